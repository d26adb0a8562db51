//! Materials by name: density, elastic constants and hardness. Each value has a range, says what kind of number it is,
//! and names its sources. The file `materials/materials.toml` says how the values were chosen.

mod entry;
mod file;
pub mod shots;

use std::collections::BTreeMap;
use std::sync::LazyLock;

pub use entry::{MaterialClass, MaterialEntry, Property, PropertyValue, QuotedValue, RateClass};
pub use file::read;

const FILE: &str = include_str!("materials.toml");

/// All materials, in the order of the file.
pub fn all_materials() -> &'static [MaterialEntry] {
    static ALL: LazyLock<Vec<MaterialEntry>> = LazyLock::new(|| read(FILE).unwrap_or_default());
    &ALL
}

/// The material of this name, or with this alias: "AISI 304" is "304", and "aluminum-6061-t6" is "aluminium-6061-t6".
pub fn find(name: &str) -> Option<&'static MaterialEntry> {
    let is_other_name =
        |plain: &str, entry: &MaterialEntry| entry.name == plain || entry.aliases.iter().any(|alias| alias == plain);
    all_materials().iter().find(|entry| entry.name == name).or_else(|| {
        let plain = plain_name(name);
        all_materials().iter().find(|entry| is_other_name(&plain, entry))
    })
}

/// Names of standards before the number of a material.
const NORMS: [&str; 8] = ["aisi", "sae", "en", "din", "jis", "astm", "alloy", "grade"];

/// The words of a name in small letters, without the name of a standard, and in British spelling.
pub fn name_words(name: &str) -> Vec<String> {
    let lower = name.to_lowercase().replace("aluminum", "aluminium");
    let words = lower.split(|c: char| !c.is_alphanumeric() && c != '.' && c != '/');
    words.filter(|word| !word.is_empty() && !NORMS.contains(word)).map(str::to_owned).collect()
}

/// A name in the form of an alias.
pub fn plain_name(name: &str) -> String {
    name_words(name).join("-")
}

/// Why the library has no material of this name, if the file says so.
pub fn absent_reason(name: &str) -> Option<&'static str> {
    static ABSENT: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| file::read_absent(FILE).unwrap_or_default());
    let without_digits = |word: String| word.trim_start_matches(|c: char| c.is_ascii_digit()).to_owned();
    let words: Vec<String> = name_words(name).into_iter().map(without_digits).collect();
    let is_meant = |absent: &str| absent.split('-').all(|part| words.iter().any(|word| word == part));
    ABSENT.iter().find(|(absent, _)| is_meant(absent)).map(|(_, reason)| reason.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standards_and_spellings_name_one_material() {
        let names = [
            "304",
            "AISI 304",
            "AISI-304",
            "1.4301",
            "100Cr6",
            "S235",
            "6061",
            "aluminum 6061-T6",
            "az31b",
            "Concrete",
        ];
        let found = names.map(|name| find(name).map_or("", |entry| entry.name.as_str()));
        let [stainless, bearing, s235] = ["steel-304-annealed", "steel-52100-hardened", "steel-s235"];
        let [aluminium, magnesium, concrete] = ["aluminium-6061-t6", "magnesium-az31b", "concrete-c30"];
        let meant =
            [stainless, stainless, stainless, stainless, bearing, s235, aluminium, aluminium, magnesium, concrete];
        assert_eq!(found, meant);
        assert_eq!(["aluminum", "steel", "cheese", "", "/"].map(find), [None; 5]);
    }

    /// An alias names one material, and is written as [`plain_name`] writes it.
    #[test]
    fn aliases_are_unique() {
        let all: Vec<&str> = all_materials().iter().flat_map(|entry| &entry.aliases).map(String::as_str).collect();
        for alias in &all {
            assert_eq!(plain_name(alias), **alias);
            assert_eq!(all.iter().filter(|other| other == &alias).count(), 1, "{alias}");
            assert!(all_materials().iter().all(|entry| entry.name != **alias), "{alias}");
        }
    }

    #[test]
    fn absent_material_has_a_reason() {
        for name in ["oak", "Ti-10Nb", "natural rubber", "polyurethane", "marble"] {
            assert!(find(name).is_none() && absent_reason(name).is_some(), "{name}");
        }
        assert_eq!(absent_reason("titanium"), None);
    }
}
