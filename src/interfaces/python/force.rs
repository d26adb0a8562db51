//! Force, energy, stiffness and friction of n contacts at once, for programs that move spheres in Python.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::convert::{Numbers, numbers};
use super::workers::columns;
use crate::impact::{self, FrictionStep, Memory};

/// The forces of contacts at these indentations, and their memories afterwards. An indentation without a shape gives a
/// number; a memory has one more axis than the indentations.
pub fn force<'py>(
    contact: &impact::Contact,
    indentation: &Bound<'py, PyAny>,
    memory: Option<&Bound<'py, PyAny>>,
) -> PyResult<[Bound<'py, PyAny>; 2]> {
    let given = Contacts::new(indentation, memory)?;
    let [forces, memories] = given.computed(indentation.py(), [1, 3], |row, memory, columns| {
        columns[0].push(force_and_update(contact, given.indentations.values[row], memory)?);
        columns[1].extend(&*memory);
        Ok(())
    })?;
    Ok([given.numbers(indentation, forces)?, given.triples(indentation, memories)?])
}

/// Stored energy and plastic work of contacts at these indentations, whose memories are those after [`force`].
pub fn energy<'py>(
    contact: &impact::Contact,
    indentation: &Bound<'py, PyAny>,
    memory: &Bound<'py, PyAny>,
) -> PyResult<[Bound<'py, PyAny>; 2]> {
    let given = Contacts::new(indentation, Some(memory))?;
    let [stored, plastic] = given.computed(indentation.py(), [1, 1], |row, memory, columns| {
        let indentation = given.indentations.values[row];
        let force = force_and_update(contact, indentation, memory)?;
        let energy = contact.energy(indentation, force, &memory_of(memory)?);
        columns[0].push(energy.stored);
        columns[1].push(energy.plastic);
        Ok(())
    })?;
    Ok([given.numbers(indentation, stored)?, given.numbers(indentation, plastic)?])
}

/// Tangent stiffness of contacts at these indentations.
pub fn stiffness<'py>(
    contact: &impact::Contact,
    indentation: &Bound<'py, PyAny>,
    memory: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let given = Contacts::new(indentation, memory)?;
    let [slopes] = given.computed(indentation.py(), [1], |row, memory, columns| {
        columns[0].push(contact.stiffness(given.indentations.values[row], &checked_memory(contact, memory)?));
        Ok(())
    })?;
    given.numbers(indentation, slopes)
}

/// The motion of contacts in a step: indentations before and after it, and the slip along the surface.
pub struct Rubbing<'a, 'py> {
    pub previous_indentation: &'a Bound<'py, PyAny>,
    pub indentation: &'a Bound<'py, PyAny>,
    pub slip: &'a Bound<'py, PyAny>,
}

/// The friction on the spheres after a step; `history` is that before it. The memories are those after [`force`].
pub fn friction<'py>(
    contact: &impact::Contact,
    coefficient: f64,
    rubbing: &Rubbing<'_, 'py>,
    memory: &Bound<'py, PyAny>,
    history: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let Rubbing { previous_indentation, indentation, slip } = rubbing;
    let given = Contacts::new(indentation, Some(memory))?;
    let before = numbers(previous_indentation, "previous_indentation")?;
    check_shape("previous_indentation", &before, &given.indentations.shape)?;
    let slips = triples_like(&given, Some(slip), "slip")?;
    let histories = triples_like(&given, history, "history")?;
    let [frictions] = given.computed(indentation.py(), [3], |row, memory, columns| {
        let indentation = given.indentations.values[row];
        let force = force_and_update(contact, indentation, memory)?;
        let triple = |values: &[f64]| std::array::from_fn(|axis| values[3 * row + axis]);
        let previous_indentation = before.values[row];
        let step = FrictionStep { previous_indentation, indentation, force, slip: triple(&slips) };
        let mut after: [f64; 3] = triple(&histories);
        if !contact.friction(coefficient, &step, &memory_of(memory)?, &mut after) {
            return Err("the friction needs a coefficient of 0 or more, and finite slip and history".to_owned());
        }
        columns[0].extend(after);
        Ok(())
    })?;
    given.triples(indentation, frictions)
}

/// Contacts of one sphere and half-space, as Python gives them: a memory has one more axis than the indentations.
struct Contacts {
    indentations: Numbers,
    memories: Vec<f64>,
}

impl Contacts {
    fn new(indentation: &Bound<'_, PyAny>, memory: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let indentations = numbers(indentation, "indentation")?;
        let mut contacts = Self { indentations, memories: Vec::new() };
        contacts.memories = triples_like(&contacts, memory, "memory")?;
        Ok(contacts)
    }

    /// The shape of three numbers for every contact.
    fn shape_of_triples(&self) -> Vec<usize> {
        [&self.indentations.shape[..], &[3]].concat()
    }

    /// Columns of results, each with a number of values for every contact. `compute` appends those of one contact, of its row and its
    /// memory.
    fn computed<const N: usize>(
        &self,
        py: Python<'_>,
        widths: [usize; N],
        compute: impl Fn(usize, &mut [f64], &mut [Vec<f64>]) -> Result<(), String> + Sync + Send,
    ) -> PyResult<[Vec<f64>; N]> {
        let computed = columns(py, self.indentations.values.len(), &widths, false, |contacts| {
            let mut memories = self.memories[3 * contacts.start..3 * contacts.end].to_vec();
            let mut made = vec![Vec::new(); N];
            for (row, memory) in contacts.zip(memories.chunks_mut(3)) {
                compute(row, memory, &mut made).map_err(|message| format!("contact {row}: {message}"))?;
            }
            Ok(made)
        })?;
        computed.try_into().map_err(|_| PyValueError::new_err("no contacts"))
    }

    fn numbers<'py>(&self, like: &Bound<'py, PyAny>, values: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        Numbers { shape: self.indentations.shape.clone(), values }.numpy(like.py())
    }

    fn triples<'py>(&self, like: &Bound<'py, PyAny>, values: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        Numbers { shape: self.shape_of_triples(), values }.numpy(like.py())
    }
}

/// Three numbers for every contact; zeros if they are not given.
fn triples_like(contacts: &Contacts, given: Option<&Bound<'_, PyAny>>, name: &str) -> PyResult<Vec<f64>> {
    let Some(given) = given else { return Ok(vec![0.0; 3 * contacts.indentations.values.len()]) };
    let given = numbers(given, name)?;
    check_shape(name, &given, &contacts.shape_of_triples())?;
    Ok(given.values)
}

fn check_shape(name: &str, given: &Numbers, expected: &[usize]) -> PyResult<()> {
    if given.shape == expected {
        return Ok(());
    }
    let of_each = if expected.last() == Some(&3) { ": three numbers for each indentation" } else { "" };
    let message = format!("{name}: has the shape {:?}, expected {expected:?}{of_each}", given.shape);
    Err(PyValueError::new_err(message))
}

/// The force of one contact. Updates its memory `row`.
fn force_and_update(contact: &impact::Contact, indentation: f64, row: &mut [f64]) -> Result<f64, String> {
    if !indentation.is_finite() {
        return Err(format!("an indentation of {indentation} m is not allowed: it must be finite"));
    }
    let mut memory = checked_memory(contact, row)?;
    let force = contact.force(indentation, &mut memory);
    row.copy_from_slice(&[memory.indentation, memory.force, memory.elastic_approach]);
    if force.is_nan() {
        Err(format!("the force of the law is not defined at an indentation of {indentation} m"))
    } else {
        Ok(force)
    }
}

/// The memory of one contact, which a path of this contact leads to.
fn checked_memory(contact: &impact::Contact, row: &[f64]) -> Result<Memory, String> {
    let memory = memory_of(row)?;
    if contact.accepts(&memory) {
        return Ok(memory);
    }
    Err(format!("the memory {row:?} does not belong to this contact. For a contact without earlier load give zeros."))
}

fn memory_of(row: &[f64]) -> Result<Memory, String> {
    let &[indentation, force, elastic_approach] = row else { return Err("a memory has three numbers".to_owned()) };
    Ok(Memory { indentation, force, elastic_approach })
}
