//! The words that keys take in place of numbers.

use super::results::columns;
use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::all;
use crate::repeat::Place;

/// Words that a key takes.
#[derive(Debug)]
pub struct Words {
    /// What one of them is called in messages.
    pub one: &'static str,
    /// What several of them are called in messages.
    pub several: &'static str,
    /// All of them.
    pub known: fn() -> Vec<String>,
}

/// Names of integration methods.
pub static METHODS: Words = Words {
    one: "method",
    several: "methods",
    known: || Method::ALL.iter().map(|(name, _)| (*name).to_owned()).collect(),
};
/// Names of whole laws, as an axis takes them.
pub static LAWS: Words = Words { one: "law", several: "laws", known: || names(LawChoice::has_loading) };
/// Names of laws that load.
pub static LOADINGS: Words = Words { one: "loading", several: "loadings", known: || names(LawChoice::has_loading) };
/// Names of laws that unload.
pub static UNLOADINGS: Words = Words { one: "unloading", several: "unloadings", known: || names(|_| true) };
/// Names of laws with an unloading of their own.
pub static OWN_UNLOADINGS: Words =
    Words { one: "unloading", several: "unloadings", known: || names(LawChoice::has_own_unloading) };
/// Where repeated impacts hit.
pub static SPOTS: Words =
    Words { one: "spot", several: "spots", known: || Place::ALL.iter().map(|place| place.name().to_owned()).collect() };
/// What is done about a jump of the printed formulas.
pub static JUMPS: Words = Words { one: "word", several: "words here", known: || words(&["printed", "crossed"]) };
/// Forms of the hardness of Jackson and Green.
pub static HARDNESSES: Words =
    Words { one: "word", several: "words here", known: || words(&["exponential", "cosine"]) };
/// How the noise of measurements is given, if not by numbers.
pub static NOISES: Words = Words { one: "word", several: "words here", known: || words(&["estimate"]) };
/// How the range of a key is searched.
pub static SCALES: Words = Words { one: "scale", several: "scales", known: || words(&["log", "linear"]) };
/// What is done about outliers.
pub static ROBUSTS: Words = Words { one: "word", several: "words here", known: || words(&["student-t", "none"]) };
/// Names of materials.
pub static MATERIALS: Words =
    Words { one: "material", several: "materials", known: || all().iter().map(|entry| entry.name.clone()).collect() };
/// How a material is drawn from its ranges.
pub static DRAWN: Words = Words { one: "word", several: "words here", known: || words(&["uniform"]) };
/// Names of the results that a table may have.
pub static COLUMNS: Words = Words {
    one: "result",
    several: "results",
    known: || columns().iter().map(|column| column.name.to_owned()).collect(),
};

fn words(known: &[&str]) -> Vec<String> {
    known.iter().map(ToString::to_string).collect()
}

fn names(is_wanted: fn(&LawChoice) -> bool) -> Vec<String> {
    LawChoice::all().iter().filter(|law| is_wanted(law)).map(LawChoice::name).collect()
}
