//! One time step of a contact in one call: force, friction and energies.

use std::ffi::c_int;

use super::calls::catch_panic;
use super::{FAILURE, SUCCESS, plm_contact};
use crate::impact::{ContactHistory, Memory};

/// The state of a contact between two time steps: seven doubles, zero for a fresh contact. Set them to zero when the sphere has
/// left the surface (indentation <= 0).
#[repr(C)]
#[derive(Clone, Copy)]
#[allow(non_camel_case_types)] // the name it has in C
pub struct plm_history {
    /// As of plm_contact_force.
    pub memory: [f64; 3],
    /// Exponent of the unloading branch. 0: not known yet; -1: the branch is no power law.
    pub exponent: f64,
    /// Indentation after the last step [m].
    pub indentation: f64,
    /// Force after the last step [N].
    pub force: f64,
    /// Plastic work of the dent [J]; it belongs to the memory if the exponent is not 0.
    pub plastic: f64,
}

impl From<ContactHistory> for plm_history {
    fn from(history: ContactHistory) -> Self {
        let ContactHistory { memory, exponent, indentation, force, plastic_work } = history;
        let memory = [memory.indentation, memory.force, memory.elastic_approach];
        Self { memory, exponent, indentation, force, plastic: plastic_work }
    }
}

impl From<&plm_history> for ContactHistory {
    fn from(history: &plm_history) -> Self {
        let plm_history { memory: [depth, peak, elastic_approach], exponent, indentation, force, plastic } = *history;
        let memory = Memory { indentation: depth, force: peak, elastic_approach };
        Self { memory, exponent, indentation, force, plastic_work: plastic }
    }
}

/// One time step of a contact: moves it to an indentation [m], and writes the force [N] into the history. The force is that of
/// plm_contact_force up to rounding, in less time: the unloading branch is found once for each largest indentation.
///
/// With slip and friction (three doubles each) the friction on the sphere [N] changes as by plm_contact_friction with this
/// coefficient, which is not used without them. With stored, the stored energy [J] is written there, and the plastic work into the
/// history; without it, the plastic work is that of the last unloading. Leave out what a step does not need: NULL.
///
/// Returns 0, or 1 if a number is NaN or infinite, if no contact can have this memory, if the coefficient is negative, if contact or
/// history is NULL, or if only one of slip and friction is. Then nothing is written.
///
/// # Safety
/// `contact` is NULL or not yet freed; `history` is NULL or points to a plm_history, `slip` and `friction` are NULL or have three
/// doubles each, `stored` is NULL or points to a double. None of them overlap, and no other thread uses what is written at the same time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_step(
    contact: *const plm_contact,
    indentation: f64,
    history: *mut plm_history,
    coefficient: f64,
    slip: *const f64,
    friction: *mut f64,
    stored: *mut f64,
) -> c_int {
    // SAFETY: as the caller promises; any bits are a valid double
    let (contact, history, slip, friction, stored) = unsafe {
        (
            contact.as_ref(),
            history.as_mut(),
            slip.cast::<[f64; 3]>().as_ref(),
            friction.cast::<[f64; 3]>().as_mut(),
            stored.as_mut(),
        )
    };
    let (Some(contact), Some(history)) = (contact, history) else { return FAILURE };
    if slip.is_some() != friction.is_some() {
        return FAILURE;
    }
    let step = || {
        let (contact, before) = (&contact.contact, ContactHistory::from(&*history));
        let mut after = before;
        if !contact.step(indentation, &mut after) {
            return None;
        }
        let new_friction = match (slip, friction.as_deref()) {
            (Some(slip), Some(friction)) => {
                let mut new_friction = *friction;
                if !contact.friction_after_step(coefficient, &before, &after, slip, &mut new_friction) {
                    return None;
                }
                Some(new_friction)
            }
            _ => None,
        };
        let energy = if stored.is_some() { contact.stored_energy(&mut after) } else { 0.0 };
        Some((after, new_friction, energy))
    };
    let Some((after, new_friction, energy)) = catch_panic(None, step) else { return FAILURE };
    *history = after.into();
    if let (Some(friction), Some(new_friction)) = (friction, new_friction) {
        *friction = new_friction;
    }
    if let Some(stored) = stored {
        *stored = energy;
    }
    SUCCESS
}
