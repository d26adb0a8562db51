//! `[repeat]`: what is read, and what is written.

use plm_impact::math::power::max_or_nan;
use plm_impact::repeat::{Drive, Place};
use plm_impact::run::repeat::prepare_repeat;
use plm_impact::scenario::Scenario;

use crate::common::command::{Desk, column, numbers};

const BODIES: &str = r#"[sphere]
radius = "5 mm"
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
[half_space]
youngs_modulus = "69 GPa"
poissons_ratio = 0.33
yield_strength = "276 MPa"
"#;

const BOUNCING: &str = r#"[impact]
drop_height = "0.5 m"
[gravity]
acceleration = "9.81 m/s^2"
[repeat]
impacts = 4
spot = "fresh"
[output]
samples = 20
"#;

#[test]
fn what_is_asked_for_is_understood() {
    let read = |rest: &str| {
        let scenario = Scenario::from_text("s.toml", &format!("{BODIES}{rest}"), &[]).unwrap();
        scenario.repeat(&scenario.resolve().unwrap()).unwrap().unwrap()
    };
    let bouncing = read(BOUNCING);
    assert_eq!(bouncing.place, Place::Fresh);
    let Drive::Bouncing { gravity, drop_height, most, until, .. } = bouncing.drive else { panic!() };
    assert_eq!((gravity, drop_height, most, until), (9.81, Some(0.5), 4, None));
    let equal = read("[impact]\nspeed = \"1 m/s\"\n[repeat]\nspot = \"same\"\nimpacts = 3\n");
    assert_eq!(equal.drive, Drive::Shots(vec![1.0; 3]));
    let listed = read("[repeat]\nspot = \"same\"\nspeeds = [\"1 m/s\", \"50 cm/s\", 2]\n");
    assert_eq!(listed.drive, Drive::Shots(vec![1.0, 0.5, 2.0]));
}

#[test]
fn a_bouncing_ball_writes_all_its_files() {
    let desk = Desk::with(format!("{BODIES}{BOUNCING}"));
    let (table, _) = desk.ends(&["run", "s.toml"], 0);
    let files = ["force_indentation.png", "height.png", "impacts.csv", "impacts.png", "summary.json", "trace.csv"];
    assert_eq!(desk.files("plots/s"), files);
    assert!(table.starts_with("impacts") && table.contains("fresh spot"), "{table}");
    assert!(table.contains("as many impacts as were asked for") && table.contains("time to rest"), "{table}");

    let impacts = desk.read("plots/s/impacts.csv");
    assert_eq!(column(&impacts, "impact"), ["1", "2", "3", "4"]);
    let numbers = |name: &str| numbers(&impacts, name);
    let (e, speed, rebound) =
        (numbers("restitution"), numbers("impact_speed_m_per_s"), numbers("rebound_speed_m_per_s"));
    // v = √(2 g h)
    assert!((speed[0] - (2.0 * 9.81 * 0.5_f64).sqrt()).abs() < 1e-15);
    for i in 0..4 {
        assert!((e[i] * speed[i] / rebound[i] - 1.0).abs() < 1e-15);
    }
    let summary = desk.json("plots/s/summary.json");
    assert_eq!((&summary["impacts"], &summary["ended_by"]), (&4.into(), &"impacts".into()));
    let rest = 2.0 * rebound[3] / 9.81 / (1.0 - e[3]);
    assert!((summary["remaining_time_s"].as_f64().unwrap() / rest - 1.0).abs() < 1e-14);
    assert_eq!(summary["provenance"]["command"], "plm-impact run s.toml");
    assert_eq!(summary["drop_height_m"], 0.5);

    let trace = desk.read("plots/s/trace.csv");
    assert!(crate::common::command::numbers(&trace, "time_s").windows(2).all(|pair| pair[0] <= pair[1]));
    let heights = crate::common::command::numbers(&trace, "height_m");
    assert_eq!(heights[0], 0.5);
    assert_eq!(column(&trace, "event").iter().filter(|event| *event == "touch").count(), 4);
    let deepest = numbers("peak_indentation_m").into_iter().fold(0.0, max_or_nan);
    let lowest = heights.iter().map(|height| -height).fold(0.0, max_or_nan);
    assert!((lowest / deepest - 1.0).abs() < 1e-8);
}

#[test]
fn shots_have_no_time_and_an_elastic_half_space_no_dent() {
    let elastic = BODIES.replace("yield_strength = \"276 MPa\"\n", "");
    let desk = Desk::ran(format!("{elastic}[repeat]\nspot = \"same\"\nspeeds = [1, 2]\n"));
    assert!(!desk.path("out/height.png").exists());
    let impacts = desk.read("out/impacts.csv");
    assert_eq!(
        impacts.lines().next().unwrap(),
        "impact,impact_speed_m_per_s,restitution,rebound_speed_m_per_s,peak_force_N,peak_indentation_m,contact_time_s,kinetic_in_J,recovered_J,energy_drift"
    );
    assert_eq!(column(&impacts, "restitution"), ["1.0", "1.0"]);
}

#[test]
fn overrides_reach_the_series() {
    let desk = Desk::with(format!("{BODIES}{BOUNCING}"));
    let (said, _) = desk.ends(&["check", "s.toml", "--set", "repeat.spot=same", "--set", "repeat.impacts=7"], 0);
    assert!(said.contains("all on the same spot") && said.contains("there were 7 impacts"), "{said}");
    assert!(said.contains("impact.drop_height") && said.contains("yield speed"), "{said}");
}

#[test]
fn one_result_whatever_the_method() {
    let e = |method: &str| -> Vec<f64> {
        let text = format!("{BODIES}{BOUNCING}[solver]\nmethod = \"{method}\"\n");
        let scenario = Scenario::from_text("s.toml", &text, &[]).unwrap();
        let (scene, contact, repeat) = prepare_repeat(&scenario).unwrap();
        let sequence = repeat.run(&contact, &scene.solver, scene.samples, None).unwrap();
        sequence.hits.iter().map(|hit| hit.restitution).collect()
    };
    let exact = e("auto");
    assert_eq!(e("closed_form"), exact);
    for method in ["rk8", "dop853", "dopri5"] {
        for (got, want) in e(method).into_iter().zip(&exact) {
            // four impacts, each with an error of up to a few hundred times the tolerance 1e-10
            assert!((got / want - 1.0).abs() < 1e-7, "{method}: {got} {want}");
        }
    }
}
