//! What the words and the scales of a picture say: units, titles, which curves are shown, and what a logarithmic axis can show.

use plm_impact::report::plot::{self, Axis, Chart, Series};

use super::drawn::*;
use crate::common::prelude::*;

/// The picture of this name that a scenario draws.
fn drawn(text: &str, picture: &str) -> Drawn {
    drawn_as(text, picture, "svg")
}

fn drawn_as(text: &str, picture: &str, format: &str) -> Drawn {
    let desk = Desk::with(text);
    desk.ends(&["run", "s.toml", "--out", "o", "--pictures", format], 0);
    Drawn(desk.read(&format!("o/{picture}.svg")))
}

/// Whether these words are a text of the picture, or lines of the key one below the other.
fn has(drawn: &Drawn, words: &str) -> bool {
    let texts: Vec<String> = drawn.texts().iter().map(|text| text.replace('\u{a0}', " ")).collect();
    texts.iter().any(|text| text == words) || texts.windows(2).any(|pair| pair.join(" ") == words)
}

fn sweep(axes: &str) -> String {
    format!("{STEEL}[sweep]\n{axes}\n")
}

/// A plate has a thickness, a law has a name of its authors, and a hardness is in HV.
#[test]
fn titles_are_in_the_words_of_the_field() {
    for (axis, title) in [
        ("\"half_space.thickness\" = { linspace = [\"5 mm\", \"50 mm\"], points = 4 }", "Plate thickness [mm]"),
        ("\"impact.drop_height\" = { linspace = [\"5 mm\", \"50 mm\"], points = 4 }", "Drop height [mm]"),
        ("\"impact.speed\" = { linspace = [1, 2], points = 4 }", "Impact speed [m/s]"),
    ] {
        let plate = STEEL.replace("yield_strength", "density = 7850\nyield_strength");
        let fall = plate.replace("[impact]\nspeed = \"3 m/s\"\n", "");
        let text = if axis.contains("drop_height") { &fall } else { &plate };
        let drawn = drawn(&format!("{text}[sweep]\n{axis}\n"), "restitution");
        assert!(has(&drawn, title), "{title}: {:?}", drawn.texts());
    }
    let braun = format!("{STEEL}[law.walton_braun]\nstiffness_ratio = 0.5\n[sweep]\n");
    let ratios = "\"law.walton_braun.stiffness_ratio\" = { linspace = [0.2, 0.8], points = 4 }\n";
    assert!(has(&drawn(&(braun + ratios), "restitution"), "Walton–Braun stiffness ratio"));
    let laws = drawn(&sweep("\"law\" = [\"plm\", \"kogut_etsion\", \"jackson_green + brake\"]"), "restitution");
    for law in ["1 PLM", "2 Kogut–Etsion", "3 Jackson–Green + Brake"] {
        assert!(has(&laws, law), "{law}: {:?}", laws.texts());
    }
}

/// Of twenty curves seven are shown, at even steps, in one unit and in different colours; the key says that there are more.
#[test]
fn the_curves_of_a_long_axis_are_even_and_counted() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let axes = "\"half_space.youngs_modulus\" = { linspace = [1e11, 2e11], points = 20 }\n\"impact.drop_height\" = { linspace = [\"100 mm\", \"2 m\"], points = 20 }";
    let drawn = drawn(&format!("{still}[sweep]\n{axes}\n"), "restitution");
    for name in ["100 mm", "400 mm", "700 mm", "1000 mm", "1300 mm", "1600 mm", "1900 mm", "7 of 20 values are shown"] {
        assert!(has(&drawn, name), "{name}: {:?}", drawn.texts());
    }
    assert!(!has(&drawn, "2 m") && !has(&drawn, "2000 mm"));
    let colors: Vec<String> = (0..13).map(|number| format!("{:?}", plot::Style::new(number).solid())).collect();
    for (number, one) in colors.iter().enumerate() {
        let color = one.split("color").nth(1).unwrap().split("width").next().unwrap();
        assert!(!colors[..number].iter().any(|other| other.contains(color)), "{number}: {color}");
    }
}

/// A dent that grows with the size of the sphere is on a logarithmic axis where the sizes are.
#[test]
fn a_dent_over_decades_of_sizes_has_a_logarithmic_axis() {
    let axes = "\"sphere.radius\" = { logspace = [\"10 um\", \"10 mm\"], points = 10 }";
    let output = "[output]\npicture = [\"residual_indentation_m\"]\n";
    let drawn = drawn(&format!("{STEEL}{output}[sweep]\n{axes}\n"), "residual_indentation_m");
    // at one speed the dent is a share of the radius: a straight line from corner to corner
    let shares = drawn.shares(BLUE);
    let middle = shares.iter().min_by(|a, b| (a.0 - 0.5).abs().total_cmp(&(b.0 - 0.5).abs())).unwrap();
    assert!((middle.0 - middle.1).abs() < 0.01, "{middle:?}");
}

/// The unloading curves of a series on logarithmic axes end at the lower edge.
#[test]
fn unloading_curves_on_logarithmic_axes_end_at_the_edge() {
    let series = "[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 12\nspot = \"fresh\"\n";
    let drawn = drawn(&(STEEL.to_owned() + series), "force_indentation");
    let [_, _, right, bottom] = drawn.boxes()[0];
    for color in [BLUE, VERMILLION, GREEN] {
        let lowest =
            drawn.lines(color).concat().into_iter().filter(|at| at.0 < right).map(|at| at.1).fold(0.0, f64::max);
        // within the gap between two dashes
        assert!(bottom - lowest < 12.0 * UNITS, "{color}: {lowest} of {bottom}");
    }
}

/// An error bar that reaches below zero goes to the edge of a logarithmic axis: the least certain value has the longest bar.
#[test]
fn an_error_bar_below_zero_reaches_the_edge() {
    let axes = [Axis::linear("x", "").between(0.0, 3.0), Axis::log("y", "").between(0.1, 100.0)];
    let bars = Series::bars([(1.0, 10.0, 5.0), (2.0, 1.0, 2.0)].into_iter()).styled(0);
    let drawn = Drawn::of(&Chart::new("bars", axes, vec![bars]));
    let lines = drawn.lines(BLUE);
    assert_eq!(lines.len(), 2);
    let bottom = drawn.boxes()[0][3];
    let lowest = lines[1].iter().map(|at| at.1).fold(0.0, f64::max);
    assert!((lowest - bottom).abs() < UNITS, "{lowest} of {bottom}");
}

/// The line below the title names the damping, and the key has both lines of a damped loop.
#[test]
fn a_damped_impact_says_so() {
    let elastic = STEEL.replace("yield_strength = \"345 MPa\"\n", "");
    for (damping, words) in
        [("viscous = 0.15", "; damping viscous 0.15"), ("hunt_crossley = 0.1", "; damping Hunt–Crossley 0.1 s/m")]
    {
        let drawn = drawn(&format!("{elastic}[damping]\n{damping}\n"), "force_indentation");
        assert!(drawn.texts().iter().any(|text| text.ends_with(words)), "{:?}", drawn.texts());
        assert!(has(&drawn, "loading") && has(&drawn, "unloading"), "{:?}", drawn.texts());
    }
    let plain = drawn(&elastic, "force_indentation");
    assert!(has(&plain, "loading and unloading") && !has(&plain, "unloading"));
}

/// Both heights of a fit are in one unit, and a hardness is in HV, as in a sweep.
#[test]
fn a_fit_has_one_unit_and_the_hardness_its_scale() {
    let desk = Desk::with(STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "[calibrate]\ndata = \"d.csv\"\n"));
    desk.put("d.csv", "drop_height_m,rebound_height_m\n0.5,0.13\n1,0.23\n1.5,0.31\n2,0.38\n");
    desk.ends(&["calibrate", "s.toml", "--out", "o", "--pictures", "svg"], 0);
    let drawn = Drawn(desk.read("o/fit_rebound_height.svg"));
    assert!(has(&drawn, "Drop height [m]") && has(&drawn, "Rebound height [m]"), "{:?}", drawn.texts());
    assert!(has(&drawn, "PLM"));
}

/// The titles of narrow boxes are not longer than their boxes.
#[test]
fn titles_of_low_boxes_do_not_touch() {
    let series = "[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 4\nspot = \"same\"\n";
    let drawn = drawn_as(&(STEEL.to_owned() + series), "impacts", "narrow-svg");
    let document = drawn.document();
    let height = |text: &str| {
        let mut nodes = document.descendants().filter(|node| node.has_tag_name("text"));
        let node = nodes.find(|node| node.text().unwrap().trim() == text).unwrap();
        // letters are at least half as wide as they are high, on average
        #[allow(clippy::cast_precision_loss)]
        let length = 0.5 * number(node, "font-size") * text.chars().count() as f64;
        length
    };
    let boxes = drawn.boxes();
    for (title, [_, top, _, bottom]) in ["Speed [m/s]", "Restitution", "Dent depth [µm]"].into_iter().zip(boxes) {
        assert!(height(title) < bottom - top + 30.0 * UNITS, "{title}");
    }
}
