//! A second ball and a curved wall: conservation, limits, and equal balls.

use plm_impact::contact::body::Support;
use plm_impact::impact::ImpactError;

use crate::common::prelude::*;

/// A steel ball, and a ball that it hits, by radius, strength and modulus.
fn balls(sphere: (f64, f64, f64), other: (f64, f64, f64), exponent: UnloadingExponent) -> Contact {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let (radius, strength, modulus) = sphere;
    let sphere = Sphere { yield_strength: Some(strength), ..Sphere::elastic(radius, material(modulus), 7850.0) };
    let (radius, strength, modulus) = other;
    let half_space = HalfSpace {
        density: Some(7850.0),
        radius: Some(radius),
        support: Support::Ball,
        ..HalfSpace::flat(material(modulus), Some(strength))
    };
    Contact::try_new(sphere, half_space, &Plm { exponent, ..Plm::default() }).unwrap()
}

const STEEL: (f64, f64, f64) = (5e-3, 345e6, 210e9);

/// By symmetry two equal balls meet as one of them meets a rigid wall at half the closing speed: at half the approach, with the same
/// force, time and contact radius.
#[test]
fn equal_balls_equal_rigid_wall_at_half_speed() {
    for exponent in [UnloadingExponent::Paper, UnloadingExponent::PressureShape] {
        let pair = balls(STEEL, STEEL, exponent);
        let wall = HalfSpace::flat(Material { youngs_modulus: 1e30, poissons_ratio: 0.3 }, None);
        let alone = Contact::try_new(*pair.sphere(), wall, &Plm { exponent, ..Plm::default() }).unwrap();
        for speed in [0.002, 0.02, 0.5, 3.0, 12.0] {
            let (two, one) = (pair.closed_form(speed).unwrap(), alone.closed_form(0.5 * speed).unwrap());
            for (what, got, want) in [
                ("e", two.row.restitution, one.row.restitution),
                ("time", two.row.contact_time, one.row.contact_time),
                ("force", two.row.peak_force, one.row.peak_force),
                ("approach", two.row.peak_indentation, 2.0 * one.row.peak_indentation),
                ("sphere", two.peak_sphere_indentation, one.row.peak_indentation),
                ("residual", two.row.residual_indentation, 2.0 * one.row.residual_indentation),
                ("radius", two.row.peak_contact_radius, one.row.peak_contact_radius),
                ("radius ratio", two.row.radius_ratio, one.row.radius_ratio),
                ("energy", two.row.kinetic_in, 2.0 * one.row.kinetic_in),
            ] {
                assert!((got - want).abs() <= 1e-12 * want.abs(), "{what} at {speed}: {got} {want}");
            }
        }
    }
}

/// Two balls, where either of them is the one that is hit.
#[test]
fn it_does_not_matter_which_ball_is_hit() {
    for (one, other) in
        [(STEEL, (8e-3, 500e6, 70e9)), (STEEL, (3e-3, 360e6, 210e9)), ((2e-3, 900e6, 400e9), (9e-3, 100e6, 70e9))]
    {
        let [ab, ba] = [(one, other), (other, one)].map(|(a, b)| balls(a, b, UnloadingExponent::PressureShape));
        for speed in [0.01, 0.3, 2.0] {
            let [ab, ba] = [&ab, &ba].map(|contact| contact.closed_form(speed).unwrap());
            assert!(
                relative_error(ab.row.restitution, ba.row.restitution) < 1e-12 && max_relative_error(&ab, &ba) < 1e-12,
                "{speed}"
            );
            assert!((ab.row.flat_depth - ba.row.dent_depth()).abs() < 1e-12 * ab.row.peak_indentation, "{speed}");
        }
    }
}

/// The larger ball has the correction for deep dents, also where it is the one that hits.
#[test]
fn hard_hit_is_symmetric_in_the_balls() {
    let (one, other) = ((5e-3, 345e6, 210e9), (3e-3, 360e6, 210e9));
    let [ab, ba] = [(one, other), (other, one)].map(|(a, b)| balls(a, b, UnloadingExponent::PressureShape));
    for speed in [30.0, 60.0] {
        let [ab, ba] = [&ab, &ba].map(|contact| contact.closed_form(speed).unwrap());
        assert!(ab.row.radius_ratio > 0.3, "{speed}: {}", ab.row.radius_ratio);
        assert!(relative_error(ab.row.restitution, ba.row.restitution) < 1e-12 && max_relative_error(&ab, &ba) < 1e-12);
    }
}

#[test]
fn a_hollow_needs_room_for_the_sphere() {
    let (sphere, half_space) = Scene::steel().bodies();
    let of = |radius: f64| {
        Contact::try_new(sphere, HalfSpace { radius: Some(radius), ..half_space }, &Plm::default()).map(drop)
    };
    assert!(of(-2.0 * sphere.radius).is_ok() && of(sphere.radius).is_ok());
    assert!(matches!(of(-1.9 * sphere.radius), Err(ImpactError::Hollow(_))));
}

/// A ball that is hit is free to move, and would fall too.
#[test]
fn free_target_under_gravity_is_refused() {
    let free = balls(STEEL, STEEL, UnloadingExponent::Paper);
    for (gravity, is_refused) in [(None, false), (Some(0.0), false), (Some(9.81), true)] {
        let contact = free.clone().with_forces(Forces { gravity, ..Forces::default() });
        let error = contact.impact(1.0, &Solver::AUTO, None).err();
        assert_eq!(matches!(error, Some(ImpactError::FreeUnderGravity)), is_refused, "{gravity:?}: {error:?}");
        assert_eq!(error.is_some(), is_refused, "{gravity:?}: {error:?}");
    }
}

/// Two equal elastic balls exchange their speeds. What a run leaves of the speed of the first is its error, and no result.
#[test]
fn rest_within_error_of_run_is_no_rest() {
    let second =
        ["half_space.radius=5 mm", "half_space.mass=ball", "half_space.density=7850", "half_space.yield_strength=1e12"];
    let contact = crate::common::contact(crate::common::STEEL, &second);
    for method in [Method::ClosedForm, Method::Rk8, Method::Dop853] {
        let impact = contact.impact(3.0, &solver(method, 1e-12), None).unwrap();
        assert!((impact.row.restitution - 1.0).abs() < 1e-11);
        assert_eq!(impact.rebound_speed, 0.0, "{}", method.name());
    }
    // a small e less than 1 is no error
    let (rebound, _) = contact.speeds_after(3.0, 1.0 - 1e-8);
    assert!(relative_error(rebound, -1.5e-8) < 1e-6, "{rebound}");
}
