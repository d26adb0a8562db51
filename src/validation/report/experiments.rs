//! The report of the user's measurements.

use std::fmt::Write as _;

use super::{share, signed};
use crate::units::aligned::{aligned, markdown};
use crate::validation::check::{largest, mean, rms};
use crate::validation::experiments::{Experiment, Measured};

const SUMMARY: [&str; 7] = ["measurements", "points", "bias", "rms", "largest", "within 2 sd", "source"];

/// The text of `experiments.csv`: every measured restitution, and the restitution by the law.
pub fn csv(experiments: &[Experiment]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["file", "line", "speed_m_per_s", "restitution", "restitution_sd", "law", "deviation"])?;
    for experiment in experiments {
        for row in &experiment.rows {
            let Measured { line, speed, restitution, sd, law } = row;
            writer.serialize((&experiment.name, line, speed, restitution, sd, law, row.deviation()))?;
        }
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

/// The names of the columns, and a row for each file with bias and rms of law over measurement − 1.
fn summary(experiments: &[Experiment]) -> Vec<[String; 7]> {
    let of_file = |experiment: &Experiment| {
        let deviations: Vec<f64> = experiment.rows.iter().map(Measured::deviation).collect();
        let off = experiment.rows.iter().filter_map(|row| Some((row.law - row.restitution).abs() <= 2.0 * row.sd?));
        let within: Vec<bool> = off.collect();
        let inside = within.iter().filter(|is_inside| **is_inside).count();
        [
            experiment.name.clone(),
            deviations.len().to_string(),
            signed(mean(&deviations)),
            share(rms(&deviations)),
            signed(largest(deviations.iter().copied())),
            if within.is_empty() { String::new() } else { format!("{inside} of {}", within.len()) },
            experiment.source.clone(),
        ]
    };
    std::iter::once(SUMMARY.map(str::to_owned)).chain(experiments.iter().map(of_file)).collect()
}

/// The summary for the terminal.
pub fn table(experiments: &[Experiment]) -> String {
    aligned(&summary(experiments), |column| column == 0 || column == 6)
}

/// The summary and the pictures for the page.
pub fn section(experiments: &[Experiment]) -> String {
    let about = "Law over measured restitution − 1; rows in `experiments.csv`.";
    let table = markdown(&summary(experiments));
    let mut text = format!("\n## Measurements of your own\n\n{about}\n\n{table}");
    for Experiment { name, .. } in experiments {
        let _ = write!(text, "\n![Restitution, {name}](<experiment-{name}.png>)\n");
    }
    text
}
