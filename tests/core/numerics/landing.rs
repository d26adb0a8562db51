//! Events at the edges of a leg: a knot just before the peak, steps beyond a knot.

use crate::common::prelude::*;

#[test]
fn knot_just_before_peak_is_passed_during_loading() {
    // a long step may pass the knot, turn, and end before the knot; its passage during loading must still be found
    let scene = Scene::steel();
    let yield_speed = scene.yield_speed();
    let law = scene.law();
    let knots = law.loading.pieces().iter().skip(1).map(|piece| (2.5 * piece.work).sqrt());
    for q in knots.chain([1.0]) {
        for eighths in 12..72 {
            let above = q * (1.0 + 10_f64.powf(-0.125 * f64::from(eighths)));
            // every speed with four of sixteen tolerances, every tolerance with a quarter of the speeds
            for tolerance in (12 + eighths % 4..28).step_by(4).map(|quarters| 10_f64.powf(-0.25 * f64::from(quarters)))
            {
                let impact = scene.impact(above * yield_speed, Method::Rk8, tolerance, Some(8));
                let way_in = impact.trace.iter().take_while(|row| row.event != Some(Event::Peak));
                assert!(way_in.clone().all(|row| row.speed > 0.0), "{above} at {tolerance:e}");
                assert!(impact.trace.windows(2).all(|rows| rows[0].time <= rows[1].time), "{above} at {tolerance:e}");
            }
        }
    }
}

/// At a loose tolerance a step may go beyond a knot, to which the next one comes back. A sample beyond the knot belongs to the piece
/// behind it: once it stood before the row of the knot.
#[test]
fn a_sample_behind_a_knot_stands_behind_it() {
    let keys = [
        ("sphere.radius", 1.0),
        ("sphere.density", 100.0),
        ("sphere.youngs_modulus", 1e6),
        ("sphere.poissons_ratio", 0.0),
        ("half_space.youngs_modulus", 1e6),
        ("half_space.poissons_ratio", -0.825_427_476_103_246),
        ("half_space.yield_strength", 268.567_455_510_224_14),
        ("gravity.acceleration", 6.237_051_527_305_032e-5),
        ("impact.speed", 2.257_341_080_377_937_9e-7),
    ];
    let contact = contact("", &keys.map(|(key, number)| format!("{key}={number:e}")));
    for samples in 3..40 {
        let impact = contact.impact(2.257_341_080_377_937_9e-7, &solver(Method::Rk8, 1e-3), Some(samples)).unwrap();
        assert!(impact.trace.is_sorted_by(|one, next| one.time <= next.time), "{samples}");
    }
}
