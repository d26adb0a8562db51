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

proptest! {
    #![proptest_config(crate::common::cases(60))]

    /// To the last bit, but for the drift of the energy, which a trace follows. `work` is that of the impact: once the samples of
    /// a trace and a second run to first yield were counted, 10 762 evaluations by dop853 in place of 797.
    #[test]
    fn a_trace_changes_neither_the_work_nor_the_result(scene in any_scene(), log_speed in -0.5..3.0_f64, which in 0..5_usize) {
        let contact = scene.contact();
        let log_speed = if which == 0 { 2.0 * log_speed - 2.0 } else { log_speed };
        let speed = contact.yield_speed().unwrap() * 10_f64.powf(log_speed);
        let damping = [None, None, Some(Damping::HuntCrossley(0.1 / speed)), Some(Damping::Viscous(0.1)), Some(Damping::Viscous(0.2))];
        let forces = Forces { gravity: [1, 4].contains(&which).then_some(9.81), damping: damping[which], ..Forces::default() };
        let contact = contact.with_forces(forces);
        for method in [Method::Rk8, Method::Dopri5, Method::Dop853, Method::Verlet] {
            let with = |samples| contact.impact(speed, &solver(method, 1e-8), samples).map(|mut impact| {
                impact.energy.drift = 0.0;
                impact.warnings.clear();
                impact.trace.clear();
                format!("{impact:?}")
            });
            prop_assert_eq!(with(Some(30)), with(None));
        }
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
