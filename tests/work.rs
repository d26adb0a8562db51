//! What rk8 spends on fixed impacts. A silent change of its step control shows here.
//!
//! The numbers were measured: eight evaluations a step, accepted or not, and one where each leg begins. Whoever changes
//! the step control changes them: let `plm-impact bench` say first whether for the better.

#![allow(clippy::unwrap_used)]

use plm_impact::bench::problems::{Problem, problems};
use plm_impact::impact::{ScaledForces, course};
use plm_impact::integrate::rk8::Rk8;
use plm_impact::integrate::{Integrator, Work};

fn problem(name: &str) -> Problem {
    problems().unwrap().into_iter().find(|problem| problem.name == name).unwrap()
}

fn work(problem: &Problem, tolerance: f64) -> Work {
    let mut rk8 = Rk8::new(tolerance);
    course::integrate(&problem.law, problem.speed, &ScaledForces::NONE, &mut rk8, None).unwrap();
    rk8.work()
}

#[test]
fn rk8_takes_the_steps_it_took() {
    let wants = [
        ("P2", Work { steps: 17, rejected: 0, force_evaluations: 139 }),
        ("deep", Work { steps: 25, rejected: 0, force_evaluations: 211 }),
    ];
    for (name, want) in wants {
        assert_eq!(work(&problem(name), 1e-9), want, "{name}");
    }
}

#[test]
fn rk8_takes_the_steps_it_took_over_the_tolerances() {
    // one impact has so few steps that a small change need not show; a hundred tolerances have many
    let wants = [
        ("P2", Work { steps: 1748, rejected: 14, force_evaluations: 14_396 }),
        ("deep", Work { steps: 2485, rejected: 0, force_evaluations: 20_980 }),
    ];
    for (name, want) in wants {
        let problem = problem(name);
        let mut total = Work::default();
        for tenths in 30..130 {
            let one = work(&problem, 10_f64.powf(-0.1 * f64::from(tenths)));
            total.steps += one.steps;
            total.rejected += one.rejected;
            total.force_evaluations += one.force_evaluations;
        }
        assert_eq!(total, want, "{name}");
    }
}
