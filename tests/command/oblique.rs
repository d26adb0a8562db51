//! Oblique impacts in scenarios: summary, trace and tables with an angle, and nothing of it without one.

use crate::common::prelude::*;

const FRICTION: &str = "[friction]\ncoefficient = 0.15\n";

fn oblique(angle: &str) -> String {
    STEEL.replace("3 m/s\"", &format!("3 m/s\"\nangle = \"{angle}\"")) + FRICTION
}

/// The results of friction and the columns of a trace; their numbers are in tests/same_numbers (oblique.toml), and the balances
/// of energy and momentum in tests/physics.
#[test]
fn an_angle_adds_its_results_and_without_one_they_are_not_there() {
    const RESULTS: [&str; 5] =
        ["/rebound_angle_deg", "/impulse_ratio", "/sliding_regime", "/energy/friction_J", "/inputs/impact_angle_rad"];
    for (scene, is_there) in [(STEEL.to_owned(), false), (oblique("20 deg"), true)] {
        let desk = Desk::with(scene);
        let (shown, _) = desk.ends(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
        let (summary, trace) = (desk.summary(), desk.read("out/trace.csv"));
        assert!(RESULTS.iter().all(|name| summary.pointer(name).is_some() == is_there), "{summary}");
        assert_eq!(shown.contains("rebound angle") && shown.contains("partial"), is_there, "{shown}");
        assert_eq!(
            trace.contains("slip_speed_m_per_s,friction_force_N,tangential_speed_m_per_s,spin_rad_per_s"),
            is_there
        );
        // e is that of the normal speed
        let cos = if is_there { 20_f64.to_radians().cos() } else { 1.0 };
        let number = |name: &str| summary[name].as_f64().unwrap();
        assert!((number("rebound_speed_m_per_s") / (number("restitution") * 3.0 * cos) - 1.0).abs() < 1e-12);
    }
    // most of the way at 70 degrees
    let summary = Desk::ran(oblique("70 deg")).summary();
    assert_eq!(summary["sliding_regime"], "sliding");
    assert!((summary["impulse_ratio"].as_f64().unwrap() - 0.15).abs() < 1e-12);
}

#[test]
fn a_table_has_columns_of_friction_where_an_angle_varies() {
    let sweep = "[sweep]\n\"friction.coefficient\" = [0.1, 0.3]\n\"impact.angle\" = [\"0 deg\", \"10 deg\", \"60 deg\"]\n\"sphere.spin\" = [-50, 0]\n";
    let names = |tables: &str| {
        let scenario = Scenario::from_text("s.toml", &(STEEL.to_owned() + tables), &[]);
        scenario.unwrap().plan().unwrap().column_names()
    };
    let names_of_sweep = names(sweep);
    for name in [
        "rebound_angle_deg",
        "tangential_restitution",
        "rebound_spin_rad_per_s",
        "is_sliding",
        "psi_1",
        "friction_error",
    ] {
        assert!(names_of_sweep.iter().any(|column| column == name), "{name} in {names_of_sweep:?}");
    }
    // straight tables have no such columns
    assert!(names("[sweep]\n\"impact.speed\" = [1, 2]\n").iter().all(|name| !name.contains("angle")));
}
