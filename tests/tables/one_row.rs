//! A row of a table and the single run of the same scene have the same bits, or nearly the same numbers if they are
//! computed by different methods.

use plm_impact::impact::{Damping, Event, Forces, Impact, Method};
use plm_impact::integrate::Work;
use proptest::prelude::*;

use crate::common::command::{Desk, column, text};
use crate::common::{STEEL, Scene, any_scene, solver};

/// Results that have the same name in `summary.json` and in a row.
const NAMES: [&str; 6] =
    ["restitution", "contact_time_s", "peak_force_N", "peak_indentation_m", "residual_indentation_m", "dent_radius_m"];

/// The number of a key of `summary.json`, read from its digits, because a reader of JSON may round them.
fn number(summary: &str, key: &str) -> Option<f64> {
    let start = format!("  \"{key}\": ");
    let line = summary.lines().find_map(|line| line.strip_prefix(start.as_str())).unwrap();
    line.trim_end_matches(',').parse().ok()
}

/// Pairs of the numbers of the single run and of a table of one row.
fn numbers(scenario: &str, speed: &str) -> Vec<(&'static str, Option<f64>, Option<f64>)> {
    let desk = Desk::with(scenario);
    let speed_of_run = format!("impact.speed=\"{speed}\"");
    let axis = format!("sweep.\"impact.speed\"=[\"{speed}\"]");
    for (out, set) in [("one", &speed_of_run), ("table", &axis)] {
        let output = desk.call(&["run", "s.toml", "--out", out, "--set", set]);
        assert!(output.status.success(), "{scenario}: {}", text(&output.stderr));
    }
    let (summary, table) = (desk.read("one/summary.json"), desk.read("table/table.csv"));
    let of_row = |name| column(&table, name)[0].parse().ok();
    NAMES.map(|name| (name, number(&summary, name), of_row(name))).to_vec()
}

#[test]
fn a_row_has_the_bits_of_the_single_run() {
    let forces = [
        "",
        "[gravity]\nacceleration = \"9.81 m/s^2\"\n",
        "[damping]\nhunt_crossley = \"0.05 s/m\"\n",
        "[damping]\nviscous = 0.1\n",
    ];
    let methods = ["auto", "rk8", "dopri5", "dop853", "verlet", "closed_form"];
    for (which, of_forces) in forces.into_iter().enumerate() {
        for method in methods {
            // a single run writes a trace, which has no closed form under forces
            if method == "closed_form" && which > 0 {
                continue;
            }
            // elastic, just beyond first yield, and far beyond it
            for speed in ["5 mm/s", "9.8 mm/s", "3 m/s"] {
                let solver = format!("[solver]\nmethod = \"{method}\"\ntolerance = 1e-9\n");
                for (name, one, row) in numbers(&format!("{STEEL}{of_forces}{solver}"), speed) {
                    let about = format!("{name} by {method}, {of_forces:?}, {speed}: {one:?} {row:?}");
                    // with `auto` the row is by closed form and the single run by rk8, which is accurate to ten times
                    // the tolerance; with `closed_form` the trace of the single run changes the rounding
                    let bound = match method {
                        "auto" if which < 2 => 10.0 * 1e-9,
                        "closed_form" => 1e-14,
                        _ => 0.0,
                    };
                    match (one, row) {
                        (Some(one), Some(row)) if bound > 0.0 => assert!((one - row).abs() <= bound * row, "{about}"),
                        (one, row) => assert_eq!(one.map(f64::to_bits), row.map(f64::to_bits), "{about}"),
                    }
                }
            }
        }
    }
}

/// All digits of the results of an impact, without its work, its trace, and the drift of the energy, which the trace
/// changes.
fn results(impact: &mut Impact) -> String {
    (impact.energy.drift, impact.work) = (0.0, Work::default());
    impact.warnings.clear();
    impact.trace.clear();
    format!("{impact:?}")
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    #[test]
    fn a_trace_changes_no_result(scene in any_scene(), log_speed in -0.5..3.0_f64, which in 0..5_usize) {
        let contact = scene.contact();
        let speed = contact.yield_speed().unwrap() * 10_f64.powf(log_speed);
        let damping = [None, None, Some(Damping::HuntCrossley(0.1 / speed)), Some(Damping::Viscous(0.1)), None][which];
        let forces = Forces { gravity: (which == 1).then_some(9.81), damping, ..Forces::default() };
        let contact = contact.with_forces(forces);
        for method in [Method::Rk8, Method::Dopri5, Method::Dop853, Method::Verlet] {
            let with = |samples| contact.impact(speed, &solver(method, 1e-8), samples).map(|mut impact| results(&mut impact));
            prop_assert_eq!(with(Some(30)), with(None));
        }
    }
}

#[test]
fn a_trace_tells_of_first_yield_in_order_of_time() {
    let contact = Scene::steel().contact();
    for share in [1.0 + 1e-6, 1.5, 100.0] {
        for method in [Method::Rk8, Method::Dopri5, Method::Dop853, Method::ClosedForm] {
            let speed = share * contact.yield_speed().unwrap();
            let trace = contact.impact(speed, &solver(method, 1e-10), Some(40)).unwrap().trace;
            let times: Vec<f64> = trace.iter().map(|row| row.time).collect();
            assert!(times.is_sorted(), "{share}, {method:?}: {times:?}");
            let yields = trace.iter().filter(|row| row.event == Some(Event::Yield));
            assert_eq!(yields.count(), 1, "{share}, {method:?}");
        }
    }
}
