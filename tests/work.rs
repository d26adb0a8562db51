//! What rk8 spends on two fixed impacts. A silent change of its step control shows here.

#![allow(clippy::unwrap_used)]

use plm_impact::bench::problems::problems;
use plm_impact::impact::course;
use plm_impact::integrate::rk8::Rk8;
use plm_impact::integrate::{Integrator, Work};

#[test]
fn rk8_takes_the_steps_it_took() {
    // measured; eight evaluations a step and one where each leg begins. Whoever changes the step control changes these
    // numbers: let the bench say first whether for the better.
    let wants = [
        ("P2", Work { steps: 17, rejected: 0, force_evaluations: 139 }),
        ("deep", Work { steps: 25, rejected: 0, force_evaluations: 211 }),
    ];
    let problems = problems().unwrap();
    for (name, want) in wants {
        let problem = problems.iter().find(|problem| problem.name == name).unwrap();
        let mut rk8 = Rk8::new(1e-9);
        course::integrate(&problem.law, problem.speed, &mut rk8, None).unwrap();
        assert_eq!(rk8.work(), want, "{name}");
    }
}
