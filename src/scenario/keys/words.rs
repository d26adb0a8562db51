//! The words that keys take in place of numbers.

use super::WordList;
use crate::contact::law::LawChoice;
use crate::contact::law::catalogue::jackson_green::HardnessFit;
use crate::contact::strength::kind::StrengthKind;
use crate::impact::series::SpotMode;
use crate::impact::{Method, PlateTheory};
use crate::materials::{MaterialEntry, absent_reason, all_materials, name_words};
use crate::results::result_columns;
use crate::strings::{did_you_mean, known_names};

const fn word_list(one: &'static str, several: &'static str, known: fn() -> Vec<String>) -> WordList {
    WordList { singular: one, plural: several, values: known }
}

/// Names in a message about an unknown word.
const MOST_NAMES: usize = 5;

/// The end of a message about a material that is not in the list. It names the materials whose descriptions have all words of the name,
/// or the nearest names.
pub fn unknown_material(name: &str) -> String {
    if let Some(reason) = absent_reason(name) {
        return format!(". It is left out, because {reason}.");
    }
    let parts = name_words(name);
    let has = |words: &str, part: &str| words.split(|c: char| !c.is_alphanumeric() && c != '.').any(|own| own == part);
    let is_meant = |entry: &&MaterialEntry| {
        let words = format!("{} {}", entry.name, entry.title).to_lowercase();
        !parts.is_empty() && parts.iter().all(|part| has(&words, part))
    };
    let meant: Vec<&str> = all_materials().iter().filter(is_meant).map(|entry| entry.name.as_str()).collect();
    let names: Vec<&str> = all_materials().iter().map(|entry| entry.name.as_str()).collect();
    let rest = format!(
        "{}; `plm-impact materials` lists all. A scenario can give youngs_modulus, poissons_ratio and density instead",
        known_names(name, &names, "materials")
    );
    match &meant[..] {
        [one] => format!(", did you mean \"{one}\"?"),
        [] => did_you_mean(name, names, '"', &rest),
        several => {
            let first = several[..several.len().min(MOST_NAMES)].join("\", \"");
            let more = several.len().saturating_sub(MOST_NAMES);
            let more =
                if more > 0 { format!(" `plm-impact materials {name}` lists {more} more.") } else { String::new() };
            format!(", did you mean one of \"{first}\"?{more}")
        }
    }
}

/// Names of integration methods.
pub static METHODS: WordList = word_list("method", "methods", || to_texts(Method::ALL.map(Method::name)));
/// Names of whole laws.
pub static LAWS: WordList = word_list("law", "laws", || law_names(LawChoice::has_loading));
/// Laws, as an axis takes them.
pub static LAW_AXIS: WordList =
    word_list("law", "laws (or \"loading + unloading\" such as \"jackson_green + brake\")", || {
        law_names(LawChoice::has_loading)
    });
pub static LOADINGS: WordList = word_list("loading", "loadings", || law_names(LawChoice::has_loading));
pub static UNLOADINGS: WordList = word_list("unloading", "unloadings", || law_names(|_| true));
/// Spots of repeated impacts.
pub static SPOT_MODES: WordList = word_list("spot", "spots", || to_texts(SpotMode::ALL.map(SpotMode::name)));
/// Forms of the hardness of Jackson and Green.
pub static HARDNESSES: WordList = word_list("word", "words here", || to_texts(HardnessFit::ALL.map(HardnessFit::name)));
/// Words for the noise of measurements, if it is not given by numbers.
pub static NOISES: WordList = word_list("word", "words here", || to_texts(["estimate"]));
/// Kinds of a strength.
pub static STRENGTH_KINDS: WordList =
    word_list("kind", "kinds", || to_texts(StrengthKind::ALL.map(StrengthKind::name)));
/// How the rise of a strength with the rate of strain is given, if not by a table.
pub static RATES: WordList = word_list("word", "words here", || to_texts(["material"]));
/// Scales on which the range of a key is searched.
pub static SCALES: WordList = word_list("scale", "scales", || to_texts(["log", "linear"]));
/// The ways to treat outliers.
pub static ROBUSTS: WordList = word_list("word", "words here", || to_texts(["student-t", "none"]));
/// The place of `student-t` among them.
pub const STUDENT_T: usize = 0;
pub static MATERIALS: WordList =
    word_list("material", "materials", || to_texts(all_materials().iter().map(|entry| &entry.name)));
pub static PLATES: WordList = word_list("word", "words here", || to_texts(PlateTheory::ALL.map(PlateTheory::name)));
/// Distributions of a material within its ranges.
pub static MATERIAL_DISTRIBUTIONS: WordList = word_list("word", "words here", || to_texts(["uniform"]));
/// Names of the results that a table may have.
pub static COLUMNS: WordList =
    word_list("result", "results", || to_texts(result_columns().iter().map(|column| column.name)));

fn to_texts(known: impl IntoIterator<Item = impl ToString>) -> Vec<String> {
    known.into_iter().map(|word| word.to_string()).collect()
}

fn law_names(is_wanted: fn(&LawChoice) -> bool) -> Vec<String> {
    to_texts(LawChoice::all().iter().filter(|law| is_wanted(law)).map(LawChoice::name))
}
