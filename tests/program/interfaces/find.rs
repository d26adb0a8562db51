//! `plm-impact find`: the values of a key that give a wanted result.

use std::f64::consts::PI;

use crate::common::prelude::*;

/// All solutions, as JSON.
fn solutions(desk: &Sandbox, arguments: &[&str]) -> Vec<Value> {
    let (printed, _) = desk.run_expecting(&[&["find"], arguments, &["--json"]].concat(), 0);
    serde_json::from_str::<Value>(&printed).unwrap()["solutions"].as_array().unwrap().clone()
}

fn number(found: &Value, name: &str) -> f64 {
    found[name].as_f64().unwrap_or_else(|| panic!("{name}: {found}"))
}

/// The only solution.
fn solution(desk: &Sandbox, arguments: &[&str]) -> Value {
    let found = solutions(desk, arguments);
    assert_eq!(found.len(), 1, "{arguments:?}: {found:?}");
    found[0].clone()
}

#[track_caller]
fn refused(desk: &Sandbox, arguments: &[&str], words: &[&str]) {
    let said = desk.run_expecting(&[&["find"], arguments].concat(), 2).1;
    assert!(words.iter().all(|word| said.contains(word)), "{arguments:?}: {said}");
}

/// Hertz: with F = k δ^(3/2) the energy at the peak is 2/5 k δ^(5/2) = m v^2/2, so v = (4/5 F^(5/3) k^(-2/3)/m)^(1/2).
#[test]
fn hertz_gives_the_found_values() {
    let desk = Sandbox::with(STEEL.replace("yield_strength = \"345 MPa\"\n", ""));
    let (modulus, density) = (210e9 / (1.0 - 0.3 * 0.3) / 2.0, 7850.0);
    let speed = |force: f64, radius: f64| {
        let (k, mass) = (4.0 / 3.0 * modulus * f64::sqrt(radius), density * 4.0 / 3.0 * PI * radius.powi(3));
        f64::sqrt(0.8 * force.powf(5.0 / 3.0) * k.powf(-2.0 / 3.0) / mass)
    };
    let found = solution(&desk, &["impact.speed", "s.toml", "--peak-force", "1 kN"]);
    assert!(relative_error(number(&found, "impact_speed_m_per_s"), speed(1e3, 5e-3)) < 1e-9, "{found}");
    assert!(relative_error(number(&found, "peak_force_N"), 1e3) < 1e-9, "{found}");
    // a height instead of the speed of the file; h = v^2/(2 g)
    let found = solution(&desk, &["impact.drop_height", "s.toml", "--peak-force", "1000"]);
    let height = speed(1e3, 5e-3).powi(2) / (2.0 * 9.80665);
    assert!(relative_error(number(&found, "impact_drop_height_m"), height) < 1e-9, "{found}");
    // a diameter instead of the radius of the file: the force at one speed is proportional to its square
    let found = solution(&desk, &["sphere.diameter", "s.toml", "--peak_force_N", "4 kN"]);
    let of_file = solution(&desk, &["sphere.radius", "s.toml", "--peak-force", "1 kN"]);
    let [diameter, radius] = [number(&found, "sphere_diameter_m"), number(&of_file, "sphere_radius_m")];
    assert!(relative_error(diameter, 4.0 * radius) < 1e-9, "{diameter} {radius}");
    assert!(relative_error(speed(1e3, radius), 3.0) < 1e-9, "{radius}");
}

/// The value that is printed gives the wanted result in a run.
#[test]
fn run_of_the_printed_command_gives_the_result() {
    let desk = Sandbox::with(STEEL);
    let (printed, said) = desk.run_expecting(
        &["find", "impact.drop_height", "s.toml", "--dent-diameter", "1 mm", "--set", "sphere.radius=4 mm"],
        0,
    );
    assert!(
        printed.starts_with("impact.drop_height   ") && printed.contains("gives dent_diameter_m = 1 mm\n"),
        "{printed}"
    );
    let command = said.split_once("Next: `plm-impact ").unwrap().1.trim().trim_end_matches('`');
    let words = ["run", "s.toml", "--set", "sphere.radius=4 mm", "--set"];
    let setting = command.rsplit_once("--set ").unwrap().1.trim_matches('\'');
    assert!(command.starts_with("run s.toml --set 'sphere.radius=4 mm' --set 'impact.drop_height="), "{command}");
    desk.run_expecting(&[&words[..], &[setting, "--out", "out", "--pictures", "none"]].concat(), 0);
    // six digits of the height
    assert!(relative_error(number(&desk.summary(), "dent_diameter_m"), 1e-3) < 1e-5);
}

/// A hardness comes back on its scale, and the interval of e is a result too.
#[test]
fn any_key_and_result_are_found() {
    let desk = Sandbox::with(STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"300 HV\""));
    let printed = desk.run_expecting(&["find", "half_space.hardness", "s.toml", "--energy-plastic", "5 mJ"], 0).0;
    assert!(printed.starts_with("half_space.hardness   ") && printed.contains(" HV ("), "{printed}");
    // without a flat on the ball the dent has all of the residual indentation
    let found = solution(&desk, &["impact.speed", "s.toml", "--dent-depth", "20 um"]);
    assert!(relative_error(number(&found, "residual_indentation_m"), 2e-5) < 1e-7, "{found}");
    let found = solution(
        &desk,
        &[
            "half_space.hardness",
            "s.toml",
            "--restitution-interval-low",
            "0.6",
            "--set",
            "half_space.strength_kind=proof",
        ],
    );
    // a scenario with a pulse has the speed of the scenario without
    let [with, without] = [&["--set", "output.pulse.step=50 ns"][..], &[]].map(|set| {
        solution(&desk, &[&["impact.speed", "s.toml", "--dent-diameter", "1 mm"], set].concat())["impact_speed_m_per_s"].clone()
    });
    assert_eq!(with, without);
    let run = &found["results"];
    assert!(relative_error(run["restitution_interval"][0].as_f64().unwrap(), 0.6) < 1e-7, "{found}");
}

/// The loss by friction rises from zero at normal incidence, and has a maximum: there are two angles. A table along the angle crosses
/// the wanted value twice.
#[test]
fn all_solutions_are_found() {
    let desk = Sandbox::with(format!("{STEEL}[friction]\ncoefficient = 0.2\n"));
    let wanted = 0.1;
    let found = solutions(&desk, &["impact.angle", "s.toml", "--friction-loss-fraction", "10 %"]);
    let axis = "sweep={ \"impact.angle\" = { linspace = [\"1 deg\", \"89 deg\"], points = 300 } }";
    desk.run_expecting(&["run", "s.toml", "--set", axis, "--out", "t", "--pictures", "none"], 0);
    let table = desk.read("t/table.csv");
    let (angles, losses) = (numbers(&table, "impact_angle_rad"), numbers(&table, "friction_loss_fraction"));
    let crossed: Vec<usize> =
        (1..losses.len()).filter(|at| (losses[at - 1] < wanted) != (losses[*at] < wanted)).collect();
    assert_eq!((found.len(), crossed.len()), (2, 2), "{found:?}");
    let printed = desk.run_expecting(&["find", "impact.angle", "s.toml", "--friction-loss-fraction", "0.1"], 0).0;
    assert_eq!(printed.matches(" deg   gives friction_loss_fraction = 0.1").count(), 2, "{printed}");
    // the notes are the same for both
    assert_eq!(printed.matches("Which exponent?").count(), 1, "{printed}");
    for (found, at) in found.iter().zip(crossed) {
        let angle = number(found, "impact_angle_rad");
        assert!(angle > angles[at - 1] && angle < angles[at], "{angle}");
        assert!(relative_error(found["results"]["friction_loss_fraction"].as_f64().unwrap(), wanted) < 1e-6, "{found}");
    }
}

/// An impact that slides to its end has the impulse ratio μ. The nodes of the range lie on both sides of its middle, with equal distances
/// from the wanted value.
#[test]
fn solution_in_the_middle_of_the_range_is_found() {
    let desk = Sandbox::with(format!("{STEEL}angle = \"70 deg\"\n[friction]\ncoefficient = 0.3\n"));
    let key = ["friction.coefficient", "s.toml", "--impulse-ratio", "0.1", "--from", "0", "--to", "0.2"];
    let found = solution(&desk, &key);
    assert!(relative_error(number(&found, "friction_coefficient"), 0.1) < 1e-9, "{found}");
}

/// Below the yield speed every impact is elastic.
#[test]
fn constant_result_gives_a_part_of_the_range() {
    let desk = Sandbox::with(STEEL);
    let found = solution(&desk, &["impact.speed", "s.toml", "--restitution", "1", "--from", "1 mm/s"]);
    let ends = found["impact_speed_m_per_s_interval"].as_array().unwrap();
    assert_eq!(ends[0], 0.001);
    let yield_speed = number(&found["results"], "yield_speed_m_per_s");
    // the value is the middle of the part: the range is logarithmic
    let middle = number(&found, "impact_speed_m_per_s");
    assert!(relative_error(middle, (0.001 * yield_speed).sqrt()) < 1e-3 && found["restitution"] == 1.0, "{found}");
    assert!((1.0..1.01).contains(&(ends[1].as_f64().unwrap() / yield_speed)), "{ends:?} {yield_speed}");
    let printed =
        desk.run_expecting(&["find", "impact.speed", "s.toml", "--restitution", "1", "--from", "1 mm/s"], 0).0;
    assert!(printed.starts_with("impact.speed   every value from 1 mm/s to "), "{printed}");
    // no dent: the depths are compared with the largest one, and not with a metre
    let found = solution(&desk, &["impact.speed", "s.toml", "--dent-depth", "0", "--from", "1 mm/s"]);
    let end = found["impact_speed_m_per_s_interval"][1].as_f64().unwrap();
    assert!((1.0..1.001).contains(&(end / yield_speed)), "{end} {yield_speed}");
    // a part that ends with the range: the yield speed is proportional to the strength to the power 5/2
    let ends = ["--from", "1 GPa", "--to", "10 GPa"];
    let found = solution(&desk, &[&["half_space.yield_strength", "s.toml", "--restitution", "1"], &ends[..]].concat());
    let part = &found["half_space_yield_strength_Pa_interval"];
    let least = 345e6 * (3.0 / yield_speed).powf(0.4);
    assert!((0.999..1.001).contains(&(part[0].as_f64().unwrap() / least)) && part[1] == 1e10, "{part} {least}");
    let middle = number(&found, "half_space_yield_strength_Pa");
    assert!(relative_error(middle, (least * 1e10).sqrt()) < 1e-3 && found["restitution"] == 1.0, "{found}");
    // the whole range
    let no_dent = ["impact.speed", "s.toml", "--dent-depth", "0", "--from", "1 mm/s", "--to", "2 mm/s"];
    assert_eq!(solution(&desk, &no_dent)["impact_speed_m_per_s_interval"], json!([0.001, 0.002]));
    // e is the root of the ratio of the stiffnesses at every speed
    let desk = Sandbox::with(format!("{STEEL}[law.walton_braun]\nstiffness_ratio = 0.81\n"));
    let found = solution(&desk, &["impact.speed", "s.toml", "--restitution", "0.9", "--from", "1", "--to", "10"]);
    assert_eq!(found["impact_speed_m_per_s_interval"], json!([1.0, 10.0]), "{found}");
}

/// The energy m v^2/2 of 1 g at 3 m/s is 4.5 mJ.
#[test]
fn end_of_range_is_single_solution() {
    let desk = Sandbox::with(STEEL.replace("density = \"7850 kg/m^3\"", "mass = \"4 g\""));
    let energy = ["find", "sphere.mass", "s.toml", "--energy-kinetic-in", "4.5 mJ", "--from", "1 g", "--to", "10 g"];
    let printed = desk.run_expecting(&energy, 0).0;
    assert!(printed.starts_with("sphere.mass   1 g   gives energy.kinetic_in_J = 4.5 mJ"), "{printed}");
}

/// With a density of the half-space, e is the measured one, as on the terminal and in a calibration.
#[test]
fn restitution_has_waves_if_there_are_any() {
    let desk = Sandbox::with(STEEL.replace("yield_strength", "density = \"7850 kg/m^3\"\nyield_strength"));
    let found = solution(&desk, &["impact.speed", "s.toml", "--restitution", "0.5"]);
    assert!(relative_error(number(&found["results"], "restitution_with_waves"), 0.5) < 1e-7, "{found}");
    assert!(number(&found["results"], "restitution") > 0.501, "{found}");
}

#[test]
fn no_solution_reports_the_range_of_the_result() {
    let desk = Sandbox::with(STEEL);
    refused(
        &desk,
        &["impact.speed", "s.toml", "--restitution", "0.9", "--from", "1 m/s", "--to", "4 m/s"],
        &[
            "no impact.speed from 1 m/s to 4 m/s gives restitution = 0.9",
            "restitution is 0.4",
            "(at 4 m/s) to 0.6",
            "(at 1 m/s)",
            "--from and --to",
        ],
    );
    // a depth of the dent differs from another by its share, and not by metres: it is 8.271 um at 1 m/s
    refused(
        &desk,
        &["impact.speed", "s.toml", "--dent-depth", "8.22 um", "--from", "1 m/s", "--to", "4 m/s"],
        &["no impact.speed from 1 m/s to 4 m/s gives residual_indentation_m = 8.22 µm", "is 8.27083 µm (at 1 m/s)"],
    );
    assert_eq!(desk.files("."), ["s.toml"]);
}

/// A sphere that is released at first contact has no kinetic energy of which the plastic work is a fraction.
#[test]
fn result_without_value_is_refused_with_reason() {
    let desk = Sandbox::with(STEEL.replace("speed = \"3 m/s\"", "drop_height = 0\n[gravity]\nacceleration = 9.81"));
    refused(
        &desk,
        &["sphere.radius", "s.toml", "--plastic-fraction", "0.5"],
        &["gives no plastic_fraction: it has no value, because the sphere does not separate. Change the range"],
    );
    // an elastic impact has no interval, which is a result of tables alone
    desk.write("h.toml", STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"300 HV\""));
    refused(
        &desk,
        &["impact.speed", "h.toml", "--restitution-interval-low", "0.5", "--from", "1 um/s", "--to", "2 um/s"],
        &["restitution_interval_low: it exists only if the interval is known: a body yields under the law"],
    );
    // the reason of an impact is a sentence, which ends once
    refused(
        &desk,
        &["impact.speed", "h.toml", "--restitution", "0.5", "--from", "5 km/s", "--to", "6 km/s"],
        &["or reduce the speed. Change the range"],
    );
}

#[test]
fn mistakes_are_refused_with_advice() {
    let desk = Sandbox::with(STEEL);
    let speed = |more: &[&'static str]| [&["impact.speed", "s.toml"], more].concat();
    refused(
        &desk,
        &["impact.sped", "s.toml", "--restitution", "0.5"],
        &["`impact.sped` is not a numeric key", "impact.speed"],
    );
    refused(&desk, &speed(&[]), &["no result is given", "--dent-diameter"]);
    refused(
        &desk,
        &speed(&["--restitution", "0.5", "--peak-force", "1 N"]),
        &["cannot be used with", "<FILE> --RESULT <VALUE>"],
    );
    refused(&desk, &speed(&["--peak-force", "1 mm"]), &["--peak-force 1 mm: "]);
    refused(&desk, &speed(&["--restitution", "0.5", "--from", "1 mm"]), &["lower end of the range of impact.speed"]);
    refused(
        &desk,
        &speed(&["--restitution", "0.5", "--from", "9", "--to", "1"]),
        &["the lower end must be below the upper end"],
    );
    // a scenario without plate, friction and gravity
    refused(&desk, &speed(&["--zener-number", "1"]), &["\"zener_number\" is not available"]);
    refused(
        &desk,
        &speed(&["--plate-wave-transits", "1"]),
        &["plate_wave_transits: it exists only if the target is a plate"],
    );
    refused(
        &desk,
        &["friction.coefficient", "s.toml", "--restitution", "0.5", "--from", "0.1", "--to", "1"],
        &["has no effect"],
    );
    refused(
        &desk,
        &["half_space.thickness", "s.toml", "--restitution", "0.5"],
        &["half_space.thickness has no value", "--from"],
    );
    desk.write("t.toml", format!("{STEEL}[sweep]\n\"sphere.radius\" = [1, 2]\n"));
    refused(
        &desk,
        &["impact.speed", "t.toml", "--restitution", "0.5"],
        &["this scenario is a table", "--set sweep=none"],
    );
    solution(&desk, &["impact.speed", "t.toml", "--restitution", "0.5", "--set", "sweep=none"]);
}
