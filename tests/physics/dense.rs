//! Dense output of rk8: the rows of a trace between the steps are as accurate as the tolerance.

use plm_impact::impact::{Impact, Method, TraceRow};
use plm_impact::law::UnloadingExponent;
use plm_impact::math::power::max_or_nan;

use crate::common::Scene;

/// Speeds over the yield speed: elastic, just yielding, beyond each knot, far beyond the last knot.
const SHARES: [f64; 12] = [0.5, 1.001, 1.5, 2.5, 5.0, 10.0, 20.0, 45.0, 100.0, 250.0, 700.0, 1e4];

/// The rows of a trace that are not events.
fn samples(impact: &Impact) -> impl Iterator<Item = &TraceRow> {
    impact.trace.iter().filter(|row| row.event.is_none())
}

/// Largest error of indentation, speed and force over the samples of an impact, relative to the largest of each.
fn worst(scene: &Scene, share: f64, tolerance: f64) -> f64 {
    let speed = share * scene.yield_speed();
    let exact = scene.impact(speed, Method::ClosedForm, tolerance, Some(1001));
    let stepped = scene.impact(speed, Method::Rk8, tolerance, Some(1001));
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

fn assert_follows_the_tolerance(scenes: &[Scene]) {
    for scene in scenes {
        for share in SHARES {
            for digits in 4..=12 {
                let tolerance = 10_f64.powi(-digits);
                let worst = worst(scene, share, tolerance);
                assert!(worst <= 3.0 * tolerance, "{:?} at {share} v_Y, {tolerance:e}: {worst:e}", scene.exponent);
            }
        }
    }
}

#[test]
fn samples_are_as_good_as_the_tolerance() {
    let mut soft = Scene::steel();
    soft.sphere.youngs_modulus = 5e9;
    assert_follows_the_tolerance(&[Scene::steel(), Scene::case_3(), soft]);
}

#[test]
fn samples_are_as_good_with_any_unloading_exponent() {
    let fixed = [1.01, 1.1, 1.25, 1.4, 1.75, 2.0].map(UnloadingExponent::Fixed);
    let scenes = [UnloadingExponent::PressureShape].into_iter().chain(fixed);
    assert_follows_the_tolerance(&scenes.map(|exponent| Scene { exponent, ..Scene::steel() }).collect::<Vec<_>>());
}
