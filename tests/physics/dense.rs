//! Dense output: the rows of a trace between the steps are as accurate as the tolerance.

use crate::common::prelude::*;

/// Speeds over the yield speed: elastic, just yielding, beyond each knot, far beyond the last knot.
const SHARES: [f64; 14] = [0.1, 0.5, 0.999, 1.001, 1.5, 2.5, 5.0, 10.0, 20.0, 45.0, 100.0, 250.0, 700.0, 4e3];

/// The rows of a trace that are not events.
fn samples(impact: &Impact) -> impl Iterator<Item = &TraceRow> {
    impact.trace.iter().filter(|row| row.event.is_none())
}

/// Largest error of indentation, speed and force over the samples of an impact, relative to the largest of each.
fn worst(scene: &Scene, share: f64, method: Method, tolerance: f64) -> f64 {
    let speed = share * scene.yield_speed();
    let exact = scene.impact(speed, Method::ClosedForm, tolerance, Some(1001));
    let stepped = scene.impact(speed, method, tolerance, Some(1001));
    assert_eq!(samples(&stepped).count(), 999);
    let errors = samples(&stepped).zip(samples(&exact)).map(|(got, want)| {
        assert!((got.time - want.time).abs() <= 1e-14 * exact.contact_time);
        [
            (got.indentation - want.indentation) / exact.peak_indentation,
            (got.speed - want.speed) / speed,
            (got.force - want.force) / exact.peak_force,
        ]
    });
    errors.flatten().fold(0.0, |worst, error| max_or_nan(worst, error.abs()))
}

fn assert_follows_the_tolerance(scenes: &[Scene], methods: &[(Method, f64)]) {
    for scene in scenes {
        // just above first yield the law has no answer with a small exponent
        let is_held = |share: &f64| scene.contact().row(share * scene.yield_speed(), &Solver::AUTO).is_ok();
        let shares: Vec<f64> = SHARES.into_iter().filter(is_held).collect();
        assert!(shares.len() >= if matches!(scene.exponent, UnloadingExponent::Fixed(_)) { 10 } else { 14 });
        for share in shares {
            for digits in 4..=12 {
                let tolerance = 10_f64.powi(-digits);
                // the steppers of the library at every third tolerance
                for &(method, factor) in &methods[..if digits % 3 == 0 { methods.len() } else { 1 }] {
                    // near separation, an error of the dent of one tolerance changes F by up to the stiffness n/ε_m
                    let allowed = if method == Method::Rk8 { 3.0 } else { 10.0 * factor };
                    let worst = worst(scene, share, method, tolerance);
                    let case = format!("{:?} at {share} v_Y, {} {tolerance:e}", scene.exponent, method.name());
                    assert!(worst <= allowed * tolerance + 1e-12, "{case}: {worst:e}");
                }
            }
        }
    }
}

#[test]
fn samples_are_as_good_as_the_tolerance() {
    let mut soft = Scene::steel();
    soft.sphere.youngs_modulus = 5e9;
    soft.yield_strength = Some(34.5e6);
    let softer = Scene { exponent: UnloadingExponent::PressureShape, ..soft };
    assert_follows_the_tolerance(&[Scene::steel(), Scene::case_3(), soft, softer], &STEPPING);
}

#[test]
fn samples_are_as_good_with_any_unloading_exponent() {
    let fixed = [1.01, 1.1, 1.25, 1.4, 1.75, 2.0].map(UnloadingExponent::Fixed);
    let scenes = [UnloadingExponent::PressureShape].into_iter().chain(fixed);
    let scenes: Vec<Scene> = scenes.map(|exponent| Scene { exponent, ..Scene::steel() }).collect();
    assert_follows_the_tolerance(&scenes, &STEPPING[..1]);
}
