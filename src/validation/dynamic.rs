//! Checks of whole impacts against explicit finite elements: restitution, contact time, peak force, dent depth.

use std::sync::Arc;

use super::check::{Check, Tolerance};
use super::{EXPONENTS, ValidationError};
use crate::impact::Impact;
use crate::law::{LawChoice, Plm, PlmCoefficients};
use crate::reference::impacts::{self, ImpactRow, Sample};
use crate::reference::{DYNAMIC, ReferenceError};
use crate::scenario::Scenario;

/// With each of [`EXPONENTS`].
const RESTITUTION: [Tolerance; 2] = [
    Tolerance { limit: 0.030, source: "documented 2.8 %, margin 0.2 %" },
    Tolerance { limit: 0.023, source: "documented 2.1 %, margin 0.2 %" },
];
const TIME: Tolerance = Tolerance { limit: 0.016, source: "documented 1.4 %, margin 0.2 %" };
const DENT: Tolerance = Tolerance { limit: 0.022, source: "documented 2 %, margin 0.2 %" };
const FORCE: Tolerance = Tolerance { limit: 0.036, source: "loading force, documented 3.5 %, margin 0.1 %" };
const WITH_WAVES: Tolerance = Tolerance { limit: 0.010, source: "documented 0.8 %, margin 0.2 %" };
const RADIATED: Tolerance = Tolerance {
    limit: 0.085,
    source: "documented 0 to 7 % below the reference, which has two or three digits (1.2 %)",
};

/// Number of samples in the traces that pictures are drawn from.
const SAMPLES: usize = 300;

const SCENARIOS: [(&str, &str); 3] = [
    ("D1", include_str!("../../scenarios/dynamic-fe-d1.toml")),
    ("D2", include_str!("../../scenarios/dynamic-fe-d2.toml")),
    ("D5", include_str!("../../scenarios/dynamic-fe-d5.toml")),
];

/// One impact, by finite elements and by the law.
#[derive(Debug, Clone)]
pub struct Case {
    /// The name, such as "D1".
    pub name: &'static str,
    pub reference: ImpactRow,
    /// Samples of the finite elements, in the order of time.
    pub samples: Vec<Sample>,
    /// The impact by the law with each of [`EXPONENTS`], with a trace.
    pub impacts: Vec<Impact>,
}

/// The three impacts.
///
/// # Errors
/// [`ValidationError`] if a reference is damaged or an impact has no result.
pub fn cases(coefficients: &PlmCoefficients) -> Result<Vec<Case>, ValidationError> {
    let (references, samples) = (impacts::impacts()?, impacts::samples()?);
    let coefficients = Arc::new(coefficients.clone());
    SCENARIOS
        .iter()
        .map(|&(name, text)| {
            let reference = references.iter().find(|row| row.case == name).cloned();
            let reference = reference
                .ok_or_else(|| ReferenceError { table: impacts::TABLE, problem: format!("has no row {name}") })?;
            let scene = Scenario::from_text(name, text, &[]).and_then(|scenario| scenario.resolve());
            let mut scene = scene.map_err(ValidationError::Scenario)?;
            let impacts = EXPONENTS.map(|(exponent, _)| {
                scene.law = LawChoice::Plm(Plm { coefficients: Arc::clone(&coefficients), exponent, flow: None });
                scene.contact()?.impact(scene.speed, &scene.solver, Some(SAMPLES)).map_err(ValidationError::from)
            });
            let samples = samples.iter().filter(|sample| sample.case == name).cloned().collect();
            Ok(Case { name, reference, samples, impacts: impacts.into_iter().collect::<Result<_, _>>()? })
        })
        .collect()
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let mut checks = Vec::new();
    for case in cases(coefficients)? {
        let fe = &case.reference;
        let mut row = |quantity: &str, unit, numbers, tolerance| {
            checks.push(Check::numbers(
                &format!("impact: {quantity}"),
                case.name.to_owned(),
                DYNAMIC,
                unit,
                numbers,
                tolerance,
            ));
        };
        for ((impact, (_, name)), tolerance) in case.impacts.iter().zip(EXPONENTS).zip(RESTITUTION) {
            row(&format!("restitution, {name}"), "", [fe.restitution, impact.restitution], tolerance);
            row(&format!("contact time, {name}"), "s", [fe.contact_time, impact.contact_time], TIME);
        }
        // loading is the same with both exponents
        if let Some(impact) = case.impacts.first() {
            row("peak force", "N", [fe.peak_force, impact.peak_force], FORCE);
            row("residual indentation", "m", [fe.residual_indentation, impact.residual_indentation], DENT);
        }
        let Some(shape) = case.impacts.last() else { continue };
        if let (Some(restitution), Some(loss)) = (shape.restitution_with_waves(), shape.wave_loss_fraction) {
            row("restitution, pressure-shape with waves", "", [fe.restitution, restitution], WITH_WAVES);
            row("energy radiated as waves", "", [fe.radiated_share, loss], RADIATED);
        }
    }
    checks.sort_by(|a, b| a.quantity.cmp(&b.quantity));
    Ok(checks)
}
