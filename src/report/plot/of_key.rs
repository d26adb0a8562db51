//! The names of the keys of a scenario in pictures.

use super::Axis;
use crate::scenario::scene::Key;
use crate::units::capital;

/// The path of a key in words, such as "half-space Young's modulus".
pub(super) fn words(path: &str) -> String {
    let words = path.replace(['.', '_'], " ").replace("half space", "half-space");
    words.replace("youngs", "Young's").replace("poissons", "Poisson's")
}

/// The path of a key as a title, such as "Half-space Young's modulus".
pub fn title_of(path: &str) -> String {
    capital(&words(path.trim_start_matches("impact.")))
}

pub(super) fn axis_of(key: &Key, is_logarithmic: bool) -> Axis {
    let (title, unit) = (title_of(key.path), key.quantity.dimension.si_unit());
    let axis = Axis::engineering(&title, unit);
    if is_logarithmic { axis.logarithmic() } else { axis }
}
