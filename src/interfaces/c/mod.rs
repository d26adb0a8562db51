//! The contact law for C, C++, Fortran and other languages (feature `capi`): a force from an indentation and a memory.
//!
//! ```text
//! cargo rustc --release --lib --features capi --crate-type staticlib    # or cdylib
//! cc -I src/interfaces/c program.c target/release/libplm_impact.a -lm -lpthread -ldl -o program
//! ```
//!
//! The header is `src/interfaces/c/plm_impact.h`. Everything is in SI units. Many threads may use a contact at the same time.
//! The memory of a contact (δ_m \[m\], F_m \[N\], the part of δ_m that is recovered on unloading \[m\]) belongs to the
//! caller. It is zero for a fresh contact: see [`Memory`].

// Raw pointers are used only in this folder. Every unsafe block says why it is sound.
#![allow(unsafe_code)]
// the comments are those of the header, where brackets hold units and indices
#![allow(rustdoc::broken_intra_doc_links)]

pub mod balls;
mod calls;
pub mod step;
#[cfg(test)]
mod tests;

use std::ffi::{CStr, c_char, c_int};
use std::path::Path;
use std::slice;

use self::calls::{VERSION_TEXT, catch_panic, fingerprint_of, force, from_doubles, write_text};
use crate::error::Error;
use crate::impact::{Contact, ContactEnergy, FrictionStep, Memory};
use crate::report::run::contact_at_scenario_speed;
use crate::scenario::Scenario;
use crate::scenario::input::Input;

/// A sphere, a half-space and the law between them.
#[allow(non_camel_case_types)] // the name it has in C
pub struct plm_contact {
    /// The values of the scenario, for contacts of other radii.
    input: Input,
    contact: Contact,
    fingerprint: u64,
}

impl plm_contact {
    fn new(input: Input, contact: Contact) -> Self {
        Self { fingerprint: fingerprint_of(&contact), input, contact }
    }
}

// many threads may use a contact at the same time
const _: () = {
    const fn assert_send_and_sync<T: Send + Sync>() {}
    assert_send_and_sync::<plm_contact>();
};

/// The message of a panic.
const PANICKED: &str = "the program has an error: it panicked";

/// The return values of the functions that may fail.
const SUCCESS: c_int = 0;
const FAILURE: c_int = 1;

/// Version of the library, such as "0.1.0". Compare it with PLM_IMPACT_VERSION, the version of this header. Do not free it.
#[unsafe(no_mangle)]
pub extern "C" fn plm_impact_version() -> *const c_char {
    VERSION_TEXT.as_ptr()
}

/// The contact of a scenario that is given as a TOML text. The keys are those of a scenario file, and `[impact]` may be
/// left out. A strength that depends on the strain rate is that of the speed of `[impact]`, which is then needed. Gravity,
/// damping, plates, rods, and tables that ask for more than one impact (`[sweep]`, ...) are refused. Two balls are a scenario with
/// half_space.radius and half_space.mass = "ball". Paths of files in the text are relative to the working directory.
///
/// Returns NULL for a bad scenario, and writes the reason into `error`: at most `length` bytes with the final zero.
/// Free the contact with `plm_contact_free`.
///
/// # Safety
/// `scenario_toml` ends with a zero byte; `error` is NULL or has `length` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_from_toml(
    scenario_toml: *const c_char,
    error: *mut c_char,
    length: usize,
) -> *mut plm_contact {
    // SAFETY: as the caller promises
    unsafe { new(scenario_toml, error, length, |text| Scenario::from_text("scenario", text, &[])) }
}

/// The contact of a scenario file. Otherwise as `plm_contact_from_toml`, but paths in the scenario are relative to its
/// folder.
///
/// # Safety
/// As `plm_contact_from_toml`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_open(path: *const c_char, error: *mut c_char, length: usize) -> *mut plm_contact {
    // SAFETY: as the caller promises
    unsafe { new(path, error, length, |path| Scenario::load(Path::new(path), &[])) }
}

/// Frees a contact; NULL is allowed.
///
/// # Safety
/// `contact` is NULL or comes from a function that returns a contact, is not yet freed, and is not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_free(contact: *mut plm_contact) {
    if !contact.is_null() {
        // SAFETY: made by Box::into_raw, and the caller does not use it afterwards
        catch_panic((), || drop(unsafe { Box::from_raw(contact) }));
    }
}

/// Force [N] at an indentation [m] by the law alone. Updates `memory` (three doubles, zero for a fresh contact).
///
/// The force is 0 for an indentation of 0 or less. Set the memory to zero when the sphere has left the surface
/// (indentation <= 0), not when the force becomes zero. Returns NaN if the indentation is NaN or infinite, if the force
/// would be, if no contact can have this memory (a number that is negative, NaN or infinite, or a third number larger
/// than the first), or if a pointer is NULL; the memory then stays as it was.
///
/// The law has no elastic waves: see `plm_contact_restitution_with_waves`.
///
/// # Safety
/// `contact` is NULL or not yet freed; `memory` is NULL or has three doubles that no other thread uses at the same
/// time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_force(contact: *const plm_contact, indentation: f64, memory: *mut f64) -> f64 {
    // SAFETY: as the caller promises; any bits are a valid double
    let (Some(contact), Some(memory)) = (unsafe { contact.as_ref() }, unsafe { memory.cast::<[f64; 3]>().as_mut() })
    else {
        return f64::NAN;
    };
    catch_panic(f64::NAN, || force(&contact.contact, indentation, memory))
}

/// `plm_contact_force` for `n` contacts of one sphere and half-space: memory[3 i], memory[3 i + 1], memory[3 i + 2] and
/// force[i] belong to indentation[i].
///
/// Returns 0 if every contact has a force. Returns 1 if a force is NaN, as of `plm_contact_force`: the memory of that contact
/// stays as it was, and all other forces are right. Returns 1 too if a pointer is NULL: then nothing is written. The arrays may
/// be NULL where `n` is 0.
///
/// # Safety
/// `contact` is NULL or not yet freed; the arrays are NULL or have `n`, 3 `n` and `n` doubles, and do not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_forces(
    contact: *const plm_contact,
    n: usize,
    indentation: *const f64,
    memory: *mut f64,
    force: *mut f64,
) -> c_int {
    if n == 0 && !contact.is_null() {
        return SUCCESS;
    }
    if contact.is_null() || indentation.is_null() || memory.is_null() || force.is_null() {
        return FAILURE;
    }
    // SAFETY: not NULL; length and separation are as the caller promises
    let (contact, indentations, memories, forces) = unsafe {
        (
            &*contact,
            slice::from_raw_parts(indentation, n),
            slice::from_raw_parts_mut(memory.cast::<[f64; 3]>(), n),
            slice::from_raw_parts_mut(force, n),
        )
    };
    let mut result = SUCCESS;
    for ((indentation, memory), force) in indentations.iter().zip(memories).zip(forces) {
        *force = catch_panic(f64::NAN, || calls::force(&contact.contact, *indentation, memory));
        if force.is_nan() {
            result = FAILURE;
        }
    }
    result
}

/// Friction of a contact with this coefficient: one tangential spring, as LAMMPS mindlin_rescale/force. Call it in every
/// step after plm_contact_force gave `force` and `memory` at `indentation`; `previous_indentation` is the indentation of the
/// last step, 0 in the first. `slip` (three doubles) is how far the contact point moved along the surface since then [m].
/// `history` (three doubles, zero for a fresh contact) becomes the friction on the sphere [N]; its torque about the centre is
/// that of this force at the contact point.
///
/// Returns 0, or 1 if there is no friction: the coefficient is negative, a number is NaN or infinite, no contact can have this
/// memory, or a pointer is NULL. The history then stays as it was.
///
/// For a sphere of another radius multiply indentations and slip as for plm_contact_force, and divide the friction likewise.
///
/// # Safety
/// As `plm_contact_stiffness`; `slip` and `history` are NULL or have three doubles each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_friction(
    contact: *const plm_contact,
    coefficient: f64,
    previous_indentation: f64,
    indentation: f64,
    force: f64,
    memory: *const f64,
    slip: *const f64,
    history: *mut f64,
) -> c_int {
    // SAFETY: as the caller promises; any bits are a valid double
    let (Some(slip), Some(history)) =
        (unsafe { slip.cast::<[f64; 3]>().as_ref() }, unsafe { history.cast::<[f64; 3]>().as_mut() })
    else {
        return FAILURE;
    };
    let step = FrictionStep { previous_indentation, indentation, force, slip: *slip };
    // SAFETY: as the caller promises
    let friction = unsafe {
        with_contact(contact, memory, None, |contact, memory| {
            let mut after = *history;
            contact.friction(coefficient, &step, memory, &mut after).then_some(after)
        })
    };
    let Some(friction) = friction else { return FAILURE };
    *history = friction;
    SUCCESS
}

/// Tangent stiffness dF/d(indentation) [N/m]: of the unloading branch up to the largest indentation so far, and of the
/// loading curve beyond it.
///
/// # Safety
/// `contact` is NULL or not yet freed; `memory` is NULL or has three doubles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_stiffness(
    contact: *const plm_contact,
    indentation: f64,
    memory: *const f64,
) -> f64 {
    // SAFETY: as the caller promises
    unsafe { with_contact(contact, memory, f64::NAN, |contact, memory| contact.stiffness(indentation, memory)) }
}

/// Energies of a contact [J], after `plm_contact_force` gave this force and memory at this indentation. Returns the
/// stored energy, which unloading gives back. Writes the plastic work of the dent into `plastic` if that is not NULL.
///
/// # Safety
/// As `plm_contact_stiffness`; `plastic` is NULL or points to a double.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_energy(
    contact: *const plm_contact,
    indentation: f64,
    force: f64,
    memory: *const f64,
    plastic: *mut f64,
) -> f64 {
    let nothing = ContactEnergy { stored: f64::NAN, plastic: f64::NAN };
    let energy_of = |contact: &Contact, memory: &Memory| {
        if force.is_finite() { contact.energy(indentation, force, memory) } else { nothing }
    };
    // SAFETY: as the caller promises
    let energy = unsafe { with_contact(contact, memory, nothing, energy_of) };
    // SAFETY: as the caller promises
    if let Some(plastic) = unsafe { plastic.as_mut() } {
        *plastic = energy.plastic;
    }
    energy.stored
}

/// Radius of the sphere [m]. The law of a sphere of another radius r follows by scaling: with s = radius/r its force is
/// plm_contact_force at s times its indentation, divided by s squared. This holds on a flat half-space alone: of a curved one
/// it would scale the curvature too, so compare with plm_contact_effective_radius. For two balls use plm_contact_between.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_radius(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, |contact| contact.sphere().radius) }
}

/// Effective radius [m], with 1/R* = 1/R + 1/half_space.radius. It is the radius of the sphere where the half-space is flat.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_effective_radius(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, |contact| contact.pair().radius) }
}

/// Mass of the sphere [kg].
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_mass(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, Contact::mass) }
}

/// Speed [m/s] of the slowest impact that yields; NaN for a contact that stays elastic and for a law that yields at
/// once.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_yield_speed(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, |contact| contact.yield_speed().unwrap_or(f64::NAN)) }
}

/// Coefficient of restitution at a speed [m/s] less what elastic waves in the half-space take, to first order. The
/// force has no waves: this is what a simulation with it leaves out. NaN if the scenario gives no half_space.density.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_restitution_with_waves(contact: *const plm_contact, speed: f64) -> f64 {
    // SAFETY: as the caller promises
    let Some(contact) = (unsafe { contact.as_ref() }) else { return f64::NAN };
    let with_waves = || contact.contact.closed_form(speed).ok()?.row.restitution_with_waves();
    catch_panic(f64::NAN, || with_waves().unwrap_or(f64::NAN))
}

/// Indentation [m] up to which the data behind the law reach. Beyond it forces and dent are estimates.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_validated_indentation(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, Contact::validated_indentation) }
}

/// Fingerprint of the bodies and of the law, for the restart file of a simulation: a memory belongs to the contact with the
/// same fingerprint alone. Two scenarios with the same contact have the same one, whatever their comments are; another version
/// of the library may have another one. 0 for NULL.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_fingerprint(contact: *const plm_contact) -> u64 {
    // SAFETY: as the caller promises
    unsafe { contact.as_ref() }.map_or(0, |contact| contact.fingerprint)
}

/// A number of a contact; NaN for NULL.
///
/// # Safety
/// `contact` is NULL or not yet freed.
unsafe fn number(contact: *const plm_contact, question: impl Fn(&Contact) -> f64) -> f64 {
    // SAFETY: as the caller promises
    let Some(contact) = (unsafe { contact.as_ref() }) else { return f64::NAN };
    catch_panic(f64::NAN, || question(&contact.contact))
}

/// Calls `question` with a contact and its memory; returns `nothing` if a pointer is NULL.
///
/// # Safety
/// As `plm_contact_stiffness`.
unsafe fn with_contact<T>(
    contact: *const plm_contact,
    memory: *const f64,
    nothing: T,
    question: impl Fn(&Contact, &Memory) -> T,
) -> T
where
    T: Copy,
{
    // SAFETY: as the caller promises; any bits are a valid double
    let (Some(contact), Some(memory)) = (unsafe { contact.as_ref() }, unsafe { memory.cast::<[f64; 3]>().as_ref() })
    else {
        return nothing;
    };
    catch_panic(nothing, || question(&contact.contact, &from_doubles(memory)))
}

/// # Safety
/// As `plm_contact_from_toml`.
unsafe fn new(
    text: *const c_char,
    error: *mut c_char,
    length: usize,
    read: impl FnOnce(&str) -> Result<Scenario, Error>,
) -> *mut plm_contact {
    // SAFETY: not NULL, and it ends with a zero as the caller promises
    let text = if text.is_null() { None } else { Some(unsafe { CStr::from_ptr(text) }) };
    let made = catch_panic(Err(PANICKED.to_owned()), || {
        let text = text.ok_or("no scenario: the pointer is NULL")?;
        let text = text.to_str().map_err(|_| "the scenario is not UTF-8")?;
        let contact = read(text).and_then(|scenario| contact_at_scenario_speed(&scenario));
        contact.map(|(input, contact)| plm_contact::new(input, contact)).map_err(|error| error.to_string())
    });
    // SAFETY: as the caller promises
    unsafe { hand_over(made, error, length) }
}

/// Gives the contact to the caller; returns NULL and the message in `error` if there is no contact.
///
/// # Safety
/// `error` is NULL or has `length` bytes.
unsafe fn hand_over(made: Result<plm_contact, String>, error: *mut c_char, length: usize) -> *mut plm_contact {
    match made {
        Ok(contact) => Box::into_raw(Box::new(contact)),
        Err(message) => {
            // SAFETY: as the caller promises
            unsafe { write_text(&message, error, length) };
            std::ptr::null_mut()
        }
    }
}
