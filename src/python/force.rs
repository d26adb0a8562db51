//! The force of the law for n contacts at once, for programs that move spheres in Python.

use numpy::{PyArrayMethods as _, PyUntypedArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::convert::{numbers, shaped};
use super::work::{FEW, TOGETHER, interruptible};
use crate::impact::{self, Memory};

/// The forces of contacts at these indentations, and their memories afterwards. An indentation without a shape gives a
/// number; a memory has one more axis than the indentations.
pub fn force<'py>(
    contact: &impact::Contact,
    indentation: &Bound<'py, PyAny>,
    memory: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let py = indentation.py();
    let array = numbers(indentation, "indentation")?;
    let array = array.readonly();
    let indentations = array.as_slice()?;
    let shape = array.shape();
    let of_memories = [shape, &[3]].concat();
    let mut memories = vec![0.0; 3 * indentations.len()];
    if let Some(memory) = memory {
        let given = numbers(memory, "memory")?;
        if given.shape() != of_memories {
            let found = given.shape();
            let message = format!(
                "memory: has the shape {found:?}, expected {of_memories:?}: three numbers for each indentation"
            );
            return Err(PyValueError::new_err(message));
        }
        memories.copy_from_slice(given.readonly().as_slice()?);
    }
    let mut forces = vec![0.0; indentations.len()];
    let along = |start: usize, forces: &mut [f64], memories: &mut [f64], indentations: &[f64]| {
        let mut rows = forces.iter_mut().zip(memories.chunks_mut(3)).zip(indentations).enumerate();
        rows.find_map(|(row, ((force, memory), indentation))| {
            let computed = respond(contact, *indentation, memory).map(|computed| *force = computed);
            computed.err().map(|message| (start + row, message))
        })
    };
    let refused = if indentations.len() <= FEW {
        py.detach(|| along(0, &mut forces, &mut memories, indentations))
    } else {
        interruptible(py, |_| {
            let pieces = forces.par_chunks_mut(TOGETHER).zip(memories.par_chunks_mut(3 * TOGETHER));
            let pieces = pieces.zip(indentations.par_chunks(TOGETHER)).enumerate();
            pieces.find_map_first(|(piece, ((forces, memories), indentations))| {
                along(piece * TOGETHER, forces, memories, indentations)
            })
        })?
    };
    if let Some((row, message)) = refused {
        return Err(PyValueError::new_err(format!("contact {row}: {message}")));
    }
    let forces = match forces[..] {
        [force] if shape.is_empty() => force.into_pyobject(py)?.into_any(),
        _ => shaped(py, forces, shape)?,
    };
    Ok((forces, shaped(py, memories, &of_memories)?))
}

/// Largest relative difference between a given memory and the law. It allows for a text file with seven digits.
const ROUNDING: f64 = 1e-6;

/// The force of one contact. Updates its memory `row`.
fn respond(contact: &impact::Contact, indentation: f64, row: &mut [f64]) -> Result<f64, String> {
    if !indentation.is_finite() {
        return Err(format!("an indentation of {indentation} m is not allowed: it must be finite"));
    }
    let parts = |memory: Memory| [memory.indentation, memory.force, memory.elastic_approach];
    let &[deepest, force, elastic_approach] = &*row else { return Err("a memory has three numbers".to_owned()) };
    let mut memory = Memory { indentation: deepest, force, elastic_approach };
    if memory != Memory::default() {
        let mut own = Memory::default();
        contact.force(deepest, &mut own);
        let is_near = |(got, want): (f64, f64)| (got - want).abs() <= ROUNDING * want;
        if !(own.indentation > 0.0 && parts(memory).into_iter().zip(parts(own)).all(is_near)) {
            return Err(format!("the memory {row:?} is none of this contact; give zeros to one that was never loaded"));
        }
    }
    let force = contact.force(indentation, &mut memory);
    row.copy_from_slice(&parts(memory));
    if force.is_nan() { Err(format!("the law has no force at an indentation of {indentation} m")) } else { Ok(force) }
}
