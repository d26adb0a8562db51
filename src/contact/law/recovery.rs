//! The one way from a point of the loading curve to an unloading branch, by any rule.

use super::UnloadingRule;
use super::plm::DeferredCurve;
use super::unloading::{ContactState, LoadedPoint, Unloading, allowed_exponent};

impl UnloadingRule {
    /// The unloading branch from a point of this loading curve.
    #[inline(always)]
    pub(super) fn unload(&self, loading: &DeferredCurve, at: &LoadedPoint) -> Unloading {
        let &LoadedPoint { indentation, force, .. } = at;
        let work = || at.work.unwrap_or_else(|| loading.work(indentation));
        let peak = |elastic_approach| ContactState { indentation, force, elastic_approach };
        match self {
            Self::Hertz => Unloading::power(peak(at.elastic_approach.unwrap_or(indentation)), 1.5),
            Self::PlmRule(rule) => {
                let (peak, requested) = rule.peak_and_exponent(at);
                Unloading::power(peak, allowed_exponent(work(), &peak, requested))
            }
            Self::Published(rule) => rule.unload(indentation, force, work()),
            // the force of a memory is the force after the relaxation
            Self::Relaxed(law) => law.unload(indentation, loading.force(indentation), work()),
        }
    }

    /// ε at a point (x, f) of this loading curve while it loads.
    pub(super) fn elastic_approach(&self, loading: &DeferredCurve, x: f64, force: f64) -> f64 {
        match self {
            Self::Hertz => x,
            Self::PlmRule(rule) => rule.elastic_approach(x, force),
            Self::Published(rule) => rule.unload(x, force, loading.work(x)).peak.elastic_approach,
            Self::Relaxed(law) => law.while_loading.elastic_approach(loading, x, force),
        }
    }

    /// The rule before a metal relaxes.
    pub(super) fn while_loading(&self) -> &Self {
        if let Self::Relaxed(law) = self { &law.while_loading } else { self }
    }

    /// Contact radius a/a_L at a peak that leaves no dent.
    pub(super) fn elastic_contact_radius(&self, peak: &ContactState) -> f64 {
        match self.while_loading() {
            Self::PlmRule(rule) => rule.contact_radius(peak),
            _ => peak.force / peak.elastic_approach,
        }
    }

    /// Contact radius a/a_L at a peak that leaves a dent.
    pub(super) fn contact_radius(&self, peak: &ContactState) -> f64 {
        match self {
            Self::Hertz => peak.force / peak.elastic_approach,
            Self::PlmRule(rule) => rule.contact_radius(peak),
            Self::Published(rule) => (rule.contact_radius)(peak.indentation, peak.force),
            Self::Relaxed(law) => law.contact_radius(peak.indentation),
        }
    }
}
