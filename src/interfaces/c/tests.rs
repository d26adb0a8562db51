//! The functions for C with every argument that is no number, and with NULL. Miri runs these tests in .ci/release-checks, and
//! sees every access to memory.

use std::ptr::{null, null_mut};

use super::balls::{
    plm_contact_between, plm_contact_of_one_material, plm_contact_reduced_mass, plm_contact_time,
    plm_contact_time_of_mass,
};
use super::step::{plm_contact_step, plm_history};
use super::*;

const STEEL: &CStr = c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3.45e8 }
";
const WRONG: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const DEPTH: f64 = 2e-5;

/// A contact, and the memory and the force of a loading to [`DEPTH`].
fn loaded() -> (*mut plm_contact, [f64; 3], f64) {
    let mut memory = [0.0; 3];
    // SAFETY: the text ends with a zero, and the memory has three doubles
    unsafe {
        let contact = plm_contact_from_toml(STEEL.as_ptr(), null_mut(), 0);
        let force = plm_contact_force(contact, DEPTH, memory.as_mut_ptr());
        assert!(force > 0.0 && memory[0] == DEPTH && memory[1] == force && memory[2] > 0.0);
        (contact, memory, force)
    }
}

#[test]
fn an_argument_that_is_no_number_gives_none() {
    let (contact, memory, force) = loaded();
    for wrong in WRONG {
        // SAFETY: the contact is freed below; all arrays have three doubles
        unsafe {
            let mut kept = memory;
            assert!(plm_contact_force(contact, wrong, kept.as_mut_ptr()).is_nan() && kept == memory);
            assert!(plm_contact_stiffness(contact, wrong, kept.as_ptr()).is_nan());
            for (depth, force) in [(wrong, force), (DEPTH, wrong)] {
                let mut plastic = 1.0;
                assert!(plm_contact_energy(contact, depth, force, kept.as_ptr(), &raw mut plastic).is_nan(), "{wrong}");
                assert!(plastic.is_nan());
            }
            let mut restitution = 1.0;
            assert!(plm_contact_time(contact, wrong, &raw mut restitution).is_nan() && restitution.is_nan());
            assert!(plm_contact_restitution_with_waves(contact, wrong).is_nan());
            for part in 0..3 {
                let mut lost = memory;
                lost[part] = wrong;
                assert!(plm_contact_force(contact, DEPTH, lost.as_mut_ptr()).is_nan());
                assert!(plm_contact_stiffness(contact, DEPTH, lost.as_ptr()).is_nan());
                assert!(plm_contact_energy(contact, DEPTH, force, lost.as_ptr(), null_mut()).is_nan());
                let (mut slip, mut history) = ([1e-8, 0.0, 0.0], [0.0; 3]);
                let mut friction = |slip: &[f64; 3], memory: &[f64; 3]| {
                    plm_contact_friction(
                        contact,
                        0.2,
                        DEPTH,
                        DEPTH,
                        force,
                        memory.as_ptr(),
                        slip.as_ptr(),
                        history.as_mut_ptr(),
                    )
                };
                assert_eq!(friction(&slip, &lost), FAILURE);
                slip[part] = wrong;
                assert_eq!(friction(&slip, &memory), FAILURE);
                assert_eq!(history, [0.0; 3]);
            }
            let numbers = [(wrong, DEPTH, DEPTH, force), (0.2, wrong, DEPTH, force), (0.2, DEPTH, wrong, force)];
            for (coefficient, before, depth, force) in [numbers.as_slice(), &[(0.2, DEPTH, DEPTH, wrong)]].concat() {
                let (slip, mut history) = ([1e-8, 0.0, 0.0], [0.0; 3]);
                let result = plm_contact_friction(
                    contact,
                    coefficient,
                    before,
                    depth,
                    force,
                    memory.as_ptr(),
                    slip.as_ptr(),
                    history.as_mut_ptr(),
                );
                assert_eq!((result, history), (FAILURE, [0.0; 3]));
            }
            let (mut memories, mut forces) = ([0.0; 6], [0.0; 2]);
            let result =
                plm_contact_forces(contact, 2, [wrong, DEPTH].as_ptr(), memories.as_mut_ptr(), forces.as_mut_ptr());
            assert_eq!(result, FAILURE);
            assert!(forces[0].is_nan() && forces[1] == force && memories[..3] == [0.0; 3] && memories[3..] == memory);
        }
    }
    // SAFETY: not used afterwards
    unsafe { plm_contact_free(contact) };
}

#[test]
fn no_contact_gives_no_number() {
    let (mut memory, mut history) = ([0.0; 3], [0.0; 3]);
    // SAFETY: every function takes NULL
    unsafe {
        assert!(plm_contact_force(null(), DEPTH, memory.as_mut_ptr()).is_nan());
        assert!(plm_contact_stiffness(null(), DEPTH, memory.as_ptr()).is_nan());
        assert!(plm_contact_energy(null(), DEPTH, 1.0, memory.as_ptr(), null_mut()).is_nan());
        assert_eq!(plm_contact_forces(null(), 1, null(), null_mut(), null_mut()), FAILURE);
        let slip = [0.0; 3];
        let friction =
            plm_contact_friction(null(), 0.2, 0.0, DEPTH, 1.0, memory.as_ptr(), slip.as_ptr(), history.as_mut_ptr());
        assert_eq!(friction, FAILURE);
        let numbers = [
            plm_contact_radius(null()),
            plm_contact_effective_radius(null()),
            plm_contact_mass(null()),
            plm_contact_yield_speed(null()),
            plm_contact_validated_indentation(null()),
            plm_contact_time(null(), 1.0, null_mut()),
            plm_contact_time_of_mass(null(), 1.0, 1.0, null_mut()),
            plm_contact_reduced_mass(null()),
            plm_contact_restitution_with_waves(null(), 1.0),
        ];
        assert!(numbers.into_iter().all(f64::is_nan));
        assert_eq!(plm_contact_fingerprint(null()), 0);
        assert!(plm_contact_between(null(), 1e-3, 1e-3).is_null());
        assert!(plm_contact_of_one_material(null(), null_mut(), 0).is_null());
        plm_contact_free(null_mut());
    }
}

#[test]
fn an_error_fits_into_its_room() {
    for length in [0, 1, 2, 9, 400] {
        let mut error = vec![c_char::MAX; 400];
        // SAFETY: the texts end with a zero, and the error has 400 bytes
        unsafe {
            assert!(plm_contact_from_toml(c"sphere = { radius = -1 }".as_ptr(), error.as_mut_ptr(), length).is_null());
            assert!(plm_contact_from_toml(c"\xff".as_ptr(), error.as_mut_ptr(), length).is_null());
        }
        let end = error[..length].iter().position(|byte| *byte == 0);
        assert_eq!(end.is_some(), length > 0);
        assert!(error[length..].iter().all(|byte| *byte == c_char::MAX));
    }
}

#[test]
fn one_strength_becomes_that_of_both() {
    let [with_sphere, both] = [
        c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3.45e8 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3 }
",
        c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3.45e8 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3.45e8 }
",
    ];
    let different = c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3e8 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3, yield_strength = 3.45e8 }
";
    let hardening = c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3, yield_strength = 3.45e8, flow_stress = { power = { exponent = 0.2 } } }
";
    // SAFETY: the texts end with a zero, and every contact is freed
    unsafe {
        let restitutions = [STEEL, with_sphere, both].map(|text| {
            let given = plm_contact_from_toml(text.as_ptr(), null_mut(), 0);
            let alike = plm_contact_of_one_material(given, null_mut(), 0);
            let balls = plm_contact_between(alike, 5e-3, 5e-3);
            let mut restitution = 0.0;
            plm_contact_time(balls, 1.0, &raw mut restitution);
            for contact in [given, alike, balls] {
                plm_contact_free(contact);
            }
            restitution
        });
        // two equal balls are one on a rigid wall at half the speed
        let rigid = c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = 3.45e8 }
half_space = { youngs_modulus = 2.1e18, poissons_ratio = 0.3 }
";
        let rigid = plm_contact_from_toml(rigid.as_ptr(), null_mut(), 0);
        let mut on_rigid_wall = 0.0;
        plm_contact_time(rigid, 0.5, &raw mut on_rigid_wall);
        plm_contact_free(rigid);
        for restitution in restitutions {
            assert!((restitution - on_rigid_wall).abs() < 1e-6, "{restitution} {on_rigid_wall}");
        }
        for (text, words) in [(different, "different yield strengths"), (hardening, "flow curve")] {
            let mut error = vec![0 as c_char; 400];
            let given = plm_contact_from_toml(text.as_ptr(), null_mut(), 0);
            assert!(plm_contact_of_one_material(given, error.as_mut_ptr(), 400).is_null());
            assert!(CStr::from_ptr(error.as_ptr()).to_str().is_ok_and(|text| text.contains(words)));
            plm_contact_free(given);
        }
    }
}

#[test]
fn a_step_writes_all_or_nothing() {
    let (contact, memory, force) = loaded();
    let fresh = || plm_history { memory: [0.0; 3], exponent: 0.0, indentation: 0.0, force: 0.0, plastic: 0.0 };
    // SAFETY: the contact is freed below; all arrays have three doubles
    unsafe {
        let (mut history, mut friction, mut stored) = (fresh(), [0.0; 3], 0.0);
        let slip = [1e-8, 0.0, 0.0];
        let step = |depth: f64, history: *mut plm_history, coefficient, slip: *const f64, friction, stored| {
            plm_contact_step(contact, depth, history, coefficient, slip, friction, stored)
        };
        assert_eq!(step(DEPTH, &raw mut history, 0.2, slip.as_ptr(), friction.as_mut_ptr(), &raw mut stored), SUCCESS);
        assert!(history.memory == memory && history.force == force && history.indentation == DEPTH);
        let mut plastic = 0.0;
        let energy = plm_contact_energy(contact, DEPTH, force, memory.as_ptr(), &raw mut plastic);
        assert!((stored - energy).abs() < 1e-12 * energy && history.plastic == plastic && friction[0] < 0.0);
        // only one of slip and friction, a bad number, and no contact or history
        let kept = (history.memory, history.force, friction, stored);
        // one pointer for all steps, because a new mutable borrow would end it
        let given = friction.as_mut_ptr();
        for (depth, coefficient, slip, rubbed) in [
            (DEPTH, 0.2, null(), given),
            (DEPTH, 0.2, slip.as_ptr(), null_mut()),
            (f64::NAN, 0.2, slip.as_ptr(), given),
            (DEPTH, -0.2, slip.as_ptr(), given),
        ] {
            assert_eq!(step(depth, &raw mut history, coefficient, slip, rubbed, &raw mut stored), FAILURE);
        }
        assert_eq!(step(DEPTH, null_mut(), 0.2, null(), null_mut(), null_mut()), FAILURE);
        assert_eq!(plm_contact_step(null(), DEPTH, &raw mut history, 0.2, null(), null_mut(), null_mut()), FAILURE);
        assert_eq!((history.memory, history.force, friction, stored), kept);
        // without friction and energies
        let mut alone = fresh();
        assert_eq!(step(DEPTH, &raw mut alone, f64::NAN, null(), null_mut(), null_mut()), SUCCESS);
        assert!(alone.force == force && alone.exponent == 0.0);
        plm_contact_free(contact);
    }
}
