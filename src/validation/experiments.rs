//! Restitution measured by the user: a directory of CSV files, each with the properties of its bodies in comment lines.
//!
//! ```text
//! # sphere.radius = 1.5 mm                   (keys of [sphere], [half_space], [law], [gravity], [damping])
//! # half_space.hardness = 300 HV
//! # source = who measured it, and where it is published
//! speed_m_per_s,restitution,restitution_sd
//! 2.0,0.533,0.012
//! ```
//!
//! Other comment lines and other columns are ignored. `restitution_sd`, the standard deviation, may be left out. With
//! `half_space.density` the law includes the loss by elastic waves. Keys have the same defaults as in a scenario.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::ValidationError;
use crate::impact::{Contact, Method, Solver};
use crate::law::{LawChoice, PlmCoefficients};
use crate::scenario::{LARGEST_SCENARIO, Scenario, ScenarioError, read_text};
use crate::units::csv_text::{CsvText, TableError, without_mark};

/// A file of measured restitution, with the restitution by the law.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// The name of the file without its ending.
    pub name: String,
    /// Who measured; empty if the file does not say so.
    pub source: String,
    pub rows: Vec<Measured>,
    /// The two bodies and their law.
    contact: Contact,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Line of the file, counted from 1.
    pub line: u64,
    /// Impact speed \[m/s\].
    pub speed: f64,
    pub restitution: f64,
    /// Standard deviation of the measured e.
    pub sd: Option<f64>,
    /// Restitution e by the law, with the loss by waves if the half-space has a density.
    pub law: f64,
}

impl Measured {
    /// Relative deviation: law over measurement − 1.
    pub fn deviation(&self) -> f64 {
        self.law / self.restitution - 1.0
    }
}

/// The tables of a scenario whose keys a comment line may give.
const TABLES: [&str; 5] = ["sphere", "half_space", "law", "gravity", "damping"];
const COLUMNS: [&str; 3] = ["speed_m_per_s", "restitution", "restitution_sd"];

/// All experiments of a directory, in the order of their names. `coefficients` are used for the PLM if a file names no
/// others.
///
/// # Errors
/// [`ValidationError`] with the file, the line, what is wrong and what is needed.
pub fn load(directory: &Path, coefficients: &PlmCoefficients) -> Result<Vec<Experiment>, ValidationError> {
    let refuse = |problem: String| refusal(directory, None, problem);
    let entries = fs::read_dir(directory).map_err(|error| refuse(format!("cannot be read: {error}")))?;
    let paths = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<PathBuf>, std::io::Error>>();
    let mut paths = paths.map_err(|error| refuse(format!("cannot be read: {error}")))?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
    paths.sort();
    if paths.is_empty() {
        return Err(refuse(format!("has no file of measurements: a CSV file with the columns {}", COLUMNS.join(", "))));
    }
    paths.iter().map(|path| experiment(path, coefficients)).collect()
}

fn experiment(path: &Path, coefficients: &PlmCoefficients) -> Result<Experiment, ValidationError> {
    let text = read_text(path, LARGEST_SCENARIO).map_err(ValidationError::Unreadable)?;
    let text = without_mark(&text);
    let contact = contact(path, text, coefficients)?;
    let source =
        text.lines().find_map(|line| line.strip_prefix('#')?.trim().strip_prefix("source")?.trim().strip_prefix('='));
    let rows = rows(path, text, &contact)?;
    let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(Experiment { name, source: source.unwrap_or_default().trim().to_owned(), rows, contact })
}

fn refusal(path: &Path, line: Option<u64>, message: String) -> ValidationError {
    ValidationError::Experiment(TableError { name: path.display().to_string(), line, message })
}

/// The contact of the bodies in the comment lines. The keys are read as a scenario, in which every key has the line
/// number that it has in the file.
fn contact(path: &Path, text: &str, coefficients: &PlmCoefficients) -> Result<Contact, ValidationError> {
    let scenario: Vec<String> =
        text.lines().map(|line| line.strip_prefix('#').and_then(key).unwrap_or_default()).collect();
    let directory = path.parent().unwrap_or(Path::new("")).to_owned();
    let read = || -> Result<_, ScenarioError> {
        // the scenario needs a speed, which is not used: every row has its own
        let speed = "impact.speed=1".to_owned();
        let name = path.display().to_string();
        let scenario = Scenario::in_directory(&name, &scenario.join("\n"), &[speed], directory)?;
        let mut scene = scenario.resolve()?;
        if let LawChoice::Plm(plm) = &mut scene.law
            && !scenario.document.has("law.plm.coefficients")
        {
            plm.coefficients = Arc::new(coefficients.clone());
        }
        Ok(scene)
    };
    let scene = read().map_err(ValidationError::Unreadable)?;
    scene.contact().map_err(|error| refusal(path, None, error.to_string()))
}

/// The line of a scenario for a comment that gives a key; `None` for other comments.
fn key(comment: &str) -> Option<String> {
    let (key, value) = comment.split_once('=')?;
    let (key, value) = (key.trim(), value.trim());
    let is_key = key.split_once('.').is_some_and(|(table, _)| TABLES.contains(&table)) && !key.contains(' ');
    let is_toml = |text: &str| toml::from_str::<toml::Table>(text).is_ok();
    let plain = format!(" {key} = {value}");
    is_key.then(|| if is_toml(&plain) { plain } else { format!(" {key} = {}", toml::Value::from(value)) })
}

fn rows(path: &Path, text: &str, contact: &Contact) -> Result<Vec<Measured>, ValidationError> {
    let refused = |(line, message)| refusal(path, line, message);
    let table = CsvText::new(text).map_err(refused)?;
    let (header, first) = (table.header.clone(), table.line);
    let places = COLUMNS.map(|name| header.iter().position(|column| column == name));
    let [Some(speed), Some(restitution), sd] = places else {
        let problem = format!("needs the columns {} and {}, and may have {}", COLUMNS[0], COLUMNS[1], COLUMNS[2]);
        return Err(refusal(path, first, problem));
    };
    let mut rows = Vec::new();
    for row in table.rows() {
        let (line, record) = row.map_err(refused)?;
        let number = |place: usize, what: &str, is_allowed: fn(f64) -> bool| {
            let text = &record[place];
            let value = text.parse().ok().filter(|value| is_allowed(*value));
            value.ok_or_else(|| {
                refusal(path, Some(line), format!("{} = {text:?} is not allowed: it must be {what}", &header[place]))
            })
        };
        let speed = number(speed, "a speed in m/s, above 0 and finite", |value| value > 0.0 && value.is_finite())?;
        let restitution = number(restitution, "a number above 0, and at most 1", |value| value > 0.0 && value <= 1.0)?;
        let sd = sd.filter(|place| !record[*place].is_empty());
        let sd = sd.map(|place| number(place, "0 or more, and finite", |value| value >= 0.0 && value.is_finite()));
        let law = law(contact, speed).map_err(|error| refusal(path, Some(line), error.to_string()))?;
        rows.push(Measured { line, speed, restitution, sd: sd.transpose()?, law });
    }
    if rows.is_empty() {
        return Err(refusal(path, first, "has no rows: give at least one measured restitution".to_owned()));
    }
    Ok(rows)
}

fn law(contact: &Contact, speed: f64) -> Result<f64, crate::impact::ImpactError> {
    let solver = Solver { method: Method::Auto, ..Solver::default() };
    let row = contact.essentials_by(speed, &solver)?;
    Ok(row.restitution_with_waves().unwrap_or(row.restitution))
}

impl Experiment {
    /// Restitution by the law at a speed \[m/s\]; NaN if there is no result.
    pub fn law_at(&self, speed: f64) -> f64 {
        law(&self.contact, speed).unwrap_or(f64::NAN)
    }
}
