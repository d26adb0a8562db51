//! Checks of model and run. Each finding is a warning in the result; with `--strict` it is an error.

mod of_run;

use std::f64::consts::{FRAC_PI_4, PI};

use super::bodies::{left_out, of_flow, of_half_space, of_materials, of_sphere, of_yielding};
use super::contact::Contact;
use super::essentials::OnPlate;
use super::forces::Damping;
use super::oblique::{Approach, Incidence};
use super::plate::{Plate, PlateTheory};
use super::result::Impact;
use super::solve::{Method, Solver};
use super::warning::{Warning, WarningKind};
use crate::contact::law::{ContactState, Ground, Law, Raised, Unloading};
use crate::contact::material::{Hold, Pair};
use crate::contact::strength::rate::Form as RateForm;
use crate::numerics::root::halved;
use crate::units::{Dimension, four_digits, human, percent};
use of_run::{of_gain, of_rebound, of_run};

/// The warnings for a peak outside of the range of the law or of its flow curve.
pub(crate) fn of_peak(ground: Ground, peak: &ContactState) -> impl Iterator<Item = Warning> + use<> {
    let x = peak.indentation;
    let law = ground.law;
    let stated = ground.outside_stated(peak).map(|(from, to)| {
        let in_yields = |x: f64| four_digits(law.in_yields(x));
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
            "the flow curve ends at a plastic strain of {last}, and the contact asks for it up to {strain:.4}: beyond its last point it is taken to stay level; give points at larger strains, or let the dent be shallower"
        );
        Warning::new(WarningKind::BeyondFlowCurve, strain, text)
    });
    stated.into_iter().chain(curve)
}

/// The warning for an exponent of unloading that is not the one that was asked for.
pub(crate) fn of_exponent(ground: Ground, unloading: &Unloading) -> Option<Warning> {
    let Raised { asked, used, gain } = ground.raised(unloading)?;
    let text = format!(
        "an unloading exponent of {} would give back {} of the energy more than was spent: {} is used in its place, with which e is 1 but for gravity and drag; give a larger exponent, or let the peak be further above first yield",
        four_digits(asked),
        percent(gain),
        four_digits(used)
    );
    Some(Warning::new(WarningKind::RaisedExponent, gain, text))
}

/// The warning for a dent of this radius, over that of the sphere.
pub(crate) fn of_dent(law: &Law, ratio: f64) -> Option<Warning> {
    let limit = law.limits.widest;
    Warning::when(ratio > limit, WarningKind::DeepDent, ratio, || {
        format!(
            "contact radius / sphere radius = {ratio:.3} is beyond {limit}, up to which this law holds: take forces and residual indentation as estimates, or let the indentation be shallower"
        )
    })
}

/// The warning for two balls that both flow and are not equal, with this contact radius over that of the smaller one.
fn of_unequal_balls(pair: &Pair, ratio: f64) -> Option<Warning> {
    let is_doubtful = pair.is_of_unequal_balls() && ratio > 0.1;
    Warning::when(is_doubtful, WarningKind::UnequalBalls, ratio, || {
        format!(
            "both balls flow and are not equal, and the contact radius is {ratio:.3} of the smaller one's: there the sum of their parts misses equal balls by 0.5 to 1 % of e, so that e has a step of this size where an axis passes through equal balls"
        )
    })
}

impl Contact {
    /// The indentation \[m\] up to which the data behind the law reach: beyond it an impact is warned of a dent that is too
    /// wide, of a flow curve that ends before, or of a law outside its stated range. Infinite for a law without such a
    /// limit, as for springs.
    pub fn deepest(&self) -> f64 {
        let radius = self.pair().smaller_radius;
        let Self { scales, law, .. } = self;
        let reaches = |x: f64| {
            let Some(peak) = law.respond(x, None).1 else { return true };
            let is_wide = scales.contact_radius * law.contact_radius(&peak) > law.limits.widest * radius;
            let is_before = law.outside_stated(&peak).is_some_and(|(from, _)| x < from);
            let is_harmless = |warning: Warning| is_before && warning.kind == WarningKind::OutsideStated;
            !is_wide && of_peak(law.into(), &peak).all(is_harmless)
        };
        let far = radius / scales.length;
        if reaches(far) { f64::INFINITY } else { halved(0.0, far, reaches).0 * scales.length }
    }
}

/// All warnings of an impact.
pub(super) fn warnings(
    contact: &Contact,
    impact: &Impact,
    ground: Ground,
    unloading: &Unloading,
    solver: &Solver,
) -> Vec<Warning> {
    let (law, peak) = (ground.law, &unloading.peak);
    let sphere = contact.sphere();
    let strengths = [sphere.yield_strength, contact.half_space().yield_strength];
    let left_out = left_out(contact.pair(), law, strengths);
    let yielding = of_yielding(impact.peak_mean_pressure, left_out, "e is far too high");
    let mut warnings: Vec<Warning> = yielding.into_iter().chain(of_flow(contact.pair())).collect();
    warnings.extend(of_materials(contact, impact, law));
    warnings.extend(of_peak(ground, peak));
    warnings.extend(of_exponent(ground, unloading));
    let ratio = impact.radius_ratio;
    warnings.extend(of_unequal_balls(contact.pair(), ratio));
    let density = (!contact.is_of_a_body()).then_some(sphere.density);
    warnings.extend(of_sphere(sphere.radius, &sphere.material, sphere.yield_strength, density));
    warnings.extend(of_half_space(contact.half_space()));
    warnings.extend(of_dent(law, ratio));
    let transit = 2.0 * sphere.radius * (sphere.density / sphere.material.youngs_modulus).sqrt();
    let of_target = contact.half_space();
    let of_ball = of_target.ball_radius().filter(|_| of_target.hold == Hold::Ball).zip(of_target.density);
    let transit = of_ball.map_or(transit, |(radius, density)| {
        transit.max(2.0 * radius * (density / of_target.material.youngs_modulus).sqrt())
    });
    let transits = impact.duration() / transit;
    let is_short = transits < 5.0 && !contact.is_of_a_body();
    warnings.extend(Warning::when(is_short, WarningKind::ShortContact, -transits, || {
        format!(
            "contact lasts {transits:.2} wave transits of the sphere (2 R / c); below 5 it is no longer quasi-static and part of the energy goes into waves"
        )
    }));
    warnings.extend(of_rate(contact));
    warnings.extend(of_waves(impact));
    if let (Some(plate), Some(of)) = (&contact.forces().plate, &impact.on_plate) {
        warnings.extend(of_plate(plate, of, impact.peak_contact_radius));
    }
    warnings.extend(of_damping(contact, impact));
    let is_verlet = solver.method == Method::Verlet;
    warnings.extend(if is_verlet { of_gain(contact, impact) } else { of_rebound(contact, impact) });
    warnings.extend(of_run(impact, solver));
    warnings.sort_by_key(|warning| !warning.is_grave());
    warnings
}

/// The warning for radiated waves that the first order does not hold for.
fn of_waves(impact: &Impact) -> Option<Warning> {
    let (loss, recovered) = (impact.wave_loss_fraction?, impact.recovered_fraction());
    Warning::when(loss > 0.2 * recovered, WarningKind::StrongWaves, loss / recovered, || {
        format!(
            "elastic waves take {loss:.3} of the kinetic energy, while the law gives {recovered:.3} of it back: too much for a first-order estimate; take restitution_with_waves as a rough value (0 where nothing is left)"
        )
    })
}

/// The rates \[1/s\] for which the constants of metals were measured.
const RATES: [f64; 2] = [1e-3, 1e5];
/// Rates \[1/s\] of a test between those of a usual test and of an impact.
const FAST_TESTS: [f64; 2] = [50.0, 1000.0];
/// Least D \[1/s\] of a flow stress.
const FLOWING: f64 = 1000.0;

/// The warnings for the strain rate of an impact, and for the constants of its metal.
fn of_rate(contact: &Contact) -> impl Iterator<Item = Warning> + use<> {
    let rate = contact.rated.and_then(|rated| rated.rate);
    let strain_rate = contact.rated.map_or(f64::NAN, |rated| rated.strain_rate);
    let [low, high] = RATES;
    let outside = Warning::when(strain_rate < low || strain_rate > high, WarningKind::StrainRate, strain_rate, || {
        format!(
            "strain rate {} 1/s is outside of {low:e} to {high:e} 1/s, for which such constants are known: take the factor of the strength for an extrapolation",
            four_digits(strain_rate)
        )
    });
    let tested_at = rate.map_or(f64::NAN, |rate| rate.tested_at);
    let is_fast = (FAST_TESTS[0]..=FAST_TESTS[1]).contains(&tested_at);
    let fast = Warning::when(is_fast, WarningKind::FastTest, tested_at, || {
        format!(
            "tested_at = {} 1/s is nearly as fast as the impact, and only the turn of the sphere is slower than that test: e comes out below the one without a rate; give the strength of a slow test",
            four_digits(tested_at)
        )
    });
    let slow = match rate.map(|rate| rate.form) {
        Some(RateForm::CowperSymonds { rate, .. }) if rate < FLOWING => Some(rate),
        _ => None,
    };
    let lower_yield = slow.map(|rate| {
        let text = format!(
            "cowper_symonds.rate = {} 1/s: constants below {FLOWING} 1/s are of the lower yield point, and a dent asks for the flow stress at 1 to 4 % of strain: e comes out too high",
            four_digits(rate)
        );
        Warning::new(WarningKind::LowerYield, -rate, text)
    });
    [outside, fast, lower_yield].into_iter().flatten()
}

/// χ v from which on the damping of Hunt and Crossley leaves less than a thousandth of the speed.
const STIFF: f64 = 1e3;

/// The warning of damping that leaves next to nothing, and whose fast decay makes steps tiny.
fn of_damping(contact: &Contact, impact: &Impact) -> Option<Warning> {
    let Some(Damping::HuntCrossley(chi)) = contact.forces().damping else { return None };
    let size = chi * impact.speed;
    Warning::when(size > STIFF, WarningKind::StiffDamping, size, || {
        format!(
            "damping.hunt_crossley x speed = {}: above {STIFF} the sphere keeps only 1/hunt_crossley = {} of its speed; check the unit, s/m",
            four_digits(size),
            human(1.0 / chi, Dimension::Speed)
        )
    })
}

/// The warnings for a plate, hit with this contact radius \[m\].
fn of_plate(plate: &Plate, of: &OnPlate, contact_radius: f64) -> impl Iterator<Item = Warning> + use<> {
    let OnPlate { thinness, displacement, reach, .. } = *of;
    let thickness = plate.thickness;
    let (least, beyond) = match plate.theory {
        PlateTheory::Thick => (5.0, "by 8 % at 5 thicknesses and by a third at 3"),
        PlateTheory::Zener if thinness < 5.0 => (10.0, "by half or more; half_space.plate = \"thick\" comes nearer"),
        PlateTheory::Zener => {
            (10.0, "by a fifth at 10 thicknesses and by half at 5; half_space.plate = \"thick\" is good to 8 % of it")
        }
    };
    let is_thick = thinness < 2.0;
    let thick = Warning::when(is_thick, WarningKind::ThickPlate, -thinness, || {
        format!(
            "during the contact a wave travels only {thinness:.2} thicknesses of the plate, and below 2 the echo of its rear face comes too late: it acts as a half-space, so leave half_space.thickness out"
        )
    });
    let between = Warning::when(!is_thick && thinness < least, WarningKind::BetweenTheories, -thinness, || {
        format!(
            "during the contact a wave travels {thinness:.1} thicknesses of the plate, and a thin plate takes at least {least}: the plate takes more energy than computed, {beyond}"
        )
    });
    let ratio = contact_radius / thickness;
    let wide = Warning::when(ratio > 0.15, WarningKind::WideContactOnPlate, ratio, || {
        format!(
            "contact radius / plate thickness = {ratio:.3} is above 0.15: there the plate is stiffer under the sphere than a half-space by more than a tenth, and yields through; take the result for an estimate"
        )
    });
    let near = plate.edge_distance.filter(|distance| *distance < reach).map(|distance| {
        let [edge, far] = [distance, reach].map(|length| human(length, Dimension::Length));
        let text = format!(
            "half_space.edge_distance = {edge} is less than {far}, from where bending waves come back during the contact: the plate may take a quarter more or less than computed"
        );
        Warning::new(WarningKind::NearEdge, reach / distance, text)
    });
    let ratio = displacement / thickness;
    let deep = Warning::when(ratio > 0.3, WarningKind::DeepPlate, ratio, || {
        format!(
            "the plate moves by {ratio:.2} of its thickness, and above 0.3 it also stretches, which makes it stiffer than computed"
        )
    });
    [thick, between, wide, near, deep].into_iter().flatten()
}

/// The warnings of an oblique impact.
pub(super) fn of_oblique(
    contact: &Contact,
    impact: &Impact,
    approach: Approach,
) -> impl Iterator<Item = Warning> + use<> {
    let angle = approach.incidence.map_or(0.0, |Incidence { angle, .. }| angle.abs());
    let ratio = impact.radius_ratio;
    let is_ploughing = impact.has_dent() && ratio > 0.1 && angle > FRAC_PI_4;
    let ploughing = Warning::when(is_ploughing, WarningKind::Ploughing, ratio, || {
        format!(
            "contact radius / sphere radius = {ratio:.3} at {:.0} deg from the normal: the sphere ploughs, a force of about {:.0} % of the contact force that friction leaves out; take tangential speed and spin as estimates",
            angle.to_degrees(),
            100.0 * 4.0 / (3.0 * PI) * ratio
        )
    });
    let mismatch = contact.dundurs_beta();
    let slips_little = impact.rebound.is_some_and(|rebound| rebound.psi.abs() < 1.0);
    let is_coupled = mismatch.abs() > LARGEST_MISMATCH && slips_little;
    let coupled = Warning::when(is_coupled, WarningKind::Mismatch, mismatch.abs(), || {
        format!(
            "the materials differ so much (Dundurs' beta = {mismatch:.2}) that pressure and friction act on each other, which is neglected: where the contact slips as little as here, psi_2 may be off by 0.1"
        )
    });
    [ploughing, coupled].into_iter().flatten()
}

/// Dundurs' β from which on finite elements show that it is neglected.
const LARGEST_MISMATCH: f64 = 0.25;
