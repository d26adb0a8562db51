//! The functions for C: the header in the repository is what cbindgen makes, and a C program gets the same bits as a
//! Rust program.

#![allow(clippy::unwrap_used)]

use std::env::consts::DLL_SUFFIX;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use plm_impact::impact::{Contact, FrictionStep, Memory};
use plm_impact::interfaces::export::header::header_files;
use plm_impact::scenario::Scenario;

#[path = "common/golden.rs"]
mod golden;

use golden::assert_golden;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn the_header_is_that_of_the_source() {
    let source = root().join("src/interfaces/c/mod.rs");
    let [version, major, minor, patch] = [
        ("", env!("CARGO_PKG_VERSION")),
        ("_MAJOR", env!("CARGO_PKG_VERSION_MAJOR")),
        ("_MINOR", env!("CARGO_PKG_VERSION_MINOR")),
        ("_PATCH", env!("CARGO_PKG_VERSION_PATCH")),
    ]
    .map(|(name, number)| match name {
        "" => format!("#define PLM_IMPACT_VERSION \"{number}\"\n"),
        _ => format!("#define PLM_IMPACT_VERSION{name} {number}\n"),
    });
    let config = cbindgen::Config {
        language: cbindgen::Language::C,
        cpp_compat: true,
        include_guard: Some("PLM_IMPACT_H".to_owned()),
        header: Some("/* The contact law of plm-impact for C. Made by cbindgen from src/interfaces/c; SPDX-License-Identifier: MIT */".to_owned()),
        no_includes: true,
        sys_includes: vec!["stddef.h".to_owned(), "stdint.h".to_owned()],
        after_includes: Some(format!("\n/* Version of this header. */\n{version}{major}{minor}{patch}")),
        usize_is_size_t: true,
        ..cbindgen::Config::default()
    };
    let made = cbindgen::Builder::new().with_src(source).with_config(config).generate().unwrap();
    let mut text = Vec::new();
    made.write(&mut text);
    // the Markdown of Rust means nothing in C
    let text =
        String::from_utf8(text).unwrap().replace(" * # Safety\n", " * What the caller promises:\n").replace('`', "");
    let text = text.lines().map(|line| {
        line.replace("  // __cplusplus", "").replace(" // __cplusplus", "").replace("}  // extern \"C\"", "}")
    });
    let text = text.fold(String::new(), |text, line| text + &line + "\n");
    let path = root().join("src/interfaces/c/plm_impact.h");
    assert_golden(&path, text);
}

/// The library that this test is linked with, as cargo says it. `built` is the folder of what is built, `debug` or `release`.
fn linked_library(built: &Path) -> String {
    let release = built.ends_with("release").then_some("--release");
    let cargo = Command::new(env!("CARGO"))
        .current_dir(root())
        .args(["test", "--quiet", "--no-run", "--test", "capi", "--message-format", "json"])
        .args(release)
        .arg("--target-dir")
        .arg(built.parent().unwrap())
        .output()
        .unwrap();
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let text = String::from_utf8(cargo.stdout).unwrap();
    let is_rlib = |word: &&str| Path::new(word).extension().is_some_and(|extension| extension == "rlib");
    let mut words = text.split('"').filter(|word| word.contains("libplm_impact-") && is_rlib(word));
    words.next_back().unwrap_or_else(|| panic!("no library in\n{text}")).to_owned()
}

/// Makes a static and a shared library of it and returns their paths. The tests of the plug-in for LAMMPS take the first too.
fn libraries() -> [PathBuf; 2] {
    let test = std::env::current_exe().unwrap();
    let built = test.parent().and_then(Path::parent).unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let source = folder.join("plm_impact_c.rs");
    fs::write(&source, "pub use plm_impact::interfaces::c::*;").unwrap();
    let made = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--edition", "2024", "--crate-type", "staticlib,cdylib", "--extern"])
        .arg(format!("plm_impact={}", linked_library(built)))
        .arg("-L")
        .arg(format!("dependency={}", built.join("deps").display()))
        .args([Path::new("--out-dir"), folder, &source])
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    [".a", DLL_SUFFIX].map(|suffix| folder.join(format!("libplm_impact_c{suffix}")))
}

/// The bits of numbers as the C program prints them.
fn hex_words(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!("{:016x}", number.to_bits())).collect::<Vec<_>>().join(" ")
}

/// The indentations of the C program.
fn path() -> impl Iterator<Item = f64> {
    const TURNS: [f64; 5] = [0.0, 30e-6, 26e-6, 35e-6, -1e-6];
    (0..400_u32).map(|step| {
        let (leg, share) = ((step / 100) as usize, f64::from(step % 100) / 100.0);
        TURNS[leg] + share * (TURNS[leg + 1] - TURNS[leg])
    })
}

/// Stiffness, force, stored and plastic energy along that path.
fn along_the_path(contact: &Contact) -> Vec<String> {
    let mut memory = Memory::default();
    path()
        .map(|indentation| {
            let stiffness = contact.stiffness(indentation, &memory);
            let force = contact.force(indentation, &mut memory);
            let energy = contact.energy(indentation, force, &memory);
            hex_words(&[stiffness, force, energy.stored, energy.plastic])
        })
        .collect()
}

/// Friction along that path, after every 50th step.
fn friction_along_the_path(contact: &Contact) -> String {
    let (mut memory, mut history, mut previous_indentation, mut text) =
        (Memory::default(), [0.0; 3], 0.0, String::new());
    for (step, indentation) in path().enumerate() {
        let slip = [2e-8, if step < 200 { 1e-8 } else { -3e-8 }, 0.0];
        let force = contact.force(indentation, &mut memory);
        assert!(contact.friction(
            0.2,
            &FrictionStep { previous_indentation, indentation, force, slip },
            &memory,
            &mut history
        ));
        previous_indentation = indentation;
        if step % 50 == 49 {
            writeln!(text, "friction {}", hex_words(&history)).unwrap();
        }
    }
    text
}

/// A program is compiled as plots/lammps/README.md says.
const LINKED_WITH: [&str; 3] = ["-lm", "-lpthread", "-ldl"];

/// The header of a contact has the forces of the C functions within rounding. The output has the time of a force by both.
#[test]
fn header_has_the_forces_of_the_c_functions() {
    let scenario = root().join("scenarios/steel-on-steel.toml");
    let folder = tempfile::tempdir().unwrap();
    for file in header_files(&Scenario::load(&scenario, &[]).unwrap(), "steel", "tests/capi.rs").unwrap() {
        fs::write(folder.path().join(file.name), file.bytes).unwrap();
    }
    let include = format!("-I{}", folder.path().display());
    let line = printed("tests/capi/header.c", Link::Static, &["-O2", &include], &[&scenario]);
    let numbers: Vec<f64> =
        line.split_whitespace().filter_map(|word| word.trim_end_matches(',').parse().ok()).collect();
    assert!(numbers[0] < 1e-13, "{line}");
    println!("{line}");
}

/// The static and the shared library for all tests, made by the first.
static LIBRARIES: LazyLock<[PathBuf; 2]> = LazyLock::new(libraries);

/// How a C program gets the functions.
#[derive(Clone, Copy)]
enum Link {
    Static,
    Shared,
}

/// Compiles a C program with these options, runs it with these scenarios, and returns what it prints.
fn printed(source: &str, link: Link, options: &[&str], scenarios: &[&Path]) -> String {
    let library = &LIBRARIES[link as usize];
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("program");
    let cc = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-I"])
        .arg(root().join("src/interfaces/c"))
        .args(options)
        .arg(root().join(source))
        .arg(library)
        .arg(format!("-Wl,-rpath,{}", library.parent().unwrap().display()))
        .args(LINKED_WITH)
        .arg("-o")
        .arg(&program)
        .output()
        .unwrap();
    assert!(cc.status.success(), "{}", String::from_utf8_lossy(&cc.stderr));
    let run = Command::new(&program).args(scenarios).output().unwrap();
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(run.status.success(), "{source}: {printed}{}", String::from_utf8_lossy(&run.stderr));
    printed
}

#[test]
fn example_prints_e_as_page_shows() {
    let page = fs::read_to_string(root().join("plots/lammps/README.md")).unwrap();
    let line = format!("src/interfaces/c/drop.c target/release/libplm_impact.a {} -o drop", LINKED_WITH.join(" "));
    assert!(page.contains(&line), "{line}");
    let scenario = root().join("scenarios/steel-on-steel.toml");
    let shown = printed("src/interfaces/c/drop.c", Link::Static, &[], &[&scenario]);
    assert!(page.contains(&format!("```text\n{shown}```")), "{shown}");
    // velocity Verlet is of second order: 10 ns are a 2900th of the contact, and leave an error of some 1e-7
    let contact = Scenario::load(&scenario, &[]).unwrap().resolve().unwrap().contact().unwrap();
    let e: f64 = shown.trim().strip_prefix("e ").unwrap().parse().unwrap();
    assert!((e - contact.closed_form(3.0).unwrap().row.restitution).abs() < 1e-6);
}

/// Runs a program that a build needs and that may be missing here; `None` if it is.
#[allow(clippy::explicit_write)] // the test runner would keep what `eprintln!` says
fn run_if_installed(program: &str, arguments: &[&str], pkg_config_path: &str) -> Option<String> {
    let run = Command::new(program).args(arguments).env("PKG_CONFIG_PATH", pkg_config_path).output();
    let Ok(run) = run else {
        writeln!(std::io::stderr(), "!!! SKIPPED: the C library by {program}. The program is not here. !!!").unwrap();
        return None;
    };
    let printed = String::from_utf8(run.stdout).unwrap();
    assert!(run.status.success(), "{program} {arguments:?}: {printed}{}", String::from_utf8_lossy(&run.stderr));
    Some(printed)
}

#[test]
fn cmake_finds_the_library() {
    let [library, _] = &*LIBRARIES;
    let (c, build) = (root().join("src/interfaces/c"), tempfile::tempdir().unwrap());
    let scenario = root().join("scenarios/steel-on-steel.toml");
    let options = [
        format!("-S{}", root().join("tests/capi/cmake").display()),
        format!("-B{}", build.path().display()),
        format!("-Dplm_impact_DIR={}", c.display()),
        format!("-DPLM_IMPACT_LIBRARY={}", library.display()),
        format!("-DDROP={}", c.join("drop.c").display()),
    ];
    if run_if_installed("cmake", &options.each_ref().map(String::as_str), "").is_none() {
        return;
    }
    run_if_installed("cmake", &["--build", &build.path().display().to_string()], "").unwrap();
    let e = Command::new(build.path().join("drop")).arg(scenario).output().unwrap();
    assert_eq!(String::from_utf8(e.stdout).unwrap(), "e 0.506361\n");
}

#[test]
fn pkg_config_knows_flags_and_version() {
    let folder = root().join("src/interfaces/c").display().to_string();
    let ask = |question: &[&str]| run_if_installed("pkg-config", &[question, &["plm_impact"]].concat(), &folder);
    let Some(version) = ask(&["--modversion"]) else { return };
    assert_eq!(version.trim(), env!("CARGO_PKG_VERSION"));
    let flags = ask(&["--cflags", "--libs", "--define-variable=libdir=/somewhere"]).unwrap();
    let expected = format!("-I{folder} -L/somewhere -lplm_impact {}", LINKED_WITH.join(" "));
    assert_eq!(flags.split_whitespace().collect::<Vec<_>>().join(" "), expected);
}

/// The sanitizers of the C compiler see the whole program, and the memory that the library does not give back.
#[test]
#[cfg(target_os = "linux")]
fn c_program_has_no_leak_or_undefined_behaviour() {
    let scenarios = ["steel-on-steel", "alumina-on-aluminium-with-waves"];
    let [steel, waves] = scenarios.map(|name| root().join(format!("scenarios/{name}.toml")));
    let sanitized = ["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
    printed("src/interfaces/c/drop.c", Link::Static, &sanitized, &[&steel]);
    printed("tests/capi/program.c", Link::Static, &sanitized, &[&steel, &waves]);
}

#[test]
fn c_program_prints_bits_of_library() {
    let scenario = root().join("scenarios/steel-on-steel.toml");
    let with_waves = root().join("scenarios/alumina-on-aluminium-with-waves.toml");
    let [printed, shared] =
        [Link::Static, Link::Shared].map(|link| printed("tests/capi/program.c", link, &[], &[&scenario, &with_waves]));
    assert_eq!(printed, shared);

    let scene = Scenario::load(&scenario, &[]).unwrap().resolve().unwrap();
    let contact = scene.contact().unwrap();
    let exact = contact.closed_form(scene.speed()).unwrap();
    let mut expected = vec![
        format!("time {:016x}", exact.row.contact_time.to_bits()),
        format!("restitution {:016x}", exact.row.restitution.to_bits()),
    ];
    expected.extend(along_the_path(&contact));
    let printed: Vec<_> = printed.lines().collect();
    assert_eq!(printed[..expected.len()], expected);
    let waves = Scenario::load(&with_waves, &[]).unwrap().resolve_bodies().unwrap().1.unwrap();
    let waves = waves.closed_form(3.0).unwrap().row.restitution_with_waves().unwrap();
    let bits = [("validated_indentation", contact.validated_indentation()), ("waves", waves)]
        .map(|(name, number)| format!("{name} {:016x}", number.to_bits()));
    // a strength that rises with the rate, at the speed of the scenario
    let rated = ["half_space.rate.johnson_cook.c=0.03".into()];
    let rated = Scenario::load(&scenario, &rated).unwrap().resolve().unwrap().contact().unwrap();
    let impact = rated.closed_form(3.0).unwrap();
    assert!(impact.row.strain_rate_result.unwrap().factor > 1.1);
    let (rated, mut memory) = (rated.at_speed(3.0).unwrap(), Memory::default());
    let forces = [30e-6, 29e-6].map(|indentation| rated.force(indentation, &mut memory));
    let of_rate = hex_words(&[impact.row.contact_time, impact.row.restitution, forces[0], forces[1]]);
    let of_sphere = hex_words(&[contact.sphere().radius, contact.mass(), contact.yield_speed().unwrap()]);
    let balls = [
        "sphere.yield_strength=345e6",
        "half_space.radius=3e-3",
        "half_space.mass=\"ball\"",
        "half_space.density=7850",
    ]
    .map(Into::into);
    let balls = Scenario::load(&scenario, &balls).unwrap().resolve().unwrap().contact().unwrap();
    let of_balls = hex_words(&[balls.closed_form(1.0).unwrap().row.restitution]);
    // the messages of the bad scenarios that the program tried, in its order
    let errors = printed[expected.len()..].join("\n");
    // velocity Verlet with 10 ns, some 2500 steps
    let (_, line) = errors.split_once("\nballs ").unwrap();
    let error: f64 = line.lines().next().unwrap().split(' ').next_back().unwrap().parse().unwrap();
    assert!(error < 2e-6, "{error}");
    for words in [
        "scenario:1:21: sphere.radius: \"-5 mm\"",
        "scenario:3:11: gravity: is not supported in a DEM contact. The simulation adds this force itself. Remove this part.",
        "scenario:3:1: sweep: is not supported in a DEM contact. Remove this table.",
        "no-such-file.toml: cannot be read",
        "\nno scenario: the pointer is NULL\n",
        "\nno scenar\nnan nan nan\nno memory is spoilt\n",
        &format!("\n{}\n{}\n1 1 1\nradii 1 0.005 0.00375\n", bits[0], bits[1]),
        &format!("\nballs {of_balls} 1 1 1 1 "),
        "\norder 1 nothing 1 1 1 1\nno contact: the pointer is NULL\nsphere and half_space have different",
        "\nsphere and half_space have different elastic constants, but both are the same material here.",
        &format!("\nrated {of_rate}\nscenario:2:"),
        "strain-rate keys require impact.speed",
        &format!("\n{}21 frictions fail\nno friction without a contact\n", friction_along_the_path(&contact)),
        &format!(
            "\nsphere {of_sphere}\n1 1 1 of no contact\nthreads agree\nforces 0 1 1 1 1 0\nversion 0.1.0 0.1.0 0\nfingerprints 1 0 1"
        ),
    ] {
        assert!(errors.contains(words), "{words} is not in:\n{errors}");
    }
}
