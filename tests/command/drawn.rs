//! A picture as SVG, read back: its boxes, lines, texts and scales.

use plm_impact::report::plot::Chart;
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
pub const INK: &str = "#222222";

/// A picture that was read back from its SVG.
pub struct Drawn(pub String);

pub fn number(node: Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

pub fn points(node: Node) -> Vec<(f64, f64)> {
    let pairs = node.attribute("points").unwrap().split_whitespace().map(|pair| pair.split_once(',').unwrap());
    pairs.map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap())).collect()
}

impl Drawn {
    pub fn of(chart: &Chart) -> Self {
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

    pub fn shares(&self, color: &str) -> Vec<(f64, f64)> {
        self.shares_of(color, 0)
    }

    pub fn texts(&self) -> Vec<String> {
        let document = self.document();
        let texts = document.descendants().filter(|node| node.has_tag_name("text"));
        texts.map(|node| node.text().unwrap().trim().to_owned()).collect()
    }

    /// The scales of a box, which a reader takes from the labels of its axes. They stand left of it, and below the lowest box.
    pub fn scales(&self, panel: usize) -> [Scale; 2] {
        let document = self.document();
        let nodes = || document.descendants().filter(|node| node.has_tag_name("text"));
        let place = |node: Node| (number(node, "x"), number(node, "y"));
        let words = |node: Node| node.text().unwrap().trim().to_owned();
        let [left, top, right, bottom] = self.boxes()[panel];
        let lowest = self.boxes().iter().map(|ends| ends[3]).fold(0.0, f64::max);
        let is_anchored = |node: &Node, at: &str| node.attribute("text-anchor") == Some(at);
        // the first row below the box has the labels, and the second the title
        let below = || {
            nodes()
                .filter(|node| is_anchored(node, "middle") && node.attribute("transform").is_none())
                .filter(move |node| (left..=right).contains(&place(*node).0) && place(*node).1 > lowest)
        };
        let labels_at = below().map(|node| place(node).1).fold(f64::INFINITY, f64::min);
        let (labels, titles): (Vec<Node>, Vec<Node>) = below().partition(|node| place(*node).1 == labels_at);
        let across: Vec<(f64, String)> = labels.iter().map(|node| (place(*node).0, words(*node))).collect();
        // boxes side by side share the labels of the first
        let first = self.boxes().iter().filter(|ends| ends[1] == top).map(|ends| ends[0]).fold(left, f64::min);
        let is_beside =
            |node: &Node| is_anchored(node, "end") && (first - 50.0 * UNITS..first).contains(&place(*node).0);
        let is_level = |node: &Node| (top..bottom + 10.0 * UNITS).contains(&place(*node).1);
        // letters stand a little below their tick
        let upward = nodes().filter(|node| is_beside(node) && is_level(node));
        let upward: Vec<(f64, String)> = upward.map(|node| (place(node).1 - 2.0 * UNITS, words(node))).collect();
        let mut turned = nodes().filter(|node| node.attribute("transform").is_some() && is_level(node));
        [Scale::of(&across, &words(titles[0])), Scale::of(&upward, &words(turned.next().unwrap()))]
    }
}

/// The values along an axis, in SI units.
pub struct Scale {
    /// Place and value of the first and of the last label.
    ends: [(f64, f64); 2],
    is_logarithmic: bool,
}

impl Scale {
    fn of(labels: &[(f64, String)], title: &str) -> Self {
        let unit = title.split(['[', ']']).nth(1).unwrap_or_default();
        let labels: Vec<(f64, f64)> = labels.iter().map(|(at, label)| (*at, value(label) * factor(unit))).collect();
        let with = |is_logarithmic| Self { ends: [labels[0], *labels.last().unwrap()], is_logarithmic };
        // every label stands where one of the two says
        let off =
            |scale: &Self| labels.iter().map(|(at, value)| (scale.place(*value) - at).abs()).fold(0.0, max_or_nan);
        let chosen = [false, true].map(with).into_iter().find(|scale| off(scale) < UNITS);
        assert!(labels.len() > 2, "{title}: {labels:?}");
        chosen.unwrap_or_else(|| panic!("{title}: {labels:?}"))
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
    let is_bare = |rest: &str| ["m", "s", "N", "Pa", "m/s"].contains(&rest);
    let known = prefixes.iter().find(|(prefix, _)| unit.strip_prefix(prefix).is_some_and(is_bare));
    known.map_or(1.0, |(_, factor)| *factor)
}
