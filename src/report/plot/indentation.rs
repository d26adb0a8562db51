//! Force against indentation of slow contacts. For one half-space: the approach, and the indentations of sphere and
//! half-space. For several half-spaces: their approaches, in the form of Xie et al. (2024), Fig. 13.

use super::{Axis, Chart, Series, Style, loops};
use crate::contact::law::Branch;
use crate::impact::indentation::{IndentationRow, Tested};
use crate::units::{Dimension, quantity};

type Quantity = fn(&IndentationRow) -> f64;

pub fn indentation(tested: &[Tested]) -> Chart {
    let mut of_sphere = Vec::new();
    let series = match tested {
        [one] => {
            let quantities: [Quantity; 3] =
                [|row| row.indentation, |row| row.sphere_indentation, |row| row.half_space_indentation];
            let drawn = |i: usize| {
                let (name, width) = loops::INDENTATIONS[i];
                one_loop(name, &one.indentation.trace, quantities[i], loops::style(i, width))
            };
            let (drawn, aside) = loops::arranged([0, 1, 2].map(drawn));
            of_sphere = aside;
            drawn
        }
        several => {
            let numbered = several.iter().enumerate();
            numbered
                .flat_map(|(i, one)| {
                    let name = one.specimen.name.as_deref().unwrap_or_default();
                    one_loop(name, &one.indentation.trace, |row| row.indentation, loops::style(i, 4.0))
                })
                .collect()
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
        let memory = &step.memory;
        entries.push(
            Series::text("Largest load")
                .and(format!("Fₘ = {}", quantity(memory.force, Dimension::Force)))
                .and(format!("δₘ = {}", quantity(memory.indentation, Dimension::Length)))
                .and(format!("δᵣ = {}", quantity(memory.residual_indentation, Dimension::Length))),
        );
    }
    let x = Axis::engineering("Indentation", "m").between(0.0, 1.06 * deepest);
    let y = Axis::engineering("Force", "N").between(0.0, 1.08 * strongest);
    let chart = Chart::new(title(tested), [x, y], series);
    let chart = chart.with_branches(&branches[..if unloads { 2 } else { 1 }]).with_entries(entries);
    loops::with_sphere(chart, of_sphere)
}

/// The loop of the trace of one half-space, against one kind of indentation.
fn one_loop(name: &str, rows: &[IndentationRow], quantity: Quantity, style: Style) -> Vec<Series> {
    let branches = rows.chunk_by(|a, b| is_loading(a) == is_loading(b)).map(|branch| {
        let mut points: Vec<_> = branch.iter().map(|row| (quantity(row), row.force)).collect();
        let is_loading = branch.first().is_some_and(is_loading);
        if !is_loading {
            // unloading and reloading follow the same curve; it is drawn once, so that the gaps between the dashes
            // stay open
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        (is_loading, points)
    });
    loops::series(Series::line(name, Vec::new()), style, branches)
}

fn is_loading(row: &IndentationRow) -> bool {
    matches!(row.branch, Branch::Elastic | Branch::Plastic)
}

fn title(tested: &[Tested]) -> String {
    let strongest =
        tested.iter().flat_map(|one| &one.indentation.steps).map(|step| step.memory.force).fold(0.0, f64::max);
    let load = quantity(strongest, Dimension::Force);
    match tested {
        [one] => match &one.specimen.name {
            Some(name) => format!("Indentation of {name} to {load}"),
            None => format!("Indentation to {load}"),
        },
        several => format!("Indentation of {} half-spaces to {load}", several.len()),
    }
}
