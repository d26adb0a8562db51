//! Materials by name: density, elastic constants and hardness. Each value has a range, says what kind of number it is,
//! and names its sources. The file `materials/materials.toml` says how the values were chosen.

mod entry;
mod file;
pub mod shots;

use std::sync::LazyLock;

pub use entry::{MaterialClass, MaterialEntry, Property, PropertyValue, QuotedValue, RateClass};
pub use file::read;

/// All materials, in the order of the file.
pub fn all_materials() -> &'static [MaterialEntry] {
    static ALL: LazyLock<Vec<MaterialEntry>> =
        LazyLock::new(|| read(include_str!("materials.toml")).unwrap_or_default());
    &ALL
}

/// The material of this name.
pub fn find(name: &str) -> Option<&'static MaterialEntry> {
    all_materials().iter().find(|entry| entry.name == name)
}
