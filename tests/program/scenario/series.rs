//! `[repeat]`: what is read, and what is written.

use crate::common::prelude::*;

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
fn series_keys_are_read() {
    let read = |rest: &str| {
        let scenario = Scenario::from_text("s.toml", &format!("{BODIES}{rest}"), &[]).unwrap();
        scenario.series(&scenario.resolve().unwrap()).unwrap()
    };
    let bouncing = read(BOUNCING);
    assert_eq!(bouncing.spot_mode, SpotMode::Fresh);
    let SeriesMode::Bouncing { gravity, drop_height, most, until, .. } = bouncing.mode else { panic!() };
    assert_eq!((gravity, drop_height, most, until), (9.81, Some(0.5), 4, None));
    let equal = read("[impact]\nspeed = \"1 m/s\"\n[repeat]\nspot = \"same\"\nimpacts = 3\n");
    assert_eq!(equal.mode, SeriesMode::Shots(vec![1.0; 3]));
    let listed = read("[repeat]\nspot = \"same\"\nspeeds = [\"1 m/s\", \"50 cm/s\", 2]\n");
    assert_eq!(listed.mode, SeriesMode::Shots(vec![1.0, 0.5, 2.0]));
}

#[test]
fn bouncing_ball_reports_place_and_time_of_end() {
    let desk = Sandbox::with(format!("{BODIES}{BOUNCING}"));
    let (table, _) = desk.run_expecting(&["run", "s.toml", "--pictures", "none"], 0);
    assert_eq!(desk.files("plots/s"), ["impacts.csv", "summary.json", "trace.csv"]);
    assert!(table.starts_with("impacts") && table.contains("fresh spot"), "{table}");
    assert!(table.contains("maximum number of impacts") && table.contains("time to rest"), "{table}");
    let (impacts, trace) = (desk.read("plots/s/impacts.csv"), desk.read("plots/s/trace.csv"));
    let summary = desk.json("plots/s/summary.json");
    assert_eq!((&summary["impacts"], &summary["ended_by"]), (&4.into(), &"impacts".into()));
    let last = |name: &str| *numbers(&impacts, name).last().unwrap();
    let rest = 2.0 * last("rebound_speed_m_per_s") / 9.81 / (1.0 - last("restitution"));
    assert!((summary["remaining_time_s"].as_f64().unwrap() / rest - 1.0).abs() < 1e-14);
    // the time to rest is the whole time, and the remaining part of it is named
    let [whole, separation] = ["rest_time_s", "last_separation_time_s"].map(|name| summary[name].as_f64().unwrap());
    assert!(relative_error(whole, separation + rest) < 1e-14 && whole > separation);
    let line = table.lines().find(|line| line.starts_with("time to rest")).unwrap();
    let [_, _, _, of_all, "s", of_rest, "ms", ..] = line.split_whitespace().collect::<Vec<_>>()[..] else {
        panic!("{line}")
    };
    assert!(
        relative_error(of_all.parse().unwrap(), whole) < 1e-3
            && relative_error(of_rest.parse().unwrap(), 1e3 * rest) < 1e-3,
        "{line}"
    );
    assert!(line.ends_with("after the last separation"), "{line}");
    // the trace goes from the release through every impact
    assert!(numbers(&trace, "time_s").is_sorted() && numbers(&trace, "height_m")[0] == 0.5);
    assert_eq!(column(&trace, "event").iter().filter(|event| *event == "touch").count(), 4);
}

#[test]
fn shots_have_no_time_elastic_ones_no_dent() {
    let elastic = BODIES.replace("yield_strength = \"276 MPa\"\n", "");
    let desk = Sandbox::with_results(format!("{elastic}[repeat]\nspot = \"same\"\nspeeds = [1, 2]\n"));
    assert!(!desk.path("out/height.png").exists());
    let impacts = desk.read("out/impacts.csv");
    assert_eq!(
        impacts.lines().next().unwrap(),
        "impact,impact_speed_m_per_s,restitution,rebound_speed_m_per_s,peak_force_N,peak_indentation_m,contact_time_s,kinetic_in_J,recovered_J,energy_balance_error"
    );
    assert_eq!(column(&impacts, "restitution"), ["1.0", "1.0"]);
}

/// A series that ends captured has separated before: at the touch and the contact time of the last impact that left.
#[test]
fn last_separation_belongs_to_last_separated_impact() {
    let damped = BOUNCING.replace("0.5 m", "1 mm").replace("impacts = 4", "impacts = 10000");
    let desk = Sandbox::with_results(format!("{BODIES}{damped}[damping]\nviscous = 0.3\n"));
    let (impacts, summary) = (desk.read("out/impacts.csv"), desk.summary());
    let [times, contacts] = ["time_s", "contact_time_s"].map(|name| numbers(&impacts, name));
    let last = contacts.iter().rposition(|contact| contact.is_finite()).unwrap();
    assert!(summary["ended_by"] == "captured" && last > 2, "{summary}");
    let got = summary["last_separation_time_s"].as_f64().unwrap();
    assert!(relative_error(got, times[last] + contacts[last]) < 1e-14, "{got}");
}

#[test]
fn bounces_report_wave_losses() {
    let bouncing = include_str!("../../../scenarios/alumina-on-aluminium-with-waves.toml").to_owned()
        + "[gravity]\nacceleration = 9.81\n[repeat]\nspot = \"same\"\nimpacts = 4\n";
    let desk = Sandbox::with_results(bouncing);
    let (impacts, summary) = (desk.read("out/impacts.csv"), desk.summary());
    let all = |name: &str| numbers(&impacts, name);
    for (at, rebound) in all("rebound_speed_m_per_s").into_iter().enumerate() {
        let speed = all("restitution_with_waves")[at] * all("impact_speed_m_per_s")[at];
        assert!(relative_error(rebound, speed) < 1e-14 && all("restitution_with_waves")[at] < all("restitution")[at]);
    }
    assert!(relative_error(summary["energy"]["waves_J"].as_f64().unwrap(), all("waves_J").iter().sum()) < 1e-14);
    assert!(relative_error(summary["final_restitution"].as_f64().unwrap(), all("restitution_with_waves")[3]) < 1e-14);
}
