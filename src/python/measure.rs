//! Measures the time of the library without Python, for `src/python/bench/bench.py`.

use std::hint::black_box;
use std::time::Instant;

use pyo3::prelude::*;

use super::contact::Contact;
use super::convert::{exception, with};
use crate::run::table::plan;
use crate::sweep::throughput::compute_rate;

/// Number of impacts that are timed together.
const BURST: u32 = 20;

/// Seconds for a table of `rows` speeds, and for one impact at 3 m/s.
#[pyfunction]
pub fn _measure(py: Python<'_>, contact: &Contact, rows: u32) -> PyResult<(f64, f64)> {
    let axis = format!("sweep.\"impact.speed\"={{ logspace = [0.001, 100], points = {rows} }}");
    let plan = plan(&with(contact.scenario(), [axis]).map_err(exception)?).map_err(exception)?;
    let table = py.detach(|| f64::from(rows) / compute_rate(&plan));
    let begun = Instant::now();
    for _ in 0..BURST {
        drop(black_box(contact.computed(black_box(3.0), None)));
    }
    Ok((table, begun.elapsed().as_secs_f64() / f64::from(BURST)))
}
