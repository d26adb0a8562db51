//! The quantities that can be measured, and how each follows from a computed impact.

use crate::impact::Essentials;
use crate::scene::Scene;
use crate::scene::quantity::{FORCE, LEEB, LENGTH, Quantity, RESTITUTION, SPEED, TIME};

/// A measured quantity.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    /// The name, without the unit.
    pub name: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// The value in an impact of a scene; `None` if the impact has no such value.
    pub predict: fn(&Essentials, &Scene) -> Option<f64>,
    /// Whether the quantity depends only on the restitution and known keys.
    pub is_of_restitution: bool,
}

/// All measured quantities. The last one, the force of an indentation curve, is not a quantity of an impact.
pub const MEASURED: [Measured; 9] = [
    of("restitution", &RESTITUTION, true, |row, _| Some(restitution(row))),
    of("rebound_speed", &SPEED, true, |row, scene| Some(restitution(row) * scene.speed)),
    of("rebound_height", &LENGTH, true, |row, scene| {
        let speed = restitution(row) * scene.speed;
        Some(0.5 * speed * speed / scene.forces.gravity?)
    }),
    of("leeb", &LEEB, true, |row, _| Some(1000.0 * restitution(row))),
    of("dent_diameter", &LENGTH, false, |row, _| {
        Some(if row.has_dent() { 2.0 * row.peak_contact_radius } else { 0.0 })
    }),
    of("dent_depth", &LENGTH, false, |row, _| Some(row.residual_indentation)),
    of("contact_time", &TIME, false, |row, _| Some(row.contact_time)),
    of("peak_force", &FORCE, false, |row, _| Some(row.peak_force)),
    of("force", &FORCE, false, |_, _| None),
];

/// The place of the force of an indentation curve in [`MEASURED`].
pub const CURVE: usize = 8;

const fn of(
    name: &'static str,
    quantity: &'static Quantity,
    is_of_restitution: bool,
    predict: fn(&Essentials, &Scene) -> Option<f64>,
) -> Measured {
    Measured { name, quantity, predict, is_of_restitution }
}

/// The restitution that is measured: less by the energy of elastic waves, if the half-space has a density.
fn restitution(row: &Essentials) -> f64 {
    row.restitution_with_waves().unwrap_or(row.restitution)
}

impl Measured {
    /// The place in [`MEASURED`] of the quantity of this name.
    pub fn find(name: &str) -> Option<usize> {
        MEASURED.iter().position(|measured| measured.name == name)
    }
}
