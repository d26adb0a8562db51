//! Recovery of a contact from a point of the loading curve, by any rule: the rule that applies there, unloading branch, elastic
//! approach and contact radius, and whether the law has an answer.

use super::published::MAX_CLIPPING;
use super::unloading::{ContactState, LoadedPoint, Unloading};
use super::{Law, LawError, UnloadingRule};

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

impl Unloading {
    /// The exponents of this branch, if the requested exponent was raised: the requested one, the used one, and the gain of energy
    /// that this avoids.
    pub(crate) fn exponent_clamp(&self) -> Option<ExponentClamp> {
        let (requested, used) = (self.requested, self.exponent);
        // the energy of a branch is proportional to 1/(n + 1)
        let gain = (used - requested) / (requested + 1.0);
        (used > requested).then_some(ExponentClamp { requested, used, gain })
    }
}

impl Law {
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
        if let UnloadingRule::Relaxed(law) = &self.unloading_rule { &law.while_loading } else { &self.unloading_rule }
    }

    /// True if the force drops at maximum compression, where the metal relaxes.
    pub(crate) fn relaxes(&self) -> bool {
        matches!(self.unloading_rule, UnloadingRule::Relaxed(_))
    }

    /// The unloading branch from a point of the loading curve, or from a state that a contact remembers. If loading was elastic
    /// (ε = x), n = 3/2 for every rule. The branch never recovers more than was spent.
    #[inline(always)]
    pub fn unload(&self, at: impl Into<LoadedPoint>) -> Unloading {
        let at = at.into();
        let LoadedPoint { indentation, force, .. } = at;
        let work = || at.work.unwrap_or_else(|| self.loading.work(indentation));
        let peak = |elastic_approach| ContactState { indentation, force, elastic_approach };
        match self.rule_at(indentation) {
            UnloadingRule::Hertz => Unloading::power(peak(at.elastic_approach.unwrap_or(indentation)), 1.5),
            UnloadingRule::PlmRule(rule) => {
                let (peak, requested) = rule.peak_and_exponent(&at);
                Unloading::power_within(peak, requested, work())
            }
            UnloadingRule::Published(rule) => rule.unload(indentation, force, work()),
            // the force of a memory is the force after the relaxation
            UnloadingRule::Relaxed(law) => law.unload(indentation, self.loading.force(indentation), work()),
        }
    }

    /// Elastic approach ε at a point (x, f) of the loading curve, the part of x that is recovered; 0 < ε ≤ x. A metal has not relaxed
    /// there yet.
    pub fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        match self.rule_while_loading() {
            _ if x <= self.validity.elastic_until * (1.0 + f64::EPSILON) => x,
            UnloadingRule::PlmRule(rule) => rule.elastic_approach(x, force),
            UnloadingRule::Published(rule) => rule.unload(x, force, self.loading.work(x)).peak.elastic_approach,
            UnloadingRule::Hertz | UnloadingRule::Relaxed(_) => x,
        }
    }

    /// True if ε at a state of the loading curve is limited because a published law would recover too much there.
    pub(crate) fn limits_approach(&self, state: &ContactState) -> bool {
        let &ContactState { indentation: x, force, .. } = state;
        match self.rule_while_loading() {
            UnloadingRule::Published(rule) => rule.limits_approach(x, force, self.loading.work(x)),
            _ => false,
        }
    }

    /// The state at x on the loading curve, from which unloading may begin.
    pub fn loaded_state(&self, x: f64) -> ContactState {
        let force = self.loading.force(x);
        ContactState { indentation: x, force, elastic_approach: self.elastic_approach(x, force) }
    }

    /// Contact radius a/a_L at a peak (a_L: Hertz radius at x = 1).
    ///
    /// The radius of the PLM is within 6 % of finite elements up to a = 0.58 R. A mean pressure computed from it has twice the
    /// error, with the opposite sign.
    pub fn contact_radius(&self, peak: &ContactState) -> f64 {
        let leaves_dent = self.leaves_dent(peak.indentation);
        match if leaves_dent { &self.unloading_rule } else { self.rule_while_loading() } {
            UnloadingRule::PlmRule(rule) => rule.contact_radius(peak),
            UnloadingRule::Published(rule) if leaves_dent => (rule.contact_radius)(peak.indentation, peak.force),
            UnloadingRule::Relaxed(law) => law.contact_radius(peak.indentation),
            UnloadingRule::Hertz | UnloadingRule::Published(_) => peak.force / peak.elastic_approach,
        }
    }

    /// Contact radius a/a_L at x of the loading curve of a PLM without the flat of a sphere. It follows from the force of shallow dents.
    pub(in crate::contact) fn plm_contact_radius_at(&self, x: f64) -> f64 {
        let force = self.loading.shallow().force(x);
        match self.rule_at(x) {
            UnloadingRule::PlmRule(rule) => rule.contact_radius_at(x, force / rule.shallow_approach(x, force)),
            _ => force / x,
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
            UnloadingRule::PlmRule(_) => match unloading.exponent_clamp() {
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
}
