//! Force against indentation of slow contacts. For one half-space: the approach, and the indentations of sphere and
//! half-space. For several half-spaces: their approaches, in the form of Xie et al. (2024), Fig. 13.

use super::loops::{self, LoopBranches};
use crate::contact::law::Branch;
use crate::impact::indentation::{IndentationRow, SpecimenResult};
use crate::report::chart::{Axis, Chart, Series};
use crate::units::{Dimension, format_result};

pub fn indentation(tested: &[SpecimenResult]) -> Chart {
    let branches = |one: &SpecimenResult| branches(&one.indentation.trace);
    let series = match tested {
        [one] => loops::indentation_loops(&branches(one)),
        several => {
            let one_loop = |(i, one): (usize, &SpecimenResult)| {
                let name = one.specimen.name.as_deref().unwrap_or_default();
                loops::loop_series(name, loops::loop_style(i, 4.0), &branches(one), 0)
            };
            several.iter().enumerate().flat_map(one_loop).collect()
        }
    };
    let rows = || tested.iter().flat_map(|one| &one.indentation.trace);
    let strongest = rows().map(|row| row.force).fold(0.0, f64::max);
    let deepest = rows().map(|row| row.indentation).fold(0.0, f64::max);
    let unloads = rows().any(|row| !is_loading(row));
    let branches = ["loading", "unloading and reloading"];
    let mut entries = Vec::new();
    if let [one] = tested
        && let Some(step) = one.indentation.steps.last()
    {
        let peak = &step.peak;
        entries.push(
            Series::text("Largest load")
                .with_note(format!("Fₘ = {}", format_result(peak.force, Dimension::Force)))
                .with_note(format!("δₘ = {}", format_result(peak.indentation, Dimension::Length)))
                .with_note(format!("δᵣ = {}", format_result(peak.residual_indentation, Dimension::Length))),
        );
    }
    let x = Axis::linear("Indentation", "m").with_range(0.0, 1.06 * deepest);
    let y = Axis::linear("Force", "N").with_range(0.0, 1.08 * strongest);
    let chart = Chart::new(title(tested), [x, y], series);
    chart.with_branches(&branches[..if unloads { 2 } else { 1 }]).with_legend_entries(entries)
}

/// The loop of the trace of one half-space.
fn branches(rows: &[IndentationRow]) -> LoopBranches {
    let branches = rows.chunk_by(|a, b| is_loading(a) == is_loading(b)).map(|branch| {
        let indentations = |row: &IndentationRow| [row.indentation, row.sphere_indentation, row.half_space_indentation];
        let mut rows: Vec<_> = branch.iter().map(|row| (indentations(row), row.force)).collect();
        let is_loading = branch.first().is_some_and(is_loading);
        if !is_loading {
            // unloading and reloading follow the same curve; it is drawn once, so that the gaps between the dashes
            // stay open
            rows.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        }
        (is_loading, rows)
    });
    branches.collect()
}

fn is_loading(row: &IndentationRow) -> bool {
    matches!(row.branch, Branch::Elastic | Branch::Plastic)
}

fn title(tested: &[SpecimenResult]) -> String {
    let strongest =
        tested.iter().flat_map(|one| &one.indentation.steps).map(|step| step.peak.force).fold(0.0, f64::max);
    let load = format_result(strongest, Dimension::Force);
    match tested {
        [one] => match &one.specimen.name {
            Some(name) => format!("Indentation of {name} to {load}"),
            None => format!("Indentation to {load}"),
        },
        several => format!("Indentation of {} half-spaces to {load}", several.len()),
    }
}
