//! Reads the tables of a scenario into an input: one walk along the list of keys.

use std::sync::Arc;

use toml::de::{DeTable, DeValue};

use super::reader::{
    Reader, ValueError, as_table, read_count, read_flag, read_list, read_number, read_pair, read_text, read_word,
};
use super::{Input, Value};
use crate::contact::law::{LawChoice, PlmCoefficients};
use crate::contact::strength::flow_curve::{FlowCurve, FlowPoint};
use crate::scenario::keys::key_spec::{TABLE_LISTS, TableList};
use crate::scenario::keys::quantity::{STRAIN, STRENGTH};
use crate::scenario::keys::{ALL_KEYS, Quantity, ValueForm};
use crate::scenario::toml_node::{COMBINED, TomlValue, join_path};
use crate::strings::csv::{CsvError, CsvReader};

impl Input {
    /// Reads the keys of a table of this path, which has no numbers of items. What is refused stays with the reader. What
    /// varies, `[sweep]` and such tables, is left to others.
    pub fn read(&mut self, table: &DeTable, pattern: &str, reader: &mut Reader) {
        for (name, node) in table {
            let path = join_path(pattern, name.get_ref());
            if is_known_path(&path) {
                reader.in_table(name.get_ref(), |reader| self.read_key(&path, node, reader));
            } else {
                reader.refuse_unknown(name, &names_in_table(pattern));
            }
        }
    }

    /// Takes what stands at a path.
    fn read_key(&mut self, path: &str, node: &TomlValue, reader: &mut Reader) -> Result<(), ValueError> {
        let is_this =
            |form: ValueForm| !matches!((form, node.get_ref()), (ValueForm::WordOrTable(_), DeValue::Table(_)));
        match ALL_KEYS.iter().position(|key| key.path == path && is_this(key.form)) {
            Some(place) => self.read_value(place, node, reader),
            None => self.read_table(path, node, reader),
        }
    }

    fn read_value(&mut self, place: usize, node: &TomlValue, reader: &mut Reader) -> Result<(), ValueError> {
        let number = match ALL_KEYS[place].form {
            ValueForm::Number(quantity) => read_number(quantity, None, node)?,
            ValueForm::NumberOr(quantity, word) => read_number(quantity, Some(word), node)?,
            ValueForm::Count(quantity) => read_count(quantity, node)? as f64,
            ValueForm::Flag => f64::from(u8::from(read_flag(node)?)),
            ValueForm::Word(words) => read_word(words, node)? as f64,
            form => {
                if let Some(value) = read_other(form, ALL_KEYS[place].path, node, reader)? {
                    self.set_value_at(place, value);
                }
                return Ok(());
            }
        };
        self.set_number_at(place, number);
        Ok(())
    }

    fn read_table(&mut self, path: &str, node: &TomlValue, reader: &mut Reader) -> Result<(), ValueError> {
        if let Some(TableList { path, example, item }) =
            TABLE_LISTS.iter().find(|list| list.path.strip_suffix("[]") == Some(path))
        {
            let DeValue::Array(tables) = node.get_ref() else {
                return Err(ValueError::wrong_type(node, &format!("a list of tables: {example}")));
            };
            let mut all = Vec::new();
            for (i, table) in tables.iter().enumerate() {
                let mut one = Self::default();
                reader.in_table(&format!("[{i}]"), |reader| match table.get_ref() {
                    DeValue::Table(keys) => {
                        one.read(keys, path, reader);
                        Ok(())
                    }
                    _ => Err(ValueError::wrong_type(table, item)),
                });
                all.push(one);
            }
            self.set_table_list(path, all);
            return Ok(());
        }
        if path == "law" {
            return self.read_law(node, reader);
        }
        self.read(as_table(node)?, path, reader);
        Ok(())
    }

    /// Takes the law that `[law]` names, and its keys.
    fn read_law(&mut self, node: &TomlValue, reader: &mut Reader) -> Result<(), ValueError> {
        let DeValue::Table(laws) = node.get_ref() else {
            return Err(ValueError::new(node, format!("not a table; {ONE_LAW_TEXT}")));
        };
        let found: Vec<&str> = laws.keys().map(|law| &**law.get_ref()).collect();
        let (&[name], Some((law, table))) = (&found[..], laws.iter().next()) else {
            let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
            return Err(ValueError::new(
                node,
                format!("a scenario has exactly one law, found {found}; {ONE_LAW_TEXT}"),
            ));
        };
        if name == COMBINED {
            reader.in_table(COMBINED, |reader| {
                self.named_law = read_combined_law(table, reader)?;
                Ok(())
            });
            return Ok(());
        }
        let Some(known) = LawChoice::all().into_iter().find(|law| law.info().name == name) else {
            let known: Vec<&str> = LawChoice::names().into_iter().chain([COMBINED]).collect();
            reader.refuse_unknown(law, &known);
            return Ok(());
        };
        self.named_law = known;
        if !self.named_law.has_loading() {
            let message = format!(
                "{name} defines unloading only. Use [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\"."
            );
            reader.in_table(name, |_| Err(ValueError::new(table, message)));
        }
        reader.in_table(name, |reader| {
            self.read(as_table(table)?, &join_path("law", name), reader);
            Ok(())
        });
        Ok(())
    }
}

const ONE_LAW_TEXT: &str = "write one table such as [law.plm], or remove [law]";

/// The law of two halves.
fn read_combined_law(node: &TomlValue, reader: &mut Reader) -> Result<LawChoice, ValueError> {
    let halves = as_table(node)?;
    // the names are checked as those of any key
    Input::default().read(halves, "law.combined", reader);
    let mut names = Vec::new();
    for (half, verb, law) in [("loading", "loads", "plm"), ("unloading", "unloads", "thornton")] {
        let Some(name) = halves.get(half) else {
            let message = format!("the key `{half}` is missing: the law that {verb}, such as {half} = \"{law}\"");
            return Err(ValueError::new(node, message));
        };
        names.push(name.get_ref().as_str().unwrap_or_default());
    }
    Ok(LawChoice::from_name(&names.join(" + ")).unwrap_or_default())
}

/// A value that is no number and no word; `None` for one that is read elsewhere.
fn read_other(form: ValueForm, path: &str, node: &TomlValue, reader: &mut Reader) -> Result<Option<Value>, ValueError> {
    Ok(Some(match form {
        ValueForm::Numbers(quantity) => Value::Numbers(read_each(node, &format!("[{}]", quantity.example), |item| {
            read_number(quantity, None, item)
        })?),
        ValueForm::Words(words) => {
            let known = (words.values)();
            let example = format!("[\"{}\"]", known.first().map_or("", String::as_str));
            Value::Words(read_each(node, &example, |item| read_word(words, item).map(|place| known[place].clone()))?)
        }
        ValueForm::Points => {
            let points = read_each(node, &format!("[{}]", pair_example(POINT)), |item| read_pair(POINT, item))?;
            Value::Curve(flow_curve_through(&points).map_err(|message| ValueError::new(node, message))?)
        }
        ValueForm::WordOrTable(words) => Value::Text((words.values)()[read_word(words, node)?].clone()),
        ValueForm::File(example) if path.ends_with(".flow_stress.table") => {
            let [path, text] = reader.file(node, example)?;
            let at = |line: Option<u64>| line.map(|line| format!(":{line}")).unwrap_or_default();
            let curve = parse_flow_points(&text)
                .and_then(|points| flow_curve_through(&points).map_err(|message| (None, message)));
            let refuse = |(line, message)| ValueError::new(node, format!("{path}{}: {message}", at(line)));
            Value::Curve(curve.map_err(refuse)?)
        }
        ValueForm::File(example) if path == "law.plm.coefficients" => {
            let [path, text] = reader.file(node, example)?;
            let refuse = |error: &dyn std::fmt::Display| {
                ValueError::new(node, format!("{path}: {}", error.to_string().trim_end()))
            };
            Value::Coefficients(Arc::new(PlmCoefficients::from_toml(&text).map_err(|error| refuse(&error))?))
        }
        // a file is read where it is needed
        ValueForm::Text(example) | ValueForm::File(example) => Value::Text(read_text(node, example)?.to_owned()),
        _ => return Ok(None),
    }))
}

fn read_each<T>(
    node: &TomlValue,
    example: &str,
    read: impl FnMut(&TomlValue) -> Result<T, ValueError>,
) -> Result<Vec<T>, ValueError> {
    read_list(node, example)?.iter().map(read).collect()
}

/// A point of a flow curve.
pub const POINT: [&Quantity; 2] = [&STRAIN, &STRENGTH];

pub fn pair_example(quantities: [&Quantity; 2]) -> String {
    format!("[{}]", quantities.map(|quantity| quantity.example).join(", "))
}

const POINT_COLUMNS: [&str; 2] = ["plastic_strain", "stress_Pa"];

/// The points of a file: `plastic_strain, stress_Pa`.
fn parse_flow_points(text: &str) -> Result<Vec<[f64; 2]>, CsvError> {
    let table = CsvReader::new(text)?;
    if table.header.iter().collect::<Vec<_>>() != POINT_COLUMNS {
        return Err((table.line, format!("its columns must be {}", POINT_COLUMNS.join(", "))));
    }
    let mut points = Vec::new();
    for row in table.rows() {
        let (line, row) = row?;
        let field = |i: usize| {
            let no_number = |_| (Some(line), format!("{} is not a number: \"{}\"", POINT_COLUMNS[i], &row[i]));
            row[i].parse::<f64>().map_err(no_number)
        };
        points.push([field(0)?, field(1)?]);
    }
    Ok(points)
}

fn flow_curve_through(points: &[[f64; 2]]) -> Result<FlowCurve, String> {
    let points = points.iter().map(|&[strain, stress]| FlowPoint { strain, stress });
    FlowCurve::from_points(points.collect::<Vec<_>>()).map_err(|error| error.to_string())
}

/// True if there is a key or a table of this path.
pub fn is_known_path(path: &str) -> bool {
    path == "law" || ALL_KEYS.iter().any(|key| is_at_or_below(key.path, path))
}

/// The names of the keys and tables in a table of this path.
pub fn names_in_table(table: &str) -> Vec<&'static str> {
    let inner = |path: &'static str| match table {
        "" => path.split(['.', '[']).next(),
        _ => path.strip_prefix(table)?.strip_prefix('.')?.split(['.', '[']).next(),
    };
    let mut names: Vec<&str> = Vec::new();
    for name in ALL_KEYS.iter().filter_map(|key| inner(key.path)) {
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
