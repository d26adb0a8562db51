//! Events: their places, their order, and the rows of a trace.

use crate::common::prelude::*;

/// Speeds in units of the yield speed: an elastic impact, impacts beyond each knot, and far beyond the last knot.
const SPEEDS: [f64; 14] = [0.1, 0.999, 1.000_001, 1.001, 1.5, 2.5, 5.0, 10.0, 20.0, 45.0, 100.0, 250.0, 700.0, 4e3];

/// The steppers, and the closed form, whose traces are made of the exact motion.
const TRACING: [(Method, f64); 4] = [STEPPING[0], STEPPING[1], STEPPING[2], (Method::ClosedForm, 1.0)];

fn scenes() -> [Scene; 3] {
    let mut soft = Scene::steel();
    soft.sphere.youngs_modulus = 5e9;
    soft.yield_strength = Some(34.5e6);
    soft.exponent = UnloadingExponent::PressureShape;
    [Scene::steel(), Scene::case_3(), soft]
}

#[test]
fn events_come_once_and_in_order_with_the_state_of_the_summary() {
    for scene in scenes() {
        for share in SPEEDS {
            for (method, _) in TRACING {
                check_events(&scene, share, method);
            }
        }
    }
}

fn check_events(scene: &Scene, share: f64, method: Method) {
    let contact = scene.contact();
    let (law, unit) = (scene.law(), contact.pair().yield_point.unwrap().indentation);
    let impact = scene.impact(share * contact.yield_speed().unwrap(), method, 1e-10, Some(50));
    let case = format!("{} at {share} v_Y", method.name());
    let x_m = impact.peak_indentation / unit;
    let passed = law.loading.pieces().iter().skip(1).filter(|piece| piece.start < x_m);
    let mut want: Vec<(Event, f64)> = vec![(Event::Touch, 0.0)];
    if share > 1.0 {
        want.push((Event::Yield, 1.0));
    }
    want.extend(passed.map(|piece| (Event::Knot, piece.start)));
    want.extend([(Event::Peak, x_m), (Event::Separation, impact.residual_indentation / unit)]);
    let got: Vec<_> = impact.trace.iter().filter(|row| row.event.is_some()).collect();
    assert_eq!(got.len(), want.len(), "{case}");
    for (row, (event, x)) in got.iter().zip(want) {
        assert_eq!(row.event, Some(event), "{case}");
        // the row is on the knot up to rounding, not beyond it
        let miss = (row.indentation / unit - x).abs();
        assert!(miss <= 2e-15 * x, "{case}: {event:?} misses by {miss:e}");
    }
    // no event occurs twice at the same time: the times rise strictly
    assert!(got.windows(2).all(|pair| pair[0].time < pair[1].time), "{case}");
    assert!(impact.trace.is_sorted_by(|one, next| one.time <= next.time), "{case}");
    let (peak, last) = (got[got.len() - 2], *impact.trace.last().unwrap());
    let summary = [impact.peak_indentation, impact.peak_force, impact.loading_time];
    assert_eq!((peak.speed, [peak.indentation, peak.force, peak.time]), (0.0, summary), "{case}");
    assert!(impact.trace.iter().all(|row| row.indentation <= impact.peak_indentation), "{case}");
    // the sphere separates at the dent: F = 0 occurs there and at first touch only
    assert_eq!((last.event, last.force), (Some(Event::Separation), 0.0), "{case}");
    let miss = (last.indentation - impact.residual_indentation).abs();
    assert!(miss <= 1e-12 * impact.residual_indentation, "{case}: {miss:e}");
    assert!(off(-last.speed, impact.rebound_speed) < 1e-15 && off(last.time, impact.contact_time) < 1e-15);
    assert_eq!(impact.trace.iter().filter(|row| row.force == 0.0).count(), 2, "{case}");
}

#[test]
fn a_knot_just_before_the_peak_is_passed_on_the_way_in() {
    // a long step may pass the knot, turn, and end before the knot; the passage on the way in must still be found
    let scene = Scene::steel();
    let yield_speed = scene.yield_speed();
    let law = scene.law();
    let knots = law.loading.pieces().iter().skip(1).map(|piece| (2.5 * piece.work).sqrt());
    for q in knots.chain([1.0]) {
        for eighths in 12..72 {
            let above = q * (1.0 + 10_f64.powf(-0.125 * f64::from(eighths)));
            for tolerance in (12..28).map(|quarters| 10_f64.powf(-0.25 * f64::from(quarters))) {
                let impact = scene.impact(above * yield_speed, Method::Rk8, tolerance, Some(8));
                let way_in = impact.trace.iter().take_while(|row| row.event != Some(Event::Peak));
                assert!(way_in.clone().all(|row| row.speed > 0.0), "{above} at {tolerance:e}");
                assert!(impact.trace.windows(2).all(|rows| rows[0].time <= rows[1].time), "{above} at {tolerance:e}");
            }
        }
    }
}

#[test]
fn separation_is_not_triggered_at_first_touch() {
    // F = 0 at first touch too, which must not count as separation, for any length of the first step
    for (method, factor) in STEPPING {
        for tolerance in [1e-1, 1e-2, 1e-3, 1e-6, 1e-13] {
            let impact = Scene::steel().impact(1e-3, method, tolerance, None);
            assert!(off(impact.restitution, 1.0) < factor * tolerance, "{} at {tolerance:e}", method.name());
            assert!(impact.loading_time > 0.0 && impact.contact_time > 1.9 * impact.loading_time);
        }
    }
}

#[test]
fn trace_is_even_in_time_and_has_the_rows_asked_for() {
    for samples in [2, 3, 10, 400, 1001] {
        for share in [0.5, 1.001, 30.0, 1000.0] {
            for (method, _) in TRACING {
                let scene = Scene::steel();
                let impact = scene.impact(share * scene.yield_speed(), method, 1e-10, Some(samples));
                let even: Vec<_> = impact.trace.iter().filter(|row| row.event.is_none()).collect();
                // first touch and separation are the ends of the even samples
                assert_eq!(even.len(), samples - 2, "{} at {share} v_Y", method.name());
                #[allow(clippy::cast_precision_loss)]
                for (i, row) in even.iter().enumerate() {
                    let want = impact.contact_time * (i + 1) as f64 / (samples - 1) as f64;
                    // the spacing is that of the exact contact time
                    assert!(off(row.time, want) < 1e-9, "{} row {i}: {} {want}", method.name(), row.time);
                }
                assert!(impact.trace.windows(2).all(|pair| pair[0].time <= pair[1].time));
                assert_eq!(impact.trace[0].time, 0.0);
                assert_eq!(impact.trace[0].speed, impact.speed);
            }
        }
    }
    assert!(Scene::steel().impact(1.0, Method::Rk8, 1e-10, None).trace.is_empty());
}

#[test]
fn branches_follow_each_other() {
    for (method, _) in TRACING {
        let impact = Scene::steel().impact(1.0, method, 1e-10, Some(400));
        let rank = |branch| [Branch::Elastic, Branch::Plastic, Branch::Unloading].iter().position(|b| *b == branch);
        assert!(impact.trace.windows(2).all(|pair| rank(pair[0].branch) <= rank(pair[1].branch)));
        for row in &impact.trace {
            assert!((row.speed < 0.0) <= (row.branch == Branch::Unloading));
            let sum = row.sphere_indentation + row.half_space_indentation;
            assert!((sum - row.indentation).abs() <= 1e-15 * row.indentation);
            // the half-space never recovers beyond its dent
            let dent = if row.branch == Branch::Unloading { impact.residual_indentation } else { 0.0 };
            assert!(row.half_space_indentation >= dent * (1.0 - 1e-9));
        }
        let elastic = Scene::steel().impact(1e-3, method, 1e-10, Some(400));
        assert!(elastic.trace.iter().all(|row| row.branch != Branch::Plastic));
    }
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    #[test]
    fn every_row_closes_the_energy_ledger(log_share in -1.0..4.0_f64, log_tolerance in -12.0..-4.0_f64, samples in 2..200_usize) {
        let scene = Scene::steel();
        let tolerance = 10_f64.powf(log_tolerance);
        for (method, _) in TRACING {
            let impact = scene.impact(10_f64.powf(log_share) * scene.yield_speed(), method, tolerance, Some(samples));
            for row in &impact.trace {
                prop_assert!(row.energy_drift.abs() <= 100.0 * tolerance, "{} {tolerance:e}: {row:?}", method.name());
            }
            let worst = impact.trace.iter().fold(0.0, |worst, row| max_or_nan(worst, row.energy_drift.abs()));
            prop_assert!(impact.energy.drift >= worst && impact.energy.drift <= 100.0 * tolerance);
        }
    }
}

/// The formula of Stronge lies between the yield point and 84 times that indentation. It is computed on several pieces, whose
/// joints are no events.
#[test]
fn a_trace_tells_of_the_knots_of_a_law_and_not_of_the_joints_of_its_formula() {
    let contact = Scene::case_3().contact_by(LawChoice::from_name("stronge").unwrap().get());
    let (yields_at, _) = contact.yields_at().unwrap();
    for (method, _) in TRACING {
        for (speed, knots) in [(0.5, 0), (20.0, 1)] {
            let impact = contact.impact(speed, &solver(method, 1e-10), Some(20)).unwrap();
            assert!(impact.peak_indentation > 8.0 * yields_at);
            let at: Vec<f64> =
                impact.trace.iter().filter(|row| row.event == Some(Event::Knot)).map(|row| row.indentation).collect();
            assert_eq!(at.len(), knots, "{method:?} at {speed} m/s: {at:?}");
            assert!(at.iter().all(|at| off(*at, 84.0 * yields_at) < 1e-12), "{method:?}: {at:?}");
        }
    }
}
