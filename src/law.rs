//! Contact laws: a loading curve made of smooth pieces, the elastic approach along it, and an unloading rule.
//!
//! A law is data. It knows no time, no file and no solver, and evaluating it changes nothing: the memory of a contact
//! (its largest state so far, [`Peak`]) is a value that is handed in and out.
//!
//! # Sources
//! * Hertz (1882), J. reine angew. Math. 92, 156-171.
//! * Xie, Guo, Ding, Yin, Weng (2024), Materials 17, 3018, doi 10.3390/ma17123018: yield point, unloading, residual radius.
//! * Weng, Yin, Hu et al. (2021), Tribology International 162, 107114, doi 10.1016/j.triboint.2021.107114: the
//!   piecewise-linear loading model (PLM). Its coefficients are in no public text; the built-in ones were fitted anew to
//!   finite-element curves, see [`plm`].

pub mod curve;
pub mod plm;
pub mod reloading;
pub mod unloading;

use curve::Curve;
pub use plm::{CoefficientsError, PlmCoefficients};
use plm::{ElasticLine, RadiusRatio};
pub use reloading::Reloaded;
pub use unloading::{Peak, Unloading};

/// Which exponent n the unloading branch has.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum UnloadingExponent {
    /// n = 3/2, the paper's law.
    #[default]
    Paper,
    /// Any number in (1, 2].
    Fixed(f64),
    /// n(Λ) from the contact pressure's shape at the peak: 3/2 for Hertz's ellipse, 3π/4 − 1 for uniform pressure.
    PressureShape,
}

/// The part of the approach that would be recovered, ε, along the loading curve.
#[derive(Debug, Clone, PartialEq)]
pub enum ElasticApproach {
    /// All of it: ε = x.
    All,
    /// The polyline of the PLM, ε = min(x, `ε_line(f)`).
    Line(ElasticLine),
    /// Hertz-type unloading of fixed stiffness k: ε = (f/k)^(2/3), as in the test problems of the speed report.
    FixedStiffness(f64),
    /// On a spot that was loaded before.
    Reloaded(Box<Reloaded>),
}

impl ElasticApproach {
    /// ε at a point (x, f) of the loading curve; 0 < ε ≤ x.
    #[inline]
    #[must_use]
    pub fn at(&self, x: f64, force: f64) -> f64 {
        match self {
            Self::All => x,
            Self::Reloaded(reloaded) => reloaded.approach(x, force),
            _ if x <= 1.0 => x,
            Self::Line(line) => line.at(force).min(x),
            Self::FixedStiffness(stiffness) => (force / stiffness).powf(2.0 / 3.0).min(x),
        }
    }
}

/// A contact law in dimensionless form (x = δ/L, f = F/Φ).
#[derive(Debug, Clone, PartialEq)]
pub struct Law {
    /// Loading force.
    pub loading: Curve,
    /// Elastic approach along the loading curve.
    pub elastic: ElasticApproach,
    /// Hertz-equivalent over true contact radius, Λ.
    pub radius_ratio: RadiusRatio,
    /// Exponent of the unloading branch.
    pub exponent: UnloadingExponent,
}

impl Law {
    /// Hertz without end: loading and unloading on f = x^1.5.
    #[must_use]
    pub fn hertz() -> Self {
        Self {
            loading: Curve::hertz(),
            elastic: ElasticApproach::All,
            radius_ratio: RadiusRatio::default(),
            exponent: UnloadingExponent::Paper,
        }
    }

    /// Elastic approach ε at a point (x, f) of the loading curve; 0 < ε ≤ x.
    #[inline]
    #[must_use]
    pub fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        self.elastic.at(x, force)
    }

    /// The state at x on the loading curve, as a peak that unloading may leave from.
    #[must_use]
    pub fn loaded_to(&self, x: f64) -> Peak {
        let force = self.loading.force(x);
        Peak { indentation: x, force, elastic_approach: self.elastic_approach(x, force) }
    }

    /// The unloading branch from a peak. Where loading was elastic (x ≤ 1, or ε = x), n = 3/2 whatever the choice; on the
    /// branch of a spot that was loaded before, that branch.
    #[inline]
    #[must_use]
    pub fn unloading(&self, peak: Peak) -> Unloading {
        if let ElasticApproach::Reloaded(reloaded) = &self.elastic
            && peak.indentation <= reloaded.branch.peak.indentation
        {
            return Unloading { peak, exponent: reloaded.branch.exponent };
        }
        let exponent = match self.exponent {
            UnloadingExponent::Fixed(n) if peak.residual() > 0.0 => n,
            UnloadingExponent::PressureShape if peak.indentation > 1.0 => {
                pressure_shape_exponent(self.radius_ratio.at(peak.force / peak.elastic_approach))
            }
            _ => 1.5,
        };
        Unloading { peak, exponent }
    }

    /// Contact radius a/a_L at a peak, a = â/Λ(A) with the Hertz-equivalent A = f/ε (a_L: Hertz radius at x = 1).
    #[must_use]
    pub fn contact_radius(&self, peak: &Peak) -> f64 {
        peak.force / peak.elastic_approach / self.radius_ratio_at(peak)
    }

    /// Force at x for a contact whose largest state so far is `memory`, and the memory afterwards.
    ///
    /// Below the old peak the contact moves on the unloading branch, up or down; beyond it, on the loading curve.
    #[must_use]
    pub fn respond(&self, x: f64, memory: Option<Peak>) -> (f64, Option<Peak>) {
        match memory.or(self.branch().map(|branch| branch.peak)) {
            _ if x.is_nan() => (f64::NAN, memory),
            Some(peak) if x <= peak.indentation => (self.unloading(peak).force(x), memory),
            None if x <= 0.0 => (0.0, None),
            _ => {
                let peak = self.loaded_to(x);
                (peak.force, Some(peak))
            }
        }
    }
}

/// n(Λ) = 3/2 − [2 (10 − 3π)/(3π − 8)] (Λ − 1): the straight line between Hertz pressure (Λ = 1, n = 3/2) and uniform
/// pressure (Λ = 3π/8, n = 3π/4 − 1), both exact.
#[must_use]
pub fn pressure_shape_exponent(radius_ratio: f64) -> f64 {
    const THREE_PI: f64 = 3.0 * std::f64::consts::PI;
    1.5 - 2.0 * (10.0 - THREE_PI) / (THREE_PI - 8.0) * (radius_ratio - 1.0)
}
