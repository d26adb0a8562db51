//! The slip of the contact point, and the motion of the bodies that follows from it.
//!
//! With the tangential velocity V and the spin Ω of the sphere, the slip velocity s of the contact point at −R z, and the friction T:
//!
//! ```text
//! s = V + Ω × (−R z) = (v_x − R Ω_y,  v_y + R Ω_x)
//! m V' = T,   I Ω' = −R z × T,   s' = (j/m) T,   j = 1 + m R²/I     (7/2 for a solid sphere)
//! ```
//!
//! Friction acts against the slip, and the springs of the contact begin without load. So s and T stay on the line of s_0, with the
//! direction û, and one number is unknown: s_1/s_0. With J = m (s_1 − s_0)/j:
//!
//! ```text
//! V_1 = V + (J/m) û,   Ω_1 = Ω − (R J/I) z × û,   z × û = (−û_y, û_x, 0)
//! ```
//!
//! The spin about the normal stays. The torque against this spin is about μ F a, which is small against μ F R.
//!
//! A free second ball, at rest before, receives the opposite impulse. Then s is reduced by the speed of this ball at the contact point, and
//!
//! ```text
//! j = m* (1/m_s + R_s²/I_s + 1/m_h + R_h²/I_h),   J = m* (s_1 − s_0)/j,   V_h = −(J/m_h) û,   Ω_h = −(R_h J/I_h) z × û,   I = (2/5) m R²
//! ```

use super::tangential_motion::{CrossMotion, TangentialMotion};
use crate::impact::problem::contact::Contact;
use crate::numerics::functions::hypot;
use crate::numerics::power::nan_max;

/// The line on which the contact point slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slip {
    /// s_0 \[m/s\] in `direction`. It is negative for a contact point that slips backwards.
    pub(super) speed: f64,
    /// û: along the path in an impact in the plane of incidence, otherwise with û_x ≥ 0.
    direction: [f64; 2],
    /// The motion of the sphere before the impact.
    before: TangentialMotion,
}

impl Slip {
    /// The slip before an impact with this motion of a sphere of this radius.
    pub(super) fn new(before: TangentialMotion, radius: f64) -> Self {
        // a sphere rolls if the difference is rounding
        let difference = |speed: f64, rolls: f64| {
            let slip = speed - rolls;
            if slip.abs() <= 4.0 * f64::EPSILON * rolls.abs() { 0.0 } else { slip }
        };
        let forward = difference(before.speed, radius * before.spin);
        let cross = before.cross.map_or(0.0, |cross| difference(cross.speed, -radius * cross.spin_about_path));
        if cross == 0.0 {
            return Self { speed: forward, direction: [1.0, 0.0], before };
        }
        let speed = hypot(forward, cross).copysign(if forward < 0.0 { -1.0 } else { 1.0 });
        Self { speed, direction: [forward / speed, cross / speed], before }
    }

    /// Tangential motion of the sphere at this slip speed.
    pub(super) fn sphere_at(&self, contact: &Contact, slip: f64) -> TangentialMotion {
        let share = contact.reduced_mass() / contact.mass();
        let change = share * ((slip - self.speed) / contact.slip_factor());
        let spin = -contact.spin_factor() * change / contact.sphere().radius;
        self.before.with_change(self.direction, change, spin)
    }

    /// Tangential motion of a second ball at this slip speed.
    pub(super) fn target_at(&self, contact: &Contact, slip: f64) -> Option<TangentialMotion> {
        let share = contact.reduced_mass() / contact.target_mass()?;
        let speed = share * ((self.speed - slip) / contact.slip_factor());
        let spin = 2.5 * speed / contact.half_space().ball_radius()?;
        let cross = self.before.cross.map(|_| CrossMotion::default());
        let at_rest = TangentialMotion { cross, ..TangentialMotion::in_plane(0.0, 0.0) };
        Some(at_rest.with_change(self.direction, speed, spin))
    }

    /// The energy \[J\] of tangential motion and spin before the impact, and after the impact with the energy of a second ball; and the
    /// change of the angular momentum about the contact point, over its largest part.
    pub(super) fn balance(&self, contact: &Contact, slip: f64) -> SlipBalance {
        let (mass, radius) = (contact.mass(), contact.sphere().radius);
        let moment = contact.moment_of_inertia().unwrap_or_else(|| mass * radius / 2.5 * radius);
        let (before, after) = (self.before, self.sphere_at(contact, slip));
        let of_target = self.target_at(contact, slip).zip(contact.target_mass()).map_or(0.0, |(target, mass)| {
            let radius = contact.half_space().ball_radius().unwrap_or(0.0);
            target.kinetic_energy(mass, 0.4 * mass * radius * radius)
        });
        // of the centre about the contact point: R z × m V
        let of_centre = |motion: &TangentialMotion| {
            let [x, y] = motion.velocity().map(|speed| mass * radius * speed);
            [-y, x]
        };
        let of_spin = |motion: &TangentialMotion| motion.spins().map(|spin| moment * spin);
        let (centre, spin) = ([of_centre(&before), of_centre(&after)], [of_spin(&before), of_spin(&after)]);
        let changes = [0, 1].map(|axis| [centre[1][axis] - centre[0][axis], spin[1][axis] - spin[0][axis]]);
        let parts = [0, 1].into_iter().flat_map(|axis| [centre[0][axis], spin[0][axis], changes[axis][0]]);
        let size = parts.map(f64::abs).fold(0.0, nan_max);
        let error = changes.iter().map(|[centre, spin]| (centre + spin).abs()).fold(0.0, nan_max);
        SlipBalance {
            kinetic_in: before.kinetic_energy(mass, moment),
            recovered: after.kinetic_energy(mass, moment) + of_target,
            momentum_error: if size > 0.0 { error / size } else { 0.0 },
        }
    }
}

/// Energies and angular momentum of the tangential motion. SI units.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipBalance {
    pub(super) kinetic_in: f64,
    pub(super) recovered: f64,
    pub(super) momentum_error: f64,
}
