//! A half-space that hardens: finite elements, limits without hardening, and properties that always
//! hold.

use plm_impact::impact::solve::closed_form;

use plm_impact::contact::strength::flow_curve::FlowPoint;
use plm_impact::reference::HARDENING;
use plm_impact::validate::comparison::rms;

use crate::common::prelude::*;

fn steel(flow: Option<FlowCurve>, exponent: UnloadingExponent) -> Contact {
    Scene::steel().contact_by(&Plm { exponent, flow: [None, flow], ..Plm::default() })
}

/// A law on a half-space of E = 200 GPa; none on one that is steeper than its elastic line. E_s/E_h is 10^`ratio`.
fn hardening_law(
    ratio: f64,
    yield_strength: f64,
    flow: FlowCurve,
    exponent: UnloadingExponent,
) -> Option<(Law, YieldingPair)> {
    let half_space = Material { youngs_modulus: MODULUS, poissons_ratio: 0.3 };
    let sphere = Material { youngs_modulus: MODULUS * 10_f64.powf(ratio), poissons_ratio: 0.3 };
    let half_space = HalfSpace::flat(half_space, Some(yield_strength));
    let pair = Pair::try_new(&Sphere::elastic(1.0, sphere, 1.0), &half_space).unwrap();
    let law = Plm { exponent, flow: [None, Some(flow)], ..Plm::default() }.law_for_pair(&pair).ok()?;
    Some((law, YieldingPair::new(&pair).unwrap()))
}

const MODULUS: f64 = 2e11;

/// Random measured curves of the kind that metals have: concave, with a first part that may be as steep as the elastic line, and
/// level from any point on. None rises by half within 0.1 % of strain.
fn any_measured_law() -> impl Strategy<Value = (Law, YieldingPair, UnloadingExponent)> {
    let parts = prop::collection::vec((-3.0..-1.0_f64, 0.0..450.0_f64), 2..8);
    let exponent = prop_oneof![Just(UnloadingExponent::Paper), Just(UnloadingExponent::PressureShape)];
    (-1.0..3.0_f64, 50.0..6000.0_f64, parts, exponent).prop_map(|(ratio, modulus_over_strength, parts, exponent)| {
        let yield_strength = MODULUS / modulus_over_strength;
        let (mut widths, mut slopes): (Vec<f64>, Vec<f64>) = parts
            .into_iter()
            .map(|(decades, slope)| (10_f64.powf(decades), slope.min(0.9 * modulus_over_strength)))
            .unzip();
        // the narrow parts first, each flatter than the one before
        widths.sort_by(f64::total_cmp);
        slopes.sort_by(|a, b| b.total_cmp(a));
        let mut least = f64::INFINITY;
        let points = widths.iter().zip(slopes).scan((0.0, yield_strength), |(strain, stress), (width, slope)| {
            least = least.min(slope).min(0.45 / width);
            *strain += width;
            *stress += least * width * yield_strength;
            Some(FlowPoint { strain: *strain, stress: *stress })
        });
        let flow = FlowCurve::from_points(points.collect::<Vec<_>>()).unwrap();
        let (law, bodies) = hardening_law(ratio, yield_strength, flow, exponent).unwrap();
        (law, bodies, exponent)
    })
}

/// Whether along a law d ln F/d ln δ is above this bound, dents deepen and e falls, but for these shares: of the indentation, and
/// of e.
fn is_monotonic(
    law: &Law,
    bodies: &YieldingPair,
    least_growth: f64,
    dent: f64,
    rise: f64,
) -> Result<(), TestCaseError> {
    let mut before = law.loaded_state(1.0);
    let (mut least, mut deepest_dent) = (1.0_f64, 0.0_f64);
    // up to an indentation of 0.15 R
    let deepest = 0.15 / bodies.yield_radius_ratio().powi(2);
    for i in 1..400 {
        let x = deepest.powf(f64::from(i) / 400.0);
        let peak = law.loaded_state(x);
        let growth = (peak.force / before.force).ln() / (peak.indentation / before.indentation).ln();
        prop_assert!(growth > least_growth, "{x}: {growth}");
        prop_assert!(peak.residual() >= deepest_dent - dent * x, "{x}: {} {deepest_dent}", peak.residual());
        deepest_dent = deepest_dent.max(peak.residual());
        let restitution = (law.unload(peak).recoverable_energy() / law.loading.work(x)).sqrt();
        prop_assert!(restitution < least * (1.0 + rise) && restitution < 1.0 + 1e-12, "{x}: {restitution} {least}");
        least = least.min(restitution);
        before = peak;
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::common::proptest_config(200))]

    #[test]
    fn saturating_measured_curves_satisfy_looser_bounds((law, bodies, _) in any_measured_law()) {
        // a metal that has stopped hardening yields further in a deep dent
        is_monotonic(&law, &bodies, 0.9, 2e-3, 1e-2)?;
    }
}

/// The pressure of a soft sphere on a hard metal grows so fast that "pressure-shape" asks for an exponent below -1. The branch
/// then gives back just what was spent, and an impact has no answer.
#[test]
fn impossible_exponent_has_no_answer() {
    // e 1.6 GPa sphere on E = 437 GPa, as steep as the elastic line allows
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let (sphere, half_space, yield_strength) = (material(1.6e9), material(437e9), Some(130e6));
    let scene = Scene { sphere, half_space, yield_strength, ..Scene::steel() };
    for flow in [FlowCurve::Voce { saturation: 22.7, rate: 148.0 }, FlowCurve::Power { exponent: 0.5 }] {
        let plm = Plm { exponent: UnloadingExponent::PressureShape, flow: [None, Some(flow)], ..Plm::default() };
        let contact = scene.contact_by(&plm);
        let yields = contact.yield_speed().unwrap();
        let mut refused = 0;
        for i in 1..200 {
            let speed = yields * 1.05_f64.powi(i);
            let (_, law, q) = contact.scaling(speed).unwrap();
            let outcome = closed_form::solve(law, q);
            assert!(outcome.restitution > 0.0 && outcome.restitution <= 1.0, "{i}: {}", outcome.restitution);
            assert!(outcome.contact_time.is_finite() && outcome.unloading.exponent > 0.0, "{i}");
            let no_answer = matches!(contact.closed_form(speed), Err(ImpactError::Law(LawError::Exponent { .. })));
            assert!(!no_answer || outcome.restitution > 1.0 - 1e-12, "{i}: {}", outcome.restitution);
            refused += u32::from(no_answer);
        }
        assert!(refused > 5, "{refused}");
    }
}

/// The table "Which strength?" of the guide, for both exponents of unloading: e at the work of the finite elements, by the flow
/// curve, and by one constant strength in its place: that at the first plastic strain, at 0.2 %, and at 8 %, which a
/// hardness test gives. rms and largest deviation.
#[test]
fn error_of_e_matches_table_of_strengths() {
    let off_by = |strain: Option<f64>, exponent: UnloadingExponent| -> Vec<f64> {
        let unloadings = HARDENING.rows().unwrap().into_iter();
        let of_each = unloadings.map(|row| {
            let (strength, half_space) = (row.number("yield_strength_Pa"), row.half_space());
            let curve = row.curve().unwrap();
            let rise = curve.normalise(strength, half_space.material.youngs_modulus);
            let ratio = strain.map_or(1.0, |strain| rise.relative_stress(strain));
            let half_space = HalfSpace { yield_strength: Some(ratio * strength), ..half_space };
            let bodies =
                YieldingPair::new(&Pair::try_new(&Sphere::elastic(1.0, row.sphere(), 1.0), &half_space).unwrap())
                    .unwrap();
            let flow = strain.is_none().then_some(curve);
            let law = Plm { exponent, flow: [None, flow], ..Plm::default() }.law(&bodies).unwrap();
            // F_Y δ_Y is proportional to the fifth power of the strength
            let spent = row.number("spent") / ratio.powi(5);
            let x = law.loading.pieces()[law.loading.index_at_work(spent)].indentation_at_work(spent);
            (law.unload(law.loaded_state(x)).recoverable_energy() / spent).sqrt() / row.number("restitution") - 1.0
        });
        of_each.collect()
    };
    let (shape, paper) = (UnloadingExponent::PressureShape, UnloadingExponent::Paper);
    for (strain, exponent, most, extreme) in [
        (None, shape, 0.011, -0.027),
        (None, paper, 0.041, -0.062),
        (Some(0.0), shape, 0.23, -0.53),
        (Some(0.0), paper, 0.25, -0.55),
        (Some(0.002), shape, 0.15, -0.38),
        (Some(0.002), paper, 0.17, -0.40),
        (Some(0.08), shape, 0.17, 0.34),
        (Some(0.08), paper, 0.15, 0.32),
    ] {
        let off = off_by(strain, exponent);
        assert!((rms(&off) - most).abs() < 6e-3, "{strain:?} {exponent:?}: {}", rms(&off));
        let of_all = max_magnitude(off.iter().copied());
        assert!((of_all - extreme).abs() < 6e-3, "{strain:?} {exponent:?}: {of_all}");
    }
}

/// A measured curve may have an unphysical jump of its slope. The force must still rise, because all else depends on
/// this.
#[test]
fn the_force_rises_along_any_curve() {
    let mut compared = 0;
    for (strain, stress) in [(1e-6, 345.2e6), (1e-3, 550e6), (1e-2, 2.4e9), (1e-9, 345.0002e6)] {
        let points = [FlowPoint { strain, stress }, FlowPoint { strain: 2.0 * strain, stress }];
        let contact = steel(Some(FlowCurve::from_points(points.to_vec()).unwrap()), UnloadingExponent::PressureShape);
        let (_, law, _) = contact.scaling(3.0).unwrap();
        assert!(
            law.loading.pieces().windows(2).all(|pair| pair[0].force < pair[1].force && pair[0].work < pair[1].work)
        );
        for speed in [0.02, 0.1, 1.0, 10.0] {
            let Ok(exact) = contact.closed_form(speed) else { continue };
            compared += 1;
            assert!(exact.row.restitution > 0.0 && exact.row.restitution <= 1.0);
            let stepped = contact.impact(speed, &Solver::default(), None).unwrap();
            assert!(relative_error(stepped.row.restitution, exact.row.restitution) < 1e-8, "{stress:e} {speed}");
        }
    }
    // the others, just beyond first yield, would give back more than was spent
    assert!(compared >= 13, "{compared} of 16");
}
