//! The law as a force without motion: energy, stiffness, and no panic for any input.

use crate::common::prelude::*;

/// Energy is conserved. During loading, unloading and reloading, the work on the contact (trapezoids of the force) is
/// the stored energy plus the plastic work. At the peak and at the end both agree with the closed form.
#[test]
fn the_work_of_the_force_is_stored_or_taken_by_the_dent() {
    // the others have no loading curve
    let whole = LawChoice::all().into_iter().filter(LawChoice::has_loading);
    for law in whole.clone() {
        let contact = Scene::steel().contact_by(law.get());
        let exact = contact.closed_form(1.0).expect("an impact at 1 m/s");
        let deepest = exact.peak_indentation;
        let mut memory = Memory::default();
        let (mut work, mut last, mut plastic_so_far) = (0.0, (0.0, 0.0), 0.0);
        let turns = [0.0, 0.6 * deepest, 0.55 * deepest, deepest, 0.0];
        for (from, to) in turns.iter().zip(&turns[1..]) {
            for i in 1..=20_000 {
                let indentation = from + (to - from) * f64::from(i) / 20_000.0;
                let force = contact.force(indentation, &mut memory);
                work += 0.5 * (force + last.1) * (indentation - last.0);
                if indentation > last.0 {
                    assert_eq!(contact.force(indentation, &mut memory.clone()), force, "{law:?}: asked twice");
                }
                last = (indentation, force);
            }
            let ContactEnergy { stored, plastic } = contact.energy(last.0, last.1, &memory);
            let kinetic = 0.5 * contact.mass();
            assert!((stored + plastic - work).abs() < 2e-6 * kinetic, "{law:?}: {stored} + {plastic} is not {work}");
            assert!(plastic >= plastic_so_far * (1.0 - 1e-12), "{law:?}: the dent gives back");
            plastic_so_far = plastic;
        }
        let kinetic = 0.5 * contact.mass();
        let restitution = (1.0 - plastic_so_far / kinetic).sqrt();
        assert!((restitution - exact.restitution).abs() < 1e-9, "{law:?}: e {restitution}, {}", exact.restitution);
        assert!((memory.force / exact.peak_force - 1.0).abs() < 1e-12, "{law:?}");
        assert!((memory.dent() - exact.residual_indentation).abs() < 1e-9 * deepest, "{law:?}");
    }
    assert!(whole.count() >= 10);
}

/// The stiffness is the derivative of the force (central difference), on both branches and on the curve of Hertz.
#[test]
fn the_stiffness_is_the_slope_of_the_force() {
    for strength in [Some(345e6), None] {
        let contact = Scene { yield_strength: strength, ..Scene::steel() }.contact();
        let mut memory = Memory::default();
        contact.force(2e-5, &mut memory);
        for (indentation, memory) in [(1e-8, Memory::default()), (3e-5, memory), (1.95e-5, memory)] {
            let step = 1e-6 * indentation;
            let force = |at: f64| contact.force(at, &mut memory.clone());
            let slope = (force(indentation + step) - force(indentation - step)) / (2.0 * step);
            let stiffness = contact.stiffness(indentation, &memory);
            assert!((stiffness / slope - 1.0).abs() < 1e-6, "{strength:?}, {indentation}: {stiffness}, {slope}");
        }
    }
}

/// A memory that was lost (NaN), or that no contact can have, is not taken for another one; and no indentation spoils a memory
/// for the steps after it.
#[test]
fn what_no_contact_can_have_gives_no_number_and_leaves_the_memory() {
    let hostile = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0, 5e-324, 1e-5, f64::MAX];
    for strength in [Some(345e6), None] {
        let contact = Scene { yield_strength: strength, ..Scene::steel() }.contact();
        for case in 0..hostile.len().pow(4) {
            let [indentation, a, b, c] =
                [0, 1, 2, 3].map(|place| hostile[case / hostile.len().pow(place) % hostile.len()]);
            let before = Memory { indentation: a, force: b, elastic_approach: c };
            let mut memory = before;
            let stiffness = contact.stiffness(indentation, &memory);
            let force = contact.force(indentation, &mut memory);
            let energy = contact.energy(indentation, force, &memory);
            let bits = |memory: Memory| [memory.indentation, memory.force, memory.elastic_approach].map(f64::to_bits);
            let is_possible = [a, b, c].iter().all(|part| *part >= 0.0) && c <= a;
            if !is_possible || ![indentation, a, b, c].iter().all(|given| given.is_finite()) {
                assert!(force.is_nan() && stiffness.is_nan() && energy.stored.is_nan() && energy.plastic.is_nan());
                assert_eq!(bits(memory), bits(before));
            } else if bits(memory) != bits(before) {
                assert!([memory.force, memory.elastic_approach].iter().all(|part| part.is_finite()), "{memory:?}");
            }
        }
    }
}

/// What an impact is warned of and where a code without impacts is told to warn are the same.
#[test]
fn an_impact_deeper_than_the_data_is_warned_of_and_no_other() {
    let is_of_depth = |warning: &Warning| match warning.kind {
        WarningKind::DeepDent | WarningKind::BeyondFlowCurve => true,
        WarningKind::OutsideStated => {
            // the indentation, and the lower end of the range
            let numbers: Vec<f64> = warning.to_string().split(' ').filter_map(|word| word.parse().ok()).collect();
            numbers[0] > numbers[1]
        }
        _ => false,
    };
    let (mut warned, mut not_warned) = (0, 0);
    let elastic = Scene { yield_strength: None, ..Scene::steel() };
    for (law, scene) in
        LawChoice::all().into_iter().map(|law| (law, Scene::steel())).chain([(LawChoice::default(), elastic)])
    {
        let (sphere, half_space) = scene.parts();
        let Ok(contact) = Contact::try_new(sphere, half_space, law.get()) else { continue };
        for step in 0..60 {
            let speed = 0.01 * 1.3_f64.powi(step);
            let Ok(impact) = contact.impact(speed, &Solver::AUTO, None) else {
                continue;
            };
            let is_deeper = impact.peak_indentation > contact.deepest();
            assert_eq!(
                impact.warnings.iter().any(is_of_depth),
                is_deeper,
                "{law:?} at {speed} m/s: {:?}",
                impact.warnings
            );
            *(if is_deeper { &mut warned } else { &mut not_warned }) += 1;
        }
    }
    assert!(warned > 50 && not_warned > 300, "{warned} {not_warned}");
}

#[test]
fn an_elastic_contact_needs_no_memory() {
    let contact = Scene { yield_strength: None, ..Scene::steel() }.contact();
    let mut memory = Memory::default();
    // on the way in, and back
    for indentation in [1e-6, 3e-5, 2e-5] {
        let force = contact.force(indentation, &mut memory);
        // Hertz: K δ^1.5, of which unloading gives back (2/5) F δ
        assert!(off(force, contact.pair().hertz_stiffness() * indentation.powf(1.5)) < 1e-14);
        let energy = contact.energy(indentation, force, &memory);
        assert!(off(energy.stored, 0.4 * force * indentation) < 1e-14 && energy.plastic == 0.0);
        assert_eq!(memory, Memory::default());
    }
}
