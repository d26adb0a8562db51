//! Oblique impacts with gravity, damping, a plate, and in a series of hops: the forces act on the normal motion, and friction
//! keeps its ledger.

use approx::assert_abs_diff_eq;

use super::*;

/// A steel ball on steel under these settings.
pub(super) fn under(settings: &[&str]) -> Contact {
    contact(STEEL, &settings.iter().map(|setting| (*setting).to_owned()).collect::<Vec<_>>())
}

/// On a plate friction follows the normal motion of the plate, and a plate that hardly gives way is a half-space.
#[test]
fn friction_goes_with_a_plate() {
    let on_plate = |thickness: f64| {
        contact(STEEL, &["half_space.density=7850".to_owned(), format!("half_space.thickness={thickness}")])
    };
    let sticks = approach(1.0, 15.0, 0.15, 0.0);
    let (_, on_block) = impact(&steel(&LawChoice::default()), sticks, None);
    let (_, on_thick) = impact(&on_plate(5.0), sticks, None);
    assert_abs_diff_eq!(on_thick.contact_point_restitution, on_block.contact_point_restitution, epsilon = 2e-5);
    // it slides all the time: the impulse of friction is mu times that of the plate on the sphere, (1 + e) m v
    let slides = approach(1.0, 60.0, 0.15, 0.0);
    let (normal_speed, tangential_speed) = (slides.normal, slides.tangential.speed);
    let (on_plate, rebound) = impact(&on_plate(5e-3), slides, None);
    assert!(on_plate.row.restitution < 0.9 * impact(&steel(&LawChoice::default()), slides, None).0.row.restitution);
    let left = tangential_speed - 0.15 * (1.0 + on_plate.row.restitution) * normal_speed;
    assert_relative_eq!(rebound.tangential.speed, left, max_relative = 1e-7);
}

/// On a plate friction changes the tangential speed by its impulse, also where springs stick for a while.
#[test]
fn friction_on_plate_has_its_impulse() {
    let contact = under(&["half_space.density=7850", "half_space.thickness=5 mm"]);
    let before = approach(3.0, 24.0, 0.15, 0.0);
    let (on_plate, rebound) = impact(&contact, before, Some(2001));
    assert!(!rebound.is_sliding);
    let force = |row: &TraceRow| row.friction.unwrap().friction_force;
    let mut impulse = 0.0;
    let change = contact.mass() * (rebound.tangential.speed - before.tangential.speed);
    for pair in on_plate.trace.windows(2) {
        impulse += 0.5 * (force(&pair[0]) + force(&pair[1])) * (pair[1].time - pair[0].time);
        let so_far = contact.mass() * (pair[1].friction.unwrap().tangential.speed - before.tangential.speed);
        assert_abs_diff_eq!(impulse, so_far, epsilon = 1e-3 * change.abs());
    }
    assert_abs_diff_eq!(impulse, change, epsilon = 1e-3 * change.abs());
}

/// A contact with hardly any damping is a contact without damping, although its friction is computed without steps of sliding. The stops
/// of some laws rise faster behind a joint, so springs stick there. Once they slid on, and s_1/s_0 was up to 0.019 wrong.
#[test]
fn hardly_damped_friction_is_undamped_friction() {
    let laws = ["plm", "thornton", "kogut_etsion", "jackson_green", "walton_braun", "mesarovic_johnson"];
    let scenes = [("stronge", 0.3, 12.0), ("stronge", 0.3, 16.0), ("stronge", 0.15, 11.0), ("stronge", 0.08, 13.0)];
    // where the law limits its elastic approach, and where it ceases to do so
    let more = [("stronge", 0.08, 15.0), ("yigit_christoforou", 0.08, 12.0), ("thornton + stronge", 0.08, 11.0)];
    let grid = [(0.05, 11.0), (0.3, 3.0), (3.0, 12.0), (3.0, 18.0), (3.0, 40.0)];
    let of_grid = laws.into_iter().flat_map(|law| grid.map(|(speed, angle)| (law, speed, angle)));
    let mut judged = 0;
    for (law, speed, angle) in scenes.into_iter().chain(more).chain(of_grid) {
        let law_key = format!("law={law}");
        let ratio = |settings: &[&str]| {
            let row = under(settings).row(approach(speed, angle, 0.15, 0.0), &Solver::AUTO).ok()?;
            Some(row.rebound?.contact_point_restitution)
        };
        // the law has no answer near its yield point
        let Some(undamped) = ratio(&[law_key.as_str()]) else { continue };
        let damped = ratio(&[law_key.as_str(), "damping.viscous=1e-9"]).unwrap();
        assert!((undamped - damped).abs() < 5e-5, "{law} {speed} {angle}: {undamped} {damped}");
        judged += 1;
    }
    assert!(judged > 30, "{judged}");
}

/// A linear law has no scale, so s_1/s_0 at one angle is the same at all speeds. Its values are from a sum over 8000 springs, stepped
/// 8000 times a leg.
#[test]
fn friction_of_linear_law_does_not_depend_on_speed() {
    let contact = under(&["law=walton_braun"]);
    for (angle, want) in [(3.0, -0.444_304_8), (8.0, -0.625_231_0), (12.0, -0.427_393_5), (20.0, 0.082_206_7)] {
        for speed in [0.01, 0.3, 1.0, 5.0, 10.0] {
            let row = contact.row(approach(speed, angle, 0.15, 0.0), &Solver::AUTO).unwrap();
            assert_abs_diff_eq!(row.rebound.unwrap().contact_point_restitution, want, epsilon = 1e-5);
        }
    }
}

/// A ball that hops along: every hop is the impact by itself with the speeds and the spin that the last one left, the ball moves
/// along the surface at its speed in the air, and m v R + I ω about the contact point stays through all of them.
#[test]
fn hopping_ball_keeps_spin_and_path() {
    let contact = under(&["gravity.acceleration=9.81"]);
    let first = approach(2.0, 40.0, 0.2, 0.0);
    let drive = SeriesMode::Bouncing { gravity: 9.81, drop_height: None, approach: first, most: 12, until: None };
    let series =
        ImpactSeries { spot_mode: SpotMode::Fresh, mode: drive }.run(&contact, &Solver::AUTO, 20, None).unwrap();
    assert_eq!(series.impacts.len(), 12);
    let radius = contact.sphere().radius;
    // over the mass: v R + (2/5) R² ω
    let momentum = |speed: f64, spin: f64| speed * radius + 0.4 * radius * radius * spin;
    let begun = momentum(first.tangential.speed, 0.0);
    let (mut place, mut lost) = (0.0, 0.0);
    for (i, hit) in series.impacts.iter().enumerate() {
        let alone = contact.impact(hit.approach, &Solver::AUTO, None).unwrap();
        let (rebound, after) = (alone.row.rebound.unwrap(), hit.impact.row.rebound.unwrap());
        assert_eq!(
            (rebound.tangential.speed, rebound.tangential.spin),
            (after.tangential.speed, after.tangential.spin)
        );
        assert_relative_eq!(momentum(after.tangential.speed, after.tangential.spin), begun, max_relative = 1e-12);
        assert_abs_diff_eq!(hit.position[0], place, epsilon = 1e-12);
        lost += hit.impact.oblique.unwrap().loss;
        if let Some(flight) = hit.flight {
            let in_contact =
                0.5 * (hit.tangential().unwrap().speed + after.tangential.speed) * hit.impact.row.contact_time;
            place += in_contact + after.tangential.speed * flight.duration;
            let next = series.impacts[i + 1].approach;
            let Approach { normal, tangential, .. } = next;
            assert_relative_eq!(normal, flight.landing_speed, max_relative = 1e-12);
            assert_eq!(tangential, after.tangential);
        }
    }
    // in the end it rolls: v = R ω = begun/(1 + 2/5)/R, and friction has taken the rest, (1/7) m v²
    let last = series.impacts[11].impact.row.rebound.unwrap();
    assert_relative_eq!(last.tangential.speed, begun / (1.4 * radius), max_relative = 1e-6);
    let all = first.tangential.speed.powi(2) * contact.mass() / 7.0;
    assert_relative_eq!(lost, all, max_relative = 1e-6);
    // straight down with no spin it is the ball that bounces on one place
    let straight = Approach::at_angle(2.0, 0.0, 0.0, 0.2);
    let of = |approach: Approach| {
        let drive = SeriesMode::Bouncing { gravity: 9.81, drop_height: None, approach, most: 5, until: None };
        ImpactSeries { spot_mode: SpotMode::Fresh, mode: drive }.run(&contact, &Solver::AUTO, 2, None).unwrap()
    };
    let (with, without) = (of(straight), of(2.0.into()));
    for (one, other) in with.impacts.iter().zip(&without.impacts) {
        assert_eq!(
            (one.time, one.approach.normal, one.position, one.rebound_speed),
            (other.time, other.approach.normal, [0.0; 2], other.rebound_speed)
        );
    }
}
