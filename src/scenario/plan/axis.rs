//! An axis of a sweep: a key of the scene and its values.

use crate::contact::law::LawChoice;
use crate::impact::Method;
use crate::numerics::functions::{log10, pow};
use crate::scenario::input::{BodyMaterial, Input, Key};
use crate::scenario::keys::{EVERY_KEY, Part, at};

/// Axes with at most this number of points are tabulated, which takes some ten milliseconds.
const TABULATED: u64 = 1 << 19;

/// The numbers of an axis, in SI.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    List(Vec<f64>),
    /// Evenly spaced, both ends included; may fall.
    Spaced {
        from: f64,
        to: f64,
        points: u64,
        /// Logarithms to base 10 of the first and the last value, if the values are evenly spaced in the logarithm.
        decades: Option<(f64, f64)>,
    },
}

impl Values {
    pub fn len(&self) -> u64 {
        match self {
            Self::List(values) => values.len() as u64,
            Self::Spaced { points, .. } => *points,
        }
    }

    /// Evenly spaced in the logarithm; both ends are > 0.
    pub fn logarithmic(from: f64, to: f64, points: u64) -> Self {
        Self::Spaced { from, to, points, decades: Some((log10(from), log10(to))) }
    }

    /// Value `i`; the ends are exact.
    #[allow(clippy::cast_possible_truncation)] // 2^53 points and more are no table
    pub fn at(&self, i: u64) -> f64 {
        match *self {
            Self::List(ref values) => values[i as usize],
            Self::Spaced { from, .. } if i == 0 => from,
            Self::Spaced { to, points, .. } if i + 1 >= points => to,
            Self::Spaced { from, to, points, decades } => {
                let share = i as f64 / (points - 1) as f64;
                let between = |low: f64, high: f64| low + (high - low) * share;
                decades.map_or_else(|| between(from, to), |(low, high)| pow(10f64, between(low, high)))
            }
        }
    }

    /// Makes a list of the values, if the list is short.
    fn tabulated(self) -> Self {
        if self.len() <= TABULATED { Self::List((0..self.len()).map(|i| self.at(i)).collect()) } else { self }
    }
}

/// The key of an axis, and its values.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting {
    Number {
        key: &'static Key,
        values: Values,
    },
    /// A key with words as values.
    Words {
        path: &'static str,
        /// At least one.
        words: Vec<Word>,
    },
}

/// A word of an axis, with its meaning.
#[derive(Debug, Clone, PartialEq)]
pub enum Word {
    Method(Method),
    Law(LawChoice),
    Material(BodyMaterial),
}

impl Word {
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
pub struct Axis {
    pub setting: Setting,
    part: Part,
    /// True if pictures show the axis on a logarithmic scale: its values are evenly spaced in the logarithm.
    pub is_logarithmic: bool,
    /// True if its values are evenly spaced by their definition.
    pub is_even: bool,
}

impl Axis {
    /// An axis of a numeric key.
    pub fn of_number(key: &'static Key, values: Values) -> Self {
        let is_logarithmic = matches!(values, Values::Spaced { decades: Some(_), .. });
        let is_even = matches!(values, Values::Spaced { decades: None, .. });
        Self { setting: Setting::Number { key, values: values.tabulated() }, part: key.part, is_logarithmic, is_even }
    }

    pub fn of_words(path: &'static str, words: Vec<Word>) -> Self {
        // the axis of laws is no key, but a table
        let key = EVERY_KEY.iter().find(|key| key.path == path);
        let part = key.map_or(Part::Law, |key| key.part);
        Self { setting: Setting::Words { path, words }, part, is_logarithmic: false, is_even: false }
    }

    /// The indices of its smallest and its largest number; of the first and the last word for words.
    pub fn extreme_places(&self) -> [u64; 2] {
        let Setting::Number { values: Values::List(values), .. } = &self.setting else { return [0, self.len() - 1] };
        // a list may be in any order
        let all = || (0..).zip(values);
        let smallest = all().min_by(|a, b| a.1.total_cmp(b.1));
        let largest = all().max_by(|a, b| a.1.total_cmp(b.1));
        [smallest, largest].map(|end| end.map_or(0, |(place, _)| place))
    }

    /// The key, as in the file.
    pub fn path(&self) -> &'static str {
        match &self.setting {
            Setting::Number { key, .. } => key.path,
            Setting::Words { path, .. } => path,
        }
    }

    pub fn len(&self) -> u64 {
        match &self.setting {
            Setting::Number { values, .. } => values.len(),
            Setting::Words { words, .. } => words.len() as u64,
        }
    }

    /// Its words; empty for an axis of numbers.
    pub fn words(&self) -> &[Word] {
        if let Setting::Words { words, .. } = &self.setting { words } else { &[] }
    }

    pub fn words_mut(&mut self) -> &mut [Word] {
        if let Setting::Words { words, .. } = &mut self.setting { words } else { &mut [] }
    }

    /// A value as text, for pictures and messages.
    #[allow(clippy::cast_possible_truncation)] // lists of words are short
    pub fn label(&self, i: u64) -> String {
        match &self.setting {
            Setting::Number { key, values } => key.quantity.human(values.at(i)),
            Setting::Words { words, .. } => words[i as usize].name(),
        }
    }

    /// True if bodies and law are constant along the axis.
    pub fn keeps_contact(&self) -> bool {
        !self.part.changes_contact()
    }

    /// True if the law or its flow curve may change along the axis, as for materials that harden.
    pub fn changes_law(&self) -> bool {
        self.part.changes_law() || !self.words().is_empty()
    }

    /// True if its words set other keys, or remove the keys of another word: laws and materials.
    pub fn brings_values(&self) -> bool {
        matches!(self.words(), [Word::Law(_) | Word::Material(_), ..])
    }

    /// Sets value `i` in an input. A law or a material sets other keys too; for several axes use [`super::put`].
    #[allow(clippy::cast_possible_truncation)] // lists of words are short
    pub fn put(&self, i: u64, input: &mut Input) {
        match &self.setting {
            Setting::Number { key, values } => key.set(input, Some(values.at(i))),
            Setting::Words { words, .. } => match &words[i as usize] {
                Word::Method(method) => {
                    input.choose(at!("solver.method"), Method::ALL.iter().position(|known| known == method));
                }
                Word::Law(law) => input.named_law.clone_from(law),
                Word::Material(choice) => input.take(choice),
            },
        }
    }

    /// Value `i`; the index in the list for a word.
    pub fn number(&self, i: u64) -> f64 {
        match &self.setting {
            Setting::Number { values, .. } => values.at(i),
            Setting::Words { .. } => i as f64,
        }
    }
}
