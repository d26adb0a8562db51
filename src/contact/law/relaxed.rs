//! A metal that relaxes where the sphere turns: its strength is then that of a slower rate of strain than on the way in.
//!
//! ```text
//! loading   f_g(x), a law of the strength g σ, in units of its yield point
//! turn      f_t, ε_t, n of the law of the strength g_t σ at the same δ, with r = g_t/g ≤ 1
//!           x = r² x_t,  f = r³ f_t,  ε = r² ε_t
//! ```
//!
//! At the turn the force falls from f_g to f_t, and the dent takes the energy. Fresh surface that turns at x_t ≤ 1 stays
//! elastic.

use super::unloading::{ContactState, Unloading};
use super::{Ground, Law, LoadingRule, Relaxed};
use crate::numerics::curve::branch::{Branch, Form};
use crate::numerics::root::halved;

/// The largest force is reported lower than the force at the end of loading, by this share of the step.
const UNREPORTED: f64 = 0.8;

impl Relaxed {
    /// r², r³.
    fn units(&self) -> [f64; 2] {
        let square = self.ratio * self.ratio;
        [square, square * self.ratio]
    }

    fn until(&self) -> f64 {
        let [length, _] = self.units();
        self.law.limits.elastic_until * length
    }

    /// The unloading branch of a surface that was loaded to x.
    fn left_at(&self, x: f64) -> Unloading {
        let [length, force] = self.units();
        let unloading = self.law.unloading(self.law.loaded_to(x / length));
        let scaled = unloading.scaled(length, force);
        // the depth is that of the impact, to the last bit, and no more than that comes back
        let elastic_approach = scaled.peak.elastic_approach.min(x);
        Unloading { peak: ContactState { indentation: x, elastic_approach, ..scaled.peak }, ..scaled }
    }

    /// A branch in units of this law.
    fn own(&self, unloading: &Unloading) -> Unloading {
        let [length, force] = self.units();
        unloading.scaled(1.0 / length, 1.0 / force)
    }
}

impl Law {
    /// Returns this law with another one for the turn: of a strength that is `ratio` times as large, in its own units.
    #[must_use]
    pub(crate) fn relaxing_to(self, law: Law, ratio: f64) -> Self {
        Self { relaxed: Some(Box::new(Relaxed { law, ratio })), ..self }
    }

    /// True if the loading is the same in units of any strength: the PLM of bodies whose strength is constant, with a dent alone.
    pub(crate) fn has_one_curve(&self) -> bool {
        matches!(&self.rule, LoadingRule::Polyline(rule) if rule.hardening.is_none() && rule.flattening.is_none())
    }

    /// x up to which fresh surface gives back all.
    #[inline(always)]
    pub(crate) fn recovers_until(&self) -> f64 {
        self.relaxed.as_ref().map_or(self.limits.elastic_until, |relaxed| relaxed.until())
    }

    /// How fresh surface unloads from x, if the metal relaxes there.
    #[inline(always)]
    pub(super) fn relaxed_at(&self, x: f64) -> Option<Unloading> {
        let relaxed = self.relaxed.as_ref()?;
        (x > relaxed.until() * (1.0 + f64::EPSILON)).then(|| relaxed.left_at(x))
    }

    /// The law at the turn, with the branch in the units of that law; `None` if the metal does not relax.
    #[inline(always)]
    pub(super) fn at_turn(&self, unloading: &Unloading) -> Option<(&Law, Unloading)> {
        self.relaxed.as_ref().map(|relaxed| (&relaxed.law, relaxed.own(unloading)))
    }

    /// Contact radius of a turn, if the metal relaxes there.
    #[inline(always)]
    pub(super) fn relaxed_radius(&self, peak: &ContactState) -> Option<f64> {
        let relaxed = self.relaxed.as_ref()?;
        let own = relaxed.own(&Unloading::power(*peak, 1.5)).peak;
        (peak.indentation > relaxed.until()).then(|| relaxed.law.contact_radius(&own) * relaxed.ratio)
    }

    /// How far the force falls where a loading turns at this branch.
    pub(crate) fn step(&self, unloading: &Unloading) -> f64 {
        let ContactState { indentation, force, .. } = unloading.peak;
        match self.relaxed {
            Some(_) if indentation > self.recovers_until() => (self.loading.force(indentation) - force).max(0.0),
            _ => 0.0,
        }
    }

    /// The branch up to the place where it meets this loading curve. It may become longer or shorter by that.
    pub(crate) fn met_by(&self, branch: &Unloading) -> Unloading {
        let (piece, residual) = (branch.branch(), branch.peak.residual());
        let over = |recovered: f64| piece.force_beyond(recovered) - self.loading.force(residual + recovered);
        // a branch is steeper than any loading curve
        let mut end = branch.peak.elastic_approach;
        while over(end) < 0.0 && end.is_finite() {
            end *= 2.0;
        }
        let (below, _) = halved(0.0, end, |recovered| over(recovered) < 0.0);
        branch.up_to(ContactState {
            indentation: residual + below,
            force: piece.force_beyond(below),
            elastic_approach: below,
        })
    }
}

impl Ground<'_> {
    /// How far the force falls where an impact turns that leaves along this branch; nothing in a dent.
    pub(crate) fn step(&self, unloading: &Unloading) -> f64 {
        self.law_at(unloading.peak.indentation).map_or(0.0, |law| law.step(unloading))
    }

    /// The largest force as it is reported: above the relaxed one by a fifth of the step, as in the finite elements. With damping
    /// `largest` is the largest on the way in.
    pub(crate) fn reported_force(&self, unloading: &Unloading, largest: Option<f64>) -> f64 {
        let step = self.step(unloading);
        largest.unwrap_or(unloading.peak.force + step) - UNREPORTED * step
    }
}

impl Unloading {
    /// The branch in other units: lengths times `length`, forces times `force`.
    #[must_use]
    pub(crate) fn scaled(&self, length: f64, force: f64) -> Self {
        let ContactState { indentation, force: of_peak, elastic_approach } = self.peak;
        let peak = ContactState {
            indentation: indentation * length,
            force: of_peak * force,
            elastic_approach: elastic_approach * length,
        };
        let curve = self.curve.map(|Branch { form, length: whole }| {
            let form = match form {
                Form::UniformPressure { force: largest } => Form::UniformPressure { force: largest * force },
                Form::ShiftedHertz { stiffness, offset } => Form::ShiftedHertz {
                    stiffness: stiffness * (force / (length * length.sqrt())),
                    offset: offset * length,
                },
            };
            Branch { form, length: whole * length }
        });
        Self { peak, exponent: self.exponent, curve }
    }
}
