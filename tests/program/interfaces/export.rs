//! `plm-impact export`: the springs, when integrated, have the e and the contact time of the law; tables are those of
//! the closed form; scenes that cannot be exported are refused. Runs in LAMMPS are in tests/lammps.

use std::process::Output;

use crate::common::prelude::*;
use plm_impact::interfaces::export::{
    MAX_RESTITUTION_ERROR, TargetCode, constant_restitution_range, damped_spring, non_cohesive_spring,
    steps_per_contact,
};

const STEEL: &str = "scenarios/steel-on-steel.toml";

fn export(arguments: &[&str]) -> Output {
    run_in(Path::new(env!("CARGO_MANIFEST_DIR")), &[&["export"], arguments].concat())
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

/// e and contact time of a force law F(δ, δ'), integrated in steps of a millionth of `time`. The contact ends when
/// `is_over` is true for δ and the force.
fn integrated(
    (mass, speed, time): (f64, f64, f64),
    force: impl Fn(f64, f64) -> f64,
    is_over: impl Fn(f64, f64) -> bool,
) -> (f64, f64) {
    let step = 1e-6 * time;
    let (mut x, mut v, mut t) = (0.0_f64, speed, 0.0);
    loop {
        let half = v - 0.5 * step * force(x, v) / mass;
        x += step * half;
        let pushed = force(x, half);
        v = half - 0.5 * step * pushed / mass;
        t += step;
        if v < 0.0 && is_over(x, pushed) {
            return (-v / speed, t);
        }
    }
}

#[test]
fn the_springs_rebound_as_the_law_does() {
    let contact = steel();
    for speed in [0.05, 3.0, 20.0] {
        let impact = contact.closed_form(speed).unwrap();
        let (m, e, time) = (contact.mass(), impact.row.restitution, impact.row.contact_time);
        let near = |rebound: f64, lasted: f64| {
            assert!((rebound / e - 1.0).abs() < 1e-4, "{speed}: e {rebound}, {e}");
            assert!((lasted / time - 1.0).abs() < 1e-4, "{speed}: {lasted}");
        };
        let stiffness = damped_spring(m, e, time);
        let damping = damping(m, stiffness, e);
        // such a spring pulls before separation: only the end of the overlap counts
        let spring = |x: f64, v: f64| stiffness * x + damping * v;
        let (rebound, lasted) = integrated((m, speed, time), spring, |x, _| x <= 0.0);
        near(rebound, lasted);

        let (stiffness, damping) = non_cohesive_spring(m, e, time).unwrap();
        let spring = |x: f64, v: f64| (stiffness * x + damping * v).max(0.0);
        let (rebound, lasted) = integrated((m, speed, time), spring, |_, pushed| pushed <= 0.0);
        near(rebound, lasted);
    }
}

/// The number in a line after these words.
fn number_after(text: &str, words: &str) -> f64 {
    let rest = text.split_once(words).unwrap_or_else(|| panic!("{words} is not in\n{text}")).1;
    rest.split(|c: char| c == ',' || c == ')' || c.is_whitespace()).next().unwrap().parse().unwrap()
}

/// The springs that LIGGGHTS and Yade make of their lines, by the formulas of their manuals: a ball on a wall has the e and the contact
/// time that the head of the lines states.
///
/// LIGGGHTS, `model hooke`: k = (16/15) √R Y* (15 m V²/(16 √R Y*))^(1/5), with the damping of a linear spring for e; the wall has
/// the material of the sphere, and the contact ends with the overlap. Yade, `ViscElMat` on `ViscElMat`: springs and dashpots in series,
/// so half of kn and cn, and a force that never pulls.
#[test]
fn lines_of_liggghts_and_yade_rebound_as_stated() {
    let (mass, radius) = (steel().mass(), 5e-3_f64);
    for speed in [0.1, 3.0] {
        let lines = |code: &str| printed(&[STEEL, "--to", code, "--speed", &format!("{speed} m/s")]);
        let (liggghts, yade) = (lines("liggghts"), lines("yade"));
        let near = |text: &str, (rebound, lasted): (f64, f64)| {
            let stated = [number_after(text, "m/s: e "), number_after(text, "contact time ")];
            assert!((rebound / stated[0] - 1.0).abs() < 1e-3, "{speed}: e {rebound}, {stated:?}");
            assert!((lasted / stated[1] - 1.0).abs() < 1e-3, "{speed}: {lasted} s, {stated:?}");
        };
        let poissons_ratio = number_after(&liggghts, "poissonsRatio peratomtype ");
        let modulus = number_after(&liggghts, "youngsModulus peratomtype ") / (2.0 * (1.0 - poissons_ratio.powi(2)));
        let factor = 16.0 / 15.0 * radius.sqrt() * modulus;
        let of_speed = number_after(&liggghts, "characteristicVelocity scalar ");
        let stiffness = factor * (mass * of_speed * of_speed / factor).powf(0.2);
        let damping = damping(mass, stiffness, number_after(&liggghts, "coefficientRestitution peratomtypepair 1 "));
        let spring = |x: f64, v: f64| stiffness * x + damping * v;
        let time = number_after(&liggghts, "contact time ");
        near(&liggghts, integrated((mass, speed, time), spring, |x, _| x <= 0.0));

        let [stiffness, damping] = ["kn=", "cn="].map(|name| 0.5 * number_after(&yade, name));
        let spring = |x: f64, v: f64| (stiffness * x + damping * v).max(0.0);
        near(&yade, integrated((mass, speed, time), spring, |_, pushed| pushed <= 0.0));
    }
}

/// Damping of a linear spring with this e, from the logarithmic decrement; the contact ends with the overlap.
pub(super) fn damping(mass: f64, stiffness: f64, e: f64) -> f64 {
    let share = -e.ln() / (std::f64::consts::PI.powi(2) + e.ln().powi(2)).sqrt();
    2.0 * share * (mass * stiffness).sqrt()
}

/// The wall of LAMMPS as its code takes steps: velocity Verlet, with the damping of the speed half a step before, and no
/// force where there is no overlap. With 200 steps a contact this gives what LAMMPS gave over the phases of the first
/// step: e 0.492 -0.4 to +0.3 %, 0.316 -1.0 to +0.2 %, 0.159 -2.3 to 0 %.
fn stepped(e: f64, steps: f64, phase: f64) -> f64 {
    let (stiffness, step) = (damped_spring(1.0, e, 1.0), 1.0 / steps);
    let damping = damping(1.0, stiffness, e);
    let (mut x, mut v, mut a) = (-phase * step, 1.0, 0.0);
    loop {
        let half: f64 = v + 0.5 * step * a;
        x += step * half;
        a = if x > 0.0 { -(stiffness * x + damping * half) } else { 0.0 };
        v = half + 0.5 * step * a;
        if x <= 0.0 && v < 0.0 {
            return -v;
        }
    }
}

#[test]
fn time_step_keeps_restitution_within_one_percent() {
    let off = |e: f64, steps: f64| {
        let errors = (0..40).map(|i| stepped(e, steps, (f64::from(i) + 0.5) / 40.0) / e - 1.0);
        errors.fold((0.0_f64, 0.0_f64), |(low, high), error| (low.min(error), high.max(error)))
    };
    // what LAMMPS gave with 200 steps
    for (e, low, high) in [(0.4925, -0.0038, 0.0034), (0.3161, -0.0091, 0.0025), (0.1588, -0.0229, 0.0)] {
        let (least, most) = off(e, 200.0);
        assert!((least - low).abs() < 1e-3 && (most - high).abs() < 1e-3, "{e}: {least} {most}");
    }
    for e in [0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.85, 0.95] {
        let steps = steps_per_contact(e);
        let (least, most) = off(e, steps);
        assert!(least > -0.01 && most < 0.01, "{e}, {steps} steps: {least} {most}");
    }
    // the text says the number of steps, and the time step is that of the line
    let text = printed(&[STEEL, "--to", "lammps", "--set", "law=thornton", "--speed", "30 m/s"]);
    assert!(text.contains("610 steps per contact, error of e below 1 %"), "{text}");
}

#[test]
fn constant_e_has_its_speed_range() {
    let contact = steel();
    let e = |speed| contact.closed_form(speed).unwrap().row.restitution;
    let [from, to] = constant_restitution_range(&contact, 3.0, e(3.0)).map(Option::unwrap);
    for (end, beyond) in [(from, 0.999 * from), (to, 1.001 * to)] {
        assert!((e(end) / e(3.0) - 1.0).abs() <= MAX_RESTITUTION_ERROR * (1.0 + 1e-9));
        assert!((e(beyond) / e(3.0) - 1.0).abs() > MAX_RESTITUTION_ERROR);
    }
    let [from, to] = [from, to].map(plm_impact::units::format_four_digits);
    assert!(printed(&[STEEL, "--to", "lammps"]).contains(&format!("from {from} to {to} m/s")));
    // below first yield, at 9.667 mm/s, e is 1 at every speed: the range has no lower end. At 1 µm/s, 1000 times the speed is
    // elastic too
    let slow = |speed| printed(&[STEEL, "--to", "lammps", "--speed", speed]);
    assert!(
        slow("1 mm/s").contains("by less than 2 % up to 0.0") && !slow("1 mm/s").contains("0.0000"),
        "{}",
        slow("1 mm/s")
    );
    assert!(slow("1 um/s").contains("by less than 2 % at all speeds near this one"), "{}", slow("1 um/s"));
}

/// A fall of v²/(2 g), and e² of it on the way up.
#[test]
fn header_has_numbers_of_drop_test() {
    let impact = steel().closed_form(3.0).unwrap();
    let text = printed(&[STEEL, "--to", "yade", "--speed", "3 m/s"]);
    let line = text.lines().find(|line| line.contains("dent diameter")).unwrap();
    let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
    let fall = 4.5 / 9.80665;
    let want = [2.0 * impact.row.peak_contact_radius, impact.row.restitution * impact.row.restitution * fall, fall];
    assert!(numbers.iter().zip(want).all(|(got, want)| (got / want - 1.0).abs() < 1e-6), "{line} {want:?}");
    assert_eq!(numbers.len(), 3, "{line}");
}

#[test]
fn tables_are_those_of_the_closed_form() {
    let contact = steel();
    let text = printed(&[STEEL, "--to", "csv", "--speeds", "0.1 m/s,10 m/s"]);
    let row = |line: &str| line.split_once(',').and_then(|(speed, e)| Some((speed.parse().ok()?, e.parse().ok()?)));
    let rows: Vec<(f64, f64)> = text.lines().filter_map(row).collect();
    assert_eq!(rows.len(), 41, "{text}");
    assert_eq!((rows[0].0, rows[40].0), (0.1, 10.0));
    for (speed, e) in rows {
        assert!((e - contact.closed_form(speed).unwrap().row.restitution).abs() < 1e-9, "{speed}");
    }
    // a tenth to ten times the 3 m/s of the scenario
    let text = printed(&[STEEL, "--to", "csv"]);
    assert!(text.contains("\n3e-1,") && text.contains("\n3e1,"), "{text}");
}

#[test]
fn every_code_gets_its_lines_with_their_origin() {
    for (name, target) in TargetCode::ALL.map(|target| (target.name(), target)) {
        let text = printed(&[STEEL, "--to", name, "--set", "law=thornton"]);
        // a comment of XML holds no two hyphens
        let set = if target == TargetCode::Mujoco { "- -set law=thornton" } else { "--set law=thornton" };
        assert!(text.contains("plm-impact 0.1.0: plm-impact export") && text.contains(set), "{text}");
        assert_eq!(text.lines().next().unwrap().contains("untested template"), target == TargetCode::Mercury, "{text}");
        assert!(text.contains("SHA-256") && text.contains("impact at 3 m/s: e "), "{text}");
        // tests/lammps runs the lines of LAMMPS; those of LIGGGHTS and Yade only where somebody has these codes
        let said = match target {
            TargetCode::Lammps | TargetCode::Csv => [false, false, false],
            TargetCode::Liggghts | TargetCode::Yade => [true, false, false],
            TargetCode::Drake
            | TargetCode::Mujoco
            | TargetCode::Chrono
            | TargetCode::Edem
            | TargetCode::Mfix
            | TargetCode::Lethe
            | TargetCode::Kratos => [false, true, false],
            TargetCode::Mercury => [false, false, true],
            TargetCode::Rocky => [false; 3],
        };
        let words = ["not tested automatically", "not run in that code", "untested template"];
        assert_eq!(text.contains("# not tested: "), target == TargetCode::Rocky, "{text}");
        assert_eq!(words.map(|words| text.contains(words)), said, "{text}");
    }
}

/// A thick wall takes elastic waves, so where its density is known the lines have e with them. 0.573 is in the head of that
/// scenario, 0.5795 in the finite elements that it names.
#[test]
fn lines_name_wave_loss_in_their_e() {
    let with_waves = printed(&["scenarios/alumina-on-aluminium-with-waves.toml", "--to", "lammps"]);
    assert!(with_waves.contains(": e 0.5726") && with_waves.contains(" 0.572623728 damping"), "{with_waves}");
    assert!(with_waves.contains("# e includes radiated waves (thick wall); without them e is 0.583962"));
    let without = printed(&[STEEL, "--to", "lammps"]);
    assert!(without.contains("# e is without elastic waves. Set half_space.density for a thick wall"), "{without}");
}

/// e of the summary that a run of this scenario writes, and the one of the lines.
fn both(scenario: &str, result: &str, arguments: &[&str]) -> (f64, f64, String) {
    let desk = Sandbox::with_results(scenario);
    std::fs::write(desk.path("e.toml"), scenario).unwrap();
    let (text, _) = desk.run_expecting(&[&["export", "e.toml", "--to", "liggghts"], arguments].concat(), 0);
    let line = text.lines().find_map(|line| line.split_once("coefficientRestitution peratomtypepair 1 ")).unwrap();
    (desk.summary()[result].as_f64().unwrap(), line.1.parse().unwrap(), text.clone())
}

/// A sheet that the ball hits takes energy, and damping does: the code gets the e of all that.
#[test]
fn plate_and_damping_are_in_e() {
    let plate =
        crate::common::STEEL.replace("yield_strength", "density = 7850.0\nthickness = \"5 mm\"\nyield_strength");
    let (run, line, text) = both(&plate, "restitution", &[]);
    assert!((run - line).abs() < 1e-8 && text.contains("a plate of 5 mm"), "{run} {line} {text}");
    let damped = crate::common::STEEL.to_owned() + "[damping]\nviscous = 0.1\n";
    let (run, line, text) = both(&damped, "restitution", &[]);
    assert!((run - line).abs() < 1e-8 && text.contains("e includes [damping] of the scenario"), "{run} {line} {text}");
}

/// Gravity, air, series, angle and spin are of the motion, which the other code has itself: the e is that of the speed normal to
/// the wall, here 3 cos(60 deg) and sqrt(2 g h).
#[test]
fn motion_of_scenario_is_omitted_and_named() {
    let law = |speed: f64| steel().closed_form(speed).unwrap().row.restitution;
    let of = |more: &str, arguments: &[&str]| {
        let bodies = crate::common::STEEL.split("[impact]").next().unwrap();
        let law = "[law.plm]\nunloading_exponent = \"pressure-shape\"\n";
        let desk = Sandbox::with(format!("{bodies}{law}{more}"));
        let (text, _) = desk.run_expecting(&[&["export", "s.toml", "--to", "liggghts"], arguments].concat(), 0);
        let e = text.lines().find_map(|line| line.split_once("peratomtypepair 1 ")).unwrap().1;
        (e.parse::<f64>().unwrap(), text)
    };
    let oblique = "[impact]\nspeed = \"3 m/s\"\nangle = \"60 deg\"\n[friction]\ncoefficient = 0.2\n";
    let (e, text) = of(oblique, &[]);
    assert!((e - law(1.5)).abs() < 1e-8 && text.contains("impact.angle is not exported"), "{e} {text}");
    let bouncing =
        "[impact]\ndrop_height = \"0.5 m\"\n[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 3\nspot = \"same\"\n";
    let (e, text) = of(bouncing, &[]);
    assert!((e - law((9.81_f64).sqrt())).abs() < 1e-8, "{e} {text}");
    assert!(
        text.contains("# [repeat] is not exported: the lines are for the first impact")
            && text.contains("# [gravity] is not exported")
    );
    let swept = "[impact]\nspeed = \"3 m/s\"\n[sweep]\n\"half_space.youngs_modulus\" = [\"210 GPa\", \"70 GPa\"]\n";
    let (e, text) = of(swept, &["--speed", "2 m/s"]);
    assert!((e - law(2.0)).abs() < 1e-8 && text.contains("half_space.youngs_modulus = 2.1e11 Pa (210 GPa)"), "{text}");
}

/// The stiffness that the hooke model of LIGGGHTS computes for a ball on a wall: k = (16/15) sqrt(R) Y* (15 m V^2/(16 sqrt(R) Y*))^(1/5).
/// With `ktToKnUser on` its tangential spring is 2/7 of that, else as stiff, and `tangential_damping off` takes its damping out.
#[test]
fn liggghts_gets_tangential_spring_of_comment() {
    let rubbing = crate::common::STEEL.to_owned() + "[friction]\ncoefficient = 0.2\n";
    let desk = Sandbox::with(rubbing.replace("[impact]", "[impact]\nangle = \"10 deg\""));
    let lines = |code: &str| desk.run_expecting(&["export", "s.toml", "--to", code], 0).0;
    let (text, lammps) = (lines("liggghts"), lines("lammps"));
    let words = "model hooke tangential history tangential_damping off ktToKnUser on";
    assert_eq!(text.matches(words).count(), 2, "{text}");
    assert!(
        text.contains(&format!("pair_style gran {words}\n")) && text.contains(&format!("wall/gran {words} primitive"))
    );
    let number = |text: &str, before: &str| -> f64 {
        let rest = text.split_once(before).unwrap().1;
        rest.split([' ', '\n']).next().unwrap().parse().unwrap()
    };
    let (radius, mass) = (5e-3_f64, steel().mass());
    let factor = 16.0 / 15.0 * radius.sqrt() * number(&text, "youngsModulus peratomtype ") / (2.0 * (1.0 - 0.09));
    let speed = number(&text, "characteristicVelocity scalar ");
    let stiffness = factor * (mass * speed * speed / factor).powf(0.2);
    // LAMMPS gets the tangential stiffness itself
    assert_relative_eq!(number(&lammps, "linear_history "), 2.0 / 7.0 * stiffness, max_relative = 1e-6);
    // without friction there is no such spring
    assert!(!printed(&[STEEL, "--to", "liggghts"]).contains("ktToKnUser"));
}

/// LIGGGHTS stops at a modulus below 5 MPa, unless the input sets `soft_particles yes`, and at e of 0.05 and less.
#[test]
fn liggghts_gets_soft_particles_and_accepted_e() {
    for (modulus, is_soft) in [("2 MPa", true), ("210 GPa", false)] {
        let keys = [
            format!("sphere.youngs_modulus={modulus}"),
            format!("half_space.youngs_modulus={modulus}"),
            "half_space.yield_strength=1e12 Pa".to_owned(),
        ];
        let sets = keys.iter().flat_map(|key| ["--set", key.as_str()]);
        let text = printed(&[STEEL, "--to", "liggghts"].into_iter().chain(sets).collect::<Vec<_>>());
        let value: f64 =
            text.split_once("youngsModulus peratomtype ").unwrap().1.lines().next().unwrap().parse().unwrap();
        assert_eq!((value < 5e6, text.contains("soft_particles yes\n")), (is_soft, is_soft), "{text}");
    }
    let damped = [STEEL, "--to", "liggghts", "--set", "damping.viscous=2"];
    let output = export(&damped);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("LIGGGHTS refuses e of 0.05 or less, and e is 0.0"), "{message}");
    assert_eq!(output.status.code(), Some(2));
}
