//! `plm-impact peen`: dent, coverage, mass and time; scatter; the speed from dents; the process window; what is below a dent.

use std::f64::consts::PI;

use crate::common::prelude::*;
use plm_impact::impact::{PeenedSurface, Peening};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The example of README.
const EXAMPLE: [&str; 11] = [
    "peen",
    "--diameter",
    "0.6 mm",
    "--shot-material",
    "steel-52100-hardened",
    "--speed",
    "40 m/s",
    "--on",
    "steel-4140-qt",
    "--hardness",
    "300 HV",
];

fn json(desk: &Sandbox, arguments: &[&str], more: &[&str]) -> Value {
    serde_json::from_str(&desk.run_expecting(&[arguments, &["--json"], more].concat(), 0).0).unwrap()
}

fn number(summary: &Value, name: &str) -> f64 {
    summary[name].as_f64().unwrap_or_else(|| panic!("{name}: {summary}"))
}

/// N = ln 50/(π a²), mass = N (4/3) π R³ ρ, time = mass × area/flow, C = 1 − exp(−N π a²): by hand from the dent diameter.
#[test]
fn coverage_follows_from_dent_by_hand() {
    let desk = Sandbox::with("");
    let flow = ["--mass-flow", "6 kg/min", "--area", "50 cm^2", "--time", "3 s", "--save", "p.toml"];
    let peened = json(&desk, &EXAMPLE, &flow);
    let radius = number(&peened, "dent_diameter_m") / 2.0;
    assert!(relative_error(radius, 94.6e-6) < 1e-3, "{radius}");
    let impacts = 50_f64.ln() / (PI * radius * radius);
    let shot = 4.0 / 3.0 * PI * 0.3e-3_f64.powi(3) * 7830.0;
    // 0.1 kg/s on 0.005 m²
    let flux = 20.0;
    for (name, by_hand) in [
        ("impacts_for_coverage_per_m2", impacts),
        ("mass_for_coverage_kg_per_m2", impacts * shot),
        ("time_for_coverage_s", impacts * shot / flux),
        ("coverage_after_time", 1.0 - (-3.0 * flux / shot * PI * radius * radius).exp()),
    ] {
        assert!(relative_error(number(&peened, name), by_hand) < 1e-9, "{name}: {by_hand} {peened}");
    }
    // the saved scenario gives the same
    desk.run_expecting(&["run", "p.toml", "--out", "out", "--pictures", "none"], 0);
    assert_eq!(desk.summary()["time_for_coverage_s"], peened["time_for_coverage_s"]);
    // S230: 0.0230 inch; cast shot has pores, so its density is 7400 kg/m^3
    let named =
        ["peen", "--shot", "s-230", "--shot-hardness", "55 HRC", "--speed", "40 m/s", "--on", "copper-annealed"];
    let named = json(&desk, &named, &[]);
    let shot = 4.0 / 3.0 * PI * (0.0230 * 0.0254 / 2.0_f64).powi(3) * 7400.0;
    assert!(relative_error(number(&named, "shot_mass_kg"), shot) < 1e-9, "{named}");
}

/// 10⁴ shots at random places of a patch whose edges are joined: the covered share of 10⁴ random points. The formula has the mean area
/// of the dents. The covered share of such a patch scatters by 0.6 %.
#[test]
fn coverage_formula_matches_random_shots() {
    const SHOTS: u32 = 10_000;
    let mut generator = ChaCha8Rng::seed_from_u64(5);
    #[allow(clippy::cast_precision_loss)] // 53 bits
    let mut next = || (generator.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    for (coverage, radii) in [(0.98, [1.0, 1.0]), (0.5, [1.0, 1.0]), (0.9, [0.5, 1.5])] {
        let dent_area = PI * (radii[0] * radii[0] + radii[1] * radii[1]) / 2.0;
        let request = Peening { coverage, mass_flux: None, time: None };
        let surface = PeenedSurface { request, dent_area, shot_mass: 1.0 };
        let side = (f64::from(SHOTS) / surface.impacts_per_area().unwrap()).sqrt();
        let shots: Vec<[f64; 3]> =
            (0..SHOTS).map(|shot| [side * next(), side * next(), radii[shot as usize % 2]]).collect();
        let distance = |a: f64, b: f64| (a - b).abs().min(side - (a - b).abs());
        let points = 10_000;
        let mut covered = 0_u32;
        for _ in 0..points {
            let point = [side * next(), side * next()];
            let is_in = |[x, y, radius]: &[f64; 3]| {
                let (x, y) = (distance(point[0], *x), distance(point[1], *y));
                x * x + y * y < radius * radius
            };
            covered += u32::from(shots.iter().any(is_in));
        }
        let share = f64::from(covered) / f64::from(points);
        // the points scatter by at most 0.5 %, and the dents by less
        assert!((share - coverage).abs() < 0.02, "{share} for {coverage}");
    }
}

/// A published simulation with Abaqus: steel shot of 0.15 mm radius on Ti-6Al-4V (Johnson-Cook 961 MPa + 902 MPa ε^0.87) at 39.1 m/s
/// has a crater of 50.98 µm to the peaks of its rim, and 85 shots per mm² cover 50 %. The rim is wider than the contact.
#[test]
fn published_titanium_case_agrees() {
    let request = Peening { coverage: 0.5, mass_flux: None, time: None };
    let dent_area = PI * 0.050_98e-3 * 0.050_98e-3;
    let impacts = PeenedSurface { request, dent_area, shot_mass: 1.0 }.impacts_per_area().unwrap();
    assert!((impacts * 1e-6 - 85.0).abs() < 0.5, "{impacts}");
    let points: Vec<String> = (0..=15)
        .map(|i| 0.02 * f64::from(i))
        .map(|strain: f64| format!("[{strain}, \"{} MPa\"]", 961.0 + 902.0 * strain.powf(0.87)))
        .collect();
    let scenario = format!(
        "[sphere]\nradius = \"0.15 mm\"\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\ndensity = 7800\n\
         [half_space]\nyoungs_modulus = \"120 GPa\"\npoissons_ratio = 0.34\nyield_strength = \"961 MPa\"\nflow_stress.points = [{}]\n\
         rate.johnson_cook.c = 0.01\n[impact]\nspeed = \"39.1 m/s\"\n[peening]\ncoverage = 0.5\n\
         [law.plm]\nunloading_exponent = \"pressure-shape\"\n",
        points.join(", ")
    );
    let desk = Sandbox::with(&scenario);
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    let radius = number(&desk.summary(), "dent_diameter_m") / 2.0;
    assert!((0.8..1.0).contains(&(radius / 0.050_98e-3)), "{radius}");
}

#[test]
fn bad_options_are_refused() {
    let desk = Sandbox::with("");
    let steel = ["peen", "--speed", "60 m/s", "--on", "steel-4140-qt"];
    for (more, says) in [
        (&["--shot", "S230", "--shot-hardness", "46 HRC", "--coverage", "1.2"][..], "--coverage: 1.2 is not allowed"),
        (&["--shot", "S240", "--shot-hardness", "46 HRC"], "did you mean \"S230\"?"),
        (&["--shot", "S230"], "--shot-hardness: the hardness of the shot is missing"),
        (&["--shot", "Z150"], "--shot-material: the material of Z150 is not known"),
        (&["--shot", "S230", "--shot-hardness", "46 HRC", "--angle", "100 deg"], "counted from the surface"),
        (&["--shot", "S230", "--shot-hardness", "46 HRC", "--mass-flow", "5 kg", "--area", "1 m^2"], "--mass-flow"),
        (
            &["--shot", "S230", "--shot-hardness", "46 HRC", "--window", "none/w.png"],
            "Choose another file with --window",
        ),
    ] {
        let (_, said) = desk.run_expecting(&[&steel, more].concat(), 2);
        assert!(said.contains(says), "{more:?}: {said}");
    }
    assert_eq!(desk.files("."), ["s.toml"]);
    // a key without the keys that it needs
    let steel = format!("{STEEL}\n[peening]\n");
    for (keys, says) in [
        ("mass_flow = \"1 kg/s\"\narea = 1\n", "requires peening.coverage"),
        ("coverage = 0.9\ntime = 1\n", "requires peening."),
        ("coverage = 0.9\n[repeat]\nspot = \"same\"\nimpacts = 3\n", "does not apply to [repeat]"),
    ] {
        let (_, said) = Sandbox::with(&(steel.clone() + keys)).run_expecting(&["check", "s.toml"], 2);
        assert!(said.contains(says), "{said}");
    }
}

/// 80° from the surface are 10° from the normal, and the dent is the dent of v cos 10°.
#[test]
fn oblique_jet_dents_by_normal_speed() {
    let desk = Sandbox::with("");
    let oblique = json(&desk, &EXAMPLE, &["--angle", "80 deg"]);
    let mut normal = EXAMPLE;
    let speed = format!("{} m/s", 40.0 * 10_f64.to_radians().cos());
    normal[6] = &speed;
    let normal = json(&desk, &normal, &[]);
    let name = "impacts_for_coverage_per_m2";
    assert!(relative_error(number(&oblique, name), number(&normal, name)) < 1e-9);
}

/// The impacts follow from the mean area of the dents, and the mass from the mean mass: E[d³] = d³ (1 + 3 s²) for a normal diameter.
#[test]
fn scattered_shots_use_mean_area() {
    let desk = Sandbox::with("");
    let scatter = ["--speed-sd", "4 m/s", "--size-sd", "0.06 mm", "--samples", "4000", "--save", "p.toml"];
    let peened = json(&desk, &EXAMPLE, &scatter);
    let mean = |name: &str| {
        let columns = peened["columns"].as_array().unwrap();
        columns.iter().find(|column| column["column"] == name).map(|column| number(column, "mean")).unwrap()
    };
    let impacts = 50_f64.ln() / mean("dent_area_m2");
    assert!(relative_error(number(&peened["peening"], "impacts_for_coverage_per_m2"), impacts) < 1e-9);
    let mass = impacts * mean("shot_mass_kg");
    assert!(relative_error(number(&peened["peening"], "mass_for_coverage_kg_per_m2"), mass) < 1e-9);
    let shot = 4.0 / 3.0 * PI * 0.3e-3_f64.powi(3) * 7830.0 * (1.0 + 3.0 * 0.01);
    // 30 % of scatter over 4000 shots: 0.5 %
    assert!(relative_error(mean("shot_mass_kg"), shot) < 0.02);
    desk.run_expecting(&["run", "p.toml", "--out", "out", "--pictures", "none"], 0);
    assert_eq!(desk.summary()["peening"], peened["peening"]);
}

#[test]
fn dents_give_back_their_speed() {
    let desk = Sandbox::with("");
    let named = &EXAMPLE[..5];
    let on = &EXAMPLE[7..];
    let diameter = number(&json(&desk, &EXAMPLE, &[]), "dent_diameter_m");
    let dents: Vec<String> = [0.98, 1.0, 1.02].iter().map(|factor| (factor * diameter * 1e6).to_string()).collect();
    desk.write("dents.csv", format!("dent_diameter_um\n{}\n", dents.join("\n")));
    let fitted = json(&desk, &[named, on].concat(), &["--dents", "dents.csv"]);
    assert!(relative_error(number(&fitted["keys"][0], "estimate"), 40.0) < 2e-3, "{fitted}");
    // the range of hardness of the library is a band
    let (printed, _) = desk.run_expecting(&[named, &on[..2], &["--dents", "dents.csv"]].concat(), 0);
    assert!(printed.contains("The hardness of steel-4140-qt varies: the speed is "), "{printed}");
}

#[test]
fn process_window_is_one_picture() {
    let desk = Sandbox::with("");
    let window = [&EXAMPLE[..], &["--window", "w.svg"]].concat();
    desk.run_expecting(&window, 0);
    let drawn = desk.read("w.svg");
    assert!(drawn.contains("Process window") && drawn.contains("kg/m^2"));
    let (_, said) = desk.run_expecting(&window, 2);
    assert!(said.contains("w.svg") && desk.read("w.svg") == drawn, "{said}");
}

/// By the formulas with S = 1, for a metal that does not harden: z_0 = 2 a (Y/0.003)^−0.12 (a/(0.4 R))^−0.16.
#[test]
fn depths_below_dent_are_columns_on_request() {
    let sweep = format!("{STEEL}\n[sweep]\n\"impact.speed\" = [\"20 m/s\", \"40 m/s\"]\n");
    let desk = Sandbox::with(&sweep);
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    assert!(!desk.read("out/table.csv").contains("plastic_zone"));
    let columns = "\n[output]\ncolumns = [\"compressive_layer_depth_m\", \"plastic_zone_depth_m\", \"residual_compression_Pa\", \
                   \"dent_diameter_m\", \"contact_radius_over_R\"]\n";
    let desk = Sandbox::with(&(sweep + columns));
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    let table = desk.read("out/table.csv");
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let (strength, modulus): (f64, f64) = (345e6, 210e9 / (1.0 - 0.09) / 2.0);
    let y = strength / modulus / 0.003;
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |name: &str| -> f64 { cells[names.iter().position(|one| *one == name).unwrap()].parse().unwrap() };
        let (a, ratio) = (cell("dent_diameter_m") / 2.0, cell("contact_radius_over_R"));
        let depth = 2.0 * a * y.powf(-0.12) * (ratio / 0.4).powf(-0.16);
        assert!(relative_error(cell("compressive_layer_depth_m"), depth) < 1e-9, "{line}");
        assert!(relative_error(cell("plastic_zone_depth_m"), 1.15 * depth) < 1e-9, "{line}");
        let stress = strength * (1.32 - 0.14 * y.ln() + 0.36 * (ratio - 0.4));
        assert!(relative_error(cell("residual_compression_Pa"), stress) < 1e-9, "{line}");
    }
}

/// The stated limit of the contact radius is that of the bodies that yield: a dent in the target, or a flat on a soft shot.
#[test]
fn limit_is_that_of_the_yielding_body() {
    let desk = Sandbox::with("");
    let soft = [
        "--diameter",
        "0.6 mm",
        "--shot-material",
        "aluminium-6061-t6",
        "--speed",
        "20 m/s",
        "--on",
        "steel-52100-hardened",
    ];
    let printed = |options: &[&str]| desk.run_expecting(&[&["peen"], options].concat(), 0).0;
    assert!(printed(&soft).contains("valid up to 0.3."), "{}", printed(&soft));
    let hard = [
        "--diameter",
        "0.6 mm",
        "--shot-material",
        "steel-52100-hardened",
        "--speed",
        "20 m/s",
        "--on",
        "aluminium-6061-t6",
    ];
    assert!(printed(&hard).contains("valid up to 0.55."), "{}", printed(&hard));
}
