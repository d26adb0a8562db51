//! The forces in addition to the contact law: gravity, damping, and a plate or rod that gives way. A scene has only the forces that it names.
//!
//! The sphere moves by m δ'' = −F_c + m g. The contact force F_c is the F of the law without damping, and otherwise follows
//! [`Damping`]. The contact never pulls. So under viscous damping, and in a viscoelastic contact, the sphere separates where F_c
//! vanishes, above the bottom of its dent, also at ζ ≥ 1. The elastic energy that the contact still holds there is reported. k_t jumps
//! at the knots of a law, and so does a damping force that depends on k_t. With damping the peak force comes before maximum
//! compression; the integration locates it as an event.
//!
//! A sphere that the recovered work cannot lift out of its dent is captured: e = 0, and there is no contact time. Without
//! damping this is so where F_m ≤ (n + 1) m g. A sphere let go at first contact is always captured, because it has no kinetic
//! energy; it has no restitution.
//!
//! Under gravity alone peak and rebound follow from the energy ([`crate::impact::solve::closed_form`]). In other cases the energy balance
//! checks the run: kinetic + stored + plastic + damping − m g δ = ½ m v². Its error is at most about 10 tolerances. If the
//! tolerance is above 1e-4 and the weight exceeds the force at first yield, it is up to 60 tolerances: such a weight accelerates
//! a slow sphere to hundreds of times its speed, and the error of the first step grows with the speed.

use super::scales::{FORCE_FACTOR, Scales};
use super::waveguide::Waveguide;
use crate::contact::body::InvalidInput;
use crate::contact::law::unloading::OLD_PEAK_ROUNDING;
use crate::contact::law::{Surface, Unloading};
use crate::impact::flight::free_flight::FreeFlight;
use crate::numerics::ode::{DampingCoefficients, RestCriterion};
use crate::numerics::power::nan_max;

/// Damping on top of the contact law; the total contact force never pulls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// F (1 + χ δ'), with the elastic-plastic force F of the law and χ \[s/m\], ≥ 0 (Hunt and Crossley 1975).
    HuntCrossley(f64),
    /// F + 2 ζ √(m k_t) δ', with the tangent stiffness k_t = dF/dδ of the current branch and ζ \[1\], ≥ 0, the fraction of
    /// critical damping (on a Hertz contact this is the δ^¼ of Tsuji, Tanaka and Ishida 1992).
    Viscous(f64),
    /// F + A k_t δ', with the tangent stiffness k_t and a time A \[s\], ≥ 0: viscoelastic bodies (Kuwabara and Kono 1987; Brilliantov
    /// et al. 1996). On a Hertz contact it is (4/3) E* √R (δ^(3/2) + (3/2) A √δ δ'). To first order in A
    ///
    /// ```text
    /// e = 1 − 1.15344 a,   a = (3/2) A v/L,   L = (m v²/((4/3) E* √R))^(2/5)
    /// ```
    Viscoelastic(f64),
}

impl Damping {
    /// The resistance in the units of an impact.
    pub fn scaled_coefficients(self, scales: &Scales) -> DampingCoefficients {
        let none = DampingCoefficients::NONE;
        match self {
            Self::HuntCrossley(chi) => DampingCoefficients { hunt_crossley: chi * scales.speed, ..none },
            Self::Viscous(zeta) => DampingCoefficients { viscous: 2.0 * zeta, ..none },
            Self::Viscoelastic(time) => DampingCoefficients { viscoelastic: time / scales.time(), ..none },
        }
    }

    /// χ, ζ or A.
    fn constant(self) -> f64 {
        let (Self::HuntCrossley(constant) | Self::Viscous(constant) | Self::Viscoelastic(constant)) = self;
        constant
    }
}

/// The forces on the sphere in addition to the contact law. Damping acts in the contact; gravity and a waveguide act on the motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Forces {
    /// Gravity along the approach g \[m/s²\], > 0.
    pub gravity: Option<f64>,
    pub damping: Option<Damping>,
    /// The plate or rod in place of the half-space.
    pub waveguide: Option<Waveguide>,
    /// The flight before and after the impact, if there is gravity or a drop height. It does not act in the contact.
    pub flight: Option<FreeFlight>,
}

impl Forces {
    /// Checks gravity and damping, as a scenario does.
    #[inline]
    pub(in crate::impact) fn check(&self) -> Result<(), InvalidInput> {
        let rule = "it must be 0 or a positive number";
        let check =
            |quantity, value: f64| InvalidInput::check(quantity, value, value >= 0.0 && value.is_finite(), rule);
        if let Some(gravity) = self.gravity {
            check("gravity (m/s^2)", gravity)?;
        }
        match self.damping {
            None => Ok(()),
            Some(Damping::HuntCrossley(chi)) => check("damping of Hunt and Crossley (s/m)", chi),
            Some(Damping::Viscous(zeta)) => check("viscous damping", zeta),
            Some(Damping::Viscoelastic(time)) => check("viscoelastic time (s)", time),
        }
    }

    /// True if only the law acts.
    pub fn is_none(&self) -> bool {
        self.gravity.is_none() && self.damping.is_none() && self.waveguide.is_none()
    }

    /// True if damping or a waveguide absorbs energy.
    pub(crate) fn has_dissipation(&self) -> bool {
        self.waveguide.is_some() || self.damping.is_some_and(|damping| damping.constant() != 0.0)
    }
}

/// Gravity of a fall \[m/s²\] if the scenario gives none.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// The forces in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaledForces {
    /// w = m g/Φ; 0 without gravity.
    pub weight: f64,
    /// Damping in the contact, and the waveguide, which gives way by y f' u: θ = y/(5/4) with y = Y Φ/V.
    pub damping: DampingCoefficients,
}

impl ScaledForces {
    /// No force but the law.
    pub const NONE: Self = Self { weight: 0.0, damping: DampingCoefficients::NONE };

    /// True if only the law acts.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.weight == 0.0 && self.is_conservative()
    }

    /// True if there is no damping and no waveguide, so that only the dent absorbs energy.
    #[inline]
    pub(in crate::impact) fn is_conservative(&self) -> bool {
        self.damping == DampingCoefficients::NONE
    }

    /// True if a sphere that came at q = v/V stays in its dent. It is for impacts without damping.
    pub fn is_captured(&self, unloading: &Unloading, q: f64) -> bool {
        let largest = (unloading.exponent + 1.0) * self.weight;
        // an elastic contact recovers the energy that it absorbed, except for rounding
        let largest = if unloading.peak.residual() > 0.0 { largest } else { largest * (1.0 - OLD_PEAK_ROUNDING) };
        self.weight > 0.0 && (q == 0.0 || unloading.peak.force <= largest)
    }

    /// True if the rebound speed equals the impact speed: nothing absorbs energy, and the sphere separates where it touched. If it
    /// separates deeper, in a dent that cost no energy, its weight does work over this distance.
    pub(in crate::impact) fn is_lossless(&self, ground: Surface, unloading: &Unloading) -> bool {
        let sinks = self.weight > 0.0 && ground.deepest_state(&unloading.peak).residual() > ground.first_contact();
        self.is_conservative() && ground.plastic_work(unloading) == 0.0 && !sinks
    }

    /// The point at which the contact carries the weight: on the unloading branch, or on the loading curve if the sphere has not yet
    /// reached this depth.
    pub(in crate::impact) fn static_equilibrium(&self, ground: Surface, unloading: &Unloading) -> StaticEquilibrium {
        if unloading.peak.force < self.weight {
            self.equilibrium_on_loading(ground)
        } else {
            self.equilibrium_on_unloading(ground, unloading)
        }
    }

    /// The point at which the unloading branch carries the weight; at most its peak.
    pub(in crate::impact) fn equilibrium_on_unloading(
        &self,
        ground: Surface,
        unloading: &Unloading,
    ) -> StaticEquilibrium {
        let distance = unloading.elastic_approach_at_force(self.weight);
        let indentation = ground.deepest_state(&unloading.peak).residual() + distance;
        StaticEquilibrium { indentation, distance, slope: unloading.slope_at(distance) }
    }

    pub(in crate::impact) fn equilibrium_on_loading(&self, ground: Surface) -> StaticEquilibrium {
        let indentation = ground.indentation_at_force(self.weight);
        let slope = ground.piece(ground.reloading_path.index_at(indentation)).slope_at(indentation);
        StaticEquilibrium { indentation, distance: indentation - ground.first_contact(), slope }
    }

    /// The criterion of rest for an overdamped sphere, at this distance of the leg: the sphere creeps up to the static point, and never
    /// passes it. `None` for a sphere that oscillates about this point. A run ends as soon as the sphere is near enough and slow
    /// enough: its speed is at most the faster of the two decay rates times the remaining distance.
    pub(in crate::impact) fn rest_criterion(&self, point: &StaticEquilibrium, distance: f64) -> Option<RestCriterion> {
        let omega = (FORCE_FACTOR * point.slope).sqrt();
        let DampingCoefficients { hunt_crossley: chi, viscous: eta, viscoelastic: kappa, plate: theta } = self.damping;
        // the fraction of critical damping of small oscillations
        let zeta = 0.5 * (FORCE_FACTOR * self.weight * chi / omega + eta + (kappa + theta) * omega);
        let tolerance = CREEP_TOLERANCE * point.distance;
        // from ζ = 0.9 on every half oscillation is below e^(−πζ/√(1−ζ²)) = 0.2 % of the one before: too small to be resolved
        let fast = zeta + (zeta * zeta - 1.0).max(0.0).sqrt();
        let is_overdamped = self.weight > 0.0 && zeta >= 0.9;
        is_overdamped.then_some(RestCriterion { distance, tolerance, largest_speed: fast * omega * tolerance })
    }
}

/// The contact force where the law has this force and slope: with what damping adds to it, and never below 0. At separation it is zero,
/// except for rounding.
#[inline]
pub(in crate::impact) fn total_force(
    drag: DampingCoefficients,
    force: f64,
    slope: impl FnOnce() -> f64,
    speed: f64,
) -> f64 {
    if !drag.acts_in_contact() {
        return force;
    }
    // the drag is that of the deceleration g = c f
    let per_speed = drag.rates_at_force(FORCE_FACTOR * force, || FORCE_FACTOR * slope()).0;
    nan_max(force + per_speed / FORCE_FACTOR * speed, 0.0)
}

/// The point at which a contact carries the weight of its sphere.
#[derive(Debug, Clone, Copy)]
pub(in crate::impact) struct StaticEquilibrium {
    /// x.
    pub(in crate::impact) indentation: f64,
    /// Distance from the start of its branch: first contact, or the residual indentation.
    pub(in crate::impact) distance: f64,
    /// Tangent stiffness df/dx.
    slope: f64,
}

/// An overdamped sphere counts as captured if its distance to the static indentation is a smaller fraction of the static depth.
const CREEP_TOLERANCE: f64 = 1e-3;
