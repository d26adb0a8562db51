//! The batch form of rk8 gives the bits of rk8 alone, whatever shares the lanes.

#![allow(clippy::unwrap_used)]

mod common;

use common::Scene;
use plm_impact::bench::problems::kinked_law;
use plm_impact::impact::{Outcome, batch, course};
use plm_impact::integrate::IntegrationError;
use plm_impact::integrate::rk8::Rk8;
use plm_impact::law::{Law, UnloadingExponent};
use plm_impact::material::Material;
use proptest::prelude::*;

/// None, one, one less and one more than the lanes of an instruction set with 32 of them, many.
const SIZES: [usize; 5] = [0, 1, 31, 33, 200];
const TOLERANCES: [f64; 3] = [1e-4, 1e-10, 1e-13];

type Bits = Result<[u64; 7], IntegrationError>;

fn bits(outcome: Result<Outcome, IntegrationError>) -> Bits {
    outcome.map(|Outcome { unloading, restitution, loading_time, contact_time }| {
        let peak = unloading.peak;
        [
            peak.indentation,
            peak.force,
            peak.elastic_approach,
            unloading.exponent,
            restitution,
            loading_time,
            contact_time,
        ]
        .map(f64::to_bits)
    })
}

fn alone(law: &Law, speed: f64, tolerance: f64) -> Bits {
    bits(course::integrate(law, speed, &mut Rk8::new(tolerance), None))
}

fn together(cases: &[(&Law, f64)], tolerance: f64) -> Vec<Bits> {
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
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_batch_gives_the_bits_of_rk8_in_the_order_of_its_cases(
        laws in prop::collection::vec(any_law(), 2..6),
        log_speeds in prop::collection::vec(-1.0..4.0_f64, SIZES[4]),
        size in prop::sample::select(SIZES.to_vec()),
        tolerance in prop::sample::select(TOLERANCES.to_vec()),
    ) {
        let speeds = log_speeds.iter().map(|log| 10_f64.powf(*log));
        let cases: Vec<(&Law, f64)> = laws.iter().cycle().zip(speeds).take(size).collect();
        let got = together(&cases, tolerance);
        prop_assert_eq!(got.len(), size);
        for (i, ((law, speed), got)) in cases.iter().zip(got).enumerate() {
            prop_assert!(got.is_ok(), "case {} of {}: {:?}", i, size, got);
            prop_assert_eq!(got, alone(law, *speed, tolerance), "case {} of {}, q = {}", i, size, speed);
        }
    }
}

#[test]
fn every_size_meets_every_tolerance() {
    let plm = |exponent| Scene { exponent, ..Scene::steel() }.law();
    let laws = [plm(UnloadingExponent::Paper), plm(UnloadingExponent::PressureShape), Law::hertz(), kinked_law()];
    for size in SIZES {
        // no two cases alike, and neighbours far apart: some lanes take ten times the steps of others
        #[allow(clippy::cast_precision_loss)]
        let speed = |i: usize| 1.37_f64.powi(i32::try_from(i * 7 % 29).unwrap()) * (1.0 + 1e-3 * i as f64);
        let cases: Vec<(&Law, f64)> = (0..size).map(|i| (&laws[i % laws.len()], speed(i))).collect();
        for tolerance in TOLERANCES {
            let want: Vec<Bits> = cases.iter().map(|(law, speed)| alone(law, *speed, tolerance)).collect();
            assert_eq!(together(&cases, tolerance), want, "{size} cases at {tolerance:e}");
        }
    }
}
