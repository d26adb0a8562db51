//! Scenarios: a TOML file with units, checked during parsing.

mod body_materials;
pub mod document;
pub mod input;
pub mod key_docs;
#[doc(hidden)]
pub mod keys;
mod kind;
pub mod kinds;
mod no_result;
mod origin;
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
use crate::impact::{Contact, ImpactError};
use crate::scenario::plan::AxisSetting;
pub use document::{Document, MAX_DATA_MIB, MAX_SCENARIO_MIB, Override, read_open_file, read_text};
use input::reader::{Reader, as_table};
use input::{ALTERNATIVES, Body, Input, N_BODY_KEYS, N_SPHERE_KEYS, REQUIRED_KEYS, without_axis_table as varied_key};
use keys::key;
pub use kind::{Kind, TEMPLATES};
pub use no_result::no_result_error;
use plan::varied::VariedKeys;
pub use rules::effect::Facts;
pub use source::{ScenarioIdentity, ScenarioSource};

/// A parsed and checked scenario.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Its text, for the positions of values.
    pub document: Document,
    /// Its values, including the values that the bodies take from their materials.
    input: Input,
    variation: VariedKeys,
    /// The texts of the files that it names, by their keys. Each file is read once, so hash and numbers belong to one text.
    files: BTreeMap<String, (PathBuf, String)>,
    /// The folder of the files that it names.
    directory: PathBuf,
    /// The path of its file relative to the folder of its results, if there is a file.
    pub from_results: Option<String>,
}

/// An input that fulfils all rules, and its contact or the reason why it has no contact.
pub type CheckedInput = (Input, Result<Contact, ImpactError>);

const NEEDS_GRAVITY_TEXT: &str =
    "drop_height = 0 requires [gravity]. Add [gravity] with acceleration = \"9.81 m/s^2\", or give a height above 0.";

/// The key of the file of measurements.
const DATA_KEY: &str = "calibrate.data";

impl Scenario {
    /// Reads a scenario file, with `key=value` overrides.
    pub fn load(path: &Path, overrides: &[Override]) -> Result<Self, Error> {
        let text = document::read_text(path, MAX_SCENARIO_MIB)?;
        let directory = path.parent().unwrap_or(Path::new("")).to_owned();
        Self::new(path.display().to_string(), text, overrides, directory, BTreeMap::new())
    }

    /// Parses a scenario from a text; `name` stands for the file in messages.
    pub fn from_text(name: &str, text: &str, overrides: &[Override]) -> Result<Self, Error> {
        Self::new(name.to_owned(), text.to_owned(), overrides, PathBuf::new(), BTreeMap::new())
    }

    /// `texts` holds the texts of files by their keys, if they are known without the files.
    fn new(
        name: String,
        text: String,
        overrides: &[Override],
        directory: PathBuf,
        mut texts: BTreeMap<String, String>,
    ) -> Result<Self, Error> {
        let document = Document::new(name, text, overrides)?;
        let mut files = BTreeMap::new();
        let mut read = |key: &str, name: &str| {
            let path = directory.join(name);
            let text = match texts.remove(key) {
                Some(text) => text,
                None => document::read_text(&path, MAX_SCENARIO_MIB).map_err(|error| error.to_string())?,
            };
            files.insert(key.to_owned(), (path.clone(), text.clone()));
            Ok([path.display().to_string(), text])
        };
        let root = document.tables()?;
        let mut reader = Reader::new(&mut read);
        let (mut input, mut varied) = (Input::default(), VariedKeys::default());
        if let Ok(tables) = as_table(&root) {
            input.read(tables, "", &mut reader);
            varied = VariedKeys::read(tables, &mut reader);
        }
        // a refused material would have given keys
        let lacks_material = |(path, _): &(String, _)| Body::from_material_key(varied_key(path)).is_some();
        let has_unknown = reader.has_unknown || reader.errors.iter().any(lacks_material);
        let mut mistakes = document.refusals(reader.errors);
        let choices = varied.apply_materials(&input, &document).unwrap_or_else(|mistake| {
            mistakes.push(mistake);
            Vec::new()
        });
        for choice in &choices {
            input.apply_material(choice);
        }
        input.set_materials(choices);
        if let Some(name) = input.text_value(key!("calibrate.data")) {
            let path = directory.join(name);
            // a file that cannot be read is refused where it is needed
            let text = texts.remove(DATA_KEY).or_else(|| document::read_text(&path, MAX_DATA_MIB).ok());
            files.extend(text.map(|text| (DATA_KEY.to_owned(), (path, text))));
        }
        let scenario = Self { document, input, variation: varied, files, directory, from_results: None };
        mistakes.extend(scenario.check_combinations());
        // a misspelt key, or a value of a misspelt material, is not also reported as missing
        if !has_unknown {
            let needed = scenario.needed_while_reading(mistakes.is_empty());
            mistakes.extend(scenario.missing_keys(&REQUIRED_KEYS[..needed]));
        }
        Error::combine(mistakes).map_or(Ok(scenario), Err)
    }

    /// How many of [`REQUIRED_KEYS`] are asked for while the scenario is read. An impact asks for its keys when it is resolved,
    /// unless the scenario has to change anyway.
    fn needed_while_reading(&self, is_correct: bool) -> usize {
        match self.kind() {
            Ok(Kind::Impact | Kind::Repeat | Kind::Sweep | Kind::MonteCarlo) if is_correct => 0,
            Ok(Kind::Impact | Kind::Repeat | Kind::Sweep | Kind::MonteCarlo) => REQUIRED_KEYS.len() - 1,
            Ok(Kind::Indentation) if !self.is_given("half_space") => N_SPHERE_KEYS,
            Ok(Kind::Indentation | Kind::Calibrate) => N_BODY_KEYS,
            Err(_) => N_SPHERE_KEYS,
        }
    }

    /// Refuses a scenario that lacks one of these keys.
    fn require(&self, keys: &[&'static str]) -> Result<(), Error> {
        Error::combine(self.missing_keys(keys)).map_or(Ok(()), Err)
    }

    /// The refusals of those of these keys that are missing. A key is not missing if its alternative is given, or if it varies over
    /// the cases of a table. If the table is missing, its keys are not reported.
    fn missing_keys(&self, keys: &[&'static str]) -> Vec<Error> {
        let group = |key: &&'static str| {
            ALTERNATIVES.iter().find(|group| group[0] == *key).map_or_else(|| vec![*key], |group| group.to_vec())
        };
        let (mut missing, mut tables) = (Vec::new(), Vec::new());
        for group in
            keys.iter().map(group).filter(|group| !group.iter().any(|path| self.origin(path).is_given_or_varies()))
        {
            let (table, _) = group[0].split_once('.').unwrap_or_default();
            // a body needs more keys than the varied one, and so its table
            let in_table = |path: &&str| path.split_once('.').is_some_and(|(other, _)| other == table);
            if self.is_given(table) || self.variation.paths().iter().any(|path| table == "impact" && in_table(path)) {
                missing.push(self.document.missing_any_key(table, &group, ""));
            } else if !tables.contains(&table) {
                tables.push(table);
                missing.push(self.document.missing_key("", table));
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
        self.check_impact().map(|(input, _)| input)
    }

    /// The input of a scenario that needs no impact, and its contact. The speed is NaN if it is not given.
    pub fn resolve_bodies(&self) -> Result<CheckedInput, Error> {
        self.check_input(REQUIRED_KEYS.len() - 1)
    }

    pub(in crate::scenario) fn check_impact(&self) -> Result<CheckedInput, Error> {
        self.check_speeds()?;
        self.check_input(if self.shot_speeds().is_some() { REQUIRED_KEYS.len() - 1 } else { REQUIRED_KEYS.len() })
    }

    /// The input of the first case, in which the first `needed` keys of [`REQUIRED_KEYS`] must be given, and its contact. A table
    /// may have cases without a contact.
    fn check_input(&self, needed: usize) -> Result<CheckedInput, Error> {
        self.require(&REQUIRED_KEYS[..needed])?;
        let input = self.first_case();
        let contact = input.contact();
        let does_not_fall = input.speed() == 0.0 && input.forces().gravity.is_none();
        let fall = if does_not_fall {
            Err(self.refusal_where_varied("impact.drop_height", NEEDS_GRAVITY_TEXT))
        } else {
            Ok(())
        };
        let checked = [
            self.check_flow(&input),
            fall,
            self.check_target(&input, &contact),
            self.check_waveguide(&contact),
            self.check_air(&input),
            self.check_strength(&input),
            self.check_rates(&input),
        ];
        Error::combine(checked.into_iter().filter_map(Result::err).collect()).map_or(Ok((input, contact)), Err)
    }

    /// The input with the first value of every varied key: of its axis or range, of a list of shots, or the median of its distribution.
    fn first_case(&self) -> Input {
        let mut input = self.input.clone();
        if let Some(speed) = self.shot_speeds().and_then(<[f64]>::first) {
            input.set(key!("impact.speed"), Some(*speed));
        }
        for axis in self.variation.sweep.iter().flatten() {
            if let AxisSetting::Number { key, values } = &axis.setting {
                key.set_exclusive(&mut input, values.value_at(0));
            }
        }
        for variable in self.variation.monte_carlo.iter().flat_map(|random| &random.variables) {
            variable.key.set_exclusive(&mut input, variable.median());
        }
        for free in self.variation.free.iter().flatten() {
            free.key.set_exclusive(&mut input, free.from);
        }
        input
    }
}
