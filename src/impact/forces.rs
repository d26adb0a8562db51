//! What acts beside the contact law: gravity, damping and a plate that gives way, only where a scene names them.
//!
//! # Motion
//!
//! The sphere moves by m δ'' = −F_c + m g, with the contact force F_c: the law's own F without damping, else as
//! [`Damping`] says. The contact never pulls. Under viscous damping the sphere therefore leaves where F_c vanishes, above
//! the bottom of its dent, also at ζ ≥ 1. The elastic energy that the contact still holds there is reported. k_t jumps at
//! the knots of a law, and so does the viscous force. With damping the largest force comes before maximum
//! compression; it is found as an event.
//!
//! # What serves as a reference
//!
//! * Gravity alone: peak and rebound follow from the balance of energy. Contact times have closed forms on straight
//!   pieces, and are quadratures on the others.
//! * Hunt-Crossley damping alone: the phase curve is known, G(u) = G(v) − W/m with G(u) = u/χ − ln(1 + χ u)/χ². For small
//!   χ v, e = 1 − (2/3) χ v + (4/9) (χ v)²; the first term is that of Hunt and Crossley (1975).
//! * In other cases there is none, and the energy balance is the check: kinetic + stored + plastic + damping − m g δ =
//!   ½ m v². The largest errors measured, in units of the tolerance: rk8 10, dop853 25, dopri5 79. Three of 150 000 random
//!   scenes exceeded this, by at most 60 tolerances. All three had a tolerance above 1e-4 and a weight above the force at first
//!   yield: such a weight takes a slow sphere to hundreds of times its speed, and the error of the first step grows with
//!   it.
//!
//! # Capture
//!
//! A sphere that the recovered work cannot lift out of its dent is captured: e = 0, and there is no contact time.
//!
//! * Without damping this is so where F_m ≤ (n + 1) m g. The trace ends at the static indentation on the way out.
//! * With damping it is so where the sphere turns back before it has left. The trace ends there; or, for an overdamped
//!   sphere (ζ from 0.9 on), where it has come within 0.1 % of the static indentation.
//! * A sphere let go at first touch is always captured, because it has no kinetic energy. It has no restitution.

use super::plate::Plate;
use super::scales::ACCELERATION;
use crate::integrate::Drag;

/// Damping on top of the contact law; the total contact force never pulls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// F (1 + χ δ'), with the elastic-plastic force F of the law and χ \[s/m\], ≥ 0 (Hunt and Crossley 1975).
    HuntCrossley(f64),
    /// F + 2 ζ √(m k_t) δ', with the tangent stiffness k_t = dF/dδ of the current branch and ζ \[1\], ≥ 0, the fraction of
    /// critical damping (on a Hertz contact this is the δ^¼ of Tsuji, Tanaka and Ishida 1992).
    Viscous(f64),
}

impl Damping {
    /// The same in units of an impact whose unit of speed is `speed` \[m/s\].
    #[must_use]
    pub(super) fn scaled(self, speed: f64) -> Self {
        match self {
            Self::HuntCrossley(chi) => Self::HuntCrossley(chi * speed),
            Self::Viscous(zeta) => Self::Viscous(zeta),
        }
    }

    /// The resistance, as integrators know it.
    pub(super) fn drag(self) -> Drag {
        match self {
            Self::HuntCrossley(chi) => Drag { chi, ..Drag::NONE },
            Self::Viscous(zeta) => Drag { eta: 2.0 * zeta, ..Drag::NONE },
        }
    }

    /// Fraction of critical damping of small swings about the indentation at which the contact carries this weight. `omega`
    /// is their circular frequency without damping.
    pub(super) fn fraction_of_critical(self, weight: f64, omega: f64) -> f64 {
        match self {
            Self::HuntCrossley(chi) => 0.5 * ACCELERATION * weight * chi / omega,
            Self::Viscous(zeta) => zeta,
        }
    }
}

/// What acts on the sphere beside the contact law. Damping acts in the contact, gravity and a plate act on the motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Forces {
    /// Gravity along the approach g \[m/s²\], > 0.
    pub gravity: Option<f64>,
    /// Damping of the contact.
    pub damping: Option<Damping>,
    /// The plate in place of the half-space.
    pub plate: Option<Plate>,
}

impl Forces {
    /// Whether the law acts alone.
    pub fn is_none(&self) -> bool {
        self.gravity.is_none() && !self.have_drag()
    }

    /// Whether damping or a plate takes energy.
    pub(crate) fn have_drag(&self) -> bool {
        self.damping.is_some() || self.plate.is_some()
    }

    /// Whether an impact under them can be solved without steps on a law of powers and straight lines: without damping, or
    /// with that of Hunt and Crossley and no gravity; never on a plate.
    pub(crate) fn have_closed_form(&self) -> bool {
        let drag = self.damping.map_or(Drag::NONE, Damping::drag);
        self.plate.is_none() && drag.eta == 0.0 && (drag.chi == 0.0 || self.gravity.is_none())
    }
}

/// Speed of a body \[m/s\] that has fallen from rest through `height` \[m\] under `gravity` \[m/s²\]: √(2 g h).
pub fn drop_speed(gravity: f64, height: f64) -> f64 {
    (2.0 * gravity * height).sqrt()
}
