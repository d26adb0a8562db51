//! Runs a scenario of any kind, as the command does.

use std::path::PathBuf;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBytes, PyDict, PyMapping, PyType};

use super::convert::{exception, helper, overrides, source_of, unreadable_exception, warn};
use super::rows::{failures, plan_columns, values};
use super::table::{table as table_of, value_columns};
use super::workers::{append, interruptible, with_capacity};
use crate::files::{OutputFile, Progress};
use crate::report;
use crate::report::chart::PictureFormat;
use crate::report::run::{Outcome, RunOptions, table};
use crate::report::text::{Detail, to_text};
use crate::scenario::{Override, Scenario};

/// The name of measurements that are arrays, in messages.
const DATA: &str = "data";

/// Runs a scenario from a file or from a dict of the same form, such as `run("scenarios/steel-on-steel.toml")`. The keys in
/// `set` replace those of the scenario: `set={"impact.speed": "2 m/s", "law": "thornton"}`. No file is written. Drawing the
/// pictures takes most of the time: leave them out by `pictures=False`.
///
/// Raises ValueError for a bad scenario, with file, line, key, value and what is allowed; ScenarioNotFoundError, which is a
/// FileNotFoundError too, for a missing file; RuntimeError for a run that fails. Warnings are one ModelWarning.
#[pyfunction]
#[pyo3(signature = (scenario, /, *, set=None, pictures=true))]
pub fn run<'py>(
    py: Python<'py>,
    scenario: &Bound<'py, PyAny>,
    set: Option<&Bound<'py, PyMapping>>,
    pictures: bool,
) -> PyResult<Bound<'py, PyAny>> {
    run_scenario(py, &scenario_of(scenario, overrides(set)?)?, pictures)
}

/// Finds keys of a scenario from measurements, as `plm-impact calibrate` does.
///
/// `data` takes the place of the file of measurements. It is a dict of arrays, a table of this module, or a DataFrame of
/// pandas or polars, a table of Arrow. Its columns have the names that such a file has (`speed_m_per_s`, `restitution`,
/// `restitution_sd`); NaN stands for what was not measured. A line k in the results is element k - 2: line 1 has the names.
///
///     found = calibrate("scenarios/calibrate-ball-drop.toml", {"drop_height_mm": [50, 100], "rebound_height_mm": [22.0, 45.1]})
///     found.summary, found.tables["residuals"]
///
/// `pictures=False` leaves the pictures out, as in `run`: a bootstrap needs none. Errors are those of `run`.
#[pyfunction]
#[pyo3(signature = (scenario, data=None, /, *, set=None, pictures=true))]
pub fn calibrate<'py>(
    py: Python<'py>,
    scenario: &Bound<'py, PyAny>,
    data: Option<&Bound<'py, PyAny>>,
    set: Option<&Bound<'py, PyMapping>>,
    pictures: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let mut overrides = overrides(set)?;
    let Some(data) = data else { return run_scenario(py, &scenario_of(scenario, overrides)?, pictures) };
    overrides.push(format!("calibrate.data={DATA}"));
    let csv = helper(py, "csv_of")?.call1((data,))?.extract()?;
    let scenario = scenario_of(scenario, overrides)?.with_data(csv);
    run_scenario(py, &scenario, pictures).map_err(|error| element_error(py, error))
}

/// A scenario that is given as a path or a dict.
pub(super) fn scenario_of(path_or_tables: &Bound<'_, PyAny>, overrides: Vec<String>) -> PyResult<Scenario> {
    let scenario = match path_or_tables.cast::<PyMapping>() {
        Ok(tables) => {
            let source = source_of(tables)?;
            Scenario::from_text("scenario", &source.text, &Override::list(&[source.overrides, overrides].concat()))
        }
        Err(_) => Scenario::load(&path_or_tables.extract::<PathBuf>()?, &Override::list(&overrides)),
    };
    scenario.map_err(|error| unreadable_exception(path_or_tables.py(), error))
}

/// The error of a line of measurements that are arrays: it names the element.
fn element_error(py: Python<'_>, error: PyErr) -> PyErr {
    let text = error.value(py).to_string();
    let parts = text.strip_prefix(DATA).and_then(|rest| rest.strip_prefix(':')?.split_once(':'));
    match parts.and_then(|(line, rest)| Some((line.parse::<usize>().ok()?, rest))) {
        Some((1, rest)) => PyValueError::new_err(format!("{DATA}:{rest}")),
        Some((line, rest)) => PyValueError::new_err(format!("{DATA}, element {}:{rest}", line.saturating_sub(2))),
        None => error,
    }
}

fn run_scenario<'py>(py: Python<'py>, scenario: &Scenario, pictures: bool) -> PyResult<Bound<'py, PyAny>> {
    let command = format!("{}.run({})", env!("CARGO_CRATE_NAME"), scenario.document.name());
    let made = interruptible(py, |progress| report::run::run(scenario, Some(&options(&command, pictures, progress))))?
        .map_err(exception)?;
    if let Some(mut made) = made {
        made.warnings.extend(made.contradiction.take());
        warn(py, 1, &[made.warnings.as_slice(), &made.notes].concat())?;
        return outcome(py, made, None);
    }
    let plan = scenario.plan().map_err(exception)?;
    let rows = usize::try_from(plan.n_cases()).unwrap_or(usize::MAX);
    let named = plan_columns(&plan);
    let mut columns = with_capacity(rows, &vec![1; named.len()])?;
    let made = interruptible(py, |progress| {
        let take = |piece| append(&mut columns, piece);
        let tally = table::compute_rows(&plan, progress, |rows| values(&named, rows), take)?;
        table::summarise(scenario, &plan, &tally, &options(&command, pictures, progress), None)
    });
    let made = made?.map_err(exception)?;
    let failed = failures(columns.last().map_or(&[], Vec::as_slice));
    warn(py, 1, &made.warnings.iter().chain(&made.notes).cloned().chain(failed).collect::<Vec<_>>())?;
    outcome(py, made, Some(table_of(&value_columns(py, [], named, columns)?, rows)?))
}

fn options<'a>(command: &'a str, pictures: bool, progress: &'a Progress) -> RunOptions<'a> {
    let pictures = if pictures { PictureFormat::Png } else { PictureFormat::None };
    RunOptions { command, detail: Detail::Normal, pictures, progress }
}

/// A `plm_impact.Outcome`.
fn outcome<'py>(
    py: Python<'py>,
    Outcome { warnings, blocks, files, .. }: Outcome,
    table: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    static OUTCOME: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let named = PyDict::new(py);
    for OutputFile { name, bytes } in files {
        named.set_item(name, PyBytes::new(py, &bytes))?;
    }
    OUTCOME.import(py, "plm_impact", "Outcome")?.call1((warnings, to_text(&blocks), named, table))
}
