//! `summary.json` of repeated impacts: how they ended, what they left, inputs and provenance.

use serde::Serialize;

use super::ReportError;
use super::inputs::Inputs;
use super::repeat::end_text;
use super::summary::Provenance;
use crate::impact::Contact;
use crate::math::power::max_or_nan;
use crate::repeat::{Drive, Repeat, Sequence};

#[derive(Serialize)]
struct Summary<'a> {
    impacts: usize,
    spot: &'static str,
    ended_by: &'static str,
    end: String,
    final_restitution: f64,
    final_rebound_speed_m_per_s: f64,
    #[serde(rename = "largest_peak_force_N")]
    largest_peak_force: f64,
    largest_peak_indentation_m: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    deepest_residual_indentation_m: Option<f64>,
    #[serde(flatten)]
    bouncing: Option<Bouncing>,
    energy: Energy,
    traced_impacts: usize,
    warnings: &'a [String],
    #[serde(rename = "effective_modulus_Pa")]
    effective_modulus: f64,
    sphere_compliance: f64,
    sphere_mass_kg: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    yield_speed_m_per_s: Option<f64>,
    inputs: &'a Inputs,
    #[serde(skip_serializing_if = "Option::is_none")]
    shot_speeds_m_per_s: Option<&'a [f64]>,
    provenance: &'a Provenance,
}

#[derive(Serialize)]
struct Bouncing {
    gravity_m_per_s2: f64,
    drop_height_m: Option<f64>,
    most_impacts: u64,
    until_speed_m_per_s: Option<f64>,
    last_separation_time_s: Option<f64>,
    /// `null`: infinite (e of 1 or more), or nothing bounces.
    remaining_time_s: Option<f64>,
    remaining_time: &'static str,
    highest_rebound_m: Option<f64>,
    /// Only of a captured sphere.
    #[serde(skip_serializing_if = "Option::is_none")]
    static_indentation_m: Option<f64>,
}

#[derive(Serialize)]
struct Energy {
    #[serde(rename = "first_kinetic_in_J")]
    first: f64,
    #[serde(rename = "last_recovered_J")]
    last: f64,
    #[serde(rename = "plastic_J", skip_serializing_if = "Option::is_none")]
    plastic: Option<f64>,
    drift: f64,
}

/// Shots that a summary lists; a longer list is in `impacts.csv`.
const LISTED: usize = 1000;

/// `summary.json`, with a newline at its end.
///
/// # Errors
/// [`ReportError::Json`], which numbers and text do not give.
pub fn summary(
    contact: &Contact,
    repeat: &Repeat,
    sequence: &Sequence,
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let hits = &sequence.hits;
    let (first, last) = (hits.first(), hits.last());
    let largest = |value: fn(&crate::repeat::Hit) -> f64| hits.iter().map(value).fold(0.0, max_or_nan);
    let can_yield = contact.pair().yield_point.is_some();
    let bouncing = match repeat.drive {
        Drive::Bouncing { gravity, drop_height, most, until, .. } => Some(Bouncing {
            gravity_m_per_s2: gravity,
            drop_height_m: drop_height,
            most_impacts: most,
            until_speed_m_per_s: until,
            last_separation_time_s: last.and_then(crate::repeat::Hit::separation_time),
            remaining_time_s: sequence.remaining_time,
            remaining_time: "2 v/(g (1 - e)) from the last separation, with the last rebound speed v and restitution e held \
                             for all bounces to come and contact times left out (a lower bound where e rises as the speed \
                             falls); null if e is 1 or more, or the sphere stays in its dent",
            highest_rebound_m: hits.iter().filter_map(|hit| hit.flight).map(|flight| flight.top()).reduce(max_or_nan),
            static_indentation_m: last.and_then(|hit| hit.static_indentation),
        }),
        Drive::Shots(_) => None,
    };
    let summary = Summary {
        impacts: hits.len(),
        spot: repeat.place.name(),
        ended_by: sequence.end.name(),
        end: end_text(repeat, sequence),
        final_restitution: last.map_or(0.0, |hit| hit.restitution),
        final_rebound_speed_m_per_s: last.map_or(0.0, |hit| hit.rebound_speed),
        largest_peak_force: largest(|hit| hit.peak_force),
        largest_peak_indentation_m: largest(|hit| hit.peak_indentation),
        deepest_residual_indentation_m: can_yield.then(|| sequence.deepest_dent()),
        bouncing,
        energy: Energy {
            first: first.map_or(0.0, |hit| hit.kinetic_in),
            last: last.map_or(0.0, |hit| hit.recovered),
            plastic: can_yield.then(|| hits.iter().filter_map(|hit| hit.plastic).sum()),
            drift: sequence.drift(),
        },
        traced_impacts: sequence.traced.len(),
        warnings,
        effective_modulus: contact.pair().effective_modulus,
        sphere_compliance: contact.pair().sphere_compliance,
        sphere_mass_kg: contact.mass(),
        yield_speed_m_per_s: contact.yield_speed(),
        inputs,
        shot_speeds_m_per_s: match &repeat.drive {
            Drive::Shots(speeds) if speeds.len() <= LISTED => Some(speeds),
            _ => None,
        },
        provenance,
    };
    let mut text = serde_json::to_string_pretty(&summary)?;
    text.push('\n');
    Ok(text)
}
