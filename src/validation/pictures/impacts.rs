//! Pictures of whole impacts: force against indentations (Fig. 12 of Xie et al. 2024).

use super::super::EXPONENTS;
use super::super::dynamic::Case;
use super::{Picture, slug};
use crate::impact::TraceRow;
use crate::plot::{Axis, Chart, Series, Style};
use crate::reference::impacts::Sample;

/// An indentation: its name, its value in the reference, and its value in the law.
type Share = (&'static str, fn(&Sample) -> f64, fn(&TraceRow) -> f64);

const SHARES: [Share; 3] = [
    ("approach δ", |sample| sample.indentation, |row| row.indentation),
    ("sphere δₛ", |sample| sample.sphere_indentation, |row| row.sphere_indentation),
    ("half-space δₕ", |sample| sample.half_space_indentation, |row| row.half_space_indentation),
];

/// Restitution by the finite elements and by the law with each exponent.
fn notes(case: &Case) -> Vec<String> {
    let of_law =
        case.impacts.iter().zip(EXPONENTS).map(|(impact, (_, name))| format!("  {name}: {:.4}", impact.restitution));
    let of_reference = format!("  finite elements: {:.4}", case.reference.restitution);
    let with_waves = case.impacts.last().and_then(|impact| impact.restitution_with_waves());
    let with_waves = with_waves.map(|restitution| format!("  … with waves: {restitution:.4}"));
    ["points: finite elements".to_owned(), "Restitution".to_owned(), of_reference]
        .into_iter()
        .chain(of_law)
        .chain(with_waves)
        .collect()
}

pub(super) fn picture(case: &Case) -> Picture {
    let mut series = Vec::new();
    for (i, (name, of_sample, of_row)) in SHARES.into_iter().enumerate() {
        let points = case.samples.iter().map(|sample| (of_sample(sample), sample.force));
        series.push(Series::points(name, points.collect()).styled(i));
        for (which, impact) in case.impacts.iter().enumerate() {
            let curve = impact.trace.iter().map(|row| (of_row(row), row.force)).collect();
            series.push(Series::bare("", curve).styled(Style::of(i).branch(which)));
        }
    }
    let axes = [Axis::engineering("Indentation", "m"), Axis::engineering("Force", "N")];
    let slug = slug(case.name);
    let title = format!("Impact {} (scenarios/dynamic-fe-{slug}.toml)", case.name);
    let chart = Chart::new(title, axes, series).with_branches(&EXPONENTS.map(|(_, name)| name)).with_notes(notes(case));
    (format!("impact-{slug}-force-indentation"), chart)
}
