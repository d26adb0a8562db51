//! e against the speed of an impact, or against its drop height, with the impact as a point on the curve.

use serde_json::Value;

use super::rows::{rows_of, texts};
use crate::error::Error;
use crate::files::OutputFile;
use crate::numerics::functions::log10;
use crate::report::plot::sweep::pictures;
use crate::report::plot::{Pictures, Series, Style};
use crate::report::run::impact;
use crate::scenario::Scenario;
use crate::scenario::scene::at::at;
use crate::table::count::Tally;
use crate::units::four_digits;

/// Points of the curve.
const POINTS: usize = 601;
/// The curve goes so many decades below the power of ten at or below the impact, and as many above it.
const DECADES: f64 = 2.0;

/// The picture in this format, and its points as CSV; `None` for a sphere that is released at first touch.
pub fn curve(scenario: &Scenario, format: Pictures) -> Result<Option<Value>, Error> {
    let (input, _, impact) = impact::compute(scenario, None)?;
    let (key, at) = match input.number(at!("impact.drop_height")) {
        Some(height) => ("impact.drop_height", height),
        None => ("impact.speed", input.speed()),
    };
    if at <= 0.0 {
        return Ok(None);
    }
    let decade = log10(at).floor();
    let axis =
        format!("sweep.\"{key}\"={{ logspace = [1e{}, 1e{}], points = {POINTS} }}", decade - DECADES, decade + DECADES);
    let source = scenario.source();
    let swept = Scenario::from_text(scenario.document.name(), &source.text, &[axis])?;
    let mut plan = swept.plan()?;
    plan.columns = Some(vec!["restitution"]);
    let drawn = pictures(&plan, &Tally::of(&plan)).into_iter().next();
    drawn
        .map(|(_, mut chart)| {
            let point = Series::points("this impact", vec![(at, impact.restitution)]).styled(Style::BLACK);
            let point = point.and(format!("e = {}", four_digits(impact.restitution)));
            chart.panels.iter_mut().for_each(|panel| panel.series.push(point.clone()));
            "Restitution of the same bodies".clone_into(&mut chart.title);
            let mut files: Vec<OutputFile> = format.file("restitution", &chart)?.into_iter().collect();
            files.push(OutputFile { name: "restitution.csv".to_owned(), bytes: rows_of(&plan)?.0 });
            Ok(texts(files))
        })
        .transpose()
}
