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
pub use plm::unloading_rule::PlmUnloadingRule;
pub use plm::{CoefficientsError, DeferredCurve, Plm, PlmCoefficients};
pub use published::{LawError, Loading};
use published::{MAX_CLIPPING, MAX_PARABOLOID_RADIUS_RATIO, PublishedRule, Validity};
pub use surface::{LoadingHistory, Surface};
use unloading::OLD_PEAK_ROUNDING;
pub use unloading::{ContactState, LoadedPoint, Unloading, UnloadingExponent, UnloadingShape, pressure_shape_exponent};

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

/// An unloading exponent that is larger than the requested one, because the requested one would recover more energy than was spent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExponentClamp {
    /// The requested exponent.
    pub(crate) requested: f64,
    /// The exponent of the branch.
    pub(crate) used: f64,
    /// The energy that the requested exponent would recover, over the energy that was spent, minus 1.
    pub(crate) gain: f64,
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
        Self { loading, validity: rule.validity(), unloading_rule: UnloadingRule::PlmRule(rule) }
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

    /// Fresh surface recovers the whole approach up to this x.
    #[inline(always)]
    pub(crate) fn recovers_fully_until(&self) -> f64 {
        match &self.unloading_rule {
            UnloadingRule::Relaxed(law) => law.elastic_until(),
            _ => self.validity.elastic_until,
        }
    }

    /// True if fresh surface that was loaded to x may keep a dent; the last digit of x does not matter.
    #[inline(always)]
    pub(crate) fn leaves_dent(&self, x: f64) -> bool {
        x > self.recovers_fully_until() * (1.0 + f64::EPSILON)
    }

    /// The unloading of fresh surface from x.
    #[inline(always)]
    fn rule_at(&self, x: f64) -> &UnloadingRule {
        if self.leaves_dent(x) { &self.unloading_rule } else { &UnloadingRule::Hertz }
    }

    /// The rule of unloading before a metal relaxes; for other laws the rule of unloading.
    pub fn rule_while_loading(&self) -> &UnloadingRule {
        self.unloading_rule.while_loading()
    }

    /// True if the force drops at maximum compression, where the metal relaxes.
    pub(crate) fn relaxes(&self) -> bool {
        matches!(self.unloading_rule, UnloadingRule::Relaxed(_))
    }

    /// The drop of the force where loading turns into this branch; only a metal that relaxes has one.
    pub(crate) fn force_drop_at_peak(&self, unloading: &Unloading) -> f64 {
        let ContactState { indentation, force, .. } = unloading.peak;
        if !matches!(self.rule_at(indentation), UnloadingRule::Relaxed(_)) {
            return 0.0;
        }
        let fall = self.loading.force(indentation) - force;
        // a smaller drop is rounding
        if fall > OLD_PEAK_ROUNDING * force { fall } else { 0.0 }
    }

    /// The unloading branch from a point of the loading curve, or from a state that a contact remembers. If loading was elastic
    /// (ε = x), n = 3/2 for every rule. The branch never recovers more than was spent.
    #[inline(always)]
    pub fn unload(&self, at: impl Into<LoadedPoint>) -> Unloading {
        let at = at.into();
        self.rule_at(at.indentation).unload(&self.loading, &at)
    }

    /// Elastic approach ε at a point (x, f) of the loading curve, the part of x that is recovered; 0 < ε ≤ x.
    pub fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        let is_elastic = x <= self.validity.elastic_until * (1.0 + f64::EPSILON);
        if is_elastic { x } else { self.unloading_rule.elastic_approach(&self.loading, x, force) }
    }

    /// The state at x on the loading curve, from which unloading may begin.
    pub fn loaded_state(&self, x: f64) -> ContactState {
        let force = self.loading.force(x);
        ContactState { indentation: x, force, elastic_approach: self.elastic_approach(x, force) }
    }

    /// Contact radius a/a_L at x of the loading curve of a PLM without the flat of a sphere. It follows from the force of shallow dents.
    pub(in crate::contact) fn plm_contact_radius_at(&self, x: f64) -> f64 {
        let force = self.loading.shallow().force(x);
        match self.rule_at(x) {
            UnloadingRule::PlmRule(rule) => rule.contact_radius_at(x, force / rule.shallow_approach(x, force)),
            _ => force / x,
        }
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

    /// The exponents of this branch, if the requested exponent was raised: the requested one, the used one, and the gain of energy
    /// that this avoids.
    pub(crate) fn exponent_clamp(&self, unloading: &Unloading) -> Option<ExponentClamp> {
        let (peak, used) = (&unloading.peak, unloading.exponent);
        match self.rule_at(peak.indentation) {
            UnloadingRule::PlmRule(rule) => {
                let requested = rule.requested_exponent(peak);
                // the energy of a branch is proportional to 1/(n + 1)
                let gain = (used - requested) / (requested + 1.0);
                (used > requested).then_some(ExponentClamp { requested, used, gain })
            }
            UnloadingRule::Relaxed(law) => law.exponent_clamp(unloading),
            _ => None,
        }
    }

    /// Checks that the law has an answer for the peak of this branch.
    ///
    /// # Errors
    /// [`LawError`] if the law has no answer there: a published law outside of its formulas, and any law whose unloading would
    /// recover more energy than was spent, by more than [`MAX_CLIPPING`].
    #[inline]
    pub fn check(&self, unloading: &Unloading) -> Result<(), LawError> {
        let ContactState { indentation, .. } = unloading.peak;
        let ratio = self.over_yield_indentation(indentation);
        let refused = |problem| Err(LawError::Range { ratio, problem });
        match self.rule_at(indentation) {
            UnloadingRule::Hertz => Ok(()),
            UnloadingRule::PlmRule(_) => match self.exponent_clamp(unloading) {
                Some(ExponentClamp { requested, gain, .. }) if gain > MAX_CLIPPING => {
                    Err(LawError::Exponent { requested, ratio, gain })
                }
                _ => Ok(()),
            },
            UnloadingRule::Published(_) if indentation > self.validity.max_indentation => {
                refused("outside the range of its loading formulas")
            }
            UnloadingRule::Published(rule) => {
                rule.failure_reason(&unloading.peak, self.loading.work(indentation)).map_or(Ok(()), refused)
            }
            UnloadingRule::Relaxed(law) => law.check(unloading),
        }
    }

    /// x over the yield indentation of this law; over the yield indentation of C_ν for a law without an elastic regime.
    pub(crate) fn over_yield_indentation(&self, x: f64) -> f64 {
        if self.validity.elastic_until > 0.0 { x / self.validity.elastic_until } else { x }
    }

    /// Contact radius a/a_L at a peak (a_L: Hertz radius at x = 1).
    ///
    /// The radius of the PLM is within 6 % of finite elements up to a = 0.58 R. A mean pressure computed from it has twice the
    /// error, with the opposite sign.
    pub fn contact_radius(&self, peak: &ContactState) -> f64 {
        if self.leaves_dent(peak.indentation) {
            self.unloading_rule.contact_radius(peak)
        } else {
            self.unloading_rule.elastic_contact_radius(peak)
        }
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
