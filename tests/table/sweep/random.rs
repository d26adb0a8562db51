//! Random cases: their distributions, their independence, their statistics.

use plm_impact::units::{Dimension, parse};

use super::{rows, summary};
use crate::common::prelude::*;

#[test]
fn random_values_follow_their_distribution() {
    let plan = |variable: &str| {
        rows(&format!("{STEEL}[monte_carlo]\nsamples = 200000\nseed = 3\n\"sphere.density\" = {variable}\n"))
    };
    let moments = |values: &[f64]| {
        let n = f64::from(u32::try_from(values.len()).unwrap());
        let mean = values.iter().sum::<f64>() / n;
        (mean, (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt())
    };
    // the standard error of the mean is sd/447 and that of sd about sd/632; five standard errors are allowed
    for (text, want_mean, want_sd) in [
        ("{ normal = { mean = 1000, sd = 50 } }", 1000.0, 50.0),
        ("{ lognormal = { mean = 1000, sd = 500 } }", 1000.0, 500.0),
        ("{ uniform = [1000, 2000] }", 1500.0, 1000.0 / 12f64.sqrt()),
        // truncated at 0 it is the half-normal distribution: mean √(2/π) sd, variance (1 − 2/π) sd²
        (
            "{ normal = { mean = 1e-9, sd = 100 } }",
            100.0 * (2.0 / std::f64::consts::PI).sqrt(),
            100.0 * (1.0 - 2.0 / std::f64::consts::PI).sqrt(),
        ),
    ] {
        let values = plan(text).axis_values;
        assert_eq!(values.len(), 200_000);
        assert!(values.iter().all(|value| *value > 0.0));
        let (mean, sd) = moments(&values);
        assert!((mean - want_mean).abs() < 5.0 * want_sd / 447.0, "{text}: mean {mean}");
        // the fourth moment of the lognormal distribution is large, so its sd is less accurate
        assert!((sd / want_sd - 1.0).abs() < 0.02, "{text}: sd {sd}");
    }
}

#[test]
fn truncated_probability_has_all_digits() {
    // Abramowitz and Stegun 1964, Table 26.1: P(1) and P(2)
    for (sd, want) in [("5 mm", 0.841_344_746_068_543), ("2.5 mm", 0.977_249_868_051_821)] {
        let tables = format!(
            "[monte_carlo]\nsamples = 2\n\"sphere.radius\" = {{ normal = {{ mean = \"5 mm\", sd = \"{sd}\" }} }}\n"
        );
        let kept = summary(&tables)["random"][0]["kept"].as_f64().unwrap();
        assert!((kept - want).abs() < 1e-15, "{sd}: {kept}");
    }
}

#[test]
fn sample_depends_only_on_seed_key_number() {
    let text = format!(
        "{STEEL}[monte_carlo]\nsamples = 10000\nseed = 7\n\"sphere.density\" = {{ uniform = [1, 2] }}\n\"impact.speed\" = {{ uniform = [1, 2] }}\n"
    );
    let plan = Scenario::from_text("test", &text, &[]).unwrap().plan().unwrap();
    let evaluator = Evaluator::new(&plan);
    let (mut whole, mut part) = (Rows::default(), Rows::default());
    evaluator.append_rows(0..10_000, &mut whole);
    evaluator.append_rows(7_777..7_779, &mut part);
    assert_eq!(part.axis_values, whole.axis_values[2 * 7_777..2 * 7_779]);
    assert_eq!(part.results, whole.results[7_777..7_779]);
    // the two keys have different random numbers
    assert!(whole.axis_values.chunks(2).all(|pair| pair[0] != pair[1]));
    let other = text.replace("seed = 7", "seed = 8");
    assert!(rows(&other).axis_values != whole.axis_values);
}

#[test]
fn quantiles_of_a_known_distribution() {
    // at the same peak e = √(c/(n + 1)) falls with n, so the quantiles of e are e at the quantiles of n
    let summary = summary(
        "[monte_carlo]\nsamples = 50000\nseed = 1\n\"law.plm.unloading_exponent\" = { uniform = [1.2, 1.8] }\n",
    );
    let e_of = |n: f64| {
        let rows = rows(&format!("{STEEL}[sweep]\n\"law.plm.unloading_exponent\" = [{n}]\n"));
        rows.results[0].unwrap().restitution
    };
    let got = &summary["restitution"];
    for (name, n) in [("quantile_05", 1.77), ("quantile_50", 1.5), ("quantile_95", 1.23)] {
        // the standard error of a quantile of a uniform n is 0.6 √(p (1 − p)/50000) < 1.4e-3, and de/dn is about −0.1
        assert_relative_eq!(got[name].as_f64().unwrap(), e_of(n), epsilon = 5.0 * 1.4e-4);
    }
    assert_eq!(got["samples"], 50_000);
    assert_eq!(got["quantile_resolution"], 0.0);
    assert_eq!(summary["random"][0]["truncated_to"], "> 1 and <= 2");
}

const SIZES: &str =
    "[monte_carlo]\nsamples = 2000\nseed = 2\n\"sphere.radius\" = { lognormal = { mean = \"5 mm\", sd = \"1 mm\" } }\n";

/// Every column that output names has its distribution and its histogram; e of this law does not depend on the size.
#[test]
fn named_columns_have_quantiles_and_histograms() {
    let asked = "[output]\ncolumns = [\"contact_time_s\"]\npicture = [\"dent_diameter_m\"]\n";
    let desk = Sandbox::with(format!("{STEEL}{SIZES}{asked}"));
    let output = desk.run(&["run", "s.toml", "--out", "out", "--pictures", "svg"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let said = text(&output.stdout);
    assert!(said.contains(" in all cases, because this result does not depend on sphere.radius here\n"), "{said}");
    let lines: Vec<Vec<&str>> =
        said.lines().map(|line| line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect()).collect();
    let head = ["random cases", "mean", "standard deviation", "5 %", "50 %", "95 %"];
    assert!(lines.iter().any(|cells| *cells == head), "{said}");
    let pictures = desk.files("out").into_iter().filter(|name| name.ends_with("svg")).collect::<Vec<_>>();
    assert_eq!(pictures, ["dent_diameter_m_histogram.svg"]);
    let table = desk.read("out/table.csv");
    let summary = desk.summary();
    let columns = summary["columns"].as_array().unwrap();
    assert_eq!(columns.len(), 2);
    for (entry, name) in columns.iter().zip(["contact_time_s", "dent_diameter_m"]) {
        assert_eq!(entry["column"], name);
        let mut values: Vec<f64> = column(&table, name).iter().map(|text| text.parse().unwrap()).collect();
        values.sort_by(f64::total_cmp);
        let n = values.len();
        assert_eq!((n, &entry["samples"]), (2000, &json!(2000)));
        let mean = values.iter().sum::<f64>() / n as f64;
        assert_relative_eq!(entry["mean"].as_f64().unwrap(), mean, max_relative = 1e-12);
        // the text has four digits, and a unit
        let row =
            lines.iter().find(|cells| cells.first().is_some_and(|cell| name.starts_with(&cell.replace(' ', "_"))));
        let dimension = if name == "contact_time_s" { Dimension::Time } else { Dimension::Length };
        let shown = parse(row.unwrap()[1], dimension).unwrap();
        assert!(row.unwrap().len() == head.len() && (shown / mean - 1.0).abs() < 1e-3, "{said}");
        // n - 1 = 1999 is no multiple of 20, so that each quantile lies between two values
        for (key, below) in [("quantile_05", 99), ("quantile_50", 999), ("quantile_95", 1899)] {
            assert!((values[below]..=values[below + 1]).contains(&entry[key].as_f64().unwrap()), "{name} {key}");
        }
    }
}

/// A column without scatter has no histogram, whose one bar would say nothing.
#[test]
fn a_constant_column_has_no_histogram() {
    let desk = Sandbox::with(format!("{STEEL}{SIZES}"));
    let output = desk.run(&["run", "s.toml", "--out", "out", "--pictures", "svg"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(desk.files("out").iter().all(|name| !name.ends_with("svg")), "{:?}", desk.files("out"));
    // a scatter of the strength does change e
    let strengths = "[monte_carlo]\nsamples = 50\nseed = 2\n\"half_space.yield_strength\" = { uniform = [3e8, 4e8] }\n";
    let desk = Sandbox::with(format!("{STEEL}{strengths}"));
    let output = desk.run(&["run", "s.toml", "--out", "out", "--pictures", "svg"]);
    assert!(!text(&output.stdout).contains("does not depend"));
    assert!(desk.files("out").contains(&"restitution_histogram.svg".to_owned()));
}
