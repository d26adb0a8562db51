//! The bytes of a table are the same on every machine: with other variants of the C library and on other processors.

use std::process::Command;

use crate::common::prelude::*;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");

/// With this setting glibc uses its variants for a processor without fused multiply-add and wide registers.
const PLAIN_GLIBC: &str = "glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-FMA4,-AVX512F,-AVX2_Usable,-FMA_Usable";

/// Tables of all kinds, with the number of rows divided by `one_of`.
fn tables(one_of: u32) -> Vec<(&'static str, String)> {
    let bodies = STEEL.replace("yield_strength = \"345 MPa\"\n", "");
    let sweep = |more: &str, points: u32, rest: &str| {
        let points = points / one_of;
        let axes = format!(
            "[sweep]\n\"impact.speed\" = {{ logspace = [\"1 mm/s\", \"100 m/s\"], points = {points} }}\n\"half_space.yield_strength\" = [\"345 MPa\", \"900 MPa\"]\n"
        );
        format!("{bodies}{more}{axes}{rest}")
    };
    let exponent = "[law.plm]\nunloading_exponent = \"pressure-shape\"\n";
    let laws = "law = [\"hertz\", \"thornton\", \"jackson_green\", \"kogut_etsion\", \"kogut_komvopoulos\", \"stronge\", \"yigit_christoforou\", \"ma_liu\", \"johnson\", \"thornton + mesarovic_johnson\", \"jackson_green + brake\"]\n";
    let random = "[monte_carlo]\nsamples = SAMPLES\n\"half_space.yield_strength\" = { lognormal = { mean = \"345 MPa\", sd = \"60 MPa\" } }\n\"sphere.radius\" = { normal = { mean = \"5 mm\", sd = \"2 mm\" } }\n\"impact.speed\" = { uniform = [1, 30] }\n";
    let random = random.replace("SAMPLES", &(5000 / one_of).to_string());
    vec![
        ("plain", sweep("", 4000, "")),
        ("exponent", sweep(exponent, 2000, "")),
        ("laws", sweep("", 60, laws)),
        ("random", format!("{bodies}{random}")),
        ("rk8", sweep("[solver]\nmethod = \"rk8\"\n", 500, "")),
        ("rk8 of laws", sweep("[solver]\nmethod = \"rk8\"\n", 10, laws)),
        ("gravity", sweep("[gravity]\nacceleration = 9.81\n", 500, "")),
        ("viscous", sweep("[damping]\nviscous = 0.1\n", 300, "")),
        ("viscous, other exponent", sweep(&format!("{exponent}[damping]\nviscous = 0.1\n"), 100, "")),
        ("hunt-crossley", sweep("[damping]\nhunt_crossley = \"0.1 s/m\"\n[gravity]\nacceleration = 9.81\n", 300, "")),
        ("damped laws", sweep("[damping]\nviscous = 0.1\n", 10, laws)),
        ("verlet", sweep("[solver]\nmethod = \"verlet\"\nsteps_per_contact = 200\n", 100, "")),
    ]
}

/// The table that the command makes of a scenario.
fn table(command: &mut Command, scenario: &str) -> Vec<u8> {
    let desk = Desk::with(scenario);
    let output = command
        .args(["run", "--quiet", "--pictures", "none", "--out"])
        .arg(desk.path("out"))
        .arg(desk.path("s.toml"))
        .output();
    let output = output.unwrap();
    assert!(matches!(output.status.code(), Some(0 | 1)), "{scenario}\n{}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(desk.path("out/table.csv")).unwrap()
}

/// The first line that differs, for a message.
fn first_difference(a: &[u8], b: &[u8]) -> String {
    let (a, b) = (String::from_utf8_lossy(a), String::from_utf8_lossy(b));
    let count = a.lines().zip(b.lines()).filter(|(a, b)| a != b).count();
    let first = a.lines().zip(b.lines()).find(|(a, b)| a != b);
    format!("{count} rows differ, the first: {first:?}")
}

fn is_the_same_under(machine: impl Fn() -> Command, one_of: u32) {
    for (name, scenario) in tables(one_of) {
        let here = table(&mut Command::new(PROGRAM), &scenario);
        let there = table(&mut machine(), &scenario);
        assert!(here == there, "{name}: {}", first_difference(&here, &there));
    }
}

#[test]
fn a_table_does_not_depend_on_the_variants_of_the_c_library() {
    let machine = || {
        let mut command = Command::new(PROGRAM);
        command.env("GLIBC_TUNABLES", PLAIN_GLIBC);
        command
    };
    is_the_same_under(machine, 1);
}

#[test]
fn shards_whose_last_digits_depend_on_the_machine_are_not_mixed() {
    #[cfg(all(target_arch = "x86_64", target_env = "gnu"))]
    let has_two_variants = std::arch::is_x86_feature_detected!("fma");
    #[cfg(not(all(target_arch = "x86_64", target_env = "gnu")))]
    let has_two_variants = false;
    let call = |desk: &Desk, tunables: Option<&str>, arguments: &[&str]| {
        let mut command = Command::new(PROGRAM);
        command.envs(tunables.map(|value| ("GLIBC_TUNABLES", value))).current_dir(desk.path(""));
        let output = command.args(arguments).output().unwrap();
        (output.status.code().unwrap(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let shard = |part| ["run", "s.toml", "--out", "shards", "--quiet", "--shard", part];
    let whole = ["run", "s.toml", "--out", "shards", "--quiet"];
    let machine = "a machine that computes powers with other last digits, on which dopri5 and dop853 depend";
    let swept = "\"solver.method\" = [\"closed_form\", \"dop853\"]";
    for (method, axis, is_exact) in [("rk8", "", true), ("dopri5", "", false), ("rk8", swept, false)] {
        // a machine with one variant has nothing that could be mixed
        let is_mixed = is_exact || !has_two_variants;
        let method = if axis.is_empty() { format!("[solver]\nmethod = \"{method}\"\n") } else { String::new() };
        let desk = Desk::with(format!("{STEEL}{method}[sweep]\n\"sphere.radius\" = [0.001, 0.002]\n{axis}\n"));
        assert_eq!(call(&desk, None, &shard("0/2")).0, 0);
        let (code, message) = call(&desk, Some(PLAIN_GLIBC), &shard("1/2"));
        if is_mixed {
            assert_eq!((code, call(&desk, Some(PLAIN_GLIBC), &whole).0), (0, 0), "{message}");
            continue;
        }
        assert_eq!(code, 2, "{message}");
        assert!(message.contains(&format!("these parts are of {machine}")), "{message}");
        assert!(!desk.path("shards/table.csv").exists());
        // with the same variant, shards make a table
        std::fs::remove_dir_all(desk.path("shards")).unwrap();
        for part in ["0/2", "1/2", "0/2"] {
            assert_eq!(call(&desk, Some(PLAIN_GLIBC), &shard(part)).0, 0);
        }
        assert_eq!(call(&desk, Some(PLAIN_GLIBC), &whole).0, 0);
    }
}

#[test]
#[cfg(target_arch = "x86_64")]
#[ignore = "needs qemu-x86_64 (package qemu-user)"]
fn a_table_does_not_depend_on_the_processor() {
    // a processor without AVX and fused multiply-add, and one with both
    for processor in ["Nehalem", "Haswell"] {
        let machine = || {
            let mut command = Command::new("qemu-x86_64");
            command.args(["-cpu", processor, PROGRAM]);
            command
        };
        // the emulator is slow, so there are fewer rows
        is_the_same_under(machine, 5);
    }
}
