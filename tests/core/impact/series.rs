//! Series of impacts: bouncing under gravity and repeated shots.

use plm_impact::impact::flight::free_flight::FreeFlight;
use plm_impact::impact::flight::trajectory::Flight;
use plm_impact::impact::series::{SeriesEnd, SeriesImpact, SeriesResult};

use crate::common::prelude::*;

const GRAVITY: f64 = 9.81;

fn auto() -> Solver {
    Solver::AUTO
}

fn contact(scene: Scene, damping: Option<Damping>) -> Contact {
    scene.contact().with_forces(Forces { gravity: Some(GRAVITY), damping, ..Forces::default() })
}

fn elastic() -> Scene {
    Scene { yield_strength: None, ..Scene::steel() }
}

fn bouncing(place: SpotMode, speed: f64, most: u64, until: Option<f64>) -> ImpactSeries {
    ImpactSeries {
        spot_mode: place,
        mode: SeriesMode::Bouncing { gravity: GRAVITY, drop_height: None, approach: speed.into(), most, until },
    }
}

/// Error of the energy balance of a series: kinetic energy + m g (height) + losses by dents and damping, relative to
/// the first kinetic energy.
fn energy_balance_error(contact: &Contact, sequence: &SeriesResult, place: SpotMode) -> f64 {
    let weight = contact.mass() * GRAVITY;
    let first = sequence.impacts[0].impact.row.kinetic_in;
    let mut spent = 0.0;
    let mut worst: f64 = 0.0;
    let mut touch = 0.0;
    for hit in &sequence.impacts {
        worst = nan_max(worst, ((hit.impact.row.kinetic_in - weight * touch + spent) / first - 1.0).abs());
        spent += [
            hit.impact.energy.plastic,
            hit.forces_value(|forces| forces.damping_loss),
            hit.forces_value(|forces| forces.stored_at_separation),
        ]
        .iter()
        .flatten()
        .sum::<f64>();
        if !hit.is_captured() {
            worst =
                nan_max(worst, ((hit.recovered_energy() - weight * hit.end_indentation() + spent) / first - 1.0).abs());
        }
        touch = if place == SpotMode::Same { hit.impact.row.residual_indentation } else { 0.0 };
    }
    worst
}

#[test]
fn elastic_ball_keeps_energy_over_1e4_bounces() {
    // e = 1 in every impact, so impact N begins at (N − 1)(2 v/g + T); the sum of 10^4 terms has a rounding error of
    // 1e-13
    let contact = contact(elastic(), None);
    let sequence = bouncing(SpotMode::Same, 1.0, 10_000, None).run(&contact, &auto(), 20, None).unwrap();
    let (first, last) = (&sequence.impacts[0], &sequence.impacts[9_999]);
    assert_eq!((sequence.end, sequence.impacts.len()), (SeriesEnd::Impacts, 10_000));
    assert!(
        relative_error(last.impact.row.kinetic_in, first.impact.row.kinetic_in) < 1e-10,
        "{:e}",
        relative_error(last.impact.row.kinetic_in, first.impact.row.kinetic_in)
    );
    assert_eq!(last.approach.normal, 1.0);
    let period = 2.0 / GRAVITY + first.impact.row.contact_time;
    assert!(relative_error(last.time.unwrap(), 9_999.0 * period) < 1e-12);
    // there is no end, so no remaining time
    assert_eq!(sequence.remaining_time, None);
    // the number of rows of the trace is limited: all impacts would have 400 000
    let rows: usize = sequence.traced_impacts().iter().map(|hit| 2 * hit.impact.trace.len()).sum();
    assert!(rows < 300_000, "{rows}");
}

#[test]
fn constant_restitution_gives_geometric_series() {
    // viscous damping of a Hertz contact has the same e at every speed (Tsuji, Tanaka and Ishida 1992), except for
    // gravity during the contact: m g over the peak force is below 1e-5 here
    let contact = contact(elastic(), Some(Damping::Viscous(0.05)));
    let sequence = bouncing(SpotMode::Same, 2.0, 12, None).run(&contact, &solver(Method::Rk8, 1e-10), 2, None).unwrap();
    let e = sequence.impacts[0].impact.row.restitution;
    assert!(e > 0.8 && e < 0.95, "{e}");
    for (i, hit) in sequence.impacts.iter().enumerate() {
        let i = i32::try_from(i).unwrap();
        assert!(relative_error(hit.impact.row.restitution, e) < 1e-3, "{i} {}", hit.impact.row.restitution);
        assert!(relative_error(hit.approach.normal, 2.0 * e.powi(i)) < 2e-3);
        // t_N = Σ 2 e^k v/g + contacts
        let flights = 2.0 * 2.0 / GRAVITY * e * (1.0 - e.powi(i)) / (1.0 - e);
        let contacts: f64 =
            sequence.impacts[..usize::try_from(i).unwrap()].iter().map(|hit| hit.impact.row.contact_time).sum();
        assert!((hit.time.unwrap() - flights - contacts).abs() < 2e-3 * flights.max(1e-6), "{i}");
    }
    let last = sequence.impacts.last().unwrap();
    // all flights together take 2 e v/(g (1 − e)): the computed flights plus the remaining time
    let flown: f64 = sequence.impacts.iter().filter_map(|hit| hit.flight).map(|flight| flight.duration).sum();
    let whole = 2.0 * 2.0 * e / (GRAVITY * (1.0 - e));
    assert!(relative_error(flown + sequence.remaining_time.unwrap(), whole) < 1e-3);
    assert!(
        relative_error(
            sequence.remaining_time.unwrap(),
            2.0 * last.rebound_speed / GRAVITY / (1.0 - last.impact.row.restitution)
        ) < 1e-15
    );
}

#[test]
fn same_spot_deepens_only_in_first_bounce() {
    for exponent in [UnloadingExponent::Paper, UnloadingExponent::PressureShape] {
        for speed in [0.05, 1.0, 3.0, 20.0] {
            let contact = contact(Scene { exponent, ..Scene::steel() }, None);
            let sequence = bouncing(SpotMode::Same, speed, 100, None).run(&contact, &auto(), 10, None).unwrap();
            let first = &sequence.impacts[0];
            assert!(first.impact.row.restitution < 1.0 && first.impact.row.residual_indentation > 0.0);
            for hit in &sequence.impacts[1..] {
                // each reload ends exactly at the old peak
                assert_eq!((hit.impact.row.restitution, hit.dent_growth), (1.0, 0.0));
                assert_eq!(hit.approach.normal, first.rebound_speed);
                assert_eq!(hit.impact.row.residual_indentation, first.impact.row.residual_indentation);
                assert!(relative_error(hit.impact.row.peak_force, first.impact.row.peak_force) < 1e-12);
                assert_eq!(hit.impact.energy.plastic, Some(0.0));
            }
            assert_eq!((sequence.end, sequence.remaining_time), (SeriesEnd::Impacts, None));
            // flights begin and end at the depth of the dent
            let flight = first.flight.unwrap();
            assert_eq!(flight.height, -first.impact.row.residual_indentation);
            assert_eq!(flight.duration, 2.0 * first.rebound_speed / GRAVITY);
            assert!(energy_balance_error(&contact, &sequence, SpotMode::Same) < 1e-12);
        }
    }
}

#[test]
fn fresh_spots_give_single_impacts_at_remaining_speeds() {
    let contact = contact(Scene::steel(), None);
    let sequence = bouncing(SpotMode::Fresh, 3.0, 100, Some(0.02)).run(&contact, &auto(), 10, None).unwrap();
    assert_eq!(sequence.end, SeriesEnd::Until);
    for (hit, next) in sequence.impacts.iter().zip(&sequence.impacts[1..]) {
        let single = contact.closed_form(hit.approach.normal).unwrap();
        assert_eq!(hit.impact.row.restitution, single.row.restitution);
        assert_eq!(hit.impact.row.residual_indentation, single.row.residual_indentation);
        // the speed after leaving the dent: u² = (e v)² − 2 g δ_r
        let square = hit.rebound_speed * hit.rebound_speed - 2.0 * GRAVITY * hit.impact.row.residual_indentation;
        assert!(relative_error(next.approach.normal * next.approach.normal, square) < 1e-14);
        assert!(next.approach.normal >= 0.02 && next.impact.row.restitution >= hit.impact.row.restitution);
        let gap = next.time.unwrap() - hit.time.unwrap() - hit.impact.row.contact_time;
        assert!((gap - (hit.rebound_speed + next.approach.normal) / GRAVITY).abs() < 1e-14);
    }
    // the next impact, which was not computed, would have been slower than the limit
    let last = sequence.impacts.last().unwrap();
    assert!(last.rebound_speed.powi(2) - 2.0 * GRAVITY * last.impact.row.residual_indentation < 0.02_f64.powi(2));
}

#[test]
fn energy_balance_of_100_damped_bounces_closes() {
    for place in SpotMode::ALL {
        for (damping, tolerance) in [
            (None, 1e-13),
            (Some(Damping::HuntCrossley(0.02)), 1e-10),
            (Some(Damping::Viscous(0.002)), 1e-10),
            (Some(Damping::Viscoelastic(1e-8)), 1e-10),
        ] {
            let contact = contact(Scene::steel(), damping);
            let solver = Solver { tolerance, ..auto() };
            let sequence = bouncing(place, 3.0, 100, None).run(&contact, &solver, 10, None).unwrap();
            let drift = energy_balance_error(&contact, &sequence, place);
            assert!(drift < 10.0 * tolerance, "{place:?} {damping:?}: {drift:e}");
            assert!(sequence.impacts.iter().all(|hit| hit.impact.energy.balance_error < 10.0 * tolerance));
        }
    }
}

#[test]
fn capture_ends_a_series_at_its_limit() {
    // soft and heavy, so that F_m = (n + 1) m g is reached while the dent is small: a sphere of 4 cm, dense as lead, on wax
    let soft = Material { youngs_modulus: 1e6, poissons_ratio: 0.3 };
    let scene = Scene {
        radius: 0.02,
        density: 10_000.0,
        sphere: Material { youngs_modulus: 200e9, poissons_ratio: 0.3 },
        half_space: soft,
        yield_strength: Some(1e4),
        exponent: UnloadingExponent::Paper,
    };
    let contact = contact(scene, None);
    let weight = contact.mass() * GRAVITY;
    let run = |speed: f64| bouncing(SpotMode::Fresh, speed, 50, None).run(&contact, &auto(), 10, None).unwrap();
    let is_captured = |hit: &SeriesImpact| hit.impact.row.peak_force <= 2.5 * weight;
    // the limit by bisection between a captured and a free first impact
    let (mut low, mut high) = (1e-3, 0.5);
    assert!(run(low).impacts[0].is_captured() && !run(high).impacts[0].is_captured());
    while high / low > 1.0 + 1e-12 {
        let middle = f64::sqrt(low * high);
        *(if run(middle).impacts[0].is_captured() { &mut low } else { &mut high }) = middle;
    }
    let (captured, free) = (run(low), run(high));
    assert_eq!((captured.end, captured.impacts.len()), (SeriesEnd::Captured, 1));
    assert!(is_captured(&captured.impacts[0]) && captured.impacts[0].impact.row.restitution == 0.0);
    assert!(relative_error(captured.impacts[0].impact.row.peak_force, 2.5 * weight) < 1e-10);
    assert_eq!(captured.remaining_time, None);
    // at rest the force of the branch is the weight: (δ − δ_r)/δ_e = (m g/F_m)^(2/3) = 0.4^(2/3)
    let hit = &captured.impacts[0];
    let recovered = (hit.forces_value(|forces| forces.static_indentation).unwrap()
        - hit.impact.row.residual_indentation)
        / (hit.impact.row.peak_indentation - hit.impact.row.residual_indentation);
    assert!(relative_error(recovered, 0.4_f64.powf(2.0 / 3.0)) < 1e-9);
    // just above the limit: too slow to leave the dent
    assert!(!is_captured(&free.impacts[0]));
    assert_eq!(free.end, SeriesEnd::InDent);
    // on the same spot it bounces elastically in the dent
    let same = bouncing(SpotMode::Same, high * 1.1, 5, None).run(&contact, &auto(), 10, None).unwrap();
    assert_eq!((same.end, same.impacts.len()), (SeriesEnd::Impacts, 5));
    assert!(same.impacts[1..].iter().all(|hit| hit.impact.row.restitution == 1.0));
    // every series ends by one of these rules, at any speed
    for speed in [0.02, 0.1, 0.2, 0.5] {
        let sequence = run(speed);
        assert!(matches!(sequence.end, SeriesEnd::Captured | SeriesEnd::InDent), "{speed} {:?}", sequence.end);
    }
}

/// Under viscous damping a slow ball lifts off while it is still indented, and falls back. No dent holds it: it is captured.
#[test]
fn ball_falling_back_into_contact_is_captured() {
    for zeta in [0.2, 0.4, 0.6, 0.8] {
        for place in [SpotMode::Same, SpotMode::Fresh] {
            let contact = contact(Scene::steel(), Some(Damping::Viscous(zeta)));
            let sequence = bouncing(place, 0.005, 10_000, None).run(&contact, &auto(), 10, None).unwrap();
            assert_eq!((sequence.end, sequence.deepest_dent()), (SeriesEnd::Captured, 0.0), "{zeta} {place:?}");
        }
    }
}

#[test]
fn a_drop_starts_the_clock_at_the_release() {
    let contact = contact(Scene::steel(), None);
    let speed = (2.0 * GRAVITY * 0.5).sqrt();
    let drive =
        SeriesMode::Bouncing { gravity: GRAVITY, drop_height: Some(0.5), approach: speed.into(), most: 2, until: None };
    let sequence = ImpactSeries { spot_mode: SpotMode::Same, mode: drive }.run(&contact, &auto(), 10, None).unwrap();
    assert!(relative_error(sequence.impacts[0].time.unwrap(), (2.0_f64 * 0.5 / GRAVITY).sqrt()) < 1e-15);
    assert_eq!(sequence.fall.unwrap().height, 0.5);
}

#[test]
fn a_fall_takes_the_time_of_galilei() {
    // t = √(2 h/g): 2 s from 19.62 m at 9.81 m/s²
    let fall = Flight::from_drop(FreeFlight::in_vacuum(9.81), 19.62);
    approx::assert_relative_eq!(fall.duration, 2.0, max_relative = 1e-15);
    approx::assert_relative_eq!(fall.landing_speed, 19.62, max_relative = 1e-15);
    approx::assert_abs_diff_eq!(fall.height_at(2.0), 0.0, epsilon = 1e-14);
    approx::assert_relative_eq!(fall.speed_at(2.0), 19.62, max_relative = 1e-15);
}

#[test]
fn flight_from_dent_loses_its_depth() {
    // from 1 m below at 6 m/s under 10 m/s²: 0.8 m above the surface, back on it at 4 m/s after 1 s
    let flight = Flight::from_rebound(FreeFlight::in_vacuum(10.0), 3.0, 1.0, 6.0, 0.0).unwrap();
    assert_eq!((flight.landing_speed, flight.duration, flight.apex_height()), (4.0, 1.0, 0.8));
    assert_eq!(flight.height_at(1.0), 0.0);
    // a flight that only reaches the rim does not land on a fresh surface; on the same spot every flight comes back
    assert_eq!(Flight::from_rebound(FreeFlight::in_vacuum(10.0), 0.0, 1.0, 20_f64.sqrt() * (1.0 - 1e-15), 0.0), None);
    assert_eq!(Flight::from_rebound(FreeFlight::in_vacuum(10.0), 0.0, 1.0, 0.1, 1.0).unwrap().landing_speed, 0.1);
}

/// A series has at most 200 000 rows of traces: a contact with 30 000 rows of loading and as many of unloading is traced three times.
#[test]
fn only_first_contacts_of_long_series_are_traced() {
    let contact = contact(Scene::steel(), None);
    for (samples, traced) in [(30_000, 3), (150_000, 1), (2, 4)] {
        let series = bouncing(SpotMode::Same, 1.0, 4, None).run(&contact, &auto(), samples, None).unwrap();
        assert_eq!((series.impacts.len(), series.traced_impacts().len()), (4, traced), "{samples}");
    }
}
