//! Invariants of the trace of an impact.

use super::balances::{Judgement, assert_close};
use super::equivalences::exact;
use super::random_scenario::Run;
use crate::common::prelude::*;

/// The order of a row: loading, its end, or unloading.
pub fn rank(row: &TraceRow) -> u8 {
    match row.branch {
        Branch::Elastic | Branch::Reloading => 0,
        Branch::Plastic => 1,
        _ => 2,
    }
}

/// The trace rises in time from first touch on, its branches follow each other, no contact pulls, and both bodies share the
/// indentation. Between the steps a row is as exact as the tolerance.
pub fn rows_are_in_order(run: &Run) -> Judgement {
    let (impact, trace) = (&run.impact, &run.impact.trace);
    prop_assert_eq!(trace.is_empty(), run.scene.samples.is_none());
    let Some(first) = trace.first() else { return Ok(false) };
    prop_assert_eq!((first.event, first.time), (Some(Event::Touch), 0.0));
    assert_close("speed", first.speed, run.speed(), 4e-16 * run.speed())?;
    if let [.., before, last] = &trace[..] {
        prop_assert!(before.time < last.time, "{:?} {:?}", before, last);
    }
    assert_close("touch", first.indentation, run.touch(), 1e-12 * run.touch())?;
    // on a straight line a viscous or viscoelastic force begins with a step
    prop_assert!(first.force == 0.0 || run.scene.has("damping.visco") && !run.is_plm(), "{:?}", first);
    for (row, next) in trace.iter().zip(&trace[1..]) {
        prop_assert!(row.time <= next.time && rank(row) <= rank(next), "{:?} {:?}", row, next);
        let is_new = row.event.is_none() || next.event.is_none() || next.event == Some(Event::Relaxation);
        prop_assert!(is_new || row.time < next.time, "{:?} {:?}", row, next);
    }
    let error = if run.is_adaptive() { run.error_allowance() } else { f64::INFINITY };
    // the force of a metal that relaxes is higher than the one that is reported
    let of_force = if impact.row.strain_rate_result.is_some() { f64::INFINITY } else { 3.0 * error };
    let beyond = beyond_the_peak(impact);
    for row in trace {
        prop_assert!(row.force >= 0.0 && row.force <= impact.row.peak_force * (1.0 + of_force), "{:?}", row);
        // on a plate the bodies approach a little further once the metal has relaxed
        let most = if rank(row) == 2 { impact.row.peak_indentation + beyond } else { impact.row.peak_indentation };
        prop_assert!(row.indentation <= most * (1.0 + error), "{:?}", row);
        prop_assert!(row.speed >= 0.0 || rank(row) == 2, "{:?}", row);
        assert_close(
            "parts",
            row.sphere_indentation + row.half_space_indentation,
            row.indentation,
            1e-15 * row.indentation,
        )?;
        let dent = if rank(row) == 2 { impact.row.dent_depth() } else { 0.0 };
        prop_assert!(row.half_space_indentation >= dent * (1.0 - 1e-9) - 1e-15 * row.indentation, "{:?}", row);
    }
    Ok(true)
}

/// How far a sphere on a plate may go on at most after the metal has relaxed: up to the force before that.
fn beyond_the_peak(impact: &Impact) -> f64 {
    let at = impact.trace.iter().position(|row| row.event == Some(Event::Relaxation));
    let Some(at) = at.filter(|_| impact.row.waveguide.is_some()) else { return 0.0 };
    let [before, after] = [impact.trace[at - 1].force, impact.trace[at].force];
    impact.elastic_approach * ((before / after).powf(1.0 / impact.unloading_exponent) - 1.0)
}

/// The trace turns and ends as the summary says, and its other rows are even in time.
pub fn the_trace_is_that_of_the_summary(run: &Run) -> Judgement {
    let (impact, trace) = (&run.impact, &run.impact.trace);
    let (Some(samples), Some(last)) = (run.scene.samples, trace.last()) else { return Ok(false) };
    if !run.is_adaptive() || run.turns_at_subdivision() {
        return Ok(false);
    }
    let Forces { damping, .. } = *run.contact.forces();
    let is_captured = impact.captured_result().is_some();
    prop_assert_eq!(last.event, Some(if is_captured { Event::Captured } else { Event::Separation }));
    assert_close("end", last.time, impact.duration(), 1e-15 * impact.duration())?;
    let place = impact.forces_result.map_or(impact.row.residual_indentation, |under| under.end_indentation);
    assert_close("place", last.indentation, place, 1e-12 * impact.row.peak_indentation)?;
    if !is_captured {
        let [back, want] = [-last.sphere_speed.unwrap_or(last.speed), impact.row.restitution * run.speed()];
        // where e is 1 the last row has the error of the run, as a part of all the energy that was put in
        let of_plain =
            if run.contact.forces().is_none() && run.contact.target_mass().is_none() { 1e-15 } else { 1e-12 };
        let error = if impact.row.restitution == 1.0 {
            run.error_allowance() * run.input_energy() / impact.row.kinetic_in
        } else {
            of_plain
        };
        assert_close("rebound", back, want, error * run.speed().max(want))?;
        assert_close("last force", last.force, 0.0, damping.map_or(0.0, |_| 1e-6 * impact.row.peak_force))?;
        if run.scene.has("damping.visco") {
            // during the rebound the sphere separates above the dent
            prop_assert!(last.indentation > impact.row.residual_indentation && last.speed < 0.0, "{:?}", last);
        } else if damping.is_none() {
            prop_assert_eq!(trace.iter().filter(|row| row.force == 0.0).count(), 2);
        }
    }
    if let Some(peak) = trace.iter().find(|row| row.event == Some(Event::Peak)).filter(|_| damping.is_none()) {
        prop_assert_eq!(
            (peak.indentation, peak.speed, peak.time),
            (impact.row.peak_indentation, 0.0, impact.loading_time)
        );
        prop_assert!(
            impact.row.strain_rate_result.is_some() || peak.force == impact.force_at_peak_indentation,
            "{:?}",
            peak
        );
    }
    if let Some(at) = trace.iter().position(|row| row.event == Some(Event::Relaxation)) {
        let [before, after] = [trace[at - 1], trace[at]];
        prop_assert!(before.event == Some(Event::Peak) && before.time == after.time && before.force > after.force);
        // the reported peak force is the relaxed force and a fifth of its drop
        let reported = after.force + 0.2 * (before.force - after.force);
        assert_close("relaxed", reported, impact.row.peak_force, damping.map_or(1e-11, |_| f64::INFINITY) * reported)?;
    }
    let even: Vec<f64> = trace.iter().filter(|row| row.event.is_none()).map(|row| row.time).collect();
    prop_assert!(even.len() == samples - 2 || is_captured && even.len() < samples, "{} of {}", even.len(), samples);
    #[allow(clippy::cast_precision_loss)]
    for (i, time) in even.iter().enumerate() {
        let want = impact.duration() * (i + 1) as f64 / (samples - 1) as f64;
        assert_close("time", *time, want, run.error_allowance() * impact.duration())?;
    }
    Ok(true)
}

/// Yield and knots come once and in order, each at its place on the law to the last digits, all that were passed; in a
/// dent it yields where the earlier impact turned.
pub fn events_are_where_the_law_has_them(run: &Run) -> Judgement {
    if run.scene.samples.is_none() || !run.is_adaptive() || run.turns_at_subdivision() {
        return Ok(false);
    }
    let own = run.contact_at_own_rate();
    let (scales, law, _) = own.scaling(run.speed().max(2.0 * own.yield_speed().unwrap_or(0.0))).unwrap();
    let peak = run.impact.row.peak_indentation / scales.units.length;
    let of = |wanted: Event| -> Vec<f64> {
        let rows = run.impact.trace.iter().filter(|row| row.event == Some(wanted));
        rows.map(|row| row.indentation / scales.units.length).collect()
    };
    let (knots, yields) = (of(Event::Knot), of(Event::Yield));
    prop_assert!(of(Event::Touch).len() == 1 && of(Event::Peak).len() <= 1 && yields.len() <= 1);
    prop_assert!(knots.is_sorted_by(|one, next| one < next), "{:?}", knots);
    // a formula that takes several pieces continues where they meet
    let starts = law.loading.pieces()[1..].iter().filter(|piece| !piece.is_subdivision).map(|piece| piece.start);
    let starts: Vec<f64> = starts.collect();
    let is_known = |knot: &f64| starts.iter().any(|start| relative_error(*knot, *start) <= 2e-15);
    prop_assert!(knots.iter().all(is_known), "{:?} of {:?}", knots, starts);
    let first = match run.before.memory() {
        Some(memory) if !run.contact.has_rate() => Some(memory.indentation),
        Some(_) => None,
        None => own.yield_indentation_and_force().map(|(indentation, _)| indentation / scales.units.length),
    };
    let Some(first) = first else { return Ok(false) };
    prop_assert!(yields.iter().all(|x| relative_error(*x, first) < 1e-12), "{:?} {}", yields, first);
    prop_assert!(
        yields.len() == usize::from(peak > first) || relative_error(peak, first) <= run.error_allowance(),
        "{:?} {}",
        yields,
        peak
    );
    if run.is_fresh() {
        // first yield is one of the starts of some laws
        let passed = starts.iter().filter(|start| **start < peak && relative_error(**start, first) > 1e-12).count();
        prop_assert_eq!(knots.len(), passed, "{:?} {}", starts, peak);
    }
    Ok(true)
}

/// The rows of a trace between the steps are as good as the tolerance. Near separation an error of the dent of one tolerance changes
/// the force by up to the stiffness.
pub fn samples_are_as_good_as_the_tolerance(run: &Run) -> Judgement {
    let is_fit = run.is_adaptive() && run.contact.forces().is_none() && !run.turns_at_subdivision();
    let Some(samples) = run.scene.samples.filter(|_| is_fit) else { return Ok(false) };
    let (exact, is_own) = (exact(run, Some(samples)), matches!(run.impact.method, Method::Rk8 | Method::ClosedForm));
    let tolerance = if run.impact.method == Method::ClosedForm { 1e-13 } else { run.solver.tolerance };
    let allowed = tolerance * if is_own { 3.0 } else { 100.0 } + 1e-12;
    let [got, want] = [&run.impact, &exact].map(|impact| impact.trace.iter().filter(|row| row.event.is_none()));
    prop_assert_eq!(got.clone().count(), samples - 2);
    for (got, want) in got.zip(want) {
        assert_close("time", got.time, want.time, 1e-14 * exact.row.contact_time)?;
        assert_close("indentation", got.indentation, want.indentation, allowed * exact.row.peak_indentation)?;
        assert_close("speed", got.speed, want.speed, allowed * run.speed())?;
        assert_close("force", got.force, want.force, allowed * exact.row.peak_force)?;
    }
    Ok(samples > 2)
}
