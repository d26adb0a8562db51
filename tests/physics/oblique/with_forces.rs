//! Oblique impacts with gravity, damping, a plate, and in a series of hops: the forces act on the normal motion, and friction
//! keeps its ledger.

use approx::assert_abs_diff_eq;

use super::*;

/// A steel ball on steel under these settings.
fn under(settings: &[&str]) -> Contact {
    contact(STEEL, &settings.iter().map(|setting| (*setting).to_owned()).collect::<Vec<_>>())
}

/// On a plate friction goes on the normal motion of the plate as on any other: gross sliding has its formula with the e of the
/// plate, and a plate that hardly gives way is a half-space.
#[test]
fn friction_goes_with_a_plate() {
    let on_plate = |thickness: f64| {
        contact(STEEL, &["half_space.density=7850".to_owned(), format!("half_space.thickness={thickness}")])
    };
    let plate = on_plate(5e-3);
    let steep = approach(1.0, 80.0, 0.15, 0.0);
    let (sliding, rebound) = impact(&plate, steep, None);
    let [normal, tangential] = steep.components();
    let want = tangential - 0.15 * (1.0 + sliding.restitution) * normal;
    assert_relative_eq!(rebound.tangential_speed, want, max_relative = 1e-9);
    let approach = approach(1.0, 15.0, 0.15, 0.0);
    let (_, on_block) = impact(&steel(&LawChoice::default()), approach, None);
    let (_, on_thick) = impact(&on_plate(5.0), approach, None);
    assert_abs_diff_eq!(on_thick.contact_point_restitution, on_block.contact_point_restitution, epsilon = 2e-5);
    assert!(
        (impact(&plate, approach, None).1.contact_point_restitution - on_block.contact_point_restitution).abs() > 1e-3
    );
}

/// A contact point that slides all the time gets μ times the impulse of the whole contact force, which is m (1 + e) v_n and the weight
/// times the contact time.
#[test]
fn gross_sliding_goes_with_gravity_and_damping() {
    for settings in [
        &["gravity.acceleration=9.81"][..],
        &["damping.viscous=0.1"],
        &["damping.hunt_crossley=\"0.1 s/m\""],
        &["gravity.acceleration=1e3", "damping.viscous=0.05"],
    ] {
        let contact = under(settings);
        let gravity = contact.forces().gravity.unwrap_or(0.0);
        let approach = approach(1.0, 80.0, 0.15, 20.0);
        let (_, rebound) = impact(&contact, approach, None);
        let [normal, tangential] = approach.components();
        let alone = contact.impact(normal, &Solver::default(), None).unwrap();
        let impulse = (1.0 + alone.restitution) * normal + gravity * alone.contact_time;
        // viscous damping pushes hard at first touch, where the contact sticks for a moment
        let is_viscous = settings.iter().any(|setting| setting.contains("viscous"));
        assert_eq!(rebound.is_sliding, !is_viscous, "{settings:?}");
        let tolerance = if is_viscous { 1e-4 } else { 1e-9 };
        assert_relative_eq!(rebound.tangential_speed, tangential - 0.15 * impulse, max_relative = tolerance);
    }
}

/// Gravity and damping that vanish leave the impact without them.
#[test]
fn little_gravity_and_damping_change_little() {
    let approach = approach(1.0, 15.0, 0.15, 0.0);
    let (_, free) = impact(&under(&[]), approach, None);
    for setting in ["gravity.acceleration=1e-6", "damping.viscous=1e-9", "damping.hunt_crossley=\"1e-9 s/m\""] {
        let (_, rebound) = impact(&under(&[setting]), approach, None);
        assert_abs_diff_eq!(rebound.contact_point_restitution, free.contact_point_restitution, epsilon = 2e-7);
    }
}

/// A sphere that stays in its dent has no rebound.
#[test]
fn a_captured_sphere_has_no_rebound() {
    let contact = under(&["gravity.acceleration=9.81"]);
    let leaves = contact.impact(approach(1.0, 20.0, 0.15, 0.0), &Solver::default(), Some(10)).unwrap();
    let held = under(&["gravity.acceleration=1e7"]);
    let impact = held.impact(approach(1.0, 20.0, 0.15, 0.0), &Solver::default(), Some(10)).unwrap();
    assert!(impact.captured().is_some() && impact.rebound.is_none() && impact.oblique.is_none());
    assert!(leaves.rebound.is_some());
}

/// A ball that hops along: every hop is the impact by itself with the speeds and the spin that the last one left, the ball moves
/// along the surface at its speed in the air, and m v R + I ω about the contact point stays through all of them.
#[test]
fn a_ball_that_hops_along_carries_its_spin_and_its_path() {
    let contact = under(&["gravity.acceleration=9.81"]);
    let first = approach(2.0, 40.0, 0.2, 0.0);
    let drive = Drive::Bouncing { gravity: 9.81, drop_height: None, approach: first, most: 12, until: None };
    let series = Repeat { place: Place::Fresh, drive }.run(&contact, &Solver::AUTO, 20, None).unwrap();
    assert_eq!(series.hits.len(), 12);
    let radius = contact.sphere().radius;
    // over the mass: v R + (2/5) R² ω
    let momentum = |speed: f64, spin: f64| speed * radius + 0.4 * radius * radius * spin;
    let begun = momentum(first.components()[1], 0.0);
    let (mut place, mut lost) = (0.0, 0.0);
    for (i, hit) in series.hits.iter().enumerate() {
        let alone = contact.impact(hit.approach, &Solver::AUTO, None).unwrap();
        let (rebound, after) = (alone.rebound.unwrap(), hit.rebound.unwrap());
        assert_eq!((rebound.tangential_speed, rebound.spin), (after.tangential_speed, after.spin));
        assert_relative_eq!(momentum(after.tangential_speed, after.spin), begun, max_relative = 1e-12);
        assert_abs_diff_eq!(hit.position, place, epsilon = 1e-12);
        lost += hit.oblique.unwrap().loss;
        if let Some(flight) = hit.flight {
            let in_contact = 0.5 * (hit.speed_along().unwrap() + after.tangential_speed) * hit.contact_time;
            place += in_contact + after.tangential_speed * flight.duration;
            let next = series.hits[i + 1].approach;
            let [normal, along] = next.components();
            assert_relative_eq!(normal, flight.landing_speed, max_relative = 1e-12);
            assert_relative_eq!(along, after.tangential_speed, max_relative = 1e-12);
            assert_eq!(next.incidence.unwrap().spin, after.spin);
        }
    }
    // in the end it rolls: v = R ω = begun/(1 + 2/5)/R, and friction has taken the rest, (1/7) m v²
    let last = series.hits[11].rebound.unwrap();
    assert_relative_eq!(last.tangential_speed, begun / (1.4 * radius), max_relative = 1e-6);
    let all = first.components()[1].powi(2) * contact.mass() / 7.0;
    assert_relative_eq!(lost, all, max_relative = 1e-6);
    // straight down with no spin it is the ball that bounces on one place
    let straight = Approach { incidence: Some(Incidence { angle: 0.0, spin: 0.0, friction: 0.2 }), ..first };
    let of = |approach: Approach| {
        let drive = Drive::Bouncing { gravity: 9.81, drop_height: None, approach, most: 5, until: None };
        Repeat { place: Place::Fresh, drive }.run(&contact, &Solver::AUTO, 2, None).unwrap()
    };
    let (with, without) = (of(straight), of(2.0.into()));
    for (one, other) in with.hits.iter().zip(&without.hits) {
        assert_eq!(
            (one.time, one.speed, one.position, one.rebound_speed),
            (other.time, other.speed, 0.0, other.rebound_speed)
        );
    }
}
