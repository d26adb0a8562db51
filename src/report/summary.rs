//! `summary.json`: every result, the resolved inputs and where they came from. SI throughout, the unit in every name.
//!
//! A half-space without a yield strength has no plastic key at all; one with it that stayed elastic has `null` for what
//! only a dent has.

use serde::Serialize;

use super::ReportError;
use super::inputs::Inputs;
use crate::impact::{Contact, Impact};

/// Where a result comes from: enough to repeat it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Provenance {
    /// Version of this program.
    pub version: String,
    /// The scenario as named on the command line.
    pub scenario_file: String,
    /// SHA-256 of its text, hexadecimal.
    pub scenario_sha256: String,
    /// The command line.
    pub command: String,
    /// The integration method, as a scenario spells it.
    pub method: String,
    /// Relative tolerance on the dimensionless state.
    pub tolerance: f64,
    /// Contact law.
    pub law: String,
    /// Where it was published; `None` for the PLM, whose coefficients say it, and for an elastic contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law_source: Option<String>,
    /// Name of its table of coefficients; `None` for a law without one.
    pub coefficients: Option<String>,
    /// What those coefficients were determined from.
    pub coefficients_source: Option<String>,
}

#[derive(Serialize)]
struct Summary<'a> {
    /// `null` for a sphere that had no speed to begin with.
    restitution: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wave_loss_fraction: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    restitution_with_waves: Option<f64>,
    rebound_speed_m_per_s: f64,
    /// `null` for a captured sphere.
    contact_time_s: Option<f64>,
    loading_time_s: f64,
    #[serde(rename = "peak_force_N")]
    peak_force: f64,
    peak_indentation_m: f64,
    peak_sphere_indentation_m: f64,
    peak_contact_radius_m: f64,
    #[serde(rename = "peak_mean_pressure_Pa")]
    peak_mean_pressure: f64,
    elastic_approach_m: f64,
    #[serde(flatten)]
    plastic: Option<Plastic>,
    #[serde(flatten)]
    under_forces: Option<Forced>,
    #[serde(skip_serializing_if = "Option::is_none")]
    verlet: Option<Verlet>,
    energy: Energy,
    accuracy: Accuracy,
    work: Work,
    warnings: Vec<String>,
    #[serde(rename = "effective_modulus_Pa")]
    effective_modulus: f64,
    sphere_compliance: f64,
    sphere_mass_kg: f64,
    unloading_exponent: f64,
    inputs: &'a Inputs,
    provenance: &'a Provenance,
}

/// What only a half-space that can yield has.
#[derive(Serialize)]
struct Plastic {
    residual_indentation_m: f64,
    unloading_radius_m: f64,
    residual_radius_m: Option<f64>,
    dent_radius_m: Option<f64>,
    yield_speed_m_per_s: Option<f64>,
    yield_indentation_m: Option<f64>,
    #[serde(rename = "yield_force_N")]
    yield_force: Option<f64>,
}

/// What only a scene with gravity or damping has.
#[derive(Serialize)]
struct Forced {
    outcome: &'static str,
    end_time_s: f64,
    end_indentation_m: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    static_indentation_m: Option<f64>,
}

/// What only a run in fixed steps has.
#[derive(Serialize)]
struct Verlet {
    step_s: f64,
    compression_time_s: f64,
    /// `null` for a captured sphere.
    separation_time_s: Option<f64>,
    energy_drift_at_end: f64,
}

#[derive(Serialize)]
struct Energy {
    #[serde(rename = "kinetic_in_J")]
    kinetic_in: f64,
    #[serde(rename = "recovered_J")]
    recovered: f64,
    #[serde(rename = "plastic_J", skip_serializing_if = "Option::is_none")]
    plastic: Option<f64>,
    #[serde(rename = "damping_J", skip_serializing_if = "Option::is_none")]
    damping: Option<f64>,
    #[serde(rename = "stored_at_separation_J", skip_serializing_if = "Option::is_none")]
    stored_at_separation: Option<f64>,
    #[serde(rename = "gravity_work_J", skip_serializing_if = "Option::is_none")]
    gravity_work: Option<f64>,
    drift: f64,
}

/// `null` where the scene has no closed form.
#[derive(Serialize)]
struct Accuracy {
    closed_form_restitution: Option<f64>,
    restitution_error: Option<f64>,
    contact_time_error: Option<f64>,
}

#[derive(Serialize)]
struct Work {
    steps: u64,
    rejected: u64,
    force_evaluations: u64,
}

/// JSON has no infinity.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// `summary.json`, with a newline at its end.
///
/// # Errors
/// [`ReportError::Json`], which numbers and text do not give.
pub fn summary(
    contact: &Contact,
    impact: &Impact,
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let pair = contact.pair();
    let plastic = pair.yield_point.map(|_| Plastic {
        residual_indentation_m: impact.residual_indentation,
        unloading_radius_m: impact.unloading_radius,
        residual_radius_m: impact.residual_radius,
        dent_radius_m: impact.dent_radius,
        yield_speed_m_per_s: contact.yield_speed(),
        yield_indentation_m: contact.yields_at().map(|(indentation, _)| indentation),
        yield_force: contact.yields_at().map(|(_, force)| force),
    });
    let (energy, accuracy, work) = (&impact.energy, &impact.accuracy, &impact.work);
    let summary = Summary {
        restitution: (impact.speed > 0.0).then_some(impact.restitution),
        wave_loss_fraction: impact.wave_loss_fraction,
        restitution_with_waves: impact.restitution_with_waves,
        rebound_speed_m_per_s: impact.rebound_speed,
        contact_time_s: finite(impact.contact_time),
        loading_time_s: impact.loading_time,
        peak_force: impact.peak_force,
        peak_indentation_m: impact.peak_indentation,
        peak_sphere_indentation_m: impact.peak_sphere_indentation,
        peak_contact_radius_m: impact.peak_contact_radius,
        peak_mean_pressure: impact.peak_mean_pressure,
        elastic_approach_m: impact.elastic_approach,
        plastic,
        under_forces: impact.under_forces.as_ref().map(|under| Forced {
            outcome: under.fate.name(),
            end_time_s: under.end_time,
            end_indentation_m: under.end_indentation,
            static_indentation_m: under.static_indentation,
        }),
        verlet: impact.in_fixed_steps.map(|seen| Verlet {
            step_s: seen.step,
            compression_time_s: seen.compression_time,
            separation_time_s: seen.separation_time,
            energy_drift_at_end: seen.drift_at_end,
        }),
        energy: Energy {
            kinetic_in: energy.kinetic_in,
            recovered: energy.recovered,
            plastic: energy.plastic,
            damping: impact.under_forces.and_then(|under| under.damping_loss),
            stored_at_separation: impact.under_forces.and_then(|under| under.stored_at_separation),
            gravity_work: impact.under_forces.and_then(|under| under.gravity_work),
            drift: energy.drift,
        },
        accuracy: Accuracy {
            closed_form_restitution: finite(accuracy.closed_form_restitution),
            restitution_error: finite(accuracy.restitution_error),
            contact_time_error: finite(accuracy.contact_time_error),
        },
        work: Work { steps: work.steps, rejected: work.rejected, force_evaluations: work.force_evaluations },
        warnings: impact.warnings.iter().map(ToString::to_string).collect(),
        effective_modulus: pair.effective_modulus,
        sphere_compliance: pair.sphere_compliance,
        sphere_mass_kg: contact.mass(),
        unloading_exponent: impact.unloading_exponent,
        inputs,
        provenance,
    };
    let mut text = serde_json::to_string_pretty(&summary)?;
    text.push('\n');
    Ok(text)
}
