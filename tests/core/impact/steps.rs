//! One call per contact and step, for codes that move the spheres: the same force, friction and energies as by the functions
//! of which each finds the branch anew.

use crate::common::prelude::*;
use crate::common::{NO_OVERRIDES, contact};

const STEEL: &str = r#"
sphere = { radius = "5 mm", youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = 7850 }
half_space = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, yield_strength = "345 MPa" }
impact = { speed = "3 m/s" }
"#;

/// Contacts of every kind of branch: powers, curves of their own, a metal that relaxes, springs, and Hertz alone.
fn contacts() -> Vec<(&'static str, Contact)> {
    let by_law = |name, law: &[&str]| (name, contact(STEEL, law));
    let elastic = STEEL.replace(r#", yield_strength = "345 MPa""#, "");
    let balls = STEEL.replace(r#""345 MPa""#, r#""345 MPa", radius = "3 mm", mass = "ball", density = 7850"#);
    let balls = balls.replace("density = 7850 }\nhalf", "density = 7850, yield_strength = \"345 MPa\" }\nhalf");
    let rated = STEEL.replace(r#""345 MPa""#, r#""345 MPa", rate = { johnson_cook = { c = 0.03 } }"#);
    vec![
        by_law("paper", NO_OVERRIDES),
        by_law("pressure shape", &["law.plm.unloading_exponent=\"pressure-shape\""]),
        ("balls", contact(&balls, &["law.plm.unloading_exponent=\"pressure-shape\""])),
        ("elastic", contact(&elastic, NO_OVERRIDES)),
        ("relaxing", contact(&rated, NO_OVERRIDES).at_speed(3.0).unwrap().into_owned()),
        by_law("thornton", &["law=\"thornton\""]),
        by_law("stronge", &["law=\"stronge\""]),
        by_law("mesarovic_johnson", &["law=\"mesarovic_johnson\""]),
    ]
}

/// Touches, loads, unloads to exactly 0, reloads beyond the largest indentation, turns at the largest one, and leaves.
fn path() -> impl Iterator<Item = f64> {
    const TURNS: [f64; 10] = [0.0, 1e-7, 0.0, 5e-8, 30e-6, 25e-6, 30e-6, 28e-6, 35e-6, -1e-6];
    let steps = |leg: &[f64]| {
        let (from, to) = (leg[0], leg[1]);
        (1..=50).map(move |step| from + (to - from) * f64::from(step) / 50.0)
    };
    std::iter::once(0.0).chain(TURNS.windows(2).flat_map(steps))
}

fn assert_near(got: f64, want: f64, size: f64, what: &str) {
    // ten rounding errors of the distance from the residual indentation
    assert!((got - want).abs() <= 1e-12 * want.abs() + 1e-13 * size, "{what}: {got} and not {want}");
}

#[test]
fn step_has_force_friction_and_energies_of_functions() {
    for (name, contact) in contacts() {
        let (mut memory, mut friction) = (Memory::default(), [0.0; 3]);
        let (mut history, mut of_steps) = (ContactHistory::default(), [0.0; 3]);
        // with energies in every step, and in the steps of the last unloading alone
        let (mut sparse, mut of_sparse) = (ContactHistory::default(), [0.0; 3]);
        let mut largest = 0.0_f64;
        let n = path().count();
        for (number, indentation) in path().enumerate() {
            let what = format!("{name}, step {number}");
            let (previous_indentation, before, sparse_before) = (history.indentation, history, sparse);
            let is_unloaded = indentation < memory.indentation;
            let force = contact.force(indentation, &mut memory);
            let slip = [2e-8, if number < n / 2 { 1e-8 } else { -3e-8 }, 0.0];
            let step = FrictionStep { previous_indentation, indentation, force, slip };
            assert!(contact.friction(0.2, &step, &memory, &mut friction));
            let mut without_friction = [0.0; 3];
            assert!(contact.friction(0.0, &step, &memory, &mut without_friction) && without_friction == [0.0; 3]);
            let energy = contact.energy(indentation, force, &memory);

            assert!(contact.step(indentation, &mut history), "{what}");
            assert!(contact.friction_after_step(0.2, &before, &history, &slip, &mut of_steps), "{what}");
            let stored = contact.stored_energy(&mut history);
            largest = largest.max(force);
            assert_eq!(history.memory, memory, "{what}");
            assert_near(history.force, force, largest, &what);
            for (got, want) in of_steps.iter().zip(friction) {
                assert_near(*got, want, largest, &what);
            }
            let work = largest * 35e-6;
            assert_near(stored, energy.stored, work, &what);
            assert_near(history.plastic_work, energy.plastic, work, &what);

            assert!(contact.step(indentation, &mut sparse));
            assert_eq!(sparse.force, history.force, "{what}");
            assert!(contact.friction_after_step(0.2, &sparse_before, &sparse, &slip, &mut of_sparse), "{what}");
            for (got, want) in of_sparse.iter().zip(friction) {
                assert_near(*got, want, largest, &what);
            }
            if is_unloaded {
                assert_near(sparse.plastic_work, energy.plastic, work, &what);
            }
            if number > n - 40 {
                assert_eq!(contact.stored_energy(&mut sparse), stored, "{what}");
                assert_eq!(sparse, history, "{what}");
            }
            // the setup of a run asks again
            for history in [&mut history, &mut sparse] {
                let again = *history;
                assert!(contact.step(indentation, history) && *history == again, "{what}");
            }
        }
        assert_eq!(history.force, 0.0, "{name}: has left");
    }
}

/// A memory may lose digits in a text file, but its numbers belong together.
#[test]
fn contact_accepts_its_own_memory_alone() {
    for (name, contact) in contacts() {
        let mut memory = Memory::default();
        assert!(contact.accepts(&memory), "{name}");
        // no path leads to a largest indentation without force
        for indentation in [-1e-6, f64::NAN, 30e-6] {
            let without_force = Memory { indentation, ..Memory::default() };
            assert!(!contact.accepts(&without_force), "{name}: {indentation}");
        }
        contact.force(30e-6, &mut memory);
        let is_elastic = memory == Memory::default();
        assert_eq!(is_elastic, name == "elastic");
        // no path of an elastic contact leads to a memory
        if is_elastic {
            memory = Memory { indentation: 30e-6, force: contact.force(30e-6, &mut memory), elastic_approach: 30e-6 };
        }
        for (change, is_small) in
            [(0.0, true), (5e-7, true), (-5e-7, true), (2e-6, false), (-2e-6, false), (-0.9, false)]
        {
            let Memory { force, elastic_approach, .. } = memory;
            let of_force = Memory { force: force * (1.0 + change), ..memory };
            let of_approach = Memory { elastic_approach: elastic_approach * (1.0 + change), ..memory };
            for changed in [of_force, of_approach] {
                assert_eq!(contact.accepts(&changed), is_small && !is_elastic, "{name}: {changed:?}");
            }
        }
    }
}

#[test]
fn bad_step_changes_nothing() {
    let contact = contact(STEEL, NO_OVERRIDES);
    let mut history = ContactHistory::default();
    assert!(contact.step(2e-5, &mut history) && contact.step(1.9e-5, &mut history));
    let kept = history;
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!contact.step(wrong, &mut history) && history == kept);
        for part in 0..3 {
            let mut lost = kept;
            let Memory { indentation, force, elastic_approach } = &mut lost.memory;
            *[indentation, force, elastic_approach][part] = wrong;
            assert!(!contact.step(1.8e-5, &mut lost), "{part}");
            let (mut slip, mut friction) = ([1e-8; 3], [0.1; 3]);
            slip[part] = wrong;
            assert!(!contact.friction_after_step(0.2, &kept, &kept, &slip, &mut friction) && friction == [0.1; 3]);
            friction[part] = wrong;
            assert!(!contact.friction_after_step(0.2, &kept, &kept, &[1e-8; 3], &mut friction));
        }
        assert!(!contact.friction_after_step(wrong, &kept, &kept, &[1e-8; 3], &mut [0.1; 3]));
    }
    assert!(!contact.friction_after_step(-0.1, &kept, &kept, &[1e-8; 3], &mut [0.1; 3]));
}
