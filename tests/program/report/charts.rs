//! Pictures: curves lie at the places of their values, text stays text and on the sheet. Places are read from the SVG;
//! one test compares it with the PNG, which is drawn from the same data.

use plm_impact::report::chart;

use plm_impact::report::chart::{Axis, Chart, Panel, Series, heatmap};
use plm_impact::report::pictures;
use roxmltree::Node;

use super::svg_reader::*;
use crate::common::prelude::*;

fn impact(sphere_modulus: f64, yield_strength: Option<f64>, speed: f64) -> Impact {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let sphere = Sphere { radius: 5e-3, material: material(sphere_modulus), density: 7850.0, yield_strength: None };
    let half_space = HalfSpace::flat(material(210e9), yield_strength);
    let contact = Contact::try_new(sphere, half_space, &Plm::default()).unwrap();
    contact.impact(speed, &Solver::default(), Some(400)).unwrap()
}

fn scenes() -> [Impact; 4] {
    [
        impact(210e9, Some(345e6), 3.0),
        impact(210e9, None, 3.0),
        impact(f64::INFINITY, Some(345e6), 3.0),
        impact(210e9, Some(345e6), 0.012),
    ]
}

/// The loops of approach, sphere and half-space share a box. A rigid sphere has no loop, and then the half-space has the whole
/// approach.
#[test]
fn force_loops_fill_the_axes() {
    for (impact, has_sphere) in scenes().into_iter().zip([true, true, false, true]) {
        let drawn = SvgPicture::from_chart(&pictures::force_indentation(&impact).unwrap());
        assert_eq!(drawn.boxes().len(), 1);
        for (color, is_drawn) in [(BLUE, true), (VERMILLION, has_sphere), (GREEN, has_sphere)] {
            let points = if is_drawn { drawn.shares_of(color, 0).len() } else { 0 };
            assert!(if is_drawn { points > 100 } else { drawn.lines(color).is_empty() }, "{color}: {points}");
        }
        // the peak is at 1/1.06 and 1/1.08 of the box, from the ranges of the axes; the loop ends at the dent
        let curve = drawn.shares(BLUE);
        let highest = curve.iter().fold((0.0, 0.0), |a: (f64, f64), b| if b.1 > a.1 { *b } else { a });
        assert!((highest.0 - 1.0 / 1.06).abs() < 1e-3 && (highest.1 - 1.0 / 1.08).abs() < 1e-3, "{highest:?}");
        let residual = impact.row.residual_indentation / (1.06 * impact.row.peak_indentation);
        let end = curve.last().unwrap();
        // within the gap between two dashes
        assert!((end.0 - residual).abs() < 8e-3 && end.1.abs() < 8e-3, "{end:?} for {residual}");
    }
}

#[test]
fn an_impact_without_trace_makes_no_picture() {
    let mut impact = impact(210e9, None, 3.0);
    impact.trace.clear();
    assert!(pictures::force_indentation(&impact).is_err_and(|error| error.to_string().contains("needs a trace")));
    assert!(pictures::history(&impact).is_err_and(|error| error.to_string().contains("needs a trace")));
}

fn lines(axes: [Axis; 2], curves: Vec<Vec<(f64, f64)>>) -> Chart {
    let series = curves.into_iter().zip(["first", "second", "third"]);
    let series = series.map(|(points, name)| Series::line(name, points).with_style(chart::Style::LAW));
    Chart::new("a < b & \"c\"", axes, series.collect()).with_notes(["a note\u{7}"])
}

/// Linear axes from 0 to 2 and logarithmic axes from 1 to 10^4, with both ends.
fn axes() -> [([Axis; 2], f64, f64); 2] {
    let linear = |title: &str| Axis::linear(title, "m").with_range(0.0, 2.0);
    let log = |title: &str| Axis::log(title, "m").with_range(1.0, 1e4);
    [([linear("Length"), linear("Height")], 0.0, 2.0), ([log("Length"), log("Height")], 1.0, 1e4)]
}

#[test]
fn a_curve_lies_where_its_values_are() {
    for (axes, low, high) in axes() {
        let chart = lines(axes, vec![vec![(low, low), (high, high)]]);
        let drawn = SvgPicture::from_chart(&chart);
        let ends = drawn.shares(VERMILLION);
        for (got, want) in ends.iter().zip([(0.0, 0.0), (1.0, 1.0)]) {
            assert!((got.0 - want.0).abs() < 1e-3 && (got.1 - want.1).abs() < 1e-3, "{got:?}");
        }
        // the PNG has the colour at the same places
        let [left, top, right, bottom] = drawn.boxes()[0].map(|at| at / UNITS);
        let (width, pixels) = pixels(&chart.to_png().unwrap());
        for share in [0.1, 0.35, 0.6, 0.9] {
            let shows = |x: f64, y: f64| {
                let (x, y) = (left + x * (right - left), bottom - y * (bottom - top));
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                let at = y.round() as usize * width + x.round() as usize;
                pixels[at] == [0xd5, 0x5e, 0x00]
            };
            assert!(shows(share, share) && !shows(share, 0.9 * share), "{share}");
        }
    }
}

#[test]
fn curves_and_guides_are_cut_at_the_axes() {
    let unit = |title: &str| Axis::linear(title, "").with_range(0.0, 1.0);
    let curves = vec![vec![(-1.0, 0.25), (2.0, 0.25)], vec![(0.5, -5.0), (0.5, 5.0)], vec![(-3.0, 9.0), (9.0, 9.0)]];
    let guides = vec![Series::vertical(7.0, "outside"), Series::horizontal(0.75, "level")];
    let drawn = SvgPicture::from_chart(&lines([unit("x"), unit("y")], curves).with_guides(guides));
    let near = |a: f64, b: f64| (a - b).abs() < 1e-3;
    let inside: Vec<_> = drawn.shares(VERMILLION).into_iter().filter(|(x, _)| *x < 1.01).collect();
    let want = [(0.0, 0.25), (1.0, 0.25), (0.5, 0.0), (0.5, 1.0)];
    assert_eq!(inside.len(), want.len(), "{inside:?}");
    assert!(inside.iter().zip(want).all(|(got, want)| near(got.0, want.0) && near(got.1, want.1)), "{inside:?}");
    let texts = drawn.texts();
    assert!(texts.iter().any(|text| text == "level") && !texts.iter().any(|text| text == "outside"), "{texts:?}");
}

#[test]
fn text_stays_in_sheet_with_any_font() {
    let drawn = SvgPicture::from_chart(&lines(axes()[0].0.clone(), vec![vec![(0.0, 0.0), (2.0, 2.0)]]));
    let texts = drawn.texts();
    for want in ["a < b & \"c\"", "Length [m]", "Height [m]", "first", "a note", "0.5"] {
        assert!(texts.iter().any(|text| text == want), "{want} is not in {texts:?}");
    }
    let document = drawn.document();
    let root = document.root_element();
    assert_eq!((number(root, "width"), number(root, "height")), (1600.0, 1000.0));
    assert_eq!(root.attribute("viewBox"), Some("0 0 16000 10000"));
    let nodes = || document.descendants().filter(|node| node.has_tag_name("text"));
    for node in nodes() {
        assert!(node.attribute("font-family").unwrap().ends_with("sans-serif"));
        let (x, y, size) = (number(node, "x"), number(node, "y"), number(node, "font-size"));
        assert!((0.0..16_000.0).contains(&x) && (0.0..10_000.0).contains(&y), "{x} {y}");
        assert!((10.0 * UNITS..40.0 * UNITS).contains(&size), "{size}");
    }
    // the title of the vertical axis reads upwards, and labels end at their ticks
    let upward = nodes().find(|node| node.attribute("transform").is_some()).unwrap();
    assert_eq!(upward.text().unwrap().trim(), "Height [m]");
    assert!(upward.attribute("transform").unwrap().starts_with("rotate(270,"));
    assert!(nodes().any(|node| node.attribute("text-anchor") == Some("end")));
}

#[test]
fn narrow_picture_keeps_letters_and_moves_legend() {
    let curves = || (0..5).map(|i| Series::line(format!("curve {i}"), vec![(0.0, 0.0), (2.0, 3.0)])).collect();
    let chart = Chart::new("Title", [Axis::linear("Length", "m"), Axis::linear("Height", "m")], curves());
    let chart = chart.with_notes([LONG]);
    let [wide, narrow] = [chart.to_svg(), chart.to_narrow_svg()].map(|svg| SvgPicture(text(&svg.unwrap())));
    let size = |drawn: &SvgPicture, name: &str| {
        let document = drawn.document();
        let mut nodes = document.descendants().filter(|node| node.has_tag_name("text"));
        nodes.find(|node| node.text().unwrap().trim() == name).map(|node| number(node, "font-size")).unwrap()
    };
    // a wide picture may draw its key smaller, so that it finds a place inside
    for name in ["Title", "Length [m]", "Height [m]"] {
        assert_eq!(size(&wide, name), size(&narrow, name), "{name}");
    }
    let document = narrow.document();
    let (width, height) = (number(document.root_element(), "width"), number(document.root_element(), "height"));
    assert_eq!(width, 800.0);
    let [left, _, right, bottom] = narrow.boxes()[0].map(|end| end / UNITS);
    assert!(left > 0.0 && right < width && right - left > 0.7 * width, "{left} {right}");
    let place =
        |node: Node| [number(node, "x"), number(node, "y"), number(node, "font-size")].map(|value| value / UNITS);
    let is_key = |node: &Node| node.has_tag_name("text") && node.attribute("text-anchor") == Some("start");
    let key: Vec<_> = document.descendants().filter(is_key).collect();
    assert!(key.len() > 6, "{}", key.len());
    for node in key {
        let ([x, y, size], words) = (place(node), node.text().unwrap().trim());
        assert!(y - size > bottom && y + 0.5 * size < height, "{words} at {y} of {height}");
        // letters are at least half as wide as they are high, on average
        #[allow(clippy::cast_precision_loss)]
        let length = 0.5 * size * words.chars().count() as f64;
        assert!(x >= 0.0 && x + length < width, "{words}");
    }
}

#[test]
fn odd_data_make_a_picture_and_no_panic() {
    let odd: Vec<Vec<(f64, f64)>> = vec![
        vec![],
        vec![(1.0, 1.0)],
        vec![(0.0, 0.0), (f64::NAN, 1.0), (f64::INFINITY, -1.0), (-3.0, 1e300)],
        vec![(1.0, 1.0), (2.0, 1.0 + 1e-16)],
        vec![(5e-324, 1e-310), (1e-300, 1e308)],
    ];
    for points in odd {
        for axis in [Axis::linear("x", "m"), Axis::linear("x", "m"), Axis::log("x", "m")] {
            let series = vec![Series::line("a", points.clone()), Series::marked_line("b", points.clone())];
            let chart = Chart::new("odd", [axis.clone(), axis.clone()], series);
            assert_eq!(SvgPicture::from_chart(&chart).boxes().len(), 1, "{points:?}");
        }
    }
}

#[test]
fn heat_map_colours_each_cell() {
    let map = |values: &[f64]| {
        let axes = [Axis::log("Speed", "m/s"), Axis::linear("Strength", "Pa")];
        let value = |column: usize, row: usize| values[2 * row + column];
        heatmap("e", axes, [&[1.0, 10.0], &[1e8, 2e8]], value, Axis::linear("e", "").with_range(0.0, 1.0))
    };
    let chart = map(&[0.0, 1.0, f64::NAN, 0.5]);
    let [left, top, right, bottom] = SvgPicture::from_chart(&chart).boxes()[0].map(|at| at / UNITS);
    let (width, pixels) = pixels(&chart.to_png().unwrap());
    // both ends of viridis (van der Walt and Smith 2015): 440154 and fde725; places as shares of the axes
    let cells = [((0.2, 0.25), [0x44, 0x01, 0x54]), ((0.65, 0.25), [0xfd, 0xe7, 0x25]), ((0.2, 0.9), [0xe2; 3])];
    for ((x, y), color) in cells {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let [x, y] = [left + x * (right - left), bottom - y * (bottom - top)].map(|at| at.round() as usize);
        let got: [u8; 3] = pixels[y * width + x];
        assert!(got.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 2), "{got:?} for {color:?}");
    }
    // one column has no width, so nothing is drawn
    let axes = || [Axis::linear("x", ""), Axis::linear("y", "")];
    let empty = heatmap("e", axes(), [&[1.0], &[]], |_, _| 0.5, Axis::linear("e", ""));
    assert_eq!(SvgPicture::from_chart(&empty).boxes().len(), 2);
}

const LONG: &str = "A title of forty words that somebody wrote who had much to say about the sphere, the half-space, the speed \
                    and the law, and who would like to read all of it above the picture and not only its middle part";

#[test]
fn long_titles_and_notes_stay_on_sheet() {
    let endless = "word".repeat(200);
    let curves = |count: usize, name: &str| -> Vec<Series> {
        (0..count).map(|i| Series::line(format!("{name} {i}"), vec![(1.0, 1.0), (2.0, 3.0)])).collect()
    };
    let axes = |title: &str| [Axis::linear(title, "m/s"), Axis::linear(title, "N")];
    let assert_fits = |chart: &Chart, what: &str| assert!(has_free_border(&chart.to_png().unwrap()), "{what}");
    for (title, other) in [("short", endless.as_str()), (LONG, LONG), (&endless, "short")] {
        let chart = Chart::new(title, axes(other), curves(3, title)).with_notes([title, LONG]);
        assert_fits(&chart, &format!("{title} / {other}"));
    }
    for count in [1, 40, 300] {
        assert_fits(&Chart::new(LONG, axes("v"), curves(count, "curve")).with_notes([LONG]), &format!("{count}"));
    }
    let linear = || Axis::linear(LONG, "");
    let cells = [&[1.0, 2.0][..], &[1e-9, 2e-9]];
    let value = |column: usize, row: usize| [0.0, 0.1, 0.2, 123_456.0][2 * row + column];
    assert_fits(&heatmap(LONG, [linear(), linear()], cells, value, linear()), "map");
    let panels = vec![Panel::new(linear(), curves(2, LONG)), Panel::new(Axis::linear("y", ""), curves(2, LONG))];
    assert_fits(&Chart::with_panels(LONG, linear(), panels), "boxes");
}

#[test]
fn a_dark_pixel_at_the_border_is_seen() {
    let mut pixels = vec![[255; 3]; 40 * 20];
    assert!(has_white_border(40, &pixels));
    // in the last column, half-way down
    pixels[40 * 10 + 39] = [0; 3];
    assert!(!has_white_border(40, &pixels));
}

/// The number of markers: closed shapes or discs without a line, in this colour, within the first box.
fn markers(drawn: &SvgPicture, color: &str) -> usize {
    let right = drawn.boxes()[0][2];
    let document = drawn.document();
    let is_marker = |node: &Node| node.attribute("fill") == Some(color) && !node.has_tag_name("text");
    let is_inside = |node: &Node| {
        let at = node.attribute("points").map_or_else(|| number(*node, "cx"), |_| points(*node)[0].0);
        at <= right
    };
    document.descendants().filter(is_marker).filter(is_inside).count()
}

/// With few points every one has its marker, also in a picture of another result than e.
#[test]
fn two_angles_have_two_markers() {
    let picture = "[output]\npicture = [\"rebound_angle_deg\"]\n";
    let text = format!(
        "{}[friction]\ncoefficient = 0.1\n{picture}[sweep]\n\"impact.angle\" = [20, 40]\n",
        crate::common::STEEL
    );
    let desk = Sandbox::with(text.replace("[20, 40]", "[\"20 deg\", \"40 deg\"]"));
    desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "svg"], 0);
    let drawn = SvgPicture(desk.read("o/rebound_angle_deg.svg"));
    assert_eq!(markers(&drawn, BLUE), 2, "{}", drawn.0);
}

/// Where the second axis does not move the yield speed, one grey guide shows it; where it does, each curve has its own.
#[test]
fn guides_that_coincide_are_one() {
    for (axis, grey) in
        [("\"damping.viscous\" = [0, 0.1, 0.2]", true), ("\"half_space.yield_strength\" = [3e8, 5e8]", false)]
    {
        let speeds = "\"impact.speed\" = { logspace = [0.001, 10], points = 30 }";
        let desk = Sandbox::with(format!("{}[sweep]\n{speeds}\n{axis}\n", crate::common::STEEL));
        desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "svg"], 0);
        let drawn = SvgPicture(desk.read("o/restitution.svg"));
        let [_, top, right, bottom] = drawn.boxes()[0];
        let is_upright = |line: &&Vec<(f64, f64)>| {
            line.iter().all(|at| (at.0 - line[0].0).abs() < 1.0 && at.0 < right)
                && (line[0].1 - line[1].1).abs() < bottom - top
        };
        let of = |color: &str| drawn.lines(color).iter().filter(is_upright).count();
        assert_eq!(of(BLUE) == 0, grey, "{axis}");
    }
}
