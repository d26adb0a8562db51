//! Pictures that need a browser or LAMMPS, and so are not drawn in these tests: the numbers that each picture shows, which its
//! script writes to a table with the picture, are those of today.

use crate::common::prelude::*;

/// The numbers of a picture as it was drawn are those of now: within less than a pixel, and to four digits.
fn check(table: &str, script: &str, now: impl Fn(&str) -> f64) {
    let drawn: Vec<(String, f64)> = records(table);
    assert!(!drawn.is_empty());
    for (name, value) in drawn {
        let today = now(&name);
        let message = format!("the picture is stale: {name} was {value} and is {today}; draw it by {script}");
        assert!((value / today - 1.0).abs() < 2e-4, "{message}");
    }
}

#[test]
fn page_picture_shows_current_numbers() {
    let desk = Sandbox::with("");
    let template = desk.run_expecting(&["init", "impact", "--out", "-"], 0).0;
    desk.write("s.toml", &template);
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    let summary = desk.summary();
    let script = "UPDATE=1 node --test tests/web/page.test.mjs";
    check(include_str!("../../reference/page_picture.csv"), script, |name| summary[name].as_f64().unwrap());
}

#[test]
fn lammps_picture_shows_current_restitution() {
    let desk = Sandbox::with("");
    let steel = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/steel-on-steel.toml");
    desk.write("s.toml", fs::read_to_string(steel).unwrap());
    check(include_str!("../../reference/rain_picture.csv"), "UPDATE=1 pytest tests/lammps", |speed| {
        let speed = format!("impact.speed={speed}");
        desk.run_expecting(&["run", "s.toml", "--out", "out", "--force", "--pictures", "none", "--set", &speed], 0);
        desk.summary()["restitution"].as_f64().unwrap()
    });
}

#[test]
fn gas_picture_shows_current_restitution() {
    let desk = Sandbox::with("");
    let balls = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/ball-on-ball.toml");
    let text = fs::read_to_string(balls).unwrap();
    // the equal balls at one speed
    let (before, rest) = text.split_once("[sweep]").unwrap();
    let (_, after) = rest.split_once("[law.plm]").unwrap();
    desk.write("s.toml", format!("{before}[law.plm]{after}"));
    check(include_str!("../../reference/gas_picture.csv"), "UPDATE=1 pytest tests/lammps", |speed| {
        let speed = format!("impact.speed={speed}");
        desk.run_expecting(&["run", "s.toml", "--out", "out", "--force", "--pictures", "none", "--set", &speed], 0);
        desk.summary()["restitution"].as_f64().unwrap()
    });
}
