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

use super::unloading::{ContactState, LoadedPoint, Unloading, allowed_exponent};
use super::{Law, LawError, PeakLaw, UnloadingRule};

impl PeakLaw {
    /// r², r³.
    fn units(&self) -> [f64; 2] {
        let square = self.ratio * self.ratio;
        [square, square * self.ratio]
    }

    /// Fresh surface that turns at this x or before stays elastic.
    pub(super) fn elastic_until(&self) -> f64 {
        let [length, _] = self.units();
        self.law.validity.elastic_until * length
    }

    /// The unloading branch of a surface that was loaded to x with this force and the loading work `spent`.
    pub(super) fn unload(&self, x: f64, force: f64, spent: f64) -> Unloading {
        let [per_length, per_force] = self.units();
        let (own, most, spent) = (x / per_length, force / per_force, spent / (per_length * per_force));
        let own_force = self.law.loading.force(own);
        let branch = |work| {
            let at = LoadedPoint { indentation: own, force: own_force, work: Some(work), elastic_approach: None };
            self.law.unload(at)
        };
        let unloading = if own_force <= most {
            branch(spent)
        } else {
            // shape and approach follow the law at the turn; f x is more than any branch recovers
            let lowered = branch(own_force * own).in_units(1.0, most / own_force);
            Unloading { exponent: allowed_exponent(spent, &lowered.peak, lowered.exponent), ..lowered }
        };
        let scaled = unloading.in_units(per_length, per_force);
        // the depth is the depth of the impact, to the last bit, and at most the depth is recovered
        let elastic_approach = scaled.peak.elastic_approach.min(x);
        Unloading { peak: ContactState { indentation: x, elastic_approach, ..scaled.peak }, ..scaled }
    }

    /// See [`Law::check`].
    pub(super) fn check(&self, unloading: &Unloading) -> Result<(), LawError> {
        let [length, force] = self.units();
        self.law.check(&unloading.in_units(1.0 / length, 1.0 / force))
    }

    /// Contact radius a/a_L of a turn at x.
    pub(super) fn contact_radius(&self, x: f64) -> f64 {
        let [length, _] = self.units();
        self.law.contact_radius(&self.law.loaded_state(x / length)) * self.ratio
    }
}

impl Law {
    /// Returns this law with another law at maximum compression, whose strength is larger by `ratio`, in the units of that law.
    #[must_use]
    pub(crate) fn with_peak_law(self, law: Self, ratio: f64) -> Self {
        let peak_law = PeakLaw { while_loading: self.unloading_rule, law, ratio };
        Self { unloading_rule: UnloadingRule::Relaxed(Box::new(peak_law)), ..self }
    }
}
