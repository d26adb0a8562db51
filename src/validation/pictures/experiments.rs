//! Pictures of the measurements of the user, with what the law gives for each of them.

use super::super::experiments::{Experiment, Row};
use super::Picture;
use crate::plot::of_key::title_of;
use crate::plot::{Axis, Chart, Series};

/// A picture for every quantity of a file, against the impact speed, or against the place in the file where there is none.
pub(super) fn pictures(of: &Experiment) -> impl Iterator<Item = Picture> {
    of.quantities().map(|(what, mut rows)| {
        rows.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        let has_speed = rows.iter().all(|row| row.speed.is_finite());
        #[allow(clippy::cast_precision_loss)] // lines of a file
        let at = |row: &Row| if has_speed { row.speed } else { row.line as f64 };
        let curve = |value: fn(&Row) -> f64| rows.iter().map(|row| (at(row), value(row))).collect::<Vec<_>>();
        // a point of NaN separates the bars
        let bar = |x: f64, y: f64, sd: f64| [(x, y - sd), (x, y + sd), (f64::NAN, f64::NAN)];
        let bars = rows.iter().filter_map(|row| Some(bar(at(row), row.measured, row.sd?))).flatten().collect();
        let series = vec![
            Series::points("measured, with its sd", curve(|row| row.measured)),
            Series::bare("", bars).styled(0),
            Series::marked_line("law", curve(|row| row.law)).styled(1),
        ];
        let x = if has_speed { Axis::log("Impact speed", "m/s") } else { Axis::linear("Line of the file", "") };
        let y = Axis::engineering(&title_of(what.name()), what.quantity().dimension.si_unit());
        let notes = (!of.source.is_empty()).then(|| of.source.clone());
        (of.picture(what), Chart::new(&of.name, [x, y], series).with_notes(notes))
    })
}
