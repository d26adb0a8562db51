//! The integrators under drag, compared with the damped harmonic oscillator.

use plm_impact::impact::{Damping, ScaledForces, course};
use plm_impact::integrate::damped::Damped;
use plm_impact::integrate::library::{Library, Scheme};
use plm_impact::integrate::{Drag, Integrator, Landing, Leg, Path, Restoring, Sizes, State};
use plm_impact::law::Law;

/// An impact on a linear spring d'' = −ω² d − 2ζω d' at speed u: the states at the turning point and at lift-off.
fn spring(integrator: &mut dyn Integrator, omega: f64, zeta: f64, u: f64) -> (State, State, Landing) {
    let restoring = Restoring::Straight { at_start: 0.0, slope: omega * omega };
    let sizes = Sizes { distance: u / omega, speed: u };
    let drag = Drag { eta: 2.0 * zeta, ..Drag::NONE };
    let path = |leg| Path { restoring, leg, sizes, pull: 0.0, drag, rest: None };
    let mut state = State { time: 0.0, distance: 0.0, speed: u, loss: 0.0 };
    assert_eq!(
        integrator.traverse(&path(Leg::Outward(f64::INFINITY)), &mut state, None).unwrap().landing,
        Landing::Turning
    );
    let turned = state;
    let landing = integrator.traverse(&path(Leg::Back(0.0)), &mut state, None).unwrap();
    (turned, state, landing.landing)
}

#[test]
fn a_viscous_spring_follows_its_closed_form() {
    let (omega, u) = (3.0, 0.7);
    for zeta in [1e-3, 0.05, 0.3, 0.9, 0.999_f64] {
        // d = (u/ω_d) e^(−ζωt) sin ω_d t is at rest where tan ω_d t = ω_d/(ζω), that is at ω_d t = arccos ζ. On the way
        // back the force −d'' vanishes after the same time. Each way multiplies the speed by e^(−ζ arccos ζ/√(1−ζ²))
        let root = (1.0 - zeta * zeta).sqrt();
        let angle = f64::acos(zeta);
        let left = (-zeta * angle / root).exp();
        let time = angle / (omega * root);
        let mut own = Damped::new(1e-12);
        let mut five = Library::new(Scheme::Dopri5, 1e-12);
        let mut eight = Library::new(Scheme::Dop853, 1e-12);
        let all: [&mut dyn Integrator; 3] = [&mut own, &mut five, &mut eight];
        for integrator in all {
            let (turned, end, landing) = spring(integrator, omega, zeta, u);
            assert_eq!(landing, Landing::LiftOff);
            let near = |got: f64, want: f64| (got / want - 1.0).abs() < 1e-9;
            assert!(near(turned.time, time) && near(turned.distance, u / omega * left), "{zeta}");
            assert!(near(end.time, 2.0 * time) && near(end.speed, -u * left * left), "{zeta}");
            // lift-off: ω² d + 2ζω d' = 0
            assert!((omega * end.distance + 2.0 * zeta * end.speed).abs() < 1e-9 * u, "{zeta}");
            let [d, v] = [end.distance, end.speed];
            let ledger = 0.5 * v * v + 0.5 * omega * omega * d * d + end.loss;
            assert!(near(ledger, 0.5 * u * u), "{zeta}");
        }
    }
}

#[test]
fn critical_and_overdamped_springs_let_go_too() {
    for zeta in [1.0, 1.5, 10.0_f64] {
        let mut own = Damped::new(1e-11);
        let (_, end, landing) = spring(&mut own, 1.0, zeta, 1.0);
        assert_eq!(landing, Landing::LiftOff);
        // e^(−2ζ arcosh ζ/√(ζ²−1)), the same formula for ζ above 1; e^(−2) at 1
        let want = if zeta == 1.0 {
            (-2.0_f64).exp()
        } else {
            let root = (zeta * zeta - 1.0).sqrt();
            (-2.0 * zeta * zeta.acosh() / root).exp()
        };
        assert!((-end.speed / want - 1.0).abs() < 1e-9, "{zeta}: {} {want}", end.speed);
    }
}

#[test]
fn a_weakly_damped_hertz_contact_lets_go_where_its_force_vanishes() {
    // lift-off is where (5/4) d^1.5 = 2ζ √((5/4)(3/2) √d) u, with u = 1 near the end: d^(5/4) = 2ζ √1.875/1.25. It is
    // earlier by d than without damping, where it is at 2.9432751843247047
    let law = Law::hertz();
    for tenths in 60..160 {
        let zeta = 10_f64.powf(-0.1 * f64::from(tenths));
        let forces = ScaledForces { drag: Damping::Viscous(zeta).drag(1.0), ..ScaledForces::NONE };
        let distance = (2.0 * zeta * 1.875_f64.sqrt() / 1.25).powf(0.8);
        let want = 2.943_275_184_324_704_7 - distance;
        for tolerance in [1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13] {
            let outcome = course::integrate(&law, 1.0, &forces, &mut Damped::new(tolerance), None).unwrap();
            let miss = (outcome.contact_time / want - 1.0).abs();
            // the loss by damping is of order ζ
            assert!(miss < 10.0 * tolerance + 10.0 * zeta + 1e-10, "{zeta:e} at {tolerance:e}: {miss:e}");
        }
    }
}
