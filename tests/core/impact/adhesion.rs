//! Adhesion as a loss of energy: the constant of JKR, the sticking speed, and where no result is known.

use plm_impact::impact::problem::adhesion::PULL_OFF_FACTOR;

use crate::common::prelude::*;

/// The work ∫ F dδ of JKR (Johnson, Kendall and Roberts 1971) with R = E* = w = 1, from δ = 0, where the contact forms, to the least δ,
/// where it breaks. With the contact radius a as variable,
///
/// ```text
/// F = (4/3) a³ − √(8 π a³),   δ = a² − √(2 π a),   δ = 0 at a³ = 2 π,   dδ/da = 0 at a³ = π/8
/// ```
#[test]
fn pull_off_work_is_of_jkr() {
    use std::f64::consts::PI;
    let force = |a: f64| 4.0 / 3.0 * a * a * a - (8.0 * PI * a * a * a).sqrt();
    let rate = |a: f64| 2.0 * a - (0.5 * PI / a).sqrt();
    let work = tanh_sinh_reference((PI / 8.0).cbrt(), (2.0 * PI).cbrt(), |a| force(a) * rate(a));
    assert!(relative_error(-work, PULL_OFF_FACTOR) < 1e-14, "{work}");
}

/// A glass sphere of 5 µm diameter on glass, or on a metal.
fn particle(yield_strength: Option<f64>) -> Contact {
    let glass = Material { youngs_modulus: 70e9, poissons_ratio: 0.2 };
    let half_space = HalfSpace::flat(glass, yield_strength);
    Contact::try_new(Sphere::elastic(2.5e-6, glass, 2500.0), half_space, &Plm::default()).unwrap()
}

fn row(contact: &Contact, speed: f64) -> ImpactRow {
    contact.row(speed, &Solver::AUTO).unwrap()
}

#[test]
fn elastic_particle_sticks_below_its_speed() {
    let contact = particle(None).with_adhesion(Some(0.05));
    // Thornton and Ning (1998): V_s = √(14.18/m) (Γ⁵ R⁴/E*²)^(1/6)
    let printed = (14.18 / contact.mass()).sqrt()
        * (0.05_f64.powi(5) * 2.5e-6_f64.powi(4) / contact.pair().effective_modulus.powi(2)).powf(1.0 / 6.0);
    for speed in [1e-3, 0.01, 0.03, 0.1, 1.0] {
        let row = row(&contact, speed);
        let result = row.adhesion.unwrap();
        assert!(relative_error(result.sticking_speed, printed) < 2e-4, "{result:?} {printed}");
        let left = 1.0 - (result.sticking_speed / speed).powi(2);
        assert!((result.restitution - left.max(0.0).sqrt()).abs() < 1e-15, "{speed}");
        assert_eq!((row.restitution, result.restitution == 0.0), (1.0, speed < printed), "{speed}");
        assert_eq!(contact.impact(speed, &Solver::AUTO, None).unwrap().row.adhesion.unwrap(), result);
    }
}

/// A dent is flatter than the sphere by R_e/R: V_s grows with (R_e/R)^(2/3).
#[test]
fn dent_raises_the_sticking_speed() {
    let contact = particle(Some(280e6)).with_adhesion(Some(0.05));
    let elastic = row(&particle(None).with_adhesion(Some(0.05)), 2.0).adhesion.unwrap();
    for speed in [0.5, 2.0, 10.0] {
        let impact = contact.impact(speed, &Solver::AUTO, None).unwrap();
        let result = impact.row.adhesion.unwrap();
        let flatter = (impact.unloading_radius / 2.5e-6).powf(2.0 / 3.0);
        assert!(flatter > 1.01 && relative_error(result.sticking_speed, flatter * elastic.sticking_speed) < 1e-12);
        let left = impact.row.restitution.powi(2) - (result.sticking_speed / speed).powi(2);
        assert!((result.restitution - left.max(0.0).sqrt()).abs() < 1e-15);
        assert_eq!(row(&contact, speed).adhesion, Some(result));
        // the other results are those without adhesion
        let plain = contact.clone().with_adhesion(None).row(speed, &Solver::AUTO).unwrap();
        assert_eq!(ImpactRow { adhesion: None, ..impact.row }.restitution, plain.restitution);
        assert_eq!(plain.adhesion, None);
    }
    let waves = Scene::steel();
    let (sphere, half_space) = waves.bodies();
    let dense = HalfSpace { density: Some(7850.0), ..half_space };
    let contact = Contact::try_new(sphere, dense, &Plm::default()).unwrap().with_adhesion(Some(1e-9));
    let row = row(&contact, 3.0);
    assert!(relative_error(row.adhesion.unwrap().restitution, row.restitution_with_waves().unwrap()) < 1e-12);
}

#[test]
fn no_result_at_rest_or_under_other_drag() {
    let contact = particle(None).with_adhesion(Some(0.05));
    let under = |forces: Forces, speed: f64| row(&contact.clone().with_forces(forces), speed).adhesion;
    let damped = |damping| Forces { damping: Some(damping), ..Forces::default() };
    let falling = Forces { gravity: Some(9.81), ..Forces::default() };
    assert_eq!(under(falling, 0.0), None);
    assert_eq!(under(damped(Damping::Viscoelastic(1e-9)), 1.0), None);
    assert!(under(falling, 1.0).is_some() && under(damped(Damping::Viscous(0.1)), 1.0).is_some());
}
