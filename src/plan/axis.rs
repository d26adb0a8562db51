//! An axis of a sweep: a key of the scene and the values it takes.

use crate::impact::Method;
use crate::law::LawChoice;
use crate::math::functions::{log10, pow};
use crate::scene::taken::{Body, Taken};
use crate::scene::{Key, Scene};

/// Axes of up to this many points are tabulated: some ten milliseconds before the first row.
const TABULATED: u64 = 1 << 19;

/// The numbers of an axis, in SI.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// As listed.
    List(Vec<f64>),
    /// Evenly spaced, both ends included; may fall.
    Linear {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// How many.
        points: u64,
    },
    /// Evenly spaced in the logarithm, both ends included; may fall. Made by [`Values::logarithmic`].
    Logarithmic {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Logarithms to base 10 of the first and the last value.
        decades: (f64, f64),
        /// How many.
        points: u64,
    },
}

impl Values {
    /// The number of values.
    pub fn len(&self) -> u64 {
        match self {
            Self::List(values) => values.len() as u64,
            Self::Linear { points, .. } | Self::Logarithmic { points, .. } => *points,
        }
    }

    /// Evenly spaced in the logarithm; both ends are > 0.
    pub fn logarithmic(from: f64, to: f64, points: u64) -> Self {
        Self::Logarithmic { from, to, decades: (log10(from), log10(to)), points }
    }

    /// Value `i`; the ends are exact.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // 2^53 points and more are no table
    pub fn at(&self, i: u64) -> f64 {
        let share = |points: u64| i as f64 / (points - 1) as f64;
        match *self {
            Self::List(ref values) => values[i as usize],
            Self::Linear { from, .. } | Self::Logarithmic { from, .. } if i == 0 => from,
            Self::Linear { to, points, .. } | Self::Logarithmic { to, points, .. } if i + 1 >= points => to,
            Self::Linear { from, to, points } => from + (to - from) * share(points),
            Self::Logarithmic { decades: (low, high), points, .. } => pow(10f64, low + (high - low) * share(points)),
        }
    }

    /// The same values as a list, where that is short.
    fn tabulated(self) -> Self {
        if self.len() <= TABULATED { Self::List((0..self.len()).map(|i| self.at(i)).collect()) } else { self }
    }
}

/// What an axis changes, and to what.
#[derive(Debug, Clone)]
pub enum Setting {
    /// A numeric key.
    Number {
        /// Its key.
        key: &'static Key,
        /// Its values.
        values: Values,
    },
    /// `solver.method`.
    Method(Vec<Method>),
    /// `law`.
    Law(Vec<LawChoice>),
    /// `material` of a body.
    Material(Body, Vec<Taken>),
}

/// An axis.
#[derive(Debug, Clone)]
pub struct Axis {
    /// What it changes.
    pub setting: Setting,
    /// Whether pictures show it on a logarithmic scale.
    pub is_logarithmic: bool,
}

impl Axis {
    /// An axis of a numeric key.
    pub fn of_number(key: &'static Key, values: Values) -> Self {
        let is_logarithmic = matches!(values, Values::Logarithmic { .. });
        Self { setting: Setting::Number { key, values: values.tabulated() }, is_logarithmic }
    }

    /// An axis of words: of methods, laws or materials.
    pub fn of_words(setting: Setting) -> Self {
        Self { setting, is_logarithmic: false }
    }

    /// The key, as in the file.
    pub fn path(&self) -> &'static str {
        match &self.setting {
            Setting::Number { key, .. } => key.path,
            Setting::Method(_) => "solver.method",
            Setting::Law(_) => "law",
            Setting::Material(body, _) => body.material(),
        }
    }

    /// Its column in the table, with its unit.
    pub fn column(&self) -> String {
        match &self.setting {
            Setting::Number { key, .. } => key.column(),
            Setting::Method(_) => "solver_method".to_owned(),
            Setting::Law(_) => "law".to_owned(),
            Setting::Material(body, _) => body.material().replace('.', "_"),
        }
    }

    /// How many values.
    pub fn len(&self) -> u64 {
        match &self.setting {
            Setting::Number { values, .. } => values.len(),
            Setting::Method(methods) => methods.len() as u64,
            Setting::Law(laws) => laws.len() as u64,
            Setting::Material(_, materials) => materials.len() as u64,
        }
    }

    /// Its words; `None` for an axis of numbers.
    pub fn words(&self) -> Option<Vec<String>> {
        match &self.setting {
            Setting::Number { .. } => None,
            Setting::Method(methods) => Some(methods.iter().map(|method| method.name().to_owned()).collect()),
            Setting::Law(laws) => Some(laws.iter().map(LawChoice::name).collect()),
            Setting::Material(_, materials) => {
                Some(materials.iter().map(|taken| taken.material.name.clone()).collect())
            }
        }
    }

    /// Whether the contact (bodies and law) stays the same along it.
    pub fn keeps_contact(&self) -> bool {
        keeps_contact(self.path())
    }

    /// Whether it changes how an impact is computed.
    pub fn is_of_solver(&self) -> bool {
        self.path().starts_with("solver.")
    }

    /// Puts value `i` into a scene.
    #[allow(clippy::cast_possible_truncation)] // lists of words are short
    pub fn put(&self, i: u64, scene: &mut Scene) {
        match &self.setting {
            Setting::Number { key, values } => (key.set)(scene, values.at(i)),
            Setting::Method(methods) => scene.solver.method = methods[i as usize],
            Setting::Law(laws) => scene.law = laws[i as usize].clone(),
            Setting::Material(_, materials) => scene.put_material(&materials[i as usize]),
        }
    }

    /// Value `i`; for a word, its place in the list.
    #[allow(clippy::cast_precision_loss)]
    pub fn number(&self, i: u64) -> f64 {
        match &self.setting {
            Setting::Number { values, .. } => values.at(i),
            Setting::Method(_) | Setting::Law(_) | Setting::Material(..) => i as f64,
        }
    }
}

/// Whether bodies and law stay the same when this key changes.
pub fn keeps_contact(path: &str) -> bool {
    path == "impact.speed" || path == "impact.drop_height" || path.starts_with("solver.")
}
