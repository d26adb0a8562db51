//! The work of rk8 for fixed impacts. An unintended change of its step control or its landings shows here.
//!
//! The numbers were measured. Without drag there are eight evaluations for each step, accepted or not, and one at the
//! beginning of each leg. Under drag there are twelve, and as many for each repeat of a step that ends on an event. If
//! you change the step control, these numbers change: check first with `plm-impact bench` that the change is better.

use plm_impact::bench::problems::{Problem, problems};
use plm_impact::impact::{Damping, ScaledForces, course};
use plm_impact::integrate::damped::Damped;
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
    // one impact has so few steps that a small change may not show; a hundred tolerances have many steps
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

#[test]
fn rk8_under_drag_takes_the_steps_it_took() {
    let wants = [
        ("P2", Damping::Viscous(0.1), Work { steps: 24, rejected: 5, force_evaluations: 423 }),
        ("P2", Damping::Viscous(0.5), Work { steps: 21, rejected: 6, force_evaluations: 399 }),
        ("P2", Damping::HuntCrossley(0.1), Work { steps: 38, rejected: 4, force_evaluations: 579 }),
        ("deep", Damping::Viscous(0.1), Work { steps: 37, rejected: 3, force_evaluations: 671 }),
    ];
    for (name, damping, want) in wants {
        let (problem, mut damped) = (problem(name), Damped::new(1e-9));
        let forces = ScaledForces { weight: 0.0, damping: Some(damping) };
        course::integrate(&problem.law, problem.speed, &forces, &mut damped, None).unwrap();
        assert_eq!(damped.work(), want, "{name} {damping:?}");
    }
}
