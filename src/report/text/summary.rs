//! `summary.json`: results, inputs and provenance, in SI, with the unit in every name.

use serde_json::{Map, Value};

use super::inputs::Inputs;
use crate::error::Error;
use crate::files::provenance::Provenance;
use crate::scenario::scene::results::impact::Single;
use crate::scenario::scene::results::{fields, impact};

/// The summary of these results, with a newline at its end.
pub fn of(mut results: Map<String, Value>, inputs: &Inputs, provenance: &Provenance) -> Result<String, Error> {
    results.insert("inputs".to_owned(), serde_json::to_value(inputs)?);
    results.insert("provenance".to_owned(), serde_json::to_value(provenance)?);
    Ok(serde_json::to_string_pretty(&results)? + "\n")
}

/// The summary of one impact.
pub fn summary(single: &Single, inputs: &Inputs, provenance: &Provenance) -> Result<String, Error> {
    of(fields(&impact::results(), single), inputs, provenance)
}
