//! Values of a wrong type: the refusal uses the words of a scenario, not those of the parser.

use serde::Deserialize;

use crate::common::prelude::*;

/// `value_types.toml`
#[derive(Deserialize)]
struct Types {
    /// Words of the parser that do not occur in scenarios.
    foreign: Vec<String>,
    wrong: Vec<String>,
    scene: Vec<Keys>,
}

/// Tables of a scenario, and keys whose value is `@`.
#[derive(Deserialize)]
struct Keys {
    tables: String,
    keys: Vec<String>,
}

/// Reads all parts of a scenario, without running it.
fn read_all_parts(text: &str, change: &str) -> Result<(), Error> {
    let scenario = Scenario::from_text("steel.toml", text, &[change.into()])?;
    match scenario.kind()? {
        Kind::Indentation => scenario.indentation().map(drop),
        Kind::Sweep | Kind::MonteCarlo => scenario.plan().map(drop),
        Kind::Calibrate => scenario.calibration_request().map(drop),
        Kind::Impact => scenario.resolve().map(drop),
        Kind::Repeat => scenario.resolve().and_then(|scene| scenario.series(&scene)).map(drop),
    }
}

#[test]
fn no_word_of_the_parser_reaches_a_user() {
    let types: Types = toml::from_str(include_str!("../value_types.toml")).unwrap();
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let mut refused = 0;
    for scene in &types.scene {
        let has_impact = !scene.tables.contains("[indentation]");
        for key in &scene.keys {
            let bodies = if has_impact { STEEL } else { &still };
            // half-spaces of a list take the place of the table
            let bodies = if key.contains("name=@") { still.split("[half_space]").next().unwrap() } else { bodies };
            let text = format!("{bodies}{}", scene.tables);
            let mut of_key = 0;
            for wrong in &types.wrong {
                let change = key.replace('@', wrong);
                let Err(error) = read_all_parts(&text, &change) else { continue };
                of_key += 1;
                // the quoted input does not count as a word of the parser
                let own = error.to_string().replace(&change, "");
                let word = types.foreign.iter().find(|word| own.contains(word.as_str()));
                assert_eq!(word, None, "{change}: {error}");
            }
            assert!(of_key >= 5, "{key}: only {of_key} of {} refused", types.wrong.len());
            refused += of_key;
        }
    }
    assert!(refused > 1000, "{refused}");
}

#[test]
fn too_many_steps_does_not_suggest_same_method() {
    let message = IntegrationError::TooManySteps { steps: 9 }.to_string();
    assert!(message.contains("Increase solver.tolerance") && message.contains("\"auto\""), "{message}");
    assert!(!message.contains("rk8"), "{message}");
}

#[test]
fn override_replaces_law_of_file() {
    let law = |own: &str, changes: &[&str]| {
        let scenario = Scenario::from_text("steel.toml", &format!("{STEEL}{own}"), &Override::list(changes));
        scenario
            .and_then(|scenario| scenario.resolve())
            .map(|scene| format!("{:?}", scene.law()))
            .map_err(|e| e.to_string())
    };
    let in_file = |own: &str| law(own, &[]).unwrap();
    let plm = "[law.plm]\nunloading_exponent = 1.6\n";
    let thornton = "[law.thornton]\nyield_pressure = 7e8\n";
    assert_ne!(in_file(plm), in_file(thornton));
    for own in ["", plm, "[law.hertz]\n", "[law.combined]\nloading = \"plm\"\nunloading = \"brake\"\n"] {
        assert_eq!(law(own, &["law.thornton.yield_pressure=700 MPa"]).unwrap(), in_file(thornton), "{own}");
        assert_eq!(law(own, &["law=thornton"]).unwrap(), in_file("[law.thornton]\n"), "{own}");
        assert_eq!(law(own, &["law={ thornton = { yield_pressure = 7e8 } }"]).unwrap(), in_file(thornton), "{own}");
        let combined = in_file("[law.combined]\nloading = \"jackson_green\"\nunloading = \"brake\"\n");
        assert_eq!(law(own, &["law=jackson_green + brake"]).unwrap(), combined, "{own}");
        // the last override counts
        assert_eq!(law(own, &["law=stronge", "law=hertz"]).unwrap(), in_file("[law.hertz]\n"), "{own}");
    }
    // keys of the same law are kept
    assert_eq!(law(thornton, &["law=thornton"]).unwrap(), in_file(thornton));
}
