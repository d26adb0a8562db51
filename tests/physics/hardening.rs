//! A half-space that hardens: 30-digit impacts, finite elements, limits without hardening, and properties that always
//! hold.

use plm_impact::impact::{Contact, Forces, Impact, Method, ScaledForces, Solver, closed_form, course};
use plm_impact::integrate::rk8::Rk8;
use plm_impact::law::{Bodies, ContactLaw, Law, Plm, UnloadingExponent};
use plm_impact::material::{HalfSpace, Material, Pair, Sphere};
use plm_impact::reference::hardening::{ExactImpact, Materials, impacts, unloadings};
use plm_impact::strength::flow::{FlowCurve, FlowPoint};
use plm_impact::validation::check::{largest, rms};
use proptest::prelude::*;

use crate::common::{STEPPING, off, solver, worst};

fn contact(materials: &Materials, impact: &ExactImpact) -> Contact {
    let sphere = Sphere {
        radius: impact.radius_m,
        material: materials.sphere(),
        density: impact.sphere_density_kg_per_m3,
        yield_strength: None,
    };
    Contact::try_new(sphere, materials.half_space(), &materials.law(impact.exponent())).unwrap()
}

fn compare(want: &ExactImpact, got: &Impact, allowed: f64) {
    let want_indentation = want.peak_indentation_m;
    for (name, got, want) in [
        ("restitution", got.restitution, want.restitution),
        ("contact time", got.contact_time, want.contact_time_s),
        ("peak force", got.peak_force, want.peak_force),
        ("peak indentation", got.peak_indentation, want.peak_indentation_m),
        ("elastic approach", got.elastic_approach, want.elastic_approach_m),
        ("residual indentation", got.residual_indentation, want.residual_indentation_m),
        ("exponent", got.unloading_exponent, want.unloading_exponent),
        ("contact radius", got.peak_contact_radius, want.peak_contact_radius_m),
    ] {
        // the dent is the difference of indentation and elastic approach
        let lost = if name.starts_with("residual") { want_indentation / want } else { 1.0 };
        let allowed = allowed * lost;
        assert!(off(got, want) <= allowed, "{name} off by {:e}: {got} {want}", off(got, want));
    }
}

#[test]
fn impacts_are_those_of_30_digit_arithmetic() {
    let rows = impacts().unwrap();
    assert_eq!(rows.len(), 8);
    for (materials, want) in &rows {
        let contact = contact(materials, want);
        let speed = want.impact_speed_m_per_s;
        compare(want, &contact.closed_form(speed).unwrap(), 1e-12);
        compare(want, &contact.impact(speed, &Solver::default(), None).unwrap(), 1e-8);
        compare(want, &contact.impact(speed, &Solver::default(), Some(50)).unwrap(), 1e-8);
        for (method, factor) in STEPPING {
            compare(want, &contact.impact(speed, &solver(method, 1e-11), None).unwrap(), factor * 1e-11);
        }
    }
}

#[test]
fn unloadings_of_finite_elements_are_met_as_documented() {
    let rows = unloadings().unwrap();
    assert_eq!(rows.len(), 43);
    let mut off: [Vec<f64>; 4] = Default::default();
    let mut initial = Vec::new();
    for (materials, want) in &rows {
        let bodies = materials.bodies().unwrap().unwrap();
        let of = |plm: Plm| {
            let law = plm.law(&bodies).unwrap();
            // at the same work of loading as the finite elements
            let x = law.loading.pieces()[law.loading.index_at_work(want.spent)].indentation_at_work(want.spent);
            let peak = law.loaded_to(x);
            let restitution = (law.unloading(peak).capacity() / want.spent).sqrt();
            (peak, restitution / want.restitution - 1.0, law.contact_radius(&peak) * bodies.yield_radius_ratio())
        };
        let (peak, restitution, radius) = of(materials.law(UnloadingExponent::PressureShape));
        let deviations = [
            restitution,
            peak.force / want.f - 1.0,
            peak.indentation / want.x - 1.0,
            radius / want.contact_radius - 1.0,
        ];
        off.iter_mut().zip(deviations).for_each(|(list, deviation)| list.push(deviation));
        initial.push(of(Plm { exponent: UnloadingExponent::PressureShape, ..Plm::default() }).1);
    }
    // rms and largest deviation as documented for e, force, indentation and contact radius, plus half a unit of the
    // last digit
    let documented = [(0.011, 0.029), (0.014, 0.038), (0.0105, 0.031), (0.0155, 0.036)];
    for (list, (most, extreme)) in off.iter().zip(documented) {
        assert!(rms(list) < most + 5e-4, "{}", rms(list));
        assert!(largest(list.iter().copied()).abs() < extreme + 5e-4, "{}", largest(list.iter().copied()));
    }
    // with the initial yield strength e is 2 to 53 % too low
    assert!((rms(&initial) - 0.231).abs() < 2e-3, "{}", rms(&initial));
    assert!((largest(initial.into_iter()) + 0.528).abs() < 2e-3);
}

const STEEL: Material = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
const STEEL_SPHERE: Sphere = Sphere { radius: 5e-3, material: STEEL, density: 7850.0, yield_strength: None };
const STEEL_HALF_SPACE: HalfSpace = HalfSpace { material: STEEL, yield_strength: Some(345e6), density: None };
const EXPONENTS: [UnloadingExponent; 3] =
    [UnloadingExponent::Paper, UnloadingExponent::PressureShape, UnloadingExponent::Fixed(1.3)];

fn steel(flow: Option<FlowCurve>, exponent: UnloadingExponent) -> Contact {
    let plm = Plm { exponent, flow, ..Plm::default() };
    Contact::try_new(STEEL_SPHERE, STEEL_HALF_SPACE, &plm).unwrap()
}

#[test]
fn a_curve_that_does_not_rise_is_the_law_without_hardening() {
    let level = |stress| FlowCurve::through([0.001, 0.02].map(|strain| FlowPoint { strain, stress }).to_vec()).unwrap();
    let flat = [
        FlowCurve::Power { exponent: 0.0 },
        FlowCurve::Voce { saturation: 0.0, rate: 20.0 },
        FlowCurve::Linear { slope: 0.0 },
        level(345e6),
    ];
    for curve in flat {
        for exponent in EXPONENTS {
            let (hardening, plain) = (steel(Some(curve.clone()), exponent), steel(None, exponent));
            // elastic, just past yield, on every piece, and beyond the last knot (250 yield indentations at 6.3 m/s)
            for speed in [1e-3, 0.0097, 0.012, 0.02, 0.05, 0.2, 1.0, 3.0, 10.0, 30.0] {
                let (got, want) = (hardening.closed_form(speed).unwrap(), plain.closed_form(speed).unwrap());
                for (got, want) in [
                    (got.restitution, want.restitution),
                    (got.contact_time, want.contact_time),
                    (got.peak_force, want.peak_force),
                    (got.peak_indentation, want.peak_indentation),
                    (got.elastic_approach, want.elastic_approach),
                    (got.unloading_exponent, want.unloading_exponent),
                    (got.peak_contact_radius, want.peak_contact_radius),
                ] {
                    assert!(off(got, want) < 1e-13, "{curve:?} {speed}: {got} {want}");
                }
            }
        }
    }
}

#[test]
fn gravity_has_its_closed_form() {
    for exponent in EXPONENTS {
        let contact = steel(Some(FlowCurve::Power { exponent: 0.2 }), exponent);
        let speeds = [0.02, 0.1, 0.3, 1.0, 1.5, 3.0, 7.0, 20.0];
        for (_, law, q) in speeds.map(|speed| contact.scaled(speed).unwrap()) {
            let got = course::integrate(law, q, &ScaledForces::NONE, &mut Rk8::new(1e-10), None).unwrap();
            assert!(worst(&got, &closed_form::solve(law, q)) < 1e-9);
        }
        if matches!(exponent, UnloadingExponent::Fixed(_)) {
            // just past yield the work of loading limits such an exponent, and the closed form under gravity takes this
            // as an impact without a dent
            continue;
        }
        let falling = contact.clone().with_forces(Forces { gravity: Some(9.81), damping: None });
        for speed in speeds {
            let exact = falling.impact(speed, &solver(Method::ClosedForm, 1e-10), None).unwrap();
            let stepped = falling.impact(speed, &solver(Method::Rk8, 1e-12), None).unwrap();
            assert!(
                off(stepped.restitution, exact.restitution) < 1e-9,
                "{speed}: {:e}",
                off(stepped.restitution, exact.restitution)
            );
            assert!(off(stepped.contact_time, exact.contact_time) < 1e-9, "{speed}");
        }
    }
}

/// Random κ, a_Y/R and flow curve: in the range that was compared with finite elements, and up to N = 0.5.
fn any_hardening_law() -> impl Strategy<Value = (Law, Bodies, UnloadingExponent)> {
    let curve = prop_oneof![
        3 => (0.02..=0.5_f64).prop_map(|exponent| FlowCurve::Power { exponent }),
        1 => (0.1..3.0_f64, 2.0..30.0_f64).prop_map(|(saturation, rate)| FlowCurve::Voce { saturation, rate }),
        1 => (0.1..3.0_f64).prop_map(|giga| FlowCurve::Linear { slope: 1e9 * giga }),
    ];
    let exponent = prop_oneof![Just(UnloadingExponent::Paper), Just(UnloadingExponent::PressureShape)];
    (-1.0..3.0_f64, 50.0..6000.0_f64, curve, exponent).prop_map(|(ratio, modulus_over_strength, flow, exponent)| {
        let half_space = Material { youngs_modulus: 2e11, poissons_ratio: 0.3 };
        let sphere = Material { youngs_modulus: 2e11 * 10_f64.powf(ratio), poissons_ratio: 0.3 };
        let yield_strength = Some(half_space.youngs_modulus / modulus_over_strength);
        let half_space = HalfSpace { material: half_space, yield_strength, density: None };
        let bodies = Bodies::new(&Pair::try_new(1.0, &sphere, &half_space).unwrap(), &half_space).unwrap();
        let plm = Plm { exponent, flow: Some(flow), ..Plm::default() };
        (plm.law(&bodies).unwrap(), bodies, exponent)
    })
}

proptest! {
    #![proptest_config(crate::common::cases(200))]

    #[test]
    fn force_rises_dents_deepen_and_restitution_falls((law, bodies, exponent) in any_hardening_law()) {
        let mut before = law.loaded_to(1.0);
        let (mut least, mut deepest_dent) = (1.0_f64, 0.0_f64);
        // documented rise after a knot: 0.05 % with 3/2, 0.10 % with pressure-shape
        let rise = if exponent == UnloadingExponent::Paper { 5e-4 } else { 1e-3 };
        // up to an indentation of 0.15 R
        let deepest = 0.15 / bodies.yield_radius_ratio().powi(2);
        for i in 1..400 {
            let x = deepest.powf(f64::from(i) / 400.0);
            let peak = law.loaded_to(x);
            let growth = (peak.force / before.force).ln() / (peak.indentation / before.indentation).ln();
            prop_assert!(growth > 1.0, "{x}: {growth}");
            // the force is linear between points; for a soft sphere this makes the dent fall a little just after the
            // first knot
            prop_assert!(peak.residual() >= deepest_dent - 3e-4 * x, "{x}: {} {deepest_dent}", peak.residual());
            deepest_dent = deepest_dent.max(peak.residual());
            let restitution = (law.unloading(peak).capacity() / law.loading.work(x)).sqrt();
            prop_assert!(restitution < least * (1.0 + rise) && restitution < 1.0 + 1e-12, "{x}: {restitution} {least}");
            least = least.min(restitution);
            before = peak;
        }
    }
}

/// The statement of the pages on one constant strength instead of the flow curve: the strength at 0.2 % plastic strain,
/// and the strength at 8 %, which a hardness test gives. rms and largest deviation of e at the work of the finite
/// elements.
#[test]
fn one_strength_for_a_metal_that_hardens_is_as_far_off_as_documented() {
    for (strain, most, extreme) in [(0.002, 0.15, -0.37), (0.08, 0.17, 0.35)] {
        let off = unloadings().unwrap().into_iter().map(|(materials, want)| {
            let (strength, half_space) = (materials.yield_strength, materials.half_space());
            let ratio = materials.curve().unwrap().rise(strength, half_space.material.youngs_modulus).at(strain);
            let half_space = HalfSpace { yield_strength: Some(ratio * strength), ..half_space };
            let bodies =
                Bodies::new(&Pair::try_new(1.0, &materials.sphere(), &half_space).unwrap(), &half_space).unwrap();
            let law = Plm { exponent: UnloadingExponent::PressureShape, ..Plm::default() }.law(&bodies).unwrap();
            // F_Y δ_Y is proportional to the fifth power of the strength
            let spent = want.spent / ratio.powi(5);
            let x = law.loading.pieces()[law.loading.index_at_work(spent)].indentation_at_work(spent);
            (law.unloading(law.loaded_to(x)).capacity() / spent).sqrt() / want.restitution - 1.0
        });
        let off: Vec<f64> = off.collect();
        assert!((rms(&off) - most).abs() < 6e-3, "{strain}: {}", rms(&off));
        assert!((largest(off.iter().copied()) - extreme).abs() < 6e-3, "{strain}: {}", largest(off.into_iter()));
    }
}

/// A measured curve may have an unphysical jump of its slope. The force must still rise, because all else depends on
/// this.
#[test]
fn the_force_rises_along_any_curve() {
    for (strain, stress) in [(1e-6, 3450e6), (1e-3, 3450e6), (1e-2, 34.5e9), (1e-9, 3.45e12)] {
        let points = [FlowPoint { strain, stress }, FlowPoint { strain: 2.0 * strain, stress }];
        let contact = steel(Some(FlowCurve::through(points.to_vec()).unwrap()), UnloadingExponent::PressureShape);
        let (_, law, _) = contact.scaled(3.0).unwrap();
        assert!(
            law.loading.pieces().windows(2).all(|pair| pair[0].force < pair[1].force && pair[0].work < pair[1].work)
        );
        for speed in [0.02, 0.1, 1.0, 10.0] {
            let exact = contact.closed_form(speed).unwrap();
            assert!(exact.restitution > 0.0 && exact.restitution <= 1.0);
            let stepped = contact.impact(speed, &Solver::default(), None).unwrap();
            assert!(off(stepped.restitution, exact.restitution) < 1e-8, "{stress:e} {speed}");
        }
    }
}

/// Reloading below the old peak is elastic, and reloading beyond it continues along the loading curve.
#[test]
fn a_hardened_dent_is_remembered() {
    let contact = steel(Some(FlowCurve::Power { exponent: 0.2 }), UnloadingExponent::PressureShape);
    let (_, law, _) = contact.scaled(3.0).unwrap();
    let peak = law.loaded_to(40.0);
    let again = law.reloaded(peak);
    assert!(off(again.respond(40.0, None).0, peak.force) < 1e-14);
    assert_eq!(again.loaded_to(80.0), law.loaded_to(80.0));
    assert!(off(again.unloading(again.loaded_to(80.0)).exponent, law.unloading(law.loaded_to(80.0)).exponent) < 1e-14);
}

/// Prints how long it takes to set up a contact with a flow curve. Run it by
/// `cargo test --release --test physics hardening -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement of time"]
fn time_to_set_up() {
    for flow in [FlowCurve::Power { exponent: 0.2 }, FlowCurve::Voce { saturation: 1.5, rate: 15.0 }] {
        let begin = std::time::Instant::now();
        for _ in 0..10_000 {
            std::hint::black_box(steel(Some(flow.clone()), UnloadingExponent::PressureShape));
        }
        println!("{flow:?}: {:.2} us", begin.elapsed().as_secs_f64() * 100.0);
        let contact = steel(Some(flow.clone()), UnloadingExponent::PressureShape);
        let plain = steel(None, UnloadingExponent::PressureShape);
        for (name, contact) in [("hardening", contact), ("plain", plain)] {
            let (_, law, q) = contact.scaled(3.0).unwrap();
            let begin = std::time::Instant::now();
            for i in 0..100_000 {
                std::hint::black_box(closed_form::solve(law, q * (1.0 + 1e-6 * f64::from(i))));
            }
            println!(
                "  {name}: {:.0} ns an impact, {} pieces",
                begin.elapsed().as_secs_f64() * 1e4,
                law.loading.pieces().len()
            );
        }
    }
}
