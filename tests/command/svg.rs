//! Pictures as SVG: text is text, a curve is at the place of its values, and a run writes the pictures that are asked
//! for.

use crate::common::command::{Desk, text};
use plm_impact::plot::{Axis, Canvas, Lines, Series};
use plm_impact::scenario::Kind;
use roxmltree::{Document, Node};

/// Units of the drawing per pixel.
const UNITS: f64 = 10.0;

fn number(node: Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

fn points(node: Node) -> Vec<(f64, f64)> {
    let pairs = node.attribute("points").unwrap().split_whitespace().map(|pair| pair.split_once(',').unwrap());
    pairs.map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap())).collect()
}

/// The elements of a picture with this name.
fn parts<'a, 'i>(svg: &'a Document<'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    svg.descendants().filter(move |node| node.has_tag_name(name))
}

fn texts(svg: &Document) -> Vec<String> {
    parts(svg, "text").map(|node| node.text().unwrap().trim().to_owned()).collect()
}

fn svg(canvas: &Canvas) -> String {
    text(&canvas.to_svg().unwrap())
}

fn lines(series: Vec<Series>) -> Canvas {
    let axis = |title: &str| Axis::linear(title, "m").between(0.0, 2.0);
    let lines = Lines {
        title: "a < b & \"c\"".into(),
        x: axis("Length"),
        y: axis("Height"),
        series,
        guides: vec![],
        notes: vec!["a note\u{7}".into()],
    };
    lines.draw().unwrap()
}

#[test]
fn a_curve_lies_where_its_values_are() {
    let drawn = svg(&lines(vec![Series::bare("diagonal", vec![(0.0, 0.0), (2.0, 2.0)])]));
    let svg = Document::parse(&drawn).unwrap();
    let root = svg.root_element();
    assert_eq!((number(root, "width"), number(root, "height")), (1600.0, 1000.0));
    assert_eq!(root.attribute("viewBox"), Some("0 0 16000 10000"));
    // the outline of the axes is a closed black line; the first series is blue (Okabe and Ito)
    let of = |color| parts(&svg, "polyline").filter(move |node| node.attribute("stroke") == Some(color));
    let outline = of("#222222").map(points).find(|points| points.len() == 5).unwrap();
    let (left, top) = outline[0];
    let (right, bottom) = outline[2];
    assert!(right - left > 0.5 * 16_000.0 && bottom - top > 0.5 * 10_000.0);
    let curve = of("#0072B2").map(points).next().unwrap();
    for ((x, y), (at_x, at_y)) in [(curve[0], (left, bottom)), (*curve.last().unwrap(), (right, top))] {
        assert!((x - at_x).abs() <= 1.0 && (y - at_y).abs() <= 1.0, "{curve:?} in {outline:?}");
    }
}

#[test]
fn text_stays_text_within_the_sheet_in_any_font() {
    let drawn = svg(&lines(vec![Series::bare("f(x) <= 1", vec![(0.0, 0.0), (2.0, 2.0)])]));
    let svg = Document::parse(&drawn).unwrap();
    let texts = texts(&svg);
    for want in ["a < b & \"c\"", "Length [m]", "Height [m]", "f(x) <= 1", "a note", "0.5"] {
        assert!(texts.iter().any(|text| text == want), "{want} is not in {texts:?}");
    }
    for node in parts(&svg, "text") {
        assert!(node.attribute("font-family").unwrap().ends_with("sans-serif"));
        let (x, y, size) = (number(node, "x"), number(node, "y"), number(node, "font-size"));
        assert!((0.0..16_000.0).contains(&x) && (0.0..10_000.0).contains(&y), "{x} {y}");
        assert!((10.0 * UNITS..40.0 * UNITS).contains(&size), "{size}");
    }
    // the title of the vertical axis reads upwards, and labels end at their ticks
    let upward = parts(&svg, "text").find(|node| node.attribute("transform").is_some()).unwrap();
    assert_eq!(upward.text().unwrap().trim(), "Height [m]");
    assert!(upward.attribute("transform").unwrap().starts_with("rotate(270,"));
    assert!(parts(&svg, "text").any(|node| node.attribute("text-anchor") == Some("end")));
}

#[test]
fn every_kind_of_run_writes_the_pictures_that_it_is_asked_for() {
    for (kind, _) in Kind::ALL {
        let desk = Desk::with("");
        let file = format!("{kind}.toml");
        assert_eq!(desk.call(&["init", kind]).status.code(), Some(0));
        let run = |format: &str| {
            let output = desk.call(&["run", &file, "--pictures", format, "--out", format]);
            assert_eq!(output.status.code(), Some(0), "{kind}: {}", text(&output.stderr));
            let names = desk.files(format);
            let of = |ending: &str| -> Vec<String> {
                names.iter().filter_map(|name| Some(name.strip_suffix(ending)?.to_owned())).collect()
            };
            (of(".png"), of(".svg"), names.len())
        };
        let (png, svg, none) = (run("png"), run("svg"), run("none"));
        assert!(!png.0.is_empty() && png.0 == svg.1, "{kind}: {png:?} {svg:?}");
        assert!(png.1.is_empty() && svg.0.is_empty() && none.0.is_empty() && none.1.is_empty());
        // only pictures are left out
        assert_eq!(none.2, png.2 - png.0.len(), "{kind}");
        for name in &svg.1 {
            let drawn = desk.read(&format!("svg/{name}.svg"));
            let svg = Document::parse(&drawn).unwrap();
            assert!(texts(&svg).len() > 5 && parts(&svg, "polyline").count() > 2, "{kind}: {name}");
            assert_eq!(parts(&svg, "image").count(), 0);
        }
    }
}

#[test]
fn the_report_of_a_validation_shows_its_pictures_as_svg() {
    let desk = Desk::with("");
    let output = desk.call(&["validate", "--out", "v", "--pictures", "svg"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let page = desk.read("v/README.md");
    let shown: Vec<&str> = page.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()).collect();
    let pictures: Vec<&&str> = shown.iter().filter(|name| name.contains(".svg")).collect();
    assert!(pictures.len() > 3 && !page.contains(".png"), "{shown:?}");
    for name in pictures {
        assert!(Document::parse(&desk.read(&format!("v/{name}"))).is_ok(), "{name}");
    }
}

#[test]
fn merged_shards_have_the_pictures_of_the_undivided_run() {
    let desk = Desk::with("");
    let run = |arguments: &[&str]| {
        let output = desk.call(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    };
    run(&["init", "sweep"]);
    run(&["run", "sweep.toml", "--pictures", "svg", "--out", "whole"]);
    for shard in ["0/2", "1/2"] {
        run(&["run", "sweep.toml", "--shard", shard, "--out", "shards"]);
    }
    for (format, count) in [("svg", 3), ("none", 2)] {
        run(&["merge", "shards", "--out", &format!("{format}/table.csv"), "--pictures", format]);
        assert_eq!(desk.files(format).len(), count, "{:?}", desk.files(format));
    }
    assert_eq!(desk.read("svg/restitution.svg"), desk.read("whole/restitution.svg"));
    let place = desk.call(&["merge", "shards", "--out", "restitution.svg"]);
    assert!(text(&place.stderr).contains("is the name of a picture"), "{}", text(&place.stderr));
}
