//! `plm-impact bench` as a process: its files, not the measured times.

use std::collections::BTreeSet;
use std::fs;
use std::io::Cursor;

use assert_cmd::Command;
use tempfile::TempDir;

const PROBLEMS: [&str; 9] = ["P1", "P2", "P3", "shallow", "deep", "soft sphere", "hardened", "damped", "plate"];
const METHODS: [&str; 5] = ["rk8", "dop853", "dopri5", "verlet", "closed_form"];
const COLUMNS: [&str; 10] = [
    "problem",
    "method",
    "tolerance",
    "restitution_error",
    "contact_time_error",
    "separation_error",
    "peak_force_error",
    "force_evaluations",
    "steps",
    "ns_per_impact",
];

/// There is no closed form under viscous damping, or on a plate.
fn serves(method: &str, problem: &str) -> bool {
    method != "closed_form" || !["damped", "plate"].contains(&problem)
}

struct Row {
    problem: String,
    method: String,
    tolerance: Option<f64>,
    /// Errors of restitution, contact time, observed separation and peak force.
    errors: [f64; 4],
    force_evaluations: u64,
    steps: u64,
    ns_per_impact: f64,
}

fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    assert_eq!(reader.headers().unwrap(), &csv::StringRecord::from(COLUMNS.to_vec()));
    let row = |record: csv::StringRecord| Row {
        problem: record[0].to_string(),
        method: record[1].to_string(),
        tolerance: if record[2].is_empty() { None } else { Some(record[2].parse().unwrap()) },
        errors: [3, 4, 5, 6].map(|i: usize| record[i].parse().unwrap()),
        force_evaluations: record[7].parse().unwrap(),
        steps: record[8].parse().unwrap(),
        ns_per_impact: record[9].parse().unwrap(),
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

/// A page without the cells of its tables, and without the number of threads.
fn words(page: &str) -> Vec<&str> {
    let is_measured = |line: &&str| line.starts_with('|') || line.starts_with("Rows a second on");
    page.lines().filter(|line| !is_measured(line)).collect()
}

fn assert_is_picture(bytes: &[u8]) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), plm_impact::plot::SIZE);
    let dark = pixels.iter().filter(|value| **value < 128).count();
    assert!(dark > pixels.len() / 200, "an empty picture");
}

#[test]
fn bench_writes_the_whole_report() {
    let directory = TempDir::new().unwrap();
    let out = directory.path().join("out");
    // a directory of the user, with the name that the bench used earlier for its tables
    fs::create_dir_all(out.join("throughput")).unwrap();
    fs::write(out.join("throughput/notes"), "mine").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_plm-impact"))
        // as on a machine with one core, where two tables share the only thread in turn
        .env("RAYON_NUM_THREADS", "1")
        .args(["bench", "--quick", "--out"])
        .arg(&out)
        .assert()
        .success()
        .get_output()
        .clone();

    let names: BTreeSet<String> =
        fs::read_dir(&out).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    let picture = |problem: &str| format!("{}.png", problem.to_lowercase().replace(' ', "-"));
    let pictures = PROBLEMS.map(picture);
    let others = ["speed_vs_error.csv", "README.md", "throughput"].map(str::to_owned);
    let want = pictures.iter().cloned().chain(others).collect();
    assert_eq!(fs::read_to_string(out.join("throughput/notes")).unwrap(), "mine");
    assert_eq!(names, want);
    for name in &pictures {
        assert_is_picture(&fs::read(out.join(name)).unwrap());
        assert!(crate::common::picture::has_free_border(&fs::read(out.join(name)).unwrap()), "{name}");
    }

    let report = fs::read_to_string(out.join("README.md")).unwrap();
    // without the measured numbers, the page in the repository is what the command writes
    let kept = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/plots/bench/README.md")).unwrap();
    assert_eq!(words(&kept), words(&report), "plots/bench/README.md is stale");
    assert_eq!(String::from_utf8(output.stdout).unwrap().trim_end(), report.trim_end());
    for problem in PROBLEMS {
        for method in METHODS.into_iter().filter(|method| serves(method, problem)) {
            assert!(report.contains(&format!("\n| {problem} | {method} | ")), "{problem}, {method}\n{report}");
        }
    }
    check_rows(&rows(&fs::read_to_string(out.join("speed_vs_error.csv")).unwrap()));
}

fn check_rows(rows: &[Row]) {
    for row in rows {
        assert!(PROBLEMS.contains(&row.problem.as_str()), "{}", row.problem);
        assert!(METHODS.contains(&row.method.as_str()), "{}", row.method);
        assert!(row.errors.iter().all(|error| *error >= 0.0 && error.is_finite()), "{} {}", row.problem, row.method);
        assert!(row.ns_per_impact > 0.0 && row.ns_per_impact.is_finite(), "{} {}", row.problem, row.method);
        let steps = row.method != "closed_form";
        assert!((row.steps > 0) == steps && (row.force_evaluations > 0) == steps, "{} {}", row.problem, row.method);
        // a fixed step and the closed form have no tolerance
        let is_adaptive = !["verlet", "closed_form"].contains(&row.method.as_str());
        assert_eq!(row.tolerance.is_some(), is_adaptive, "{} {}", row.problem, row.method);
        let [_, contact_time, separation, _] = row.errors;
        if row.method == "verlet" && ["damped", "plate"].contains(&row.problem.as_str()) {
            // the drag lags by half a step
        } else if row.method == "verlet" {
            // the bench tries several phases of the step, 0.1 to 0.9 among them: the separation observed at whole steps
            // is late by up to one step, beyond the error of the motion
            let (steps, printed) = (f64::from(u32::try_from(row.steps).unwrap()), 1e-2 * separation);
            assert!(separation > 0.5 / steps && separation < 1.0 / (steps - 2.0) + contact_time + printed);
            assert!(contact_time < 0.5 * separation, "{}: {contact_time} {separation}", row.problem);
        } else {
            assert_eq!(contact_time, separation);
        }
    }
    for problem in PROBLEMS {
        for method in METHODS.into_iter().filter(|method| serves(method, problem)) {
            let of_method: Vec<&Row> =
                rows.iter().filter(|row| row.problem == problem && row.method == method).collect();
            let rungs = if method == "closed_form" { 1 } else { 5 };
            assert!(of_method.len() >= rungs, "{problem}: {} rows of {method}", of_method.len());
            if ["rk8", "closed_form"].contains(&method) {
                let tightest = of_method.iter().min_by(|a, b| a.tolerance.partial_cmp(&b.tolerance).unwrap()).unwrap();
                // a damped run is measured against one that is ten times as exact
                let most = if problem == "damped" { 1e-11 } else { 1e-12 };
                assert!(tightest.errors.iter().all(|error| *error < most), "{problem} {method}: {:?}", tightest.errors);
            }
        }
    }
}
