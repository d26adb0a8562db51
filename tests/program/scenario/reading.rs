//! Scenarios as text: the scenes that they resolve to, and the refusal of bad scenarios.

use plm_impact::scenario::input::{NUMERIC_KEYS, alternative_pairs};

use crate::common::prelude::*;

fn resolve(text: &str, overrides: &[&str]) -> Result<Input, Error> {
    Scenario::from_text("steel.toml", text, &Override::list(overrides))?.resolve()
}

fn plm(input: &Input) -> Plm {
    match input.law() {
        LawChoice::Plm(plm) => plm,
        law => panic!("{}", law.name()),
    }
}

#[test]
fn scenario_resolves_to_si_and_defaults() {
    let scene = resolve(STEEL, &[]).unwrap();
    assert_eq!(scene.sphere().radius, 0.005);
    assert_eq!(scene.sphere().material.youngs_modulus, 210e9);
    assert_eq!(scene.sphere().density, 7850.0);
    assert_eq!(scene.sphere().yield_strength, None);
    assert_eq!(scene.half_space().yield_strength, Some(345e6));
    assert_eq!(scene.speed(), 3.0);
    assert_eq!(plm(&scene).exponent, UnloadingExponent::Paper);
    assert_eq!(*plm(&scene).coefficients, *PlmCoefficients::built_in());
    assert_eq!(scene.solver().tolerance, 1e-10);
    assert_eq!(scene.samples(), 400);
}

#[test]
fn overrides_from_shell_change_keys() {
    let scene = resolve(
        STEEL,
        &[
            "impact.speed=1 m/s",
            "sphere.youngs_modulus=rigid",
            "sphere.density=7.8e3",
            "half_space.yield_strength=\"0.5 GPa\"",
            "law.plm.unloading_exponent=pressure-shape",
            "solver.method=dop853",
            "solver.tolerance=1e-6",
            "output.samples=7",
            "impact.speed=2 m/s",
        ],
    )
    .unwrap();
    assert_eq!(scene.speed(), 2.0, "the last one counts");
    assert_eq!(scene.sphere().material.youngs_modulus, f64::INFINITY);
    assert_eq!(scene.sphere().density, 7800.0);
    assert_eq!(scene.half_space().yield_strength, Some(5e8));
    assert_eq!(plm(&scene).exponent, UnloadingExponent::PressureShape);
    assert_eq!(scene.solver().method, Method::Dop853);
    assert_eq!(scene.solver().tolerance, 1e-6);
    assert_eq!(scene.samples(), 7);
    let set = |given: String| resolve(STEEL, &[&given]).unwrap();
    for method in Method::ALL {
        assert_eq!(set(format!("solver.method={}", method.name())).solver().method, method);
    }
    let [paper, fixed] = [("1.5", UnloadingExponent::Paper), ("2", UnloadingExponent::Fixed(2.0))];
    for (value, exponent) in [paper, fixed, ("1.25", UnloadingExponent::Fixed(1.25))] {
        assert_eq!(plm(&set(format!("law.plm.unloading_exponent={value}"))).exponent, exponent);
    }
}

/// A value of the file, and a change of the command line that needs it no more.
#[test]
fn overrides_replace_alternatives_and_tables_and_remove_keys() {
    let set = |set: &[&str]| resolve(STEEL, set).unwrap();
    assert_eq!(set(&["sphere.diameter=1 cm"]), set(&["sphere.radius=none", "sphere.diameter=1 cm"]));
    for [other, own] in alternative_pairs() {
        let quantity = NumericKey::find(own).unwrap().quantity();
        let number = quantity.parse(quantity.example.trim_matches('"')).unwrap();
        let need = if own == "impact.drop_height" { "gravity.acceleration=9.81" } else { "solver.method=auto" };
        let input = set(&[need, &format!("{own}={number}")]);
        assert_eq!((number_of_key(&input, own), number_of_key(&input, other)), (Some(number), None));
    }
    assert_eq!(set(&["half_space={ youngs_modulus = 7e10, poissons_ratio = 0.3 }"]).half_space().yield_strength, None);
    assert_eq!(set(&["half_space.yield_strength=none"]).half_space().yield_strength, None);
    assert_eq!(set(&["gravity.acceleration=9.81", "gravity=none"]), set(&[]));
    // a mistake in the file is reported at its position in the file, though the command line has moved it
    let text = STEEL.replace("\"3 m/s\"", "-3");
    let message = resolve(&text, &["sphere.radius=none", "sphere.diameter=1 cm", "law=hertz"]).unwrap_err().to_string();
    let place = 1 + text.lines().position(|line| line == "speed = -3").unwrap();
    assert!(message.starts_with(&format!("steel.toml:{place}:9: impact.speed: -3 m/s is not allowed")), "{message}");
}

#[test]
fn a_diameter_is_twice_the_radius() {
    let by_diameter = STEEL.replace("radius = \"5 mm\"", "diameter = \"10 mm\"");
    assert_eq!(resolve(&by_diameter, &[]).unwrap().sphere(), resolve(STEEL, &[]).unwrap().sphere());
}

/// Keys by how they begin, what each needs beside it, and the line of the steel scenario that it takes the place of.
const REQUIRED_LINES: [(&str, &str, &str); 19] = [
    ("sphere.mass", "sphere.mass=7", "density = \"7850 kg/m^3\"\n"),
    ("half_space.hardness", "half_space.hardness=7e9", "yield_strength = \"345 MPa\"\n"),
    ("sphere.hardness", "sphere.hardness=7e9", ""),
    ("impact.drop_height", "impact.drop_height=7", "speed = \"3 m/s\"\n"),
    // without an angle nothing slides
    ("sphere.moment_of_inertia", "impact.angle=30 deg & friction.coefficient=0.1", ""),
    ("friction.coefficient", "impact.angle=30 deg & friction.coefficient=0.1", ""),
    ("sphere.spin", "friction.coefficient=0.1", ""),
    ("impact.angle", "friction.coefficient=0.1", ""),
    // a plate needs a density, and an edge needs a plate
    ("half_space.thickness", "half_space.density=7 & half_space.thickness=7", ""),
    ("half_space.edge_distance", "half_space.density=7 & half_space.thickness=7", ""),
    ("half_space.rod_diameter", "half_space.density=7 & half_space.rod_diameter=7", ""),
    ("half_space.rod_length", "half_space.density=7 & half_space.rod_diameter=7", ""),
    ("peening.", "peening.coverage=0.25 & peening.mass_flow=7 & peening.area=7", ""),
    // what flies falls from a height
    ("air.", "impact.drop_height=7 & air.density=1 & air.drag=0.5", "speed = \"3 m/s\"\n"),
    // a key of a flow curve needs a curve of its form, a key of a rate a law of it, and for both a sphere its strength
    ("flow_stress.power", "flow_stress.power.exponent=0.1", ""),
    ("flow_stress.voce", "flow_stress.voce.saturation=2 & flow_stress.voce.rate=20", ""),
    ("flow_stress.linear", "flow_stress.linear.slope=1e9", ""),
    ("rate.cowper", "rate.cowper_symonds.rate=2 & rate.cowper_symonds.exponent=2", ""),
    ("rate.", "rate.johnson_cook.c=0.1", ""),
];

/// Finds the lines that a key needs beside it, and the line that it takes the place of.
fn required_lines(path: &str) -> (Vec<String>, &'static str) {
    let (body, rest) = path.split_once('.').unwrap();
    let is_inner = |begin: &str| ["flow_stress.", "rate."].iter().any(|table| begin.starts_with(table));
    let found = REQUIRED_LINES.iter().find(|(begin, ..)| if is_inner(begin) { rest } else { path }.starts_with(begin));
    let Some((begin, needs, without)) = found else { return (Vec::new(), "") };
    let prefix = if is_inner(begin) { format!("{body}.") } else { String::new() };
    let needs = needs.split(" & ").map(|need| format!("{prefix}{need}"));
    let strength = (prefix == "sphere.").then(|| "sphere.yield_strength=1e8".to_owned());
    (strength.into_iter().chain(needs).collect(), without)
}

#[test]
fn every_listed_key_is_read_from_file() {
    for key in NUMERIC_KEYS.iter() {
        let is_share = ["poissons_ratio", "stiffness_ratio", "power.exponent", "peening.coverage"]
            .iter()
            .any(|name| key.path().ends_with(name));
        // a value inside of the range of the key
        let value = match key.path() {
            "solver.tolerance" => 1e-3,
            "half_space.hardness" | "sphere.hardness" => 1.25e9,
            path if path.ends_with(".johnson_cook.c") => 0.125,
            _ if is_share => 0.25,
            _ => 1.25,
        };
        let (beside, without) = required_lines(key.path());
        let size = if key.path() == "sphere.radius" { "[sphere]" } else { "[sphere]\ndiameter = 1" };
        let text = STEEL.replace("radius = \"5 mm\"\n", "").replace("[sphere]", size);
        let text = if without.is_empty() { text } else { text.replace(without, "") };
        let beside: Vec<&str> = beside.iter().map(String::as_str).collect();
        let given = |more: &[&str]| resolve(&text, &[&beside, more].concat()).unwrap();
        // an angle always carries its unit
        let unit = if key.path() == "impact.angle" { " rad" } else { "" };
        let by_file = given(&[&format!("{}={value}{unit}", key.path())]);
        // a key of a law needs this law
        let law = key.path().strip_prefix("law.").and_then(|rest| rest.split('.').next()).unwrap_or("plm");
        if key.path() != "sphere.radius" {
            let mut by_key = given(&[&format!("law.{law}={{}}")]);
            key.set_exclusive(&mut by_key, value);
            assert_eq!(by_file, by_key, "{}", key.path());
        }
        assert_eq!(by_file.number(*key), Some(value), "{}", key.path());
    }
    assert_eq!(NumericKey::find("impact.speed").unwrap().column_name(), "impact_speed_m_per_s");
    assert!(NumericKey::find("solver.method").is_none());
}

/// Where the keys of a law are not given, `check` shows the values that the law takes.
#[test]
fn key_defaults_match_law_defaults() {
    for law in LawChoice::all() {
        let mut input = Input::default();
        input.named_law = law;
        let own = input.law();
        assert_eq!(input.with_derived_values().law(), own);
    }
}

#[test]
fn drop_height_sets_speed_without_gravity_in_contact() {
    let text = STEEL.replace("speed = \"3 m/s\"", "drop_height = \"0.5 m\"");
    // standard gravity of the 3rd general conference on weights and measures
    let fallen = resolve(&text, NO_OVERRIDES).unwrap();
    assert_eq!((fallen.speed(), fallen.forces().gravity), (9.80665_f64.sqrt(), None));
    let gravity = "gravity.acceleration=9.81 m/s^2";
    let scene = resolve(&text, &[gravity]).unwrap();
    // √(2 g h)
    assert_eq!(scene.speed(), 9.81_f64.sqrt());
    assert_eq!((scene.forces().gravity, number_of_key(&scene, "impact.drop_height")), (Some(9.81), Some(0.5)));
    let mut input = scene;
    NumericKey::find("gravity.acceleration").unwrap().set_exclusive(&mut input, 4.0);
    assert_eq!(input.speed(), 2.0, "the height stays");
    NumericKey::find("impact.speed").unwrap().set_exclusive(&mut input, 3.0);
    let scene = input;
    assert_eq!((scene.speed(), number_of_key(&scene, "impact.drop_height")), (3.0, None));
    assert_eq!(resolve(&text, &[gravity, "impact.drop_height=0"]).unwrap().speed(), 0.0);
    assert_eq!(scene.contact().unwrap().forces().gravity, Some(4.0));
}

#[test]
fn damping_kinds_exclude_and_gravity_pulls_down() {
    let damping = |text: &str| resolve(STEEL, &[text]).unwrap().forces().damping;
    assert_eq!(damping("damping.hunt_crossley=0.1 s/m"), Some(Damping::HuntCrossley(0.1)));
    assert_eq!(damping("damping.viscous=5 %"), Some(Damping::Viscous(0.05)));
    assert!(resolve(STEEL, &[]).unwrap().forces().is_none());
}

#[test]
fn whole_numbers_of_any_base_are_read() {
    for (speed, want) in [
        ("7", 7.0),
        ("0x10", 16.0),
        ("0b11", 3.0),
        // beyond 64 bits, and 64 bits whose hexadecimal digits are also decimal ones: 0x99.. = 11 068 046 444 225 730 969
        ("100000000000000000000", 1e20),
        ("0x9999999999999999", 11_068_046_444_225_730_969.0),
    ] {
        let text = STEEL.replace("speed = \"3 m/s\"", &format!("speed = {speed}"));
        assert_eq!(resolve(&text, &[]).unwrap().speed(), want, "{speed}");
    }
    // a text that the command line changes is TOML, which has 64 bits
    let large = STEEL.replace("\"3 m/s\"", "100000000000000000000");
    let refused = Scenario::from_text("s.toml", &large, &["sphere.spin=0".into()]).unwrap_err().to_string();
    assert!(refused.starts_with("s.toml:13:9: ") && refused.contains("100000000000000000000"), "{refused}");
}

#[test]
fn named_file_is_read_once() {
    let directory = tempfile::tempdir().unwrap();
    let path = |name: &str| directory.path().join(name);
    let curve = |stress: &str| {
        std::fs::write(path("flow.csv"), format!("plastic_strain,stress_Pa\n0.01,360e6\n0.1,{stress}\n"))
    };
    let text = STEEL.replace("[impact]", "flow_stress.table = \"flow.csv\"\n[impact]");
    std::fs::write(path("s.toml"), text).unwrap();
    curve("400e6").unwrap();
    let read = || Scenario::load(&path("s.toml"), &[]).unwrap();
    let scenario = read();
    let (scene, hash) = (scenario.resolve().unwrap(), scenario.sha256());
    curve("500e6").unwrap();
    // numbers and hash stay those of one text, and another reading gives the new ones
    assert_eq!(scenario.resolve().unwrap(), scene);
    assert_eq!(scenario.sha256(), hash);
    assert_ne!(read().resolve().unwrap(), scene);
    assert_ne!(read().sha256(), hash);
    std::fs::remove_file(path("flow.csv")).unwrap();
    assert_eq!(scenario.resolve().unwrap(), scene);
    let message = Scenario::load(&path("s.toml"), &[]).unwrap_err().to_string();
    assert!(message.contains("half_space.flow_stress.table") && message.contains("cannot be read"), "{message}");
}

#[test]
fn all_errors_are_reported_with_location() {
    let text =
        STEEL.replace("\"5 mm\"", "\"5 kg\"").replace("speed =", "sped =").replace("[half_space]", "[halfspace]");
    let message = Scenario::from_text("steel.toml", &text, &["solver.tolerance=7".into()]).unwrap_err().to_string();
    let places = [
        "steel.toml:2:10: sphere.radius: \"5 kg\" is a mass, but a length is needed",
        "steel.toml:7:2: halfspace: unknown table `halfspace`, did you mean `half_space`?",
        "steel.toml:13:1: impact.sped: unknown key `sped`, did you mean `speed`?",
        "--set solver.tolerance=7: solver.tolerance: 7 is not allowed",
    ];
    let found: Vec<usize> =
        places.iter().map(|place| message.find(place).unwrap_or_else(|| panic!("{message}"))).collect();
    assert!(found.is_sorted(), "{message}");
    // a mark under each that is in the file
    assert_eq!(message.lines().filter(|line| line.trim_end().ends_with('^')).count(), 3, "{message}");

    let many = (0..24).fold(String::new(), |text, i| text + &format!("x{i} = 1\n"));
    let many = STEEL.replace("radius", &format!("{many}radius"));
    let message = resolve(&many, &[]).unwrap_err().to_string();
    assert_eq!(message.matches("unknown key").count(), 20, "{message}");
    assert!(message.ends_with("and 4 more mistakes"), "{message}");
}

#[test]
fn the_hash_is_of_text_overrides_and_coefficients() {
    let directory = tempfile::tempdir().unwrap();
    let coefficients = directory.path().join("my.toml");
    let built_in = include_str!("../../../src/contact/law/plm/coefficients.toml");
    let file = directory.path().join("scenario.toml");
    let hash = |text: &str, overrides: &[&str], table: &str| {
        std::fs::write(&file, text).unwrap();
        std::fs::write(&coefficients, table).unwrap();
        Scenario::load(&file, &Override::list(overrides)).unwrap().sha256()
    };
    let plain = hash(STEEL, &[], built_in);
    assert_eq!(plain.len(), 64);
    assert_eq!(plain, hash(STEEL, &[], built_in));
    assert_ne!(plain, hash(&format!("{STEEL}\n"), &[], built_in));
    assert_ne!(plain, hash(STEEL, &["impact.speed=3"], built_in));
    assert_ne!(hash(STEEL, &["impact.speed=3"], built_in), hash(STEEL, &["impact.speed=4"], built_in));
    // a file of coefficients changes the hash only if the scenario names it
    let changed = format!("# mine\n{built_in}");
    assert_eq!(plain, hash(STEEL, &[], &changed));
    let named = format!("{STEEL}\n[law.plm]\ncoefficients = \"my.toml\"\n");
    assert_ne!(hash(&named, &[], built_in), hash(&named, &[], &changed));
}

/// That they run, and to which numbers, is in tests/regression.
#[test]
fn shipped_scenarios_have_a_comment_and_no_warning() {
    let mut checked = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let scenario = Scenario::load(&path, &[]).unwrap();
            assert!(scenario.document.original_text().starts_with("# "), "{}", path.display());
            let warnings = plm_impact::report::run::check(&scenario).unwrap().warnings;
            // a table may have rows beyond the range of the law
            let is_table = matches!(scenario.kind().unwrap(), Kind::Sweep | Kind::MonteCarlo);
            assert!(is_table || warnings.is_empty(), "{}: {warnings:?}", path.display());
            checked += 1;
        }
    }
    assert!(checked > 15, "{checked}");
}

/// Values, names and rules: all mistakes of a file are reported at once, and programs get each of them.
#[test]
fn all_mistakes_of_file_are_reported() {
    let text = "[sphere]\nradius = \"5 mm\"\ndiameter = \"10 mm\"\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.7\n\
                [half_space]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\nedge_distance = \"5 cm\"\n\
                [impact]\nspeed = 1\ndrop_height = 1\nangle = \"10 deg\"\n";
    let error = Scenario::from_text("many.toml", text, &[]).unwrap_err();
    let told = error.to_string();
    let mistakes = [
        "many.toml:5:18: sphere.poissons_ratio: 0.7 is not allowed",
        "`radius` and `diameter` exclude each other",
        "`speed` and `drop_height` exclude each other",
        "half_space.edge_distance: applies to plates only",
        "impact.angle: requires [friction]",
        "the key `density` is missing",
    ];
    for mistake in mistakes {
        assert!(told.contains(mistake), "{mistake} is not in\n{told}");
    }
    assert_eq!(error.details.more_errors.len(), mistakes.len() - 1, "{told}");
    let keys: Vec<&str> = error.details.more_errors.iter().filter_map(|other| other.key.as_deref()).collect();
    assert!(keys.contains(&"half_space.edge_distance") && keys.contains(&"impact.angle"), "{keys:?}");
    // so are those that only the numbers of both bodies together show
    let text = STEEL.replace("[impact]", "radius = 0\n[gravity]\nacceleration = 9.81\n[air]\ndensity = 1.2\n[impact]");
    let told = resolve(&text, &[]).unwrap_err().to_string();
    assert!(told.contains("half_space.radius: must not be 0") && told.contains("the key `drag` is missing"), "{told}");
    // a value of a misspelt material is not reported as missing
    let materials = "[sphere]\nradius = \"5 mm\"\nmaterial = \"steel-52100-hardend\"\n[half_space]\nmaterial = \"steel-s2355\"\n\
                     [impact]\nspeed = 1\n";
    let error = Scenario::from_text("two.toml", materials, &[]).unwrap_err();
    assert_eq!(error.details.more_errors.len(), 1, "{error}");
    assert!(!error.to_string().contains("missing"), "{error}");
}
