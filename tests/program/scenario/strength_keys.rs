//! `sphere.mass`, `half_space.hardness` and `[half_space.flow_stress]`: the scenes of scenarios with them.

use plm_impact::scenario::input::Input;

use plm_impact::validate::comparison;

use crate::common::prelude::*;

fn input_of(text: &str) -> Input {
    Scenario::from_text("s.toml", text, &[]).unwrap().resolve().unwrap()
}

fn with_mass(mass: &str) -> String {
    STEEL.replace("density = \"7850 kg/m^3\"", &format!("mass = {mass}"))
}

fn with_hardness(hardness: &str) -> String {
    STEEL.replace("yield_strength = \"345 MPa\"", &format!("hardness = {hardness}"))
}

fn with_flow(flow: &str) -> String {
    STEEL.replace("[impact]", &format!("[half_space.flow_stress]\n{flow}\n[impact]"))
}

fn restitution(scene: &Input) -> f64 {
    scene.contact().unwrap().closed_form(scene.speed()).unwrap().row.restitution
}

#[test]
fn mass_replaces_density() {
    // 4/3 π (5 mm)³ 7850 kg/m³
    let grams = 4.0 / 3.0 * std::f64::consts::PI * 0.125 * 7.85;
    let by_mass = input_of(&with_mass(&format!("\"{grams} g\"")));
    assert!(relative_error(restitution(&by_mass), restitution(&input_of(STEEL))) < 1e-14);
    assert!(relative_error(by_mass.contact().unwrap().mass(), 1e-3 * grams) < 1e-14);
    // the mass does not change with the radius
    let text = format!("{}[sweep]\n\"sphere.radius\" = [\"1 mm\", \"5 mm\"]\n", with_mass("0.004"));
    let plan = Scenario::from_text("s.toml", &text.replace("radius = \"5 mm\"\n", ""), &[]).unwrap().plan().unwrap();
    let mut one = plan.input.clone();
    for radius in [1e-3, 5e-3, 2e-3] {
        NumericKey::find("sphere.radius").unwrap().set_exclusive(&mut one, radius);
        assert!(relative_error(one.contact().unwrap().mass(), 0.004) < 1e-14);
    }
}

/// The strengths are those of another program, which searches for the indentation of the law by halving. HB 285 and HRC 29.8 are
/// HV 300 in DIN 50150.
#[test]
fn hardness_replaces_yield_strength() {
    for (hardness, wanted) in [
        ("\"300 HV\"", 1_153_797_625.732_568_5),
        ("\"285 HB\"", 1_153_797_625.732_568_5),
        ("\"29.8 HRC\"", 1_153_797_625.732_568_5),
        ("\"60.1 HRC\"", 3_013_390_789.322_441),
    ] {
        let strength = input_of(&with_hardness(hardness)).half_space().yield_strength.unwrap();
        assert!(relative_error(strength, wanted) < 1e-11, "{hardness}: {strength}");
    }
    // as a column of a table, whose e is that of these strengths; HRC 40.8 is HV 400
    let table = Sandbox::with_results(
        with_hardness("\"300 HV\"") + "[sweep]\n\"half_space.hardness\" = [\"200 HV\", \"40.8 HRC\"]\n",
    );
    let table = table.read("out/table.csv");
    let [strengths, e] = ["half_space_yield_strength_Pa", "restitution"].map(|name| numbers(&table, name));
    for ((got, e), wanted) in strengths.iter().zip(e).zip([749_271_039.306_507_1, 1_581_299_156.517_662]) {
        let alone = input_of(&STEEL.replace("\"345 MPa\"", &format!("{got:e}")));
        assert!(relative_error(*got, wanted) < 1e-11 && relative_error(e, restitution(&alone)) < 1e-14, "{got} {e}");
    }
    // also in scenes without an impact
    let still = |table: &str| with_hardness("\"1.000122020840274 GPa\"").replace("[impact]\nspeed = \"3 m/s\"", table);
    let pressed = Scenario::from_text("s.toml", &still("[indentation]\nsteps = [{ load = \"1 kN\" }]"), &[]).unwrap();
    let specimens = pressed.indentation().unwrap().specimens;
    assert!(relative_error(specimens[0].half_space.yield_strength.unwrap(), 345e6) < 1e-11);
    for pressure in ["\"3 GPa\"", "3e9"] {
        assert!(
            relative_error(
                input_of(&with_hardness(pressure)).half_space().yield_strength.unwrap(),
                1_086_092_343.417_381_5
            ) < 1e-11
        );
    }
}

#[test]
fn hardness_with_exponent_holds_at_strain_0_08() {
    let text = with_hardness("\"300 HV\"")
        .replace("[impact]", "[half_space.flow_stress]\npower = { exponent = 0.1 }\n[impact]");
    let scene = input_of(&text);
    let strength = scene.half_space().yield_strength.unwrap();
    assert!(relative_error(strength, 852_118_419.191_218_5) < 1e-10, "{strength}");
    // the same after a change of the modulus
    let mut changed = scene;
    NumericKey::find("half_space.youngs_modulus").unwrap().set_exclusive(&mut changed, 100e9);
    let strength = changed.half_space().yield_strength.unwrap();
    assert!(relative_error(strength, 1_020_803_430.849_911_6) < 1e-10, "{strength}");
}

#[test]
fn every_form_of_a_flow_curve_is_read() {
    let flow = |text: &str| match input_of(&with_flow(text)).law() {
        LawChoice::Plm(plm) => plm.flow[1].clone(),
        _ => None,
    };
    assert_eq!(flow("power = { exponent = 0.1 }"), Some(FlowCurve::Power { exponent: 0.1 }));
    assert_eq!(flow("voce = { saturation = 1.5, rate = 15 }"), Some(FlowCurve::Voce { saturation: 1.5, rate: 15.0 }));
    assert_eq!(flow("linear = { slope = \"4.2 GPa\" }"), Some(FlowCurve::Linear { slope: 4.2e9 }));
    let points = flow("points = [[0.002, \"350 MPa\"], [0.01, 400e6]]");
    assert!(
        matches!(&points, Some(FlowCurve::Points(points)) if points.len() == 2 && points[1].stress == 4e8),
        "{points:?}"
    );
}

#[test]
fn flow_curve_table_is_read_beside_scenario() {
    let desk = Sandbox::with(with_flow("table = \"flow.csv\""));
    let file = desk.path("flow.csv");
    fs::write(&file, "# steel\nplastic_strain, stress_Pa\n0.002, 350e6\n0.01, 400e6\n").unwrap();
    let (_, said) = desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "none"], 0);
    assert!(said.contains("The flow curve ends at a plastic strain of 0.01"), "{said}");
}

#[test]
fn every_number_is_axis_and_random_variable() {
    let base = with_flow("power = { exponent = 0.1 }");
    for (text, key, values) in [
        (with_mass("\"4 g\""), "sphere.mass", "[\"3 g\", \"5 g\"]"),
        (with_hardness("\"300 HV\""), "half_space.hardness", "[\"200 HV\", \"30 HRC\"]"),
        (base, "half_space.flow_stress.power.exponent", "[0.1, 0.3]"),
        (with_flow("voce = { saturation = 1, rate = 10 }"), "half_space.flow_stress.voce.saturation", "[0.5, 2]"),
        (with_flow("voce = { saturation = 1, rate = 10 }"), "half_space.flow_stress.voce.rate", "[5, 20]"),
        (with_flow("linear = { slope = 1e9 }"), "half_space.flow_stress.linear.slope", "[\"1 GPa\", \"2 GPa\"]"),
    ] {
        let table = Sandbox::with_results(format!("{text}[sweep]\n\"{key}\" = {values}\n")).read("out/table.csv");
        let e = numbers(&table, "restitution");
        assert!(e.len() == 2 && table.lines().next().unwrap().contains(&key.replace('.', "_")), "{table}");
        assert!((e[0] - e[1]).abs() > 1e-3, "{key}: {table}");
        let drawn = format!("{text}[monte_carlo]\nsamples = 20\n\"{key}\" = {{ uniform = {values} }}\n");
        assert!(Scenario::from_text("s.toml", &drawn, &[]).unwrap().plan().is_ok());
    }
}

/// Quenched steels by Leeb's device D against their Vickers hardness: HV = 0.00264169 L² - 1.900271 L + 519.8346 with
/// L = 1000 e. This is T. Foale's fit, that of a hobbyist, to a table of conversion for steels that are not austenitic, which he
/// does not name; the one row of ASTM E140 that could be read agrees within 1.4 %. Against it e by the hardness is too low at
/// every hardness, by as much as the guide says. With a rate of c = 0.006, which is no fit but a value between those of 4340 and of
/// hard steels, it is right in the mean.
#[test]
fn e_of_quenched_steels_is_biased_low() {
    let leeb = include_str!("../../../scenarios/leeb-d.toml");
    let guide = include_str!("../../../scenarios/README.md");
    let bias = |rate: &[&str]| -> Vec<f64> {
        let of = |number: u16| {
            let leeb_number = f64::from(number);
            let vickers = 0.002_641_69 * leeb_number * leeb_number - 1.900_271 * leeb_number + 519.8346;
            let hardness = format!("half_space.hardness={vickers} HV");
            let impact = contact(leeb, &[&[&*hardness][..], rate].concat()).closed_form(2.0).unwrap();
            100.0 * (1e3 * impact.row.restitution_with_waves().unwrap() / leeb_number - 1.0)
        };
        (500..=860).step_by(20).map(of).collect()
    };
    let ends = |bias: &[f64]| [f64::max, f64::min].map(|pick| bias.iter().copied().reduce(pick).unwrap());
    let slow = bias(&[]);
    let [least, most] = ends(&slow);
    assert!(comparison::mean(&slow).abs() < 3.5 && most > -5.0 && least < 0.0, "{slow:?}");
    let row = format!("| quenched steels, without strain-rate keys: too low by {:.1} to {:.1} %", -least, -most);
    assert!(guide.contains(&row), "{row}");
    let fast = bias(&["half_space.rate.johnson_cook.c=0.006"]);
    assert!(comparison::mean(&fast).abs() < 1.5, "{fast:?}");
    // by range of hardness, as the guide says
    let [soft, hard] = [&fast[..8], &fast[8..]].map(comparison::mean);
    let row = format!("on average {:.1} % too low below 400 HV, and {:.1} % too high above", -soft, hard);
    assert!(guide.contains(&row), "{row} {fast:?}");
}

/// The scenario of the Leeb device against an energy balance in an independent Python program, with the law of section
/// 4 and n(Λ): 11 mJ on the strength of 300 HV by the built-in law. The metal that hardens has a strength from elsewhere.
#[test]
fn the_leeb_scenario_rebounds_as_calculated_elsewhere() {
    let file = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/leeb-d.toml"));
    let nine_pieces =
        [concat!("law.plm.coefficients=", env!("CARGO_MANIFEST_DIR"), "/tests/reference/coefficients-9.toml")];
    let leeb = Scenario::load(file, &Override::list(&nine_pieces)).unwrap().resolve().unwrap();
    assert!(relative_error(restitution(&leeb), 0.552_105_882_113_3) < 1e-8, "{}", restitution(&leeb));
    // the same for a metal that hardens with the exponent 0.1
    let text = fs::read_to_string(file).unwrap() + "[half_space.flow_stress]\npower = { exponent = 0.1 }\n";
    let text = text.replace("hardness = \"300 HV\"", "yield_strength = 803547686.0702806");
    let hardening = crate::common::scene(&text, &nine_pieces);
    assert!(relative_error(restitution(&hardening), 0.513_146_638_758_511_5) < 1e-8, "{}", restitution(&hardening));
}

/// At these loads a simulated Brinell test gives 11 to 15 % more than the number typed, as scenarios/trust.md explains. The parts: the
/// table of ISO 18265 (HV = 1.05 HB), the faces of the pyramid over their projection (1/0.9272), and the area of the cap.
#[test]
fn simulated_brinell_test_reads_high() {
    for (hardness, load) in [(130.0, 500.0), (130.0, 1000.0), (200.0, 1500.0), (300.0, 3000.0), (400.0, 3000.0)] {
        let steps = format!("[indentation]\nsteps = [{{ load = \"{load} kgf\" }}]\n");
        let bodies = format!(
            "[sphere]\ndiameter = \"10 mm\"\nyoungs_modulus = \"600 GPa\"\npoissons_ratio = 0.23\n\
             [half_space]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\nhardness = \"{hardness} HB\"\n"
        );
        let desk = Sandbox::with_results(bodies + &steps);
        let radius = desk.summary()["half_spaces"][0]["steps"][0]["peak_contact_radius_m"].as_f64().unwrap() * 1e3;
        assert!(radius < 0.45 * 5.0, "{radius}");
        let area = std::f64::consts::PI * radius * radius;
        let cap = 10.0 * std::f64::consts::PI * (5.0 - (25.0 - radius * radius).sqrt());
        let tested = load / cap / hardness;
        assert!((1.105..1.155).contains(&tested), "{hardness} HB: {tested}");
        assert!((tested * cap / area / (1.05 / 0.9272) - 1.0).abs() < 0.025, "{hardness} HB: {}", tested * cap / area);
    }
}
