//! A metal that relaxes at maximum compression: there it has the strength of a lower strain rate than during loading.
//!
//! ```text
//! loading   f_g(x), a law of the strength g σ, in units of its yield point
//! turn      f_t, ε_t, n of the law of the strength g_t σ at the same δ, with r = g_t/g ≤ 1
//!           x = r² x_t,  f = min(f_g, r³ f_t),  ε = r² ε_t
//! ```
//!
//! At maximum compression the force falls from f_g to f, and the dent absorbs the energy. Just beyond first yield r³ f_t would exceed
//! f_g by up to 10⁻⁴, because the first straight piece of the law at the turn lies above Hertz's curve. There f = f_g. The branch
//! recovers at most the work of loading. Fresh surface that turns at x_t ≤ 1 stays elastic.

use std::sync::Arc;

use super::unloading::{ContactState, OLD_PEAK_ROUNDING, Unloading, allowed_exponent};
use super::{Law, LoadingHistory, PeakLaw, Surface, UnloadingRule};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::curve::unloading_curve::{UnloadingCurve, UnloadingCurveKind};
use crate::numerics::root::bisect;

/// The reported peak force is lower than the force at the end of loading by this fraction of the drop.
const UNREPORTED_STEP_SHARE: f64 = 0.8;

impl PeakLaw {
    /// r², r³.
    fn units(&self) -> [f64; 2] {
        let square = self.ratio * self.ratio;
        [square, square * self.ratio]
    }

    fn elastic_until(&self) -> f64 {
        let [length, _] = self.units();
        self.law.validity.elastic_until * length
    }

    /// The unloading branch of a surface that was loaded to x with this force and the loading work `spent`.
    fn unloading_from(&self, x: f64, force: f64, spent: f64) -> Unloading {
        let [per_length, per_force] = self.units();
        let (own, most, spent) = (x / per_length, force / per_force, spent / (per_length * per_force));
        let own_force = self.law.loading.force(own);
        let unloading = if own_force <= most {
            self.law.unloading_from(own, own_force, spent)
        } else {
            // shape and approach follow the law at the turn; f x is more than any branch recovers
            let lowered = self.law.unloading_from(own, own_force, own_force * own).in_units(1.0, most / own_force);
            Unloading { exponent: allowed_exponent(spent, &lowered.peak, lowered.exponent), ..lowered }
        };
        let scaled = unloading.in_units(per_length, per_force);
        // the depth is the depth of the impact, to the last bit, and at most the depth is recovered
        let elastic_approach = scaled.peak.elastic_approach.min(x);
        Unloading { peak: ContactState { indentation: x, elastic_approach, ..scaled.peak }, ..scaled }
    }

    /// A branch in the units of this law.
    fn in_own_units(&self, unloading: &Unloading) -> Unloading {
        let [length, force] = self.units();
        unloading.in_units(1.0 / length, 1.0 / force)
    }
}

impl Law {
    /// Returns this law with another law at maximum compression, whose strength is larger by `ratio`, in the units of that law.
    #[must_use]
    pub(crate) fn with_peak_law(self, law: Law, ratio: f64) -> Self {
        Self { peak_law: Some(Box::new(PeakLaw { law, ratio })), ..self }
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
        self.peak_law.as_ref().map_or(self.validity.elastic_until, |relaxed| relaxed.elastic_until())
    }

    /// The unloading of fresh surface from a point (x, f) of the loading curve, after the loading work `spent`, if the metal relaxes.
    #[inline(always)]
    pub(super) fn peak_unloading_at(&self, x: f64, force: f64, spent: impl FnOnce() -> f64) -> Option<Unloading> {
        let relaxed = self.peak_law.as_ref()?;
        (x > relaxed.elastic_until() * (1.0 + f64::EPSILON)).then(|| relaxed.unloading_from(x, force, spent()))
    }

    /// The law at the turn, with the branch in the units of that law; `None` if the metal does not relax.
    #[inline(always)]
    pub(super) fn at_peak(&self, unloading: &Unloading) -> Option<(&Law, Unloading)> {
        self.peak_law.as_ref().map(|relaxed| (&relaxed.law, relaxed.in_own_units(unloading)))
    }

    /// Contact radius of a turn, if the metal relaxes there.
    #[inline(always)]
    pub(super) fn peak_contact_radius(&self, peak: &ContactState) -> Option<f64> {
        let relaxed = self.peak_law.as_ref()?;
        let [length, _] = relaxed.units();
        let of_law = || relaxed.law.contact_radius(&relaxed.law.loaded_state(peak.indentation / length));
        (peak.indentation > relaxed.elastic_until()).then(|| of_law() * relaxed.ratio)
    }

    /// The drop of the force where loading turns into this branch; 0 if the drop is rounding.
    pub(crate) fn force_drop_at_peak(&self, unloading: &Unloading) -> f64 {
        let ContactState { indentation, force, .. } = unloading.peak;
        match self.peak_law {
            Some(_) if indentation > self.recovers_fully_until() => {
                let fall = self.loading.force(indentation) - force;
                if fall > OLD_PEAK_ROUNDING * force { fall } else { 0.0 }
            }
            _ => 0.0,
        }
    }

    /// The dent with this unloading branch, which was made at another strain rate. Reloading follows the branch to its end, and then
    /// the continuation of the branch until it meets this loading curve. If the branch ends above this loading curve, as after a
    /// much faster impact, the force drops to the loading curve there.
    pub(crate) fn dent_of_other_rate(&self, branch: &Unloading) -> LoadingHistory {
        let (piece, old) = (branch.to_piece(), branch.peak);
        let over = |recovered: f64| piece.force_at_distance(recovered) - self.loading.force(old.residual() + recovered);
        if over(old.elastic_approach) >= 0.0 {
            return self.dented_with(*branch, self.loading.force(old.indentation), true);
        }
        // a branch is steeper than any loading curve
        let mut end = 2.0 * old.elastic_approach;
        while over(end) < 0.0 && end.is_finite() {
            end *= 2.0;
        }
        let (below, _) = bisect(old.elastic_approach, end, |recovered| over(recovered) < 0.0);
        let force = piece.force_at_distance(below);
        let met = ContactState { indentation: old.residual() + below, force, elastic_approach: below };
        self.dented_with(branch.with_peak(met), force, true)
    }
}

impl Unloading {
    /// This branch in a dent with that residual indentation, in which the impact has spent this work: the dent becomes no
    /// shallower, and the branch recovers no more than was spent.
    pub(super) fn in_dent(&self, residual: f64, spent: f64) -> Self {
        let elastic_approach = self.peak.elastic_approach.min(self.peak.indentation - residual);
        let peak = ContactState { elastic_approach, ..self.peak };
        let exponent = allowed_exponent(spent, &peak, self.exponent);
        let is_same = elastic_approach == self.peak.elastic_approach && exponent == self.exponent;
        if is_same { *self } else { Self::power(peak, exponent) }
    }
}

impl Surface<'_> {
    /// The drop of the force where an impact turns into this branch; 0 in a dent.
    pub(crate) fn force_drop_at_peak(&self, unloading: &Unloading) -> f64 {
        self.loading_law_at(unloading.peak.indentation).map_or(0.0, |law| law.force_drop_at_peak(unloading))
    }

    /// The reported peak force: the relaxed force and a fifth of the drop, as in the finite elements. With damping
    /// `largest` is the largest force of loading.
    pub(crate) fn reported_force(&self, unloading: &Unloading, largest: Option<f64>) -> f64 {
        let step = self.force_drop_at_peak(unloading);
        largest.unwrap_or(unloading.peak.force + step) - UNREPORTED_STEP_SHARE * step
    }
}

impl Unloading {
    /// The branch in other units: lengths times `length`, forces times `force`.
    #[must_use]
    pub(crate) fn in_units(&self, length: f64, force: f64) -> Self {
        let ContactState { indentation, force: of_peak, elastic_approach } = self.peak;
        let peak = ContactState {
            indentation: indentation * length,
            force: of_peak * force,
            elastic_approach: elastic_approach * length,
        };
        let curve = self.curve.map(|UnloadingCurve { form, length: whole }| {
            let form = match form {
                UnloadingCurveKind::UniformPressure { force: largest } => {
                    UnloadingCurveKind::UniformPressure { force: largest * force }
                }
                UnloadingCurveKind::ShiftedHertz { stiffness, offset } => UnloadingCurveKind::ShiftedHertz {
                    stiffness: stiffness * (force / (length * length.sqrt())),
                    offset: offset * length,
                },
            };
            UnloadingCurve { form, length: whole * length }
        });
        Self { peak, exponent: self.exponent, curve }
    }
}
