//! The report of `bench`: a CSV file of all settings, one of the laws, a picture of each problem, and a page
//! in Markdown with one table.

use super::laws::LawTiming;
use super::measure::{METHODS, Setting, Timing, is_applicable};
use super::problems::BenchProblem;
use crate::error::Error;
use crate::files::OutputFile;
use crate::impact::Method;
use crate::numerics::power::nan_max;
use crate::report::chart::{Axis, Chart, Series};
use crate::report::text::files::into_bytes;
use crate::strings::markdown_table;

pub type ProblemTimings = (BenchProblem, Vec<Timing>);

/// A column of `speed_vs_error.csv`: its name and its text.
type BenchColumn = (&'static str, fn(&Timing) -> String);

/// The columns behind that of the problem.
const COLUMNS: [BenchColumn; 8] = [
    ("method", |m| m.method.name().to_owned()),
    (
        "tolerance",
        |m| if let Setting::Tolerance(tolerance) = m.setting { format_error(tolerance) } else { String::new() },
    ),
    ("restitution_error", |m| format_error(m.restitution_error)),
    ("contact_time_error", |m| format_error(m.contact_time_error)),
    ("peak_force_error", |m| format_error(m.peak_force_error)),
    ("force_evaluations", |m| m.stats.force_evaluations.to_string()),
    ("steps", |m| m.stats.steps.to_string()),
    ("ns_per_impact", |m| format!("{:.1}", m.ns_per_impact)),
];

fn format_error(value: f64) -> String {
    format!("{value:.3e}")
}

/// Every setting on every problem.
pub fn settings_csv(all: &[ProblemTimings]) -> Result<OutputFile, Error> {
    let rows = all.iter().flat_map(|(problem, measurements)| {
        measurements.iter().map(|m| {
            let cells = COLUMNS.map(|(_, cell)| cell(m));
            std::iter::once(problem.name.to_owned()).chain(cells).collect()
        })
    });
    csv("speed_vs_error.csv", std::iter::once("problem").chain(COLUMNS.map(|(name, _)| name)), rows)
}

/// The time of a row, and of a contact, by law.
pub fn laws_csv(rates: &[LawTiming]) -> Result<OutputFile, Error> {
    let rows = rates
        .iter()
        .map(|rate| vec![rate.law.clone(), format!("{:.1}", rate.ns_per_row), format!("{:.1}", rate.ns_per_contact)]);
    csv("rows_by_law.csv", ["law", "ns_per_row", "ns_per_contact"], rows)
}

fn csv<'a>(
    name: &str,
    columns: impl IntoIterator<Item = &'a str>,
    rows: impl Iterator<Item = Vec<String>>,
) -> Result<OutputFile, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns)?;
    for row in rows {
        writer.write_record(row)?;
    }
    Ok(OutputFile { name: name.into(), bytes: into_bytes(writer)? })
}

/// The page, as Markdown, with the times of the problems as its table. `rates` are rows a second of a table with `columns` columns,
/// computed and made into lines of CSV.
pub fn page(all: &[ProblemTimings], laws: &[LawTiming], (columns, rates): (usize, [f64; 2])) -> String {
    let [computed, csv] = rates.map(|rate| format!("{:.1}", 1e-6 * rate));
    let slowest = |time: fn(&LawTiming) -> f64| microseconds(laws.iter().map(time).fold(0.0, f64::max));
    let fastest = |time: fn(&LawTiming) -> f64| microseconds(laws.iter().map(time).fold(f64::INFINITY, f64::min));
    format!(
        include_str!("page.md"),
        times = time_table(all),
        fastest_row = fastest(|rate| rate.ns_per_row),
        slowest_row = slowest(|rate| rate.ns_per_row),
        fastest_contact = fastest(|rate| rate.ns_per_contact),
        slowest_contact = slowest(|rate| rate.ns_per_contact),
        threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
        columns = columns,
        computed = computed,
        csv = csv,
    )
}

/// Smaller errors are drawn here: a logarithmic axis has no zero.
const ROUNDING: f64 = 1e-16;

/// The picture of a problem: time of one impact against the larger of its errors.
pub fn picture((problem, measurements): &ProblemTimings) -> Result<OutputFile, Error> {
    let series = METHODS.into_iter().filter(|method| is_applicable(*method, problem)).map(|method| {
        let points = measurements
            .iter()
            .filter(|m| m.method == method)
            .map(|m| (nan_max(nan_max(m.restitution_error, m.contact_time_error), ROUNDING), 1e-3 * m.ns_per_impact))
            .collect();
        Series::marked_line(method.name(), points)
    });
    let x = Axis::log("Larger relative error of restitution and contact time", "").with_range(ROUNDING, 1.0);
    let y = Axis::log("Time per impact, one core", "µs");
    let lines = Chart::new(problem.name, [x, y], series.collect()).with_caption(problem.description);
    let name = format!("{}.png", problem.name.to_lowercase().replace(' ', "-"));
    Ok(OutputFile { name, bytes: lines.to_png()? })
}

/// The shortest time of a setting that keeps within a threshold \[ns\].
fn time_to_reach(measurements: &[Timing], method: Method, threshold: f64) -> Option<f64> {
    let reaching = measurements.iter().filter(|m| m.method == method && m.is_within(threshold));
    reaching.map(|m| m.ns_per_impact).min_by(f64::total_cmp)
}

/// To two or three digits.
fn microseconds(ns: f64) -> String {
    let us = 1e-3 * ns;
    let decimals = match us {
        ..0.0995 => 3,
        ..9.95 => 2,
        _ => 0,
    };
    format!("{us:.decimals$}")
}

/// Time of one impact \[µs\] by method and threshold. Behind that of a library method stands how many times as long as rk8 it
/// takes.
fn time_table(all: &[ProblemTimings]) -> String {
    let names = [
        "problem",
        "closed form",
        "rk8, 1e-6",
        "rk8, 1e-9",
        "rk8, 1e-12",
        "dop853, 1e-6",
        "dop853, 1e-9",
        "dopri5, 1e-6",
        "dopri5, 1e-9",
        "verlet, 1e-3",
        "steps of verlet for e within 1 %",
    ];
    let row = |(problem, measurements): &ProblemTimings| {
        let time = |method, threshold| time_to_reach(measurements, method, threshold);
        let alone = |method, threshold| time(method, threshold).map_or_else(|| "–".into(), microseconds);
        let with_ratio = |method, threshold| match (time(method, threshold), time(Method::Rk8, threshold)) {
            (Some(ns), Some(of_rk8)) => format!("{} ({:.1} ×)", microseconds(ns), ns / of_rk8),
            _ => "–".to_owned(),
        };
        vec![
            problem.name.to_owned(),
            alone(Method::ClosedForm, 1e-9),
            alone(Method::Rk8, 1e-6),
            alone(Method::Rk8, 1e-9),
            alone(Method::Rk8, 1e-12),
            with_ratio(Method::Dop853, 1e-6),
            with_ratio(Method::Dop853, 1e-9),
            with_ratio(Method::Dopri5, 1e-6),
            with_ratio(Method::Dopri5, 1e-9),
            with_ratio(Method::Verlet, 1e-3),
            verlet_steps_for_one_percent(measurements),
        ]
    };
    markdown_table(&std::iter::once(names.map(str::to_owned).into()).chain(all.iter().map(row)).collect::<Vec<_>>())
}

/// Steps per contact from which on velocity Verlet keeps e within 1 %. A number of steps serves if all finer settings do too.
fn verlet_steps_for_one_percent(measurements: &[Timing]) -> String {
    let ladder = || {
        measurements.iter().filter_map(|m| if let Setting::Steps(steps) = m.setting { Some((steps, m)) } else { None })
    };
    let last_bad = ladder().filter(|(_, m)| m.restitution_error > 1e-2).map(|(steps, _)| steps).max().unwrap_or(0);
    let needed = ladder().map(|(steps, _)| steps).filter(|steps| *steps > last_bad).min();
    needed.map_or_else(|| format!("more than {last_bad}"), |steps| steps.to_string())
}
