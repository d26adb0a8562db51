//! `plm-impact export`: the springs, when integrated, have the e and the contact time of the law; tables are those of
//! the closed form; scenes that cannot be exported are refused. Runs in LAMMPS and LIGGGHTS are in tests/lammps.

use std::path::Path;
use std::process::Output;

use assert_cmd::Command;
use plm_impact::export::{E_WITHIN, Equal, Springs, Target, range_of_constant, spring_without_pull};
use plm_impact::impact::Contact;
use plm_impact::scenario::Scenario;

const STEEL: &str = "scenarios/steel-on-steel.toml";

fn export(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Command::cargo_bin("plm-impact").unwrap().current_dir(root).arg("export").args(arguments).output().unwrap()
}

fn printed(arguments: &[&str]) -> String {
    let output = export(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn steel() -> Contact {
    Scenario::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join(STEEL), &[])
        .unwrap()
        .resolve()
        .unwrap()
        .contact()
        .unwrap()
}

/// e, contact time and peak force of a force law F(δ, δ', δ_max), integrated in steps of a millionth of `time`. The
/// contact ends when `is_over` is true for δ and the force.
fn integrated(
    (mass, speed, time): (f64, f64, f64),
    force: impl Fn(f64, f64, f64) -> f64,
    is_over: impl Fn(f64, f64) -> bool,
) -> (f64, f64, f64) {
    let step = 1e-6 * time;
    let (mut x, mut v, mut t, mut deepest, mut largest) = (0.0_f64, speed, 0.0, 0.0_f64, 0.0_f64);
    loop {
        let half = v - 0.5 * step * force(x, v, deepest) / mass;
        x += step * half;
        deepest = deepest.max(x);
        let pushed = force(x, half, deepest);
        largest = largest.max(pushed);
        v = half - 0.5 * step * pushed / mass;
        t += step;
        if v < 0.0 && is_over(x, pushed) {
            return (-v / speed, t, largest);
        }
    }
}

#[test]
fn the_springs_rebound_as_the_law_does() {
    let contact = steel();
    for speed in [0.05, 3.0, 20.0] {
        let impact = contact.closed_form(speed).unwrap();
        let (m, e) = (contact.mass(), impact.restitution);
        for equal in [Equal::ContactTime, Equal::PeakForce] {
            let Springs { damped, loading, unloading } = Springs::of(&contact, &impact, equal);
            // damping of a linear spring with this e, from the logarithmic decrement; the contact ends with the overlap
            let share = -e.ln() / (std::f64::consts::PI.powi(2) + e.ln().powi(2)).sqrt();
            let damping = 2.0 * share * (m * damped).sqrt();
            // such a spring pulls before separation: only the end of the overlap counts
            let spring = |x: f64, v: f64, _: f64| damped * x + damping * v;
            let of_impact = (m, speed, impact.contact_time);
            let (rebound, lasted, _) = integrated(of_impact, spring, |x, _| x <= 0.0);
            assert!((rebound / e - 1.0).abs() < 1e-4, "{speed}: e {rebound}, {e}");
            assert!((lasted / impact.contact_time - 1.0).abs() < 1e-4, "{speed}: {lasted}");

            let (stiffness, damping) = spring_without_pull(m, e, impact.contact_time).unwrap();
            let spring = |x: f64, v: f64, _: f64| (stiffness * x + damping * v).max(0.0);
            let (rebound, lasted, _) = integrated(of_impact, spring, |_, pushed| pushed <= 0.0);
            assert!((rebound / e - 1.0).abs() < 1e-4, "{speed}: e {rebound}, {e}");
            assert!((lasted / impact.contact_time - 1.0).abs() < 1e-4, "{speed}: {lasted}");

            let springs = |x: f64, _: f64, deepest: f64| {
                (loading * x).min(unloading * (x - deepest * (1.0 - loading / unloading))).max(0.0)
            };
            let (rebound, lasted, largest) = integrated(of_impact, springs, |_, pushed| pushed <= 0.0);
            assert!((rebound / e - 1.0).abs() < 1e-4, "{speed}: e {rebound}, {e}");
            match equal {
                Equal::ContactTime => assert!((lasted / impact.contact_time - 1.0).abs() < 1e-4, "{speed}: {lasted}"),
                Equal::PeakForce => assert!((largest / impact.peak_force - 1.0).abs() < 1e-4, "{speed}: {largest}"),
            }
        }
    }
}

#[test]
fn a_constant_e_says_how_far_it_holds() {
    let contact = steel();
    let e = |speed| contact.closed_form(speed).unwrap().restitution;
    let (from, to) = range_of_constant(&contact, 3.0, e(3.0));
    for (end, beyond) in [(from, 0.999 * from), (to, 1.001 * to)] {
        assert!((e(end) / e(3.0) - 1.0).abs() <= E_WITHIN * (1.0 + 1e-9));
        assert!((e(beyond) / e(3.0) - 1.0).abs() > E_WITHIN);
    }
    assert!(printed(&[STEEL, "--to", "lammps"]).contains(&format!("from {from:.4} to {to:.4} m/s")));
}

#[test]
fn tables_are_those_of_the_closed_form() {
    let contact = steel();
    for (target, between) in [("csv", ","), ("acusolve", ", ")] {
        let text = printed(&[STEEL, "--to", target, "--speeds", "0.1 m/s,10 m/s"]);
        let rows: Vec<(f64, f64)> = text
            .lines()
            .filter_map(|line| {
                let (speed, e) = line.trim_end_matches(" ;").split_once(between)?;
                Some((speed.parse().ok()?, e.parse().ok()?))
            })
            .collect();
        assert_eq!(rows.len(), 41, "{text}");
        assert!((rows[0].0 - 0.1).abs() < 1e-15 && (rows[40].0 - 10.0).abs() < 1e-12);
        for (speed, e) in rows {
            assert!((e - contact.closed_form(speed).unwrap().restitution).abs() < 1e-9, "{target}: {speed}");
        }
    }
}

#[test]
fn every_code_gets_its_lines_with_their_origin() {
    for (name, target) in Target::ALL {
        let text = printed(&[STEEL, "--to", name, "--set", "law=thornton"]);
        assert!(text.contains("plm-impact 0.1.0: plm-impact export") && text.contains("--set law=thornton"), "{text}");
        assert!(text.contains("SHA-256") && text.contains("impact at 3 m/s: e "), "{text}");
        let is_run = !matches!(target, Target::Mercury | Target::Acusolve | Target::Fluent);
        assert_eq!(!text.contains("were not run in that code"), is_run, "{text}");
    }
}

#[test]
fn what_cannot_be_exported_is_refused() {
    for (arguments, words) in [
        (&["scenarios/damped-impact.toml", "--to", "csv"][..], "gravity: is not a part of the contact law"),
        (&[STEEL, "--to", "lammps", "--speeds", "1 m/s,2 m/s"], "takes one constant e"),
        (&[STEEL, "--to", "csv", "--speeds", "2 m/s,1 m/s"], "is not below the last"),
        (&[STEEL, "--to", "csv", "--speeds", "2 m/s"], "is not two speeds"),
        (&[STEEL, "--to", "lammps", "--speed", "-2 m/s"], "must be > 0 m/s"),
        (&[STEEL, "--to", "lammps", "--speed", "2 kg"], "--speed"),
        (&[STEEL, "--to", "edem"], "possible values"),
        (&["no-such-file.toml", "--to", "csv"], "cannot be read"),
    ] {
        let output = export(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(words) && output.stdout.is_empty(), "{arguments:?}: {error}");
    }
}
