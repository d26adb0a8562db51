//! Contact laws: a loading curve made of smooth pieces, the elastic approach along it, and an unloading rule.
//!
//! A law is data. It does not depend on time, files or solvers, and evaluating it changes nothing. A spot that was loaded before
//! has a [`LoadingHistory`]; law and dent are the [`Surface`] of an impact. A code that follows a contact step by step keeps its memory, a
//! [`ContactState`], and passes it in at every step.
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
mod loading_history;
mod peak_law;
pub mod plm;
pub mod published;
mod recovery;
mod surface;
pub mod unloading;

use std::sync::Arc;

use crate::numerics::curve::LoadingCurve;
use crate::strings::names::named_enum;
pub use catalogue::{Combined, LawChoice};
pub use contact_law::{ContactLaw, LawInfo, YieldingPair};
pub use loading_history::LoadingHistory;
pub use plm::unloading_rule::{PlmUnloadingRule, UnloadingExponent, pressure_shape_exponent};
pub use plm::{CoefficientsError, DeferredCurve, Plm, PlmCoefficients};
pub use published::{LawError, Loading};
use published::{MAX_PARABOLOID_RADIUS_RATIO, PublishedRule, Validity};
pub(crate) use recovery::ExponentClamp;
pub use surface::Surface;
pub use unloading::{ContactState, LoadedPoint, Unloading, UnloadingShape};

/// How a contact unloads after loading beyond the elastic regime.
#[derive(Debug, Clone)]
pub enum UnloadingRule {
    /// Along Hertz's curve, at any load.
    Hertz,
    PlmRule(Arc<PlmUnloadingRule>),
    Published(Box<PublishedRule>),
    /// By the law of a metal that relaxes at maximum compression.
    Relaxed(Box<PeakLaw>),
}

named_enum! {
    pub enum Branch {
        /// Loading without a dent.
        Elastic = "elastic",
        Plastic = "plastic",
        /// Reloading along the unloading branch of an earlier dent.
        Reloading = "reloading",
        Unloading = "unloading",
        /// The sphere is above the dent, without contact. An impact ends in this state.
        Separated = "separated",
    }
}

/// A contact law in dimensionless form (x = δ/L, f = F/Φ).
#[derive(Debug, Clone)]
pub struct Law {
    pub loading: DeferredCurve,
    /// The range in which the loading holds.
    pub validity: Validity,
    pub unloading_rule: UnloadingRule,
}

/// The law at maximum compression of a metal that relaxes there (strain-rate dependence).
#[derive(Debug, Clone)]
pub struct PeakLaw {
    /// The rule by which the metal would unload without relaxing.
    while_loading: UnloadingRule,
    /// In units of the yield point of this law.
    law: Law,
    /// r.
    ratio: f64,
}

impl Law {
    pub fn new(loading: impl Into<Arc<LoadingCurve>>, validity: Validity, unloading_rule: UnloadingRule) -> Self {
        Self { loading: loading.into().into(), validity, unloading_rule }
    }

    /// True if it is a pair of springs, which know no bodies: a contact of any width is allowed, and what stays is no dent.
    pub fn is_spring(&self) -> bool {
        self.validity.max_radius_ratio.is_infinite()
    }

    /// Hertz without limit: loading and unloading on f = x^1.5.
    pub fn hertz() -> Self {
        Self::new(
            LoadingCurve::hertz(),
            Validity::new(f64::INFINITY, MAX_PARABOLOID_RADIUS_RATIO),
            UnloadingRule::Hertz,
        )
    }

    /// The PLM with this force of shallow dents.
    pub fn plm(shallow: Arc<LoadingCurve>, rule: Arc<PlmUnloadingRule>) -> Self {
        let loading = DeferredCurve::new(shallow, &rule);
        let validity = Validity::new(1.0, rule.max_radius_ratio);
        Self { loading, validity, unloading_rule: UnloadingRule::PlmRule(rule) }
    }

    /// The law of a published loading with a published unloading.
    pub fn from_published(loading: Loading, recovery: published::RecoveryRule) -> Self {
        let Loading { curve, limits, contact_radius } = loading;
        Self::new(curve, limits, UnloadingRule::Published(Box::new(PublishedRule { contact_radius, recovery })))
    }

    /// The loading of shallow dents, if it is the same in units of any strength: the PLM of bodies whose strength is constant, with
    /// a dent alone.
    pub(crate) fn universal_curve(&self) -> Option<&Arc<LoadingCurve>> {
        match &self.unloading_rule {
            UnloadingRule::PlmRule(rule) if rule.hardening.is_none() && rule.flattening.is_none() => {
                Some(self.loading.shallow())
            }
            _ => None,
        }
    }

    /// True if no correction for deep dents changes the force at x.
    pub(crate) fn is_shallow(&self, x: f64) -> bool {
        self.loading.is_shallow(x)
    }

    /// The range of x that the authors of the law state, if a plastic peak is outside of it.
    pub(crate) fn exceeded_fit_range(&self, peak: &ContactState) -> Option<(f64, f64)> {
        let x = peak.indentation;
        self.validity.fitted_range.filter(|(from, to)| self.leaves_dent(x) && !(*from..=*to).contains(&x))
    }

    /// The hardening of the yielding body, if it hardens.
    pub(crate) fn hardening(&self) -> Option<&plm::hardening::Hardening> {
        if let UnloadingRule::PlmRule(rule) = self.rule_while_loading() { rule.hardening.as_ref() } else { None }
    }

    /// x over the yield indentation of this law; over the yield indentation of C_ν for a law without an elastic regime.
    pub(crate) fn over_yield_indentation(&self, x: f64) -> f64 {
        if self.validity.elastic_until > 0.0 { x / self.validity.elastic_until } else { x }
    }

    /// Force at x of a contact with the largest state `memory`, and the memory afterwards.
    ///
    /// Below the old peak the contact follows the unloading branch, in both directions; beyond the peak it follows the loading curve.
    pub fn force_and_memory(&self, x: f64, memory: Option<ContactState>) -> (f64, Option<ContactState>) {
        match memory {
            _ if x.is_nan() => (f64::NAN, memory),
            Some(peak) if x <= peak.indentation => (self.unload(peak).force(x), memory),
            None if x <= 0.0 => (0.0, None),
            _ => {
                let peak = self.loaded_state(x);
                // a relaxed metal follows its branch until the branch meets the loading curve
                let relaxed = memory.filter(|old| self.relaxes() && self.leaves_dent(old.indentation));
                let force_beyond = |old: &Unloading| old.to_piece().force_at_distance(x - old.peak.residual());
                match relaxed.map(|old| force_beyond(&self.unload(old))) {
                    Some(force) if force < peak.force => (force, memory),
                    _ => (peak.force, Some(peak)),
                }
            }
        }
    }
}
