//! The words that keys take in place of numbers.

use super::field::{Fault, OneOf, Reader, Scalar, word};
use super::key::{Form, Words};
use super::results::columns;
use super::written::Node;
use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::{Entry as Material, all, find};
use crate::repeat::Place;

/// Words, each kind as a value and as a type.
macro_rules! words {
    ($($(#[doc = $about:literal])+ $name:ident $kind:ident = $words:expr;)+) => {$(
        $(#[doc = $about])+
        pub static $name: Words = $words;
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub struct $kind;
        impl OneOf for $kind {
            const WORDS: &'static Words = &$name;
        }
    )+};
}

words! {
    /// Names of integration methods.
    METHODS Methods = Words {
        one: "method",
        several: "methods",
        known: || Method::ALL.iter().map(|(name, _)| (*name).to_owned()).collect(),
    };
    /// Names of whole laws, as an axis takes them.
    LAWS Laws = Words { one: "law", several: "laws", known: || names(LawChoice::has_loading) };
    /// Names of laws that load.
    LOADINGS Loadings = Words { one: "loading", several: "loadings", known: || names(LawChoice::has_loading) };
    /// Names of laws that unload.
    UNLOADINGS Unloadings = Words { one: "unloading", several: "unloadings", known: || names(|_| true) };
    /// Names of laws with an unloading of their own.
    OWN_UNLOADINGS OwnUnloadings = Words { one: "unloading", several: "unloadings", known: || names(LawChoice::has_own_unloading) };
    /// Where repeated impacts hit.
    SPOTS Spots = Words { one: "spot", several: "spots", known: || Place::ALL.iter().map(|place| place.name().to_owned()).collect() };
    /// What is done about a jump of the printed formulas.
    JUMPS JumpWords = Words { one: "word", several: "words here", known: || texts(&["printed", "crossed"]) };
    /// Forms of the hardness of Jackson and Green.
    HARDNESSES Hardnesses = Words { one: "word", several: "words here", known: || texts(&["exponential", "cosine"]) };
    /// How the noise of measurements is given, if not by numbers.
    NOISES Noises = Words { one: "word", several: "words here", known: || texts(&["estimate"]) };
    /// How the range of a key is searched.
    SCALES Scales = Words { one: "scale", several: "scales", known: || texts(&["log", "linear"]) };
    /// What is done about outliers.
    ROBUSTS Robusts = Words { one: "word", several: "words here", known: || texts(&["student-t", "none"]) };
    /// Names of materials.
    MATERIALS Materials = Words { one: "material", several: "materials", known: || all().iter().map(|entry| entry.name.clone()).collect() };
    /// How a material is drawn from its ranges.
    DRAWN Drawn = Words { one: "word", several: "words here", known: || texts(&["uniform"]) };
    /// Names of the results that a table may have.
    COLUMNS Columns = Words {
        one: "result",
        several: "results",
        known: || columns().iter().map(|column| column.name.to_owned()).collect(),
    };
}

/// Words that stand for a value of a type that is defined elsewhere.
macro_rules! named {
    ($($type:ty: $words:ident, $find:expr;)+) => {$(
        impl Scalar for $type {
            fn form() -> Form {
                Form::Word(&$words)
            }
            fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
                let name = word(&$words, node)?;
                ($find)(&name).ok_or_else(|| Fault::at(node, format!("unknown {} \"{name}\"", $words.one)))
            }
        }
    )+};
}

named! {
    Method: METHODS, Method::from_name;
    &'static Material: MATERIALS, find;
    Place: SPOTS, |name: &str| Place::ALL.into_iter().find(|place| place.name() == name);
}

fn texts(known: &[&str]) -> Vec<String> {
    known.iter().map(ToString::to_string).collect()
}

fn names(is_wanted: fn(&LawChoice) -> bool) -> Vec<String> {
    LawChoice::all().iter().filter(|law| is_wanted(law)).map(LawChoice::name).collect()
}
