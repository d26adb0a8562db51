//! The forces of the rows of a table, against time and against indentation: one curve for each row.

use super::loops;
use super::sweep::{axis_words, value_label};
use crate::report::chart::{Axis, Chart, Series, SeriesKind, Style, min_max};
use crate::scenario::plan::{Plan, SweepAxis};
use crate::table::traces::RowTrace;

/// Pictures with more curves than this have markers on each.
const PLAIN_CURVES: usize = 6;

/// The two pictures, with their names.
pub fn charts(plan: &Plan, traces: &[RowTrace]) -> Vec<(String, Chart)> {
    let names: Vec<String> = traces.iter().map(|trace| curve_name(plan.axes(), &trace.places)).collect();
    let (_, strongest) = min_max(traces.iter().flat_map(RowTrace::rows).map(|row| row.force));
    let force = || Axis::linear("Force", "N").with_range(0.0, 1.08 * strongest);
    let fixed = plan.axes().iter().filter(|axis| axis.len() == 1);
    let notes: Vec<String> = fixed.map(|axis| format!("{} = {}", axis_words(axis), value_label(axis, 0))).collect();
    let by = title_end(plan.axes());
    let time = Chart::new(format!("Force against time{by}"), [time_axis(traces), force()], time_curves(traces, &names));
    let indentation = indentation_chart(format!("Force against indentation{by}"), traces, &names, force());
    let charts = [("force_time", time), ("force_indentation", indentation)];
    charts.map(|(name, chart)| (name.to_owned(), chart.with_notes(notes.clone()))).into()
}

/// The values of a row on the axes that vary: "3 m/s, 345 MPa".
fn curve_name(axes: &[SweepAxis], places: &[u64]) -> String {
    let varied = axes.iter().zip(places).filter(|(axis, _)| axis.len() > 1);
    varied.map(|(axis, place)| value_label(axis, *place)).collect::<Vec<_>>().join(", ")
}

/// The end of a title, with the axes to which the values of the key belong: " by impact speed and half-space yield strength".
fn title_end(axes: &[SweepAxis]) -> String {
    let words: Vec<String> = axes.iter().filter(|axis| axis.len() > 1).map(axis_words).collect();
    if words.is_empty() { String::new() } else { format!(" by {}", words.join(" and ")) }
}

fn time_axis(traces: &[RowTrace]) -> Axis {
    let (_, last) = min_max(traces.iter().flat_map(RowTrace::rows).map(|row| row.time));
    Axis::linear("Time", "s").with_range(0.0, 1.03 * last)
}

fn time_curves(traces: &[RowTrace], names: &[String]) -> Vec<Series> {
    let curve = |(number, (trace, name)): (usize, (&RowTrace, &String))| {
        let points = trace.rows().iter().map(|row| (row.time, row.force)).collect();
        let kind = if traces.len() > PLAIN_CURVES { SeriesKind::LabelledLine } else { SeriesKind::Line };
        Series { kind, ..Series::line(name.clone(), points).with_style(Style::new(number)) }
    };
    traces.iter().zip(names).enumerate().map(curve).collect()
}

fn indentation_chart(title: String, traces: &[RowTrace], names: &[String], force: Axis) -> Chart {
    let (_, deepest) = min_max(traces.iter().flat_map(RowTrace::rows).map(|row| row.indentation));
    let curves = traces.iter().zip(names).enumerate().flat_map(|(number, (trace, name))| {
        let branches = loops::impact_loop(&trace.impact).unwrap_or_default();
        loops::loop_series(name.clone(), loops::loop_style(number, 4.0), &branches, 0)
    });
    let x = Axis::linear("Indentation", "m").with_range(0.0, 1.06 * deepest);
    Chart::new(title, [x, force], curves.collect()).with_branches(&["loading", "unloading"])
}
