//! The force of the law for n contacts at once, for programs that move spheres in Python.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::convert::{Numbers, numbers};
use super::workers::columns;
use crate::impact::{self, Memory};

/// The forces of contacts at these indentations, and their memories afterwards. An indentation without a shape gives a
/// number; a memory has one more axis than the indentations.
pub fn force<'py>(
    contact: &impact::Contact,
    indentation: &Bound<'py, PyAny>,
    memory: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let py = indentation.py();
    let Numbers { shape, values: indentations } = numbers(indentation, "indentation")?;
    let of_memories = [&shape[..], &[3]].concat();
    let given = memory.map(|memory| numbers(memory, "memory")).transpose()?;
    if let Some(given) = given.as_ref().filter(|given| given.shape != of_memories) {
        let found = &given.shape;
        let message =
            format!("memory: has the shape {found:?}, expected {of_memories:?}: three numbers for each indentation");
        return Err(PyValueError::new_err(message));
    }
    let memories = given.map_or_else(|| vec![0.0; 3 * indentations.len()], |given| given.values);
    let computed = columns(py, indentations.len(), &[1, 3], false, |contacts| {
        let mut memories = memories[3 * contacts.start..3 * contacts.end].to_vec();
        let rows = contacts.zip(memories.chunks_mut(3));
        let forces = rows.map(|(row, memory)| {
            force_and_update(contact, indentations[row], memory).map_err(|message| format!("contact {row}: {message}"))
        });
        Ok(vec![forces.collect::<Result<_, _>>()?, memories])
    })?;
    let [forces, memories]: [Vec<f64>; 2] = computed.try_into().unwrap_or_default();
    Ok((Numbers { shape, values: forces }.numpy(py)?, Numbers { shape: of_memories, values: memories }.numpy(py)?))
}

/// The force of one contact. Updates its memory `row`.
fn force_and_update(contact: &impact::Contact, indentation: f64, row: &mut [f64]) -> Result<f64, String> {
    if !indentation.is_finite() {
        return Err(format!("an indentation of {indentation} m is not allowed: it must be finite"));
    }
    let &[deepest, force, elastic_approach] = &*row else { return Err("a memory has three numbers".to_owned()) };
    let mut memory = Memory { indentation: deepest, force, elastic_approach };
    if !contact.accepts(&memory) {
        return Err(format!("the memory {row:?} is none of this contact; give zeros to one that was never loaded"));
    }
    let force = contact.force(indentation, &mut memory);
    row.copy_from_slice(&[memory.indentation, memory.force, memory.elastic_approach]);
    if force.is_nan() { Err(format!("the law has no force at an indentation of {indentation} m")) } else { Ok(force) }
}
