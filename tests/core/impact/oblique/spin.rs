//! Spin as a vector: an impact out of the plane of incidence is the impact in a plane with the magnitude of the slip, turned.

use approx::assert_abs_diff_eq;

use super::with_forces::under;
use super::*;

/// Forward, to the left and back, sticking and sliding: speed, degrees, friction, and the spin of rolling forward \[rad/s\].
const PLANE_SCENES: [(f64, f64, f64, f64); 5] = [
    (3.9, 8.0, 0.3, 0.0),
    (3.9, 8.0, 0.3, 400.0),
    (3.9, 20.0, 0.1, -300.0),
    (1.0, 60.0, 0.15, 50.0),
    (2.0, 0.0, 0.2, 90.0),
];

/// A motion turned about the normal, from x to y.
fn turned(motion: TangentialMotion, azimuth: f64) -> TangentialMotion {
    let ((sin, cos), [x, y], [about_x, about_y, about_z]) = (azimuth.sin_cos(), motion.velocity(), motion.spins());
    let cross = CrossMotion {
        speed: sin * x + cos * y,
        spin_about_path: cos * about_x - sin * about_y,
        spin_about_normal: about_z,
    };
    TangentialMotion { speed: cos * x - sin * y, spin: sin * about_x + cos * about_y, cross: Some(cross) }
}

fn assert_motion_eq(got: TangentialMotion, want: TangentialMotion, radius: f64, allowed: f64) {
    for axis in [0, 1] {
        assert_abs_diff_eq!(got.velocity()[axis], want.velocity()[axis], epsilon = allowed);
    }
    for axis in [0, 1, 2] {
        assert_abs_diff_eq!(got.spins()[axis] * radius, want.spins()[axis] * radius, epsilon = 2.5 * allowed);
    }
}

fn with_spins(plane: Approach, spin_about_path: f64, spin_about_normal: f64) -> Approach {
    let cross = Some(CrossMotion { speed: 0.0, spin_about_path, spin_about_normal });
    Approach { tangential: TangentialMotion { cross, ..plane.tangential }, ..plane }
}

fn two_balls() -> Contact {
    contact(STEEL, &["half_space.mass=ball", "half_space.radius=8 mm", "half_space.density=7850"])
}

/// A turned scene has the turned result, to rounding: of the sphere, of a second ball, and on every row of the trace.
#[test]
fn turned_scene_has_turned_result() {
    for contact in [steel(&LawChoice::default()), two_balls(), alumina_on_glass()] {
        let radius = contact.sphere().radius;
        for (speed, degrees, friction, spin) in PLANE_SCENES {
            let plane = approach(speed, degrees, friction, spin);
            let (of_plane, want) = impact(&contact, plane, Some(12));
            for azimuth in [0.3_f64, 1.2, 2.0, 3.1, -0.7, -2.5] {
                let scene = Approach { tangential: turned(plane.tangential, azimuth), ..plane };
                let (of_scene, got) = impact(&contact, scene, Some(12));
                let size = speed + radius * spin.abs();
                // in partial slip rounding changes the lengths of the steps
                let allowed = size * if want.is_sliding { 4e-15 } else { 1e-10 };
                assert_eq!(got.is_sliding, want.is_sliding);
                assert_motion_eq(got.tangential, turned(want.tangential, azimuth), radius, allowed);
                assert_eq!(got.target.is_some(), want.target.is_some());
                if let (Some(got), Some(want)) = (got.target, want.target) {
                    assert_motion_eq(got, turned(want, azimuth), 8e-3, allowed);
                }
                assert_abs_diff_eq!(got.angle, want.angle.abs(), epsilon = 1e-10);
                assert_abs_diff_eq!(got.psi.abs(), want.psi.abs(), epsilon = 1e-13 * want.psi.abs());
                let [ratio, want_of_ratio] = [got, want].map(|rebound| rebound.contact_point_restitution);
                assert_abs_diff_eq!(ratio, want_of_ratio, epsilon = 1e-9);
                assert_abs_diff_eq!(got.loss_fraction, want.loss_fraction, epsilon = 1e-9);
                for (got, want) in of_scene.trace.iter().zip(&of_plane.trace) {
                    let [got, want] = [got, want].map(|row| row.friction.unwrap().tangential);
                    assert_abs_diff_eq!(got.velocity()[0], turned(want, azimuth).velocity()[0], epsilon = 1e-9 * size);
                    assert_abs_diff_eq!(got.velocity()[1], turned(want, azimuth).velocity()[1], epsilon = 1e-9 * size);
                }
            }
        }
    }
}

/// A spin about the normal stays, and changes nothing else; a spin of 0 about the path changes no bit.
#[test]
fn spin_about_normal_changes_nothing() {
    for contact in [steel(&LawChoice::default()), two_balls()] {
        for (speed, degrees, friction, spin) in PLANE_SCENES {
            let plane = approach(speed, degrees, friction, spin);
            let (of_plane, want) = impact(&contact, plane, Some(12));
            let (of_scene, got) = impact(&contact, with_spins(plane, 0.0, 700.0), Some(12));
            let cross = Some(CrossMotion { speed: 0.0, spin_about_path: 0.0, spin_about_normal: 700.0 });
            assert_eq!(got.tangential, TangentialMotion { cross, ..want.tangential });
            assert_eq!(
                (got.psi, got.loss_fraction, got.impulse_ratio),
                (want.psi, want.loss_fraction, want.impulse_ratio)
            );
            assert_eq!(got.target.map(|ball| (ball.speed, ball.spin)), want.target.map(|ball| (ball.speed, ball.spin)));
            assert_eq!(of_scene.row.restitution, of_plane.row.restitution);
            let [got, want] = [&of_scene, &of_plane].map(|impact| impact.oblique.unwrap());
            assert_eq!(got.loss, want.loss);
            // its energy is in both sides of the balance: ½ I Ω_z²
            let energy = 0.2 * contact.mass() * contact.sphere().radius.powi(2) * 700.0 * 700.0;
            assert_relative_eq!(got.kinetic_in, want.kinetic_in + energy, max_relative = 1e-14);
            assert_relative_eq!(got.recovered, want.recovered + energy, max_relative = 1e-14);
            for (got, want) in of_scene.trace.iter().zip(&of_plane.trace) {
                let [got, want] = [got, want].map(|row| row.friction.unwrap());
                assert_eq!((got.slip_speed, got.friction_force), (want.slip_speed, want.friction_force));
            }
        }
    }
}

/// A ball that drops straight with a spin about x leaves along y, as a ball with this spin about y leaves along x.
#[test]
fn spin_of_straight_drop_turns_rebound() {
    let contact = steel(&LawChoice::default());
    let drop = approach(2.0, 0.0, 0.2, 0.0);
    for spin in [90.0, -90.0, 900.0] {
        let (_, want) = impact(&contact, approach(2.0, 0.0, 0.2, spin), None);
        let (_, got) = impact(&contact, with_spins(drop, spin, 0.0), None);
        // about +y the ball leaves along +x; about +x it leaves along -y, to the right
        let cross = got.tangential.cross.unwrap();
        assert_eq!((got.tangential.speed, got.tangential.spin), (0.0, 0.0));
        assert_eq!((cross.speed, cross.spin_about_path), (-want.tangential.speed, want.tangential.spin));
        assert!(cross.speed * spin < 0.0);
        assert_eq!((got.angle, got.psi), (want.angle.abs(), want.psi.abs()));
        assert_eq!(got.tangential.azimuth().to_degrees(), -90.0_f64.copysign(spin));
    }
    // without a tangential velocity there is no azimuth
    let (_, straight) = impact(&contact, with_spins(drop, 0.0, 50.0), None);
    assert!(straight.tangential.azimuth().is_nan() && straight.angle == 0.0);
}

/// Angular momentum about the contact point is conserved as a vector, and the work of friction is the loss of kinetic energy.
#[test]
fn angular_momentum_and_energy_are_conserved() {
    for contact in [steel(&LawChoice::default()), alumina_on_glass().with_moment_of_inertia(1.1e-9)] {
        let (mass, radius) = (contact.mass(), contact.sphere().radius);
        let moment = contact.moment_of_inertia().unwrap_or(0.4 * mass * radius * radius);
        for (speed, degrees, friction, spin) in PLANE_SCENES {
            let scene = with_spins(approach(speed, degrees, friction, spin), 250.0, -400.0);
            let (impact, rebound) = impact(&contact, scene, Some(4001));
            // R z × m V + I Ω
            let momentum = |motion: TangentialMotion| {
                let ([x, y], spins) = (motion.velocity(), motion.spins());
                let of_centre = [-y, x, 0.0].map(|speed| mass * radius * speed);
                [0, 1, 2].map(|axis| of_centre[axis] + moment * spins[axis])
            };
            let size = mass * radius * speed + moment * (spin.abs() + 650.0);
            for axis in [0, 1, 2] {
                let [before, after] = [scene.tangential, rebound.tangential].map(|motion| momentum(motion)[axis]);
                assert_abs_diff_eq!(before, after, epsilon = 1e-14 * size);
            }
            let energy = |motion: TangentialMotion| {
                let square = |all: &[f64]| all.iter().map(|one| one * one).sum::<f64>();
                0.5 * (mass * square(&motion.velocity()) + moment * square(&motion.spins()))
            };
            let friction = impact.oblique.unwrap();
            let [before, after] = [scene.tangential, rebound.tangential].map(energy);
            assert_relative_eq!(friction.kinetic_in, before, max_relative = 1e-14);
            assert_relative_eq!(friction.recovered, after, max_relative = 1e-14);
            assert_abs_diff_eq!(friction.loss, before - after, epsilon = 1e-14 * before);
            assert!(friction.momentum_error < 1e-14 && friction.loss > 0.0);
            // ∫ T·s dt of the trace, by the trapezoidal rule
            let power = |row: &TraceRow| -row.friction.unwrap().friction_force * row.friction.unwrap().slip_speed;
            let work: f64 = impact
                .trace
                .windows(2)
                .map(|pair| 0.5 * (power(&pair[0]) + power(&pair[1])) * (pair[1].time - pair[0].time))
                .sum();
            assert_relative_eq!(work, friction.loss, max_relative = 2e-4);
        }
    }
}

/// Gross sliding of two equal balls: V = μ (1 + e)/2 v_n along the slip. This is the throw of pool, Alciatore, technical proof A.14: a
/// rolling cue ball slips across the table too, and throws the object ball less than a cue ball that does not roll.
#[test]
fn rolling_cue_ball_throws_less() {
    let set = ["half_space.mass=ball", "half_space.radius=5 mm", "half_space.density=7850"];
    let (contact, friction) = (contact(STEEL, &set), 0.05);
    let throw = |rolls: f64| {
        let stun = approach(1.0, 40.0, friction, 0.0);
        // it rolls on a table whose normal is y: Ω = y × V/R
        let of_rolling = rolls / contact.sphere().radius;
        let scene = with_spins(stun, -stun.normal * of_rolling, -stun.tangential.speed * of_rolling);
        let (impact, rebound) = impact(&contact, scene, None);
        assert!(rebound.is_sliding);
        let slip = [stun.tangential.speed, -stun.normal * rolls];
        let want = 0.5 * friction * (1.0 + impact.row.restitution) * stun.normal * slip[0] / slip[0].hypot(slip[1]);
        let target = rebound.target.unwrap();
        assert_relative_eq!(target.speed, want, max_relative = 1e-9);
        // it lifts the object ball, or presses it on the table
        assert_relative_eq!(target.velocity()[1], want * slip[1] / slip[0], max_relative = 1e-9, epsilon = 1e-15);
        target.speed
    };
    let [draw, stun, follow] = [-1.0, 0.0, 1.0].map(throw);
    assert_relative_eq!(draw, follow, max_relative = 1e-12);
    // sin 40° of the throw of a cue ball that does not roll
    assert_relative_eq!(follow, stun * 40_f64.to_radians().sin(), max_relative = 1e-9);
}

/// A hopping ball turns until it rolls. Then friction has made, whatever its size, V = (5 V_0 + 2 R Ω_0 × z)/7, the direction of
/// Coriolis (1835) for a massé shot; each hop keeps the vectors of the hop before.
#[test]
fn hopping_ball_turns_to_direction_of_coriolis() {
    let contact = under(&["gravity.acceleration=9.81"]);
    let radius = contact.sphere().radius;
    for (friction, spin, spin_about_path) in [(0.1, 0.0, 500.0), (0.3, -300.0, 200.0), (0.2, 100.0, -400.0)] {
        let first = with_spins(approach(2.0, 30.0, friction, spin), spin_about_path, 60.0);
        let mode = SeriesMode::Bouncing { gravity: 9.81, drop_height: None, approach: first, most: 30, until: None };
        let series = ImpactSeries { spot_mode: SpotMode::Fresh, mode }.run(&contact, &Solver::AUTO, 2, None).unwrap();
        let mut place = [0.0; 2];
        for (hit, next) in series.impacts.iter().zip(series.impacts.iter().skip(1)) {
            let (after, flight) = (hit.impact.row.rebound.unwrap().tangential, hit.flight.unwrap());
            assert_eq!((hit.position, next.approach.tangential), (place, after));
            assert_eq!(after.spins()[2], 60.0);
            let alone = contact.impact(hit.approach, &Solver::AUTO, None).unwrap().row.rebound.unwrap();
            assert_eq!(alone.tangential, after);
            let [before, velocity] = [hit.approach.tangential.velocity(), after.velocity()];
            place = [0, 1].map(|axis| {
                let in_contact = 0.5 * (before[axis] + velocity[axis]) * hit.impact.row.contact_time;
                place[axis] + in_contact + velocity[axis] * flight.duration
            });
            assert_abs_diff_eq!(next.position[0], place[0], epsilon = 1e-12);
            assert_abs_diff_eq!(next.position[1], place[1], epsilon = 1e-12);
            place = next.position;
        }
        let last = series.impacts.last().unwrap().impact.row.rebound.unwrap().tangential;
        let want = [(5.0 * first.tangential.speed + 2.0 * radius * spin) / 7.0, -2.0 * radius * spin_about_path / 7.0];
        for axis in [0, 1] {
            assert_abs_diff_eq!(last.velocity()[axis], want[axis], epsilon = 1e-4);
        }
        assert_abs_diff_eq!(last.azimuth(), want[1].atan2(want[0]), epsilon = 1e-4);
    }
}
