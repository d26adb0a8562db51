//! `plm-impact export --to edem|rocky|mfix|lethe|kratos`: the equation of one contact of each code, integrated with the values of the lines, has
//! e of the law. The equations are those of the documentation or source that `src/interfaces/export/material_codes.rs` names.

use std::f64::consts::PI;

use crate::common::STEEL;
use crate::common::prelude::*;

/// The law at these speeds: e from 0.8 to 0.4.
const SPEEDS: [f64; 3] = [0.05, 0.5, 5.0];

/// The lines of a code at this speed, and e of the law.
fn lines(code: &str, speed: f64) -> (String, f64) {
    let scenario = STEEL.replace("3 m/s", &format!("{speed} m/s"));
    let text = Sandbox::with(&scenario).run_expecting(&["export", "s.toml", "--to", code], 0).0;
    (text, contact(&scenario, NO_OVERRIDES).closed_form(speed).unwrap().row.restitution)
}

/// The n-th number behind these words.
fn number_after(text: &str, words: &str, n: usize) -> f64 {
    let rest = text.split_once(words).unwrap_or_else(|| panic!("{words} in {text}")).1;
    let numbers = rest.split(|c: char| !c.is_ascii_digit() && !"+-.e".contains(c));
    let mut numbers = numbers.filter_map(|word| word.trim_end_matches('.').parse::<f64>().ok());
    numbers.nth(n).unwrap_or_else(|| panic!("a number behind {words} in {text}"))
}

/// E* of two bodies, as all of these codes compute it from Young's moduli and Poisson's ratios.
fn effective_modulus(moduli: [f64; 2], ratios: [f64; 2]) -> f64 {
    1.0 / ((1.0 - ratios[0] * ratios[0]) / moduli[0] + (1.0 - ratios[1] * ratios[1]) / moduli[1])
}

/// −ln e/√(π² + ln² e).
fn damping_ratio(e: f64) -> f64 {
    -e.ln() / (PI * PI + e.ln().powi(2)).sqrt()
}

/// The sphere of [`STEEL`] on a wall: its mass and its radius.
fn body() -> (f64, f64) {
    (contact(STEEL, NO_OVERRIDES).mass(), 0.005)
}

/// e of a contact with the stiffness S = 2 E* √(R x), by semi-implicit Euler with this time step. The damping is a factor of √(S m). The
/// contact ends with the overlap, or where the force would attract.
fn rebound(speed: f64, step: f64, modulus: f64, damping: f64, attracts: bool) -> f64 {
    let (mass, radius) = body();
    let (mut x, mut u) = (0.0_f64, speed);
    loop {
        x += 0.5 * step * u;
        let stiffness = 2.0 * modulus * (radius * x.max(0.0)).sqrt();
        let force = 2.0 / 3.0 * stiffness * x + damping * (stiffness * mass).sqrt() * u;
        if u < 0.0 && (x <= 0.0 || !attracts && force <= 0.0) {
            return -u / speed;
        }
        u -= step * force / mass;
        x += 0.5 * step * u;
    }
}

/// e with fine steps, and with the time step of the lines.
fn assert_rebound(e: f64, speed: f64, step: f64, contact: impl Fn(f64) -> f64) {
    let (fine, coarse) = (contact(step / 50.0), contact(step));
    assert!((fine / e - 1.0).abs() < 2e-3 && (coarse / e - 1.0).abs() < 0.01, "{fine} {coarse} {e} at {speed} m/s");
}

#[test]
fn hertz_mindlin_of_edem_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, e) = lines("edem", speed);
        let modulus = |body: &str| number_after(&text, &format!("material of the {body}: Young's modulus "), 0);
        let ratio = |body: &str| number_after(text.split_once(body).unwrap().1, "Poisson's ratio ", 0);
        let bodies = ["material of the sphere", "material of the wall"];
        let effective = effective_modulus([modulus("sphere"), modulus("wall")], bodies.map(ratio));
        let damping =
            2.0 * (5.0_f64 / 6.0).sqrt() * damping_ratio(number_after(&text, "coefficient of restitution ", 0));
        let step = number_after(&text, "; time step ", 0);
        assert_rebound(e, speed, step, |step| rebound(speed, step, effective, damping, true));
        let cut = number_after(&text, "if EDEM does, e is ", 0);
        assert!((rebound(speed, step / 50.0, effective, damping, false) / cut - 1.0).abs() < 2e-3 && cut > e);
    }
}

#[test]
fn nonlinear_model_of_lethe_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, e) = lines("lethe", speed);
        let [modulus, ratio, restitution] = ["young modulus", "poisson ratio", "restitution coefficient"]
            .map(|key| ["particles", "wall"].map(|body| number_after(&text, &format!("set {key} {body} = "), 0)));
        let mean = 2.0 * restitution[0] * restitution[1] / (restitution[0] + restitution[1]);
        let damping = 2.0 * (5.0_f64 / 6.0).sqrt() * damping_ratio(mean);
        let step = number_after(&text, "set time step = ", 0);
        let effective = effective_modulus(modulus, ratio);
        assert_rebound(e, speed, step, |step| rebound(speed, step, effective, damping, true));
        assert_eq!(text.matches("subsection").count(), text.lines().filter(|line| line.trim() == "end").count());
    }
}

/// MFiX damps by 2 β √(K m) x^(1/4) with K = (4/3) E* √R, where S m = (3/2) K m √x.
#[test]
fn hertzian_model_of_mfix_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, e) = lines("mfix", speed);
        let effective = effective_modulus(
            ["E_YOUNG(1) = ", "EW_YOUNG = "].map(|key| number_after(&text, key, 0)),
            ["V_POISSON(1) = ", "VW_POISSON = "].map(|key| number_after(&text, key, 0)),
        );
        let damping = 2.0 * (2.0_f64 / 3.0).sqrt() * damping_ratio(number_after(&text, "DES_EN_WALL_INPUT(1) = ", 0));
        let step = number_after(&text, "time step itself: ", 0);
        assert_rebound(e, speed, step, |step| rebound(speed, step, effective, damping, true));
    }
}

/// γ of Kratos from e, by the fit of its function `GammaForHertzThornton`.
fn kratos_damping(e: f64) -> f64 {
    const FIT: [f64; 10] = [
        -6.918_798, -16.411_05, 146.804_9, -796.455_9, 2_928.711, -7_206.864, 11_494.29, -11_342.18, 6_276.757,
        -1_489.915,
    ];
    let alpha = FIT.iter().rev().fold(0.0, |sum, factor| e * (factor + sum));
    (1.0 / (1.0 - (1.0 + e).powi(2) * alpha.exp()) - 1.0).sqrt()
}

#[test]
fn viscous_hertz_law_of_kratos_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, e) = lines("kratos", speed);
        let json: String = text.lines().filter(|line| !line.starts_with("//")).collect();
        let file: Value = serde_json::from_str(&json).unwrap();
        let of_body = |place: usize, key: &str| file["materials"][place]["Variables"][key].as_f64().unwrap();
        let relation = &file["material_relations"][0];
        assert_eq!(relation["material_ids_list"], serde_json::json!([1, 2]));
        let damping = 2.0 * kratos_damping(relation["Variables"]["COEFFICIENT_OF_RESTITUTION"].as_f64().unwrap());
        let [modulus, ratio] = ["YOUNG_MODULUS", "POISSON_RATIO"].map(|key| [of_body(0, key), of_body(1, key)]);
        let step = number_after(&text, "The time step is ", 0);
        let effective = effective_modulus(modulus, ratio);
        assert_rebound(e, speed, step, |step| rebound(speed, step, effective, damping, false));
    }
}

/// A hysteretic spring has no damping to integrate: the lines have e itself, and say what was not verified.
#[test]
fn values_for_rocky_name_unverified_statements() {
    let (text, e) = lines("rocky", 0.5);
    assert!((number_after(&text, "restitution coefficient ", 0) / e - 1.0).abs() < 1e-8);
    assert!(text.contains("No verified source") && text.contains("# not tested: "), "{text}");
}

/// Two spheres of different materials: both are in the lines, and no wall.
#[test]
fn second_sphere_replaces_wall() {
    let scenario =
        STEEL.replace("[half_space]", "[half_space]\nradius = \"3 mm\"\nmass = \"ball\"\ndensity = \"2700 kg/m^3\"");
    for (code, words) in [
        ("edem", ["material of the second sphere", "solids density 2.7"]),
        ("rocky", ["material of the second sphere", "density 2.7"]),
        ("mfix", ["DES_EN_INPUT(2) = ", "RO_S0(2) = 2.7"]),
        ("lethe", ["subsection particle type 1", "set density particles = 2.7"]),
        ("kratos", ["\"material_name\": \"second_sphere\"", "\"PARTICLE_DENSITY\": 2.7"]),
    ] {
        let desk = Sandbox::with(&scenario);
        let (text, _) = desk.run_expecting(&["export", "s.toml", "--to", code], 0);
        let lines: String = text.lines().filter(|line| !line.starts_with(['#', '/'])).collect();
        assert!(words.iter().all(|word| lines.contains(word)), "{code}: {text}");
        assert!(!lines.to_lowercase().contains("wall =") && !lines.contains("\"wall\""), "{code}: {text}");
    }
}

#[test]
fn rigid_sphere_and_dead_rebound_are_refused() {
    for (code, change, words) in [
        ("edem", "--set=sphere.youngs_modulus=rigid", "the sphere is rigid. Give sphere.youngs_modulus"),
        ("mfix", "--set=damping.viscous=3", "needs e of 0.02 or more"),
    ] {
        let desk = Sandbox::with(STEEL);
        let (_, message) = desk.run_expecting(&["export", "s.toml", "--to", code, change], 2);
        assert!(message.contains(words), "{code}: {message}");
    }
}
