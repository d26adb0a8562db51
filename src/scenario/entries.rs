//! Reads the keys of a file one by one, as the registry describes them, and refuses keys that are not in the registry.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::axes::{self, RandomKeys};
use super::values::{Fault, Refused, Value, read, unexpected};
use crate::law::LawChoice;
use crate::plan::axis::{Axis, Setting};
use crate::plan::free::Free;
use crate::plan::random::{Distribution, Variable};
use crate::scene::key::Form;
use crate::scene::keys::every_key;
use crate::scene::other_keys::List;
use crate::scene::taken::Body;
use crate::units::nearest::did_you_mean;

/// The values of a scenario by their place in the file, with the number of the item in a list of tables
/// (`indentation.steps[2].load`, counted from 0).
#[derive(Debug, Clone, Default)]
pub(super) struct Entries {
    values: BTreeMap<String, Value>,
    /// Lengths of the lists of tables.
    lists: BTreeMap<String, usize>,
    /// The tables of the file, also empty ones.
    tables: Vec<String>,
    /// Axes of `[sweep]`, in the order of the file.
    pub(super) axes: Option<Vec<Axis>>,
    /// `[monte_carlo]`.
    pub(super) variables: Option<RandomKeys>,
    /// `calibrate.free`.
    pub(super) free: Option<Vec<Free>>,
}

impl Entries {
    /// Reads every key of a document, in the order of the file.
    pub(super) fn read(root: &DeTable) -> Result<Self, Refused> {
        let mut entries = Self::default();
        entries.table(root, "", "")?;
        Ok(entries)
    }

    /// A number, in SI.
    pub(super) fn number(&self, path: &str) -> Option<f64> {
        if let Value::Number(value) = self.values.get(path)? { Some(*value) } else { None }
    }

    /// A whole number.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and in the range of its quantity
    pub(super) fn count<T: TryFrom<u64>>(&self, path: &str) -> Option<T> {
        T::try_from(self.number(path)? as u64).ok()
    }

    /// Numbers, in SI.
    pub(super) fn numbers(&self, path: &str) -> Option<&[f64]> {
        if let Value::Numbers(values) = self.values.get(path)? { Some(values) } else { None }
    }

    /// Pairs of numbers, in SI.
    pub(super) fn pairs(&self, path: &str) -> &[[f64; 2]] {
        if let Some(Value::Pairs(pairs)) = self.values.get(path) { pairs } else { &[] }
    }

    /// A text or a word.
    pub(super) fn text(&self, path: &str) -> Option<&str> {
        if let Value::Text(text) = self.values.get(path)? { Some(text) } else { None }
    }

    /// Texts or words.
    pub(super) fn texts(&self, path: &str) -> Option<&[String]> {
        if let Value::Texts(texts) = self.values.get(path)? { Some(texts) } else { None }
    }

    /// Whether a key, a table or a list of tables is given.
    pub(super) fn has(&self, path: &str) -> bool {
        self.values.contains_key(path) || self.lists.contains_key(path) || self.tables.iter().any(|table| table == path)
    }

    /// How many tables a list has, if it is given.
    pub(super) fn length(&self, path: &str) -> Option<usize> {
        self.lists.get(path).copied()
    }

    /// The keys that are given in a table, without its name.
    pub(super) fn keys_in<'a>(&'a self, table: &'a str) -> impl Iterator<Item = &'a str> {
        self.values.keys().filter_map(move |path| path.strip_prefix(table)?.strip_prefix('.'))
    }

    /// Whether a key varies over the cases of a table.
    pub(super) fn varies(&self, path: &str) -> bool {
        self.varied().any(|varied| varied == path)
    }

    /// The keys that vary.
    pub(super) fn varied(&self) -> impl Iterator<Item = &'static str> {
        let axes = self.axes.iter().flatten().map(Axis::path);
        let variables = self.variables.iter().flat_map(|table| &table.variables).map(|variable| variable.key.path);
        axes.chain(variables).chain(self.free.iter().flatten().map(|free| free.key.path))
    }

    /// The first value of a key that varies: of its axis or range, or the mean or lower end of its distribution.
    pub(super) fn first(&self, path: &str) -> Option<f64> {
        let axis = self.axes.iter().flatten().find(|axis| axis.path() == path);
        if let Some(Axis { setting: Setting::Number { values, .. }, .. }) = axis {
            return Some(values.at(0));
        }
        if let Some(free) = self.free.iter().flatten().find(|free| free.key.path == path) {
            return Some(free.from);
        }
        let variable = self.variables.as_ref()?.variables.iter().find(|variable| variable.key.path == path)?;
        Some(match variable.distribution {
            Distribution::Uniform { from, .. } => from,
            Distribution::Normal { mean, .. } | Distribution::Lognormal { mean, .. } => mean,
        })
    }

    /// Sets a numeric key that the file does not give.
    pub(super) fn give(&mut self, path: &str, value: f64) {
        let mut table = path;
        while let Some((outer, _)) = table.rsplit_once('.') {
            if !self.has(outer) {
                self.tables.push(outer.to_owned());
            }
            table = outer;
        }
        self.values.insert(path.to_owned(), Value::Number(value));
    }

    /// The place in the file where `[monte_carlo]` asks to draw the material of a body.
    pub(super) fn draws(&self, body: Body) -> Option<Range<usize>> {
        let materials = &self.variables.as_ref()?.materials;
        materials.iter().find(|drawn| drawn.body == body).map(|drawn| drawn.span.clone())
    }

    /// Replaces the drawn material of a body by random keys.
    pub(super) fn draw(&mut self, body: Body, drawn: Vec<Variable>) {
        let Some(RandomKeys { variables, materials, .. }) = &mut self.variables else { return };
        let Some(at) = materials.iter().position(|known| known.body == body) else { return };
        let count = drawn.len();
        let place = materials[at].place;
        variables.splice(place..place, drawn);
        for later in materials.iter_mut().filter(|later| later.place >= place) {
            later.place += count;
        }
    }

    /// Reads a table: `place` is where it is, `pattern` the same without the numbers of items.
    fn table(&mut self, table: &DeTable, place: &str, pattern: &str) -> Result<(), Refused> {
        if !place.is_empty() {
            self.tables.push(place.to_owned());
        }
        for (name, value) in table {
            let (place, pattern) = (joined(place, name.get_ref()), joined(pattern, name.get_ref()));
            let form = every_key().find(|key| key.path == pattern).map(|key| key.form);
            let refused = |fault: Fault| fault.of(place.clone());
            match (form, value.get_ref()) {
                (Some(form @ (Form::Axes | Form::Variables | Form::Free)), DeValue::Table(inner)) => {
                    match form {
                        Form::Axes => self.axes = Some(axes::axes(&place, inner, value)?),
                        Form::Variables => self.variables = Some(axes::variables(&place, inner, value)?),
                        _ => self.free = Some(axes::free(&place, inner, value)?),
                    }
                    self.tables.push(place);
                }
                (Some(Form::Axes | Form::Variables | Form::Free), _) => {
                    return Err(refused(unexpected(value, "a table")));
                }
                (Some(Form::WordOrTable(_)), DeValue::Table(inner)) => self.table(inner, &place, &pattern)?,
                (Some(form), _) => {
                    let value = read(&form, value).map_err(refused)?;
                    self.values.insert(place, value);
                }
                (None, DeValue::Table(inner)) if pattern == "law" => {
                    one_law(inner, value.span()).map_err(refused)?;
                    self.table(inner, &place, &pattern)?;
                }
                (None, DeValue::Table(inner)) if is_table(&pattern) => self.table(inner, &place, &pattern)?,
                (None, _) if pattern == "law" => {
                    return Err(refused(Fault::at(value, format!("not a table; {ONE_LAW}"))));
                }
                (None, _) if is_table(&pattern) => return Err(refused(unexpected(value, "a table"))),
                (None, written) => match (List::find(&pattern), written) {
                    (Some(list), DeValue::Array(items)) => self.tables_of(list, items, &place)?,
                    (Some(list), _) => {
                        return Err(refused(unexpected(value, &format!("a list of tables: {}", list.example))));
                    }
                    (None, _) => {
                        return Err(Fault::at(name, unknown(&pattern)).of(place));
                    }
                },
            }
        }
        Ok(())
    }

    fn tables_of(&mut self, list: &List, items: &[Spanned<DeValue>], place: &str) -> Result<(), Refused> {
        self.lists.insert(place.to_owned(), items.len());
        let pattern = format!("{}[]", list.path);
        for (i, item) in items.iter().enumerate() {
            let place = format!("{place}[{i}]");
            let DeValue::Table(inner) = item.get_ref() else { return Err(unexpected(item, list.item).of(place)) };
            self.table(inner, &place, &pattern)?;
        }
        Ok(())
    }
}

const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

fn joined(place: &str, name: &str) -> String {
    if place.is_empty() { name.to_owned() } else { format!("{place}.{name}") }
}

/// Whether keys of the registry stand below this place; laws without keys have tables too.
fn is_table(pattern: &str) -> bool {
    let dotted = format!("{pattern}.");
    let is_law = || pattern.strip_prefix("law.").is_some_and(|law| LawChoice::names().contains(&law));
    every_key().any(|key| key.path.starts_with(&dotted)) || is_law()
}

/// Refuses any number of laws but one.
fn one_law(laws: &DeTable, span: Range<usize>) -> Result<(), Fault> {
    if laws.len() == 1 {
        return Ok(());
    }
    let found: Vec<&str> = laws.keys().map(|name| name.get_ref().as_ref()).collect();
    let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
    Err(Fault { span, message: format!("a scenario has exactly one law, found {found}; {ONE_LAW}") })
}

/// The message about an unknown key or table.
fn unknown(pattern: &str) -> String {
    let (table, name) = pattern.rsplit_once('.').unwrap_or(("", pattern));
    let prefix = if table.is_empty() { String::new() } else { format!("{table}.") };
    let mut known: Vec<String> = Vec::new();
    let laws = if table == "law" { LawChoice::names() } else { Vec::new() };
    let next = |path: &'static str| path.strip_prefix(prefix.as_str())?.split(['.', '[']).next();
    for name in laws.into_iter().chain(every_key().filter_map(|key| next(key.path))) {
        if !known.iter().any(|other| other == name) {
            known.push(name.to_owned());
        }
    }
    let (thing, things) = match table {
        "" => ("table", "tables"),
        "law" => ("law", "laws"),
        _ => ("key", "keys here"),
    };
    if known.is_empty() {
        return format!("unknown {thing} `{name}`; this table takes none");
    }
    let all = format!("{things} are {}", known.join(", "));
    format!("unknown {thing} `{name}`{}", did_you_mean(name, known.iter().map(String::as_str), '`', &all))
}
