//! Spheres that are released at rest, or nearly at rest, and are moved by their own weight.

use plm_impact::impact::solve::motion;

use super::exact_solutions;
use crate::common::prelude::*;

#[test]
fn sphere_released_at_rest_falls_at_any_tolerance() {
    // the speed at first touch is much smaller than later: k d^(n+1)/(n+1) = w d, so d_m^n = (n + 1) w/k
    let reloaded = |exponent| {
        let law = Scene { exponent, ..Scene::steel() }.law();
        let dent = law.history_after(law.loaded_state(20.0));
        (law, Some(dent))
    };
    let dents = [UnloadingExponent::Paper, UnloadingExponent::Fixed(1.2), UnloadingExponent::Fixed(1.8)].map(reloaded);
    for (law, dent) in [Law::hertz(), Scene::steel().law()].map(|law| (law, None)).iter().chain(&dents) {
        let ground = Surface::new(law, dent.as_ref());
        let (k, n) = ground.reloading_branch().map_or((1.0, 1.5), |branch| (branch.power_stiffness(), branch.exponent));
        // beyond 0.4 it also passes knots, where its speed still rises
        for weight in [1e-6, 1e-3, 0.4, 0.6, 2.0, 5.0, 12.0, 20.0, 50.0, 300.0] {
            let forces = ScaledForces { weight, ..ScaledForces::NONE };
            let deepest = ((n + 1.0) * weight / k).powf(1.0 / n);
            for tolerance in (30..120).map(|tenths| 10_f64.powf(-0.1 * f64::from(tenths))) {
                for share in [0.0, 1e-8, 1e-3] {
                    let speed = share * (weight * deepest).sqrt();
                    let outcome = motion::integrate(ground, speed, &forces, &mut Rk8::new(tolerance), None).unwrap();
                    let exact = exact_solutions::solve(ground, speed, &forces);
                    let (got, want) = (outcome.unloading.peak.elastic_approach, exact.unloading.peak.elastic_approach);
                    let at = format!("n = {n}, w = {weight}, {share} at {tolerance:e}");
                    assert!(relative_error(got, want) < 10.0 * tolerance + 1e-12, "{at}: {got} {want}");
                    assert!(
                        weight > 0.4 || relative_error(want, deepest) < 10.0 * share + 1e-12,
                        "{at}: {want} {deepest}"
                    );
                    assert!(relative_error(outcome.loading_time, exact.loading_time) < 10.0 * tolerance + 1e-9, "{at}");
                }
            }
        }
    }
}

/// The weight does the work m g δ on a sphere that is released at rest, so the sphere sinks as deep as an impact of this energy without
/// gravity does: through a law whose pieces depend on the depth too.
#[test]
fn released_sphere_sinks_as_deep_as_its_energy() {
    for yield_strength in [3e3, 30e3, 300e3] {
        let ground = Material { youngs_modulus: 20e6, poissons_ratio: 0.45 };
        let scene = Scene { radius: 20e-3, half_space: ground, yield_strength: Some(yield_strength), ..Scene::steel() };
        let peak = |forces: Forces, speed: f64| {
            let impact = super::contact_with_forces(&scene, forces).closed_form(speed).unwrap();
            impact.row.peak_indentation
        };
        let released = peak(super::gravity(super::GRAVITY), 0.0);
        let hit = peak(Forces::default(), (2.0 * super::GRAVITY * released).sqrt());
        assert!(relative_error(released, hit) < 1e-12, "{yield_strength}: {released} {hit}");
    }
}
