//! The values of file and command line: numbers as they are given, without numbers that follow from others. Every key has its own
//! value here, so the order in which values are set does not matter; `resolve.rs` computes the numbers that follow.

pub(in crate::scenario) mod balls;
pub(crate) mod body_material;
pub(in crate::scenario) mod law;
pub mod measured;
pub mod numeric_key;
pub(crate) mod read_input;
pub(crate) mod reader;
pub(in crate::scenario) mod resolve;
pub(in crate::scenario) mod strength;

pub(crate) use body_material::{Body, BodyMaterial};
pub use measured::MeasuredQuantity;
pub use numeric_key::{
    ALTERNATIVES, N_BODY_KEYS, N_SPHERE_KEYS, NUMERIC_KEYS, NumericKey, OBLIQUE_KEYS, REQUIRED_KEYS, SPIN_KEYS,
    alternative_pairs, alternatives_to, without_axis_table,
};

use std::collections::BTreeMap;
use std::sync::Arc;

use super::keys::{ALL_KEYS, COUNT, KeyId, KeySpec, NUMBER, OTHER, Part, Quantity, ValueForm, WORD};
use crate::contact::law::{LawChoice, PlmCoefficients};
use crate::contact::strength::flow_curve::{FlowCurve, FlowPoint};
use crate::units::{Dimension, format_input, format_number, format_si_and_short};

/// A value that is neither a number nor a word.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Numbers(Vec<f64>),
    Words(Vec<String>),
    Text(String),
    /// A flow curve through points, from a list or a file.
    Curve(FlowCurve),
    Coefficients(Arc<PlmCoefficients>),
}

/// The values that an input has besides its numbers.
#[derive(Debug, Clone, Default, PartialEq)]
struct NonNumericValues {
    /// By the indices of their keys.
    values: BTreeMap<usize, Value>,
    /// The items of lists of tables, by the paths of the lists.
    items: BTreeMap<&'static str, Vec<Input>>,
    materials: Vec<BodyMaterial>,
}

/// All values of a scenario.
#[derive(Debug, Clone)]
pub struct Input {
    /// Values by the index of their key: numbers in SI, whole numbers, and words by their index in the list of words. A missing value is
    /// NaN. A word in place of a number is infinity.
    numbers: [f64; ALL_KEYS.len()],
    // the rows of a table share these values; only an axis of materials changes them
    others: Arc<NonNumericValues>,
    /// The law that the scenario names, without the numbers that it gives to it: see [`Input::law`].
    pub named_law: LawChoice,
}

impl Default for Input {
    fn default() -> Self {
        Self { numbers: [f64::NAN; ALL_KEYS.len()], others: Arc::default(), named_law: LawChoice::default() }
    }
}

impl PartialEq for Input {
    fn eq(&self, other: &Self) -> bool {
        self.numbers.map(f64::to_bits) == other.numbers.map(f64::to_bits)
            && self.others == other.others
            && self.named_law == other.named_law
    }
}

impl Input {
    /// The number of a key, SI.
    #[inline]
    pub fn number(&self, at: KeyId<NUMBER>) -> Option<f64> {
        self.number_at(at.index())
    }

    #[inline]
    pub(super) fn number_at(&self, place: usize) -> Option<f64> {
        let number = self.numbers[place];
        if number.is_nan() { None } else { Some(number) }
    }

    /// Sets a checked number, SI; `None` removes it.
    #[inline]
    pub fn set(&mut self, at: KeyId<NUMBER>, number: Option<f64>) {
        self.numbers[at.index()] = number.unwrap_or(f64::NAN);
    }

    /// A whole number.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole and positive, checked when it was read
    pub fn count(&self, at: KeyId<COUNT>) -> Option<u64> {
        self.number_at(at.index()).map(|number| number as u64)
    }

    /// True if the scenario gives `true`.
    pub fn flag(&self, at: KeyId<COUNT>) -> bool {
        self.number_at(at.index()) == Some(1.0)
    }

    /// The index of a word in the list of the words of the key.
    #[inline]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a place in a list
    pub fn word(&self, at: KeyId<WORD>) -> Option<usize> {
        self.number_at(at.index()).map(|place| place as usize)
    }

    /// Sets a word, by its index in the list of the words of the key; `None` removes it.
    pub fn set_word(&mut self, at: KeyId<WORD>, word: Option<usize>) {
        self.numbers[at.index()] = word.map_or(f64::NAN, |place| place as f64);
    }

    /// Any other value.
    pub fn value(&self, at: KeyId<OTHER>) -> Option<&Value> {
        self.others.values.get(&at.index())
    }

    /// Sets such a value; `None` removes it.
    pub fn set_value(&mut self, at: KeyId<OTHER>, value: Option<Value>) {
        let values = &mut Arc::make_mut(&mut self.others).values;
        match value {
            Some(value) => drop(values.insert(at.index(), value)),
            None => drop(values.remove(&at.index())),
        }
    }

    /// Sets a parsed value at an index of the list.
    pub(super) fn set_number_at(&mut self, place: usize, number: f64) {
        self.numbers[place] = number;
    }

    pub(super) fn set_value_at(&mut self, place: usize, value: Value) {
        Arc::make_mut(&mut self.others).values.insert(place, value);
    }

    pub fn word_list(&self, at: KeyId<OTHER>) -> Option<&[String]> {
        if let Some(Value::Words(words)) = self.value(at) { Some(words) } else { None }
    }

    pub fn number_list(&self, at: KeyId<OTHER>) -> Option<&[f64]> {
        if let Some(Value::Numbers(numbers)) = self.value(at) { Some(numbers) } else { None }
    }

    /// A text, or the name of a file.
    pub fn text_value(&self, at: KeyId<OTHER>) -> Option<&str> {
        if let Some(Value::Text(text)) = self.value(at) { Some(text) } else { None }
    }

    /// The items of a list of tables; `None` if it is not given.
    pub fn table_list(&self, path: &str) -> Option<&[Self]> {
        self.others.items.get(path).map(Vec::as_slice)
    }

    /// Sets the items of a list of tables.
    pub fn set_table_list(&mut self, path: &'static str, items: Vec<Self>) {
        Arc::make_mut(&mut self.others).items.insert(path, items);
    }

    /// The values that the bodies take from their named materials.
    pub fn materials(&self) -> &[BodyMaterial] {
        &self.others.materials
    }

    pub fn set_materials(&mut self, materials: Vec<BodyMaterial>) {
        Arc::make_mut(&mut self.others).materials = materials;
    }

    /// Sets the defaults of the keys in `is_used` that are not given and have a default.
    pub(super) fn fill_defaults(&mut self, is_used: impl Fn(&KeySpec) -> bool) {
        for (place, key) in ALL_KEYS.iter().enumerate().filter(|(_, key)| is_used(key)) {
            let default = key.default.trim_matches('"');
            let value = match key.form {
                ValueForm::Number(quantity) | ValueForm::NumberOr(quantity, _) | ValueForm::Count(quantity) => {
                    quantity.parse(default).ok()
                }
                ValueForm::Word(words) => {
                    (words.values)().iter().position(|word| word == default).map(|word| word as f64)
                }
                _ => None,
            };
            if let (Some(value), None) = (value, self.number_at(place)) {
                self.set_number_at(place, value);
            }
        }
    }

    /// The numbers of a table, by their names in alphabetical order.
    pub fn numbers_of(&self, table: &str) -> Vec<(String, f64)> {
        let name = |path: &'static str| path.strip_prefix(table)?.strip_prefix('.');
        let all = ALL_KEYS.iter().zip(self.numbers).filter(|(key, number)| key.number().is_some() && !number.is_nan());
        let mut all: Vec<_> = all.filter_map(|(key, number)| Some((name(key.path)?.to_owned(), number))).collect();
        all.sort_by(|a, b| a.0.cmp(&b.0));
        all
    }

    /// The keys of one impact that have a value, for reports: in the order of the list, with the name of the law before its
    /// keys.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // counts and places are whole
    pub fn key_values(&self) -> Vec<KeyValue> {
        let mut key_values = Vec::new();
        for (place, key) in ALL_KEYS.iter().enumerate().filter(|(_, key)| key.part != Part::Kind) {
            if key.part == Part::Law && !key_values.iter().any(|key_values: &KeyValue| key_values.path == "law") {
                key_values.push(KeyValue::from_word("law", Part::Law, self.named_law.name()));
            }
            if key.part == Part::Law && !self.is_law_key(key.path) {
                continue;
            }
            let value = match (key.form, self.number_at(place), self.others.values.get(&place)) {
                (ValueForm::NumberOr(_, word), Some(f64::INFINITY), _) => word.into(),
                (ValueForm::Count(_), Some(count), _) => (count as u64).into(),
                (ValueForm::Flag, Some(flag), _) => (flag == 1.0).into(),
                (ValueForm::Word(words), Some(place), _) => (words.values)().get(place as usize).cloned().into(),
                (_, Some(number), _) => number.into(),
                (.., Some(value)) if value.report_text().is_some() => value.report_text().into(),
                _ => continue,
            };
            let quantity = key.number().map(|(quantity, _)| quantity);
            key_values.push(KeyValue { path: key.path.to_owned(), part: key.part, quantity, value });
        }
        key_values
    }
}

impl Value {
    /// The text for reports; `None` for values that reports omit.
    fn report_text(&self) -> Option<String> {
        match self {
            Self::Curve(FlowCurve::Points(points)) => {
                let pair = |point: &FlowPoint| {
                    format!("{}: {}", format_number(point.strain), format_input(point.stress, Dimension::Pressure))
                };
                Some(points.iter().map(pair).collect::<Vec<_>>().join(", "))
            }
            Self::Coefficients(table) => Some(format!("{} ({})", table.provenance.name, table.provenance.source)),
            _ => None,
        }
    }
}

/// A key and its value, for reports.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyValue {
    /// With dots.
    pub path: String,
    pub part: Part,
    /// Only a number has one.
    pub quantity: Option<&'static Quantity>,
    /// In SI, or a word.
    pub value: serde_json::Value,
}

impl KeyValue {
    pub fn from_word(path: &str, part: Part, word: impl Into<serde_json::Value>) -> Self {
        Self { path: path.to_owned(), part, quantity: None, value: word.into() }
    }

    /// Its name in summaries, with the unit: `impact_speed_m_per_s`.
    pub fn column(&self) -> String {
        self.path.replace('.', "_") + self.quantity.map_or("", |quantity| quantity.dimension.suffix())
    }

    /// The value for the terminal.
    pub fn terminal_text(&self) -> String {
        match (self.quantity, self.value.as_f64(), self.value.as_str()) {
            (Some(quantity), Some(number), _) if quantity.is_hardness => {
                format!("{}, {}", format_si_and_short(number, quantity.dimension), quantity.display(number))
            }
            (Some(quantity), Some(number), _) => format_si_and_short(number, quantity.dimension),
            (.., Some(word)) => word.to_owned(),
            _ => self.value.to_string(),
        }
    }
}
