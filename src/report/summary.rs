//! `summary.json`: results, inputs and provenance, in SI, with the unit in every name.

use serde::Serialize;

use super::inputs::Inputs;
use crate::error::Error;
use crate::impact::{Contact, Impact};
use crate::provenance::Provenance;
use crate::repeat::Drive;
use crate::scene::results::impact::Single;
use crate::scene::results::series::Series;
use crate::scene::results::{Fields, fields, impact, series};

/// Results, inputs and provenance.
#[derive(Serialize)]
struct Summary<'a, R> {
    #[serde(flatten)]
    results: R,
    inputs: &'a Inputs,
    /// Inputs that are lists.
    #[serde(flatten)]
    lists: Fields,
    provenance: &'a Provenance,
}

/// A summary as text, with a newline at its end.
fn pretty(summary: &impl Serialize) -> Result<String, Error> {
    Ok(serde_json::to_string_pretty(summary)? + "\n")
}

/// The summary of these results.
pub fn of(results: impl Serialize, inputs: &Inputs, provenance: &Provenance) -> Result<String, Error> {
    pretty(&Summary { results, inputs, lists: Fields(Vec::new()), provenance })
}

/// The summary of one impact.
pub fn summary(contact: &Contact, impact: &Impact, inputs: &Inputs, provenance: &Provenance) -> Result<String, Error> {
    of(fields(&impact::results(), &Single { contact, impact }), inputs, provenance)
}

/// A summary lists the speeds of at most so many shots; a longer list stands in `impacts.csv` only.
const LISTED: usize = 1000;

/// The summary of a series of impacts.
pub fn of_series(of: &Series, inputs: &Inputs, provenance: &Provenance) -> Result<String, Error> {
    let lists = match &of.repeat.drive {
        Drive::Shots(speeds) if speeds.len() <= LISTED => vec![("shot_speeds_m_per_s", speeds.clone().into())],
        _ => Vec::new(),
    };
    pretty(&Summary { results: fields(&series::results(), of), inputs, lists: Fields(lists), provenance })
}
