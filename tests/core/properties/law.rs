//! Invariants of the law behind an impact: rows of its trace, its unloading exponent, and the same contact without motion.

use plm_impact::impact::indentation::SetPoint::{Indentation as To, Load};

use super::balances::{Judgement, assert_close};
use super::random_scenario::Run;
use super::trace::rank;
use crate::common::prelude::*;
use crate::impact::forces::exact_solutions;

/// The law of a run whose strength has no rate, with its units and the dent that was there before.
fn law_of(run: &Run) -> Option<(Scales, &Law, Option<LoadingHistory>)> {
    if run.contact.has_rate() {
        return None;
    }
    let fastest = run.speed().max(2.0 * run.contact.yield_speed().unwrap_or(0.0));
    let (scales, law, _) = run.contact.scaling(fastest).unwrap();
    Some((scales, law, run.before.memory().map(|peak| law.history_after(peak))))
}

/// Every row of the trace has the force of the law at its indentation: on the loading curve, up the branch of an old dent, and down
/// the branch of the peak. A captured sphere rests where that branch carries its weight.
pub fn rows_lie_on_the_law(run: &Run) -> Judgement {
    let Some((scales, law, dent)) = law_of(run) else { return Ok(false) };
    let (impact, ground) = (&run.impact, Surface::new(law, dent.as_ref()));
    let unloading = ground.unload_at(impact.row.peak_indentation / scales.units.length - ground.first_contact());
    // the distance to the dent is a small difference of two indentations
    let rounding = 1e-11 * impact.row.peak_indentation / impact.elastic_approach;
    // the rows of fixed steps are interpolated
    let trace = if run.is_adaptive() { &impact.trace[..] } else { &[] };
    for row in trace {
        let x = row.indentation / scales.units.length;
        let want = if rank(row) == 2 { unloading.force(x) } else { ground.loaded_state(x).force };
        let got = row.elastic_force.unwrap_or(row.force);
        assert_close("force", got, want * scales.units.force, rounding * impact.force_at_peak_indentation)?;
    }
    // one that creeps to rest has not turned
    let at_rest = impact.captured_result().and_then(|under| under.static_indentation);
    if let Some(at_rest) = at_rest.filter(|at_rest| *at_rest < 0.99 * impact.row.peak_indentation) {
        let weight = run.contact.mass() * run.contact.forces().gravity.unwrap();
        let carried = unloading.force(at_rest / scales.units.length) * scales.units.force;
        assert_close("weight", carried, weight, 1e-9 * weight + rounding * impact.force_at_peak_indentation)?;
    }
    Ok(!trace.is_empty())
}

/// The exponent of unloading is the one that was asked for, to the last bit where it is a number, or the one that gives back just what
/// was spent, of which a warning tells.
pub fn the_exponent_gives_back_no_more_than_was_spent(run: &Run) -> Judgement {
    let Some((scales, law, None)) = law_of(run) else { return Ok(false) };
    let UnloadingRule::PlmRule(rule) = law.rule_while_loading() else { return Ok(false) };
    let LawChoice::Plm(plm) = run.scene.input().unwrap().law() else { return Ok(false) };
    let used = run.impact.unloading_exponent;
    let x = run.impact.row.peak_indentation / scales.units.length;
    let peak = law.loaded_state(x);
    let asked = match plm.exponent {
        UnloadingExponent::Paper => 1.5,
        UnloadingExponent::Fixed(exponent) => exponent,
        // with hardening the shape of the pressure is another one, and where a sphere flows too
        UnloadingExponent::PressureShape if run.scene.has("half_space.flow_stress") || !run.is_flat_and_alone() => {
            return Ok(false);
        }
        UnloadingExponent::PressureShape => {
            pressure_shape_exponent(rule.radius.pressure_shape_at(peak.force / peak.elastic_approach))
        }
    };
    // f ε/(n + 1) is the work of loading
    let gives_all = peak.force * peak.elastic_approach / law.loading.work(x) - 1.0;
    let is_raised = run.impact.warnings.iter().any(|warning| warning.kind == WarningKind::RaisedExponent);
    // behind an elastic loading it is Hertz's, and next to it rounding decides
    if peak.residual() <= 1e-9 * x {
        return Ok(false);
    }
    if gives_all > asked * (1.0 + 1e-12) {
        assert_close("raised exponent", used, gives_all, 1e-12)?;
        prop_assert!(is_raised || gives_all < asked * (1.0 + 1e-9), "{} {}", gives_all, asked);
    } else {
        let rounding = if plm.exponent == UnloadingExponent::PressureShape { 1e-13 } else { 0.0 };
        assert_close("exponent", used, asked, rounding)?;
        prop_assert!(!is_raised, "{} {}", gives_all, asked);
    }
    Ok(true)
}

/// A contact that is only asked for its force goes up the loading curve, down the branch, up it again, and on beyond the old peak. Its
/// energy is the work of this force, and its stiffness the slope.
pub fn a_force_with_a_memory_goes_the_same_way(run: &Run) -> Judgement {
    let Some((scales, law, None)) = law_of(run) else { return Ok(false) };
    let (contact, mut memory) = (&run.contact, Memory::default());
    let peak = law.loaded_state(run.impact.row.peak_indentation / scales.units.length);
    let unloading = law.unload(peak);
    let (spent, size) = (law.loading.work(peak.indentation), peak.force * peak.indentation);
    for share in [1.0, 0.6, -0.1, 0.6, 1.0, 1.2] {
        let x = peak.residual() + share * peak.elastic_approach;
        let before = memory;
        let force = contact.force(x * scales.units.length, &mut memory);
        let want = if x > peak.indentation { law.loaded_state(x).force } else { unloading.force(x) };
        let rounding = 1e-13 * peak.indentation / peak.elastic_approach;
        assert_close("force", force / scales.units.force, want, rounding * peak.force)?;
        prop_assert_eq!(contact.force(x * scales.units.length, &mut memory.clone()), force, "asked twice");
        prop_assert!(share > 1.0 || before == Memory::default() || before == memory, "{:?}", memory);
        if share <= 1.0 {
            let ContactEnergy { stored, plastic } = contact.energy(x * scales.units.length, force, &memory);
            assert_close("stored", stored / scales.units.energy(), unloading.stored_energy(x), rounding * size)?;
            assert_close(
                "plastic",
                plastic / scales.units.energy(),
                spent - unloading.recoverable_energy(),
                1e-12 * spent,
            )?;
        }
        if share == 0.6 {
            let step = 1e-5 * peak.elastic_approach;
            let slope = (unloading.force(x + step) - unloading.force(x - step)) / (2.0 * step);
            let stiffness =
                contact.stiffness(x * scales.units.length, &memory) * scales.units.length / scales.units.force;
            assert_close("stiffness", stiffness, slope, 1e-6 * slope)?;
        }
    }
    prop_assert!(contact.pair().yield_point.is_some() || memory == Memory::default());
    Ok(true)
}

/// A slow indentation to the depth of an impact has its force and dent, takes its kinetic energy, and gives back what the impact does.
/// Cycles below that depth change nothing of it, and the cycle after it runs back up the branch.
pub fn a_slow_indentation_is_the_impact_without_motion(run: &Run) -> Judgement {
    let Some((_, _, None)) = law_of(run) else { return Ok(false) };
    let Ok(impact) = run.contact.clone().with_forces(Forces::default()).closed_form(run.speed()) else {
        return Ok(false);
    };
    let input = run.scene.input().unwrap();
    let law = input.law();
    let (sphere, half_space) = input.bodies(&law);
    let slow = StaticContact::try_new(&sphere, &half_space, law.as_contact_law()).unwrap();
    let depth = impact.row.peak_indentation;
    let steps = slow.indent(&[To(depth), Load(0.0), To(depth)], None).unwrap().steps;
    let [up, down, again] = steps[..] else { panic!("three steps") };
    let kinetic = impact.row.kinetic_in;
    assert_close("force", up.force, impact.force_at_peak_indentation, 1e-12 * up.force)?;
    assert_close("dent", up.peak.residual_indentation, impact.row.residual_indentation, 1e-12 * depth)?;
    if impact.row.has_dent() {
        assert_close(
            "radius",
            up.peak.contact_radius,
            impact.row.peak_contact_radius,
            1e-12 * impact.row.peak_contact_radius,
        )?;
    }
    let slope = impact.unloading_exponent * up.force / impact.elastic_approach;
    prop_assert!(!run.is_plm() || relative_error(up.peak.unloading_stiffness, slope) < 1e-11, "{:?}", up.peak);
    assert_close("work", up.work, kinetic, 1e-12 * kinetic)?;
    assert_close("back", -down.work, impact.row.restitution.powi(2) * kinetic, 1e-12 * kinetic)?;
    assert_close("plastic", up.plastic_work, up.work + down.work, 1e-12 * kinetic)?;
    prop_assert_eq!((again.plastic_work, again.peak), (0.0, up.peak));
    assert_close("force again", again.force, up.force, 1e-12 * up.force)?;
    assert_close("work again", again.work, -down.work, 1e-12 * kinetic)?;
    // above the lower peak the law may have no answer
    if let Ok(cycles) = slow.indent(&[To(0.4 * depth), Load(0.0), To(depth)], None) {
        let last = cycles.steps[2];
        assert_close("force of cycles", last.force, up.force, 1e-13 * up.force)?;
        assert_close("dent of cycles", last.peak.residual_indentation, up.peak.residual_indentation, 1e-13 * depth)?;
        let plastic = cycles.steps.iter().map(|step| step.plastic_work).sum::<f64>();
        assert_close("plastic work of cycles", plastic, up.plastic_work, 1e-12 * kinetic)?;
    }
    Ok(true)
}

/// Under the damping of Hunt and Crossley alone the force at every speed has a closed form, on any spot.
pub fn hunt_and_crossley_need_no_steps(run: &Run) -> Judgement {
    let (Some((scales, law, dent)), Forces { gravity: None, damping, waveguide: None, .. }) =
        (law_of(run), *run.contact.forces())
    else {
        return Ok(false);
    };
    let Some(Damping::HuntCrossley(chi)) = damping.filter(|_| run.is_plm() && run.is_adaptive()) else {
        return Ok(false);
    };
    let damped = crate::impact::forces::damped(chi * scales.speed);
    let exact = exact_solutions::solve(Surface::new(law, dent.as_ref()), run.speed() / scales.speed, &damped);
    let allowed = 10.0 * run.error_allowance() + 1e-9;
    for (name, got, want) in [
        ("restitution", run.impact.row.restitution, exact.restitution),
        ("largest force", run.impact.row.peak_force / scales.units.force, exact.largest_force),
        ("peak", run.impact.row.peak_indentation / scales.units.length, exact.unloading.peak.indentation),
        ("loading time", run.impact.loading_time / scales.time(), exact.loading_time),
        ("contact time", run.impact.row.contact_time / scales.time(), exact.contact_time),
    ] {
        assert_close(name, got, want, allowed * want)?;
    }
    Ok(true)
}

/// The energy fraction of elastic waves is the integral over loading and unloading.
pub fn waves_take_the_integral(run: &Run) -> Judgement {
    let is_alone = run.contact.forces().is_none() && run.is_fresh() && run.is_plm() && !run.contact.has_rate();
    let Some(share) = run.impact.row.wave_loss_fraction.filter(|_| is_alone && run.is_adaptive()) else {
        return Ok(false);
    };
    let want = crate::impact::waves::loss_by_quadrature(&run.contact, run.speed());
    assert_close("waves", share, want, (1e-10 + run.error_allowance()) * want)?;
    Ok(true)
}

/// An impact has the warning of its depth just if its depth exceeds the depth limit that a code without impacts gets.
pub fn an_impact_deeper_than_the_data_is_warned_of(run: &Run) -> Judgement {
    let is_of_depth = |warning: &Warning| match warning.kind {
        WarningKind::DeepDent | WarningKind::BeyondFlowCurve => true,
        WarningKind::OutsideStated => {
            // the indentation, and the lower end of the range
            let numbers: Vec<f64> = warning.to_string().split(' ').filter_map(|word| word.parse().ok()).collect();
            numbers[0] > numbers[1]
        }
        _ => false,
    };
    let (depth, deepest) = (run.impact.row.peak_indentation, run.contact_at_own_rate().validated_indentation());
    if !run.is_fresh() || relative_error(depth, deepest) < 1e-9 {
        return Ok(false);
    }
    prop_assert_eq!(run.impact.warnings.iter().any(is_of_depth), depth > deepest, "{} {}", depth, deepest);
    Ok(true)
}
