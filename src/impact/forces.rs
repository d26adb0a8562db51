//! Forces beside the contact law: gravity and damping, only where a scene names them.

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
    #[must_use]
    pub(super) fn drag(self) -> Drag {
        match self {
            Self::HuntCrossley(chi) => Drag::of_force(chi),
            Self::Viscous(zeta) => Drag::of_stiffness(2.0 * zeta),
        }
    }

    /// Fraction of critical damping of small swings about a place where the contact carries this weight, and where they
    /// have the circular frequency `omega` without damping.
    #[must_use]
    pub(super) fn fraction_of_critical(self, weight: f64, omega: f64) -> f64 {
        match self {
            Self::HuntCrossley(chi) => 0.5 * ACCELERATION * weight * chi / omega,
            Self::Viscous(zeta) => zeta,
        }
    }
}

/// What acts on the sphere beside the contact law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Forces {
    /// Gravity along the approach g \[m/s²\], > 0.
    pub gravity: Option<f64>,
    /// Damping of the contact.
    pub damping: Option<Damping>,
}

impl Forces {
    /// Whether there are none: the impact is that of the law alone.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.gravity.is_none() && self.damping.is_none()
    }
}

/// Speed of a body \[m/s\] that has fallen from rest through `height` \[m\] under `gravity` \[m/s²\]: √(2 g h).
#[must_use]
pub fn drop_speed(gravity: f64, height: f64) -> f64 {
    (2.0 * gravity * height).sqrt()
}
