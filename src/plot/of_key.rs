//! What the key of a scenario is called in pictures.

use super::Axis;
use crate::scene::Key;

/// "half-space Young's modulus".
pub(super) fn words(path: &str) -> String {
    let words = path.replace(['.', '_'], " ").replace("half space", "half-space");
    words.replace("youngs", "Young's").replace("poissons", "Poisson's")
}

/// The same as a title.
pub(super) fn title_of(path: &str) -> String {
    let words = words(path.trim_start_matches("impact."));
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The axis of a key.
pub(super) fn axis_of(key: &Key, is_logarithmic: bool) -> Axis {
    let (title, unit) = (title_of(key.path), key.quantity.dimension.si_unit());
    if is_logarithmic { Axis::log(&title, unit) } else { Axis::engineering(&title, unit) }
}
