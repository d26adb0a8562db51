//! Invariants of one impact: energies, momentum, friction, sizes.

use super::random_scenario::Run;
use crate::common::prelude::*;

/// Whether the scene could be judged.
pub type Judgement = Result<bool, TestCaseError>;

/// Whether a number is another one, but for this much.
pub fn assert_close(name: &str, got: f64, want: f64, allowed: f64) -> Result<(), TestCaseError> {
    let off = (got - want).abs();
    prop_assert!(off <= allowed, "{}: {:e}, not {:e}; off by {:e}, allowed are {:e}", name, got, want, off, allowed);
    Ok(())
}

/// The run sees no error of its energy above its tolerance, at the end and on any row of the trace.
pub fn the_ledger_closes(run: &Run) -> Judgement {
    let energy = &run.impact.energy;
    let rows = run.impact.trace.iter().fold(0.0, |worst, row| nan_max(worst, row.energy_balance_error.abs()));
    prop_assert!(rows <= energy.balance_error && energy.error_at_end.abs() <= energy.balance_error, "{:?}", energy);
    if run.is_adaptive() {
        assert_close("balance error", energy.balance_error, 0.0, run.error_allowance())?;
    }
    Ok(run.is_adaptive())
}

/// The energies that are reported add up to what was put in and the error at the end, to rounding and by every method; and none is
/// below zero. A metal whose strength has a rate and that hardens may give back up to 0.1 % more than it took.
pub fn the_reported_energies_add_up(run: &Run) -> Judgement {
    let (impact, size) = (&run.impact, run.input_energy());
    let of = |part: fn(&ForcesResult) -> Option<f64>| impact.forces_result.as_ref().and_then(part).unwrap_or(0.0);
    let (plastic, gravity) = (impact.energy.plastic.unwrap_or(0.0), of(|under| under.gravity_work));
    let parts = [
        plastic,
        impact.row.waveguide.map_or(0.0, |waveguide| waveguide.energy),
        of(|under| under.damping_loss),
        of(|under| under.stored_at_separation),
        of(|under| under.remaining_energy),
    ];
    let found = impact.energy.recovered + parts.iter().sum::<f64>();
    // where nothing is lost e is 1, whatever the error of the run
    let of_run = if impact.row.restitution == 1.0 { 0.0 } else { impact.energy.error_at_end * size };
    // the work of the weight up to separation may be far above that down to the peak, where a plate holds the sphere long
    let largest = found.abs().max(gravity.abs()).max(size);
    assert_close("sum", found - gravity, impact.row.kinetic_in + of_run, 2e-13 * largest)?;
    if let Some(under) = impact.forces_result {
        let way =
            under.end_indentation - run.touch() + impact.row.waveguide.map_or(0.0, |waveguide| waveguide.displacement);
        assert_close("work of the weight", gravity, run.weight() * way, 1e-12 * largest)?;
    }
    let gain = if run.contact.has_rate() && run.scene.has("half_space.flow_stress") { 1e-3 } else { 0.0 };
    prop_assert!(parts.iter().all(|part| *part >= -(run.error_allowance() + gain) * size), "{:?} of {:e}", parts, size);
    assert_close(
        "share",
        impact.row.plastic_fraction * impact.row.kinetic_in,
        if impact.row.has_speed() { plastic } else { 0.0 },
        1e-14 * plastic.abs(),
    )?;
    Ok(true)
}

/// 0 ≤ e ≤ 1: no more comes back than was put in, and all of it below first yield. A sphere that leaves deeper than it came has the
/// work of its weight on that way; a reload beyond a knot of the law gains up to 1e-4, of which a warning tells; and a metal that
/// hardens and has a rate may gain, as above.
pub fn restitution_is_a_ratio(run: &Run) -> Judgement {
    let (impact, contact) = (&run.impact, &run.contact);
    let (e, is_captured) = (impact.row.restitution, impact.captured_result().is_some());
    prop_assert_eq!((e == 0.0, impact.row.contact_time.is_infinite()), (is_captured, is_captured));
    prop_assert_eq!(impact.row.rebound_height.is_some(), !is_captured && contact.forces().flight.is_some());
    prop_assert!(e >= 0.0 && (impact.row.has_speed() || is_captured), "{}", e);
    if !run.is_adaptive() || !impact.row.has_speed() {
        return Ok(false);
    }
    let gravity = impact.forces_result.and_then(|under| under.gravity_work).unwrap_or(0.0);
    let gain = match () {
        () if contact.has_rate() && run.scene.has("half_space.flow_stress") => 2e-3,
        () if run.is_fresh() => 0.0,
        () => 2e-4,
    };
    let most = impact.row.kinetic_in + gravity.max(0.0) + (run.error_allowance() + gain) * run.input_energy();
    prop_assert!(impact.energy.recovered <= most, "{:e}", e - 1.0);
    let is_below = contact.yield_speed().is_some_and(|yields| run.speed() <= yields) && !contact.has_rate();
    if (is_below || contact.pair().yield_point.is_none()) && run.is_fresh() && contact.forces().is_none() {
        prop_assert!(!impact.row.has_dent() && impact.energy.plastic.unwrap_or(0.0) == 0.0 && run.after == Spot::new());
        prop_assert!(e <= 1.0 && e >= 1.0 - run.error_allowance(), "{}", e);
    }
    Ok(true)
}

/// Sizes are positive, the dent is smaller than the peak, what they consist of adds up to rounding, and the spot remembers them.
pub fn sizes_fit_together(run: &Run) -> Judgement {
    let impact = &run.impact;
    let (peak, dent, radius) =
        (impact.row.peak_indentation, impact.row.residual_indentation, run.contact.pair().radius);
    let wide =
        [impact.row.peak_contact_radius, impact.peak_mean_pressure, impact.elastic_approach, impact.loading_time];
    prop_assert!(wide.iter().chain([&peak]).all(|size| *size > 0.0 && size.is_finite()), "{:?}", impact);
    prop_assert!(impact.row.contact_time > impact.loading_time && impact.stats.steps < 1_000_000, "{:?}", impact);
    prop_assert!((0.0..=peak).contains(&dent) && dent >= run.touch() * (1.0 - 1e-12), "{} {}", dent, peak);
    prop_assert!((0.0..=dent).contains(&impact.row.flat_depth), "{:?}", impact.row.flat_depth);
    assert_close("dent", impact.elastic_approach + dent, peak, 4e-15 * peak)?;
    assert_close("memory", run.contact.dent_depth(&run.after), dent, 1e-12 * peak)?;
    let above = impact.row.peak_force / impact.force_at_peak_indentation - 1.0;
    // fixed steps do not hit the turn of a metal that relaxes there
    prop_assert!(above > -1e-15 || impact.row.strain_rate_result.is_some() && !run.is_adaptive(), "{:e}", above);
    prop_assert!(
        above < 1e-15 || run.contact.forces().damping.is_some() || impact.row.strain_rate_result.is_some(),
        "{:e}",
        above
    );
    if run.is_plm() {
        prop_assert!(
            impact.row.radius_ratio <= 1.0 && impact.unloading_radius >= radius * (1.0 - 1e-12),
            "{:?}",
            impact
        );
        prop_assert!(impact.residual_radius.is_none_or(|residual| residual > radius));
    }
    prop_assert_eq!(impact.fixed_steps.is_some(), impact.method == Method::Verlet);
    Ok(true)
}

/// The momentum of both bodies stays, and their energies are those of the common motion and of the relative one.
pub fn momentum_of_both_bodies_stays(run: &Run) -> Judgement {
    let (Some(target), Some(after)) = (run.contact.target_mass(), run.impact.row.target_speed) else {
        return Ok(false);
    };
    let (mass, speed, energy) = (run.contact.mass(), run.speed(), &run.impact.energy);
    let (back, centre) = (-run.impact.rebound_speed, energy.centre_of_mass.unwrap());
    assert_close("momentum", mass * back + target * after, mass * speed, 1e-13 * (mass * speed).max(target * after))?;
    let of_both = 0.5 * mass * speed * speed;
    assert_close("energy before", energy.kinetic_in + centre, of_both, 1e-13 * of_both)?;
    let left = 0.5 * mass * back * back + 0.5 * target * after * after;
    assert_close("energy after", energy.recovered + centre, left, 2e-13 * of_both)?;
    Ok(true)
}

/// Friction makes no energy and no angular momentum, is at most μ times the force, acts against the slip, and its trace ends as the
/// rebound does.
pub fn friction_keeps_its_ledger(run: &Run) -> Judgement {
    prop_assert!(
        run.impact.captured_result().is_none() || run.impact.row.rebound.is_none() && run.impact.oblique.is_none()
    );
    let (Some(mu), Some(rebound)) = (run.approach.friction, run.impact.row.rebound) else { return Ok(false) };
    let (impact, friction) = (&run.impact, run.impact.oblique.unwrap());
    let rounding = 1e-12 * friction.kinetic_in;
    let kinetic = 0.5 * run.contact.reduced_mass() * run.approach.speed().powi(2);
    assert_close("loss fraction", rebound.loss_fraction * kinetic, friction.loss, 1e-12 * friction.loss.abs())?;
    assert_close("friction", friction.recovered + friction.loss, friction.kinetic_in, rounding)?;
    prop_assert!((-rounding..=friction.kinetic_in + rounding).contains(&friction.loss), "{:?}", friction);
    assert_close("angular momentum", friction.momentum_error, 0.0, 1e-13)?;
    let (radius, before, after) = (run.contact.sphere().radius, run.approach.tangential, rebound.tangential);
    let change = [0, 1].map(|axis| after.velocity()[axis] - before.velocity()[axis]);
    let size = run.approach.speed() + after.velocity()[0].hypot(after.velocity()[1]);
    prop_assert_eq!(after.spins()[2], before.spins()[2]);
    if let Some(target) = rebound.target {
        let (mass, ball) = (run.contact.mass(), run.contact.target_mass().unwrap());
        let of_ball = run.contact.half_space().radius.unwrap();
        for axis in [0, 1] {
            // a velocity along y turns about x backwards
            let (other, sign) = (1 - axis, if axis == 0 { 1.0 } else { -1.0 });
            let (gained, moved) = (mass * change[axis], ball * target.velocity()[axis]);
            assert_close("momentum", gained + moved, 0.0, 1e-12 * (mass + ball) * size)?;
            // about the contact point: the centre of the sphere is above it, that of the ball below
            let spun = 0.4 * mass * radius * radius * (after.spins()[other] - before.spins()[other])
                + 0.4 * ball * of_ball * of_ball * target.spins()[other];
            let angular = sign * (gained * radius - moved * of_ball) + spun;
            assert_close("angular momentum of both", angular, 0.0, 1e-12 * (mass + ball) * size * (radius + of_ball))?;
        }
    }
    if rebound.is_sliding && rebound.psi != 0.0 {
        // the impulse of the whole contact force, and of the weight that it carries, against the slip
        let impulse = run.contact.reduced_mass() * (1.0 + impact.row.restitution) * run.speed();
        let impulse = impulse + run.weight() * impact.row.contact_time;
        let ([vx, vy], [about_x, about_y, _]) = (before.velocity(), before.spins());
        let slip = [vx - radius * about_y, vy + radius * about_x];
        for axis in [0, 1] {
            let want = mu * impulse * slip[axis] / slip[0].hypot(slip[1]);
            let allowed = (1e-9 + run.error_allowance()) * mu * impulse.abs();
            assert_close("sliding", -run.contact.mass() * change[axis], want, allowed)?;
        }
    }
    if rebound.psi == 0.0 || !run.is_adaptive() {
        return Ok(false);
    }
    // friction is a straight line between the steps of its run; a metal that relaxes drops its force between two rows
    let share = if run.contact.forces().is_none() { 1e-3 } else { 2e-3 };
    for row in impact.trace.iter().filter(|row| row.event != Some(Event::Relaxation)) {
        let most = mu * row.force + share * mu.max(1.0) * impact.row.peak_force;
        prop_assert!(row.friction.unwrap().friction_force.abs() <= most, "{:?}", row);
    }
    if let [first, .., last] = &impact.trace[..] {
        let [first, last] = [first, last].map(|row| row.friction.unwrap());
        for axis in [0, 1] {
            let speed = |motion: &TangentialMotion| motion.velocity()[axis];
            let rim = |motion: &TangentialMotion| motion.spins()[axis] * radius;
            let (first, last) = (&first.tangential, &last.tangential);
            assert_close("first", speed(first), speed(&before), 1e-12 * size)?;
            assert_close("last", speed(last), speed(&after), (1e-9 + run.error_allowance()) * size)?;
            assert_close("last spin", rim(last), rim(&after), (1e-8 + run.error_allowance()) * size)?;
        }
    }
    prop_assert!(
        rebound.psi_after().abs() <= rebound.psi.abs() * (1.0 + 1e-12) && rebound.error < 1e-5,
        "{:?}",
        rebound
    );
    prop_assert!(rebound.impulse_ratio.abs() <= mu * (1.0 + 1e-5), "{:?} {}", rebound, mu);
    prop_assert!(rebound.impulse_ratio * rebound.psi >= 0.0, "{:?}", rebound);
    Ok(true)
}
