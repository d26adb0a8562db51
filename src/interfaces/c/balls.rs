//! The functions for two balls, and for the masses that a simulation gives its spheres.

use std::ffi::c_char;
use std::ptr::null_mut;

use super::calls::catch_panic;
use super::{PANICKED, hand_over, number, plm_contact};
use crate::impact::Contact;

/// The contact of two balls with the bodies and the law of `contact`: the sphere with `sphere_radius` [m], and the half-space as
/// a ball with `half_space_radius` [m]. Scaling by the effective radius is not this law: two balls of 5 and 3 mm differ from a
/// scaled sphere on a flat half-space by 0.2 to 3.5 % in e. But the law scales with both radii at once, as for plm_contact_force.
///
/// Returns NULL if `contact` is NULL, or if there is no contact with these radii. Free the contact with `plm_contact_free`.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_between(
    contact: *const plm_contact,
    sphere_radius: f64,
    half_space_radius: f64,
) -> *mut plm_contact {
    // SAFETY: as the caller promises
    let Some(contact) = (unsafe { contact.as_ref() }) else { return null_mut() };
    let is_radius = |radius: f64| radius > 0.0 && radius.is_finite();
    if !is_radius(sphere_radius) || !is_radius(half_space_radius) {
        return null_mut();
    }
    catch_panic(null_mut(), || {
        let balls = contact.input.contact_between([sphere_radius, half_space_radius]);
        balls.map_or(null_mut(), |balls| Box::into_raw(Box::new(plm_contact::new(contact.input.clone(), balls))))
    })
}

/// The contact of two bodies of one material, such as spheres of one kind: where one body of `contact` has no yield strength, it
/// has that of the other. With one strength alone the other body stays elastic, and e is several per cent too high.
///
/// Returns NULL if the bodies have different elastic constants or different strengths, or a flow curve, and writes the reason into
/// `error`: at most `length` bytes with the final zero. Free the contact with `plm_contact_free`.
///
/// # Safety
/// `contact` is NULL or not yet freed; `error` is NULL or has `length` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_of_one_material(
    contact: *const plm_contact,
    error: *mut c_char,
    length: usize,
) -> *mut plm_contact {
    // SAFETY: as the caller promises
    let made = match unsafe { contact.as_ref() } {
        None => Err("no contact: the pointer is NULL".to_owned()),
        Some(contact) => catch_panic(Err(PANICKED.to_owned()), || {
            let input = contact.input.with_one_material()?;
            let balls = input.contact_at_own_speed().map_err(|reason| reason.to_string())?;
            Ok(plm_contact::new(input, balls))
        }),
    };
    // SAFETY: as the caller promises
    unsafe { hand_over(made, error, length) }
}

/// Mass [kg] of the relative motion: m1 m2/(m1 + m2) for two balls, and the mass of the sphere on a fixed half-space.
///
/// # Safety
/// `contact` is NULL or not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_reduced_mass(contact: *const plm_contact) -> f64 {
    // SAFETY: as the caller promises
    unsafe { number(contact, Contact::reduced_mass) }
}

/// Contact time [s] of the whole impact at a speed [m/s], of two balls at their closing speed; NaN if there is no result. Writes
/// the coefficient of restitution into `restitution` if that is not NULL.
///
/// # Safety
/// `contact` is NULL or not yet freed; `restitution` is NULL or points to a double.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_time(contact: *const plm_contact, speed: f64, restitution: *mut f64) -> f64 {
    // SAFETY: as the caller promises
    unsafe { time_and_restitution(contact, speed, restitution, |_| 1.0) }
}

/// plm_contact_time with a given mass of the relative motion [kg], such as that of two spheres of a simulation.
///
/// # Safety
/// As `plm_contact_time`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn plm_contact_time_of_mass(
    contact: *const plm_contact,
    reduced_mass: f64,
    speed: f64,
    restitution: *mut f64,
) -> f64 {
    // SAFETY: as the caller promises
    unsafe {
        time_and_restitution(contact, speed, restitution, |contact| (reduced_mass / contact.reduced_mass()).sqrt())
    }
}

/// Contact time and restitution of a contact whose mass is `heavier` squared times its own. An impact with the same energy has
/// the same path of force and indentation, and a time in proportion to the root of the mass.
///
/// # Safety
/// As `plm_contact_time`.
unsafe fn time_and_restitution(
    contact: *const plm_contact,
    speed: f64,
    restitution: *mut f64,
    heavier: impl Fn(&Contact) -> f64,
) -> f64 {
    // SAFETY: as the caller promises
    let (Some(contact), restitution) = (unsafe { contact.as_ref() }, unsafe { restitution.as_mut() }) else {
        return f64::NAN;
    };
    let (time, e) = catch_panic((f64::NAN, f64::NAN), || {
        let heavier = heavier(&contact.contact);
        contact
            .contact
            .closed_form(speed * heavier)
            .map_or((f64::NAN, f64::NAN), |impact| (impact.row.contact_time * heavier, impact.row.restitution))
    });
    if let Some(restitution) = restitution {
        *restitution = e;
    }
    time
}
