//! rk8 and the damped stepper give the same bits in a batch as for a single impact, for any mixture of impacts in the
//! lanes.

use plm_impact::bench::problems::kinked_law;
use plm_impact::impact::batch::Problem;
use plm_impact::impact::{Contact, Damping, Fate, Forces, Method, Outcome, ScaledForces, Solver, batch, course};
use plm_impact::integrate::IntegrationError;
use plm_impact::integrate::rk8::Rk8;
use plm_impact::law::{Law, UnloadingExponent};
use plm_impact::material::Material;
use plm_impact::scenario::Scenario;
use plm_impact::sweep::evaluator::{Evaluator, Rows};
use proptest::prelude::*;

use crate::common::{STEEL, Scene};

/// Sizes of a batch: none, one, one less and one more than 32 lanes, many.
const SIZES: [usize; 5] = [0, 1, 31, 33, 200];
const TOLERANCES: [f64; 3] = [1e-4, 1e-10, 1e-13];

type Bits = Result<([u64; 10], Fate), IntegrationError>;

fn bits(outcome: Result<Outcome, IntegrationError>) -> Bits {
    outcome.map(|outcome| {
        let peak = outcome.unloading.peak;
        let numbers = [
            peak.indentation,
            peak.force,
            peak.elastic_approach,
            outcome.unloading.exponent,
            outcome.restitution,
            outcome.loading_time,
            outcome.contact_time,
            outcome.end_indentation,
            outcome.end_speed,
            outcome.loss,
        ];
        (numbers.map(f64::to_bits), outcome.fate)
    })
}

/// The result of each case, computed by itself.
fn alone(cases: &[Problem], tolerance: f64) -> Vec<Bits> {
    let one = |(law, q, forces): &Problem| bits(course::integrate(law, *q, forces, &mut Rk8::new(tolerance), None));
    cases.iter().map(one).collect()
}

fn together(cases: &[Problem], tolerance: f64) -> Vec<Bits> {
    batch::integrate(cases, tolerance).into_iter().map(bits).collect()
}

/// PLM laws of any two bodies, with every kind of exponent, and two laws that are not PLM.
fn any_law() -> impl Strategy<Value = Law> {
    let exponent = prop_oneof![
        2 => Just(UnloadingExponent::Paper),
        2 => Just(UnloadingExponent::PressureShape),
        1 => (1.01..=2.0_f64).prop_map(UnloadingExponent::Fixed),
    ];
    let body = || {
        (9.0..12.5_f64, -0.5..0.49_f64)
            .prop_map(|(log_e, poissons_ratio)| Material { youngs_modulus: 10_f64.powf(log_e), poissons_ratio })
    };
    let plm = (body(), body(), -5.0..-1.0_f64, exponent).prop_map(|(sphere, half_space, log_strength, exponent)| {
        let e_star = 1.0 / (1.0 / sphere.plane_strain_modulus() + 1.0 / half_space.plane_strain_modulus());
        let yield_strength = Some(10_f64.powf(log_strength) * e_star);
        Scene { sphere, half_space, yield_strength, exponent, ..Scene::steel() }.law()
    });
    prop_oneof![8 => plm, 1 => Just(Law::hertz()), 1 => Just(kinked_law())]
}

proptest! {
    #![proptest_config(crate::common::cases(200))]

    #[test]
    fn a_batch_gives_the_bits_of_rk8_in_the_order_of_its_cases(
        laws in prop::collection::vec(any_law(), 2..6),
        log_speeds in prop::collection::vec(-1.0..4.0_f64, SIZES[4]),
        size in prop::sample::select(SIZES.to_vec()),
        tolerance in prop::sample::select(TOLERANCES.to_vec()),
    ) {
        let speeds = log_speeds.iter().map(|log| 10_f64.powf(*log));
        let of_law = |(law, speed)| (law, speed, ScaledForces::NONE);
        let cases: Vec<Problem> = laws.iter().cycle().zip(speeds).map(of_law).take(size).collect();
        let got = together(&cases, tolerance);
        prop_assert_eq!(got.len(), size);
        for (i, (got, want)) in got.into_iter().zip(alone(&cases, tolerance)).enumerate() {
            prop_assert!(got.is_ok(), "case {} of {}: {:?}", i, size, got);
            prop_assert_eq!(got, want, "case {} of {}, q = {}", i, size, cases[i].1);
        }
    }
}

#[test]
fn every_size_meets_every_tolerance() {
    let plm = |exponent| Scene { exponent, ..Scene::steel() }.law();
    let laws = [plm(UnloadingExponent::Paper), plm(UnloadingExponent::PressureShape), Law::hertz(), kinked_law()];
    for size in SIZES {
        // all cases differ, and neighbours differ much: some lanes take ten times as many steps as others
        #[allow(clippy::cast_precision_loss)]
        let speed = |i: usize| 1.37_f64.powi(i32::try_from(i * 7 % 29).unwrap()) * (1.0 + 1e-3 * i as f64);
        let cases: Vec<Problem> = (0..size).map(|i| (&laws[i % laws.len()], speed(i), ScaledForces::NONE)).collect();
        for tolerance in TOLERANCES {
            assert_eq!(together(&cases, tolerance), alone(&cases, tolerance), "{size} cases at {tolerance:e}");
        }
    }
}

/// Random forces: no damping or damping of both kinds, also far beyond critical; no weight, a small weight, and a
/// weight that captures the sphere.
fn any_forces() -> impl Strategy<Value = ScaledForces> {
    let damping = prop_oneof![
        1 => Just(None),
        1 => Just(Some(Damping::Viscous(0.0))),
        3 => (-3.0..0.7_f64).prop_map(|log| Some(Damping::HuntCrossley(10_f64.powf(log)))),
        6 => (-3.0..0.5_f64).prop_map(|log| Some(Damping::Viscous(10_f64.powf(log)))),
    ];
    let weight = prop_oneof![Just(0.0), (-6.0..-2.0_f64).prop_map(|log| 10_f64.powf(log)), 0.01..3.0_f64];
    (weight, damping).prop_map(|(weight, damping)| ScaledForces { weight, damping })
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    #[test]
    fn a_damped_batch_gives_the_bits_of_the_stepper_in_the_order_of_its_cases(
        laws in prop::collection::vec(any_law(), 2..6),
        forces in prop::collection::vec(any_forces(), SIZES[4]),
        log_speeds in prop::collection::vec(-2.0..3.0_f64, SIZES[4]),
        size in prop::sample::select(SIZES.to_vec()),
        tolerance in prop::sample::select(TOLERANCES.to_vec()),
    ) {
        let speeds = log_speeds.iter().map(|log| 10_f64.powf(*log));
        let cases: Vec<Problem> =
            laws.iter().cycle().zip(speeds).zip(forces).map(|((law, q), forces)| (law, q, forces)).take(size).collect();
        let (got, want) = (together(&cases, tolerance), alone(&cases, tolerance));
        prop_assert_eq!(got.len(), size);
        for (i, (got, want)) in got.into_iter().zip(want).enumerate() {
            prop_assert_eq!(got, want, "case {} of {}: q = {}, {:?}", i, size, cases[i].1, cases[i].2);
        }
    }
}

/// All ways in which an impact can end, and all ways in which it can leave the lanes, in one batch.
#[test]
fn damped_lanes_meet_every_fate_and_every_kind_of_piece() {
    let plm = |exponent| Scene { exponent, ..Scene::steel() }.law();
    let laws = [plm(UnloadingExponent::Paper), plm(UnloadingExponent::PressureShape), Law::hertz(), kinked_law()];
    let dampings = [Damping::Viscous(0.05), Damping::Viscous(1.5), Damping::HuntCrossley(0.3), Damping::Viscous(0.0)];
    let mut cases = Vec::new();
    for law in &laws {
        for damping in dampings {
            for weight in [0.0, 1e-3, 0.3, 2.0] {
                for q in [0.1, 1.0, 7.0, 90.0] {
                    cases.push((law, q, ScaledForces { weight, damping: Some(damping) }));
                }
                if weight > 0.0 {
                    // released at rest
                    cases.push((law, 0.0, ScaledForces { weight, damping: Some(damping) }));
                }
            }
        }
    }
    let got = together(&cases, 1e-10);
    assert_eq!(got, alone(&cases, 1e-10));
    let fates = |fate| got.iter().flatten().filter(|(_, of)| *of == fate).count();
    assert!(fates(Fate::Captured) > 40 && fates(Fate::Separated) > 100, "{}", fates(Fate::Captured));
}

/// Creeping for more steps than a leg may take gives the same error in lanes as alone.
#[test]
fn a_lane_that_only_creeps_gives_up_as_the_stepper_does() {
    let law = Law::hertz();
    // enough cases to fill the lanes, so that none is finished alone
    let cases = [(&law, 1.0, ScaledForces { weight: 0.1, damping: Some(Damping::Viscous(3000.0)) }); 5];
    let got = together(&cases, 1e-6);
    assert_eq!(got, alone(&cases, 1e-6));
    assert!(matches!(got[0], Err(IntegrationError::Creeping { .. })), "{:?}", got[0]);
}

#[test]
fn rows_with_damping_are_those_of_one_impact_at_a_time() {
    let contact = |forces| Scene::steel().contact().with_forces(forces);
    let contacts: Vec<Contact> = [
        Forces { gravity: None, damping: Some(Damping::Viscous(0.1)) },
        Forces { gravity: Some(9.81), damping: Some(Damping::Viscous(0.1)) },
        Forces { gravity: Some(9.81), damping: Some(Damping::Viscous(0.0)) },
        Forces { gravity: None, damping: Some(Damping::HuntCrossley(0.2)) },
        Forces { gravity: Some(1e5), damping: None },
        Forces::default(),
    ]
    .map(contact)
    .to_vec();
    let speeds = [0.0, 1e-200, 1e-3, 0.02, 0.5, 3.0, 20.0, 1e200];
    let impacts: Vec<(&Contact, f64)> =
        contacts.iter().flat_map(|contact| speeds.map(|speed| (contact, speed))).collect();
    for method in [Method::Rk8, Method::Auto] {
        let solver = Solver { method, tolerance: 1e-9, ..Solver::default() };
        let rows = Contact::essentials_together(&impacts, &solver);
        assert_eq!(rows.len(), impacts.len());
        for ((contact, speed), row) in impacts.iter().zip(rows) {
            assert_eq!(row, contact.essentials_by(*speed, &solver), "{:?} at {speed} by {method:?}", contact.forces());
        }
    }
}

fn rows(text: &str) -> Rows {
    let plan = Scenario::from_text("test", text, &[]).unwrap().plan().unwrap().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).rows(0..plan.count(), &mut rows);
    rows
}

/// Rows with damping share lanes if their contacts are computed in advance, but not if a key of the solver varies.
#[test]
fn damped_rows_in_lock_step_are_those_by_themselves() {
    let damped = format!("{STEEL}\n[damping]\nviscous = 0.1\n");
    let grid = r#"[sweep]
"damping.viscous" = [0, 0.05, 1.2]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 101 }
"#;
    for gravity in ["", "[gravity]\nacceleration = \"9.81 m/s^2\"\n"] {
        let together = rows(&format!("{damped}{gravity}{grid}")).results;
        let alone = rows(&format!("{damped}{gravity}{grid}\"solver.tolerance\" = [1e-10]\n")).results;
        assert_eq!(together.len(), 303);
        assert_eq!(together, alone);
    }
    let samples = "[monte_carlo]\nsamples = 100\nseed = 7\n\"impact.speed\" = { uniform = [\"1 mm/s\", \"5 m/s\"] }\n";
    let plan = Scenario::from_text("test", &format!("{damped}{samples}"), &[]).unwrap().plan().unwrap().unwrap();
    let contact = plan.scene.contact().unwrap();
    let rows = rows(&format!("{damped}{samples}"));
    for (speed, row) in rows.swept.iter().zip(&rows.results) {
        assert_eq!(row.unwrap(), contact.essentials_by(*speed, &plan.scene.solver).unwrap());
    }
}

/// A state of NaN gives the same error in lanes as alone, and does not change the other lanes.
#[test]
fn a_lane_whose_state_is_no_number_says_so() {
    let law = Scene::steel().law();
    let cases = [5.0, f64::NAN, 20.0].map(|speed| (&law, speed, ScaledForces::NONE));
    let got = together(&cases, 1e-9);
    assert!(matches!(got[1], Err(IntegrationError::NotFinite { .. })), "{:?}", got[1]);
    let want = alone(&cases, 1e-9);
    assert!(matches!(want[1], Err(IntegrationError::NotFinite { .. })), "{:?}", want[1]);
    assert_eq!((&got[0], &got[2]), (&want[0], &want[2]));
}
