//! `output.traces`: the traces of the rows of a short table.

use crate::common::prelude::*;

const RUN: [&str; 4] = ["run", "s.toml", "--out", "o"];

fn sweep(axes: &str) -> Sandbox {
    Sandbox::with(format!("{STEEL}[sweep]\n{axes}\n[output]\nsamples = 50\ntraces = true\n"))
}

/// The lines of a table below its header, without the first fields.
fn lines_of_case(traces: &str, case: &str, skipped: usize) -> Vec<String> {
    let own = traces.lines().skip(1).filter(|line| line.split(',').next() == Some(case));
    own.map(|line| line.split(',').skip(skipped).collect::<Vec<_>>().join(",")).collect()
}

#[test]
fn traces_equal_those_of_single_impacts() {
    let desk = sweep("\"impact.speed\" = [\"1 m/s\", \"2 m/s\"]\nlaw = [\"plm\", \"thornton\"]");
    desk.run_expecting(&[&RUN[..], &["--pictures", "svg"]].concat(), 0);
    let traces = desk.read("o/traces.csv");
    assert!(traces.starts_with("case,impact_speed_m_per_s,law,time_s,indentation_m,"), "{traces}");
    for (case, speed, law) in [("0", "1", "plm"), ("1", "1", "thornton"), ("2", "2", "plm"), ("3", "2", "thornton")] {
        let (speed, law) = (format!("impact.speed={speed}"), format!("law={law}"));
        let set = ["--set", "sweep=none", "--set", "output.traces=false", "--set", &speed, "--set", &law];
        let out = format!("one{case}");
        desk.run_expecting(&[&["run", "s.toml", "--pictures", "none", "--out", &out], &set[..]].concat(), 0);
        let single = desk.read(&format!("{out}/trace.csv"));
        let lines: Vec<String> = single.lines().skip(1).map(str::to_owned).collect();
        assert_eq!(lines_of_case(&traces, case, 3), lines, "{case}");
    }
    // the key of both pictures has one name for each row
    for picture in ["force_time", "force_indentation"] {
        let drawn = desk.read(&format!("o/{picture}.svg"));
        for name in ["1\u{a0}m/s, ", "2\u{a0}m/s, "] {
            assert_eq!(drawn.matches(name).count(), 2, "{picture} {name}");
        }
    }
    let files = desk.json("o/summary.json")["provenance"]["files"].clone();
    assert!(files.as_array().unwrap().contains(&json!("traces.csv")), "{files}");
}

/// A table of this number of rows has traces, and a table with one row more has none.
#[test]
fn long_tables_are_refused() {
    let speeds = |points: u32| format!("\"impact.speed\" = {{ linspace = [1, 2], points = {points} }}");
    let desk = sweep(&speeds(12));
    desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 0);
    assert_eq!(desk.files("o"), ["summary.json", "table.csv", "traces.csv"]);
    let desk = sweep(&speeds(13));
    let said = desk.run_expecting(&RUN, 2).1;
    assert!(
        said.contains("output.traces: this table has 13 rows, and at most 12") && said.contains("Use fewer values"),
        "{said}"
    );
    assert!(!desk.path("o").exists());
}

#[test]
fn traces_belong_to_a_sweep() {
    let refused = |text: String, words: &str| {
        let said = Sandbox::with(text).run_expecting(&RUN, 2).1;
        assert!(said.contains(words), "{said}");
    };
    let output = "[output]\ntraces = true\n";
    refused(format!("{STEEL}{output}"), "output.traces: applies to [sweep] only, and this scenario is a single impact");
    let random = "[monte_carlo]\nsamples = 3\n\"impact.speed\" = { uniform = [1, 2] }\n";
    refused(format!("{STEEL}{random}{output}"), "replace [monte_carlo] by [sweep]");
    refused(format!("{STEEL}[output]\ntraces = \"yes\"\n"), "expected true or false, without quotes");
    // a key that is false changes nothing
    Sandbox::with_results(format!("{STEEL}[output]\ntraces = false\n"));
}

/// A row without a result has no trace.
#[test]
fn row_without_result_has_no_trace() {
    let desk = sweep("\"impact.speed\" = [1, 1e-250]");
    desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 1);
    let traces = desk.read("o/traces.csv");
    assert!(!lines_of_case(&traces, "0", 1).is_empty() && lines_of_case(&traces, "1", 1).is_empty());
}
