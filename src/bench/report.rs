//! The report of `bench`: a CSV file of all settings, a picture of each problem, and a page in Markdown.

use super::hard_cases::HardCase;
use super::laws::Rate;
use super::measure::{METHODS, Measurement, Rung, serves};
use super::problems::Problem;
use crate::impact::{Computed, Method, ScaledForces, Solver, closed_form, run};
use crate::integrate::IntegrationError;
use crate::math::power::max_or_nan;
use crate::output::OutputFile;
use crate::plot::PlotError;
use crate::plot::axis::Axis;
use crate::plot::{Chart, Series};
use crate::units::aligned::markdown;

/// A problem with all that was measured on it.
pub type Measured = (Problem, Vec<Measurement>);

/// A column of `speed_vs_error.csv`: its name and its text.
type Column = (&'static str, fn(&Measurement) -> String);

/// The columns behind that of the problem.
const COLUMNS: [Column; 9] = [
    ("method", |m| m.method.name().to_owned()),
    ("tolerance", |m| if let Rung::Tolerance(tolerance) = m.rung { error(tolerance) } else { String::new() }),
    ("restitution_error", |m| error(m.restitution_error)),
    ("contact_time_error", |m| error(m.contact_time_error)),
    ("separation_error", |m| error(m.separation_error)),
    ("peak_force_error", |m| error(m.peak_force_error)),
    ("force_evaluations", |m| m.work.force_evaluations.to_string()),
    ("steps", |m| m.work.steps.to_string()),
    ("ns_per_impact", |m| format!("{:.1}", m.ns_per_impact)),
];

fn error(value: f64) -> String {
    format!("{value:.3e}")
}

pub fn csv(all: &[Measured]) -> Result<OutputFile, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(std::iter::once("problem").chain(COLUMNS.map(|(name, _)| name)))?;
    for (problem, measurements) in all {
        for m in measurements {
            let cells = COLUMNS.map(|(_, cell)| cell(m));
            writer.write_record(std::iter::once(problem.name).chain(cells.iter().map(String::as_str)))?;
        }
    }
    let bytes = writer.into_inner().map_err(csv::IntoInnerError::into_error)?;
    Ok(OutputFile { name: "speed_vs_error.csv".into(), bytes })
}

/// The page with all tables, as Markdown. `rates` are the rows of the table of how fast tables are written, `laws` the times of
/// a row by law.
///
/// # Errors
/// What a method reports on a hard case: none is expected to.
pub fn page(
    all: &[Measured],
    cases: &[HardCase],
    laws: &[Rate],
    rates: Vec<Vec<String>>,
) -> Result<String, IntegrationError> {
    let columns = "columns | computing all results | CSV, end to end | Parquet, end to end";
    Ok(format!(
        include_str!("page.md"),
        ratios = ratio_table(all),
        times = time_table(all),
        verlet = verlet_table(all),
        hard_cases = hard_case_table(cases)?,
        laws = law_table(laws),
        threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
        tables = table(columns, rates).trim_end(),
    ))
}

/// Smaller errors are drawn here: a logarithmic axis has no zero.
const ROUNDING: f64 = 1e-16;

/// The picture of a problem: time of one impact against the larger of its errors.
pub fn picture((problem, measurements): &Measured) -> Result<OutputFile, PlotError> {
    let series = METHODS.into_iter().filter(|method| serves(*method, problem)).map(|method| {
        let points = measurements
            .iter()
            .filter(|m| m.method == method)
            .map(|m| {
                (max_or_nan(max_or_nan(m.restitution_error, m.contact_time_error), ROUNDING), 1e-3 * m.ns_per_impact)
            })
            .collect();
        Series::marked_line(method.name(), points)
    });
    let x = Axis::log("Larger relative error of restitution and contact time", "").between(ROUNDING, 1.0);
    let y = Axis::log("Time per impact, one core", "µs");
    let lines = Chart::new(format!("{}: {}", problem.name, problem.about), [x, y], series.collect());
    let name = format!("{}.png", problem.name.to_lowercase().replace(' ', "-"));
    Ok(OutputFile { name, bytes: lines.to_png()? })
}

const THRESHOLDS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// The shortest time of a setting that keeps within a threshold \[ns\].
fn time_to_reach(measurements: &[Measurement], method: Method, threshold: f64) -> Option<f64> {
    let reaching = measurements.iter().filter(|m| m.method == method && m.reaches(threshold));
    reaching.map(|m| m.ns_per_impact).min_by(f64::total_cmp)
}

fn microseconds(ns: f64) -> String {
    let us = 1e-3 * ns;
    if us < 0.0995 {
        format!("{us:.3}")
    } else if us < 9.95 {
        format!("{us:.2}")
    } else {
        format!("{us:.0}")
    }
}

/// A table in Markdown. `names` has the names of its columns, separated by bars.
fn table(names: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let names = names.split(" | ").map(str::to_owned).collect();
    markdown(&std::iter::once(names).chain(rows).collect::<Vec<_>>())
}

/// Time of one impact \[µs\] to each threshold, and how many times as long Dop853 of `ode_solvers` takes.
fn time_table(all: &[Measured]) -> String {
    let mut rows = Vec::new();
    for (problem, measurements) in all {
        for method in METHODS.into_iter().filter(|method| serves(*method, problem)) {
            let cell = |threshold| {
                let reference = time_to_reach(measurements, Method::Dop853, threshold);
                match (time_to_reach(measurements, method, threshold), reference) {
                    (Some(ns), Some(of_library)) => format!("{} ({:.1} ×)", microseconds(ns), of_library / ns),
                    (Some(ns), None) => microseconds(ns),
                    (None, _) => "–".to_owned(),
                }
            };
            let names = [problem.name, method.name()].map(str::to_owned);
            rows.push(names.into_iter().chain(THRESHOLDS.map(cell)).collect());
        }
    }
    table("problem | method | 1e-3 | 1e-6 | 1e-9 | 1e-12", rows)
}

/// Time of a row of a table, and of a contact, by law.
fn law_table(laws: &[Rate]) -> String {
    let row = |rate: &Rate| vec![rate.law.clone(), microseconds(rate.ns_per_row), microseconds(rate.ns_per_contact)];
    table("law | a row | a new contact", laws.iter().map(row))
}

/// The ratios that rk8 is judged by.
fn ratio_table(all: &[Measured]) -> String {
    let row = |(problem, measurements): &Measured| {
        let time = |method, threshold| time_to_reach(measurements, method, threshold);
        let [rk8, dop853, closed] = [Method::Rk8, Method::Dop853, Method::ClosedForm];
        let ratio = |a: Method, b: Method, threshold| match (time(a, threshold), time(b, threshold)) {
            (Some(a), Some(b)) if a / b < 100.0 => format!("{:.1}", a / b),
            (Some(a), Some(b)) => format!("{:.0}", a / b),
            _ => "–".to_owned(),
        };
        vec![
            problem.name.to_owned(),
            ratio(dop853, rk8, 1e-9),
            ratio(dop853, rk8, 1e-6),
            time(rk8, 1e-12).map_or_else(|| "–".into(), |ns| format!("{} µs", microseconds(ns))),
            ratio(rk8, closed, 1e-9),
        ]
    };
    let names = "problem | Dop853 ÷ rk8 at 1e-9 | at 1e-6 | rk8 reaches 1e-12 in | rk8 ÷ closed form at 1e-9";
    table(names, all.iter().map(row))
}

/// Steps per contact that velocity Verlet needs. A number of steps serves if it and all finer settings keep within the
/// threshold.
fn verlet_table(all: &[Measured]) -> String {
    let row = |(problem, measurements): &Measured| {
        let ladder = || measurements.iter().filter(|m| m.method == Method::Verlet);
        let errors: [fn(&Measurement) -> f64; 3] =
            [|m| m.restitution_error, |m| m.contact_time_error, |m| m.separation_error];
        let mut row = vec![problem.name.to_owned()];
        for error in errors {
            for threshold in [1e-2, 1e-3] {
                let last_bad = ladder().filter(|m| error(m) > threshold).filter_map(steps).max().unwrap_or(0);
                let needed = ladder().filter_map(steps).filter(|steps| *steps > last_bad).min();
                row.push(needed.map_or_else(|| format!("more than {last_bad}"), |steps| steps.to_string()));
            }
        }
        row
    };
    let names = "problem | e within 1 % | e within 0.1 % | contact time within 1 % | contact time within 0.1 % | separation seen within 1 % | separation seen within 0.1 %";
    table(names, all.iter().map(row))
}

fn steps(measurement: &Measurement) -> Option<u32> {
    if let Rung::Steps(steps) = measurement.rung { Some(steps) } else { None }
}

/// The larger relative error of e and contact time of each stepping method at its default tolerance on every hard case.
fn hard_case_table(cases: &[HardCase]) -> Result<String, IntegrationError> {
    let mut rows = Vec::new();
    for case in cases {
        let exact = closed_form::solve(&case.law, case.speed);
        let mut row = vec![case.name.to_owned(), format!("{:.4}", case.restitution)];
        for method in [Method::Rk8, Method::Dop853, Method::Dopri5] {
            let solver = Solver { method, ..Solver::default() };
            let Computed { outcome, .. } =
                run(&case.law, case.speed, &ScaledForces::NONE, Some(&exact), &solver, None)?;
            let of_restitution = (outcome.restitution / case.restitution - 1.0).abs();
            let of_time = (outcome.contact_time / exact.contact_time - 1.0).abs();
            row.push(format!("{:.0e}", max_or_nan(of_restitution, of_time)));
        }
        rows.push(row);
    }
    Ok(table("hard case | e | rk8 | dop853 | dopri5", rows))
}
