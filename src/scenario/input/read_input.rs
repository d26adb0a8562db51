//! Reads the tables of a scenario into an input: one walk along the list of keys.

use std::sync::Arc;

use toml::de::{DeTable, DeValue};

use super::reader::{Fault, Reader, count, items, list, number, pair, text, word};
use super::{Input, Value};
use crate::contact::law::{LawChoice, PlmCoefficients};
use crate::contact::strength::flow_curve::{FlowCurve, FlowPoint};
use crate::scenario::keys::key::{LISTS, List};
use crate::scenario::keys::quantity::{STRAIN, STRENGTH};
use crate::scenario::keys::{EVERY_KEY, Form, Quantity};
use crate::scenario::toml_node::{COMBINED, Node, below};
use crate::strings::csv::{CsvError, CsvReader};

impl Input {
    /// Reads the keys of a table of this path, which has no numbers of items. What is refused stays with the reader. What
    /// varies, `[sweep]` and such tables, is left to others.
    pub fn read(&mut self, table: &DeTable, pattern: &str, reader: &mut Reader) {
        for (name, node) in table {
            let path = below(pattern, name.get_ref());
            if is_known(&path) {
                reader.in_table(name.get_ref(), |reader| self.take_key(&path, node, reader));
            } else {
                reader.unknown(name, &names(pattern));
            }
        }
    }

    /// Takes what stands at a path.
    fn take_key(&mut self, path: &str, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let is_this = |form: Form| !matches!((form, node.get_ref()), (Form::WordOrTable(_), DeValue::Table(_)));
        match EVERY_KEY.iter().position(|key| key.path == path && is_this(key.form)) {
            Some(place) => self.take_value(place, node, reader),
            None => self.take_table(path, node, reader),
        }
    }

    fn take_value(&mut self, place: usize, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let number = match EVERY_KEY[place].form {
            Form::Number(quantity) => number(quantity, None, node)?,
            Form::NumberOr(quantity, word) => number(quantity, Some(word), node)?,
            Form::Count(quantity) => count(quantity, node)? as f64,
            Form::Word(words) => word(words, node)? as f64,
            form => {
                if let Some(value) = other(form, EVERY_KEY[place].path, node, reader)? {
                    self.put_other(place, value);
                }
                return Ok(());
            }
        };
        self.put_number(place, number);
        Ok(())
    }

    fn take_table(&mut self, path: &str, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        if let Some(List { path, example, item }) = LISTS.iter().find(|list| list.path.strip_suffix("[]") == Some(path))
        {
            let DeValue::Array(tables) = node.get_ref() else {
                return Err(Fault::unexpected(node, &format!("a list of tables: {example}")));
            };
            let mut all = Vec::new();
            for (i, table) in tables.iter().enumerate() {
                let mut one = Self::default();
                reader.in_table(&format!("[{i}]"), |reader| match table.get_ref() {
                    DeValue::Table(keys) => {
                        one.read(keys, path, reader);
                        Ok(())
                    }
                    _ => Err(Fault::unexpected(table, item)),
                });
                all.push(one);
            }
            self.set_items(path, all);
            return Ok(());
        }
        if path == "law" {
            return self.take_law(node, reader);
        }
        self.read(items(node)?, path, reader);
        Ok(())
    }

    /// Takes the law that `[law]` names, and its keys.
    fn take_law(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let DeValue::Table(laws) = node.get_ref() else {
            return Err(Fault::at(node, format!("not a table; {ONE_LAW}")));
        };
        let found: Vec<&str> = laws.keys().map(|law| &**law.get_ref()).collect();
        let (&[name], Some((law, table))) = (&found[..], laws.iter().next()) else {
            let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
            return Err(Fault::at(node, format!("a scenario has exactly one law, found {found}; {ONE_LAW}")));
        };
        if name == COMBINED {
            reader.in_table(COMBINED, |reader| {
                self.named_law = combined(table, reader)?;
                Ok(())
            });
            return Ok(());
        }
        let Some(known) = LawChoice::all().into_iter().find(|law| law.about().name == name) else {
            let known: Vec<&str> = LawChoice::names().into_iter().chain([COMBINED]).collect();
            reader.unknown(law, &known);
            return Ok(());
        };
        self.named_law = known;
        if !self.named_law.has_loading() {
            let message = format!(
                "{name} is a law of unloading only; write [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\""
            );
            reader.in_table(name, |_| Err(Fault::at(table, message)));
        }
        reader.in_table(name, |reader| {
            self.read(items(table)?, &below("law", name), reader);
            Ok(())
        });
        Ok(())
    }
}

const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

/// The law of two halves.
fn combined(node: &Node, reader: &mut Reader) -> Result<LawChoice, Fault> {
    let halves = items(node)?;
    // the names are checked as those of any key
    Input::default().read(halves, "law.combined", reader);
    let mut names = Vec::new();
    for (half, verb, law) in [("loading", "loads", "plm"), ("unloading", "unloads", "thornton")] {
        let Some(name) = halves.get(half) else {
            let message = format!("the key `{half}` is missing: the law that {verb}, such as {half} = \"{law}\"");
            return Err(Fault::at(node, message));
        };
        names.push(name.get_ref().as_str().unwrap_or_default());
    }
    Ok(LawChoice::from_name(&names.join(" + ")).unwrap_or_default())
}

/// A value that is no number and no word; `None` for one that is read elsewhere.
fn other(form: Form, path: &str, node: &Node, reader: &mut Reader) -> Result<Option<Value>, Fault> {
    Ok(Some(match form {
        Form::Numbers(quantity) => {
            Value::Numbers(each(node, &format!("[{}]", quantity.example), |item| number(quantity, None, item))?)
        }
        Form::Words(words) => {
            let known = (words.known)();
            let example = format!("[\"{}\"]", known.first().map_or("", String::as_str));
            Value::Words(each(node, &example, |item| word(words, item).map(|place| known[place].clone()))?)
        }
        Form::Points => {
            let points = each(node, &format!("[{}]", pair_example(POINT)), |item| pair(POINT, item))?;
            Value::Curve(through(&points).map_err(|message| Fault::at(node, message))?)
        }
        Form::WordOrTable(words) => Value::Text((words.known)()[word(words, node)?].clone()),
        Form::File(example) if path.ends_with(".flow_stress.table") => {
            let [path, text] = reader.file(node, example)?;
            let at = |line: Option<u64>| line.map(|line| format!(":{line}")).unwrap_or_default();
            let curve = points(&text).and_then(|points| through(&points).map_err(|message| (None, message)));
            let refuse = |(line, message)| Fault::at(node, format!("{path}{}: {message}", at(line)));
            Value::Curve(curve.map_err(refuse)?)
        }
        Form::File(example) if path == "law.plm.coefficients" => {
            let [path, text] = reader.file(node, example)?;
            let refuse =
                |error: &dyn std::fmt::Display| Fault::at(node, format!("{path}: {}", error.to_string().trim_end()));
            Value::Coefficients(Arc::new(PlmCoefficients::from_toml(&text).map_err(|error| refuse(&error))?))
        }
        // a file is read where it is needed
        Form::Text(example) | Form::File(example) => Value::Text(text(node, example)?.to_owned()),
        _ => return Ok(None),
    }))
}

fn each<T>(node: &Node, example: &str, read: impl FnMut(&Node) -> Result<T, Fault>) -> Result<Vec<T>, Fault> {
    list(node, example)?.iter().map(read).collect()
}

/// A point of a flow curve.
pub const POINT: [&Quantity; 2] = [&STRAIN, &STRENGTH];

pub fn pair_example(quantities: [&Quantity; 2]) -> String {
    format!("[{}]", quantities.map(|quantity| quantity.example).join(", "))
}

const OF_POINTS: [&str; 2] = ["plastic_strain", "stress_Pa"];

/// The points of a file: `plastic_strain, stress_Pa`.
fn points(text: &str) -> Result<Vec<[f64; 2]>, CsvError> {
    let table = CsvReader::new(text)?;
    if table.header.iter().collect::<Vec<_>>() != OF_POINTS {
        return Err((table.line, format!("its columns must be {}", OF_POINTS.join(", "))));
    }
    let mut points = Vec::new();
    for row in table.rows() {
        let (line, row) = row?;
        let field = |i: usize| {
            let no_number = |_| (Some(line), format!("{} is no number, but \"{}\"", OF_POINTS[i], &row[i]));
            row[i].parse::<f64>().map_err(no_number)
        };
        points.push([field(0)?, field(1)?]);
    }
    Ok(points)
}

fn through(points: &[[f64; 2]]) -> Result<FlowCurve, String> {
    let points = points.iter().map(|&[strain, stress]| FlowPoint { strain, stress });
    FlowCurve::from_points(points.collect::<Vec<_>>()).map_err(|error| error.to_string())
}

/// True if there is a key or a table of this path.
pub fn is_known(path: &str) -> bool {
    path == "law" || EVERY_KEY.iter().any(|key| is_at_or_below(key.path, path))
}

/// The names of the keys and tables in a table of this path.
pub fn names(table: &str) -> Vec<&'static str> {
    let inner = |path: &'static str| match table {
        "" => path.split(['.', '[']).next(),
        _ => path.strip_prefix(table)?.strip_prefix('.')?.split(['.', '[']).next(),
    };
    let mut names: Vec<&str> = Vec::new();
    for name in EVERY_KEY.iter().filter_map(|key| inner(key.path)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// True if a path is `above`, or the path of a key below it.
pub fn is_at_or_below(path: &str, above: &str) -> bool {
    path.strip_prefix(above).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
