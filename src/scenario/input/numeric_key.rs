//! The numeric keys of one impact, which may vary. Axes, random variables, free keys, `check` and the inputs of `summary.json` use
//! this list.

use std::sync::LazyLock;

use super::Input;
use crate::scenario::keys::{ALL_KEYS, KeyId, NUMBER, Part, key};

/// A numeric key of an impact, which may vary: as an axis, as a random variable, or as a free key of a calibration. It is its
/// place in the list of keys, which has all else about it.
pub type NumericKey = KeyId<NUMBER>;

/// All numeric keys of the scene of an impact, in the order of the file. The form of the output does not vary.
pub static NUMERIC_KEYS: LazyLock<Vec<NumericKey>> = LazyLock::new(|| {
    let of_impact = ALL_KEYS.iter().enumerate().filter(|(_, key)| !matches!(key.part, Part::Kind | Part::Output));
    of_impact.filter_map(|(place, _)| KeyId::new(place)).collect()
});

/// The spins of the sphere before the impact: about y, x and z.
pub const SPIN_KEYS: [NumericKey; 3] =
    [key!("sphere.spin"), key!("sphere.spin_about_path"), key!("sphere.spin_about_normal")];

/// The keys of which one makes an impact oblique, so that friction is computed.
pub const OBLIQUE_KEYS: [NumericKey; 4] = [key!("impact.angle"), SPIN_KEYS[0], SPIN_KEYS[1], SPIN_KEYS[2]];

/// Alternative keys: a scene has at most one key of a group.
pub const ALTERNATIVES: [&[&str]; 6] = [
    &["sphere.radius", "sphere.diameter"],
    &["sphere.density", "sphere.mass"],
    &["sphere.yield_strength", "sphere.hardness"],
    &["half_space.yield_strength", "half_space.hardness"],
    &["impact.speed", "impact.drop_height"],
    &["damping.hunt_crossley", "damping.viscous", "damping.viscoelastic_time"],
];

/// The alternatives of this key.
pub fn alternatives_to(path: &str) -> impl Iterator<Item = &'static str> + use<'_> {
    let group = ALTERNATIVES.into_iter().find(|group| group.contains(&path)).unwrap_or_default();
    group.iter().copied().filter(move |other| *other != path)
}

/// All pairs of alternative keys, each in the order of its group.
pub fn alternative_pairs() -> impl Iterator<Item = [&'static str; 2]> {
    let pairs_of = |group: &'static [&'static str]| {
        let later = move |place: usize| group[place + 1..].iter().map(move |other| [group[place], *other]);
        (0..group.len()).flat_map(later)
    };
    ALTERNATIVES.into_iter().flat_map(pairs_of)
}

impl NumericKey {
    pub fn find(path: &str) -> Option<Self> {
        NUMERIC_KEYS.iter().copied().find(|key| key.path() == path)
    }

    /// Sets a checked number, SI, in an input, and removes the alternatives of the key.
    pub fn set_exclusive(self, input: &mut Input, value: f64) {
        for other in alternatives_to(self.path()).filter_map(Self::find) {
            input.set(other, None);
        }
        input.set(self, Some(value));
    }
}

/// The path of the key itself, for the path of an axis, a random key or a key of a calibration. Any other path does not change.
pub fn without_axis_table(path: &str) -> &str {
    ["sweep.", "monte_carlo.", "calibrate.free."].iter().find_map(|table| path.strip_prefix(table)).unwrap_or(path)
}

/// The keys that an impact needs, or their alternatives (see [`ALTERNATIVES`]). The speed is the last.
pub const REQUIRED_KEYS: [&str; 7] = [
    "sphere.radius",
    "sphere.youngs_modulus",
    "sphere.poissons_ratio",
    "half_space.youngs_modulus",
    "half_space.poissons_ratio",
    "sphere.density",
    "impact.speed",
];

/// The number of [`REQUIRED_KEYS`] keys of the sphere, and of both bodies; mass and speed follow.
pub const N_SPHERE_KEYS: usize = 3;
pub const N_BODY_KEYS: usize = 5;
