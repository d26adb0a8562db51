//! Runs a scenario of any kind, as the command does.

use std::path::Path;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use super::convert::{exception, scenario_text, toml_value, warn};
use super::rows::{failure, of_plan, say_failures};
use super::table::{Column, Table};
use super::work::interruptible;
use crate::error::Error;
use crate::output::{OutputFile, SUMMARY};
use crate::plan::Plan;
use crate::plot::Pictures;
use crate::progress::Counter;
use crate::provenance::Provenance;
use crate::report;
use crate::run::{Order, Outcome as Written, Run, table, way};
use crate::scenario::Scenario;
use crate::sweep::count::Count;
use crate::sweep::sidecar::Tally;

/// The results of a scenario: `files` are the files that the command writes, `tables` are the tables among them, and
/// `pictures` are the pictures (PNG).
#[pyclass(frozen, module = "plm_impact")]
#[derive(Debug)]
pub struct Outcome {
    /// The warnings about scene, model and run.
    #[pyo3(get)]
    warnings: Vec<String>,
    text: String,
    files: Vec<OutputFile>,
    /// The table of a sweep, or of random cases.
    table: Option<Py<Table>>,
}

/// Runs a scenario from a file or from a dict of the same form. The keys in `set` replace those of the scenario. No
/// file is written.
#[pyfunction]
#[pyo3(signature = (scenario, /, *, set=None))]
pub fn run(py: Python<'_>, scenario: &Bound<'_, PyAny>, set: Option<&Bound<'_, PyDict>>) -> PyResult<Outcome> {
    let mut overrides = Vec::new();
    for (key, value) in set.into_iter().flatten() {
        let key: String = key.extract()?;
        overrides.push(format!("{key}={}", toml_value(&value, &key, 0)?));
    }
    let scenario = match scenario.cast::<PyDict>() {
        Ok(tables) => Scenario::from_text("scenario", &scenario_text(tables)?, &overrides),
        Err(_) => Scenario::load(Path::new(&scenario.extract::<std::path::PathBuf>()?), &overrides),
    };
    let scenario = scenario.map_err(exception)?;
    let command = format!("{}.run({})", env!("CARGO_CRATE_NAME"), scenario.document.name());
    match way(scenario.kind().map_err(exception)?).run {
        Run::Once { run, .. } => {
            let order = Order { command: &command, pictures: Pictures::Png, progress: &Counter::default() };
            let Written { mut warnings, text, files, contradiction } =
                interruptible(py, |_| run(&scenario, &order))?.map_err(exception)?;
            warnings.extend(contradiction);
            warn(py, &warnings)?;
            Ok(Outcome { warnings, text, files, table: None })
        }
        Run::Table => run_table(py, &scenario, &command),
    }
}

fn run_table(py: Python<'_>, scenario: &Scenario, command: &str) -> PyResult<Outcome> {
    let plan = table::plan(scenario).map_err(exception)?;
    let warnings = table::warnings(&plan);
    warn(py, &warnings)?;
    let (made, swept) = of_plan(py, &plan)?;
    let status = made.status.clone();
    say_failures(py, status.len(), status.iter().copied())?;
    let table = Table::new(made.table(&plan, swept));
    let made = interruptible(py, |_| {
        let tally = tally(&plan, &table, &status);
        let provenance = Provenance::new(scenario.sha256()?, command);
        let files = table::files(&plan, &tally, &warnings, &provenance, Pictures::Png)?;
        Ok::<_, Error>((report::sweep::lines(&tally), files))
    });
    let (text, files) = made?.map_err(exception)?;
    Ok(Outcome { warnings, text, files, table: Some(Py::new(py, table)?) })
}

/// Counts of the rows of a table, and the statistics of e.
fn tally(plan: &Plan, table: &Table, status: &[u8]) -> Tally {
    let mut tally = Tally::of(plan);
    let Some(Column::Numbers(restitutions)) = table.column("restitution") else { return tally };
    for (restitution, status) in restitutions.values().iter().zip(status) {
        tally.push(match failure(*status) {
            Some(failure) => failure.into(),
            None if restitution.is_nan() => Count::AtRest,
            None => Count::Restitution(*restitution),
        });
    }
    tally
}

impl Outcome {
    fn ending<'a>(&'a self, ending: &'a str) -> impl Iterator<Item = (&'a str, &'a [u8])> {
        self.files.iter().filter_map(move |file| Some((file.name.strip_suffix(ending)?, file.bytes.as_slice())))
    }

    /// The files with this ending, as bytes by the rest of the name.
    fn bytes<'py>(&self, py: Python<'py>, ending: &str) -> PyResult<Bound<'py, PyDict>> {
        let files = PyDict::new(py);
        for (name, bytes) in self.ending(ending) {
            files.set_item(name, PyBytes::new(py, bytes))?;
        }
        Ok(files)
    }
}

#[pymethods]
impl Outcome {
    /// The results: `summary.json` as a dict.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let summary = self.files.iter().find(|file| file.name == SUMMARY).map_or(&b"null"[..], |file| &file.bytes);
        py.import("json")?.call_method1("loads", (PyBytes::new(py, summary),))
    }

    /// The files by name, as bytes.
    #[getter]
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.bytes(py, "")
    }

    /// The pictures by name, without `.png`.
    #[getter]
    fn pictures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.bytes(py, ".png")
    }

    /// The tables by name: `trace`, `impacts`, or the `table` of a sweep.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tables = PyDict::new(py);
        for (name, bytes) in self.ending(".csv") {
            tables.set_item(name, Py::new(py, of_csv(bytes))?)?;
        }
        if let Some(table) = &self.table {
            tables.set_item("table", table.clone_ref(py))?;
        }
        Ok(tables)
    }

    /// The trace as a structured array; `None` for a scenario without one.
    #[getter]
    fn trace<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.ending(".csv").find(|(name, _)| *name == "trace").map(|(_, bytes)| of_csv(bytes).to_numpy(py)).transpose()
    }

    fn __repr__(&self) -> String {
        format!("<plm_impact.Outcome>\n{}", self.text.trim_end())
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        self.ending(".png").next().map(|(_, bytes)| PyBytes::new(py, bytes))
    }
}

/// The columns of a CSV file. A column holds numbers if all its fields are numbers or empty, else words.
fn of_csv(bytes: &[u8]) -> Table {
    let mut reader = csv::Reader::from_reader(bytes);
    let names: Vec<String> =
        reader.headers().map_or_else(|_| Vec::new(), |head| head.iter().map(str::to_owned).collect());
    let rows: Vec<csv::StringRecord> = reader.records().flatten().collect();
    let columns = names.into_iter().enumerate().map(|(place, name)| {
        let fields = || rows.iter().map(|row| row.get(place).unwrap_or_default());
        let number = |field: &str| if field.is_empty() { Some(f64::NAN) } else { field.parse().ok() };
        let numbers: Option<Vec<f64>> = fields().map(number).collect();
        (name, numbers.map_or_else(|| Column::words(fields()), Column::numbers))
    });
    Table::new(columns.collect())
}
