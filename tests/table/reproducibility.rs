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
    let desk = Sandbox::with(scenario);
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

/// The variants are chosen by the processor: without fused multiply-add there is one, and this would compare it with itself.
#[test]
#[cfg(all(target_arch = "x86_64", target_env = "gnu"))]
fn table_is_independent_of_c_library_variant() {
    if !std::is_x86_feature_detected!("fma") {
        skip("tables under other variants of the C library", "This processor has no fused multiply-add.");
        return;
    }
    let machine = || {
        let mut command = Command::new(PROGRAM);
        command.env("GLIBC_TUNABLES", PLAIN_GLIBC);
        command
    };
    is_the_same_under(machine, 1);
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
