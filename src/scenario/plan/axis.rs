//! An axis of a sweep: a key of the scene and its values.

use crate::contact::law::LawChoice;
use crate::impact::Method;
use crate::numerics::functions::{log10, pow};
use crate::scenario::input::{BodyMaterial, Input, NumericKey};
use crate::scenario::keys::{ALL_KEYS, Part, key};

/// Axes with at most this number of points are tabulated, which takes some ten milliseconds.
const MAX_TABULATED: u64 = 1 << 19;

/// The numbers of an axis, in SI.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisValues {
    List(Vec<f64>),
    /// Evenly spaced, both ends included; may fall.
    Spaced {
        from: f64,
        to: f64,
        points: u64,
        /// Logarithms to base 10 of the first and the last value, if the values are evenly spaced in the logarithm.
        log10_ends: Option<(f64, f64)>,
    },
}

impl AxisValues {
    pub fn len(&self) -> u64 {
        match self {
            Self::List(values) => values.len() as u64,
            Self::Spaced { points, .. } => *points,
        }
    }

    /// Evenly spaced in the logarithm; both ends are > 0.
    pub fn logarithmic(from: f64, to: f64, points: u64) -> Self {
        Self::Spaced { from, to, points, log10_ends: Some((log10(from), log10(to))) }
    }

    /// Value `i`; the ends are exact.
    #[allow(clippy::cast_possible_truncation)] // 2^53 points and more are no table
    pub fn value_at(&self, i: u64) -> f64 {
        match *self {
            Self::List(ref values) => values[i as usize],
            Self::Spaced { from, .. } if i == 0 => from,
            Self::Spaced { to, points, .. } if i + 1 >= points => to,
            Self::Spaced { from, to, points, log10_ends: decades } => {
                let share = i as f64 / (points - 1) as f64;
                let between = |low: f64, high: f64| low + (high - low) * share;
                decades.map_or_else(|| between(from, to), |(low, high)| pow(10f64, between(low, high)))
            }
        }
    }

    /// Makes a list of the values, if the list is short.
    fn into_list(self) -> Self {
        if self.len() <= MAX_TABULATED { Self::List((0..self.len()).map(|i| self.value_at(i)).collect()) } else { self }
    }
}

/// The key of an axis, and its values.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisSetting {
    Number {
        key: NumericKey,
        values: AxisValues,
    },
    /// A key with words as values.
    Words {
        path: &'static str,
        /// At least one.
        words: Vec<AxisWord>,
    },
}

/// A word of an axis, with its meaning.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisWord {
    Method(Method),
    Law(LawChoice),
    Material(BodyMaterial),
}

impl AxisWord {
    /// The word itself.
    pub fn name(&self) -> String {
        match self {
            Self::Method(method) => method.name().to_owned(),
            Self::Law(law) => law.name(),
            Self::Material(choice) => choice.material.name.clone(),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct SweepAxis {
    pub setting: AxisSetting,
    part: Part,
    /// True if pictures show the axis on a logarithmic scale: its values are evenly spaced in the logarithm.
    pub is_logarithmic: bool,
    /// True if its values are evenly spaced by their definition.
    pub is_even: bool,
}

impl SweepAxis {
    /// An axis of a numeric key.
    pub fn from_numbers(key: NumericKey, values: AxisValues) -> Self {
        let is_logarithmic = matches!(values, AxisValues::Spaced { log10_ends: Some(_), .. });
        let is_even = matches!(values, AxisValues::Spaced { log10_ends: None, .. });
        Self {
            setting: AxisSetting::Number { key, values: values.into_list() },
            part: key.part(),
            is_logarithmic,
            is_even,
        }
    }

    pub fn from_words(path: &'static str, words: Vec<AxisWord>) -> Self {
        // the axis of laws is no key, but a table
        let key = ALL_KEYS.iter().find(|key| key.path == path);
        let part = key.map_or(Part::Law, |key| key.part);
        Self { setting: AxisSetting::Words { path, words }, part, is_logarithmic: false, is_even: false }
    }

    /// The indices of its smallest and its largest number; of the first and the last word for words.
    pub fn extreme_places(&self) -> [u64; 2] {
        let AxisSetting::Number { values: AxisValues::List(values), .. } = &self.setting else {
            return [0, self.len() - 1];
        };
        // a list may be in any order
        let all = || (0..).zip(values);
        let smallest = all().min_by(|a, b| a.1.total_cmp(b.1));
        let largest = all().max_by(|a, b| a.1.total_cmp(b.1));
        [smallest, largest].map(|end| end.map_or(0, |(place, _)| place))
    }

    /// The key, as in the file.
    pub fn path(&self) -> &'static str {
        match &self.setting {
            AxisSetting::Number { key, .. } => key.path(),
            AxisSetting::Words { path, .. } => path,
        }
    }

    pub fn len(&self) -> u64 {
        match &self.setting {
            AxisSetting::Number { values, .. } => values.len(),
            AxisSetting::Words { words, .. } => words.len() as u64,
        }
    }

    /// Its words; empty for an axis of numbers.
    pub fn word_values(&self) -> &[AxisWord] {
        if let AxisSetting::Words { words, .. } = &self.setting { words } else { &[] }
    }

    pub fn words_mut(&mut self) -> &mut [AxisWord] {
        if let AxisSetting::Words { words, .. } = &mut self.setting { words } else { &mut [] }
    }

    /// A value as text, for pictures and messages.
    #[allow(clippy::cast_possible_truncation)] // lists of words are short
    pub fn label(&self, i: u64) -> String {
        match &self.setting {
            AxisSetting::Number { key, values } => key.quantity().display(values.value_at(i)),
            AxisSetting::Words { words, .. } => words[i as usize].name(),
        }
    }

    /// True if bodies and law are constant along the axis.
    pub fn is_contact_constant(&self) -> bool {
        !self.part.changes_contact()
    }

    /// True if the law or its flow curve may change along the axis, as for materials that harden.
    pub fn changes_law(&self) -> bool {
        self.part.changes_law() || !self.word_values().is_empty()
    }

    /// True if its words set other keys, or remove the keys of another word: laws and materials.
    pub fn brings_values(&self) -> bool {
        matches!(self.word_values(), [AxisWord::Law(_) | AxisWord::Material(_), ..])
    }

    /// Sets value `i` in an input. A law or a material sets other keys too; for several axes use [`super::apply_axes`].
    #[allow(clippy::cast_possible_truncation)] // lists of words are short
    pub fn apply(&self, i: u64, input: &mut Input) {
        match &self.setting {
            AxisSetting::Number { key, values } => input.set(*key, Some(values.value_at(i))),
            AxisSetting::Words { words, .. } => match &words[i as usize] {
                AxisWord::Method(method) => {
                    input.set_word(key!("solver.method"), Method::ALL.iter().position(|known| known == method));
                }
                AxisWord::Law(law) => input.named_law.clone_from(law),
                AxisWord::Material(choice) => input.apply_material(choice),
            },
        }
    }

    /// Value `i`; the index in the list for a word.
    pub fn value_at(&self, i: u64) -> f64 {
        match &self.setting {
            AxisSetting::Number { values, .. } => values.value_at(i),
            AxisSetting::Words { .. } => i as f64,
        }
    }
}
