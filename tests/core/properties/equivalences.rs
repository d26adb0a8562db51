//! Invariants between an impact and its repetition by another method, without a trace, or as a row of a table.

use super::balances::{Judged, near};
use super::random_scene::{Given, Run};
use crate::common::prelude::*;

/// All that is reported of an impact, as text, so that no number is equal to itself too.
fn text<T: std::fmt::Debug>(result: &T) -> String {
    format!("{result:?}")
}

/// A row of a table has the bits of the impact, by the library and in a table of the scenario. With partial slip both are within 1e-5
/// of each other.
pub fn a_row_has_the_bits_of_the_impact(run: &Run) -> Judged {
    if !run.is_fresh() || run.scene.has("impact.drop_height") {
        return Ok(false);
    }
    let impact = run.contact.impact(run.approach, &run.solver, None).unwrap().essentials;
    let list = vec![format!("sweep={{\"impact.speed\"=[{:e}]}}", run.approach.speed)];
    let plan = run.scene.without(&["impact.speed"]).scenario(&list).unwrap().plan().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).append_rows(0..1, &mut rows);
    let of_library = run.contact.row(run.approach, &run.solver).unwrap();
    prop_assert_eq!(text(&rows.results[0].unwrap()), text(&of_library));
    let [mut row, mut impact] = [of_library, impact];
    let is_run = |rebound: &Rebound| rebound.psi != 0.0 && (!rebound.is_sliding || rebound.error > 0.0);
    let slips = |of: &ImpactRow| of.rebound.filter(is_run);
    if let (Some(one), Some(other)) = (slips(&row), slips(&impact)) {
        let apart = (one.contact_point_restitution - other.contact_point_restitution).abs();
        prop_assert!(apart <= 1e-5, "{:e}", apart);
        (row.rebound, impact.rebound) = (None, None);
    }
    prop_assert_eq!(text(&row), text(&impact));
    Ok(true)
}

/// A trace changes neither the results nor the work, but for the error of the energy, which its rows show too.
pub fn a_trace_changes_no_bit(run: &Run) -> Judged {
    if matches!(run.solver.method, Method::Auto | Method::ClosedForm) {
        return Ok(false);
    }
    let with = |samples| {
        let mut impact = run.contact.impact_on(&mut run.before.clone(), run.approach, &run.solver, samples).unwrap();
        impact.energy.drift = 0.0;
        impact.warnings.clear();
        impact.trace.clear();
        text(&impact)
    };
    prop_assert_eq!(with(Some(30)), with(None));
    Ok(true)
}

/// Without earlier impacts a spot is fresh surface, to the last bit; and with friction the normal motion is that of the straight
/// impact.
pub fn spot_and_friction_leave_the_normal_motion(run: &Run) -> Judged {
    if !run.is_fresh() {
        return Ok(false);
    }
    let by = |approach: Approach| run.contact.impact(approach, &run.solver, run.scene.samples).unwrap();
    prop_assert_eq!(text(&by(run.approach)), text(&run.impact));
    if run.approach.incidence.is_none() {
        return Ok(true);
    }
    let (mut straight, mut oblique) = (by(run.speed().into()), run.impact.clone());
    oblique.essentials.rebound = None;
    oblique.oblique = None;
    for impact in [&mut straight, &mut oblique] {
        impact.speed = 0.0;
        impact.warnings.clear();
        impact.trace.iter_mut().for_each(|row| row.friction = None);
    }
    prop_assert_eq!(text(&oblique), text(&straight));
    Ok(true)
}

/// The impact by the closed form, or by rk8 at the finest tolerance if it has no closed form.
pub fn exact(run: &Run, samples: Option<usize>) -> Impact {
    let method = if run.has_drag() { Method::Rk8 } else { Method::ClosedForm };
    run.contact.impact_on(&mut run.before.clone(), run.approach, &solver(method, 1e-13), samples).unwrap()
}

/// Every method comes to the same impact within its tolerance, and under gravity to its times.
pub fn methods_agree(run: &Run) -> Judged {
    if !run.is_adaptive() || run.turns_at_a_joint() {
        return Ok(false);
    }
    let (got, exact, slack) = (&run.impact, exact(run, None), run.slack());
    let (peak, size) = (exact.peak_indentation, 2.0 * run.put_in());
    for (name, part, unit) in [
        ("peak force", (|of| of.peak_force) as fn(&Impact) -> f64, exact.peak_force),
        ("peak indentation", |of| of.peak_indentation, peak),
        ("contact radius", |of| of.peak_contact_radius, exact.peak_contact_radius),
        ("elastic approach", |of| of.elastic_approach, peak),
        ("dent", |of| of.residual_indentation, peak),
        ("flat", |of| of.flat_depth, peak),
        ("recovered", |of| of.energy.recovered, size),
        ("plastic", |of| of.energy.plastic.unwrap_or(0.0), size),
    ] {
        near(name, part(got), part(&exact), slack * unit)?;
    }
    let has_times = exact.captured_result().is_none() && got.captured_result().is_none() && exact.restitution > 1e-3;
    if run.contact.forces().is_none() {
        for (name, part) in [
            ("restitution", (|of| of.restitution) as fn(&Impact) -> f64),
            ("contact time", |of| of.contact_time),
            ("loading time", |of| of.loading_time),
            ("exponent", |of| of.unloading_exponent),
            // an integral over the whole law
            ("waves", |of| 0.1 * of.wave_loss_fraction.unwrap_or(0.0)),
        ] {
            near(name, part(got), part(&exact), slack * part(&exact).max(exact.wave_loss_fraction.unwrap_or(0.0)))?;
        }
        prop_assert!(run.earlier.is_some() || got.accuracy.restitution_error <= slack);
    } else if !run.has_drag() && has_times {
        let fine = run.contact.impact_on(&mut run.before.clone(), run.approach, &solver(Method::Rk8, 1e-13), None);
        let fine = fine.unwrap();
        if fine.captured_result().is_some() {
            return Ok(true);
        }
        near("contact time", fine.contact_time, exact.contact_time, 1e-9 * exact.contact_time)?;
        near("loading time", fine.loading_time, exact.loading_time, 1e-9 * exact.loading_time)?;
    }
    Ok(true)
}

/// Damping of nothing takes nothing. The run of it goes by another stepper, and comes to the same impact.
pub fn damping_of_nothing_changes_nothing(run: &Run) -> Judged {
    if run.has_drag() || !run.is_adaptive() || run.turns_at_a_joint() {
        return Ok(false);
    }
    let nothing = if run.scene.samples.is_some() { Damping::Viscous(0.0) } else { Damping::HuntCrossley(0.0) };
    let damped = run.contact.clone().with_forces(Forces { damping: Some(nothing), ..*run.contact.forces() });
    let solver = solver(Method::Rk8, run.solver.tolerance);
    let got = damped.impact_on(&mut run.before.clone(), run.approach, &solver, None).unwrap();
    let (want, slack) = (&run.impact, run.slack().max(10.0 * run.solver.tolerance));
    prop_assert_eq!(got.forces_result.unwrap().damping_loss, Some(0.0));
    near("peak force", got.peak_force, want.peak_force, 2.0 * slack * want.peak_force)?;
    near("peak", got.peak_indentation, want.peak_indentation, 2.0 * slack * want.peak_indentation)?;
    near("dent", got.residual_indentation, want.residual_indentation, 2.0 * slack * want.peak_indentation)?;
    near("recovered", got.energy.recovered, want.energy.recovered, 4.0 * slack * run.put_in())?;
    if run.contact.forces().is_none() {
        near("contact time", got.contact_time, want.contact_time, 2.0 * slack * want.contact_time)?;
        prop_assert_eq!(got.has_dent(), want.has_dent());
    }
    if let (Some(one), Some(other)) = (got.rebound, want.rebound) {
        near("friction", one.impulse_ratio, other.impulse_ratio, 1e-5)?;
    }
    Ok(true)
}

/// Many fixed steps come near to the impact, with every force and in every dent.
pub fn fixed_steps_come_near(run: &Run) -> Judged {
    if run.turns_at_a_joint() || run.impact.captured_result().is_some() {
        return Ok(false);
    }
    let steps = Solver { method: Method::Verlet, steps_per_contact: 2000, ..Solver::default() };
    // a sphere that creeps to rest takes too many
    let Ok(fixed) = run.contact.impact_on(&mut run.before.clone(), run.speed(), &steps, None) else { return Ok(false) };
    let exact = exact(run, None);
    near("peak", fixed.peak_indentation, exact.peak_indentation, 1e-2 * exact.peak_indentation)?;
    near("recovered", fixed.energy.recovered, exact.energy.recovered, 1e-2 * run.put_in())?;
    if fixed.captured_result().is_none() && exact.captured_result().is_none() {
        near("contact time", fixed.contact_time, exact.contact_time, 1e-2 * exact.contact_time)?;
    }
    Ok(true)
}

/// Keys without effect change nothing: a harder sphere and a rate of zero to the last bit; flow curves that do not rise, and a body
/// that is flat and very heavy, to rounding.
pub fn what_has_no_effect_changes_nothing(run: &Run) -> Judged {
    let (scene, contact) = (&run.scene, &run.contact);
    if !run.is_fresh() || run.approach.incidence.is_some() || run.turns_at_a_joint() {
        return Ok(false);
    }
    let with = |path, number| scene.with(path, Given::Number(number));
    let (mut others, rounding) = (Vec::new(), 1e-12 + run.slack());
    if let (true, Some(strength), None) =
        (run.is_plm(), contact.half_space().yield_strength, contact.sphere().yield_strength)
    {
        if !contact.has_rate() {
            others.push((with("sphere.yield_strength", 10.0 * strength), 0.0));
            others.push((with("half_space.rate.johnson_cook.c", 0.0), 0.0));
        }
        if !scene.has("half_space.flow_stress") && run.is_adaptive() {
            let voce = with("half_space.flow_stress.voce.rate", 20.0);
            let level = Given::Points(vec![[1e-3, strength], [0.02, strength]]);
            others.extend([
                (with("half_space.flow_stress.power.exponent", 0.0), rounding),
                (with("half_space.flow_stress.linear.slope", 0.0), rounding),
                (voce.with("half_space.flow_stress.voce.saturation", Given::Number(0.0)), rounding),
                (scene.with("half_space.flow_stress.points", level), rounding),
            ]);
        }
    }
    let is_bare = ["half_space.radius", "half_space.mass", "half_space.density", "gravity"];
    if !is_bare.iter().any(|begin| scene.has(begin)) && run.is_adaptive() {
        let radius = 1e15 * contact.sphere().radius;
        let heavy = with("half_space.mass", 1e15 * contact.mass());
        let others_of_shape = [radius, -radius].map(|radius| with("half_space.radius", radius));
        let both = heavy.with("half_space.radius", Given::Number(radius));
        others.extend(others_of_shape.into_iter().chain([heavy, both]).map(|other| (other, rounding)));
    }
    let mut compared = 0;
    for (other, allowed) in others {
        let Ok(other) = other.run() else { continue };
        let [got, want] = [&other.impact, &run.impact];
        if allowed == 0.0 {
            let essentials = ImpactRow { strain_rate_result: None, ..got.essentials };
            prop_assert_eq!(text(&essentials), text(&want.essentials), "{:?}", other.scene);
            prop_assert_eq!(text(&got.trace), text(&want.trace), "{:?}", other.scene);
        }
        let sizes = [want.peak_force, want.peak_indentation, want.peak_contact_radius, want.loading_time, 1.0];
        let numbers = |of: &Impact| {
            let wide = [of.peak_force, of.peak_indentation, of.peak_contact_radius, of.loading_time];
            [&wide[..], &[of.unloading_exponent]].concat()
        };
        for ((got, want), size) in numbers(got).into_iter().zip(numbers(want)).zip(sizes) {
            near("size", got, want, allowed * size)?;
        }
        near("recovered", got.energy.recovered, want.energy.recovered, 4.0 * allowed * run.put_in())?;
        near("dent", got.residual_indentation, want.residual_indentation, allowed * want.peak_indentation)?;
        compared += 1;
    }
    Ok(compared > 0)
}

/// Damping and a plate take energy: the sphere goes in no deeper than without them, and on a plate it is pressed no harder and comes
/// back no faster, on a thinner one still less.
pub fn damping_and_a_plate_only_take(run: &Run) -> Judged {
    if !run.has_drag() || !run.is_adaptive() {
        return Ok(false);
    }
    let free = run.scene.without(&["damping", "half_space.thickness", "solver"]);
    let bare = free.without(&["half_space.density"]);
    let free = if run.scene.has("half_space.mass") { free.run() } else { bare.run() };
    // without drag it may go in too deep, or beyond the range of the law
    let Ok(free) = free else { return Ok(false) };
    let (deepest, most) = (run.impact.peak_indentation, free.impact.peak_indentation);
    prop_assert!(deepest <= most * (1.0 + 1e-8 + run.slack()), "{} {}", deepest, most);
    if let (Some(plate), None) = (run.contact.forces().plate, run.contact.forces().gravity) {
        let thinner = run.scene.with("half_space.thickness", Given::Number(0.9 * plate.thickness));
        // a plate that is too thin is refused
        let thinner = thinner.run().map(|thinner| thinner.impact).ok();
        for [less, more] in
            [[&run.impact, &free.impact]].into_iter().chain(thinner.as_ref().map(|thin| [thin, &run.impact]))
        {
            prop_assert!(less.peak_force <= more.peak_force * (1.0 + 1e-8 + run.slack()), "{:?} {:?}", less, more);
            prop_assert!(less.restitution <= more.restitution + 1e-8 + run.slack(), "{:?} {:?}", less, more);
        }
    }
    Ok(true)
}
