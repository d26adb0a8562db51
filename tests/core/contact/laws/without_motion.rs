//! The law without motion: steps of an indentation where it has no answer, and forces that no contact can have.

use plm_impact::impact::indentation::SetPoint::Indentation as To;

use crate::common::prelude::*;

fn contact_under_law(law: &LawChoice) -> StaticContact {
    let (sphere, half_space) = Scene::case_3().bodies();
    StaticContact::try_new(&sphere, &half_space, law.as_contact_law()).unwrap()
}

/// Between about 1.1 and 2.5 yield indentations the law of Stronge would give back more energy than it takes. A step
/// that ends there is refused by its number; a step that passes through is allowed.
#[test]
fn step_beyond_range_of_law_is_named() {
    let slow = contact_under_law(&LawChoice::from_name("stronge").unwrap());
    let length = slow.pair().yield_point.unwrap().indentation;
    let error = slow.indent(&[To(0.5 * length), To(1.5 * length)], None).unwrap_err();
    assert!(matches!(error, IndentationError::Outside { step: 2, .. }), "{error:?}");
    assert!(error.to_string().starts_with("step 2: the law is not defined"), "{error}");
    slow.indent(&[To(0.5 * length), To(30.0 * length)], Some(100)).unwrap();
    // a law without loading is refused
    let (sphere, half_space) = Scene::case_3().bodies();
    let brake = LawChoice::from_name("brake").unwrap();
    assert!(matches!(
        StaticContact::try_new(&sphere, &half_space, brake.as_contact_law()),
        Err(IndentationError::Law(_))
    ));
}

/// The force is 0 for δ ≤ 0, also of springs, whose loading begins with a slope.
#[test]
fn contact_has_no_stiffness_before_touch() {
    for law in ["plm", "hertz", "walton_braun", "mesarovic_johnson"] {
        let contact = contact(STEEL, &[format!("law={law}")]);
        let stiffness = |indentation| contact.stiffness(indentation, &Memory::default());
        assert_eq!([-1e-6, 0.0].map(stiffness), [0.0; 2], "{law}");
        assert!(stiffness(1e-9) > 0.0, "{law}");
    }
}

/// A memory that was lost (NaN), or that no contact can have, is not taken for another one; and no indentation spoils a memory
/// for the steps after it.
#[test]
fn invalid_memory_yields_nan_and_is_unchanged() {
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

/// The law itself, with which a contact computes its force: no number for the indentation is no force, and no new memory.
#[test]
fn indentation_nan_leaves_memory_of_law() {
    for (name, choice) in super::whole_laws() {
        let law = super::law_of(choice.as_contact_law());
        for memory in [None, Some(law.loaded_state(30.0))] {
            let (force, after) = law.force_and_memory(f64::NAN, memory);
            assert!(force.is_nan() && after == memory, "{name}: {force} {after:?}");
        }
    }
}
