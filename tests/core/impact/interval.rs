//! The interval of e: the law's own part, and what is known of the strengths of materials.

use std::path::Path;

use plm_impact::scenario::keys::interval::law_error::{BodyClass, EXPONENTS, law_error_table};
use plm_impact::scenario::keys::{RestitutionInterval, restitution_interval};
use plm_impact::validate::coverage;
use plm_impact::validate::law_error::{cycle_errors, law_errors_csv};

use crate::common::golden::assert_golden;
use crate::common::prelude::*;

/// The table that the program uses is the one that follows from the rows of `validate`.
#[test]
fn law_error_table_matches_finite_elements() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/scenario/keys/interval/law_errors.csv");
    assert_golden(&path, law_errors_csv(PlmCoefficients::built_in()).unwrap());
}

/// Over all load cycles and impacts of the finite elements, and over those of each class, the law's part holds at least 90 %.
#[test]
fn law_error_holds_the_finite_elements() {
    for one in coverage::load_cycles().unwrap() {
        assert!(one.share() >= 0.9 && one.inside >= 12, "{one:?}");
    }
    for (_, name) in EXPONENTS {
        // an interval of e this wide still says something, and up to a/R = 0.3 the exponent of the paper is low on one side
        for row in law_error_table().iter().filter(|row| row.exponent == name) {
            assert!(row.high - row.low < 0.08 && row.low <= row.mean && row.mean <= row.high, "{row:?}");
            let is_shallow = row.max_radius_ratio == 0.3 && row.class != BodyClass::OtherPoissonsRatio;
            assert!(name != "paper" || !is_shallow || row.high < 0.0, "{row:?}");
        }
    }
}

/// The interval of an input at its own speed, with the restitution that is measured and the impact.
fn interval_of(input: &Input) -> Option<(RestitutionInterval, f64, Impact)> {
    let contact = input.contact().unwrap();
    let impact = contact.impact(input.approach(), &Solver::AUTO, None).unwrap();
    let interval = restitution_interval(input, &contact, input.speed(), &impact.row)?;
    let e = impact.row.measured_restitution();
    Some((interval, e, impact))
}

fn input_of(text: &str) -> Input {
    Scenario::from_text("s.toml", text, &[]).unwrap().resolve().unwrap()
}

/// A ball of one material on a half-space of another one.
fn drop_of(ball: &str, half_space: &str, speed: f64) -> String {
    format!(
        "[sphere]\nmaterial = \"{ball}\"\ndiameter = \"10 mm\"\n[impact]\nspeed = {speed}\n[law.plm]\nunloading_exponent = \"pressure-shape\"\n[half_space]\nmaterial = \"{half_space}\"\n"
    )
}

/// Samples of every named metal have a random hardness, exponent and strain rate, and the error of the law in a random load
/// cycle. The interval, which depends on the name alone, contains at least 90 % of their e. `validate` counts them, and
/// `validate_compares_with_every_reference` computes its page anew.
#[test]
fn interval_contains_e_of_fully_known_pieces() {
    let page = include_str!("../../../plots/validate/README.md");
    let line = page.lines().find_map(|line| line.strip_prefix("| random samples of all metals, whole interval | "));
    let counts: Vec<usize> = line.unwrap().split(" | ").take(2).map(|count| count.parse().unwrap()).collect();
    assert!(counts[0] > 5000 && 10 * counts[1] >= 9 * counts[0], "{counts:?}");
}

/// By warnings that report by how much e is off, the e that they call likely.
fn likely(warning: &Warning, e: f64) -> Option<[f64; 2]> {
    match warning.kind {
        WarningKind::NoExponent => Some([e / (1.0 + TOO_HIGH_BY[1]), e / (1.0 + TOO_HIGH_BY[0])]),
        WarningKind::WeakSphere => Some([e, 1.03 * e]),
        WarningKind::UnequalBalls => Some([0.99 * e, 1.01 * e]),
        _ => None,
    }
}

/// Every interval contains the e that a warning of the same impact calls likely. With a warning of e without figures there is no interval.
#[test]
fn interval_contains_e_of_warnings() {
    let names: Vec<&str> =
        all_materials().iter().filter(|entry| entry.is_metal()).map(|entry| entry.name.as_str()).collect();
    let (mut intervals, mut warned) = (0, 0);
    for half_space in &names {
        for ball in [half_space, "steel-52100-hardened", "aluminium-6061-t6", "steel-s235"] {
            for speed in [0.1, 1.0, 8.0] {
                let input = input_of(&drop_of(ball, half_space, speed));
                let Some((interval, e, impact)) = interval_of(&input) else { continue };
                intervals += 1;
                for warning in &impact.warnings {
                    let about = format!("{ball} on {half_space} at {speed} m/s: {warning} {interval:?}");
                    assert!(!warning.to_string().contains("not a prediction"), "{about}");
                    let Some([low, high]) = likely(warning, e) else { continue };
                    warned += 1;
                    assert!(interval.low <= low && high.min(1.0) <= interval.high, "{about}");
                }
            }
        }
    }
    assert!(intervals > 150 && warned > 30, "{intervals} {warned}");
}

/// Other Poisson's ratios than those of the other load cycles: a part as wide as the largest error of e against finite elements from 0.03
/// to 0.42, and no interval below 0.
#[test]
fn interval_holds_finite_elements_at_other_poissons_ratios() {
    let part = |poissons_ratio: f64, strength: &str| {
        let text = format!(
            "[sphere]\nradius = \"5 mm\"\nyoungs_modulus = \"rigid\"\npoissons_ratio = 0.3\nmass = \"4 g\"\n[impact]\nspeed = 3\n[law.plm]\nunloading_exponent = \"pressure-shape\"\n[half_space]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = {poissons_ratio}\n{strength}\n"
        );
        let (interval, ..) = interval_of(&input_of(&text))?;
        Some(interval.parts.into_iter().find(|part| part.name == "Poisson's ratio").map(|part| [part.low, part.high]))
    };
    let strength = "yield_strength = \"345 MPa\"";
    let errors = cycle_errors(PlmCoefficients::built_in(), UnloadingExponent::PressureShape).unwrap();
    let errors: Vec<f64> =
        errors.iter().filter(|(class, ..)| *class == BodyClass::OtherPoissonsRatio).map(|(.., error)| *error).collect();
    assert_eq!(errors.len(), 12);
    for (poissons_ratio, strength) in
        [(0.03, strength), (0.1, strength), (0.42, strength), (0.1, "hardness = \"120 HV\"")]
    {
        let [from, to] = part(poissons_ratio, strength).unwrap().unwrap();
        assert!(to < 0.016 && from == -to, "{poissons_ratio}: {from} {to}");
        assert!(errors.iter().all(|error| error.abs() < to + 1e-5), "{errors:?}");
    }
    assert_eq!(part(0.3, strength), Some(None));
    assert_eq!(part(-0.1, strength), None);
}
