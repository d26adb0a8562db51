//! Force against indentation of slow contacts. For one half-space: the approach, and the indentations of sphere and
//! half-space. For several half-spaces: their approaches, in the form of Xie et al. (2024), Fig. 13. Error bars show
//! the uncertainty at the ends of steps.

use super::PlotError;
use super::axis::Axis;
use super::canvas::Canvas;
use super::key::Entry;
use super::sheet::single;
use super::style::{DASHED, Marker, SOLID, Stroke, series, solid};
use crate::indentation::{Tested, TraceRow};
use crate::law::Branch;
use crate::units::rounded::quantity;

/// Radius of markers \[px\].
const MARK: f64 = 9.0;
/// Half the length of the caps of error bars \[px\].
const CAP: f64 = 8.0;
/// Distance between error bars \[px\].
const BAR: f64 = 20.0;

type Quantity = fn(&TraceRow) -> f64;

/// A loop: the trace of one half-space, against one kind of indentation.
struct Loop<'a> {
    name: String,
    rows: &'a [TraceRow],
    indentation: Quantity,
    width: f64,
}

impl Loop<'_> {
    /// Its style if it is the loop of this number.
    fn style(&self, index: usize) -> (Stroke, Marker) {
        solid(index, self.width, MARK)
    }

    fn place(&self, row: &TraceRow) -> (f64, f64) {
        ((self.indentation)(row), row.force)
    }
}

pub fn indentation(tested: &[Tested]) -> Result<Canvas, PlotError> {
    let loops = loops(tested);
    let rows = || loops.iter().flat_map(|one| one.rows);
    let deepest = rows().map(|row| row.indentation).fold(0.0, f64::max);
    let deepest = spans(tested).map(|([_, high], ..)| high).fold(deepest, f64::max);
    let strongest = rows().map(|row| row.force).fold(0.0, f64::max);
    let room = if spans(tested).next().is_some() { 1.16 } else { 1.08 };
    let x = Axis::engineering("Indentation", "m").between(0.0, 1.06 * deepest).fitted([]);
    let y = Axis::engineering("Force", "N").between(0.0, room * strongest).fitted([]);
    single(&title(tested), [x, y], &entries(&loops, tested), |frame, canvas| {
        frame.draw_outline(canvas);
        for (i, one) in loops.iter().enumerate() {
            for branch in one.rows.chunk_by(|a, b| is_loading(a) == is_loading(b)) {
                let mut rows: Vec<&TraceRow> = branch.iter().collect();
                let is_loading = rows.first().is_some_and(|row| is_loading(row));
                if !is_loading {
                    // unloading and reloading follow the same curve; it is drawn once, so that the gaps between the
                    // dashes stay open
                    rows.sort_by(|a, b| a.indentation.total_cmp(&b.indentation));
                }
                let dash = if is_loading { SOLID } else { DASHED };
                frame.curve(canvas, rows.into_iter().map(|row| one.place(row)), Stroke { dash, ..one.style(i).0 });
            }
        }
        for (i, one) in loops.iter().enumerate() {
            for row in marked(one.rows, i, loops.len()) {
                frame.mark(canvas, one.place(row), one.style(i).1);
            }
        }
        for ([low, high], force, i) in spans(tested) {
            let stroke = Stroke::solid(series(i).0.color, 3.0);
            // one above the other, because all loops may end at the same load
            #[allow(clippy::cast_precision_loss)] // a handful
            let above = |(x, y): (f64, f64)| (x, y - 0.5 * BAR - BAR * i as f64);
            let (low, high) = (above(frame.place(low, force)), above(frame.place(high, force)));
            canvas.polyline(&[low, high], stroke);
            for (x, y) in [low, high] {
                canvas.polyline(&[(x, y - CAP), (x, y + CAP)], stroke);
            }
        }
    })
}

fn is_loading(row: &TraceRow) -> bool {
    matches!(row.branch, Branch::Elastic | Branch::Plastic)
}

fn loops(tested: &[Tested]) -> Vec<Loop<'_>> {
    if let [one] = tested {
        let rows = one.indentation.trace.as_slice();
        let shares: [(&str, Quantity, f64); 3] = [
            ("Approach δ", |row| row.indentation, 7.0),
            ("Sphere δₛ", |row| row.sphere_indentation, 5.0),
            ("Half-space δₕ", |row| row.half_space_indentation, 3.0),
        ];
        return shares.map(|(name, indentation, width)| Loop { name: name.into(), rows, indentation, width }).into();
    }
    let mut loops = Vec::new();
    for one in tested {
        let name = one.specimen.name.clone().unwrap_or_default();
        let indentation: Quantity = |row| row.indentation;
        loops.push(Loop { name, rows: &one.indentation.trace, indentation, width: 4.0 });
    }
    loops
}

/// The rows of a loop at which its marker is drawn: where the force passes a share of its maximum. The share differs
/// from loop to loop.
fn marked(rows: &[TraceRow], index: usize, count: usize) -> impl Iterator<Item = &TraceRow> {
    let strongest = rows.iter().map(|row| row.force).fold(0.0, f64::max);
    #[allow(clippy::cast_precision_loss)] // a handful
    let share = 0.3 + 0.5 * (index as f64 + 0.5) / count as f64;
    let at = share * strongest;
    rows.windows(2).filter(move |pair| (pair[0].force < at) != (pair[1].force < at)).map(|pair| &pair[1])
}

/// Ranges of the indentation at the ends of steps in load control, with the load and the index of the half-space.
fn spans(tested: &[Tested]) -> impl Iterator<Item = ([f64; 2], f64, usize)> {
    tested.iter().enumerate().flat_map(|(i, one)| {
        one.indentation.steps.iter().enumerate().filter_map(move |(number, step)| {
            let [low, high] = one.span(number, |step| step.indentation)?;
            (high > low).then_some(([low, high], step.force, i))
        })
    })
}

fn entries(loops: &[Loop], tested: &[Tested]) -> Vec<Entry> {
    let entry = |(i, one): (usize, &Loop)| {
        let (stroke, marker) = one.style(i);
        Entry::line(&one.name, stroke).marked(marker)
    };
    let mut entries: Vec<Entry> = loops.iter().enumerate().map(entry).collect();
    let unloads = loops.iter().flat_map(|one| one.rows).any(|row| !is_loading(row));
    let branches = ["loading", "unloading and reloading"];
    entries.extend(Entry::branches(&branches[..if unloads { 2 } else { 1 }]));
    if let [one] = tested
        && let Some(step) = one.indentation.steps.last()
    {
        let memory = &step.memory;
        entries.push(
            Entry::text("Largest load")
                .and(format!("Fₘ = {}", quantity(memory.force, "N")))
                .and(format!("δₘ = {}", quantity(memory.indentation, "m")))
                .and(format!("δᵣ = {}", quantity(memory.residual_indentation, "m"))),
        );
    }
    if spans(tested).next().is_some() {
        entries.push(Entry::text("Bars: uncertain inputs").and("at the ends of steps"));
    }
    entries
}

fn title(tested: &[Tested]) -> String {
    let strongest =
        tested.iter().flat_map(|one| &one.indentation.steps).map(|step| step.memory.force).fold(0.0, f64::max);
    let load = quantity(strongest, "N");
    match tested {
        [one] => match &one.specimen.name {
            Some(name) => format!("Indentation of {name} to {load}"),
            None => format!("Indentation to {load}"),
        },
        several => format!("Indentation of {} half-spaces to {load}", several.len()),
    }
}
