//! The Python module `plm_impact` (feature `python`): it does what the command does, with arrays as input and output.
//!
//! Keys, units, ranges and explanations come from the registries of [`crate::scenario::keys`]. What Python does shorter is written in
//! Python: `plm_impact/_convert.py` makes the TOML text of a scenario from a dict, `plm_impact/_results.py` has tables and
//! outcomes. Long computations run on threads of the module; meanwhile the interpreter is free, and Ctrl-C stops them.

mod cases;
mod contact;
mod convert;
mod find;
mod force;
mod impact;
mod outcome;
mod rows;
mod table;
mod workers;

#[pyo3::pymodule]
mod _core {
    use pyo3::prelude::*;
    use serde_json::json;

    use super::convert::from_json;
    #[pymodule_export]
    use super::{
        cases::{PyContact, numeric_keys, rows, validated},
        find::find,
        impact::PyImpact,
        outcome::{calibrate, run},
        table::{Column, arrow_stream, table_of_csv},
    };
    use crate::contact::law::LawChoice;
    use crate::files::VERSION;
    use crate::materials::all_materials;
    use crate::report::text::materials::materials_json;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", VERSION)
    }

    /// The contact laws, each as a dict: name, title, source, loading, unloading, validity, confidence.
    #[pyfunction]
    fn laws(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let laws: Vec<_> = LawChoice::all().iter().map(LawChoice::info).collect();
        from_json(py, &json!(laws))
    }

    /// The materials that scenarios may name, each as a dict, as `plm-impact materials --json` prints them: name, title, class,
    /// note, and properties. A property has its value and the ends of its range in SI units, the basis and the sources.
    #[pyfunction]
    fn materials(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        from_json(py, &materials_json(&all_materials().iter().collect::<Vec<_>>()))
    }

    /// The JSON Schema of a scenario, as a dict.
    #[pyfunction]
    fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        from_json(py, &crate::scenario::schema::schema())
    }
}
