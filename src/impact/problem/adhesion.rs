//! Adhesion of small particles, as a loss of energy: the speed below which a sphere sticks, and the restitution with adhesion. Adhesion
//! does not change the force of the law.
//!
//! By the theory of Johnson, Kendall and Roberts (JKR) the force and the approach of a contact of radius a are
//!
//! ```text
//! F = 4 E* a³/(3 R) − √(8 π E* w a³)        δ = a²/R − √(2 π w a/E*)        w: work of adhesion [J/m²]
//! ```
//!
//! The contact forms at δ = 0, and breaks where δ is least. The work between both is lost (Thornton and Ning 1998, Powder Technol. 99,
//! 154-162):
//!
//! ```text
//! U = 7.092 (w⁵ R⁴/E*²)^(1/3)        V_s = √(2 U/m)        e_adhesion = √(e² − (V_s/v)²)
//! ```
//!
//! A dent is flatter than the sphere. The contact that unloads has the radius R_e of unloading in the place of R, so U is larger. The
//! loss is of first order in U over the elastic energy.

use crate::contact::law::ContactState;
use crate::impact::problem::contact::Contact;
use crate::numerics::functions::pow;

/// U/(w⁵ R⁴/E*²)^(1/3): 7.09 in the literature; the tests compute it from JKR.
pub const PULL_OFF_FACTOR: f64 = 7.092_195_971_863_959;

/// The result of an impact with adhesion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesionResult {
    /// V_s \[m/s\], of the contact that unloads.
    pub sticking_speed: f64,
    /// e with the loss by adhesion; 0 for a sphere that sticks.
    pub restitution: f64,
}

impl Contact {
    /// V_s \[m/s\] of a contact of this radius \[m\] with this work of adhesion \[J/m²\].
    pub(in crate::impact) fn sticking_speed(&self, work: f64, radius: f64) -> f64 {
        // by powers of the single factors, which do not leave double precision where V_s does not
        let depth = pow(work, 5.0 / 6.0) * pow(radius, 2.0 / 3.0) / pow(self.pair().effective_modulus, 1.0 / 3.0);
        (2.0 * PULL_OFF_FACTOR / self.reduced_mass()).sqrt() * depth
    }

    /// The result with adhesion of an impact with this restitution at this speed \[m/s\]. `dent` is the peak that shaped the dent.
    #[cold] // a row without adhesion is faster without this code in it
    pub(in crate::impact) fn adhesion_result(
        &self,
        work: f64,
        [speed, restitution]: [f64; 2],
        dent: Option<&ContactState>,
    ) -> AdhesionResult {
        let ratio = dent.map_or(1.0, ContactState::unloading_radius_ratio);
        let sticking_speed = self.sticking_speed(work, self.pair().radius * ratio);
        let lost = sticking_speed / speed;
        AdhesionResult { sticking_speed, restitution: (restitution * restitution - lost * lost).max(0.0).sqrt() }
    }
}
