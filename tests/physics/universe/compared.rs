//! What holds between an impact and the same one by another method, without a trace, as a row of a table, in other units.

use plm_impact::scenario::scene::results::Shown;
use plm_impact::scenario::scene::results::impact::{Single, results};
use plm_impact::units::Dimension;

use super::balances::{Judged, near};
use super::scene::{AnyScene, Given, Refused, Run};
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
    Evaluator::new(&plan).rows(0..1, &mut rows);
    let of_library = run.contact.row(run.approach, &run.solver).unwrap();
    prop_assert_eq!(text(&rows.results[0].unwrap()), text(&of_library));
    let [mut row, mut impact] = [of_library, impact];
    let is_run = |rebound: &Rebound| rebound.psi != 0.0 && (!rebound.is_sliding || rebound.error > 0.0);
    let slips = |of: &Essentials| of.rebound.filter(is_run);
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

/// The impact by the closed form, or where there is none by rk8 at the finest tolerance.
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
    let has_times = exact.captured().is_none() && got.captured().is_none() && exact.restitution > 1e-3;
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
        if fine.captured().is_some() {
            return Ok(true);
        }
        near("contact time", fine.contact_time, exact.contact_time, 1e-9 * exact.contact_time)?;
        near("loading time", fine.loading_time, exact.loading_time, 1e-9 * exact.loading_time)?;
    }
    Ok(true)
}

/// Exponents of length, time and mass.
fn exponents(dimension: Dimension) -> [i32; 3] {
    match dimension {
        Dimension::Length => [1, 0, 0],
        Dimension::Time => [0, 1, 0],
        Dimension::Speed => [1, -1, 0],
        Dimension::Acceleration => [1, -2, 0],
        Dimension::InverseSpeed => [-1, 1, 0],
        Dimension::Mass => [0, 0, 1],
        Dimension::Density => [-3, 0, 1],
        Dimension::Pressure => [-1, -2, 1],
        Dimension::Force => [1, -2, 1],
        Dimension::Energy => [2, -2, 1],
        Dimension::Stiffness => [0, -2, 1],
        Dimension::AngularSpeed | Dimension::StrainRate => [0, -1, 0],
        Dimension::MomentOfInertia => [2, 0, 1],
        Dimension::Viscosity => [-1, -1, 1],
        Dimension::Angle | Dimension::Ratio => [0, 0, 0],
    }
}

/// This scene in units that are so many times as large, in every key.
fn in_other_units(scene: &AnyScene, factor: impl Fn(Dimension) -> f64) -> AnyScene {
    let mut other = scene.clone();
    for (path, given) in &mut other.keys {
        let key = EVERY_KEY.iter().find(|key| key.path == *path);
        match given {
            Given::Number(number) => *number *= factor(key.unwrap().number().unwrap().0.dimension),
            Given::Points(points) => points.iter_mut().for_each(|point| point[1] *= factor(Dimension::Pressure)),
            Given::Word(_) => {}
        }
    }
    // the rates that are taken where none is given
    for (path, rate, of) in [
        ("half_space.rate.johnson_cook.reference", 1.0, "half_space.rate.johnson_cook"),
        ("half_space.rate.tested_at", 1e-3, "half_space.rate"),
    ] {
        if scene.has(of) {
            other = other.with(path, Given::Number(rate * factor(Dimension::StrainRate)));
        }
    }
    other
}

/// Every reported number has its unit: lengths, times and masses of another size in every key change it by the factor of its
/// dimension. Another size of all bodies, heavier ones, and stiffer ones at the same v/v_Y are such changes. In fixed steps rounding
/// may decide in which of two steps a sphere turns; and in the dent of a metal with a rate, whether a branch with a raised exponent
/// is kept.
pub fn units_do_not_matter(run: &Run) -> Judged {
    if !run.is_adaptive() || run.turns_at_a_joint() || run.contact.has_rate() && run.earlier.is_some() {
        return Ok(false);
    }
    let [length, time, mass] = sizes_of_units(&run.scene);
    let factor = |dimension| {
        let [of_length, of_time, of_mass] = exponents(dimension);
        length.powi(of_length) * time.powi(of_time) * mass.powi(of_mass)
    };
    let other = match in_other_units(&run.scene, factor).run() {
        Ok(other) => other,
        // extreme units leave the range of double precision, or that of a spin, and the error says so
        Err(Refused::ByImpact(ImpactError::Range(_))) => return Ok(false),
        Err(Refused::ByKeys(error)) if error.to_string().contains("a spin must be") => return Ok(false),
        Err(error) => return Err(TestCaseError::fail(text(&error))),
    };
    let is_exact = run.impact.method == Method::ClosedForm && run.contact.forces().is_none();
    let more = if run.contact.forces().is_none() { 1.0 } else { 10.0 };
    let allowed = if is_exact { 1e-12 } else { more * run.slack() };
    // the weight may do nearly all of the work, of which the kinetic energy is a small part; rounding changes the lengths of the
    // steps of friction, whose runs are exact to 1e-7
    let allowed = if run.impact.has_speed() { allowed * run.put_in() / run.impact.kinetic_in } else { allowed };
    let allowed = if run.impact.rebound.is_some() { allowed.max(1e-7) } else { allowed };
    let sizes = [run.impact.peak_indentation, run.impact.peak_force, run.put_in()];
    let [one, two] = [run, &other].map(|run| (&run.contact, &run.impact));
    let [one, two] = [one, two].map(|(contact, impact)| Single { contact, impact, band: None });
    let mut compared = 0;
    for result in results() {
        let of_run = ["work.", "accuracy.", "verlet.", "friction_error", "energy.drift", "energy.angular"];
        if of_run.iter().any(|begin| result.name.starts_with(begin)) {
            continue;
        }
        let dimension = match result.shown {
            Shown::In(dimension) => dimension,
            _ if result.name.ends_with("_Pa") => Dimension::Pressure,
            _ => Dimension::Ratio,
        };
        let [got, want] = [&two, &one].map(|single| (result.value)(single));
        // a shallow dent is so flat that its curvature has lost its digits
        if result.name == "residual_radius_m"
            && run.impact.residual_radius.is_some_and(|dent| dent > 100.0 * run.impact.unloading_radius)
        {
            continue;
        }
        let (Some(got), Some(want)) = (got.as_ref().and_then(Value::as_f64), want.as_ref().and_then(Value::as_f64))
        else {
            prop_assert_eq!(got.is_some(), want.is_some(), "{}", result.name);
            continue;
        };
        // small differences of the larger sizes
        let size = match dimension {
            Dimension::Length => sizes[0].max(want.abs()),
            Dimension::Force => sizes[1].max(want.abs()),
            Dimension::Energy => sizes[2].max(want.abs()),
            Dimension::Ratio => want.abs().max(1.0),
            _ => want.abs(),
        };
        let error = (got / factor(dimension) - want).abs() / size;
        prop_assert!(
            error <= allowed || size == 0.0,
            "{}: {:e} {:e} by {:e}, off by {:e}",
            result.name,
            got,
            want,
            factor(dimension),
            error
        );
        compared += 1;
    }
    Ok(compared > 10)
}

/// Factors of the units, which are others in every scene.
fn sizes_of_units(scene: &AnyScene) -> [f64; 3] {
    let digits = |path: &str| {
        let number = scene.keys.iter().find_map(|(key, given)| match given {
            Given::Number(number) if *key == path => Some(*number),
            _ => None,
        });
        // the middle digits of a random number are another one
        2.0 * (number.unwrap_or(0.5).abs() * 1e7).fract() - 1.0
    };
    [9.0 * digits("sphere.poissons_ratio"), 6.0 * digits("half_space.poissons_ratio"), 9.0 * digits("sphere.density")]
        .map(|log| 10_f64.powf(log))
}

/// Damping and a plate take energy: the sphere goes in no deeper than without them.
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
    Ok(true)
}
