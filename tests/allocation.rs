//! Computing an impact allocates no memory on the heap.

#![allow(clippy::unwrap_used)]

mod common;

use std::hint::black_box;

use allocation_counter::measure;
use common::Scene;
use plm_impact::contact::law::{Law, UnloadingExponent};
use plm_impact::impact::ScaledForces;
use plm_impact::impact::solve::{closed_form, motion};
use plm_impact::numerics::ode::DampingCoefficients;
use plm_impact::numerics::ode::Integrator;
use plm_impact::numerics::ode::rk8::Rk8;

/// Three cases: elastic; deep, beyond every knot of the law; an unloading exponent without a simple formula.
fn cases() -> [(&'static str, Law, f64); 3] {
    let pressure_shape = Scene { exponent: UnloadingExponent::PressureShape, ..Scene::steel() };
    [
        ("elastic", Law::hertz(), 1.0),
        ("deep", Scene::steel().law(), 1000.0),
        ("pressure-shape", pressure_shape.law(), 100.0),
    ]
}

#[test]
fn allocation_counter_counts() {
    let counted = measure(|| drop(black_box(Vec::<f64>::with_capacity(10))));
    assert_eq!((counted.count_total, counted.bytes_total), (1, 80));
}

#[test]
fn impacts_allocate_nothing() {
    for (name, law, speed) in cases() {
        // the first one makes the series of the law
        let mut outcome = closed_form::solve(&law, speed);
        let counted = measure(|| outcome = closed_form::solve(black_box(&law), speed));
        assert_eq!(counted.count_total, 0, "{name}");
        assert!(outcome.restitution > 0.0, "{name}");
        let none = DampingCoefficients::NONE;
        let drags = [
            none,
            DampingCoefficients { viscous: 0.2, ..none },
            DampingCoefficients { hunt_crossley: 0.1 / speed, ..none },
            DampingCoefficients { viscoelastic: 0.1, ..none },
        ];
        for (damping, weight) in drags.into_iter().flat_map(|drag| [(drag, 0.0), (drag, 0.5)]) {
            let forces = ScaledForces { weight, damping };
            for tolerance in [1e-3, 1e-9, 1e-13] {
                let mut stepper = Rk8::new(tolerance);
                let counted = measure(|| {
                    black_box(closed_form::solve_conservative(black_box(&law), speed, &forces, 1e-10)).unwrap();
                    motion::integrate(&law, speed, &forces, &mut stepper, None).unwrap();
                });
                assert_eq!(counted.count_total, 0, "{name} {forces:?} at {tolerance:e}");
                assert!(stepper.stats().steps > 0, "{name} {forces:?} at {tolerance:e}");
            }
        }
    }
}
