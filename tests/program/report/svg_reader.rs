//! A picture as SVG, read back: its boxes, lines, texts and scales.

use plm_impact::report::chart::Chart;
use roxmltree::Node;

use crate::common::prelude::*;

/// Units of the drawing per pixel.
pub const UNITS: f64 = 10.0;
/// The first colours of Okabe and Ito (2008), in the order of the series, and those of outline and measurements.
pub const BLUE: &str = "#0072B2";
pub const VERMILLION: &str = "#D55E00";
pub const GREEN: &str = "#009E73";
pub const PURPLE: &str = "#CC79A7";
pub const ORANGE: &str = "#E69F00";
pub const BLACK: &str = "#000000";
pub const INK: &str = "#222222";

/// A picture that was read back from its SVG.
pub struct SvgPicture(pub String);

pub fn number(node: Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

pub fn points(node: Node) -> Vec<(f64, f64)> {
    let pairs = node.attribute("points").unwrap().split_whitespace().map(|pair| pair.split_once(',').unwrap());
    pairs.map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap())).collect()
}

impl SvgPicture {
    pub fn from_chart(chart: &Chart) -> Self {
        Self(text(&chart.to_svg().unwrap()))
    }

    pub fn document(&self) -> Document<'_> {
        Document::parse(&self.0).unwrap()
    }

    /// The boxes with axes, from the top down: left, top, right, bottom. Their outlines are closed black lines.
    pub fn boxes(&self) -> Vec<[f64; 4]> {
        let outlines = self.lines(INK).into_iter().filter(|line| line.len() == 5 && line[0] == line[4]);
        outlines.map(|corners| [corners[0].0, corners[0].1, corners[2].0, corners[2].1]).collect()
    }

    /// The lines of this colour, in units of the drawing.
    pub fn lines(&self, color: &str) -> Vec<Vec<(f64, f64)>> {
        let document = self.document();
        let lines = document
            .descendants()
            .filter(|node| node.has_tag_name("polyline") && node.attribute("stroke") == Some(color));
        lines.map(points).collect()
    }

    /// The points of the lines of this colour as shares of a box. The level line of 56 pixels in the key is left out.
    pub fn shares_of(&self, color: &str, number: usize) -> Vec<(f64, f64)> {
        let [left, top, right, bottom] = self.boxes()[number];
        let share = |(x, y): (f64, f64)| ((x - left) / (right - left), (bottom - y) / (bottom - top));
        let is_key = |line: &Vec<(f64, f64)>| line[0].1 == line[1].1 && line[1].0 - line[0].0 == 56.0 * UNITS;
        let lines = self.lines(color).into_iter().filter(|line| line.len() != 2 || !is_key(line));
        lines.flatten().map(share).filter(|(x, _)| (-1e-3..=1.0 + 1e-3).contains(x)).collect()
    }

    /// The corners of the areas of this colour.
    pub fn areas(&self, color: &str) -> Vec<Vec<(f64, f64)>> {
        let document = self.document();
        let areas =
            document.descendants().filter(|node| node.has_tag_name("polygon") && node.attribute("fill") == Some(color));
        areas.map(points).collect()
    }

    /// The centres of the discs, squares, triangles and diamonds of this colour.
    pub fn marks(&self, color: &str) -> Vec<(f64, f64)> {
        let document = self.document();
        let centre = |node: Node| match node.tag_name().name() {
            "circle" => Some((number(node, "cx"), number(node, "cy"))),
            "rect" => {
                let middle = |at: &str, length: &str| number(node, at) + 0.5 * number(node, length);
                Some((middle("x", "width"), middle("y", "height")))
            }
            // three fifths of the way from the tip of a triangle to its base; half-way between the corners of a diamond
            "polygon" => {
                let (corners, share) = (points(node), if points(node).len() == 3 { 0.6 } else { 0.5 });
                let (tip, other) = (corners[0], corners[corners.len() / 2]);
                Some((tip.0, tip.1 + share * (other.1 - tip.1)))
            }
            _ => None,
        };
        document.descendants().filter(|node| node.attribute("fill") == Some(color)).filter_map(centre).collect()
    }

    /// Whether a place lies in a box, and not in the key, which stands on the last white rectangle that is no marker.
    pub fn is_in(&self, panel: usize) -> impl Fn((f64, f64)) -> bool + use<> {
        let near = |[left, top, right, bottom]: [f64; 4], (x, y): (f64, f64)| {
            (left - 5.0..=right + 5.0).contains(&x) && (top - 5.0..=bottom + 5.0).contains(&y)
        };
        let is_white = |(ends, color): &([f64; 4], [u8; 3])| *color == [255; 3] && ends[2] - ends[0] > 30.0 * UNITS;
        // the first is the sheet
        let key = self.rectangles().into_iter().filter(is_white).skip(1).last();
        let own = self.boxes()[panel];
        move |at| near(own, at) && !key.is_some_and(|(ends, _)| near(ends, at))
    }

    pub fn shares(&self, color: &str) -> Vec<(f64, f64)> {
        self.shares_of(color, 0)
    }

    pub fn texts(&self) -> Vec<String> {
        let document = self.document();
        let texts = document.descendants().filter(|node| node.has_tag_name("text"));
        texts.map(|node| node.text().unwrap().trim().to_owned()).collect()
    }

    /// The scales of a box, which a reader takes from the labels of its axes.
    pub fn scales(&self, panel: usize) -> [Scale; 2] {
        [self.across(panel), self.upward(panel)]
    }

    /// The horizontal scale, whose labels stand below the lowest box.
    pub fn across(&self, panel: usize) -> Scale {
        let document = self.document();
        let nodes = document.descendants().filter(|node| node.has_tag_name("text"));
        let [left, _, right, _] = self.boxes()[panel];
        let lowest = self.boxes().iter().map(|ends| ends[3]).fold(0.0, f64::max);
        // the first row below the box has the labels, and the second the title
        let below: Vec<Node> = nodes
            .filter(|node| node.attribute("text-anchor") == Some("middle") && node.attribute("transform").is_none())
            .filter(|node| (left..=right).contains(&number(*node, "x")) && number(*node, "y") > lowest)
            .collect();
        let labels_at = below.iter().map(|node| number(*node, "y")).fold(f64::INFINITY, f64::min);
        let (labels, titles): (Vec<Node>, Vec<Node>) = below.iter().partition(|node| number(**node, "y") == labels_at);
        let labels: Vec<(f64, String)> = labels.iter().map(|node| (number(*node, "x"), text_of(*node))).collect();
        // a title that is longer than its box has two rows
        Scale::from_labels(&labels, &titles.iter().map(|title| text_of(*title)).collect::<Vec<_>>().join(" "))
    }

    /// The vertical scale, whose labels stand left of the box, or left of the box that is beside it.
    pub fn upward(&self, panel: usize) -> Scale {
        let document = self.document();
        let [left, top, _, bottom] = self.boxes()[panel];
        let is_level = |node: &Node| (top..bottom + 10.0 * UNITS).contains(&number(*node, "y"));
        let nodes: Vec<Node> =
            document.descendants().filter(|node| node.has_tag_name("text")).filter(is_level).collect();
        let beside = |left: f64| -> Vec<(f64, String)> {
            let is_beside = |node: &&Node| {
                node.attribute("text-anchor") == Some("end")
                    && (left - 50.0 * UNITS..left).contains(&number(**node, "x"))
            };
            // letters stand a little below their tick
            nodes.iter().filter(is_beside).map(|node| (number(*node, "y") - 2.0 * UNITS, text_of(*node))).collect()
        };
        let first = self.boxes().iter().filter(|ends| ends[1] == top).map(|ends| ends[0]).fold(left, f64::min);
        let labels = [left, first].map(beside).into_iter().find(|labels| !labels.is_empty()).unwrap();
        let turned = nodes.iter().filter(|node| node.attribute("transform").is_some() && number(**node, "x") < left);
        let title = turned.max_by(|a, b| number(**a, "x").total_cmp(&number(**b, "x"))).unwrap();
        Scale::from_labels(&labels, &text_of(*title))
    }

    /// The fill of the topmost rectangle at a place.
    pub fn fill_at(&self, (x, y): (f64, f64)) -> [u8; 3] {
        let rectangles = self.rectangles();
        let is_there =
            |[left, top, right, bottom]: &[f64; 4]| (*left..=*right).contains(&x) && (*top..=*bottom).contains(&y);
        rectangles.iter().rev().find(|(ends, _)| is_there(ends)).unwrap().1
    }

    /// The filled rectangles: left, top, right, bottom, and the colour.
    pub fn rectangles(&self) -> Vec<([f64; 4], [u8; 3])> {
        let document = self.document();
        let rectangles = document.descendants().filter(|node| node.has_tag_name("rect")).map(|node| {
            let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(node, name));
            let fill = node.attribute("fill").unwrap();
            let part = |at: usize| u8::from_str_radix(&fill[at..at + 2], 16).unwrap();
            ([x, y, x + width, y + height], [1, 3, 5].map(part))
        });
        rectangles.collect()
    }
}

fn text_of(node: Node) -> String {
    node.text().unwrap().trim().to_owned()
}

/// The values along an axis, in SI units.
pub struct Scale {
    /// Place and value of the first and of the last label.
    ends: [(f64, f64); 2],
    is_logarithmic: bool,
}

impl Scale {
    fn from_labels(labels: &[(f64, String)], title: &str) -> Self {
        let unit = title.split(['[', ']']).nth(1).unwrap_or_default();
        let labels: Vec<(f64, f64)> = labels.iter().map(|(at, label)| (*at, value(label) * factor(unit))).collect();
        let with = |is_logarithmic| Self { ends: [labels[0], *labels.last().unwrap()], is_logarithmic };
        // every label stands where one of the two says
        let off = |scale: &Self| labels.iter().map(|(at, value)| (scale.place(*value) - at).abs()).fold(0.0, nan_max);
        let chosen = [false, true].map(with).into_iter().find(|scale| off(scale) < UNITS);
        assert!(labels.len() > 2, "{title}: {labels:?}");
        chosen.unwrap_or_else(|| panic!("{title}: {labels:?}"))
    }

    /// The value at a place in units of the drawing.
    pub fn value(&self, place: f64) -> f64 {
        let [(from, low), (to, high)] = self.ends;
        let share = (place - from) / (to - from);
        if self.is_logarithmic { low * (high / low).powf(share) } else { low + share * (high - low) }
    }

    /// Where a value stands, in units of the drawing.
    pub fn place(&self, value: f64) -> f64 {
        let ways = |value: f64| if self.is_logarithmic { value.ln() } else { value };
        let [(from, low), (to, high)] = self.ends;
        from + (ways(value) - ways(low)) / (ways(high) - ways(low)) * (to - from)
    }
}

/// The number of a label, as 0.5, −20 or 10⁻³.
fn value(label: &str) -> f64 {
    let number = |text: &str| text.replace(['−', '⁻'], "-").parse().unwrap_or_else(|_| panic!("{label}"));
    let mut power = label.to_owned();
    for (digit, raised) in (0..).zip("⁰¹²³⁴⁵⁶⁷⁸⁹".chars()) {
        power = power.replace(raised, &format!("{digit}"));
    }
    if power == label { number(label) } else { 10_f64.powf(number(&power["10".len()..])) }
}

/// A unit in SI units; degrees stay degrees.
fn factor(unit: &str) -> f64 {
    let prefixes = [("n", 1e-9), ("µ", 1e-6), ("m", 1e-3), ("k", 1e3), ("M", 1e6), ("G", 1e9)];
    let is_bare = |rest: &str| ["m", "s", "N", "Pa", "m/s", "Hz", "N s"].contains(&rest);
    let known = prefixes.iter().find(|(prefix, _)| unit.strip_prefix(prefix).is_some_and(is_bare));
    known.map_or(1.0, |(_, factor)| *factor)
}
