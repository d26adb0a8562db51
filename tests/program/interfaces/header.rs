//! `plm-impact export --to header`: every build of the header reproduces its vectors, the vectors are those of the library, and an
//! impact with the header has the e of the closed form. Without a compiler these tests are skipped, with a message.

use std::process::{Command, Output};

use crate::common::STEEL;
use crate::common::prelude::*;
use plm_impact::report::run::contact_at_scenario_speed;

/// Bodies and laws that the header must have: overrides of a steel ball on steel.
const PAIRS: [(&str, &[&str]); 9] = [
    ("paper", &[]),
    ("pressure_shape", &["law.plm.unloading_exponent=pressure-shape"]),
    ("exponent", &["law.plm.unloading_exponent=1.8"]),
    ("sphere_yields", &["sphere.yield_strength=200 MPa", "half_space.yield_strength=900 MPa"]),
    ("both_yield", &["sphere.yield_strength=345 MPa"]),
    ("hardening", &["half_space.flow_stress.power.exponent=0.2", "law.plm.unloading_exponent=pressure-shape"]),
    ("rate", &["half_space.rate.johnson_cook.c=0.03", "law.plm.unloading_exponent=pressure-shape"]),
    ("elastic", &["law=hertz"]),
    // yields before the yield indentation of the pair
    ("thornton", &["law=thornton", "law.thornton.yield_pressure=300 MPa"]),
];

/// Writes header, vectors and test program of these overrides.
fn header(name: &str, set: &[&str]) -> Sandbox {
    let desk = Sandbox::with(STEEL);
    desk.write(&format!("{name}.toml"), STEEL);
    let sets: Vec<&str> = set.iter().flat_map(|key| ["--set", key]).collect();
    let file = format!("{name}.toml");
    desk.run_expecting(&[&["export", &file, "--to", "header"][..], &sets].concat(), 0);
    desk
}

/// Compiles a program and runs it with this argument; `None` without this compiler.
fn run_compiled(desk: &Sandbox, compiler: &str, flags: &[&str], source: &str, argument: &str) -> Option<Output> {
    let program = desk.path("program");
    let warned = ["-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"];
    let build = Command::new(compiler)
        .current_dir(desk.path(""))
        .args(warned)
        .args(flags)
        .args([source, "-lm", "-o"])
        .arg(&program)
        .output();
    let Ok(build) = build else {
        println!("skipped: no compiler {compiler}");
        return None;
    };
    assert!(build.status.success(), "{compiler} {flags:?}: {}", String::from_utf8_lossy(&build.stderr));
    Some(Command::new(&program).current_dir(desk.path("")).arg(argument).output().unwrap())
}

/// The test program of the header ends with success, and its largest deviation is below this.
fn assert_proved(desk: &Sandbox, name: &str, compiler: &str, flags: &[&str], limit: f64) {
    let (source, vectors) = (format!("plm_{name}_test.c"), format!("plm_{name}_vectors.csv"));
    let Some(output) = run_compiled(desk, compiler, flags, &source, &vectors) else { return };
    let text = String::from_utf8(output.stdout).unwrap();
    let largest: f64 = text.trim().rsplit(' ').next().unwrap().parse().unwrap();
    assert!(
        output.status.success() && text.starts_with("1000 states") && largest < limit,
        "{name} {compiler} {flags:?}: {text}"
    );
}

#[test]
fn header_in_c_reproduces_its_vectors() {
    for (name, set) in PAIRS {
        assert_proved(&header(name, set), name, "cc", &["-std=c99"], 1e-13);
    }
}

#[test]
fn header_in_cpp_and_float_reproduces_its_vectors() {
    for (name, set) in [PAIRS[1], PAIRS[6]] {
        let desk = header(name, set);
        assert_proved(&desk, name, "c++", &["-x", "c++", "-std=c++11"], 1e-13);
        assert_proved(&desk, name, "clang", &["-std=c99"], 1e-13);
        assert_proved(&desk, name, "cc", &["-std=c99", "-DPLM_REAL=float"], 1e-5);
    }
}

/// A digit of the force is changed: the test program must find it.
#[test]
fn test_program_finds_changed_digit() {
    let desk = header("changed", &[]);
    let path = desk.path("plm_changed.h");
    let text = fs::read_to_string(&path).unwrap();
    let line = text.lines().find(|line| line.contains("_FORCE ((PLM_REAL)")).unwrap();
    let digits = line.split("PLM_REAL)").nth(1).unwrap().split(')').next().unwrap();
    let changed = format!("{:e}", digits.parse::<f64>().unwrap() * (1.0 + 1e-11));
    fs::write(&path, text.replace(digits, &changed)).unwrap();
    if let Some(output) = run_compiled(&desk, "cc", &[], "plm_changed_test.c", "plm_changed_vectors.csv") {
        assert_eq!(output.status.code(), Some(1));
    }
}

/// The vectors, replayed with the library, which tests/capi.rs compares with the C functions bit by bit.
#[test]
fn vectors_are_forces_of_library() {
    for (name, set) in PAIRS {
        let desk = header(name, set);
        let (_, contact) = contact_at_scenario_speed(&read(STEEL, set)).unwrap();
        let (mut memory, mut n) = (Memory::default(), 0);
        for line in fs::read_to_string(desk.path(&format!("plm_{name}_vectors.csv"))).unwrap().lines().skip(2) {
            let row: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
            let force = contact.force(row[0], &mut memory);
            let scale = memory.force.max(force);
            assert!((force - row[1]).abs() <= 1e-14 * scale, "{name} {line}");
            assert!((memory.elastic_approach - row[4]).abs() <= 1e-14 * memory.indentation, "{name} {line}");
            if row[0] <= 0.0 {
                memory = Memory::default();
            }
            n += 1;
        }
        assert_eq!(n, 1000, "{name}");
    }
}

/// Velocity Verlet, as in src/interfaces/c/drop.c, with the force of the header alone.
const IMPACT: &str = r#"
#include <stdio.h>
#include <stdlib.h>
#include "plm_NAME.h"
int main(int argc, char **argv) {
    plm_NAME_memory memory = {0, 0, 0};
    const double step = atof(argv[argc - 1]), speed = 3.0;
    double indentation = 0.0, velocity = speed, force = 0.0;
    do {
        velocity -= 0.5 * step * force / PLM_TITLE_MASS;
        indentation += step * velocity;
        force = plm_NAME_force(indentation, &memory);
        velocity -= 0.5 * step * force / PLM_TITLE_MASS;
    } while (indentation > 0.0);
    printf("%.12f\n", -velocity / speed);
    return 0;
}
"#;

/// The method is of second order: a tenth of the step has a hundredth of the error, but for what the first and the last step leave.
#[test]
fn impact_with_header_has_restitution_of_closed_form() {
    for (name, set) in [PAIRS[0], PAIRS[4], PAIRS[5]] {
        let desk = header(name, set);
        let title = name.to_uppercase();
        desk.write("impact.c", IMPACT.replace("NAME", name).replace("TITLE", &title));
        let exact = contact(STEEL, set).closed_form(3.0).unwrap().row.restitution;
        let error = |step: &str| {
            let output = run_compiled(&desk, "cc", &[], "impact.c", step)?;
            let e: f64 = String::from_utf8(output.stdout).unwrap().trim().parse().unwrap();
            Some((e / exact - 1.0).abs())
        };
        let (Some(coarse), Some(fine)) = (error("1e-7"), error("1e-8")) else { return };
        assert!(coarse < 1e-4 && fine < 0.2 * coarse && fine < 2e-6, "{name}: {coarse} {fine}");
    }
}

/// Laws without a table, and options that a header has not, are refused by name, and nothing is written.
#[test]
fn what_header_lacks_is_refused_by_name() {
    let ways: [(&[&str], &str); 7] = [
        (
            &["--set", "law=walton_braun"],
            "the law walton_braun cannot be a header, because its loading does not begin with Hertz's law",
        ),
        (&["--set", "law=yigit_christoforou"], "because its unloading curve is not a power of the distance"),
        (&["--set", "damping.viscous=0.1"], "is not supported in a DEM contact"),
        (
            &["--set", "half_space.density=7850", "--set", "half_space.rod_diameter=20 mm"],
            "half_space.rod_diameter: is not supported in a DEM contact",
        ),
        (
            &["--set", "half_space.density=7850", "--set", "half_space.thickness=20 mm"],
            "The simulation moves the plate itself",
        ),
        (&["--speed", "3 m/s"], "--speed: a header does not depend on a speed"),
        (&["--speeds", "1 m/s,3 m/s"], "--speeds: a header does not depend"),
    ];
    for (more, words) in ways {
        let desk = Sandbox::with(STEEL);
        let (_, message) =
            desk.run_expecting(&[&["export", "s.toml", "--to", "header", "--out", "new"], more].concat(), 2);
        assert!(message.contains(words) && !desk.path("new").exists(), "{message}");
    }
    let desk = Sandbox::with(STEEL);
    let (_, message) = desk.run_expecting(&["export", "s.toml", "--to", "lammps", "--out", "new"], 2);
    assert!(message.contains("--to lammps prints its lines"), "{message}");
}

/// A second export replaces its own files; a file of somebody else stays, and so do the other files.
#[test]
fn export_replaces_its_own_files_only() {
    let desk = Sandbox::with(STEEL);
    let arguments = ["export", "s.toml", "--to", "header", "--out", "new"];
    desk.run_expecting(&arguments, 0);
    desk.run_expecting(&arguments, 0);
    fs::remove_file(desk.path("new/plm_s.h")).unwrap();
    desk.write("new/plm_s_test.c", "int mine;\n");
    let (_, message) = desk.run_expecting(&arguments, 2);
    assert!(message.contains("plm_s_test.c: already exists and was not written by this program"), "{message}");
    assert!(!desk.path("new/plm_s.h").exists());
}

/// The origin is in the header, with the range and the licence.
#[test]
fn header_names_its_origin_and_range() {
    let desk = header("paper", &[]);
    let text = fs::read_to_string(desk.path("plm_paper.h")).unwrap();
    for words in [
        "SPDX-License-Identifier: MIT",
        "SHA-256",
        "export paper.toml --to header",
        "Validated up to",
        "half_space.yield_strength = ",
    ] {
        assert!(text.contains(words), "{words}");
    }
    assert!(!text.contains('{') || !text.contains("{name}"), "a place of the template is left");
}

/// A contact whose metal does not relax pays for no field and no line of the relaxation.
#[test]
fn only_header_with_rate_relaxes() {
    for (name, set) in PAIRS {
        let text = header(name, set).read(&format!("plm_{name}.h"));
        assert_eq!(text.contains("relaxes") || text.contains("branch_peak"), name == "rate", "{name}");
    }
}
