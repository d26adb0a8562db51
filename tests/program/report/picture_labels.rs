//! The words and the scales of pictures: units, titles, the choice of curves, and the limits of a logarithmic axis.

use plm_impact::report::chart;

use plm_impact::report::chart::{Axis, Chart, Series};

use crate::common::prelude::*;
use crate::report::svg_reader::*;

/// The picture of this name that a scenario draws.
fn drawn(text: &str, picture: &str) -> SvgPicture {
    drawn_as(text, picture, "svg")
}

fn drawn_as(text: &str, picture: &str, format: &str) -> SvgPicture {
    let desk = Sandbox::with(text);
    desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", format], 0);
    SvgPicture(desk.read(&format!("o/{picture}.svg")))
}

/// Whether these words are a text of the picture, or lines of the key one below the other.
fn has(drawn: &SvgPicture, words: &str) -> bool {
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
    // in a unit in which the values are short
    let strengths = "\"impact.speed\" = { linspace = [1, 2], points = 4 }\n\"half_space.yield_strength\" = [2e8, 9e8]";
    let strengths = drawn(&sweep(strengths), "restitution");
    assert!(has(&strengths, "200 MPa") && has(&strengths, "900 MPa"), "{:?}", strengths.texts());
    let rate = STEEL.replace("[impact]", "rate.tested_at = 1e-3\nrate.johnson_cook.c = 0.01\n[impact]");
    let rate = rate + "[sweep]\n\"half_space.rate.johnson_cook.c\" = [0.01, 0.02]\n";
    assert!(has(&drawn(&rate, "restitution"), "Half-space Johnson–Cook c"));
    let laws = drawn(&sweep("\"law\" = [\"plm\", \"kogut_etsion\", \"jackson_green + brake\"]"), "restitution");
    for law in ["1 PLM", "2 Kogut–Etsion", "3 Jackson–Green + Brake"] {
        assert!(has(&laws, law), "{law}: {:?}", laws.texts());
    }
}

/// A ball bounces under gravity, and shots are prescribed: the title has their number.
#[test]
fn title_counts_bounces_or_shots() {
    let shots = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "") + "[repeat]\nspeeds = [1, 2]\nspot = \"same\"\n";
    let bounces = STEEL.to_owned() + "[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 3\nspot = \"fresh\"\n";
    for (text, title) in [(shots, "2 shots on the same spot"), (bounces, "3 bounces on fresh surface")] {
        let drawn = drawn(&text, "impacts");
        assert!(has(&drawn, title), "{title}: {:?}", drawn.texts());
    }
}

/// The time axis ends 3 % behind the contact, and the curves end with the contact.
#[test]
fn time_axis_of_impact_ends_with_contact() {
    let desk = Sandbox::with(STEEL);
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "svg"], 0);
    let contact_time = desk.summary()["contact_time_s"].as_f64().unwrap();
    let drawn = SvgPicture(desk.read("out/history.svg"));
    let scale = drawn.across(0);
    let right = drawn.boxes()[0][2];
    let end = scale.value(right);
    assert!((end / contact_time - 1.03).abs() < 0.003, "{end} {contact_time}");
    // the key is beyond the box
    let places = drawn.lines(PURPLE).concat().into_iter().map(|at| at.0).filter(|at| *at <= right);
    let last = scale.value(places.fold(0.0, f64::max));
    assert!((last / contact_time - 1.0).abs() < 0.003, "{last} {contact_time}");
}

/// Seven of twenty curves are shown, at even steps, in one unit and in different colours; the key states that there are more.
#[test]
fn long_axis_has_even_counted_curves() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let axes = "\"half_space.youngs_modulus\" = { linspace = [1e11, 2e11], points = 20 }\n\"impact.drop_height\" = { linspace = [\"100 mm\", \"2 m\"], points = 20 }";
    let drawn = drawn(&format!("{still}[sweep]\n{axes}\n"), "restitution");
    for name in ["0.1 m", "0.4 m", "0.7 m", "1 m", "1.3 m", "1.6 m", "1.9 m", "7 of 20 values are shown"] {
        assert!(has(&drawn, name), "{name}: {:?}", drawn.texts());
    }
    assert!(!has(&drawn, "2 m"));
    let colors: Vec<String> =
        (0..13).map(|number| format!("{:?}", chart::Style::new(number).with_solid_line())).collect();
    for (number, one) in colors.iter().enumerate() {
        let color = one.split("color").nth(1).unwrap().split("width").next().unwrap();
        assert!(!colors[..number].iter().any(|other| other.contains(color)), "{number}: {color}");
    }
}

/// A dent that grows with the size of the sphere is on a logarithmic axis where the sizes are.
#[test]
fn dent_over_decades_has_logarithmic_axis() {
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
fn unloading_curves_on_logarithmic_axes_end_at_edge() {
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
    let axes = [Axis::linear("x", "").with_range(0.0, 3.0), Axis::log("y", "").with_range(0.1, 100.0)];
    let bars = Series::error_bars([(1.0, 10.0, 5.0), (2.0, 1.0, 2.0)].into_iter()).with_style(0);
    let drawn = SvgPicture::from_chart(&Chart::new("bars", axes, vec![bars]));
    let lines = drawn.lines(BLUE);
    assert_eq!(lines.len(), 2);
    let bottom = drawn.boxes()[0][3];
    let lowest = lines[1].iter().map(|at| at.1).fold(0.0, f64::max);
    assert!((lowest - bottom).abs() < UNITS, "{lowest} of {bottom}");
}

/// The line below the title names the damping, and the key has both lines of a damped loop.
#[test]
fn damped_impact_names_its_damping() {
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
fn fit_has_one_unit_and_hardness_scale() {
    let desk = Sandbox::with(STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "[calibrate]\ndata = \"d.csv\"\n"));
    desk.write("d.csv", "drop_height_m,rebound_height_m\n0.5,0.13\n1,0.23\n1.5,0.31\n2,0.38\n");
    desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "svg"], 0);
    let drawn = SvgPicture(desk.read("o/fit_rebound_height.svg"));
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

/// Random sizes of the sphere do not change e: a histogram of one value would be one bar, and is not drawn.
#[test]
fn equal_values_have_no_histogram() {
    for (key, count) in [("sphere.radius", 0), ("half_space.yield_strength", 1)] {
        let range = if count == 0 { "[\"1 mm\", \"9 mm\"]" } else { "[\"300 MPa\", \"400 MPa\"]" };
        let desk = Sandbox::with(format!("{STEEL}[monte_carlo]\nsamples = 50\n\"{key}\" = {{ uniform = {range} }}\n"));
        desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "svg"], 0);
        assert_eq!(desk.files("o").iter().filter(|name| name.contains(".svg")).count(), count, "{key}");
    }
}

/// The files of a calibration of these keys, with pictures.
fn calibrated(keys: &str, data: &str, code: i32) -> Sandbox {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let desk = Sandbox::with(format!("{still}[calibrate]\ndata = \"d.csv\"\n{keys}"));
    desk.write("d.csv", data);
    desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "svg"], code);
    desk
}

/// The key of a fit has error bars where a reader sees them, and says so where the marker covers them.
#[test]
fn error_bars_smaller_than_marker_are_noted() {
    for (deviation, is_seen) in [("0.03", true), ("0.0002", false)] {
        let data = format!(
            "speed_m_per_s,restitution,restitution_sd\n1,0.603138,{deviation}\n2,0.530915,{deviation}\n3,0.490579,{deviation}\n"
        );
        let drawn = SvgPicture(calibrated("", &data, 0).read("o/fit_restitution.svg"));
        let texts = drawn.texts().join(" ").replace('\u{a0}', " ");
        assert_eq!(texts.contains("measured, with its standard deviation"), is_seen, "{texts}");
        assert_eq!(texts.contains("standard deviation below the size of the marker"), !is_seen, "{texts}");
        assert_eq!(texts.contains("band of the line"), is_seen, "{texts}");
    }
}

/// The line of the law among the residuals is whole, and those of 95 % are dashed.
#[test]
fn the_law_and_its_limits_have_different_lines() {
    let data = "speed_m_per_s,restitution,restitution_sd\n1,0.61,0.01\n2,0.525,0.01\n3,0.5,0.01\n4,0.46,0.01\n";
    let drawn = SvgPicture(calibrated("", data, 0).read("o/residuals.svg"));
    let [left, _, right, _] = drawn.boxes()[0];
    let lines: Vec<f64> = drawn
        .lines("#777777")
        .into_iter()
        .filter(|line| line.len() == 2 && line[0].1 == line[1].1)
        .map(|line| (line[1].0 - line[0].0) / (right - left))
        .collect();
    assert_eq!(lines.iter().filter(|length| **length > 0.99).count(), 1, "{lines:?}");
    assert!(lines.iter().filter(|length| **length < 0.05).count() > 20, "{lines:?}");
}

/// A hardness that is sought is in HV on the axis too.
#[test]
fn a_sought_hardness_is_in_vickers() {
    let keys = "noise = { restitution = 0.01 }\n[calibrate.free]\n\"half_space.hardness\" = { from = \"50 HV\", to = \"500 HV\" }\n\
                \"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" }\n";
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "").replace("yield_strength = \"345 MPa\"\n", "");
    let desk = Sandbox::with(format!("{still}[calibrate]\ndata = \"d.csv\"\n{keys}"));
    desk.write("d.csv", "speed_m_per_s,restitution,peak_force_N,peak_force_N_sd\n1,0.603,330,5\n3,0.491,1106,10\n");
    desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "svg"], 0);
    let drawn = SvgPicture(desk.read("o/posterior.svg"));
    assert!(has(&drawn, "Half-space hardness [HV]"), "{:?}", drawn.texts());
    let estimate = desk.json("o/summary.json")["keys"][0]["estimate"].as_f64().unwrap();
    // the force in kgf over the area of the pyramid in mm², whose projection is smaller by 2/1.8544
    let vickers = estimate * 1.8544 / 2.0 / 9.806_65e6;
    let [x, _] = drawn.scales(0);
    // a stroke of the cross, the only black line in the box, has the best keys in its middle
    let is_in = drawn.is_in(0);
    let cross = drawn.lines(BLACK).into_iter().find(|line| is_in(line[0])).unwrap();
    let middle = 0.5 * (cross[0].0 + cross[1].0);
    assert!((middle - x.place(vickers)).abs() < UNITS, "{vickers} HV");
}

/// In a picture of many curves each has its own colour, and markers.
#[test]
fn many_curves_have_markers() {
    let axes = "\"impact.speed\" = { logspace = [1e-2, 10], points = 40 }\n\"law\" = \"all\"\n";
    let drawn = drawn(&sweep(axes), "restitution");
    let is_in = drawn.is_in(0);
    // the markers of the sixth and seventh law are strokes, without an area
    for color in [BLUE, VERMILLION, GREEN, PURPLE, ORANGE, "#882255", "#999933", "#8C562B"] {
        let count = drawn.marks(color).into_iter().filter(|at| is_in(*at)).count();
        assert!(count > 1, "{color}: {count} markers");
    }
}

/// A key within the axes has a frame, and a key with one entry that the title of the axis has already is left out.
#[test]
fn legend_has_frame_and_appears_when_needed() {
    let axes = [Axis::linear("x", ""), Axis::linear("y", "")];
    let lines = vec![Series::line("n = -2.623", vec![(0.0, 0.0), (1.0, 1.0)]).with_style(0)];
    let with_key = SvgPicture::from_chart(&Chart::new("t", axes, lines));
    let frame = with_key.lines("#E2E2E2").into_iter().filter(|line| line.len() == 5 && line[0] == line[4]).count();
    assert_eq!(frame, 1);
    // with the sign of a number
    assert!(has(&with_key, "n = −2.623"), "{:?}", with_key.texts());
    let hops = "[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 4\nspot = \"fresh\"\n";
    for (air, has_key) in [("", false), ("[air]\ndensity = 100\ndrag = 0.5\n", true)] {
        let drawn = drawn(&format!("{STEEL}{hops}{air}"), "height");
        assert!(drawn.texts().iter().any(|text| text.starts_with("Height of the lowest point [")));
        assert_eq!(has(&drawn, "With air"), has_key, "{:?}", drawn.texts());
    }
}

/// The colours of a narrow map are beside it, and not on it.
#[test]
fn narrow_map_has_colour_bar_beside_it() {
    let axes = "\"impact.speed\" = { linspace = [1, 2], points = 9 }\n\"half_space.yield_strength\" = { linspace = [3e8, 4e8], points = 9 }";
    let drawn = drawn_as(&sweep(axes), "restitution_map", "narrow-svg");
    let [map, bar] = drawn.boxes()[..] else { panic!("{:?}", drawn.boxes()) };
    let document = drawn.document();
    let left_of_bar = document.descendants().filter(|node| {
        let is_label = node.attribute("text-anchor") == Some("end") || node.attribute("transform").is_some();
        node.has_tag_name("text") && is_label && number(*node, "x") > map[0]
    });
    let begin = left_of_bar.map(|node| number(node, "x")).fold(bar[0], f64::min);
    assert!(map[2] < begin && bar[2] < 800.0 * UNITS, "{map:?} {bar:?}");
}
