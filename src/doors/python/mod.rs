//! The Python module `plm_impact` (feature `python`): it does what the command does, with arrays as input and output.
//!
//! Keys, units, ranges and explanations come from the registries of [`crate::scenario::scene`]. What Python does shorter is written in
//! Python: `plm_impact/_convert.py` makes the TOML text of a scenario from a dict, `plm_impact/_results.py` has tables and
//! outcomes. Long computations run on threads of the module; meanwhile the interpreter is free, and Ctrl-C stops them.

mod cases;
mod contact;
mod convert;
mod force;
mod outcome;
mod rows;
mod table;
mod work;

#[pyo3::pymodule]
mod _core {
    use pyo3::prelude::*;
    use serde_json::json;

    use super::convert::from_json;
    #[pymodule_export]
    use super::{
        cases::{Contact, checked, numeric_keys, rows},
        contact::Impact,
        outcome::{calibrate, run},
        table::{Column, arrow_stream, table_of_csv},
    };
    use crate::contact::law::LawChoice;
    use crate::files::VERSION;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", VERSION)
    }

    /// The contact laws, each as a dict: name, title, source, loading, unloading, validity, confidence.
    #[pyfunction]
    fn laws(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let laws: Vec<_> = LawChoice::all().iter().map(LawChoice::about).collect();
        from_json(py, &json!(laws))
    }

    /// The materials that scenarios may name, each as a dict: name, title, note, and properties. Each property has the
    /// value and the range in SI units, the basis and the sources.
    #[pyfunction]
    fn materials(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let materials = crate::contact::materials::all().iter().map(|entry| {
            let known = entry.known.iter().map(|known| {
                let value = json!({
                    "value": known.used.value,
                    "range": [known.range[0].value, known.range[1].value],
                    "basis": known.basis,
                    "sources": known.sources,
                });
                (known.property.name().to_owned(), value)
            });
            let properties: serde_json::Map<_, _> = known.collect();
            json!({ "name": entry.name, "title": entry.title, "note": entry.note, "properties": properties })
        });
        from_json(py, &materials.collect())
    }

    /// The JSON Schema of a scenario, as a dict.
    #[pyfunction]
    fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        from_json(py, &crate::scenario::schema::schema())
    }
}
