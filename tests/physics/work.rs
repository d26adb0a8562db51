//! The work of rk8 for fixed impacts. An unintended change of its step control or its landings shows here.
//!
//! The numbers were measured. Without drag there are eight evaluations for each step, accepted or not, and one at the
//! beginning of each leg. Under drag there are twelve, as many for each repeat of a step that ends on an event, and three for its continuous solution there. If
//! you change the step control, these numbers change: check first with `plm-impact bench` that the change is better.

use plm_impact::evidence::bench::problems::Problem;
use plm_impact::numerics::integrate::Effort;

use crate::common::prelude::*;

fn problem(name: &str) -> Problem {
    problems().unwrap().into_iter().find(|problem| problem.name == name).unwrap()
}

fn work(problem: &Problem, tolerance: f64) -> Effort {
    let mut rk8 = Rk8::new(tolerance);
    course::integrate(&problem.law, problem.speed, &ScaledForces::NONE, &mut rk8, &mut Recorder::default()).unwrap();
    rk8.work()
}

#[test]
fn rk8_takes_the_steps_it_took_over_the_tolerances() {
    // one impact has so few steps that a small change may not show; a hundred tolerances have many steps
    let wants = [
        ("P2", Effort { steps: 1748, rejected: 14, force_evaluations: 14_396 }),
        ("deep", Effort { steps: 3899, rejected: 0, force_evaluations: 33_792 }),
    ];
    for (name, want) in wants {
        let problem = problem(name);
        let mut total = Effort::default();
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
        ("P2", Damping::Viscous(0.1), Effort { steps: 17, rejected: 3, force_evaluations: 252 }),
        ("P2", Damping::Viscous(0.5), Effort { steps: 14, rejected: 3, force_evaluations: 216 }),
        ("P2", Damping::HuntCrossley(0.1), Effort { steps: 37, rejected: 4, force_evaluations: 522 }),
        ("deep", Damping::Viscous(0.1), Effort { steps: 38, rejected: 2, force_evaluations: 239 }),
    ];
    for (name, damping, want) in wants {
        let (problem, mut damped) = (problem(name), DragStepper::new(1e-9));
        let forces = ScaledForces { drag: damping.drag(1.0), ..ScaledForces::NONE };
        course::integrate(&problem.law, problem.speed, &forces, &mut damped, &mut Recorder::default()).unwrap();
        assert_eq!(damped.work(), want, "{name} {damping:?}");
    }
}

/// The continuous solution costs three evaluations a step of twelve, and no second run.
#[test]
fn a_damped_impact_takes_less_than_600_evaluations() {
    let contact =
        Scene::steel().contact().with_forces(Forces { damping: Some(Damping::Viscous(0.1)), ..Forces::default() });
    let work = contact.impact(20.0, &solver(Method::Rk8, 1e-10), Some(400)).unwrap().work;
    assert!(work.force_evaluations < 600, "{work:?}");
}
