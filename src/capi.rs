//! The contact law for C, C++, Fortran and other languages: an indentation and a memory in, a force out (feature `capi`).
//!
//! ```text
//! cargo rustc --release --lib --features capi --crate-type staticlib    # or cdylib
//! ```
//!
//! The header is `src/capi/plm_impact.h`. Everything is in SI units. A contact may be used by many threads at once; what a
//! contact remembers (δ_m \[m\], F_m \[N\], the part of δ_m that is recovered on unloading \[m\]) belongs to the caller, and is
//! zero for a fresh contact: see [`Memory`].

// Raw pointers cross the border here and nowhere else. Every block says why it is sound.
#![allow(unsafe_code)]

use std::ffi::{CStr, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::slice;

use crate::error::Error;
use crate::impact::{Contact, ContactEnergy, Memory};
use crate::run::contact_alone;
use crate::scenario::Scenario;

/// A sphere, a half-space and the law between them.
#[allow(non_camel_case_types)] // the name it has in C
pub struct plm_contact(Contact);

/// The contact of a scenario that is given as a TOML text: the keys are those of a scenario file, and [impact] may be left
/// out. Files that it names are relative to the working directory.
///
/// Returns NULL for a bad scenario, and writes why into `error`: at most `length` bytes with the final zero. Free the
/// contact with `plm_contact_free`.
///
/// # Safety
/// `scenario_toml` ends with a zero; `error` is NULL or has `length` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_new(
    scenario_toml: *const c_char,
    error: *mut c_char,
    length: usize,
) -> *mut plm_contact {
    // SAFETY: as the caller promises
    unsafe { new(scenario_toml, error, length, |text| Scenario::from_text("scenario", text, &[])) }
}

/// The contact of a scenario file. As `plm_contact_new`; files that the scenario names are relative to its folder.
///
/// # Safety
/// As `plm_contact_new`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_open(path: *const c_char, error: *mut c_char, length: usize) -> *mut plm_contact {
    // SAFETY: as the caller promises
    unsafe { new(path, error, length, |path| Scenario::load(Path::new(path), &[])) }
}

/// Frees a contact; NULL is allowed.
///
/// # Safety
/// `contact` comes from `plm_contact_new` or `plm_contact_open`, and is not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_free(contact: *mut plm_contact) {
    if !contact.is_null() {
        // SAFETY: made by Box::into_raw in `new`, and the caller gives it up
        drop(unsafe { Box::from_raw(contact) });
    }
}

/// Force [N] at an indentation [m] by the law alone; `memory` (three doubles, zero for a fresh contact) follows.
///
/// The force is 0 for an indentation of 0 or less. Set the memory to zero when the sphere has left the surface
/// (indentation <= 0), not where the force ends. Not a number: the indentation or the memory is none, or a pointer is NULL.
///
/// # Safety
/// `contact` is NULL or lives; `memory` is NULL or has three doubles that no other thread uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_force(contact: *const plm_contact, indentation: f64, memory: *mut f64) -> f64 {
    // SAFETY: as the caller promises; a double is any bits
    let (Some(contact), Some(memory)) = (unsafe { contact.as_ref() }, unsafe { memory.cast::<[f64; 3]>().as_mut() })
    else {
        return f64::NAN;
    };
    guarded(f64::NAN, || force(&contact.0, indentation, memory))
}

/// `plm_contact_force` for `n` contacts of one sphere and half-space: memory[3 i], memory[3 i + 1], memory[3 i + 2] and
/// force[i] belong to indentation[i]. Does nothing where a pointer is NULL.
///
/// # Safety
/// `contact` lives; the arrays have `n`, 3 `n` and `n` doubles and do not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_forces(
    contact: *const plm_contact,
    n: usize,
    indentation: *const f64,
    memory: *mut f64,
    force: *mut f64,
) {
    if n == 0 || contact.is_null() || indentation.is_null() || memory.is_null() || force.is_null() {
        return;
    }
    // SAFETY: not NULL, and as long and as separate as the caller promises
    let (contact, indentations, memories, forces) = unsafe {
        (
            &*contact,
            slice::from_raw_parts(indentation, n),
            slice::from_raw_parts_mut(memory.cast::<[f64; 3]>(), n),
            slice::from_raw_parts_mut(force, n),
        )
    };
    guarded((), || {
        for ((indentation, memory), force) in indentations.iter().zip(memories).zip(forces) {
            *force = self::force(&contact.0, *indentation, memory);
        }
    });
}

/// Tangent stiffness dF/d(indentation) [N/m]: of the unloading branch up to the largest indentation so far, of the loading
/// curve beyond it.
///
/// # Safety
/// `contact` is NULL or lives; `memory` is NULL or has three doubles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_stiffness(
    contact: *const plm_contact,
    indentation: f64,
    memory: *const f64,
) -> f64 {
    // SAFETY: as the caller promises
    unsafe { read(contact, memory, f64::NAN, |contact, memory| contact.stiffness(indentation, memory)) }
}

/// Where the work of a contact is [J], after `plm_contact_force` gave this force at this indentation and memory: returns what
/// unloading gives back, and writes into `plastic`, where that is not NULL, what the dent has taken.
///
/// # Safety
/// As `plm_contact_stiffness`; `plastic` is NULL or a double.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_energy(
    contact: *const plm_contact,
    indentation: f64,
    force: f64,
    memory: *const f64,
    plastic: *mut f64,
) -> f64 {
    let nothing = ContactEnergy { stored: f64::NAN, plastic: f64::NAN };
    // SAFETY: as the caller promises
    let energy =
        unsafe { read(contact, memory, nothing, |contact, memory| contact.energy(indentation, force, memory)) };
    // SAFETY: as the caller promises
    if let Some(plastic) = unsafe { plastic.as_mut() } {
        *plastic = energy.plastic;
    }
    energy.stored
}

/// Radius of the sphere [m]. A sphere of another radius r has the same law in r: with s = radius/r its force is
/// plm_contact_force at s times its indentation, over s squared.
///
/// # Safety
/// `contact` is NULL or lives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_radius(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { contact.as_ref() }.map_or(f64::NAN, |contact| contact.0.sphere().radius)
}

/// Mass of the sphere [kg].
///
/// # Safety
/// `contact` is NULL or lives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_mass(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { contact.as_ref() }.map_or(f64::NAN, |contact| contact.0.mass())
}

/// Speed [m/s] of the slowest impact that yields; not a number for a contact that stays elastic and for a law that yields at
/// once.
///
/// # Safety
/// `contact` is NULL or lives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_yield_speed(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { contact.as_ref() }.map_or(f64::NAN, |contact| contact.0.yield_speed().unwrap_or(f64::NAN))
}

/// Contact time [s] of the whole impact at a speed [m/s], and the coefficient of restitution into `restitution` where that
/// is not NULL; not a number where there is none.
///
/// # Safety
/// `contact` is NULL or lives; `restitution` is NULL or a double.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_time(contact: *const plm_contact, speed: f64, restitution: *mut f64) -> f64 {
    // SAFETY: as the caller promises
    let (Some(contact), restitution) = (unsafe { contact.as_ref() }, unsafe { restitution.as_mut() }) else {
        return f64::NAN;
    };
    let (time, e) = guarded((f64::NAN, f64::NAN), || {
        contact.0.closed_form(speed).map_or((f64::NAN, f64::NAN), |impact| (impact.contact_time, impact.restitution))
    });
    if let Some(restitution) = restitution {
        *restitution = e;
    }
    time
}

fn force(contact: &Contact, indentation: f64, memory: &mut [f64; 3]) -> f64 {
    let mut after = from_doubles(memory);
    let force = contact.force(indentation, &mut after);
    *memory = [after.indentation, after.force, after.elastic_approach];
    force
}

fn from_doubles([indentation, force, elastic_approach]: &[f64; 3]) -> Memory {
    Memory { indentation: *indentation, force: *force, elastic_approach: *elastic_approach }
}

/// What a question to a contact and its memory gives; `nothing` where a pointer is NULL.
///
/// # Safety
/// As `plm_contact_stiffness`.
unsafe fn read<T>(
    contact: *const plm_contact,
    memory: *const f64,
    nothing: T,
    question: impl Fn(&Contact, &Memory) -> T,
) -> T
where
    T: Copy,
{
    // SAFETY: as the caller promises; a double is any bits
    let (Some(contact), Some(memory)) = (unsafe { contact.as_ref() }, unsafe { memory.cast::<[f64; 3]>().as_ref() })
    else {
        return nothing;
    };
    guarded(nothing, || question(&contact.0, &from_doubles(memory)))
}

/// No panic crosses the border.
fn guarded<T>(otherwise: T, work: impl FnOnce() -> T) -> T {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or(otherwise)
}

/// # Safety
/// As `plm_contact_new`.
unsafe fn new(
    text: *const c_char,
    error: *mut c_char,
    length: usize,
    read: impl FnOnce(&str) -> Result<Scenario, crate::scenario::ScenarioError>,
) -> *mut plm_contact {
    // SAFETY: not NULL, and it ends with a zero as the caller promises
    let text = if text.is_null() { None } else { Some(unsafe { CStr::from_ptr(text) }) };
    let made = guarded(Err("the program has an error: it panicked".to_owned()), || {
        let text = text.ok_or("no scenario: the pointer is NULL")?;
        let text = text.to_str().map_err(|_| "the scenario is not UTF-8")?;
        let (_, contact) = read(text)
            .map_err(Error::from)
            .and_then(|scenario| contact_alone(&scenario))
            .map_err(|error| error.to_string())?;
        Ok(contact)
    });
    match made {
        Ok(contact) => Box::into_raw(Box::new(plm_contact(contact))),
        Err(message) => {
            // SAFETY: as the caller promises
            unsafe { write_text(&message, error, length) };
            std::ptr::null_mut()
        }
    }
}

/// As much of a text as there is room for, whole characters, and a zero.
///
/// # Safety
/// `to` is NULL or has `length` bytes.
unsafe fn write_text(text: &str, to: *mut c_char, length: usize) {
    if to.is_null() || length == 0 {
        return;
    }
    let ends = text.char_indices().map(|(start, character)| start + character.len_utf8());
    let room = ends.take_while(|end| *end < length).last().unwrap_or(0);
    // SAFETY: `room` + 1 bytes are at most `length`
    let to = unsafe { slice::from_raw_parts_mut(to.cast::<u8>(), length) };
    to[..room].copy_from_slice(&text.as_bytes()[..room]);
    to[room] = 0;
}
