//! Runs a scenario of any kind, as the command does.

use std::fmt::Display;
use std::path::PathBuf;

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyMapping, PyTuple};

use super::convert::{Reduced, exception, overrides, refuse_lost, source_of, unreadable, warn};
use super::rows::{failure, of_plan, say_failures};
use super::table::{Column, Table};
use super::work::interruptible;
use crate::error::Error;
use crate::output::{OutputFile, SUMMARY};
use crate::plan::Plan;
use crate::plot::Pictures;
use crate::progress::Counter;
use crate::report;
use crate::run::{Order, Outcome as Written, Run, table, way};
use crate::scenario::Scenario;
use crate::sweep::count::{Count, Tally};

/// The name of measurements that are arrays, in messages.
const DATA: &str = "data";

/// The results of a scenario: `files` are the files that the command writes, `tables` are the tables among them, and
/// `pictures` are the pictures (PNG). An outcome can be pickled.
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

/// What a pickled outcome holds: warnings, text, files, and the table of a sweep.
type Parts<'py> = (Vec<String>, String, Bound<'py, PyDict>, Option<Py<Table>>);

/// Runs a scenario from a file or from a dict of the same form, such as `run("scenarios/steel-on-steel.toml")`. The keys in
/// `set` replace those of the scenario: `set={"impact.speed": "2 m/s", "law": "thornton"}`. No file is written.
///
/// Raises ValueError for a bad scenario, with file, line, key, value and what is allowed; NoSuchFile, which is a
/// FileNotFoundError too, for a missing file; RuntimeError for a run that fails. Warnings are UserWarning.
#[pyfunction]
#[pyo3(signature = (scenario, /, *, set=None))]
pub fn run(py: Python<'_>, scenario: &Bound<'_, PyAny>, set: Option<&Bound<'_, PyMapping>>) -> PyResult<Outcome> {
    run_scenario(py, &scenario_of(scenario, overrides(set)?)?)
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
/// Errors are those of `run`.
#[pyfunction]
#[pyo3(signature = (scenario, data=None, /, *, set=None))]
pub fn calibrate(
    py: Python<'_>,
    scenario: &Bound<'_, PyAny>,
    data: Option<&Bound<'_, PyAny>>,
    set: Option<&Bound<'_, PyMapping>>,
) -> PyResult<Outcome> {
    let mut overrides = overrides(set)?;
    let Some(data) = data else { return run_scenario(py, &scenario_of(scenario, overrides)?) };
    overrides.push(format!("calibrate.data={DATA}"));
    let scenario = scenario_of(scenario, overrides)?.with_data(csv_of(data)?);
    run_scenario(py, &scenario).map_err(|error| of_element(py, error))
}

/// A scenario that is given as a path or a dict.
fn scenario_of(path_or_tables: &Bound<'_, PyAny>, overrides: Vec<String>) -> PyResult<Scenario> {
    let scenario = match path_or_tables.cast::<PyMapping>() {
        Ok(tables) => {
            let source = source_of(tables)?;
            Scenario::from_text("scenario", &source.text, &[source.overrides, overrides].concat())
        }
        Err(_) => Scenario::load(&path_or_tables.extract::<PathBuf>()?, &overrides),
    };
    scenario.map_err(|error| unreadable(path_or_tables.py(), error))
}

/// Measurements as the text of a CSV file.
fn csv_of(data: &Bound<'_, PyAny>) -> PyResult<String> {
    let names = match (data.getattr_opt("column_names")?, data.getattr_opt("columns")?) {
        (Some(names), _) | (None, Some(names)) => names,
        (None, None) => {
            data.call_method0("keys").map_err(|_| PyTypeError::new_err("data: expected a dict or a DataFrame"))?
        }
    };
    let names = names.try_iter()?.map(|name| name?.extract()).collect::<PyResult<Vec<String>>>()?;
    let numpy = data.py().import("numpy")?;
    let columns = names.iter().map(|name| {
        let column = data.get_item(name)?;
        refuse_lost(&column, name)?;
        numpy.call_method1("atleast_1d", (numpy.call_method1("asarray", (column,))?,))
    });
    let columns = columns.collect::<PyResult<Vec<_>>>()?;
    let lists = numpy.call_method1("broadcast_arrays", PyTuple::new(data.py(), columns)?)?;
    let lists = lists.try_iter()?.map(|column| column?.call_method0("tolist")?.extract());
    let lists: Vec<Vec<Bound<'_, PyAny>>> = lists.collect::<PyResult<_>>()?;
    // the shortest digits from which the same number is read; NaN, None and the like are empty fields
    let field = |value: &Bound<'_, PyAny>| match value.extract::<f64>() {
        Ok(number) if number.is_nan() => Ok(String::new()),
        _ if value.is_none() || value.get_type().name()? == "NAType" => Ok(String::new()),
        _ => Ok::<_, PyErr>(value.str()?.to_string()),
    };
    let mut csv = csv::Writer::from_writer(Vec::new());
    let failed = |error: &dyn Display| PyValueError::new_err(format!("{DATA}: {error}"));
    csv.write_record(&names).map_err(|error| failed(&error))?;
    for row in 0..lists.first().map_or(0, Vec::len) {
        let fields = lists.iter().map(|list| field(&list[row])).collect::<PyResult<Vec<_>>>()?;
        csv.write_record(fields).map_err(|error| failed(&error))?;
    }
    String::from_utf8(csv.into_inner().map_err(|error| failed(&error))?).map_err(|error| failed(&error))
}

/// The error of a line of measurements that are arrays: it names the element.
fn of_element(py: Python<'_>, error: PyErr) -> PyErr {
    let text = error.value(py).to_string();
    let parts = text.strip_prefix(DATA).and_then(|rest| rest.strip_prefix(':')?.split_once(':'));
    match parts.and_then(|(line, rest)| Some((line.parse::<usize>().ok()?, rest))) {
        Some((1, rest)) => PyValueError::new_err(format!("{DATA}:{rest}")),
        Some((line, rest)) => PyValueError::new_err(format!("{DATA}, element {}:{rest}", line.saturating_sub(2))),
        None => error,
    }
}

fn run_scenario(py: Python<'_>, scenario: &Scenario) -> PyResult<Outcome> {
    let command = format!("{}.run({})", env!("CARGO_CRATE_NAME"), scenario.document.name());
    match way(scenario.kind().map_err(exception)?).run {
        Run::Once { run, .. } => {
            let order = Order { command: &command, pictures: Pictures::Png, progress: &Counter::default() };
            let Written { mut warnings, text, files, contradiction } =
                interruptible(py, |_| run(scenario, &order))?.map_err(exception)?;
            warnings.extend(contradiction);
            warn(py, &warnings)?;
            Ok(Outcome { warnings, text, files, table: None })
        }
        Run::Table => run_table(py, scenario, &command),
    }
}

fn run_table(py: Python<'_>, scenario: &Scenario, command: &str) -> PyResult<Outcome> {
    let plan = table::plan(scenario).map_err(exception)?;
    let warnings = table::warnings(&plan);
    warn(py, &warnings)?;
    let (made, swept) = of_plan(py, &plan)?;
    let status = made.status.clone();
    say_failures(py, status.len(), status.iter().copied())?;
    let table = Table::new(made.table(&plan, &plan.results(), swept));
    let made = interruptible(py, |_| {
        let tally = tally(&plan, &table, &status);
        let provenance = scenario.provenance(command);
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

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Reduced<'py, Parts<'py>> {
        let Self { warnings, text, table, .. } = slf.get();
        let table = table.as_ref().map(|table| table.clone_ref(slf.py()));
        Ok((slf.get_type().getattr("_of_parts")?, (warnings.clone(), text.clone(), slf.get().files(slf.py())?, table)))
    }

    #[staticmethod]
    fn _of_parts(
        warnings: Vec<String>,
        text: String,
        files: &Bound<'_, PyDict>,
        table: Option<Py<Table>>,
    ) -> PyResult<Self> {
        let file = |(name, bytes): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
            Ok(OutputFile { name: name.extract()?, bytes: bytes.extract()? })
        };
        Ok(Self { warnings, text, files: files.iter().map(file).collect::<PyResult<_>>()?, table })
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
