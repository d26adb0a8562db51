//! The words that keys take in place of numbers.

use super::field::{Field, Held, show_word};
use super::key::{Form, Words};
use super::read::{Fault, Reader, named};
use super::results::columns;
use super::written::Node;
use crate::impact::{Method, PlateTheory};
use crate::law::catalogue::jackson_green::Hardness;
use crate::law::{LawChoice, UnloadingExponent};
use crate::materials::{Entry as Material, all, find};
use crate::repeat::Place;

const fn words(one: &'static str, several: &'static str, known: fn() -> Vec<String>) -> Words {
    Words { one, several, known }
}

/// Names of integration methods.
pub static METHODS: Words = words("method", "methods", || texts(Method::ALL.map(Method::name)));
/// Names of whole laws.
pub static LAWS: Words = words("law", "laws", || laws(LawChoice::has_loading));
/// The same, as an axis takes them.
pub static AXIS_OF_LAWS: Words =
    words("law", "laws (or \"loading + unloading\" such as \"jackson_green + brake\")", || {
        laws(LawChoice::has_loading)
    });
/// Names of laws that load.
pub static LOADINGS: Words = words("loading", "loadings", || laws(LawChoice::has_loading));
/// Names of laws that unload.
pub static UNLOADINGS: Words = words("unloading", "unloadings", || laws(|_| true));
/// Where repeated impacts hit.
pub static SPOTS: Words = words("spot", "spots", || texts(Place::ALL.map(Place::name)));
/// Forms of the hardness of Jackson and Green.
pub static HARDNESSES: Words = words("word", "words here", || texts(Hardness::ALL.map(Hardness::name)));
/// How the noise of measurements is given, if not by numbers.
pub static NOISES: Words = words("word", "words here", || texts(["estimate"]));
/// How the range of a key is searched.
pub static SCALES: Words = words("scale", "scales", || texts(["log", "linear"]));
/// What is done about outliers.
pub static ROBUSTS: Words = words("word", "words here", || texts(["student-t", "none"]));
/// Names of materials.
pub static MATERIALS: Words = words("material", "materials", || texts(all().iter().map(|entry| &entry.name)));
/// How a plate gives way.
pub static PLATES: Words = words("word", "words here", || texts(PlateTheory::ALL.map(PlateTheory::name)));
/// How a material is drawn from its ranges.
pub static DRAWN: Words = words("word", "words here", || texts(["uniform"]));
/// Names of the results that a table may have.
pub static COLUMNS: Words = words("result", "results", || texts(columns().iter().map(|column| column.name)));

fn texts(known: impl IntoIterator<Item = impl ToString>) -> Vec<String> {
    known.into_iter().map(|word| word.to_string()).collect()
}

fn laws(is_wanted: fn(&LawChoice) -> bool) -> Vec<String> {
    texts(LawChoice::all().iter().filter(|law| is_wanted(law)).map(LawChoice::name))
}

/// Words that stand for a value of a type that is defined elsewhere.
macro_rules! named {
    ($($type:ty: $find:expr;)+) => {$(
        impl Field for $type {
            fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
                if let Form::Word(words) = form {
                    *self = named(words, node, $find)?.into();
                }
                Ok(())
            }
            fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
                let Form::Word(words) = form else { return };
                let is_this = |name: &String| ($find)(name).map(<$type>::from).as_ref() == Some(self);
                if let Some(name) = (words.known)().into_iter().find(is_this) {
                    show_word(name, path, into);
                }
            }
        }
    )+};
}

named! {
    Option<Method>: Method::find;
    Option<&'static Material>: find;
    Option<PlateTheory>: PlateTheory::find;
    Option<Place>: Place::find;
    Hardness: Hardness::find;
}

impl Field for UnloadingExponent {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let mut value = f64::NAN;
        value.read(form, node, reader)?;
        self.put(Some(value));
        Ok(())
    }
    fn given(&self) -> Option<f64> {
        Some(match self {
            Self::Paper => 1.5,
            Self::Fixed(value) => *value,
            Self::PressureShape => f64::INFINITY,
        })
    }
    fn put(&mut self, value: Option<f64>) {
        *self = match value {
            None => *self,
            Some(f64::INFINITY) => Self::PressureShape,
            Some(value) => Self::of(value),
        };
    }
}
