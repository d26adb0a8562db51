//! Instructions of a row of a table, of a new contact, of an impact by rk8 and of a force for C, counted by valgrind and compared with
//! `reference/instructions.csv`. The counts are of a release build:
//!
//! ```text
//! cargo test --release --test instructions -- --ignored counts
//! ```

#![allow(clippy::unwrap_used)]
// the functions for C
#![allow(unsafe_code)]

use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;

use plm_impact::bench::problems::steel_on_steel;
use plm_impact::impact::Method;
use plm_impact::interfaces::c::{plm_contact_force, plm_contact_free, plm_contact_from_toml};
use plm_impact::{Contact, Plm, Solver};

/// The largest relative difference: another compiler inlines other functions.
const TOLERANCE: f64 = 0.05;

/// A name, and a function that repeats the work.
type Work = (&'static str, fn(u32));

const WORK: [Work; 4] = [("row", rows), ("contact", contacts), ("rk8", impacts_by_rk8), ("c_force", forces)];

/// The work of one process: a name of [`WORK`] and how often.
const VARIABLE: &str = "PLM_IMPACT_TEST_WORK";

fn steel() -> Contact {
    steel_on_steel(&Plm::default()).unwrap()
}

/// From 0.1 to 5 m/s: elastic rows, and rows on all pieces of the law.
fn speed(i: u32) -> f64 {
    0.1 + 4.9 * f64::from(i % 64) / 64.0
}

fn rows(count: u32) {
    let contact = steel();
    for i in 0..count {
        black_box(contact.row(black_box(speed(i)), &Solver::AUTO)).unwrap();
    }
}

fn contacts(count: u32) {
    for _ in 0..count {
        black_box(steel_on_steel(black_box(&Plm::default()))).unwrap();
    }
}

fn impacts_by_rk8(count: u32) {
    let (contact, solver) = (steel(), Solver { method: Method::Rk8, ..Solver::default() });
    for i in 0..count {
        black_box(contact.row(black_box(speed(i)), &solver)).unwrap();
    }
}

fn forces(count: u32) {
    let text = c"sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850 }
half_space = { youngs_modulus = 2.1e11, poissons_ratio = 0.3, yield_strength = 3.45e8 }
";
    let mut memory = [0.0; 3];
    // SAFETY: the text ends with a zero; the memory has three doubles; the contact is freed last
    unsafe {
        let contact = plm_contact_from_toml(text.as_ptr(), std::ptr::null_mut(), 0);
        for i in 0..count {
            // contacts of 100 steps: to 30 um and out again
            let depth = 3e-5 * (1.0 - (f64::from(i % 100) / 50.0 - 1.0).abs());
            if i % 100 == 0 {
                memory = [0.0; 3];
            }
            assert!(plm_contact_force(contact, black_box(depth), memory.as_mut_ptr()) >= 0.0);
        }
        plm_contact_free(contact);
    }
}

/// The process that valgrind counts.
#[test]
#[ignore = "the other test starts it"]
fn work() {
    let Ok(wanted) = std::env::var(VARIABLE) else { return };
    let (name, count) = wanted.split_once(' ').unwrap();
    let (_, work) = WORK.into_iter().find(|(known, _)| *known == name).unwrap();
    work(count.parse().unwrap());
}

/// The instructions of a process that does this work so often.
fn counted(folder: &Path, name: &str, count: u32) -> f64 {
    let file = folder.join("callgrind.out");
    let valgrind = Command::new("valgrind")
        .args(["--tool=callgrind", "--quiet"])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(std::env::current_exe().unwrap())
        .args(["--exact", "work", "--ignored", "--test-threads=1", "--quiet"])
        .env(VARIABLE, format!("{name} {count}"))
        .output()
        .unwrap();
    assert!(valgrind.status.success(), "{}", String::from_utf8_lossy(&valgrind.stderr));
    let text = fs::read_to_string(file).unwrap();
    let total = text.lines().find_map(|line| line.strip_prefix("summary: ").or_else(|| line.strip_prefix("totals: ")));
    total.unwrap().trim().parse().unwrap()
}

#[test]
#[ignore = "needs valgrind, and is for a release build"]
fn counts_are_those_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/instructions.csv");
    // the begin of a process is in both runs
    let per_call = |name: &str| (counted(folder.path(), name, 6400) - counted(folder.path(), name, 3200)) / 3200.0;
    let now: Vec<(&str, f64)> = WORK.iter().map(|(name, _)| (*name, per_call(name))).collect();
    let text = now.iter().fold("work,instructions\n".to_owned(), |mut text, (name, count)| {
        writeln!(text, "{name},{count:.0}").unwrap();
        text
    });
    let recorded = fs::read_to_string(&path).unwrap_or_default();
    let is_near = |name: &str, count: f64| {
        let line = recorded.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(','));
        line.is_some_and(|wanted| (count / wanted.parse::<f64>().unwrap() - 1.0).abs() < TOLERANCE)
    };
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        fs::write(&path, text).unwrap();
    } else {
        assert!(now.iter().all(|(name, count)| is_near(name, *count)), "counted\n{text}recorded\n{recorded}");
    }
}
