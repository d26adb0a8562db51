//! The clicks of a bouncing ball: intervals from first touch to first touch, in air.

use std::fmt::Write as _;

use plm_impact::impact::air::{Flying, Medium};

/// A ball of constant restitution that bounces in air, as a scenario with these lines of `[calibrate]`.
fn scenario(calibrate: &str, air: &str) -> String {
    let bodies = crate::common::STEEL.split("[impact]").next().unwrap();
    format!(
        "{bodies}{air}[impact]\ndrop_height = \"1 m\"\n[law.walton_braun]\nstiffness_ratio = 0.5\n[calibrate]\ndata = \"d.csv\"\n\
         free = {{ \"law.walton_braun.stiffness_ratio\" = {{ from = 0.2, to = 1.0 }} }}\n{calibrate}"
    )
}

const AIR: &str = "[air]\ndensity = \"1.2 kg/m^3\"\ndrag = 0.5\n";

/// Clicks that are made with e = 0.9 by the formulas of the flight and a contact time of 30 us. The law has a contact time of its
/// own, so e comes back to some 1e-5; without air it comes back too low.
#[test]
fn clicks_give_the_restitution_that_made_them() {
    let air = Medium { density: 1.2, drag: Some(0.5), viscosity: f64::NAN };
    let (radius, gravity, e) = (5e-3, 9.80665, 0.9_f64);
    let mass = 7850.0 * 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius;
    let flying = Flying::in_air(gravity, &air, radius, mass);
    let mut data = "drop_height_m,bounce_interval_s\n".to_owned();
    for height in [0.5, 2.0] {
        let (mut cell, mut speed) = (height.to_string(), flying.landing_speed(height));
        for _ in 0..6 {
            let top = flying.rise(e * speed);
            let interval = 30e-6 + flying.rise_time(e * speed) + flying.fall_time(top);
            writeln!(data, "{cell},{interval}").unwrap();
            (cell, speed) = (String::new(), flying.landing_speed(top));
        }
    }
    let noise = "noise = { bounce_interval = 1e-4 }";
    let of = |air: &str| {
        let (desk, summary) = super::calibrated(&scenario(noise, air), &data, &[], if air.is_empty() { 3 } else { 0 });
        assert!(!desk.read("o/residuals.csv").contains("NaN"));
        summary["keys"][0]["estimate"].as_f64().unwrap().sqrt()
    };
    assert!((of(AIR) - e).abs() < 1e-4, "{}", of(AIR));
    assert!(of("") < e - 1e-3, "{}", of(""));
}
