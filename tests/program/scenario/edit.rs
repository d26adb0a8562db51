//! Changes in the text of a scenario, of the command line and of the page: all else stays as it was written.

use plm_impact::scenario::document::edit::{Change, given_values, with_changes, with_value};

use crate::common::prelude::*;

const TEXT: &str = "# a ball\n[sphere]\n# how large\nradius = \"5 mm\"  # not the diameter\n[impact]\nspeed = 3\n";

#[test]
fn change_keeps_rest_of_text() {
    let change = |path, given| with_value(TEXT, path, given).unwrap();
    assert_eq!(change("sphere.radius", "2 mm"), TEXT.replace("5 mm", "2 mm"));
    assert_eq!(change("impact.speed", "0.5"), TEXT.replace("= 3", "= 0.5"));
    assert_eq!(
        change("sphere.youngs_modulus", "rigid"),
        TEXT.replace("[impact]", "youngs_modulus = \"rigid\"\n[impact]")
    );
    assert_eq!(change("gravity.acceleration", "9.81"), format!("{TEXT}\n[gravity]\nacceleration = 9.81\n"));
    assert_eq!(change("law", "thornton"), format!("{TEXT}\n[law.thornton]\n"));
    assert_eq!(change("impact.speed", ""), TEXT.replace("speed = 3\n", ""));
    assert_eq!(with_value(&change("gravity.acceleration", "9.81"), "gravity.acceleration", "").unwrap(), TEXT);
    assert_eq!(change("damping.viscous", ""), TEXT);
    // TOML has no whole number beyond 64 bits
    let large = format!("{TEXT}[monte_carlo]\nseed = 36893488147419103232\n");
    assert!(with_value(&large, "impact.speed", "0.5").is_err() && given_values(&large).is_err());
}

/// The text with these changes of the command line.
fn with(text: &str, changes: &[&str]) -> String {
    let parse = |change: &&str| {
        let (key, value) = change.split_once('=').unwrap();
        Change::parse(key, value).unwrap()
    };
    with_changes(text, &changes.iter().map(parse).collect::<Vec<_>>()).unwrap()
}

#[test]
fn command_line_change_keeps_comments() {
    assert_eq!(with(TEXT, &["sphere.radius=\"6 mm\""]), TEXT.replace("5 mm", "6 mm"));
    assert_eq!(with(TEXT, &["sphere.radius=6 mm", "sphere.radius=7 mm"]), TEXT.replace("5 mm", "7 mm"));
    assert_eq!(with(TEXT, &["impact={ drop_height = 1 }"]).matches('#').count(), 3);
}

#[test]
fn alternative_key_replaces_and_none_removes() {
    let radius = "# how large\nradius = \"5 mm\"  # not the diameter\n";
    assert_eq!(with(TEXT, &["sphere.diameter=1 cm"]), TEXT.replace(radius, "diameter = \"1 cm\"\n"));
    assert_eq!(with(TEXT, &["impact.drop_height=2"]), TEXT.replace("speed = 3", "drop_height = 2"));
    let both = with(TEXT, &["sphere.diameter=1 cm", "sphere.radius=5 mm"]);
    assert!(both.contains("radius") && both.contains("diameter"), "both are of the command line: {both}");
    let swept = with(TEXT, &["sweep.\"impact.drop_height\"=[1, 2]"]);
    assert!(swept.contains("drop_height") && !swept.contains("speed = 3"), "an axis too: {swept}");
    let table = with(TEXT, &["sweep={ \"impact.drop_height\" = [1, 2], \"sphere.diameter\" = [1, 2] }"]);
    assert!(!table.contains("speed = 3") && !table.contains("radius"), "a table of axes too: {table}");
    assert_eq!(with(TEXT, &["sphere.radius=none"]), TEXT.replace(radius, ""));
    assert_eq!(with(TEXT, &["impact=none"]), TEXT.replace("[impact]\nspeed = 3\n", ""));
    assert_eq!(with(TEXT, &["gravity.acceleration=9.81", "gravity=none", "damping.viscous=none"]), TEXT);
    assert!(with(TEXT, &["sphere.raduis=none"]).contains("raduis = \"none\""), "it is refused then");
}

#[test]
fn set_table_replaces_and_set_key_extends() {
    let inline = "sphere = { radius = 5 }\n";
    assert_eq!(with(inline, &["sphere.density=7"]).replace(' ', ""), "sphere={radius=5,density=7}\n");
    assert_eq!(with(inline, &["sphere={ density = 7 }"]), "sphere = { density = 7 }\n");
    assert_eq!(with("law = { plm = {} }\n", &["law=hertz"]).replace(' ', ""), "law={hertz={}}\n");
    assert_eq!(
        with("[law.plm]\n", &["law=stronge+ brake"]),
        "[law.combined]\nloading = \"stronge\"\nunloading = \"brake\"\n"
    );
    assert_eq!(
        with("[law.thornton]\nyield_pressure = 1 # Pa\n", &["law=thornton"]),
        "[law.thornton]\nyield_pressure = 1 # Pa\n"
    );
}

#[test]
fn text_has_exactly_its_changed_keys() {
    let changes = [("impact.speed", "3 m/s"), ("half_space.flow_stress.power.exponent", "0.1"), ("law", "stronge")];
    let text = changes.iter().fold(TEXT.to_owned(), |text, (path, value)| with_value(&text, path, value).unwrap());
    let found = given_values(&text).unwrap();
    for (path, value) in changes.iter().chain(&[("sphere.radius", "5 mm")]) {
        assert!(found.contains(&((*path).to_owned(), (*value).to_owned())), "{path} in {found:?}");
    }
    assert_eq!(found.len(), 4, "{found:?}");
    // a comment behind a number is no part of it
    assert_eq!(given_values("speed = 3  # fast\n").unwrap(), [("speed".to_owned(), "3".to_owned())]);
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
