//! Checks of model and run. Each finding is a warning in the result; with `--strict` it is an error.

pub(in crate::impact) mod bodies;
pub mod limits;
mod of_balls;
mod restitution;
mod run;
mod waveguide;

use std::f64::consts::{FRAC_PI_4, PI};

use super::oblique::Approach;
use super::problem::contact::Contact;
use super::problem::forces::Damping;
use super::result::impact::Impact;
use super::result::warning::{Warning, WarningKind};
use super::solve::Solver;
use crate::contact::law::{ContactState, ExponentClamp, Surface, Unloading};
use crate::contact::strength::kind::IMPACT_STRAINS;
use crate::contact::strength::strain_rate_hardening::RateForm;
use crate::numerics::root::bisect;
use crate::units::{Dimension, format_four_digits, format_input, format_percent};
use bodies::{half_space_warnings, sphere_warnings};
use limits::{MAX_DUNDURS_BETA, MAX_INERTIA_SHARE, MAX_PLOUGHING_RATIO, MAX_WAVE_LOSS};
pub use restitution::Bias;
pub(crate) use restitution::dent_warning;
use restitution::restitution_warnings;
use run::{energy_gain_warning, run_warning};

/// The warnings for a peak outside of the range of the law or of its flow curve.
pub(crate) fn peak_warnings(ground: Surface, peak: &ContactState) -> impl Iterator<Item = Warning> + use<> {
    let x = peak.indentation;
    let law = ground.law;
    let stated = ground.loading_law_at(x).and_then(|law| law.exceeded_fit_range(peak)).map(|(from, to)| {
        let in_yields = |x: f64| format_four_digits(law.over_yield_indentation(x));
        let end = if to.is_finite() { format!("to {}", in_yields(to)) } else { "and more".to_owned() };
        let text = format!(
            "The result is an extrapolation. The maximum indentation is {} yield indentations of the law; the authors state the law for {} {end} yield indentations.",
            in_yields(x), in_yields(from)
        );
        Warning::new(WarningKind::OutsideStated, (x / to).max(from / x), text)
    });
    let hardening = law.hardening();
    let curve = hardening.and_then(|hardening| hardening.beyond_flow_curve(x)).map(|(strain, last)| {
        let text = format!(
            "e may be too low. The flow curve ends at a plastic strain of {last}, but the strain of the dent reaches {strain:.4}; beyond its last point the curve is constant. Add points at larger strains."
        );
        Warning::new(WarningKind::BeyondFlowCurve, strain, text)
    });
    stated.into_iter().chain(curve)
}

/// The warning for an exponent of unloading that is not the one that was asked for.
pub(crate) fn exponent_warning(ground: Surface, unloading: &Unloading) -> Option<Warning> {
    // an old branch had its warning in the impact that made it
    ground.loading_law_at(unloading.peak.indentation)?;
    let ExponentClamp { requested: asked, used, gain } = unloading.exponent_clamp()?;
    let text = format!(
        "e is 1 apart from gravity and drag, because the unloading exponent was raised from {asked} to {}. With {asked} the recovered energy would exceed the loading work by {}. Use a larger exponent.",
        format_four_digits(used),
        format_percent(gain),
        asked = format_four_digits(asked)
    );
    Some(Warning::new(WarningKind::RaisedExponent, gain, text))
}

impl Contact {
    /// The indentation \[m\] up to which the data behind the law reach: beyond it an impact is warned of a dent that is too
    /// wide, of a flow curve that ends before, or of a law outside its stated range. Infinite for a law without such a
    /// limit, as for springs.
    pub fn validated_indentation(&self) -> f64 {
        let radius = self.pair().smaller_radius;
        let Self { scales, law, .. } = self;
        let reaches = |x: f64| {
            let Some(peak) = law.force_and_memory(x, None).1 else { return true };
            let is_wide =
                scales.units.contact_radius * law.contact_radius(&peak) > law.validity.max_radius_ratio * radius;
            let is_before = law.exceeded_fit_range(&peak).is_some_and(|(from, _)| x < from);
            let is_harmless = |warning: Warning| is_before && warning.kind == WarningKind::OutsideStated;
            !is_wide && peak_warnings(law.into(), &peak).all(is_harmless)
        };
        let far = radius / scales.units.length;
        if reaches(far) { f64::INFINITY } else { bisect(0.0, far, reaches).0 * scales.units.length }
    }
}

/// All warnings of an impact.
pub(super) fn impact_warnings(
    contact: &Contact,
    impact: &Impact,
    ground: Surface,
    unloading: &Unloading,
    solver: &Solver,
) -> Vec<Warning> {
    let peak = &unloading.peak;
    let sphere = contact.sphere();
    let mut warnings = restitution_warnings(contact, impact.speed, impact.peak_mean_pressure, &impact.row);
    warnings.extend(peak_warnings(ground, peak));
    warnings.extend(exponent_warning(ground, unloading));
    let density = (!contact.has_attached_mass()).then_some(sphere.density);
    warnings.extend(sphere_warnings(sphere.radius, &sphere.material, sphere.yield_strength, density));
    warnings.extend(half_space_warnings(contact.half_space()));
    warnings.extend(of_balls::missing_strength_warning(contact, impact));
    warnings.extend(strain_rate_warnings(contact));
    warnings.extend(wave_warning(impact));
    warnings.extend(inertia_warning(contact, impact));
    warnings.extend(damping_warning(contact, impact));
    warnings.extend(energy_gain_warning(contact, impact, solver.method));
    warnings.extend(run_warning(impact, solver));
    warnings.sort_by_key(|warning| !warning.is_fatal());
    warnings
}

/// The warning for radiated waves that the first order does not hold for.
fn wave_warning(impact: &Impact) -> Option<Warning> {
    let (loss, recovered) = (impact.row.wave_loss_fraction?, impact.row.recovered_fraction());
    Warning::new_if(loss > MAX_WAVE_LOSS * recovered, WarningKind::StrongWaves, loss / recovered, || {
        format!(
            "restitution_with_waves is only a rough value. The wave loss ({} of the kinetic energy) is not small compared with the recovered energy ({}).",
            format_percent(loss),
            format_percent(recovered)
        )
    })
}

/// The warning for a dent so deep that the inertia of the half-space lowers the peak force: by the factor 1 + (1/π)(ρ_h/ρ_s)(a/R)³, which
/// is half of the excess in explicit finite elements at 80 m/s.
fn inertia_warning(contact: &Contact, impact: &Impact) -> Option<Warning> {
    let is_of_sphere = !contact.has_attached_mass() && contact.target_mass().is_none();
    let density = contact.half_space().density.filter(|_| is_of_sphere && impact.row.has_dent())?;
    let ratio = impact.row.radius_ratio;
    let share = density / contact.sphere().density * ratio * ratio * ratio / PI;
    Warning::new_if(share > MAX_INERTIA_SHARE, WarningKind::TargetInertia, share, || {
        format!(
            "peak_force is about {} too high, because the inertia of the half-space is not modelled. The contact radius is {ratio:.2} times the radius of the sphere. Divide peak_force by {:.3}.",
            format_percent(share),
            1.0 + share
        )
    })
}

/// The rates \[1/s\] for which the constants of metals were measured, or used in finite elements of impacts.
const MEASURED_RATES: [f64; 2] = [1e-3, 4e5];
/// Rates \[1/s\] of a test between those of a usual test and of an impact.
const DYNAMIC_TEST_RATES: [f64; 2] = [50.0, 1000.0];
/// Least D \[1/s\] of a flow stress.
const MIN_FLOW_STRESS_RATE: f64 = 1000.0;

/// The warnings for the strain rate of an impact, and for the constants of its metal.
fn strain_rate_warnings(contact: &Contact) -> impl Iterator<Item = Warning> + use<> {
    let rate = contact.strain_rate_result.and_then(|rated| rated.rate);
    let strain_rate = contact.strain_rate_result.map_or(f64::NAN, |rated| rated.strain_rate);
    let [low, high] = MEASURED_RATES;
    let outside = Warning::new_if(
        strain_rate < low || strain_rate > high,
        WarningKind::StrainRate,
        strain_rate,
        || {
            format!(
                "The strain-rate factor is an extrapolation. The strain rate is {} 1/s; constants are known for {low:e} to {high:e} 1/s.",
                format_four_digits(strain_rate)
            )
        },
    );
    let tested_at = rate.map_or(f64::NAN, |rate| rate.test_rate);
    let is_fast = (DYNAMIC_TEST_RATES[0]..=DYNAMIC_TEST_RATES[1]).contains(&tested_at);
    let fast = Warning::new_if(is_fast, WarningKind::DynamicTest, tested_at, || {
        format!(
            "e is lower than without strain-rate dependence. tested_at = {} 1/s is close to the strain rate of the impact, and the strain rate falls below tested_at near maximum compression. Give the strength of a quasi-static test.",
            format_four_digits(tested_at)
        )
    });
    let slow = match rate.map(|rate| rate.form) {
        Some(RateForm::CowperSymonds { rate, .. }) if rate < MIN_FLOW_STRESS_RATE => Some(rate),
        _ => None,
    };
    let lower_yield = slow.map(|rate| {
        let text = format!(
            "e is too high. cowper_symonds.rate = {} 1/s describes the lower yield point, not the flow stress at the plastic strains of an impact, {IMPACT_STRAINS}. Use constants for these strains (rate of {MIN_FLOW_STRESS_RATE} 1/s or more).",
            format_four_digits(rate)
        );
        Warning::new(WarningKind::LowerYield, -rate, text)
    });
    [outside, fast, lower_yield].into_iter().flatten()
}

/// χ v from which on the damping of Hunt and Crossley leaves less than a thousandth of the speed.
const STIFF_DAMPING: f64 = 1e3;

/// The warning of damping that leaves next to nothing, and whose fast decay makes steps tiny.
fn damping_warning(contact: &Contact, impact: &Impact) -> Option<Warning> {
    let Some(Damping::HuntCrossley(chi)) = contact.forces().damping else { return None };
    let size = chi * impact.speed;
    Warning::new_if(size > STIFF_DAMPING, WarningKind::StiffDamping, size, || {
        format!(
            "The sphere hardly rebounds. damping.hunt_crossley x speed = {}, so the rebound speed is at most 1/hunt_crossley = {}. Check the unit (s/m).",
            format_four_digits(size),
            format_input(1.0 / chi, Dimension::Speed)
        )
    })
}

/// The warnings of an oblique impact.
pub(super) fn oblique_warnings(
    contact: &Contact,
    impact: &Impact,
    approach: Approach,
) -> impl Iterator<Item = Warning> + use<> {
    let angle = approach.angle().abs();
    let ratio = impact.row.radius_ratio;
    let is_ploughing = impact.row.has_dent() && ratio > MAX_PLOUGHING_RATIO && angle > FRAC_PI_4;
    let ploughing = Warning::new_if(is_ploughing, WarningKind::Ploughing, ratio, || {
        format!(
            "Tangential speed and spin are estimates. At contact radius / sphere radius = {ratio:.3} and {:.0} deg from the normal the sphere ploughs; the ploughing force (about {:.0} % of the contact force) is not modelled.",
            angle.to_degrees(),
            100.0 * 4.0 / (3.0 * PI) * ratio
        )
    });
    let mismatch = contact.dundurs_beta();
    let slips_little = impact.row.rebound.is_some_and(|rebound| rebound.psi.abs() < 1.0);
    let is_coupled = mismatch.abs() > MAX_DUNDURS_BETA && slips_little;
    let coupled = Warning::new_if(is_coupled, WarningKind::DundursCoupling, mismatch.abs(), || {
        format!(
            "psi_2 has an error of up to 0.1. The bodies are dissimilar (Dundurs' beta = {mismatch:.2}), and the coupling of pressure and friction is neglected."
        )
    });
    [ploughing, coupled].into_iter().flatten()
}
