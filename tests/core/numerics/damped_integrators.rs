//! The integrators under drag, compared with the damped harmonic oscillator.

use plm_impact::impact::solve::motion;

use crate::common::prelude::*;
use plm_impact::numerics::curve::LoadingCurve;
use plm_impact::numerics::ode::ode_solvers::{OdeSolvers, Scheme};
use plm_impact::numerics::ode::{DampingCoefficients, ErrorScales, Leg, LegEnd, LegProblem, MotionState};

#[test]
fn damped_oscillator_follows_closed_form() {
    // d'' = −ω² d − (2ζω + θω²) d', θ of a plate: the turning point is that of the sum of both, with b = ζ + θω/2 at
    // ω t = arccos b/√(1 − b²), d = u/ω e^(−b ω t). The sphere lifts off where the force of spring and damper is gone
    let (omega, u) = (3.0, 0.7_f64);
    let near = |got: f64, want: f64| (got / want - 1.0).abs() < 1e-9;
    for (zeta, kappa, theta) in [
        (1e-3, 0.0, 0.0),
        (0.05, 0.0, 0.0),
        (0.3, 0.0, 0.0),
        (0.9, 0.0, 0.0),
        (0.999, 0.0, 0.0),
        (1.0, 0.0, 0.0),
        (1.5, 0.0, 0.0),
        (10.0, 0.0, 0.0),
        (0.1, 0.0, 0.05),
        (0.0, 1e-3, 0.0),
        (0.0, 0.2, 0.0),
        (0.0, 1.2, 0.0),
    ] {
        let curve = LoadingCurve::linear(omega * omega);
        let viscous = 2.0 * zeta;
        let drag = DampingCoefficients { viscous, viscoelastic: kappa, plate: theta, ..DampingCoefficients::NONE };
        let sizes = ErrorScales { distance: u / omega, speed: u };
        let path = |leg| LegProblem {
            piece: &curve.pieces()[0],
            factor: 1.0,
            leg,
            error_scales: sizes,
            constant_acceleration: 0.0,
            drag,
            rest: None,
        };
        let both: f64 = zeta + 0.5 * (kappa + theta) * omega;
        // beyond critical damping the functions are the hyperbolic ones
        let time = match both {
            b if b < 1.0 => b.acos() / (1.0 - b * b).sqrt(),
            b if b > 1.0 => b.acosh() / (b * b - 1.0).sqrt(),
            _ => 1.0,
        };
        let left = (-both * time).exp();
        let all: [Box<dyn Integrator>; 4] = [
            Box::new(DampedStepper::new(1e-12)),
            Box::new(Rk8::new(1e-12)),
            Box::new(OdeSolvers::new(Scheme::Dopri5, 1e-12)),
            Box::new(OdeSolvers::new(Scheme::Dop853, 1e-12)),
        ];
        // the methods of ode_solvers are not for such a drag
        for mut integrator in all.into_iter().take(if both < 1.0 { 4 } else { 2 }) {
            let mut state = MotionState { time: 0.0, distance: 0.0, speed: u, loss: 0.0 };
            let out = integrator.integrate_leg(&path(Leg::Loading(f64::INFINITY)), &mut state, None).unwrap();
            assert_eq!(out.end, LegEnd::Turning);
            assert!(near(state.distance, u / omega * left) && near(state.time, time / omega), "{zeta}");
            let back = integrator.integrate_leg(&path(Leg::Unloading(0.0)), &mut state, None).unwrap();
            assert_eq!(back.end, LegEnd::LiftOff);
            let MotionState { distance: d, speed: v, loss, .. } = state;
            // each way multiplies the speed alike where there is no plate
            assert!(theta > 0.0 || near(v, -u * left * left) && near(state.time, 2.0 * time / omega), "{zeta}");
            assert!((omega * d + (viscous + kappa * omega) * v).abs() < 1e-9 * u, "{zeta}");
            assert!(near(0.5 * v * v + 0.5 * omega * omega * d * d + loss, 0.5 * u * u), "{zeta}");
        }
    }
}

#[test]
fn weakly_damped_hertz_contact_separates_at_zero_force() {
    // lift-off is where (5/4) d^1.5 = 2ζ √((5/4)(3/2) √d) u, with u = 1 near the end: d^(5/4) = 2ζ √1.875/1.25. It is
    // earlier by d than without damping, where it is at 2.9432751843247047
    let law = Law::hertz();
    for tenths in 60..160 {
        let zeta = 10_f64.powf(-0.1 * f64::from(tenths));
        let forces = ScaledForces {
            damping: DampingCoefficients { viscous: 2.0 * zeta, ..DampingCoefficients::NONE },
            ..ScaledForces::NONE
        };
        let distance = (2.0 * zeta * 1.875_f64.sqrt() / 1.25).powf(0.8);
        let want = HERTZ_CONTACT_TIME - distance;
        for tolerance in [1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13] {
            let outcome = motion::integrate(&law, 1.0, &forces, &mut DampedStepper::new(tolerance), None).unwrap();
            let miss = (outcome.contact_time / want - 1.0).abs();
            // the loss by damping is of order ζ
            assert!(miss < 10.0 * tolerance + 10.0 * zeta + 1e-10, "{zeta:e} at {tolerance:e}: {miss:e}");
        }
    }
}
