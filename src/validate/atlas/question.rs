//! A question of the atlas, and its picture.

use crate::report::chart::{Axis, Chart, Series, Style};
use crate::strings::names::named_enum;

named_enum! {
    /// Where a series of the atlas comes from.
    pub enum Origin {
        Law = "law",
        FiniteElements = "finite elements",
        Measured = "measured",
    }
}

/// The points of a law or of a set.
#[derive(Debug, Clone)]
pub struct AtlasSeries {
    pub origin: Origin,
    pub name: String,
    /// Its root mean square deviation with its unit; empty without one.
    pub deviation: String,
    pub points: Vec<(f64, f64)>,
}

impl AtlasSeries {
    pub(super) fn new(origin: Origin, name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { origin, name: name.into(), deviation: String::new(), points }
    }

    /// The text in the key.
    fn label(&self) -> String {
        if self.deviation.is_empty() { self.name.clone() } else { format!("{}: {}", self.name, self.deviation) }
    }
}

/// A question and its answers.
#[derive(Debug, Clone)]
pub struct Question {
    /// The name in `atlas.csv` and in the name of the picture.
    pub name: &'static str,
    pub title: &'static str,
    pub caption: &'static str,
    pub axes: [Axis; 2],
    /// True if laws are drawn as points, because each of their values belongs to one reference.
    pub has_points_of_laws: bool,
    pub series: Vec<AtlasSeries>,
}

impl Question {
    pub(super) fn chart(&self) -> Chart {
        let mut numbers = [0; 3];
        let series = self.series.iter().map(|one| {
            let number = numbers[one.origin as usize];
            numbers[one.origin as usize] += 1;
            let drawn = if one.origin == Origin::Law && !self.has_points_of_laws {
                Series::line(one.label(), one.points.clone())
            } else {
                Series::points(one.label(), one.points.clone())
            };
            match one.origin {
                // 13 colours and 7 markers: no two laws have the same of both
                Origin::Law => drawn.with_style(Style::new(number).with_marker_of(number)),
                Origin::FiniteElements => drawn.with_style(Style::GREY.with_marker_of(number)),
                Origin::Measured => drawn.with_style(Style::BLACK.with_marker_of(number)),
            }
        });
        let series = series.collect();
        Chart::new(self.title, self.axes.clone(), series).with_caption(self.caption)
    }
}
