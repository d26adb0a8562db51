//! Invariants between an impact and its repetition by another method, without a trace, or as a row of a table.

use super::balances::{Judgement, assert_close};
use super::random_scenario::{KeySetting, Run, WAVEGUIDES};
use crate::common::prelude::*;

/// All that is reported of an impact, as text, so that no number is equal to itself too.
fn debug_text<T: std::fmt::Debug>(result: &T) -> String {
    format!("{result:?}")
}

/// A row of a table has the bits of the impact, by the library and in a table of the scenario. With partial slip both are within 1e-5
/// of each other.
pub fn a_row_has_the_bits_of_the_impact(run: &Run) -> Judgement {
    if !run.is_fresh() || run.scene.has("impact.drop_height") {
        return Ok(false);
    }
    let impact = run.contact.impact(run.approach, &run.solver, None).unwrap().row;
    let list = vec![format!("sweep={{\"impact.speed\"=[{:e}]}}", run.scene.input().unwrap().speed())];
    let plan = run.scene.without(&["impact.speed"]).scenario(&list).unwrap().plan().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).append_rows(0..1, &mut rows);
    let of_library = run.contact.row(run.approach, &run.solver).unwrap();
    prop_assert_eq!(debug_text(&rows.results[0].unwrap()), debug_text(&of_library));
    let [mut row, mut impact] = [of_library, impact];
    let is_run = |rebound: &Rebound| rebound.psi != 0.0 && (!rebound.is_sliding || rebound.error > 0.0);
    let slips = |of: &ImpactRow| of.rebound.filter(is_run);
    if let (Some(one), Some(other)) = (slips(&row), slips(&impact)) {
        let apart = (one.contact_point_restitution - other.contact_point_restitution).abs();
        prop_assert!(apart <= 1e-5, "{:e}", apart);
        (row.rebound, impact.rebound) = (None, None);
    }
    prop_assert_eq!(debug_text(&row), debug_text(&impact));
    Ok(true)
}

/// A trace changes neither the results nor the work, but for the error of the energy, which its rows show too.
pub fn a_trace_changes_no_bit(run: &Run) -> Judgement {
    if matches!(run.solver.method, Method::Auto | Method::ClosedForm) {
        return Ok(false);
    }
    let with = |samples| {
        let mut impact = run.contact.impact_on(&mut run.before.clone(), run.approach, &run.solver, samples).unwrap();
        impact.energy.balance_error = 0.0;
        impact.warnings.clear();
        impact.trace.clear();
        debug_text(&impact)
    };
    prop_assert_eq!(with(Some(30)), with(None));
    Ok(true)
}

/// Without earlier impacts a spot is fresh surface, to the last bit; and with friction the normal motion is that of the straight
/// impact.
pub fn spot_and_friction_leave_the_normal_motion(run: &Run) -> Judgement {
    if !run.is_fresh() {
        return Ok(false);
    }
    let by = |approach: Approach| run.contact.impact(approach, &run.solver, run.scene.samples).unwrap();
    prop_assert_eq!(debug_text(&by(run.approach)), debug_text(&run.impact));
    if run.approach.friction.is_none() {
        return Ok(true);
    }
    let (mut straight, mut oblique) = (by(run.speed().into()), run.impact.clone());
    oblique.row.rebound = None;
    oblique.oblique = None;
    for impact in [&mut straight, &mut oblique] {
        impact.speed = 0.0;
        impact.warnings.clear();
        impact.trace.iter_mut().for_each(|row| row.friction = None);
    }
    prop_assert_eq!(debug_text(&oblique), debug_text(&straight));
    Ok(true)
}

/// The impact by the closed form, or by rk8 at the finest tolerance if it has no closed form.
pub fn exact(run: &Run, samples: Option<usize>) -> Impact {
    let method = if run.has_drag() { Method::Rk8 } else { Method::ClosedForm };
    run.contact.impact_on(&mut run.before.clone(), run.approach, &solver(method, 1e-13), samples).unwrap()
}

/// Every method comes to the same impact within its tolerance, and under gravity to its times.
pub fn methods_agree(run: &Run) -> Judgement {
    if !run.is_adaptive() || run.turns_at_subdivision() {
        return Ok(false);
    }
    let (got, exact, slack) = (&run.impact, exact(run, None), run.error_allowance());
    let (peak, size) = (exact.row.peak_indentation, 2.0 * run.input_energy());
    for (name, part, unit) in [
        ("peak force", (|of| of.row.peak_force) as fn(&Impact) -> f64, exact.row.peak_force),
        ("peak indentation", |of| of.row.peak_indentation, peak),
        ("contact radius", |of| of.row.peak_contact_radius, exact.row.peak_contact_radius),
        ("elastic approach", |of| of.elastic_approach, peak),
        ("dent", |of| of.row.residual_indentation, peak),
        ("flat", |of| of.row.flat_depth, peak),
        ("recovered", |of| of.energy.recovered, size),
        ("plastic", |of| of.energy.plastic.unwrap_or(0.0), size),
    ] {
        assert_close(name, part(got), part(&exact), slack * unit)?;
    }
    let has_times =
        exact.captured_result().is_none() && got.captured_result().is_none() && exact.row.restitution > 1e-3;
    if run.contact.forces().is_none() {
        for (name, part) in [
            ("restitution", (|of| of.row.restitution) as fn(&Impact) -> f64),
            ("contact time", |of| of.row.contact_time),
            ("loading time", |of| of.loading_time),
            ("exponent", |of| of.unloading_exponent),
            // an integral over the whole law
            ("waves", |of| 0.1 * of.row.wave_loss_fraction.unwrap_or(0.0)),
        ] {
            assert_close(
                name,
                part(got),
                part(&exact),
                slack * part(&exact).max(exact.row.wave_loss_fraction.unwrap_or(0.0)),
            )?;
        }
        prop_assert!(run.earlier.is_some() || got.accuracy.restitution_error <= slack);
    } else if !run.has_drag() && has_times {
        let fine = run.contact.impact_on(&mut run.before.clone(), run.approach, &solver(Method::Rk8, 1e-13), None);
        let fine = fine.unwrap();
        if fine.captured_result().is_some() {
            return Ok(true);
        }
        assert_close("contact time", fine.row.contact_time, exact.row.contact_time, 1e-9 * exact.row.contact_time)?;
        assert_close("loading time", fine.loading_time, exact.loading_time, 1e-9 * exact.loading_time)?;
    }
    Ok(true)
}

/// Damping of nothing takes nothing. The run of it goes by another stepper, and comes to the same impact.
pub fn damping_of_nothing_changes_nothing(run: &Run) -> Judgement {
    if run.has_drag() || !run.is_adaptive() || run.turns_at_subdivision() {
        return Ok(false);
    }
    let nothing = if run.scene.samples.is_some() { Damping::Viscous(0.0) } else { Damping::HuntCrossley(0.0) };
    let damped = run.contact.clone().with_forces(Forces { damping: Some(nothing), ..*run.contact.forces() });
    let solver = solver(Method::Rk8, run.solver.tolerance);
    let got = damped.impact_on(&mut run.before.clone(), run.approach, &solver, None).unwrap();
    let (want, slack) = (&run.impact, run.error_allowance().max(10.0 * run.solver.tolerance));
    prop_assert_eq!(got.forces_result.unwrap().damping_loss, Some(0.0));
    assert_close("peak force", got.row.peak_force, want.row.peak_force, 2.0 * slack * want.row.peak_force)?;
    assert_close("peak", got.row.peak_indentation, want.row.peak_indentation, 2.0 * slack * want.row.peak_indentation)?;
    assert_close(
        "dent",
        got.row.residual_indentation,
        want.row.residual_indentation,
        2.0 * slack * want.row.peak_indentation,
    )?;
    assert_close("recovered", got.energy.recovered, want.energy.recovered, 4.0 * slack * run.input_energy())?;
    if run.contact.forces().is_none() {
        assert_close("contact time", got.row.contact_time, want.row.contact_time, 2.0 * slack * want.row.contact_time)?;
        prop_assert_eq!(got.row.has_dent(), want.row.has_dent());
    }
    if let (Some(one), Some(other)) = (got.row.rebound, want.row.rebound) {
        assert_close("friction", one.impulse_ratio, other.impulse_ratio, 1e-5)?;
    }
    Ok(true)
}

/// Many fixed steps come near to the impact, with every force and in every dent.
pub fn fixed_steps_come_near(run: &Run) -> Judgement {
    if run.turns_at_subdivision() || run.impact.captured_result().is_some() {
        return Ok(false);
    }
    let steps = Solver { method: Method::Verlet, steps_per_contact: 2000, ..Solver::default() };
    // a sphere that creeps to rest takes too many
    let Ok(fixed) = run.contact.impact_on(&mut run.before.clone(), run.speed(), &steps, None) else { return Ok(false) };
    let exact = exact(run, None);
    assert_close("peak", fixed.row.peak_indentation, exact.row.peak_indentation, 1e-2 * exact.row.peak_indentation)?;
    assert_close("recovered", fixed.energy.recovered, exact.energy.recovered, 1e-2 * run.input_energy())?;
    if fixed.captured_result().is_none() && exact.captured_result().is_none() {
        assert_close("contact time", fixed.row.contact_time, exact.row.contact_time, 1e-2 * exact.row.contact_time)?;
    }
    Ok(true)
}

/// Keys without effect change nothing: a harder sphere and a rate of zero to the last bit; flow curves that do not rise, and a body
/// that is flat and very heavy, to rounding.
pub fn what_has_no_effect_changes_nothing(run: &Run) -> Judgement {
    let (scene, contact) = (&run.scene, &run.contact);
    if !run.is_fresh() || run.approach.friction.is_some() || run.turns_at_subdivision() {
        return Ok(false);
    }
    let with = |path, number| scene.with(path, KeySetting::Number(number));
    let (mut others, rounding) = (Vec::new(), 1e-12 + run.error_allowance());
    if let (true, Some(strength), None) =
        (run.is_plm(), contact.half_space().yield_strength, contact.sphere().yield_strength)
    {
        if !contact.has_rate() {
            others.push((with("sphere.yield_strength", 10.0 * strength), 0.0));
            others.push((with("half_space.rate.johnson_cook.c", 0.0), 0.0));
        }
        if !scene.has("half_space.flow_stress") && run.is_adaptive() {
            let voce = with("half_space.flow_stress.voce.rate", 20.0);
            let level = KeySetting::Points(vec![[1e-3, strength], [0.02, strength]]);
            others.extend([
                (with("half_space.flow_stress.power.exponent", 0.0), rounding),
                (with("half_space.flow_stress.linear.slope", 0.0), rounding),
                (voce.with("half_space.flow_stress.voce.saturation", KeySetting::Number(0.0)), rounding),
                (scene.with("half_space.flow_stress.points", level), rounding),
            ]);
        }
    }
    let is_bare = ["half_space.radius", "half_space.mass", "half_space.density", "gravity"];
    if !is_bare.iter().any(|begin| scene.has(begin)) && run.is_adaptive() {
        let radius = 1e15 * contact.sphere().radius;
        let heavy = with("half_space.mass", 1e15 * contact.mass());
        let others_of_shape = [radius, -radius].map(|radius| with("half_space.radius", radius));
        let both = heavy.with("half_space.radius", KeySetting::Number(radius));
        others.extend(others_of_shape.into_iter().chain([heavy, both]).map(|other| (other, rounding)));
    }
    let mut compared = 0;
    for (other, allowed) in others {
        let Ok(other) = other.run() else { continue };
        let [got, want] = [&other.impact, &run.impact];
        if allowed == 0.0 {
            let row = ImpactRow { strain_rate_result: None, ..got.row };
            prop_assert_eq!(debug_text(&row), debug_text(&want.row), "{:?}", other.scene);
            prop_assert_eq!(debug_text(&got.trace), debug_text(&want.trace), "{:?}", other.scene);
        }
        let sizes =
            [want.row.peak_force, want.row.peak_indentation, want.row.peak_contact_radius, want.loading_time, 1.0];
        let numbers = |of: &Impact| {
            let wide = [of.row.peak_force, of.row.peak_indentation, of.row.peak_contact_radius, of.loading_time];
            [&wide[..], &[of.unloading_exponent]].concat()
        };
        for ((got, want), size) in numbers(got).into_iter().zip(numbers(want)).zip(sizes) {
            assert_close("size", got, want, allowed * size)?;
        }
        assert_close("recovered", got.energy.recovered, want.energy.recovered, 4.0 * allowed * run.input_energy())?;
        assert_close(
            "dent",
            got.row.residual_indentation,
            want.row.residual_indentation,
            allowed * want.row.peak_indentation,
        )?;
        compared += 1;
    }
    Ok(compared > 0)
}

/// Damping, a plate and a rod take energy: the sphere goes in no deeper than without them, and on a plate or rod it is pressed no
/// harder and comes back no faster, on a thinner one still less.
pub fn damping_and_a_waveguide_only_take(run: &Run) -> Judgement {
    if !run.has_drag() || !run.is_adaptive() {
        return Ok(false);
    }
    let free = run.scene.without(&["damping", "solver"]).without(&WAVEGUIDES);
    let bare = free.without(&["half_space.density"]);
    let free = if run.scene.has("half_space.mass") { free.run() } else { bare.run() };
    // without drag it may go in too deep, or beyond the range of the law
    let Ok(free) = free else { return Ok(false) };
    let (deepest, most) = (run.impact.row.peak_indentation, free.impact.row.peak_indentation);
    prop_assert!(deepest <= most * (1.0 + 1e-8 + run.error_allowance()), "{} {}", deepest, most);
    if let (Some(guide), None) = (run.contact.forces().waveguide, run.contact.forces().gravity) {
        let thinner = run.scene.with(guide.kind().size_key(), KeySetting::Number(0.9 * guide.size()));
        // a plate or rod that is too thin is refused
        let thinner = thinner.run().map(|thinner| thinner.impact).ok();
        for [less, more] in
            [[&run.impact, &free.impact]].into_iter().chain(thinner.as_ref().map(|thin| [thin, &run.impact]))
        {
            prop_assert!(
                less.row.peak_force <= more.row.peak_force * (1.0 + 1e-8 + run.error_allowance()),
                "{:?} {:?}",
                less,
                more
            );
            prop_assert!(
                less.row.restitution <= more.row.restitution + 1e-8 + run.error_allowance(),
                "{:?} {:?}",
                less,
                more
            );
        }
    }
    Ok(true)
}
