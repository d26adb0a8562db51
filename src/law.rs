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
//! * The other published laws name theirs: [`catalogue`] has them, and lists those that are not public.

pub mod catalogue;
mod contact_law;
pub(crate) mod crossing;
pub mod curve;
pub mod jumps;
mod panel;
pub mod piece;
pub mod plm;
pub mod published;
pub mod reloading;
pub mod unloading;

pub use catalogue::{Combined, LawChoice};
pub use contact_law::{About, Bodies, ContactLaw};
use curve::Curve;
pub use plm::{CoefficientsError, Plm, PlmCoefficients};
use plm::{ContactRadius, ElasticLine, Hardening};

use crate::math::functions::pow;
use published::WIDEST_PARABOLOID;
pub use published::{Loading, OutsideLaw, Published};
pub use unloading::{Peak, Unloading, UnloadingExponent, UnloadingShape, pressure_shape_exponent};

/// The part of the approach that would be recovered, ε, along the loading curve.
#[derive(Debug, Clone, PartialEq)]
pub enum ElasticApproach {
    /// All of it: ε = x.
    All,
    /// The polyline of the PLM, ε = min(x, `ε_line(f)`).
    Line(ElasticLine),
    /// The same on a half-space that hardens.
    Hardening(Box<Hardening>),
    /// Hertz-type unloading of fixed stiffness k: ε = (f/k)^(2/3), as in the test problems of the speed report.
    FixedStiffness(f64),
    /// By the rules of a published law.
    Published(Box<Published>),
    /// On a spot that was loaded before.
    Reloaded(Box<Reloaded>),
}

/// The law of a spot that was loaded before.
#[derive(Debug, Clone, PartialEq)]
pub struct Reloaded {
    /// The unloading branch from the largest state so far.
    pub branch: Unloading,
    /// a/a_Y there: the dent keeps its shape, so that on the branch the contact radius falls in proportion to f/ε.
    radius: f64,
    /// The law of fresh surface.
    fresh: Law,
}

/// The branch of its law that a contact is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// Loading without a dent so far.
    Elastic,
    /// Loading, the dent grows.
    Plastic,
    /// Loading in a dent made before, back up its unloading branch.
    Reloading,
    /// Unloading.
    Unloading,
    /// The sphere is above the dent, without contact. An impact ends there.
    Separated,
}

impl Branch {
    /// `elastic`, `plastic`, `reloading`, `unloading` or `separated`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Plastic => "plastic",
            Self::Reloading => "reloading",
            Self::Unloading => "unloading",
            Self::Separated => "separated",
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
    /// Contact radius along it.
    pub radius: ContactRadius,
    /// Exponent of the unloading branch.
    pub exponent: UnloadingExponent,
}

impl Law {
    /// Hertz without end: loading and unloading on f = x^1.5.
    pub fn hertz() -> Self {
        Self {
            loading: Curve::hertz(),
            elastic: ElasticApproach::All,
            radius: ContactRadius::default(),
            exponent: UnloadingExponent::Paper,
        }
    }

    /// Elastic approach ε at a point (x, f) of the loading curve; 0 < ε ≤ x.
    #[inline(always)]
    pub fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        match &self.elastic {
            ElasticApproach::Published(law) => law.elastic_approach(x, force),
            ElasticApproach::Reloaded(reloaded) => reloaded.elastic_approach(x, force),
            ElasticApproach::Line(line) if x > 1.0 => line.at(force).min(x),
            ElasticApproach::Hardening(hardening) if x > 1.0 => hardening.elastic_approach(x, force),
            ElasticApproach::FixedStiffness(stiffness) if x > 1.0 => pow(force / stiffness, 2.0 / 3.0).min(x),
            _ => x,
        }
    }

    /// The state at x on the loading curve, as a peak that unloading may leave from.
    pub fn loaded_to(&self, x: f64) -> Peak {
        let force = self.loading.force(x);
        Peak { indentation: x, force, elastic_approach: self.elastic_approach(x, force) }
    }

    /// The unloading branch from a peak. Where loading was elastic (x ≤ 1, or ε = x), n = 3/2 whatever the choice. It never
    /// gives back more than was spent (`unloading::exponent_within`). On the branch of a spot that was loaded before it is
    /// that branch.
    pub fn unloading(&self, peak: Peak) -> Unloading {
        match &self.elastic {
            ElasticApproach::Published(law) => law.unloading(peak),
            ElasticApproach::Reloaded(reloaded) => reloaded.unloading(peak),
            _ => self.unloading_within(peak, self.loading.work(peak.indentation)),
        }
    }

    /// The unloading branch from a turn at a distance from the start of a piece, where loading took the work `spent`.
    #[inline(always)]
    pub(crate) fn turned_at(&self, index: usize, distance: f64, spent: f64) -> Unloading {
        if let ElasticApproach::Reloaded(_) = self.elastic {
            return self.unloading(self.state_at(index, distance));
        }
        let piece = &self.loading.pieces()[index];
        let indentation = piece.start + distance;
        let force = piece.force_at(indentation);
        if let ElasticApproach::Published(law) = &self.elastic {
            return law.unloading_from(indentation, force, spent);
        }
        let elastic_approach = self.elastic_approach(indentation, force);
        self.unloading_within(Peak { indentation, force, elastic_approach }, spent)
    }

    /// The branch of the exponent that the law asks for, if it gives back no more than was spent.
    #[inline(always)]
    fn unloading_within(&self, peak: Peak, spent: f64) -> Unloading {
        Unloading::power(peak, unloading::exponent_within(spent, &peak, self.exponent_asked(&peak)))
    }

    /// The exponent that the law asks for, even if the branch would give back more than was spent.
    #[inline(always)]
    fn exponent_asked(&self, peak: &Peak) -> f64 {
        match self.exponent {
            UnloadingExponent::Fixed(n) if peak.residual() > 0.0 => n,
            UnloadingExponent::PressureShape if peak.indentation > 1.0 => self.pressure_shape(peak),
            _ => 1.5,
        }
    }

    /// The exponent that follows from the shape of the contact pressure at a peak beyond first yield.
    #[inline(always)]
    fn pressure_shape(&self, peak: &Peak) -> f64 {
        let equivalent = peak.force / peak.elastic_approach;
        match &self.elastic {
            ElasticApproach::Hardening(hardening) => {
                let shape = hardening.shape(peak.indentation, equivalent);
                pressure_shape_exponent(self.radius.ratio_at(shape.equivalent)) - shape.exponent_loss()
            }
            _ => pressure_shape_exponent(self.radius.ratio_at(equivalent)),
        }
    }

    /// x up to which loading is elastic: all of the approach is recovered, on the loading curve itself.
    #[inline(always)]
    pub fn elastic_until(&self) -> f64 {
        match &self.elastic {
            ElasticApproach::All => f64::INFINITY,
            ElasticApproach::Line(_) | ElasticApproach::Hardening(_) | ElasticApproach::FixedStiffness(_) => 1.0,
            ElasticApproach::Published(law) => law.loading.elastic_until,
            ElasticApproach::Reloaded(reloaded) => reloaded.branch.peak.indentation,
        }
    }

    /// The range of x that the authors of the law state, where a plastic peak is outside of it.
    pub(crate) fn outside_stated(&self, peak: &Peak) -> Option<(f64, f64)> {
        match &self.fresh().elastic {
            ElasticApproach::Published(law) if self.branch_at(peak.indentation).is_none() => law.outside_stated(peak),
            _ => None,
        }
    }

    /// Largest a/R of the data behind the loading, or of what it takes for granted.
    pub(crate) fn widest_contact(&self) -> f64 {
        match &self.fresh().elastic {
            ElasticApproach::All => WIDEST_PARABOLOID,
            ElasticApproach::Hardening(_) => 0.32,
            ElasticApproach::Published(law) => law.loading.widest,
            _ => 0.45,
        }
    }

    /// How a half-space that hardens changes the law.
    pub(crate) fn hardening(&self) -> Option<&Hardening> {
        match &self.fresh().elastic {
            ElasticApproach::Hardening(hardening) => Some(hardening),
            _ => None,
        }
    }

    /// Checks that the law has an answer for a peak.
    ///
    /// # Errors
    /// [`OutsideLaw`] where a published law has no answer there.
    #[inline]
    pub fn accept(&self, peak: &Peak) -> Result<(), OutsideLaw> {
        match &self.fresh().elastic {
            ElasticApproach::Published(law) if self.branch_at(peak.indentation).is_none() => law.accept(peak),
            _ => Ok(()),
        }
    }

    /// The largest force of loading on the way to a peak: that of the peak, unless the force of a published law falls at a
    /// jump.
    #[inline]
    pub fn largest_force(&self, peak: &Peak) -> f64 {
        if self.loading.falls() { self.loading.largest_force(peak.indentation, peak.force) } else { peak.force }
    }

    /// Contact radius a/a_L at a peak, a = â/(Λ G) with the Hertz-equivalent A = f/ε (a_L: Hertz radius at x = 1).
    ///
    /// Compared with finite elements, the radius of the PLM is within 5 % up to a = 0.48 R. A mean pressure computed from it
    /// has twice the error, with the opposite sign.
    pub fn contact_radius(&self, peak: &Peak) -> f64 {
        let equivalent = peak.force / peak.elastic_approach;
        let geometry = self.radius.geometry_at(equivalent);
        match &self.elastic {
            ElasticApproach::Published(law) => law.contact_radius(peak),
            ElasticApproach::Reloaded(reloaded) => reloaded.contact_radius(peak),
            ElasticApproach::Hardening(hardening) => {
                let shape = hardening.shape(peak.indentation, equivalent);
                equivalent / (self.radius.ratio_at(shape.equivalent) * geometry * shape.narrowing())
            }
            _ => equivalent / (self.radius.ratio_at(equivalent) * geometry),
        }
    }

    /// Force at x for a contact whose largest state so far is `memory`, and the memory afterwards.
    ///
    /// Below the old peak the contact moves on the unloading branch, up or down; beyond it, on the loading curve.
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
