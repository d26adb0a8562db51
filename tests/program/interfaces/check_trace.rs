//! `plm-impact check-trace`: traces with closed forms, a trace that makes energy, the law beside a trace, and refusals.

use std::fmt::Write as _;

use crate::common::STEEL;
use crate::common::prelude::*;

/// A trace of a contact of 1 g at 2 m/s by this force, in steps of velocity Verlet, with three steps before and after the contact.
fn trace(header: &str, separator: &str, units: [f64; 3], force: impl Fn(f64, f64) -> f64) -> String {
    let (mass, step) = (1e-3, 1e-6);
    let (mut x, mut u, mut t, mut text, mut free) = (-3.5 * 2.0 * step, 2.0, 0.0, format!("{header}\n"), 0);
    let of = |x: f64, u: f64| if x > 0.0 { force(x, u) } else { 0.0 };
    while free < 4 {
        let f = of(x, u);
        let row = [t, x, f].iter().zip(units).map(|(value, unit)| format!("{:.12e}", value / unit)).collect::<Vec<_>>();
        writeln!(text, "{}", row.join(separator)).unwrap();
        let half = u - 0.5 * step * f / mass;
        x += step * half;
        u = half - 0.5 * step * of(x, half) / mass;
        t += step;
        free += usize::from(x <= 0.0 && u < 0.0);
    }
    text
}

/// k of a spring whose half period is 200 steps.
const STIFFNESS: f64 = 1e-3 * (std::f64::consts::PI / 200e-6) * (std::f64::consts::PI / 200e-6);

/// e and contact time of a damped spring that separates where δ = 0 (e = exp(−π ζ/√(1 − ζ²))), which pulls at its end.
#[test]
fn damped_spring_has_closed_form_restitution() {
    let ratio = 0.2_f64;
    let damping = 2.0 * ratio * (STIFFNESS * 1e-3).sqrt();
    let text = trace("t,delta,F", ",", [1.0; 3], |x, u| STIFFNESS * x + damping * u);
    let desk = Sandbox::with(STEEL);
    desk.write("contact.csv", text);
    let (out, errors) = desk.run_expecting(&["check-trace", "contact.csv", "--mass", "1 g", "--json"], 0);
    let value: Value = serde_json::from_str(&out).unwrap();
    let number = |name: &str| value["trace"][name].as_f64().unwrap();
    let root = (1.0 - ratio * ratio).sqrt();
    let e = (-std::f64::consts::PI * ratio / root).exp();
    assert_relative_eq!(number("restitution"), e, max_relative = 5e-3);
    assert_relative_eq!(number("restitution_by_work"), e, max_relative = 5e-3);
    assert_relative_eq!(number("contact_time_s"), 200e-6 / root, max_relative = 1e-2);
    assert_relative_eq!(number("speed_m_per_s"), 2.0, max_relative = 1e-9);
    assert!(number("largest_pull_N") > 0.0 && errors.contains("the force pulls in"), "{errors}");
    assert!(errors.contains("the names of `t`, `delta`, `F` have no unit: SI is assumed"), "{errors}");
    assert!(value["law"].is_null() && value["trace"]["made_energy"] == false);
}

/// An undamped spring has e = 1 and makes no energy; its columns stand between spaces as LAMMPS writes them, in other units.
#[test]
fn elastic_spring_between_spaces_has_unit_restitution() {
    let header = "# fix print\n# v_time_ms v_delta_um v_fz_kN";
    let text = trace(header, "  ", [1e-3, 1e-6, 1e3], |x, _| STIFFNESS * x);
    let desk = Sandbox::with(STEEL);
    desk.write("contact.txt", text);
    let (out, errors) = desk.run_expecting(&["check-trace", "contact.txt", "--json"], 0);
    let value: Value = serde_json::from_str(&out).unwrap();
    assert_relative_eq!(value["trace"]["restitution"].as_f64().unwrap(), 1.0, max_relative = 1e-3);
    let peak = 2.0 * (STIFFNESS * 1e-3).sqrt();
    assert_relative_eq!(value["trace"]["peak_force_N"].as_f64().unwrap(), peak, max_relative = 1e-3);
    assert_eq!(value["warnings"], json!([]), "{errors}");
    assert!(!errors.contains("SI is assumed"), "{errors}");
}

/// A spring that is stiffer while it unloads: e² = 1.2, and a fifth of the work of loading comes from nothing.
#[test]
fn contact_that_makes_energy_fails() {
    let text =
        trace(
            "time_s,indentation_m,force_N",
            ",",
            [1.0; 3],
            |x, u| if u < 0.0 { 1.2 * STIFFNESS * x } else { STIFFNESS * x },
        );
    let desk = Sandbox::with(STEEL);
    desk.write("contact.csv", text);
    let (out, errors) = desk.run_expecting(&["check-trace", "contact.csv", "--pictures", "none"], 1);
    assert!(errors.contains("the contact creates energy") && out.contains("1.095"), "{out} {errors}");
    assert!(!desk.path("plots").exists());
}

/// Traces of LAMMPS (tests/lammps/trace.in, 22 Jul 2025): e of `hooke` and `hertz/material` is the 0.5 of their input, less 0.7 % of the
/// time step. A spring without damping in eleven steps makes energy: the last two lines of the file give 1.00878.
#[test]
fn traces_of_lammps_have_their_restitution() {
    let desk = Sandbox::with(STEEL);
    let check = |name: &str, code: i32| {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/reference/lammps_{name}.txt"));
        let (out, _) = desk
            .run_expecting(&["check-trace", &file.to_string_lossy(), "s.toml", "--json", "--pictures", "none"], code);
        let value: Value = serde_json::from_str(&out).unwrap();
        value["trace"]["restitution"].as_f64().unwrap()
    };
    assert_relative_eq!(check("hooke", 0), 0.5, max_relative = 0.02);
    assert_relative_eq!(check("hertz", 0), 0.5, max_relative = 0.02);
    assert_relative_eq!(check("coarse", 1), 1.00878, max_relative = 1e-5);
}

/// A contact that begins with an overlap, as of inserted bodies, and one with few steps.
#[test]
fn overlap_and_few_steps_warn() {
    let rows = [
        "0,0,0",
        "1e-6,1e-6,0",
        "2e-6,2e-5,20",
        "3e-6,2.1e-5,21",
        "4e-6,2e-5,18",
        "5e-6,1.9e-5,15",
        "6e-6,0,0",
        "7e-6,-1e-6,0",
    ];
    let desk = Sandbox::with(STEEL);
    desk.write("contact.csv", format!("t,delta,F\n{}\n", rows.join("\n")));
    let (_, errors) = desk.run_expecting(&["check-trace", "contact.csv", "--pictures", "none"], 0);
    for words in ["the first overlap is 20", "the contact has 4 steps", "the force jumps by"] {
        assert!(errors.contains(words), "{words}: {errors}");
    }
}

/// The law itself, in steps of another program: e, time, force and depth are those of the scenario, and the picture has both loops.
#[test]
fn trace_of_law_agrees_with_scenario() {
    let contact = contact(STEEL, NO_OVERRIDES);
    let (mass, step) = (contact.mass(), 2e-8);
    let (mut x, mut u, mut t, mut text, mut free) =
        (-2.5 * 3.0 * step, 3.0, 0.0, "time_s,indentation_m,force_N\n".to_owned(), 0);
    let mut memory = Memory::default();
    let mut force = 0.0;
    while free < 4 {
        writeln!(text, "{t:.12e},{x:.15e},{force:.15e}").unwrap();
        u -= 0.5 * step * force / mass;
        x += step * u;
        t += step;
        force = contact.force(x, &mut memory);
        u -= 0.5 * step * force / mass;
        free += usize::from(force == 0.0 && u < 0.0);
    }
    let desk = Sandbox::with(STEEL);
    desk.write("contact.csv", text);
    let (out, _) =
        desk.run_expecting(&["check-trace", "contact.csv", "s.toml", "--json", "--pictures", "svg", "--out", "new"], 0);
    let value: Value = serde_json::from_str(&out).unwrap();
    for name in ["restitution", "contact_time_s", "peak_force_N", "peak_indentation_m"] {
        let [trace, law] = ["trace", "law"].map(|side| value[side][name].as_f64().unwrap());
        assert_relative_eq!(trace, law, max_relative = 2e-3);
    }
    assert_relative_eq!(
        value["trace"]["restitution_by_work"].as_f64().unwrap(),
        value["law"]["restitution"].as_f64().unwrap(),
        max_relative = 2e-3
    );
    let picture = fs::read_to_string(desk.path("new/contact_trace.svg")).unwrap();
    assert!(picture.contains("Law") && picture.contains("One contact of contact"), "{picture}");
    let (out, _) = desk.run_expecting(&["check-trace", "contact.csv", "s.toml", "--pictures", "none"], 0);
    assert!(out.contains("trace/law") && out.contains("restitution by work and mass"), "{out}");
}

/// Each bad trace, with the words of its refusal.
#[test]
fn bad_traces_are_refused() {
    let contact = "0,0,0\n1,1,0\n2,2,5\n3,3,9\n4,3,9\n5,2,5\n6,1,1\n7,0,0\n8,-1,0\n";
    let twice = format!("{contact}9,1,0\n10,2,5\n11,3,5\n12,0,0\n");
    let cases: [(&str, String, &str); 9] = [
        ("t,delta,F", "0,0,0\n1,x,0\n".into(), "contact.csv:3: column 2, `delta`: \"x\" is not a number"),
        ("t,delta,F", "0,0,0\n0,1,0\n".into(), "contact.csv:3: the time 0e0 s is not later than"),
        ("t,delta", "0,0\n".into(), "no column is the force. Name one column force_N"),
        ("t,delta_s,F", "0,0,0\n".into(), "the column `delta_s` ends in `s`, which is not a unit of"),
        ("t,delta,overlap,F", "0,0,0,0\n".into(), "more than one column is the indentation"),
        ("t,delta,F", "0,0,0\n1,1,0\n".into(), "contains no step with a force"),
        ("t,delta,F", twice, "has 2 contacts: lines 4 to 8, lines 12 to 13"),
        ("t,delta,F", "2,2,5\n3,3,9\n4,3,9\n5,2,5\n6,1,1\n7,0,0\n".into(), "the file begins inside of the contact"),
        (
            "t,delta,F",
            "0,0,0\n1,1,2\n2,0,0\n".into(),
            "the contact has 1 steps with a force, and at least 4 are needed",
        ),
    ];
    for (header, rows, words) in cases {
        let desk = Sandbox::with(STEEL);
        desk.write("contact.csv", format!("{header}\n{rows}"));
        let (_, message) = desk.run_expecting(&["check-trace", "contact.csv"], 2);
        assert!(message.contains(words) && !desk.path("plots").exists(), "{words}: {message}");
    }
    let desk = Sandbox::with(STEEL);
    desk.write("contact.csv", format!("t,delta,F\n{contact}"));
    let (_, message) = desk.run_expecting(&["check-trace", "contact.csv", "--mass", "-1 g"], 2);
    assert!(message.contains("--mass"), "{message}");
    desk.run_expecting(&["check-trace", "none.csv"], 2);
}
