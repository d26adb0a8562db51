//! Scenarios: a TOML file with units, checked during parsing.

mod body_materials;
pub mod document;
pub mod input;
pub mod key_docs;
#[doc(hidden)]
pub mod keys;
mod kind;
pub mod kinds;
#[doc(hidden)]
pub mod plan;
pub(crate) mod rules;
pub mod schema;
mod source;
mod syntax;
pub(crate) mod toml_node;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::impact::Warning;
use crate::scenario::plan::Setting;
pub use document::{Document, LARGEST_DATA, LARGEST_SCENARIO, read_text, text_of};
use input::reader::{Reader, items};
use input::{
    BODIES, Body, BodyMaterial, EITHER, Input, NEEDED, Purpose, SPHERE, partner, varied as varied_key, without_effect,
};
use keys::{EVERY_KEY, at};
pub use kind::{Kind, TEMPLATES};
use plan::varied::Varied;
pub use source::Source;

/// A parsed and checked scenario.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Its text, for the positions of values.
    pub document: Document,
    /// Its values, including the values that the bodies take from their materials.
    input: Input,
    varied: Varied,
    /// The texts of the files that it names, by their keys. Each file is read once, so hash and numbers belong to one text.
    files: BTreeMap<String, (PathBuf, String)>,
    /// The folder of the files that it names.
    directory: PathBuf,
    /// The path of its file relative to the folder of its results, if there is a file.
    pub from_results: Option<String>,
}

const NO_FALL: &str = "a sphere that is released at first touch needs gravity: add [gravity] with acceleration = \"9.81 m/s^2\", or give a height above 0";

/// The key of the file of measurements.
const DATA: &str = "calibrate.data";

impl Scenario {
    /// Reads a scenario file, with `key=value` overrides.
    pub fn load(path: &Path, overrides: &[String]) -> Result<Self, Error> {
        let text = document::read_text(path, LARGEST_SCENARIO)?;
        let directory = path.parent().unwrap_or(Path::new("")).to_owned();
        Self::new(path.display().to_string(), text, overrides, directory, BTreeMap::new())
    }

    /// Parses a scenario from a text; `name` stands for the file in messages.
    pub fn from_text(name: &str, text: &str, overrides: &[String]) -> Result<Self, Error> {
        Self::new(name.to_owned(), text.to_owned(), overrides, PathBuf::new(), BTreeMap::new())
    }

    /// `texts` holds the texts of files by their keys, if they are known without the files.
    fn new(
        name: String,
        text: String,
        overrides: &[String],
        directory: PathBuf,
        mut texts: BTreeMap<String, String>,
    ) -> Result<Self, Error> {
        let document = Document::new(name, text, overrides)?;
        let mut files = BTreeMap::new();
        let mut read = |key: &str, name: &str| {
            let path = directory.join(name);
            let text = match texts.remove(key) {
                Some(text) => text,
                None => document::read_text(&path, LARGEST_SCENARIO).map_err(|error| error.to_string())?,
            };
            files.insert(key.to_owned(), (path.clone(), text.clone()));
            Ok([path.display().to_string(), text])
        };
        let root = document.tables()?;
        let mut reader = Reader::new(&mut read);
        let (mut input, mut varied) = (Input::default(), Varied::default());
        if let Ok(tables) = items(&root) {
            input.read(tables, "", &mut reader);
            varied = Varied::read(tables, &mut reader);
        }
        // a refused material would have given keys
        let lacks_material = |(path, _): &(String, _)| Body::of_key(varied_key(path)).is_some();
        let has_unknown = reader.has_unknown || reader.refused.iter().any(lacks_material);
        let mut mistakes = document.refused(reader.refused);
        let choices = varied.take_materials(&input, &document).unwrap_or_else(|mistake| {
            mistakes.push(mistake);
            Vec::new()
        });
        for choice in &choices {
            input.take(choice);
        }
        input.set_materials(choices);
        if let Some(name) = input.text(at!("calibrate.data")) {
            let path = directory.join(name);
            // a file that cannot be read is refused where it is needed
            let text = texts.remove(DATA).or_else(|| document::read_text(&path, LARGEST_DATA).ok());
            files.extend(text.map(|text| (DATA.to_owned(), (path, text))));
        }
        let scenario = Self { document, input, varied, files, directory, from_results: None };
        mistakes.extend(scenario.check_combinations());
        // a misspelt key, or a value of a misspelt material, is not also reported as missing
        if !has_unknown {
            let needed = match scenario.kind() {
                // an impact checks for all needed keys when it is resolved, unless the scenario has to change anyway
                Ok(Kind::Impact | Kind::Repeat | Kind::Sweep | Kind::MonteCarlo) if mistakes.is_empty() => 0,
                Ok(Kind::Impact | Kind::Repeat | Kind::Sweep | Kind::MonteCarlo) => NEEDED.len() - 1,
                Ok(Kind::Indentation) if !scenario.has("half_space") => SPHERE,
                Ok(Kind::Indentation | Kind::Calibrate) => BODIES,
                Err(_) => SPHERE,
            };
            mistakes.extend(scenario.missing(&NEEDED[..needed]));
        }
        Error::combine(mistakes).map_or(Ok(scenario), Err)
    }

    /// True if the scenario, or a named material, gives a key, or if the scenario has a table.
    fn has(&self, path: &str) -> bool {
        let is_taken = || self.input.materials().iter().flat_map(BodyMaterial::values).any(|(given, _)| given == path);
        self.document.has(path) || is_taken()
    }

    /// True if a key varies over the cases of a table, or is a free key of a calibration.
    fn varies(&self, path: &str) -> bool {
        self.varied.paths().contains(&path)
    }

    /// Refuses a scenario that lacks one of these keys.
    fn need(&self, keys: &[&'static str]) -> Result<(), Error> {
        Error::combine(self.missing(keys)).map_or(Ok(()), Err)
    }

    /// The refusals of those of these keys that are missing. A key is not missing if its alternative is given, or if it varies over
    /// the cases of a table. If the table is missing, its keys are not reported.
    fn missing(&self, keys: &[&'static str]) -> Vec<Error> {
        let group = |key: &&'static str| {
            EITHER.iter().find(|pair| pair[0] == *key).map_or_else(|| vec![*key], |pair| pair.to_vec())
        };
        let (mut missing, mut tables) = (Vec::new(), Vec::new());
        for group in keys.iter().map(group).filter(|group| !group.iter().any(|path| self.gives(path))) {
            let (table, _) = group[0].split_once('.').unwrap_or_default();
            // a body needs more keys than the varied one, and so its table
            let in_table = |path: &&str| path.split_once('.').is_some_and(|(other, _)| other == table);
            if self.has(table) || self.varied.paths().iter().any(|path| table == "impact" && in_table(path)) {
                missing.push(self.document.missing_one_of(table, &group, ""));
            } else if !tables.contains(&table) {
                tables.push(table);
                missing.push(self.document.missing("", table));
            }
        }
        missing
    }

    /// The values of the scenario, complete or not.
    pub fn input(&self) -> &Input {
        &self.input
    }

    /// The input of the first impact, with all keys that an impact needs.
    pub fn resolve(&self) -> Result<Input, Error> {
        self.check_speeds()?;
        self.checked(if self.speeds().is_some() { NEEDED.len() - 1 } else { NEEDED.len() })
    }

    /// The input of a scenario that needs no impact: its speed is NaN if it is not given.
    pub fn resolve_bodies(&self) -> Result<Input, Error> {
        self.checked(NEEDED.len() - 1)
    }

    /// The input of the first case, in which the first `needed` keys of [`NEEDED`] must be given.
    fn checked(&self, needed: usize) -> Result<Input, Error> {
        self.need(&NEEDED[..needed])?;
        let input = self.first_case();
        let does_not_fall = input.speed() == 0.0 && input.forces().gravity.is_none();
        let fall = if does_not_fall { Err(self.refuse_varied("impact.drop_height", NO_FALL)) } else { Ok(()) };
        let checked = [
            self.check_flow(&input),
            fall,
            self.check_target(&input),
            self.check_plate(&input),
            self.check_air(&input),
            self.check_strength(&input),
            self.check_rates(&input),
        ];
        Error::combine(checked.into_iter().filter_map(Result::err).collect()).map_or(Ok(input), Err)
    }

    /// The input with the first value of every varied key: of its axis or range, of a list of shots, or the median of its distribution.
    fn first_case(&self) -> Input {
        let mut input = self.input.clone();
        if let Some(speed) = self.speeds().and_then(<[f64]>::first) {
            input.set(at!("impact.speed"), Some(*speed));
        }
        for axis in self.varied.sweep.iter().flatten() {
            if let Setting::Number { key, values } = &axis.setting {
                key.put(&mut input, values.at(0));
            }
        }
        for variable in self.varied.monte_carlo.iter().flat_map(|random| &random.variables) {
            variable.key.put(&mut input, variable.middle());
        }
        for free in self.varied.free.iter().flatten() {
            free.key.put(&mut input, free.from);
        }
        input
    }

    /// Warnings about given keys that have no effect on the results of these inputs. Such keys are allowed, as the file may also be run
    /// in another way. Needed keys get no warning.
    pub fn without_effect(&self, inputs: &[Input], purpose: Purpose) -> Vec<Warning> {
        let needed = if purpose == Purpose::Impact { &NEEDED[..] } else { &NEEDED[..NEEDED.len() - 2] };
        let is_needed = |path: &str| [Some(path), partner(path)].into_iter().flatten().any(|key| needed.contains(&key));
        let keys =
            EVERY_KEY.iter().map(|key| key.path).filter(|path| !path.starts_with("law.") && self.document.has(path));
        let given = keys.chain(self.document.inside("law.")).filter(|path| !is_needed(path));
        given.filter_map(|path| Some(Warning::unused_key(path, without_effect(path, inputs, purpose)?))).collect()
    }
}
