//! `inputs` of a summary: all values that follow from the scenario.

use serde_json::{Value, json};

use crate::common::STEEL;
use crate::common::command::Desk;

fn inputs(scene: &str) -> Value {
    Desk::ran(scene).summary()["inputs"].clone()
}

fn holds(inputs: &Value, wanted: &Value) {
    for (key, value) in wanted.as_object().unwrap() {
        assert_eq!(&inputs[key], value, "{key} in {inputs}");
    }
}

/// Tables that make the scene a scenario of each kind with impacts.
const KINDS: [&str; 4] = [
    "",
    "[sweep]\n\"sphere.density\" = [7000, 8000]\n",
    "[monte_carlo]\nsamples = 2\n\"sphere.density\" = { uniform = [7000, 8000] }\n",
    "[repeat]\nimpacts = 2\nspot = \"fresh\"\n",
];

#[test]
fn every_kind_lists_the_parameters_of_its_law() {
    for kind in KINDS {
        let thornton = format!("{STEEL}[law.thornton]\nyield_pressure = \"700 MPa\"\n{kind}");
        holds(&inputs(&thornton), &json!({ "law": "thornton", "law_thornton_yield_pressure_Pa": 7e8 }));
        let green = "[law.jackson_green]\nhardness = \"cosine\"\n";
        let green = inputs(&format!("{STEEL}{green}{kind}"));
        holds(&green, &json!({ "law": "jackson_green", "law_jackson_green_hardness": "cosine" }));
        let shape = inputs(&format!("{STEEL}[law.plm]\nunloading_exponent = \"pressure-shape\"\n{kind}"));
        holds(&shape, &json!({ "law_plm_unloading_exponent": "pressure-shape" }));
        assert!(shape["law_plm_coefficients"].is_string(), "{shape}");
        // a parameter that is not given has its default: 1.1 in the documentation of the law
        holds(&inputs(&format!("{STEEL}[law.stronge]\n{kind}")), &json!({ "law_stronge_yield_pressure_ratio": 1.1 }));
    }
}

#[test]
fn every_kind_lists_fall_forces_and_solver() {
    let fall = STEEL.replace("speed = \"3 m/s\"", "drop_height = \"20 cm\"");
    for kind in KINDS {
        let tables = "[gravity]\nacceleration = 9.81\n[damping]\nhunt_crossley = 0.1\n";
        let solver = "[solver]\nmethod = \"dopri5\"\ntolerance = 1e-7\n";
        let got = inputs(&format!("{fall}{tables}{solver}{kind}"));
        let speed = (2.0 * 9.81 * 0.2_f64).sqrt();
        holds(&got, &json!({ "impact_drop_height_m": 0.2, "gravity_acceleration_m_per_s2": 9.81 }));
        holds(
            &got,
            &json!({ "damping_hunt_crossley_s_per_m": 0.1, "solver_method": "dopri5", "solver_tolerance": 1e-7 }),
        );
        approx::assert_relative_eq!(got["impact_speed_m_per_s"].as_f64().unwrap(), speed, max_relative = 1e-15);
    }
    for kind in &KINDS[..3] {
        let got = inputs(&format!("{STEEL}[solver]\nmethod = \"verlet\"\nsteps_per_contact = 77\n{kind}"));
        holds(&got, &json!({ "solver_method": "verlet", "solver_steps_per_contact": 77 }));
    }
}

#[test]
fn only_a_plate_says_how_a_plate_gives_way() {
    assert!(inputs(STEEL).get("half_space_plate").is_none());
    let plate = STEEL.replace("[half_space]\n", "[half_space]\ndensity = 7850\nthickness = \"20 mm\"\n");
    holds(&inputs(&plate), &json!({ "half_space_plate": "zener" }));
}

#[test]
fn a_table_of_laws_lists_the_parameters_of_each_and_of_no_other() {
    let scene = format!("{STEEL}[law.thornton]\nyield_pressure = 7e8\n[sweep]\nlaw = [\"thornton\", \"stronge\"]\n");
    let got = inputs(&scene);
    holds(&got, &json!({ "law_thornton_yield_pressure_Pa": 7e8, "law_stronge_unloading_factor": 1.0 }));
    let names: Vec<&String> = got.as_object().unwrap().keys().filter(|key| key.starts_with("law")).collect();
    assert!(!names.iter().any(|name| *name == "law" || name.contains("plm")), "{names:?}");
    // keys that vary are in the table, not in the inputs
    let got = inputs(&format!("{STEEL}[sweep]\n\"law.plm.unloading_exponent\" = [1.5, 1.6]\n"));
    assert!(got.get("law_plm_unloading_exponent").is_none() && got["law"] == "plm", "{got}");
}

#[test]
fn scenes_without_an_impact_list_theirs() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "").replace("density = \"7850 kg/m^3\"\n", "");
    let law = "[law.plm]\nunloading_exponent = 1.6\n";
    let common = json!({
        "sphere_radius_m": 0.005, "sphere_youngs_modulus_Pa": 210e9, "sphere_poissons_ratio": 0.3,
        "law_plm_unloading_exponent": 1.6,
    });
    let pressed = inputs(&format!("{still}{law}[indentation]\nsteps = [{{ load = 100 }}]\n[output]\nsamples = 50\n"));
    holds(&pressed, &common);
    holds(&pressed, &json!({ "output_samples": 50 }));
}
