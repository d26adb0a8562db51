//! Models of friction beside the measured tangential speeds of two balls: this program, one spring, a rigid body, and three constants.

use super::impacts::{MeasuredImpact, RELATIVE_SPEED, impacts_of, relative_tangential_speed, sets_of_two_balls};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::impact::ImpactError;
use crate::reference::measured::measured_sets;
use crate::validate::comparison::rms;
use crate::validate::oblique::single_spring_ratio;

/// The deviations \[m/s\] of the tangential speed by a model, as root mean squares.
pub(super) struct ModelDeviations {
    pub(super) name: &'static str,
    pub(super) all: f64,
    /// Over the rebounds with partial slip by the program.
    pub(super) partial_slip: f64,
}

/// The constants of a rigid body that slides or sticks: restitution, tangential restitution of sticking contacts.
const CONSTANTS: [(&str, [f64; 2]); 2] = [
    ("rigid body, e = 1, same μ", [1.0, 0.0]),
    ("three constants fitted to these impacts: e 0.97, β₀ 0.44, μ 0.092", [0.97, 0.44]),
];

/// Tangential speed after of two equal solid balls without spin before, with friction μ:
///
/// ```text
/// v_t' = v_t − min(μ (1 + e) v_n, (1 + β_0) v_t/j)
/// ```
fn rigid_speed(impact: &MeasuredImpact, [restitution, sticking]: [f64; 2]) -> f64 {
    let MeasuredImpact { approach, contact, .. } = impact;
    let sliding = approach.friction.unwrap_or(0.0) * (1.0 + restitution) * approach.normal;
    approach.tangential.speed - sliding.min((1.0 + sticking) * approach.tangential.speed / contact.slip_factor())
}

/// Tangential speed after with one tangential spring, as in codes for granular media: v_t' = v_t (1 + (s_1/s_0 − 1)/j).
fn spring_speed(impact: &MeasuredImpact) -> Result<f64, Error> {
    let MeasuredImpact { approach, contact, by_law, .. } = impact;
    let psi = by_law.rebound.map_or(f64::NAN, |after| after.psi);
    let ratio = single_spring_ratio(psi, contact.chi()).map_err(ImpactError::from)?;
    Ok(approach.tangential.speed * (1.0 + (ratio - 1.0) / contact.slip_factor()))
}

/// The models, and the number of rebounds with partial slip.
pub(super) fn friction_models(impacts: &[MeasuredImpact]) -> Result<(Vec<ModelDeviations>, usize), Error> {
    let slips_partly = |impact: &MeasuredImpact| impact.by_law.rebound.is_some_and(|after| !after.is_sliding);
    let of_model = |name, speeds: Vec<f64>| {
        let deviation =
            |(impact, speed): (&MeasuredImpact, f64)| (slips_partly(impact), speed - impact.row.number(RELATIVE_SPEED));
        let off: Vec<(bool, f64)> = impacts.iter().zip(speeds).map(deviation).collect();
        let partial: Vec<f64> = off.iter().filter(|(is_partial, _)| *is_partial).map(|(_, off)| *off).collect();
        let all = rms(&off.iter().map(|(_, off)| *off).collect::<Vec<_>>());
        ModelDeviations { name, all, partial_slip: rms(&partial) }
    };
    let program = impacts.iter().map(|impact| relative_tangential_speed(&impact.by_law).unwrap_or(f64::NAN)).collect();
    let spring = impacts.iter().map(spring_speed).collect::<Result<_, Error>>()?;
    let mut models = vec![
        of_model("Mindlin's contact, this program", program),
        of_model("one spring: LAMMPS `mindlin_rescale/force`", spring),
    ];
    let of_constants =
        |(name, constants)| of_model(name, impacts.iter().map(|impact| rigid_speed(impact, constants)).collect());
    models.extend(CONSTANTS.map(of_constants));
    Ok((models, impacts.iter().filter(|impact| slips_partly(impact)).count()))
}

/// The measured collisions of two glass balls in a dimensionless form, and the deviations of models.
pub(in crate::validate) struct GlassBalls {
    /// ψ_2 over ψ_1.
    pub(in crate::validate) slips: Vec<(f64, f64)>,
    /// Root mean squares \[m/s\] of the tangential speed, by this program, one spring, a rigid body, and by three fitted constants.
    pub(in crate::validate) deviations: Vec<f64>,
}

pub(in crate::validate) fn glass_balls(coefficients: &PlmCoefficients) -> Result<GlassBalls, Error> {
    let sets = measured_sets()?;
    let mut found = GlassBalls { slips: Vec::new(), deviations: Vec::new() };
    for set in sets_of_two_balls(&sets) {
        let impacts = impacts_of(set, coefficients)?;
        for impact in &impacts {
            let Some(after) = impact.by_law.rebound else { continue };
            let change = impact.row.number(RELATIVE_SPEED) / impact.approach.tangential.speed - 1.0;
            found.slips.push((after.psi, after.psi * (1.0 + change * impact.contact.slip_factor())));
        }
        found.deviations = friction_models(&impacts)?.0.iter().map(|model| model.all).collect();
    }
    Ok(found)
}
