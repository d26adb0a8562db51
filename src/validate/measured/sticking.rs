//! The tangential restitution of contacts that stick, β_0, by the program: a line −ψ_2 = β_0 ψ_1 through rebounds with partial slip.
//! How experimenters draw this line is not known, so there are two values: the least-squares slope, and the largest −ψ_2/ψ_1.

use crate::error::Error;
use crate::impact::{Approach, Contact, Solver, TangentialMotion};

/// The step of ψ_1 from rebound to rebound.
const STEP: f64 = 0.25;
/// Gross sliding begins below this ψ_1 in every pair of bodies without spin.
const MAX_PSI: f64 = 30.0;

/// β_0 of a pair by the program.
#[derive(Debug, Clone, Copy)]
pub(super) struct StickingRestitution {
    /// Least-squares slope of −ψ_2 over ψ_1 in partial slip.
    pub(super) slope: f64,
    /// The largest −ψ_2/ψ_1.
    pub(super) largest: f64,
}

/// β_0 at the normal speed and with the friction of this approach; `None` without friction.
pub(super) fn sticking_restitution(
    contact: &Contact,
    approach: Approach,
) -> Result<Option<StickingRestitution>, Error> {
    let Some(friction) = approach.friction.filter(|friction| *friction > 0.0) else { return Ok(None) };
    let slip_at_one = friction * approach.normal / (4.0 * contact.shear_ratio());
    let (mut products, mut squares, mut largest) = (0.0, 0.0, 0.0_f64);
    let mut psi = STEP;
    while psi < MAX_PSI {
        let at = Approach { tangential: TangentialMotion::in_plane(psi * slip_at_one, 0.0), ..approach };
        let Some(after) = contact.row(at, &Solver::AUTO)?.rebound.filter(|after| !after.is_sliding) else { break };
        let ratio = after.contact_point_restitution;
        products += ratio * psi * psi;
        squares += psi * psi;
        largest = largest.max(ratio);
        psi += STEP;
    }
    Ok(Some(StickingRestitution { slope: products / squares, largest }))
}
