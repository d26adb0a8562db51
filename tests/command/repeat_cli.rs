//! `[repeat]` as text and as a process: refusals and outputs.

use plm_impact::math::power::max_or_nan;
use plm_impact::repeat::{Drive, Place};
use plm_impact::run::repeat::prepare_repeat;
use plm_impact::scenario::Scenario;

use crate::common::command::{Desk, column, text};

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

fn refusal(rest: &str) -> String {
    let text = format!("{BODIES}{rest}");
    let scenario = match Scenario::from_text("s.toml", &text, &[]) {
        Ok(scenario) => scenario,
        Err(error) => return error.to_string(),
    };
    match scenario.kind().and_then(|_| scenario.resolve()).and_then(|scene| scenario.repeat(&scene)) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_series_does_not_go_with_a_sweep() {
    let sweep = "[sweep]\n\"impact.speed\" = [1, 2]\n";
    let random = "[monte_carlo]\nsamples = 10\n\"sphere.radius\" = { normal = { mean = \"5 mm\", sd = \"0.1 mm\" } }\n";
    for (table, name) in [(sweep, "sweep"), (random, "monte_carlo")] {
        let message = refusal(&format!("{BOUNCING}{table}"));
        assert!(message.contains(&format!("[{name}] is given too")), "{message}");
    }
}

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
    let output = desk.call(&["run", "s.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let files = ["force_indentation.png", "height.png", "impacts.csv", "impacts.png", "summary.json", "trace.csv"];
    assert_eq!(desk.files("plots/s"), files);
    let table = text(&output.stdout);
    assert!(table.starts_with("impacts") && table.contains("fresh spot"), "{table}");
    assert!(table.contains("as many impacts as were asked for") && table.contains("time to rest"), "{table}");

    let impacts = desk.read("plots/s/impacts.csv");
    assert_eq!(column(&impacts, "impact"), ["1", "2", "3", "4"]);
    let numbers =
        |name: &str| -> Vec<f64> { column(&impacts, name).iter().map(|cell| cell.parse().unwrap()).collect() };
    let (e, speed, rebound) =
        (numbers("restitution"), numbers("impact_speed_m_per_s"), numbers("rebound_speed_m_per_s"));
    // v = √(2 g h)
    assert!((speed[0] - (2.0 * 9.81 * 0.5_f64).sqrt()).abs() < 1e-15);
    for i in 0..4 {
        assert!((e[i] * speed[i] / rebound[i] - 1.0).abs() < 1e-15);
    }
    let summary: serde_json::Value = serde_json::from_str(&desk.read("plots/s/summary.json")).unwrap();
    assert_eq!((&summary["impacts"], &summary["ended_by"]), (&4.into(), &"impacts".into()));
    let rest = 2.0 * rebound[3] / 9.81 / (1.0 - e[3]);
    assert!((summary["remaining_time_s"].as_f64().unwrap() / rest - 1.0).abs() < 1e-14);
    assert_eq!(summary["provenance"]["command"], "plm-impact run s.toml");
    assert_eq!(summary["drop_height_m"], 0.5);

    let trace = desk.read("plots/s/trace.csv");
    let times: Vec<f64> = column(&trace, "time_s").iter().map(|cell| cell.parse().unwrap()).collect();
    assert!(times.windows(2).all(|pair| pair[0] <= pair[1]));
    let heights: Vec<f64> = column(&trace, "height_m").iter().map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(heights[0], 0.5);
    assert_eq!(column(&trace, "event").iter().filter(|event| *event == "touch").count(), 4);
    let deepest = numbers("peak_indentation_m").into_iter().fold(0.0, max_or_nan);
    let lowest = heights.iter().map(|height| -height).fold(0.0, max_or_nan);
    assert!((lowest / deepest - 1.0).abs() < 1e-8);
}

#[test]
fn shots_have_no_time_and_an_elastic_half_space_no_dent() {
    let elastic = BODIES.replace("yield_strength = \"276 MPa\"\n", "");
    let desk = Desk::with(format!("{elastic}[repeat]\nspot = \"same\"\nspeeds = [1, 2]\n"));
    let output = desk.call(&["run", "s.toml", "--quiet", "--out", "o"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    assert!(!desk.path("o/height.png").exists());
    let header = desk.read("o/impacts.csv").lines().next().unwrap().to_owned();
    assert_eq!(
        header,
        "impact,impact_speed_m_per_s,restitution,rebound_speed_m_per_s,peak_force_N,peak_indentation_m,contact_time_s,kinetic_in_J,recovered_J,energy_drift"
    );
    assert_eq!(column(&desk.read("o/impacts.csv"), "restitution"), ["1.0", "1.0"]);
}

#[test]
fn overrides_strict_and_check_work_as_for_one_impact() {
    let desk = Desk::with(format!("{BODIES}{BOUNCING}"));
    let check = desk.call(&["check", "s.toml", "--set", "repeat.spot=same", "--set", "repeat.impacts=7"]);
    let said = text(&check.stdout);
    assert!(said.contains("all on the same spot") && said.contains("there were 7 impacts"), "{said}");
    assert!(said.contains("impact.drop_height") && said.contains("yield speed"), "{said}");
    // a deep dent gives a warning, and with --strict nothing is written
    let fast = ["run", "s.toml", "--set", "impact.drop_height=2 km"];
    let loose = desk.call(&fast);
    assert_eq!(loose.status.code(), Some(0), "{}", text(&loose.stderr));
    assert!(text(&loose.stderr).contains("warning: impact 1: contact radius"), "{}", text(&loose.stderr));
    let strict = desk.call(&[&fast[..], &["--strict", "--out", "strict"]].concat());
    assert_eq!(strict.status.code(), Some(1));
    assert!(!desk.path("strict").exists());
    let bad = desk.call(&["run", "s.toml", "--set", "repeat.spot=both", "--out", "bad"]);
    assert_eq!(bad.status.code(), Some(2));
    assert!(!desk.path("bad").exists());
    let format = desk.call(&["run", "s.toml", "--format", "csv"]);
    assert_eq!(format.status.code(), Some(2));
    assert!(text(&format.stderr).contains("--format is for tables"), "{}", text(&format.stderr));
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
