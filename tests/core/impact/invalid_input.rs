//! The library refuses the numbers that a scenario refuses, and says which one it is.

use crate::common::prelude::*;

const STEEL_MATERIAL: Material = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };

fn sphere() -> Sphere {
    Sphere { yield_strength: Some(600e6), ..Sphere::elastic(5e-3, STEEL_MATERIAL, 7850.0) }
}

fn half_space() -> HalfSpace {
    HalfSpace::flat(STEEL_MATERIAL, Some(345e6))
}

/// The reason why a contact of these bodies is refused.
fn refused(sphere: Sphere, half_space: HalfSpace) -> String {
    match Contact::try_new(sphere, half_space, &Plm::default()) {
        Err(ImpactError::Invalid(error)) => {
            let slow = StaticContact::try_new(&sphere, &half_space, &Plm::default());
            assert_eq!(slow.err().map(|error| error.to_string()), Some(error.to_string()));
            error.quantity.to_owned()
        }
        other => panic!("{other:?}"),
    }
}

/// Once a Poisson's ratio of 1 made a rigid body, and a negative modulus passed where the other body was stiffer.
#[test]
fn numbers_that_no_body_has_are_refused() {
    let of = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
    for (material, quantity) in [
        (of(210e9, 1.0), "Poisson's ratio"),
        (of(210e9, 0.5), "Poisson's ratio"),
        (of(210e9, -1.0), "Poisson's ratio"),
        (of(210e9, f64::NAN), "Poisson's ratio"),
        (of(-210e9, 0.3), "Young's modulus"),
        (of(0.0, 0.3), "Young's modulus"),
        (of(f64::NAN, 0.3), "Young's modulus"),
    ] {
        let of_sphere = refused(Sphere { material, ..sphere() }, half_space());
        assert!(of_sphere.starts_with(quantity) && of_sphere.contains("sphere"), "{of_sphere}");
        let of_half_space = refused(sphere(), HalfSpace { material, ..half_space() });
        assert!(of_half_space.starts_with(quantity) && of_half_space.contains("half-space"), "{of_half_space}");
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Pair::try_new(&Sphere { radius: bad, ..sphere() }, &half_space()).unwrap_err();
        assert!(matches!(error, PairError::Invalid(_)) && error.to_string().starts_with("radius"), "{error}");
        assert!(Contact::try_new(Sphere { radius: bad, ..sphere() }, half_space(), &Plm::default()).is_err());
        let weak = Some(bad);
        assert!(refused(Sphere { yield_strength: weak, ..sphere() }, half_space()).contains("strength of the sphere"));
        assert!(refused(sphere(), HalfSpace { yield_strength: weak, ..half_space() }).contains("strength of the half"));
    }
    // one of two bodies may be rigid
    let rigid = of(f64::INFINITY, 0.3);
    assert!(Contact::try_new(Sphere { material: rigid, ..sphere() }, half_space(), &Plm::default()).is_ok());
    assert!(Contact::try_new(sphere(), HalfSpace { material: rigid, ..half_space() }, &Plm::default()).is_ok());
    let both = (Sphere { material: rigid, ..sphere() }, HalfSpace { material: rigid, ..half_space() });
    assert!(matches!(Contact::try_new(both.0, both.1, &Plm::default()), Err(ImpactError::Range(_))));
}

#[test]
fn forces_and_friction_that_cannot_be_are_refused() {
    let contact = Contact::try_new(sphere(), half_space(), &Plm::default()).unwrap();
    let is_refused = |contact: &Contact, approach: Approach| {
        let results = [contact.impact(approach, &Solver::AUTO, None).err(), contact.row(approach, &Solver::AUTO).err()];
        results.into_iter().all(|error| matches!(error, Some(ImpactError::Invalid(_))))
    };
    let straight = Approach::from(1.0);
    assert!(!is_refused(&contact, straight));
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        for forces in [
            Forces { gravity: Some(bad), ..Forces::default() },
            Forces { damping: Some(Damping::HuntCrossley(bad)), ..Forces::default() },
            Forces { damping: Some(Damping::Viscous(bad)), ..Forces::default() },
            Forces { damping: Some(Damping::Viscoelastic(bad)), ..Forces::default() },
        ] {
            assert!(is_refused(&contact.clone().with_forces(forces), straight), "{forces:?}");
        }
        let oblique = |friction| Approach::at_angle(1.0, 0.5, 0.0, friction);
        // an infinite coefficient is a contact point that never slips
        assert_eq!(is_refused(&contact, oblique(bad)), bad != f64::INFINITY);
        assert_eq!(is_refused(&contact.clone().with_moment_of_inertia(bad), oblique(0.3)), bad != f64::INFINITY);
    }
    assert!(is_refused(&contact.with_moment_of_inertia(0.0), Approach::at_angle(1.0, 0.5, 0.0, 0.3)));
}

/// A table of coefficients is checked wherever it comes from, also in a combination.
#[test]
fn coefficients_that_break_a_rule_are_refused() {
    let mut table = PlmCoefficients::built_in().clone();
    table.force.from.reverse();
    let plm = LawChoice::Plm(Plm::new(&table, UnloadingExponent::Paper));
    let [one, other] = [plm.clone(), plm.clone()].map(Box::new);
    let thornton = Box::new(LawChoice::from_name("thornton").unwrap());
    let half = LawChoice::Combined(Combined { loading: thornton, unloading: Box::new(plm.clone()) });
    for law in [plm, LawChoice::Combined(Combined { loading: one, unloading: other }), half] {
        let error = Contact::try_new(sphere(), half_space(), law.as_contact_law()).unwrap_err();
        assert!(matches!(error, ImpactError::Law(LawError::Coefficients { .. })), "{error}");
        assert!(error.to_string().contains("force.from"), "{error}");
    }
}

/// The rules of the tables that an older file of coefficients does not have.
#[test]
fn coefficients_outside_their_range_are_refused() {
    type Change = fn(&mut PlmCoefficients);
    let changes: [(&str, Change); 10] = [
        ("poisson", |table| table.poisson.as_mut().unwrap().force = -0.1),
        ("poisson", |table| table.poisson.as_mut().unwrap().approach = f64::NAN),
        ("depth", |table| table.depth.as_mut().unwrap().recovery = -0.1),
        ("depth.to", |table| table.depth.as_mut().unwrap().to = table.depth.unwrap().from),
        ("depth.to", |table| table.depth.as_mut().unwrap().to = f64::INFINITY),
        ("depth.recovery_kappa", |table| table.depth.as_mut().unwrap().recovery_kappa = 1.1),
        ("validity", |table| table.validity.perfectly_plastic = 0.0),
        ("validity", |table| table.validity.hardening = 1.1),
        ("validity", |table| table.validity.yielding_sphere = f64::NAN),
        ("validity", |table| table.validity.both_yield = -0.1),
    ];
    for (key, change) in changes {
        let mut table = PlmCoefficients::built_in().clone();
        change(&mut table);
        let error = table.check().unwrap_err();
        assert!(matches!(error, CoefficientsError::Value { key: named, .. } if named == key), "{key}: {error}");
    }
    assert!(PlmCoefficients::built_in().check().is_ok());
}

/// Each reason has its own advice. Times without a unit are of no use to anyone.
#[test]
fn run_without_end_names_reason() {
    let steps = 7;
    for (error, advice) in [
        (IntegrationError::StepUnderflow { time: 0.5, step: 1e-20 }, "Increase solver.tolerance"),
        (IntegrationError::TooManySteps { steps }, "Increase solver.tolerance, or use method = \"auto\""),
        (IntegrationError::TooManyFixedSteps { steps }, "method = \"rk8\""),
        (IntegrationError::CoarseSteps { steps, restitution: 2.0 }, "Increase solver.steps_per_contact"),
        (IntegrationError::UnsettledRate { rounds: steps }, "Reduce the strain-rate sensitivity"),
        (IntegrationError::TooManyFrictionSteps { steps }, "Reduce the coefficient of friction"),
        (IntegrationError::Creeping { steps }, "Reduce the damping"),
        (IntegrationError::NotFinite { time: 0.5 }, ""),
    ] {
        let text = error.to_string();
        assert!(text.contains(advice) && !text.contains("dimensionless") && !text.contains("0.5"), "{text}");
        // only for a method with a tolerance the message advises to increase it, and rk8 is advised where another method ran
        assert_eq!(text.contains("tolerance"), advice.starts_with("Increase solver.tolerance"), "{text}");
        assert_eq!(text.contains("rk8"), advice.contains("rk8"), "{text}");
    }
    // a contact that fixed steps do not leave: it creeps
    let forces = Forces { gravity: Some(9.81), damping: Some(Damping::Viscous(1e6)), ..Forces::default() };
    let contact = Contact::try_new(sphere(), half_space(), &Plm::default()).unwrap().with_forces(forces);
    let verlet = Solver { method: Method::Verlet, ..Solver::default() };
    let error = contact.impact(1.0, &verlet, None).unwrap_err();
    assert!(!error.to_string().contains("tolerance"), "{error}");
}
