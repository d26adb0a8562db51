//! `fit-plm` as a command: the file that it writes, and the files and requests that it refuses.

use std::fs;

use approx::assert_relative_eq;
use plm_impact::fit;
use plm_impact::law::PlmCoefficients;
use tempfile::TempDir;

use super::{finite_elements, plan, reference};
use crate::common::command::{call, text};

#[test]
fn the_command_writes_a_file_that_a_scenario_takes() {
    let directory = TempDir::new().unwrap();
    let names: Vec<String> = (1..=5).map(|case| format!("case{case}.csv")).collect();
    for (case, name) in (1..).zip(&names) {
        fs::copy(reference(case), directory.path().join(name)).unwrap();
    }
    let mut arguments = vec!["fit-plm"];
    arguments.extend(names.iter().map(String::as_str));
    arguments.extend(["-o", "mine.toml", "--name", "PLM of mine"]);
    let output = call(directory.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let table = text(&output.stdout);
    assert!(names.iter().all(|name| table.contains(name)) && table.contains("left out"), "{table}");

    let toml = fs::read_to_string(directory.path().join("mine.toml")).unwrap();
    let table = PlmCoefficients::from_toml(&toml).unwrap();
    assert_eq!(table.provenance.name, "PLM of mine");
    assert!(table.provenance.source.contains("5 loading curves: plm-impact fit-plm case1.csv"), "{toml}");
    assert!(table.provenance.range.contains("0.48"), "{toml}");
    // the file has the fitted coefficients to ten digits
    let fitted = fit::fit(&finite_elements(), &plan(PlmCoefficients::built_in().clone())).unwrap().coefficients;
    assert_relative_eq!(table.force.slope[4], fitted.force.slope[4], max_relative = 1e-9);

    let scenario = include_str!("../../../scenarios/steel-on-steel.toml")
        .replace("[law.plm]", "[law.plm]\ncoefficients = \"mine.toml\"");
    fs::write(directory.path().join("s.toml"), scenario).unwrap();
    let output = call(directory.path(), &["run", "s.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let summary = fs::read_to_string(directory.path().join("plots/s/summary.json")).unwrap();
    assert!(summary.contains("PLM of mine"));
}

#[test]
fn bad_files_are_refused_and_nothing_is_written() {
    let good = fs::read_to_string(reference(3)).unwrap();
    let line = |text: &str, n: usize| text.lines().nth(n).unwrap().to_owned();
    let first = good.lines().position(|line| line.starts_with("delta_over")).unwrap();
    let row = line(&good, first + 20);
    let replaced = |with: &str| good.replace(&row, with);
    let at = format!("bad.csv:{}: ", first + 21);
    let swapped = {
        let next = line(&good, first + 21);
        good.replace(&row, "\u{1}").replace(&next, &row).replace('\u{1}', &next)
    };
    let short: String = good.lines().take(first + 8).collect::<Vec<_>>().join("\n");
    let cases: Vec<(String, Vec<&str>)> = vec![
        (good.replace("delta_s_over_delta", "share"), vec!["elastic approach", "delta_s_over_delta"]),
        (good.replace("F_over_FY", "force"), vec!["no column gives the force", "force_N"]),
        (good.replace("F_over_FY", "force_N"), vec!["force_N", "sphere.radius = 35 mm"]),
        (
            good.replace("a_over_R", "force_N").replace("# sphere.youngs", "# sphere.radius = 1 mm\n# sphere.youngs"),
            vec!["two columns give the force"],
        ),
        (replaced("13.5,NaN,0.3,0.03"), vec![&at, "F_over_FY = NaN", "finite number above 0"]),
        (replaced("13.5,-3,0.3,0.03"), vec![&at, "F_over_FY = -3"]),
        (replaced("13.5,many,0.3,0.03"), vec![&at, "is not a number"]),
        (replaced("13.5,40"), vec![&at, "not as many values"]),
        (swapped, vec!["delta_over_deltaY does not rise"]),
        (short, vec!["beyond first yield", "at least 8"]),
        (good.replace("# half_space.yield_strength = 345 MPa", "#"), vec!["half_space.yield_strength", "do not say"]),
        (good.replace("345 MPa", "345 mm"), vec!["half_space.yield_strength", "345 mm", "a pressure"]),
        (good.replace("poissons_ratio = 0.3", "poissons_ratio = 0.7"), vec!["poissons_ratio", "0.7"]),
        (
            good.replace("half_space.yield_strength", "half_space.yield_strenght"),
            vec!["did you mean `half_space.yield_strength`"],
        ),
        (good.replace("208 GPa", "rigid"), vec!["rigid sphere", "elastic_approach_m"]),
        (good.replace("208 GPa", "20800 GPa"), vec!["cannot exceed 1", "check moduli"]),
        (String::new(), vec!["do not say"]),
    ];
    for (content, wants) in cases {
        let directory = TempDir::new().unwrap();
        fs::write(directory.path().join("bad.csv"), &content).unwrap();
        let output = call(directory.path(), &["fit-plm", "bad.csv", "-o", "out/c.toml"]);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{wants:?}: {message}");
        assert!(message.contains("bad.csv"), "{message}");
        for want in &wants {
            assert!(message.contains(want), "{want:?} is not in\n{message}");
        }
        assert!(output.stdout.is_empty());
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 1, "{wants:?}");
    }
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let directory = TempDir::new().unwrap();
    fs::copy(reference(3), directory.path().join("c.csv")).unwrap();
    let before = fs::read(directory.path().join("c.csv")).unwrap();
    for (arguments, want) in [
        (vec!["fit-plm", "missing.csv", "-o", "c.toml"], "missing.csv"),
        (vec!["fit-plm", "c.csv", "-o", "c.csv"], "is one of the curves"),
        (vec!["fit-plm", "c.csv", "-o", "./c.csv"], "is one of the curves"),
        (vec!["fit-plm", "c.csv", "-o", "c.toml", "--knots", "3,2"], "--knots"),
        (vec!["fit-plm", "c.csv", "-o", ".."], "is not the name of a file"),
        (vec!["fit-plm", ".", "-o", "c.toml"], "cannot be read"),
    ] {
        let output = call(directory.path(), &arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(want), "{arguments:?}: {message}");
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 1, "{arguments:?}");
    }
    assert_eq!(fs::read(directory.path().join("c.csv")).unwrap(), before);
}
