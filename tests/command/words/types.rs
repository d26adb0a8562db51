//! Values of a wrong type: the refusal uses the words of a scenario, not those of the parser.

use plm_impact::integrate::IntegrationError;
use plm_impact::scenario::{Kind, Scenario, ScenarioError};

use crate::common::STEEL;

/// Words of the parser that do not occur in scenarios.
const FOREIGN: [&str; 32] = [
    "untagged",
    "enum",
    "variant",
    "invalid type",
    "invalid value",
    "invalid length",
    "did not match",
    "struct",
    "tuple",
    "newtype",
    "sequence",
    " map",
    "u64",
    "u32",
    "u16",
    "i64",
    "i128",
    "f64",
    "usize",
    "boolean",
    "floating",
    "string",
    "integer",
    "visitor",
    "identifier",
    "unit value",
    "missing field",
    "unknown field",
    "wanted",
    "deserializ",
    "Some(",
    "expected any",
];

const WRONG: [&str; 20] = [
    "true",
    "3",
    "-3",
    "2.5",
    "nan",
    "inf",
    "\"word\"",
    "\"\"",
    "[]",
    "[true]",
    "[[1]]",
    "[{}]",
    "{}",
    "{ x = 1 }",
    "1979-05-27",
    "12:30:00",
    "99999999999999999999",
    "\"3 kg\"",
    "[\"word\"]",
    "[1979-05-27]",
];

/// Reads all parts of a scenario, without running it.
fn understood(text: &str, change: &str) -> Result<(), ScenarioError> {
    let scenario = Scenario::from_text("steel.toml", text, &[change.to_owned()])?;
    match scenario.kind()? {
        Kind::Indentation => scenario.indentation().map(drop),
        Kind::Compare => scenario.comparison().map(drop),
        Kind::Sweep | Kind::MonteCarlo => scenario.plan().map(drop),
        Kind::Calibrate => scenario.wanted().map(drop),
        Kind::Impact => scenario.resolve().map(drop),
        Kind::Repeat => scenario.resolve().and_then(|scene| scenario.repeat(&scene)).map(drop),
    }
}

/// Tries every wrong value in place of `@`, and returns how many were refused.
fn tried(text: &str, key: &str) -> usize {
    let mut refused = 0;
    for wrong in WRONG {
        let change = key.replace('@', wrong);
        let Err(error) = understood(text, &change) else { continue };
        refused += 1;
        let message = error.to_string();
        // the quoted input does not count as a word of the parser
        let own = message.replace(&change, "");
        for word in FOREIGN {
            assert!(!own.contains(word), "{change}: \"{word}\" in\n{message}");
        }
    }
    refused
}

/// Keys that a scenario of one impact reads.
const OF_ONE_IMPACT: [&str; 47] = [
    "sphere=@",
    "half_space=@",
    "impact=@",
    "law=@",
    "solver=@",
    "output=@",
    "gravity=@",
    "damping=@",
    "sweep=@",
    "monte_carlo=@",
    "repeat=@",
    "compare=@",
    "indentation=@",
    "sphere.radius=@",
    "sphere.diameter=@",
    "sphere.youngs_modulus=@",
    "sphere.poissons_ratio=@",
    "sphere.density=@",
    "sphere.yield_strength=@",
    "half_space.youngs_modulus=@",
    "half_space.poissons_ratio=@",
    "half_space.yield_strength=@",
    "half_space.density=@",
    "impact.speed=@",
    "impact.drop_height=@",
    "gravity.acceleration=@",
    "damping.viscous=@",
    "damping.hunt_crossley=@",
    "solver.method=@",
    "solver.tolerance=@",
    "solver.steps_per_contact=@",
    "output.samples=@",
    "output.columns=@",
    "law.plm=@",
    "law.hertz=@",
    "law.plm.unloading_exponent=@",
    "law.plm.coefficients=@",
    "law.thornton.yield_pressure=@",
    "law.stronge.unloading_factor=@",
    "law.jackson_green.hardness=@",
    "law.jackson_green.jumps=@",
    "law.ma_liu.transition_ratio=@",
    "law.mesarovic_johnson.area_factor=@",
    "law.walton_braun.stiffness_ratio=@",
    "law.combined=@",
    "law.combined.loading=@",
    "law.combined={loading=@}",
];

#[test]
fn no_word_of_the_parser_reaches_a_user() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let gravity = "[gravity]\nacceleration = 9.81\n";
    let press = format!("{still}[indentation]\nsteps = [{{ load = 1 }}]\n");
    let compare = format!("{still}[compare]\npeak_indentation_ratio = 50\n");
    let random = format!("{STEEL}[monte_carlo]\nsamples = 3\n\"sphere.radius\" = {{ uniform = [1, 2] }}\n");
    let sweep = format!("{STEEL}[sweep]\n\"sphere.radius\" = [1]\n");
    let bounce = format!("{STEEL}{gravity}[repeat]\nimpacts = 3\nspot = \"same\"\n");
    let scenes: [(&str, &[&str]); 7] = [
        (STEEL, &OF_ONE_IMPACT),
        (
            &sweep,
            &[
                "sweep.law=@",
                "sweep.\"solver.method\"=@",
                "sweep.\"impact.speed\"=@",
                "sweep.\"impact.speed\"=[1, @]",
                "sweep.\"impact.speed\"={linspace=@, points=3}",
                "sweep.\"impact.speed\"={linspace=[1, @], points=3}",
                "sweep.\"impact.speed\"={logspace=[1, 2], points=@}",
                "sweep.law=[@]",
                "sweep.\"solver.method\"=[@]",
                "output.columns=@",
            ],
        ),
        (
            &random,
            &[
                "monte_carlo.samples=@",
                "monte_carlo.seed=@",
                "monte_carlo.\"impact.speed\"=@",
                "monte_carlo.\"impact.speed\"={uniform=@}",
                "monte_carlo.\"impact.speed\"={normal=@}",
                "monte_carlo.\"impact.speed\"={normal={mean=@, sd=1}}",
                "monte_carlo.\"impact.speed\"={lognormal={mean=1, sd=@}}",
            ],
        ),
        (
            &bounce,
            &["repeat.impacts=@", "repeat.spot=@", "repeat.until=@", "repeat.until={speed=@}", "repeat.speeds=@"],
        ),
        (
            &compare,
            &["compare.peak_indentation_ratio=@", "compare.peak_force=@", "compare.spent_work=@", "compare.laws=@"],
        ),
        (
            &press,
            &[
                "indentation.steps=@",
                "indentation.steps=[@]",
                "indentation.steps=[{load=@}]",
                "indentation.half_space=@",
            ],
        ),
        (
            &press.replace("[half_space]", "[[indentation.half_space]]"),
            &["indentation.half_space=[{name=@, youngs_modulus=1e11, poissons_ratio=0.3}]"],
        ),
    ];
    let mut refused = 0;
    for (text, keys) in scenes {
        for key in keys {
            let of_key = tried(text, key);
            assert!(of_key >= 5, "{key}: only {of_key} of {} refused", WRONG.len());
            refused += of_key;
        }
    }
    assert!(refused > 1000, "{refused}");
}

#[test]
fn a_spread_of_a_wrong_kind_is_told_what_it_should_be() {
    let random =
        format!("{STEEL}[monte_carlo]\nsamples = 3\n\"impact.speed\" = {{ normal = {{ mean = 3, sd = true }} }}\n");
    let message = Scenario::from_text("steel.toml", &random, &[]).unwrap_err().to_string();
    assert!(message.contains("found `true`, expected a standard deviation (sd) such as \"3 m/s\""), "{message}");
}

#[test]
fn a_run_out_of_steps_is_not_sent_to_the_method_that_ran_out() {
    let message = IntegrationError::TooManySteps { steps: 9 }.to_string();
    assert!(message.contains("loosen the tolerance") && message.contains("\"auto\""), "{message}");
    assert!(!message.contains("rk8"), "{message}");
}

#[test]
fn an_override_takes_the_place_of_the_law_of_the_file() {
    let law = |own: &str, changes: &[&str]| {
        let changes: Vec<String> = changes.iter().map(ToString::to_string).collect();
        let scenario = Scenario::from_text("steel.toml", &format!("{STEEL}{own}"), &changes);
        scenario
            .and_then(|scenario| scenario.resolve())
            .map(|scene| format!("{:?}", scene.law))
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
    // an unknown law is refused with the place where it was given
    let message = law(plm, &["law=thorton"]).unwrap_err();
    assert!(
        message.starts_with("--set law=thorton: law.thorton: unknown law `thorton`, did you mean `thornton`?"),
        "{message}"
    );
    let message = law(plm, &["law={ plm = {}, hertz = {} }"]).unwrap_err();
    assert!(message.contains("exactly one law, found plm and hertz"), "{message}");
    let message = law(plm, &["law=3"]).unwrap_err();
    assert!(message.contains("law: not a table"), "{message}");
}
