//! Oblique impacts in scenarios: summary, trace and tables with an angle, and nothing of it without one.

use plm_impact::scenario::Scenario;
use plm_impact::sweep::evaluator::{Evaluator, Rows};
use serde_json::Value;

use crate::common::STEEL;
use crate::common::command::{Desk, column, text};

const FRICTION: &str = "[friction]\ncoefficient = 0.15\n";

fn oblique(angle: &str) -> String {
    STEEL.replace("3 m/s\"", &format!("3 m/s\"\nangle = \"{angle}\"")) + FRICTION
}

fn run(desk: &Desk) -> (Value, String) {
    let output = desk.call(&["run", "s.toml", "--out", "out", "--pictures", "none"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    (serde_json::from_str(&desk.read("out/summary.json")).unwrap(), text(&output.stdout))
}

#[test]
fn an_angle_adds_its_results_and_without_one_they_are_not_there() {
    const RESULTS: [&str; 10] = [
        "/rebound_angle_deg",
        "/tangential_restitution",
        "/contact_point_restitution",
        "/rebound_tangential_speed_m_per_s",
        "/rebound_spin_rad_per_s",
        "/impulse_ratio",
        "/friction_loss_fraction",
        "/sliding_regime",
        "/energy/friction_J",
        "/energy/angular_momentum_drift",
    ];
    const TRACED: &str = "slip_speed_m_per_s,friction_force_N,tangential_speed_m_per_s,spin_rad_per_s,branch";
    let straight = Desk::with(STEEL);
    let (summary, shown) = run(&straight);
    assert!(RESULTS.iter().all(|name| summary.pointer(name).is_none()) && !shown.contains("friction"));
    assert!(summary["inputs"].get("impact_angle_rad").is_none());
    assert!(!straight.read("out/trace.csv").contains("slip_speed"));

    let desk = Desk::with(oblique("20 deg"));
    let (summary, shown) = run(&desk);
    assert!(RESULTS.iter().all(|name| summary.pointer(name).is_some()), "{summary}");
    assert!(shown.contains("rebound angle") && shown.contains("partial"), "{shown}");
    let number = |name: &str| summary.pointer(name).and_then(Value::as_f64).unwrap();
    assert_eq!(number("/inputs/impact_angle_rad"), 20_f64.to_radians());
    let (sin, cos) = (20_f64.to_radians().sin(), 20_f64.to_radians().cos());
    // e is that of the normal speed
    assert!((number("/rebound_speed_m_per_s") / (number("/restitution") * 3.0 * cos) - 1.0).abs() < 1e-12);
    assert!(
        (number("/rebound_tangential_speed_m_per_s") / (number("/tangential_restitution") * 3.0 * sin) - 1.0).abs()
            < 1e-12
    );
    assert!(number("/friction_error") < 1e-5 && number("/energy/angular_momentum_drift") < 1e-14);
    // energy: half m v^2 in two parts, each with its own balance
    let of = |name: &str| number(&format!("/energy/{name}"));
    let mass = number("/sphere_mass_kg");
    assert!(((of("kinetic_in_J") + of("tangential_in_J")) / (0.5 * mass * 9.0) - 1.0).abs() < 1e-12);
    assert!(((of("tangential_recovered_J") + of("friction_J")) / of("tangential_in_J") - 1.0).abs() < 1e-12);
    // the trace ends as the summary says, and friction is never above mu F
    let trace = desk.read("out/trace.csv");
    assert!(trace.lines().next().unwrap().contains(TRACED));
    let values =
        |name: &str| column(&trace, name).iter().map(|value| value.parse::<f64>().unwrap()).collect::<Vec<_>>();
    assert!((values("spin_rad_per_s").last().unwrap() / number("/rebound_spin_rad_per_s") - 1.0).abs() < 1e-6);
    let largest = values("force_N").into_iter().fold(0.0, f64::max);
    let forces = values("force_N").into_iter().zip(values("friction_force_N"));
    assert!(forces.into_iter().all(|(force, friction)| friction.abs() <= 0.15 * force + 1e-4 * largest));
    // most of the way at 70 degrees
    let (summary, _) = run(&Desk::with(oblique("70 deg")));
    assert_eq!(summary["sliding_regime"], "sliding");
    assert!((summary["impulse_ratio"].as_f64().unwrap() - 0.15).abs() < 1e-12);
}

#[test]
fn rows_of_a_table_are_the_single_impacts() {
    let sweep = "[sweep]\n\"friction.coefficient\" = [0.1, 0.3]\n\"impact.angle\" = [\"0 deg\", \"10 deg\", \"60 deg\"]\n\"sphere.spin\" = [-50, 0]\n";
    let scenario = |text: &str, set: &[String]| Scenario::from_text("s.toml", text, set).unwrap();
    let plan = scenario(&(STEEL.to_owned() + sweep), &[]).plan().unwrap().unwrap();
    let names = plan.column_names();
    for name in ["rebound_angle_deg", "tangential_restitution", "rebound_spin_rad_per_s", "is_sliding", "psi_1"] {
        assert!(names.iter().any(|column| column == name), "{name} in {names:?}");
    }
    let mut rows = Rows::default();
    Evaluator::new(&plan).rows(0..12, &mut rows);
    let mut case = 0;
    for friction in [0.1, 0.3] {
        for angle in [0, 10, 60] {
            for spin in [-50, 0] {
                let set = [
                    format!("friction.coefficient={friction}"),
                    format!("impact.angle={angle} deg"),
                    format!("sphere.spin={spin}"),
                ];
                let scene = scenario(STEEL, &set).resolve().unwrap();
                let single = scene.contact().unwrap().essentials(scene.approach_at(scene.speed)).unwrap();
                let row = rows.results[case].as_ref().unwrap();
                // as debug text, because some of the numbers are none where nothing slips
                assert_eq!(format!("{row:?}"), format!("{single:?}"), "{set:?}");
                case += 1;
            }
        }
    }
    // straight tables have no such columns
    let straight = scenario(&(STEEL.to_owned() + "[sweep]\n\"impact.speed\" = [1, 2]\n"), &[]);
    assert!(straight.plan().unwrap().unwrap().column_names().iter().all(|name| !name.contains("angle")));
}

#[test]
fn friction_where_nothing_slides_is_told() {
    let output = Desk::with(STEEL.to_owned() + FRICTION).call(&["check", "s.toml"]);
    assert!(
        text(&output.stderr).contains("friction.coefficient is not used: without impact.angle"),
        "{}",
        text(&output.stderr)
    );
    let swept = STEEL.to_owned() + "[sweep]\n\"friction.coefficient\" = [0.1, 0.2]\n";
    let output = Desk::with(swept).call(&["check", "s.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("nothing slides"), "{}", text(&output.stderr));
}

#[test]
fn a_deep_dent_at_a_flat_angle_and_unlike_materials_are_told() {
    let warned = |scene: String| text(&Desk::with(scene).call(&["check", "s.toml"]).stderr);
    let deep = warned(oblique("60 deg").replace("3 m/s", "40 m/s"));
    assert!(deep.contains("the sphere ploughs"), "{deep}");
    // a rigid ball on steel: beta = 0.29; at 2 degrees hardly anything slips
    let unlike = warned(oblique("2 deg").replacen("youngs_modulus = \"210 GPa\"", "youngs_modulus = \"rigid\"", 1));
    assert!(unlike.contains("Dundurs' beta"), "{unlike}");
    assert!(!warned(oblique("20 deg")).contains("warning"));
}
