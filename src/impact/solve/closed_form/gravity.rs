//! An impact under gravity alone. With w = m g/Φ, x the indentation and u the speed the motion is conservative on each branch,
//!
//! ```text
//! (2/5) u² = (2/5) q² + w x − W(x)
//! ```
//!
//! so peak, rebound and capture follow from the energy, exact to rounding. The times are those of a run by rk8.

use crate::contact::law::Surface;
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::{kinetic_energy, speed_at_energy};
use crate::impact::solve::motion;
use crate::impact::solve::outcome::{ImpactEnd, ScaledResult};
use crate::numerics::ode::IntegrationError;
use crate::numerics::ode::rk8::Rk8;

/// The outcome, with times of this relative tolerance.
pub(super) fn solve(
    ground: Surface,
    q: f64,
    forces: &ScaledForces,
    tolerance: f64,
) -> Result<ScaledResult, IntegrationError> {
    let (last, distance) = ground.turning_point(kinetic_energy(q), forces.weight);
    let unloading = ground.unload(last, distance, None);
    let is_captured = forces.is_captured(&unloading, q);
    // the sphere leaves at the end of the branch, or its run ends at the static indentation
    let at_end = if is_captured { unloading.elastic_approach_at_force(forces.weight) } else { 0.0 };
    let springback = (unloading.peak.elastic_approach - at_end).max(0.0);
    let energy = unloading.recoverable_energy() - unloading.stored_energy_at(at_end) - forces.weight * springback;
    let is_even = !is_captured && forces.is_lossless(ground, &unloading);
    let speed = if is_even { q } else { speed_at_energy(energy.max(0.0)) };
    let run = motion::integrate(ground, q, forces, &mut Rk8::new(tolerance), None)?;
    Ok(ScaledResult {
        unloading,
        restitution: if is_captured { 0.0 } else { speed / q },
        largest_force: ground.reported_force(&unloading, None),
        end: if is_captured { ImpactEnd::Captured } else { ImpactEnd::Separated },
        end_indentation: ground.deepest_state(&unloading.peak).residual() + at_end,
        end_speed: -speed,
        ..run
    })
}
