//! The numeric keys of one impact, found from the types of its tables: axes, random variables, keys to find, `check` and the
//! inputs of `summary.json` come from there.

use std::sync::LazyLock;

use super::field::Field;
use super::input::Input;
use super::key::AnyKey;
use super::quantity::Quantity;

/// A numeric key of the scene of an impact, which may vary: an axis, a random variable, or found from measurements.
#[derive(Debug, PartialEq)]
pub struct Key {
    /// As in the file, with dots: `impact.speed`.
    pub path: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// A word that may stand in place of the number.
    pub word: Option<&'static str>,
    /// The way to its field in an input.
    way: &'static [usize],
}

/// All keys of the scene of an impact. Their paths are leaked; this list keeps each of them in reach.
static ALL: LazyLock<Vec<AnyKey>> = LazyLock::new(|| {
    let mut all = Vec::new();
    Input::default().keys("", &[], &mut all);
    all
});

/// All numeric keys of the scene of an impact, in the order of the file.
pub static KEYS: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let numeric = ALL.iter().filter_map(|key| Some((key, key.form.number()?)));
    numeric.map(|(key, (quantity, word))| Key { path: key.path, quantity, word, way: key.way }).collect()
});

/// Keys that stand in place of each other: a scene takes one of the two.
pub const EITHER: [[&str; 2]; 5] = [
    ["sphere.radius", "sphere.diameter"],
    ["sphere.density", "sphere.mass"],
    ["half_space.yield_strength", "half_space.hardness"],
    ["impact.speed", "impact.drop_height"],
    ["damping.hunt_crossley", "damping.viscous"],
];

impl Key {
    /// Its number; `None` where it is not given, infinite for the word.
    pub fn get(&self, input: &Input) -> Option<f64> {
        let start: &dyn Field = input;
        self.way.iter().try_fold(start, |table, at| table.at(*at))?.given()
    }

    /// Puts a checked number there, SI, or takes it away. It changes nothing else.
    pub fn set(&self, input: &mut Input, value: Option<f64>) {
        // a table is made for a number, but not to say that there is none
        if value.is_none() && self.get(input).is_none() {
            return;
        }
        let start: &mut dyn Field = input;
        if let Some(field) = self.way.iter().try_fold(start, |table, at| table.at_mut(*at)) {
            field.put(value);
        }
    }

    /// The name of its column in tables, with its unit: `impact_speed_m_per_s`.
    pub fn column(&self) -> String {
        format!("{}{}", self.path.replace('.', "_"), self.quantity.dimension.suffix())
    }

    /// The key of that path.
    pub fn find(path: &str) -> Option<&'static Self> {
        KEYS.iter().find(|key| key.path == path)
    }

    /// Puts a checked number, SI, into an input. A key in place of which it stands is taken away.
    pub fn put(&self, input: &mut Input, value: f64) {
        let pair = EITHER.iter().find(|pair| pair.contains(&self.path));
        let other = pair.and_then(|pair| Self::find(if pair[0] == self.path { pair[1] } else { pair[0] }));
        if let Some(other) = other {
            other.set(input, None);
        }
        self.set(input, Some(value));
    }
}

/// The path of the key itself, from that of an axis, a random key or a key of a calibration. Any other path stays as it is.
pub fn varied(path: &str) -> &str {
    ["sweep.", "monte_carlo.", "calibrate.free."].iter().find_map(|table| path.strip_prefix(table)).unwrap_or(path)
}
