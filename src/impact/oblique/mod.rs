//! Oblique impact with Coulomb friction.
//!
//! The normal motion does not depend on friction (exact for equal bodies, and for a rigid body on an incompressible one). The
//! tangential motion has one unknown: the slip speed s of the contact point after the impact over the slip speed before, s_1/s_0
//! (`slip.rs`). With γ = G*/E*, 1/G* = (2 − ν_s)/G_s + (2 − ν_h)/G_h, j = 1 + m R²/I, and the normal speed v_n:
//!
//! ```text
//! ψ_1 = 4γ s_0/(μ v_n),   ψ_2 = 4γ s_1/(μ v_n),   χ = 2γ j
//! ```
//!
//! Gross sliding has a closed form; all other cases use the contact of [`mindlin`].
//!
//! Gravity and damping change the normal motion. The friction is limited by μ times the whole contact force, as in LAMMPS. Gravity
//! does not act along the surface. A sphere that stays in its dent has no rebound.

mod approach;
mod kinks;
pub mod mindlin;
pub mod normal_motion;
mod profile;
mod slip;
mod slip_result;
mod tangential_motion;

use super::problem::contact::{Contact, shear_compliance};
use super::problem::error::ImpactError;
use super::problem::scales::FORCE_FACTOR;
use super::scaled_impact::ScaledImpact;
use super::solve::outcome::{ImpactEnd, ScaledResult};
use crate::contact::body::{InvalidInput, Material, OutOfFloatRange, Support};
use crate::contact::law::UnloadingRule;
use crate::numerics::functions::atan2;
pub use approach::Approach;
use normal_motion::NormalMotion;
use slip::{Slip, SlipBalance};
use slip_result::SlipResult;
pub use tangential_motion::{CrossMotion, TangentialMotion};

/// The results of an oblique impact that are columns of a table. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rebound {
    /// Tangential velocity and spin.
    pub tangential: TangentialMotion,
    /// From the normal \[rad\]. In the plane of incidence negative if the sphere moves backwards.
    pub angle: f64,
    /// v_x1/v_x; NaN without v_x.
    pub tangential_restitution: f64,
    /// −s_1/s_0; NaN without s_0.
    pub contact_point_restitution: f64,
    /// −J over the normal impulse: positive if friction slows v_x; its magnitude is at most μ.
    pub impulse_ratio: f64,
    /// Tangential velocity and spin of a second ball.
    pub target: Option<TangentialMotion>,
    /// Energy absorbed by friction, over ½ m* v².
    pub loss_fraction: f64,
    /// True if the contact point slides during the whole contact.
    pub is_sliding: bool,
    /// ψ_1; infinite without friction.
    pub psi: f64,
    /// The estimated error of s_1/s_0; 0 for gross sliding.
    pub error: f64,
}

impl Rebound {
    /// ψ_2.
    pub fn psi_after(&self) -> f64 {
        -self.contact_point_restitution * self.psi
    }
}

/// The energies and the momentum of an oblique impact. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObliqueResult {
    /// ½ m |V|² + ½ I |Ω|² of the tangential velocity and the spin before the impact \[J\].
    pub kinetic_in: f64,
    /// This energy after the impact \[J\], with the energy of a second ball.
    pub recovered: f64,
    /// Energy absorbed by friction \[J\], ½ (m*/j)(s_0² − s_1²).
    pub loss: f64,
    /// Change of the angular momentum R z × m V + I Ω about the contact point, over its largest part.
    pub momentum_error: f64,
}

/// Friction on one row of a trace. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionState {
    /// s \[m/s\]; negative backwards.
    pub slip_speed: f64,
    /// T \[N\] on the sphere, on the line of the slip; negative against forward motion.
    pub friction_force: f64,
    /// Tangential velocity and spin.
    pub tangential: TangentialMotion,
}

impl Contact {
    /// γ = G*/E*: tangential over normal stiffness of the pair, up to a factor of 4.
    pub fn shear_ratio(&self) -> f64 {
        let compliance = shear_compliance(self.sphere(), self.half_space());
        1.0 / (compliance * self.pair().effective_modulus)
    }

    /// m R²/I of the sphere.
    fn spin_factor(&self) -> f64 {
        let radius = self.sphere().radius;
        self.moment_of_inertia().map_or(2.5, |moment| self.mass() * radius / moment * radius)
    }

    /// 1 + m R²/I of the sphere.
    fn own_slip_factor(&self) -> f64 {
        1.0 + self.spin_factor()
    }

    /// j: the deceleration of the slip over the deceleration of the relative motion of the bodies, for the same force.
    pub fn slip_factor(&self) -> f64 {
        let own = self.own_slip_factor();
        // 7/2 of a solid ball
        self.target_mass().map_or(own, |target| self.reduced_mass() * (own / self.mass() + 3.5 / target))
    }

    /// χ = 2γ j.
    pub fn chi(&self) -> f64 {
        2.0 * self.shear_ratio() * self.slip_factor()
    }

    /// Dundurs' β of the pair, the coupling of pressure and shear. It is 0 for equal materials; the friction neglects it.
    pub fn dundurs_beta(&self) -> f64 {
        let [sphere, half_space] = [self.sphere().material, self.half_space().material];
        let share = |body: &Material, part: f64| {
            (1.0 - part * body.poissons_ratio) * (1.0 + body.poissons_ratio) / body.youngs_modulus
        };
        let [a, b] = [&sphere, &half_space].map(|body| [share(body, 2.0), share(body, 1.0)]);
        0.5 * (a[0] - b[0]) / (a[1] + b[1])
    }
}

/// An oblique impact with a known normal motion.
pub(super) struct ObliqueImpact<'a> {
    contact: &'a Contact,
    case: &'a ScaledImpact<'a>,
    outcome: &'a ScaledResult,
    approach: Approach,
    /// μ.
    friction: f64,
    slip: Slip,
    /// ψ_1.
    psi: f64,
    chi: f64,
}

/// The largest phase angle \[rad\] of the tangential oscillation of a contact point; a solid sphere has about 7. The cost of a run
/// grows with the square of this angle.
const MAX_PHASE_ANGLE: f64 = 100.0;

/// s_1/s_0 has a limit as ψ_1 → 0, where only the rim slips. At this ψ_1 it differs from the limit by at most 2e-7. At smaller ψ_1
/// the stops are so large against the displacement of the springs that rounding dominates, so the ratio at this ψ_1 is used.
const MIN_PSI: f64 = 1e-8;

/// Requested accuracy of s_1/s_0 in a table. The error of a row may exceed it: in random impacts the largest error is 1.3e-5 under the
/// PLM (also with damping, with gravity, on plates and rods), and 5e-5 under other laws.
const ROW_ACCURACY: f64 = 5e-6;
/// Requested accuracy of s_1/s_0 in a single run; the error in random impacts is at most 1e-7.
const RUN_ACCURACY: f64 = 2e-9;

impl<'a> ObliqueImpact<'a> {
    /// `None` for an impact without angle and spin, and for a sphere that does not separate.
    ///
    /// # Errors
    /// [`ImpactError::NoBall`] if the target is free to move and is no ball.
    pub(super) fn new(
        contact: &'a Contact,
        case: &'a ScaledImpact,
        outcome: &'a ScaledResult,
        approach: Approach,
    ) -> Result<Option<Self>, ImpactError> {
        let Some(friction) = approach.friction.filter(|_| outcome.end == ImpactEnd::Separated) else {
            return Ok(None);
        };
        if matches!(contact.half_space().support, Support::Free(_)) {
            return Err(ImpactError::NoBall);
        }
        if let Some(moment) = contact.moment_of_inertia() {
            InvalidInput::check("moment of inertia (kg m^2)", moment, moment > 0.0, "it must be a positive number")?;
        }
        InvalidInput::check("coefficient of friction", friction, friction >= 0.0, "it must be 0 or a positive number")?;
        let slip = Slip::new(approach.tangential, contact.sphere().radius);
        let at_contact = 4.0 * contact.shear_ratio() * slip.speed;
        let psi = if slip.speed == 0.0 { 0.0 } else { at_contact / (friction * approach.normal) };
        Ok(Some(Self { contact, case, outcome, approach, friction, slip, psi, chi: contact.chi() }))
    }

    /// The normal impulse over m v_n: 1 + e, and under gravity also the impulse of the weight.
    fn impulse(&self) -> f64 {
        let ScaledResult { restitution, contact_time, .. } = self.outcome;
        1.0 + restitution + FORCE_FACTOR * self.case.forces.weight * contact_time / self.case.q
    }

    /// s_1/s_0 if the contact point slides during the whole contact.
    fn sliding_ratio(&self) -> f64 {
        1.0 - 2.0 * self.chi * self.impulse() / self.psi.abs()
    }

    /// True if the contact point certainly slides during the whole contact, without gravity, damping, plate and rod.
    ///
    /// ```text
    /// |ψ_1| ≥ max(2χ (1 + e) − e min(1, 2n − 2),  2χ + r)
    /// ```
    ///
    /// First condition: at separation the contact point still slides faster than the stops at the rim close in. Second condition: at
    /// the peak it still slides faster than the stops rise. r bounds the rate of the stops: 1 for Hertz, and 2 for the PLM, whose
    /// stops rise by at most 1.3. The stops of other laws may jump; these laws are integrated.
    fn slides_throughout(&self) -> bool {
        let ScaledResult { unloading, restitution: e, .. } = self.outcome;
        let rate = match self.case.ground.law.rule_while_loading() {
            _ if self.psi.is_infinite() => 0.0,
            _ if !self.case.forces.is_none() => return false,
            UnloadingRule::Hertz => 1.0,
            UnloadingRule::PlmRule(_) => 2.0,
            UnloadingRule::Published(_) | UnloadingRule::Relaxed(_) => return false,
        };
        let end = 2.0 * self.chi * (1.0 + e) - e * (2.0 * unloading.exponent - 2.0).min(1.0);
        self.psi.abs() >= end.max(2.0 * self.chi + rate)
    }

    /// The change of the slip speed. It is known without a run if the contact point does not move, or slides during the whole contact.
    /// With `is_followed` the result also has the friction during the contact.
    ///
    /// # Errors
    /// [`ImpactError::SmallInertia`] if the contact point oscillates too often for a run.
    pub(super) fn slip_result(&self, is_followed: bool) -> Result<SlipResult, ImpactError> {
        if self.slip.speed == 0.0 {
            return Ok(SlipResult::without_steps(0.0, false));
        }
        if self.slides_throughout() {
            return Ok(SlipResult::without_steps(self.sliding_ratio(), true));
        }
        // all elastic impacts have the same normal motion
        let is_elastic =
            matches!(self.case.ground.law.unloading_rule, UnloadingRule::Hertz) && self.case.forces.is_none();
        let motion;
        let motion = if is_elastic {
            NormalMotion::elastic_motion()?
        } else {
            motion = NormalMotion::new(self.case.ground, self.case.q, &self.case.forces)?;
            &motion
        };
        self.check_resolution(motion)?;
        let psi = self.psi.abs();
        let computed = psi.max(MIN_PSI);
        let accuracy = if is_followed { RUN_ACCURACY } else { ROW_ACCURACY };
        let run = motion.run(computed * self.case.q, self.chi, accuracy, is_followed)?;
        let run = if psi < computed { run.scale_by(psi / computed) } else { run };
        Ok(if run.is_sliding { SlipResult { ratio: self.sliding_ratio(), ..run } } else { run })
    }

    /// Checks that the contact point does not oscillate too often for a run.
    fn check_resolution(&self, motion: &NormalMotion) -> Result<(), ImpactError> {
        let (swings, mass, radius) = (motion.phase_angle(self.chi), self.contact.mass(), self.contact.sphere().radius);
        if swings <= MAX_PHASE_ANGLE {
            return Ok(());
        }
        // the angle is proportional to √j, and j − 1 to 1/I
        let share = MAX_PHASE_ANGLE / swings;
        let j = self.contact.slip_factor() * share * share;
        let of_sphere = mass * radius * radius;
        let least = (j > 1.0).then(|| of_sphere / (j - 1.0));
        Err(ImpactError::SmallInertia { least, solid: 0.4 * of_sphere })
    }

    pub(super) fn rebound(&self, slip: &SlipResult) -> Result<Rebound, OutOfFloatRange> {
        let normal = self.approach.normal;
        let (rebound, _) = self.contact.speeds_after(normal, self.outcome.restitution);
        let (before, after) = (self.slip.speed, self.slip.speed * slip.ratio);
        let tangential = self.slip.sphere_at(self.contact, after);
        let lost = self.friction_loss(slip);
        let [x, y] = self.approach.tangential.velocity();
        let velocity = tangential.velocity();
        if !velocity.iter().chain(&tangential.spins()).chain([&lost]).all(|value| value.is_finite()) {
            return Err(OutOfFloatRange { quantity: "tangential speed after the impact (m/s)", value: velocity[0] });
        }
        let is_slipping = before != 0.0;
        Ok(Rebound {
            tangential,
            angle: atan2(tangential.signed_speed(), rebound),
            tangential_restitution: velocity[0] / self.approach.tangential.speed,
            contact_point_restitution: if is_slipping { -slip.ratio } else { f64::NAN },
            impulse_ratio: if slip.is_sliding && is_slipping {
                self.friction.copysign(before)
            } else {
                before * (1.0 - slip.ratio) / (self.contact.slip_factor() * self.impulse() * normal)
            },
            target: self.slip.target_at(self.contact, after),
            loss_fraction: lost / (normal * normal + x * x + y * y),
            is_sliding: slip.is_sliding,
            psi: self.psi,
            error: slip.error,
        })
    }

    /// (s_0² − s_1²)/j: the energy absorbed by friction, over ½ m*.
    fn friction_loss(&self, slip: &SlipResult) -> f64 {
        let before = self.slip.speed;
        before * before * (1.0 - slip.ratio * slip.ratio) / self.contact.slip_factor()
    }

    /// The rest of the results of one impact.
    pub(super) fn result(&self, slip: &SlipResult) -> ObliqueResult {
        let SlipBalance { kinetic_in, recovered, momentum_error } =
            self.slip.balance(self.contact, self.slip.speed * slip.ratio);
        let loss = 0.5 * self.contact.reduced_mass() * self.friction_loss(slip);
        ObliqueResult { kinetic_in, recovered, loss, momentum_error }
    }

    /// Friction at a time \[s\], for this speed of the sphere towards the half-space and this contact force. SI units.
    pub(super) fn friction_at(&self, slip: &SlipResult, time: f64, speed: f64, force: f64) -> FrictionState {
        let (mu, scales) = (self.friction, &self.case.scales);
        let before = self.slip.speed;
        let direction = before.signum();
        let (slip_speed, friction_force) = match () {
            () if before == 0.0 => (0.0, 0.0),
            () if slip.steps.is_empty() => {
                let slowed = self.contact.slip_factor() * mu * (self.approach.normal - speed);
                (before - direction * slowed, -direction * mu * force)
            }
            () if time >= (1.0 - 1e-8) * slip.end * scales.time() => (before * slip.ratio, 0.0),
            () => {
                let impulse = (self.approach.normal - speed) / scales.speed / FORCE_FACTOR
                    + self.case.forces.weight * time / scales.time();
                let [share, of_force] = slip.slip_and_force(time / scales.time(), force / scales.units.force, impulse);
                (share * before, direction * mu * scales.units.force * of_force)
            }
        };
        FrictionState { slip_speed, friction_force, tangential: self.slip.sphere_at(self.contact, slip_speed) }
    }
}
