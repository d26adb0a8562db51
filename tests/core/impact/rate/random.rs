//! Random series on one spot with strengths that rise with the strain rate, of one body or both, on half-space and plate.

use crate::common::prelude::*;

/// The keys of a scene, and the speeds of its shots over the speed at first yield.
type Drawn = (Vec<String>, Vec<f64>);

fn rates() -> impl Strategy<Value = Vec<String>> {
    let form = prop_oneof![
        (0.001..0.08_f64).prop_map(|c| vec![format!("johnson_cook.c={c:e}")]),
        (1.5..6.0_f64, 1.5..8.0_f64).prop_map(|(decade, exponent)| {
            let rate = 10_f64.powf(decade);
            vec![format!("cowper_symonds.rate={rate:e}"), format!("cowper_symonds.exponent={exponent:e}")]
        }),
    ];
    let tested_at = (-3.0..3.0_f64).prop_map(|decade| 10_f64.powf(decade));
    let whose = prop_oneof![Just(vec!["half_space"]), Just(vec!["sphere"]), Just(vec!["sphere", "half_space"])];
    (form, tested_at, whose).prop_map(|(form, tested_at, whose)| {
        let of = |body: &str| {
            let keys = form.iter().map(move |key| format!("{body}.rate.{key}"));
            keys.chain([format!("{body}.rate.tested_at={tested_at:e}")]).collect::<Vec<_>>()
        };
        whose.into_iter().flat_map(of).collect()
    })
}

fn series() -> impl Strategy<Value = Drawn> {
    let exponent = prop_oneof![
        Just("1.5".to_owned()),
        Just("\"pressure-shape\"".to_owned()),
        (1.3..1.5_f64).prop_map(|n| format!("{n}")),
    ];
    let plate = prop::option::weighted(0.4, -0.2..1.2_f64);
    // σ_Y/E, size and modulus of the sphere over those of the half-space, and the ratio of the strengths
    let bodies = (-4.0..-1.5_f64, -6.0..-1.0_f64, -2.0..2.0_f64, -0.35..0.35_f64);
    let shots = prop::collection::vec(-0.3..1.7_f64, 2..6);
    (rates(), bodies, exponent, plate, shots).prop_map(|(mut keys, bodies, exponent, plate, shots)| {
        let (strain, size, stiffness, ratio) = bodies;
        let [strain, radius, stiffness, ratio] = [strain, size, stiffness, ratio].map(|log| 10_f64.powf(log));
        let strength = strain * 1e11 * stiffness.min(1.0);
        keys.extend([
            format!("sphere.radius={radius:e}"),
            format!("sphere.youngs_modulus={:e}", 1e11 * stiffness),
            "half_space.youngs_modulus=1e11".to_owned(),
            format!("half_space.yield_strength={strength:e}"),
            format!("sphere.yield_strength={:e}", strength * ratio),
            format!("law.plm.unloading_exponent={exponent}"),
        ]);
        if let Some(log) = plate {
            let thickness = radius * 10_f64.powf(log);
            keys.extend(["half_space.density=7850".to_owned(), format!("half_space.thickness={thickness:e}")]);
        }
        (keys, shots.into_iter().map(|log| 10_f64.powf(log)).collect())
    })
}

/// No impact gains energy, no dent becomes shallower, the ledgers close, the force never rises where the metal relaxes, and a sphere keeps
/// its momentum there.
#[test]
fn rate_creates_no_energy_and_keeps_dents() {
    let (relaxed, reloaded) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    let judged = check_property(400, &series(), |(keys, shots)| {
        let contact = contact(STEEL, &keys);
        let slowest = contact.yield_speed().unwrap();
        let mut spot = Spot::new();
        let mut dent = 0.0;
        for ratio in shots {
            let speed = ratio * slowest;
            let solver = solver(Method::Auto, 1e-11);
            let impact = match contact.impact_on(&mut spot, speed, &solver, Some(20)) {
                Ok(impact) => impact,
                // beyond the law, or a plate that takes all
                Err(ImpactError::TooDeep { .. } | ImpactError::Law(_) | ImpactError::Waveguide(_)) => return Ok(false),
                Err(error) => return Err(TestCaseError::fail(error.to_string())),
            };
            let depth = impact.row.peak_indentation;
            prop_assert!(impact.row.restitution <= 1.0 + 1e-9, "e = {}", impact.row.restitution);
            prop_assert!(impact.row.plastic_fraction >= 0.0, "{}", impact.row.plastic_fraction);
            prop_assert!(impact.energy.balance_error < 1e-8, "{}", impact.energy.balance_error);
            prop_assert!(contact.dent_depth(&spot) >= dent - 1e-12 * depth, "{} {}", contact.dent_depth(&spot), dent);
            let left = contact.dent_depth(&spot);
            prop_assert!((impact.row.residual_indentation - left).abs() <= 1e-12 * depth, "{impact:?}");
            reloaded.set(reloaded.get() + usize::from(dent > 0.0 && left > dent));
            dent = left;
            if let Some(at) = impact.trace.iter().position(|row| row.event == Some(Event::Relaxation)) {
                let [before, after] = [impact.trace[at - 1], impact.trace[at]];
                prop_assert!(before.time == after.time && before.force > after.force, "{before:?} {after:?}");
                let [one, other] = [before, after].map(|row| row.sphere_speed.unwrap_or(row.speed));
                prop_assert!((one - other).abs() <= 1e-12 * speed, "{one} {other}");
                relaxed.set(relaxed.get() + 1);
            }
        }
        Ok(true)
    });
    assert!(judged > 150 && relaxed.get() > 200 && reloaded.get() > 30, "{judged} {relaxed:?} {reloaded:?}");
}
