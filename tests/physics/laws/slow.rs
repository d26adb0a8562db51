//! Slow indentation with every law: the same law as in an impact, without motion.

use plm_impact::impact::indentation::IndentationMemory as Largest;
use plm_impact::impact::indentation::Target::{Indentation as To, Load};

use super::{bodies, law_of, whole_laws};
use crate::common::prelude::*;

fn pressed(law: &LawChoice) -> StaticContact {
    let (sphere, half_space) = Scene::case_3().parts();
    let indenter = Indenter { radius: sphere.radius, material: sphere.material, yield_strength: None };
    StaticContact::try_new(indenter, &half_space, law.get()).unwrap()
}

/// A slow indentation to the peak indentation of an integrated impact: the force is that of the loading curve, and
/// unloading gives back the share e² of the work of loading.
#[test]
fn an_indentation_gives_back_what_the_impact_to_its_depth_does() {
    let scene = Scene::case_3();
    let point = bodies(&scene).yield_point;
    let yield_speed = scene.contact().yield_speed().unwrap();
    for (name, law) in whole_laws() {
        let (moving, slow) = (scene.contact_by(law.get()), pressed(&law));
        let mut compared = 0;
        for speed in [0.7, 20.0, 100.0].map(|times| times * yield_speed) {
            // outside the range of the law, both have no result
            let Ok(impact) = moving.impact(speed, &solver(Method::Rk8, 1e-12), None) else { continue };
            compared += 1;
            let steps = slow.indent(&[To(impact.peak_indentation), Load(0.0)], None).unwrap().steps;
            let [up, down] = steps[..] else { panic!("{name}") };
            let force = law_of(law.get()).loading.force(up.indentation / point.indentation) * point.force;
            assert!(off(up.force, force) < 1e-12, "{name} {speed}: {} {force}", up.force);
            assert!(off(up.force, impact.peak_force) < 1e-9, "{name} {speed}");
            let back = impact.restitution * impact.restitution;
            assert!(off(-down.work / up.work, back) < 2e-9, "{name} {speed}: {} {back}", -down.work / up.work);
            let dent = (up.memory.residual_indentation - impact.residual_indentation).abs();
            assert!(dent < 1e-9 * up.indentation, "{name} {speed}: {dent}");
        }
        assert!(compared > 0, "{name}");
    }
}

/// Unloading, and loading again to the same depth and beyond: no plastic work until the old peak, then the loading
/// curve.
#[test]
fn a_second_cycle_runs_back_up_the_branch_of_the_first() {
    for (name, law) in whole_laws() {
        let slow = pressed(&law);
        let length = slow.pair().yield_point.unwrap().indentation;
        let (once, twice) = (To(60.0 * length), To(90.0 * length));
        let run = |targets: &[_]| -> Indentation { slow.indent(targets, Some(40)).unwrap() };
        let cycles = run(&[once, Load(0.0), once, Load(0.0), twice, Load(0.0)]);
        let [first, down, again, _, deeper, last] = cycles.steps[..] else { panic!("{name}") };
        assert_eq!((again.plastic_work, again.memory), (0.0, first.memory), "{name}");
        assert!(off(again.force, first.force) < 1e-12 && off(again.work, -down.work) < 1e-12, "{name}");
        let straight = run(&[twice]).steps[0];
        let numbers = |of: &Largest| {
            [of.force, of.indentation, of.residual_indentation, of.unloading_stiffness, of.mean_pressure]
        };
        for (got, want) in numbers(&deeper.memory).into_iter().zip(numbers(&straight.memory)) {
            assert!((got - want).abs() <= 1e-13 * want.abs(), "{name}: {got:e} {want:e}");
        }
        let plastic: f64 = cycles.steps.iter().map(|step| step.plastic_work).sum();
        let work: f64 = cycles.steps.iter().map(|step| step.work).sum();
        assert!((plastic - straight.plastic_work).abs() < 1e-12 * straight.work, "{name}");
        // unloaded at the end, so the remaining work is plastic
        assert!((work - plastic).abs() < 1e-12 * straight.work && last.force == 0.0, "{name}: {work} {plastic}");
        let is_elastic = !slow.can_yield();
        assert_eq!(is_elastic, name.starts_with("hertz"));
        assert!(!is_elastic || cycles.trace.iter().all(|row| row.branch != Branch::Plastic), "{name}");
    }
}

/// Between about 1.1 and 2.5 yield indentations the law of Stronge would give back more energy than it takes. A step
/// that ends there is refused by its number; a step that passes through is allowed.
#[test]
fn a_step_that_ends_where_the_law_has_no_answer_is_named() {
    let slow = pressed(&LawChoice::from_name("stronge").unwrap());
    let length = slow.pair().yield_point.unwrap().indentation;
    let error = slow.indent(&[To(0.5 * length), To(1.5 * length)], None).unwrap_err();
    assert!(matches!(error, IndentationError::Outside { step: 2, .. }), "{error:?}");
    assert!(error.to_string().starts_with("step 2: the law has no answer"), "{error}");
    slow.indent(&[To(0.5 * length), To(30.0 * length)], Some(100)).unwrap();
    // a law without loading is refused
    let (sphere, half_space) = Scene::case_3().parts();
    let indenter = Indenter { radius: sphere.radius, material: sphere.material, yield_strength: None };
    let brake = LawChoice::from_name("brake").unwrap();
    assert!(matches!(StaticContact::try_new(indenter, &half_space, brake.get()), Err(IndentationError::Law(_))));
}
