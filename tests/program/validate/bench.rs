//! `plm-impact bench` as a process: its files, not the measured times.

use std::process::Command;

use crate::common::prelude::*;

const PROBLEMS: [&str; 9] = ["P1", "P2", "P3", "shallow", "deep", "soft sphere", "hardened", "damped", "plate"];
const METHODS: [&str; 5] = ["rk8", "dop853", "dopri5", "verlet", "closed_form"];
const ERRORS: [&str; 3] = ["restitution_error", "contact_time_error", "peak_force_error"];

/// There is no closed form under viscous damping, or on a plate.
fn serves(method: &str, problem: &str) -> bool {
    method != "closed_form" || !["damped", "plate"].contains(&problem)
}

/// A page without its table, and without its other numbers.
fn split_words(page: &str) -> Vec<String> {
    let lines = page.lines().filter(|line| !line.starts_with('|'));
    lines.map(|line| line.replace(|letter: char| letter.is_ascii_digit() || letter == '.', "")).collect()
}

#[test]
fn bench_writes_the_whole_report() {
    let desk = Sandbox::with("");
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
    // as on a machine with one core, where two tables share the only thread in turn
    command.env("RAYON_NUM_THREADS", "1").current_dir(desk.path("")).args(["bench", "--quick", "--out", "out"]);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", text(&output.stderr));

    let mut names = PROBLEMS.map(|problem| format!("{}.png", problem.to_lowercase().replace(' ', "-"))).to_vec();
    for picture in &names {
        assert!(has_free_border(&fs::read(desk.path("out").join(picture)).unwrap()), "{picture}");
    }
    names.extend(["speed_vs_error.csv", "rows_by_law.csv", "README.md"].map(str::to_owned));
    names.sort();
    assert_eq!(desk.files("out"), names);

    let report = desk.read("out/README.md");
    // without the measured numbers, the page in the repository is what the command writes
    let kept = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/plots/bench/README.md")).unwrap();
    assert_eq!(split_words(&kept), split_words(&report), "plots/bench/README.md is stale");
    assert_eq!(text(&output.stdout).trim_end(), report.trim_end());
    check_rows(&desk.read("out/speed_vs_error.csv"), &report);
}

fn check_rows(table: &str, report: &str) {
    let (problems, methods) = (column(table, "problem"), column(table, "method"));
    let of = |name: &str| numbers(table, name);
    let (tolerances, steps, evaluations, times) =
        (of("tolerance"), of("steps"), of("force_evaluations"), of("ns_per_impact"));
    let errors = ERRORS.map(of);
    for (i, (problem, method)) in problems.iter().zip(&methods).enumerate() {
        let at = format!("{problem} {method}");
        assert!(PROBLEMS.contains(&problem.as_str()) && METHODS.contains(&method.as_str()), "{at}");
        assert!(errors.iter().all(|error| error[i] >= 0.0 && error[i].is_finite()), "{at}");
        assert!(times[i] > 0.0 && times[i].is_finite(), "{at}");
        let is_stepped = method != "closed_form";
        assert!((steps[i] > 0.0) == is_stepped && (evaluations[i] > 0.0) == is_stepped, "{at}");
        // a fixed step and the closed form have no tolerance
        assert_eq!(tolerances[i].is_finite(), is_stepped && method != "verlet", "{at}");
    }
    for problem in PROBLEMS {
        assert!(report.contains(&format!("\n| {problem} | ")), "{problem}\n{report}");
    }
    for (problem, method) in PROBLEMS.into_iter().flat_map(|problem| METHODS.map(|method| (problem, method))) {
        if !serves(method, problem) {
            continue;
        }
        let own: Vec<usize> =
            (0..problems.len()).filter(|i| problems[*i] == problem && methods[*i] == method).collect();
        let rungs = if method == "closed_form" { 1 } else { 5 };
        assert!(own.len() >= rungs, "{problem}: {} rows of {method}", own.len());
        if ["rk8", "closed_form"].contains(&method) {
            let tightest = own.into_iter().min_by(|a, b| tolerances[*a].total_cmp(&tolerances[*b])).unwrap();
            // a damped run is measured against one that is ten times as exact
            let most = if problem == "damped" { 1e-11 } else { 1e-12 };
            assert!(errors.iter().all(|error| error[tightest] < most), "{problem} {method}");
        }
    }
}
