//! Numbers that the terminal shows in another way, as they do not hold: beyond the law, below the sticking speed, 0 but for
//! rounding.

use crate::common::prelude::*;

fn printed(text: &str, set: &[impl ToString]) -> String {
    outcome(&read(text, set)).terminal_text()
}

fn line<'a>(printed: &'a str, name: &str) -> Option<&'a str> {
    printed.lines().find(|line| line.starts_with(name))
}

/// Newton's cradle: the first of two equal elastic balls stays.
#[test]
fn rebound_speed_within_rounding_is_0() {
    let cradle = STEEL
        .replace("density = \"7850 kg/m^3\"", "mass = \"4 g\"")
        .replace("yield_strength = \"345 MPa\"", "radius = \"5 mm\"\nmass = \"4 g\"");
    let said = printed(&cradle, NO_OVERRIDES);
    assert!(line(&said, "rebound speed").is_some_and(|line| line.split_whitespace().nth(2) == Some("0")), "{said}");
    assert!(line(&said, "target speed").is_some_and(|line| line.contains("3 m/s")), "{said}");
    // a slow rebound is a rebound
    let (rebound, _) = contact(&cradle, NO_OVERRIDES).speeds_after(3.0, 1.0 - 1e-6);
    assert!((rebound / -1.5e-6 - 1.0).abs() < 1e-6, "{rebound}");
}

#[test]
fn a_restitution_below_the_sticking_speed_is_marked() {
    let small = STEEL.replace("radius = \"5 mm\"", "diameter = \"0.1 mm\"");
    let first =
        |speed: &str| line(&printed(&small, &[&format!("impact.speed={speed}")]), "restitution").unwrap().to_owned();
    assert!(first("1 mm/s").contains("(below the sticking speed)"));
    let said = printed(&small, &["impact.speed=1 mm/s"]);
    assert!(line(&said, "rebound speed").unwrap().contains("(below the sticking speed)"), "{said}");
    // up to seven times that speed a warning is enough
    assert!(!first("25 mm/s").contains("sticking") && !first("1 m/s").contains("sticking"));
}

/// A plate that takes nearly all: a warning says to e is close to 0, and no digits stand beside it.
#[test]
fn nearly_0_has_no_digits() {
    let drop = |thickness: &str| {
        let arguments = ["drop", "--ball", "steel-52100-hardened", "--diameter", "10 mm", "--on", "aluminium-6061-t6"];
        Sandbox::with("").run_expecting(&[&arguments[..], &["--from", "1 m", "--thickness", thickness]].concat(), 0)
    };
    let (said, warned) = drop("2 mm");
    assert!(warned.contains("e is close to 0"), "{warned}");
    assert!(line(&said, "restitution").unwrap().ends_with("nearly 0 (below 0.02)"), "{said}");
    assert!(line(&said, "rebound height").unwrap().ends_with("nearly 0"), "{said}");
    assert!(!drop("5 mm").0.contains("nearly 0"));
}

#[test]
fn options_of_drop_may_hold_any_character() {
    let desk = Sandbox::with("");
    let drop = |diameter: &str, more: &[&str], code| {
        let arguments = ["drop", "--ball", "steel-52100-hardened", "--on", "aluminium-6061-t6", "--from", "1 m"];
        desk.run_expecting(&[&arguments[..], &["--diameter", diameter], more].concat(), code)
    };
    // a blank that does not break, as it is copied from a page
    assert_eq!(drop("10\u{a0}mm", &[], 0).0, drop("10 mm", &[], 0).0);
    for odd in ["10 \"mm\"", "10 mm\u{7f}", "10\\mm", "it's"] {
        let said = drop(odd, &[], 2).1;
        assert!(
            said.starts_with("error: --diameter: ") && !said.contains("unicode") && !said.contains("escape"),
            "{said}"
        );
    }
    let said = drop("10 mm", &["--angle", "30 deg", "--friction", "nan"], 2).1;
    assert!(said.contains("--friction: NaN is not allowed"), "{said}");
}
