//! The clicks of a bouncing ball: intervals from first touch to first touch, in air.

use std::fmt::Write as _;

use plm_impact::impact::flight::free_flight::{FreeFlight, Medium};

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
    let flying = FreeFlight::in_air(gravity, &air, radius, mass);
    let mut data = "drop_height_m,bounce_interval_s\n".to_owned();
    for height in [0.5, 2.0] {
        let (mut cell, mut speed) = (height.to_string(), flying.landing_speed(height));
        for _ in 0..6 {
            let top = flying.rise_height(e * speed);
            let interval = 30e-6 + flying.rise_time(e * speed) + flying.fall_time(top);
            writeln!(data, "{cell},{interval}").unwrap();
            (cell, speed) = (String::new(), flying.landing_speed(top));
        }
    }
    let noise = "noise = { bounce_interval = 1e-4 }";
    let of = |air: &str| {
        let (desk, summary) =
            super::fits::run_calibration(&scenario(noise, air), &data, &[], if air.is_empty() { 3 } else { 0 });
        assert!(!desk.read("o/residuals.csv").contains("NaN"));
        summary["keys"][0]["estimate"].as_f64().unwrap().sqrt()
    };
    assert!((of(AIR) - e).abs() < 1e-4, "{}", of(AIR));
    assert!(of("") < e - 1e-3, "{}", of(""));
}

/// The speed of a line follows from the interval of the line before, whatever else was measured there.
#[test]
fn interval_is_read_on_both_sides_of_columns() {
    let text = scenario("noise = { bounce_interval = 1e-3, contact_time = 1e-6 }", "");
    let heads = ["drop_height_m,bounce_interval_s,contact_time_us", "drop_height_m,contact_time_us,bounce_interval_s"];
    let rows = [["0.5,0.5,30", ",0.4,30"], ["0.5,30,0.5", ",30,0.4"]];
    let [right, left] = [0, 1].map(|i| {
        let data = format!("{}\n{}\n{}\n", heads[i], rows[i][0], rows[i][1]);
        let desk = crate::common::prelude::Sandbox::with(&text);
        std::fs::write(desk.path("d.csv"), data).unwrap();
        let output = desk.run(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"]);
        assert_ne!(output.status.code(), Some(2), "{}", crate::common::prelude::text(&output.stderr));
        desk.json("o/summary.json")["keys"][0]["estimate"].as_f64().unwrap()
    });
    assert!((right / left - 1.0).abs() < 1e-9, "{right} {left}");
    // without an interval the height stays unknown
    let desk = crate::common::prelude::Sandbox::with(&text);
    std::fs::write(desk.path("d.csv"), "drop_height_m,bounce_interval_s,contact_time_us\n0.5,,30\n,0.4,30\n").unwrap();
    let output = desk.run(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"]);
    assert_eq!(output.status.code(), Some(2));
}

/// Measured heights without `[air]`: the loss in the air counts twice, on the way down and up. In `[calibrate.measured]` too.
#[test]
fn heights_without_air_warn_of_both_flights() {
    let bodies = "[sphere]\nradius = \"1 mm\"\nyoungs_modulus = \"70 GPa\"\npoissons_ratio = 0.22\ndensity = \"2500 kg/m^3\"\n\
                  [half_space]\nyoungs_modulus = \"70 GPa\"\npoissons_ratio = 0.33\n[impact]\ndrop_height = \"0.5 m\"\n";
    let data = "drop_height_m,rebound_height_m\n0.5,0.2\n0.3,0.13\n0.7,0.26\n";
    let warnings = |bodies: &str, air: &str, calibrate: &str, data: &str| {
        let desk = crate::common::prelude::Sandbox::with(format!("{bodies}{air}[calibrate]\n{calibrate}\n"));
        std::fs::write(desk.path("d.csv"), data).unwrap();
        let output = desk.run(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"]);
        let said = crate::common::prelude::text(&output.stderr);
        said.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let share = |warnings: &[String]| -> Option<f64> {
        let text = warnings.iter().find(|text| text.contains("without [air] the loss in the air"))?;
        text.split("e from the measurements is ").nth(1)?.split(' ').next()?.parse().ok()
    };
    let of_file = share(&warnings(bodies, "", "data = \"d.csv\"", data)).unwrap();
    // by another way: a sphere in air of density 1.2 and drag 0.47 falls with v^2 = v_t^2 (1 - exp(-2 g h/v_t^2)), where
    // v_t^2 = 2 m g/(rho c A): 1 - v/sqrt(2 g h) of the fall and the same of a fall from the rebound height
    let slower = |height: f64| {
        let beta = 1.2 * 0.47 * 3.0 / (4.0 * 2500.0 * 1e-3);
        let x = beta * height;
        1.0 - ((1.0 - (-x).exp()) / x).sqrt()
    };
    let both = |fall: f64, rise: f64| 100.0 * (1.0 - (1.0 - slower(fall)) * (1.0 - slower(rise)));
    let want = both(0.7, 0.26);
    assert!((of_file / want - 1.0).abs() < 0.02, "{of_file} {want}");
    let measured = share(&warnings(bodies, "", "measured.rebound_height = \"0.2 m\"", data)).unwrap();
    let want = both(0.5, 0.2);
    assert!((measured / want - 1.0).abs() < 0.02, "{measured} {want}");
    assert_eq!(share(&warnings(bodies, AIR, "data = \"d.csv\"", data)), None);
    // of an interval only the fall was measured: with e = sqrt(0.5) by the law the ball rises to a half of its height
    let springs = "yield_strength = \"300 MPa\"\n[law.walton_braun]\nstiffness_ratio = 0.5\n";
    let bodies_with_springs = bodies.replace("[impact]", &format!("{springs}[impact]"));
    let intervals = "drop_height_m,bounce_interval_s\n0.5,0.45\n0.3,0.35\n0.7,0.53\n";
    let clicks = warnings(&bodies_with_springs, "", "data = \"d.csv\"\nfree = {}", intervals);
    let (of_clicks, want) = (share(&clicks).unwrap(), both(0.7, 0.35));
    assert!((of_clicks / want - 1.0).abs() < 0.02, "{of_clicks} {want}");
    // millimetres that are taken for metres
    let high = warnings(bodies, "", "data = \"d.csv\"", "drop_height_m,rebound_height_m\n1000,205\n500,110\n");
    assert!(
        high.iter().any(|text| text.contains("the drop height is 1 km, and a drop test has less than 100 m")),
        "{high:?}"
    );
}
