//! Pictures of whole impacts: force against indentations and against time (Fig. 12).

use super::super::EXPONENTS;
use super::super::dynamic::Case;
use super::{Picture, SISTER, slug};
use crate::impact::TraceRow;
use crate::plot::{Axis, Chart, Series};
use crate::reference::impacts::Sample;

/// An indentation: its name, its value in the reference, and its value in the law.
type Share = (&'static str, fn(&Sample) -> f64, fn(&TraceRow) -> f64);

const SHARES: [Share; 3] = [
    ("approach δ", |sample| sample.indentation, |row| row.indentation),
    ("sphere δₛ", |sample| sample.sphere_indentation, |row| row.sphere_indentation),
    ("half-space δₕ", |sample| sample.half_space_indentation, |row| row.half_space_indentation),
];

pub(super) fn pictures(cases: &[Case]) -> Vec<Picture> {
    cases.iter().flat_map(|case| [force_indentation(case), history(case)]).collect()
}

fn picture(kind: &str, case: &Case, axes: [Axis; 2], series: Vec<Series>) -> Picture {
    let slug = slug(case.name);
    let title = format!("Impact {} (scenarios/dynamic-fe-{slug}.toml)", case.name);
    (format!("impact-{slug}-{kind}"), Chart::new(title, axes, series).with_notes(notes(case)))
}

/// Restitution by the finite elements and by the law with each exponent.
fn notes(case: &Case) -> Vec<String> {
    let of_law =
        case.impacts.iter().zip(EXPONENTS).map(|(impact, (_, name))| format!("  {name}: {:.4}", impact.restitution));
    let of_reference = format!("  finite elements: {:.4}", case.reference.restitution);
    let with_waves = case.impacts.last().and_then(|impact| impact.restitution_with_waves());
    let with_waves = with_waves.map(|restitution| format!("  … with waves: {restitution:.4}"));
    ["Restitution".to_owned(), of_reference].into_iter().chain(of_law).chain(with_waves).collect()
}

fn force_indentation(case: &Case) -> Picture {
    let mut series = Vec::new();
    for (i, (name, of_sample, of_row)) in SHARES.into_iter().enumerate() {
        let points = case.samples.iter().map(|sample| (of_sample(sample), sample.force));
        series.push(Series::points(format!("{name}, finite elements"), points.collect()).styled(i));
        for (which, (impact, (_, exponent))) in case.impacts.iter().zip(EXPONENTS).enumerate() {
            let curve = impact.trace.iter().map(|row| (of_row(row), row.force)).collect();
            series.push(Series::bare(format!("{name}, {exponent}"), curve).styled(i + SISTER * which));
        }
    }
    let axes = [Axis::engineering("Indentation", "m"), Axis::engineering("Force", "N")];
    picture("force-indentation", case, axes, series)
}

fn history(case: &Case) -> Picture {
    let points = case.samples.iter().map(|sample| (sample.time, sample.force)).collect();
    let mut series = vec![Series::points("finite elements", points)];
    for (i, (impact, (_, exponent))) in case.impacts.iter().zip(EXPONENTS).enumerate() {
        let curve = impact.trace.iter().map(|row| (row.time, row.force)).collect();
        series.push(Series::bare(format!("law, {exponent}"), curve).styled(i + 1));
    }
    let axes = [Axis::engineering("Time", "s"), Axis::engineering("Force", "N")];
    picture("history", case, axes, series)
}
