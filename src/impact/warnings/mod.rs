//! Checks of model and run. Each finding is a warning in the result; with `--strict` it is an error.

pub(in crate::impact) mod bodies;
mod of_balls;
mod restitution;
mod run;

use std::f64::consts::{FRAC_PI_4, PI};

use super::oblique::{Approach, Incidence};
use super::problem::contact::Contact;
use super::problem::forces::Damping;
use super::result::impact::Impact;
use super::result::warning::{Warning, WarningKind};
use super::solve::{Method, Solver};
use crate::contact::law::{ContactState, ExponentClamp, Surface, Unloading};
use crate::contact::strength::strain_rate_hardening::RateForm;
use crate::numerics::root::bisect;
use crate::units::{Dimension, format_four_digits, format_input, format_percent};
use bodies::{half_space_warnings, sphere_warnings};
pub use restitution::Bias;
pub(crate) use restitution::dent_warning;
use restitution::restitution_warnings;
use run::{energy_gain_warning, rebound_warning, run_warning};

/// The warnings for a peak outside of the range of the law or of its flow curve.
pub(crate) fn peak_warnings(ground: Surface, peak: &ContactState) -> impl Iterator<Item = Warning> + use<> {
    let x = peak.indentation;
    let law = ground.law;
    let stated = ground.loading_law_at(x).and_then(|law| law.exceeded_fit_range(peak)).map(|(from, to)| {
        let in_yields = |x: f64| format_four_digits(law.over_yield_indentation(x));
        let end = if to.is_finite() { format!("to {}", in_yields(to)) } else { "and more".to_owned() };
        let text = format!(
            "peak indentation = {} x the yield indentation of the law is outside {} {end}, the range that the law is stated for: take the result for an extrapolation",
            in_yields(x), in_yields(from)
        );
        Warning::new(WarningKind::OutsideStated, (x / to).max(from / x), text)
    });
    let hardening = law.hardening();
    let curve = hardening.and_then(|hardening| hardening.beyond_flow_curve(x)).map(|(strain, last)| {
        let text = format!(
            "the flow curve ends at a plastic strain of {last}, and this dent strains the metal up to {strain:.4}: beyond its last point the curve is taken to stay level; give points at larger strains, or let the dent be shallower"
        );
        Warning::new(WarningKind::BeyondFlowCurve, strain, text)
    });
    stated.into_iter().chain(curve)
}

/// The warning for an exponent of unloading that is not the one that was asked for.
pub(crate) fn exponent_warning(ground: Surface, unloading: &Unloading) -> Option<Warning> {
    let ExponentClamp { requested: asked, used, gain } =
        ground.loading_law_at(unloading.peak.indentation)?.exponent_clamp(unloading)?;
    let text = format!(
        "an unloading exponent of {} would give back {} of the energy more than was spent: {} is used in its place, with which e is 1 but for gravity and drag; give a larger exponent, or let the peak be further above first yield",
        format_four_digits(asked),
        format_percent(gain),
        format_four_digits(used)
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
            let is_wide = scales.contact_radius * law.contact_radius(&peak) > law.validity.max_radius_ratio * radius;
            let is_before = law.exceeded_fit_range(&peak).is_some_and(|(from, _)| x < from);
            let is_harmless = |warning: Warning| is_before && warning.kind == WarningKind::OutsideStated;
            !is_wide && peak_warnings(law.into(), &peak).all(is_harmless)
        };
        let far = radius / scales.length;
        if reaches(far) { f64::INFINITY } else { bisect(0.0, far, reaches).0 * scales.length }
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
    let mut warnings = restitution_warnings(contact, impact.speed, impact.peak_mean_pressure, impact);
    warnings.extend(peak_warnings(ground, peak));
    warnings.extend(exponent_warning(ground, unloading));
    let density = (!contact.has_attached_mass()).then_some(sphere.density);
    warnings.extend(sphere_warnings(sphere.radius, &sphere.material, sphere.yield_strength, density));
    warnings.extend(half_space_warnings(contact.half_space()));
    warnings.extend(of_balls::missing_strength_warning(contact, impact));
    warnings.extend(strain_rate_warnings(contact));
    warnings.extend(wave_warning(impact));
    warnings.extend(damping_warning(contact, impact));
    let is_verlet = solver.method == Method::Verlet;
    warnings.extend(if is_verlet { energy_gain_warning(contact, impact) } else { rebound_warning(contact, impact) });
    warnings.extend(run_warning(impact, solver));
    warnings.sort_by_key(|warning| !warning.is_fatal());
    warnings
}

/// The warning for radiated waves that the first order does not hold for.
fn wave_warning(impact: &Impact) -> Option<Warning> {
    let (loss, recovered) = (impact.wave_loss_fraction?, impact.recovered_fraction());
    Warning::new_if(loss > 0.2 * recovered, WarningKind::StrongWaves, loss / recovered, || {
        format!(
            "elastic waves take {loss:.3} of the kinetic energy, while the law gives {recovered:.3} of it back: too much for a first-order estimate; take restitution_with_waves as a rough value (0 where nothing is left)"
        )
    })
}

/// The rates \[1/s\] for which the constants of metals were measured.
const MEASURED_RATES: [f64; 2] = [1e-3, 1e5];
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
                "strain rate {} 1/s is outside of {low:e} to {high:e} 1/s, for which such constants are known: take the factor of the strength for an extrapolation",
                format_four_digits(strain_rate)
            )
        },
    );
    let tested_at = rate.map_or(f64::NAN, |rate| rate.test_rate);
    let is_fast = (DYNAMIC_TEST_RATES[0]..=DYNAMIC_TEST_RATES[1]).contains(&tested_at);
    let fast = Warning::new_if(is_fast, WarningKind::DynamicTest, tested_at, || {
        format!(
            "tested_at = {} 1/s is nearly as fast as the impact, and only the turn of the sphere is slower than that test: e comes out below the one without a rate; give the strength of a slow test",
            format_four_digits(tested_at)
        )
    });
    let slow = match rate.map(|rate| rate.form) {
        Some(RateForm::CowperSymonds { rate, .. }) if rate < MIN_FLOW_STRESS_RATE => Some(rate),
        _ => None,
    };
    let lower_yield = slow.map(|rate| {
        let text = format!(
            "cowper_symonds.rate = {} 1/s: constants below {MIN_FLOW_STRESS_RATE} 1/s are of the lower yield point, and a dent strains the metal by 1 to 4 %: e comes out too high",
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
            "damping.hunt_crossley x speed = {}: above {STIFF_DAMPING} the sphere keeps only 1/hunt_crossley = {} of its speed; check the unit, s/m",
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
    let angle = approach.incidence.map_or(0.0, |Incidence { angle, .. }| angle.abs());
    let ratio = impact.radius_ratio;
    let is_ploughing = impact.has_dent() && ratio > 0.1 && angle > FRAC_PI_4;
    let ploughing = Warning::new_if(is_ploughing, WarningKind::Ploughing, ratio, || {
        format!(
            "contact radius / sphere radius = {ratio:.3} at {:.0} deg from the normal: the sphere ploughs, a force of about {:.0} % of the contact force that friction leaves out; take tangential speed and spin as estimates",
            angle.to_degrees(),
            100.0 * 4.0 / (3.0 * PI) * ratio
        )
    });
    let mismatch = contact.dundurs_beta();
    let slips_little = impact.rebound.is_some_and(|rebound| rebound.psi.abs() < 1.0);
    let is_coupled = mismatch.abs() > MAX_DUNDURS_BETA && slips_little;
    let coupled = Warning::new_if(is_coupled, WarningKind::DundursCoupling, mismatch.abs(), || {
        format!(
            "the materials differ so much (Dundurs' beta = {mismatch:.2}) that pressure and friction act on each other, which is neglected: where the contact slips as little as here, psi_2 may be off by 0.1"
        )
    });
    [ploughing, coupled].into_iter().flatten()
}

/// Dundurs' β from which on finite elements show that it is neglected.
const MAX_DUNDURS_BETA: f64 = 0.25;
