//! Measurements of the user beside the law: every CSV file of a directory. They are a calibration in which nothing is
//! to be found; comment lines give the scenario.
//!
//! ```text
//! # sphere.radius = 1.5 mm                   (keys of [sphere], [half_space], [law], [gravity], [damping])
//! # half_space.hardness = 300 HV
//! # law = thornton                           (the law by its name, in place of a key such as law.plm.unloading_exponent)
//! # source = who measured it, and where it is published
//! speed_m_per_s,restitution,restitution_sd
//! 2.0,0.533,0.012
//! ```
//!
//! The columns are those of [`crate::calibrate::data`]; other comment lines are free. A standard deviation may be left
//! out. With `half_space.density` the law includes the loss by elastic waves. Keys have the same defaults as in a scenario.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::check::{largest, mean, rms};
use super::report::{share, signed};
use crate::calibrate::Measurements;
use crate::calibrate::data::Data;
use crate::error::Error;
use crate::law::{LawChoice, PlmCoefficients};
use crate::scenario::{LARGEST_DATA, Scenario, every_key, read_text};
use crate::scene::measured::Measured;
use crate::scene::words::LAWS;
use crate::units::aligned::{aligned, markdown};
use crate::units::csv_text::{keys_in_comments, refused};
use crate::units::nearest::did_you_mean;

/// A file of measurements, with the predictions of the law.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// The name of the file without its ending.
    pub name: String,
    /// Who measured; empty if the file does not say so.
    pub source: String,
    pub rows: Vec<Row>,
}

/// One measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Line of the file, counted from 1.
    pub line: u64,
    /// Impact speed \[m/s\]; NaN for an indentation curve.
    pub speed: f64,
    pub what: Measured,
    /// The measured value, SI.
    pub measured: f64,
    /// Its standard deviation.
    pub sd: Option<f64>,
    /// The same by the law, with the loss by waves if the half-space has a density.
    pub law: f64,
}

impl Row {
    /// Relative deviation: law over measurement − 1.
    pub fn deviation(&self) -> f64 {
        self.law / self.measured - 1.0
    }
}

/// The tables of a scenario whose keys a comment line may give.
const TABLES: [&str; 5] = ["sphere.", "half_space.", "law.", "gravity.", "damping."];

/// All experiments of a directory, in the order of their names. `coefficients` are used for the PLM if a file names no
/// others.
///
/// # Errors
/// [`Error`] with the file, the line, what is wrong and what is needed.
pub fn load(directory: &Path, coefficients: &PlmCoefficients) -> Result<Vec<Experiment>, Error> {
    let refuse = |message: String| refused(&directory.display().to_string())((None, message));
    let entries = fs::read_dir(directory).and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect());
    let mut paths: Vec<PathBuf> = entries.map_err(|error| refuse(format!("cannot be read: {error}")))?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
    paths.sort();
    if paths.is_empty() {
        let columns = "columns such as speed_m_per_s, restitution, restitution_sd";
        return Err(refuse(format!("has no file of measurements: a CSV file with {columns}")));
    }
    paths.iter().map(|path| experiment(path, coefficients)).collect()
}

fn experiment(path: &Path, coefficients: &PlmCoefficients) -> Result<Experiment, Error> {
    let (text, name) = (read_text(path, LARGEST_DATA)?, path.display().to_string());
    let refused = refused(&name);
    let of_tables = every_key().map(|key| key.path).filter(|key| TABLES.iter().any(|table| key.starts_with(table)));
    let known: Vec<&str> = of_tables.chain(["law", "source"]).collect();
    let given = keys_in_comments(&text, &known).map_err(refused)?;
    // a scenario in which every key has the line number that it has in the file
    let mut lines = vec![String::new(); text.lines().count()];
    let (mut settings, mut source) =
        (vec![format!("calibrate.data={}", toml::Value::from(name.as_str()))], String::new());
    for (line, key, value) in given {
        match key {
            "source" => value.clone_into(&mut source),
            "law" if LawChoice::from_name(value).is_none() => {
                let laws = (LAWS.known)();
                let hint =
                    did_you_mean(value, laws.iter().map(String::as_str), '`', &format!("laws are {}", laws.join(", ")));
                return Err(refused((Some(line as u64), format!("unknown law `{value}`{hint}"))));
            }
            "law" => settings.push(format!("law={}", toml::Value::from(value))),
            key => {
                let plain = format!(" {key} = {value}");
                let is_toml = toml::from_str::<toml::Table>(&plain).is_ok();
                lines[line - 1] = if is_toml { plain } else { format!(" {key} = {}", toml::Value::from(value)) };
            }
        }
    }
    let directory = path.parent().unwrap_or(Path::new("")).to_owned();
    let scenario = Scenario::in_directory(&name, &lines.join("\n"), &settings, directory)?.with_data(text.clone());
    let mut wanted = scenario.compared()?;
    if let LawChoice::Plm(plm) = &mut wanted.scene.law
        && !scenario.document.has("law.plm.coefficients")
    {
        plm.coefficients = Arc::new(coefficients.clone());
    }
    let measured = Measurements::with(&scenario, wanted, Data::parse(&name, &text)?, None)?;
    let (predicted, speeds) = measured.predicted()?;
    let rows = measured.data.values.iter().zip(predicted).map(|(value, law)| Row {
        line: measured.data.rows[value.row].line,
        speed: speeds[value.row],
        what: value.what,
        measured: value.value,
        sd: value.deviation,
        law,
    });
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(Experiment { name: stem, source, rows: rows.collect() })
}

impl Experiment {
    /// The rows of every quantity that was measured.
    pub fn quantities(&self) -> impl Iterator<Item = (Measured, Vec<&Row>)> {
        let of = |what: Measured| (what, self.rows.iter().filter(|row| row.what == what).collect::<Vec<_>>());
        Measured::ALL.into_iter().map(of).filter(|(_, rows)| !rows.is_empty())
    }

    /// The name of a picture.
    pub fn picture(&self, what: Measured) -> String {
        format!("experiment-{}-{}", self.name, what.name())
    }
}

/// The text of `experiments.csv`: every measured value, and the value by the law.
pub fn csv(experiments: &[Experiment]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["file", "line", "quantity", "speed_m_per_s", "measured", "sd", "law", "deviation"])?;
    for Experiment { name, rows, .. } in experiments {
        for row in rows {
            let Row { line, what, measured, sd, law, .. } = row;
            let speed = row.speed.is_finite().then_some(row.speed);
            writer.serialize((name, line, what.name(), speed, measured, sd, law, row.deviation()))?;
        }
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

const SUMMARY: [&str; 8] = ["measurements", "quantity", "points", "bias", "rms", "largest", "within 2 sd", "source"];

/// The names of the columns, and a row for each quantity of a file with bias and rms of law over measurement − 1.
fn summary(experiments: &[Experiment]) -> Vec<[String; 8]> {
    let of_quantity = |of: &Experiment, what: Measured, rows: &[&Row]| {
        let deviations: Vec<f64> = rows.iter().map(|row| row.deviation()).collect();
        let within = rows.iter().filter_map(|row| Some((row.law - row.measured).abs() <= 2.0 * row.sd?));
        let within: Vec<bool> = within.collect();
        let inside = within.iter().filter(|is_inside| **is_inside).count();
        [
            of.name.clone(),
            what.name().to_owned(),
            deviations.len().to_string(),
            signed(mean(&deviations)),
            share(rms(&deviations)),
            signed(largest(deviations.iter().copied())),
            if within.is_empty() { String::new() } else { format!("{inside} of {}", within.len()) },
            of.source.clone(),
        ]
    };
    let rows = experiments.iter().flat_map(|of| of.quantities().map(move |(what, rows)| of_quantity(of, what, &rows)));
    std::iter::once(SUMMARY.map(str::to_owned)).chain(rows).collect()
}

/// The summary for the terminal.
pub fn table(experiments: &[Experiment]) -> String {
    aligned(&summary(experiments), |column| matches!(column, 0 | 1 | 7))
}

/// The summary and the pictures for the page.
pub fn section(experiments: &[Experiment]) -> String {
    let table = markdown(&summary(experiments));
    let mut text =
        format!("\n## Measurements of your own\n\nLaw over measurement − 1; rows in `experiments.csv`.\n\n{table}");
    for of in experiments {
        for (what, _) in of.quantities() {
            let _ = writeln!(text, "\n![{}, {}](<{}.png>)", what.name(), of.name, of.picture(what));
        }
    }
    text
}
