//! The surface that a sphere meets: a law, and the dent if the spot was loaded before. A sphere that returns to the dent follows
//! the old unloading branch, and then the loading curve of the law.
//!
//! ```text
//! f = the branch, f_m ((x − x_r)/ε_m)^n x_r ≤ x ≤ x_m     (a turn here leaves the dent as it is)
//! f, ε as on fresh surface              x > x_m           (a turn here makes a new dent)
//! ```
//!
//! x is measured from the surface as it was before the first impact, so first contact is at x_r. Work is counted from there.
//! Reloading ends at the old peak if the kinetic energy is just the energy stored there, f_m ε_m/(n + 1). A faster sphere
//! continues along the loading curve, and its further energy is the further work of loading:
//!
//! ```text
//! w(x_m2) = w(x_m) + (kinetic − f_m ε_m/(n + 1))
//! ```
//!
//! So a sphere follows a reloading path. On fresh surface this is the loading curve of the law. In a dent it has three parts: the
//! unloading branch, the rest of the piece that holds the old peak, and the pieces behind that piece.

use super::loading_history::LoadingHistory;
use super::unloading::OLD_PEAK_ROUNDING;
use super::{ContactState, Law, LawError, LoadedPoint, Unloading};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::curve::piece::Piece;
use crate::numerics::power::nan_max;

/// The reported peak force is lower than the force at the end of loading by this fraction of the drop.
const UNREPORTED_STEP_SHARE: f64 = 0.8;

/// A law, and the dent if it was loaded before.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    pub law: &'a Law,
    /// The force over x during loading or reloading, with the work from first contact.
    pub reloading_path: &'a LoadingCurve,
    reloading_branch: Option<&'a Unloading>,
    is_of_other_rate: bool,
}

impl<'a> From<&'a Law> for Surface<'a> {
    /// Fresh surface.
    #[inline]
    fn from(law: &'a Law) -> Self {
        Self::new(law, None)
    }
}

impl<'a> Surface<'a> {
    #[inline]
    pub fn new(law: &'a Law, dent: Option<&'a LoadingHistory>) -> Self {
        let reloading_path = dent.map_or(&*law.loading, |dent| &dent.reloading_path);
        let is_of_other_rate = dent.is_some_and(|dent| dent.is_of_other_rate);
        Self { law, reloading_path, reloading_branch: dent.map(|dent| &dent.unloading), is_of_other_rate }
    }

    /// The surface that a sphere of this kinetic energy and weight hits (in units of Φ L and Φ). On fresh surface its path need not
    /// go deeper than the sphere.
    #[inline]
    pub(crate) fn hit_with(law: &'a Law, dent: Option<&'a LoadingHistory>, kinetic: f64, weight: f64) -> Self {
        let Some(dent) = dent else {
            let reloading_path = law.loading.reached_by(kinetic, weight);
            return Self { law, reloading_path, reloading_branch: None, is_of_other_rate: false };
        };
        Self::new(law, Some(dent))
    }

    /// Fresh surface whose path has no correction for deep dents.
    pub(crate) fn of_shallow_dents(law: &'a Law) -> Self {
        Self { reloading_path: law.loading.shallow(), ..Self::hit_with(law, None, 0.0, 0.0) }
    }

    /// The unloading branch that reloading follows; `None` on fresh surface.
    #[inline]
    pub fn reloading_branch(&self) -> Option<&'a Unloading> {
        self.reloading_branch
    }

    /// The branch, if the state at x lies on the branch.
    #[inline]
    pub(crate) fn reloading_branch_at(&self, x: f64) -> Option<&'a Unloading> {
        self.reloading_branch.filter(|branch| x <= branch.peak.indentation)
    }

    /// The law, if a state at x lies on its loading curve, and not on the branch of a dent.
    #[inline]
    pub(crate) fn loading_law_at(&self, x: f64) -> Option<&'a Law> {
        self.reloading_branch_at(x).is_none().then_some(self.law)
    }

    /// Loading is elastic up to this x: the whole approach is recovered along the loading curve.
    #[inline(always)]
    pub fn elastic_until(&self) -> f64 {
        self.reloading_branch().map_or(self.law.validity.elastic_until, |branch| branch.peak.indentation)
    }

    /// True if an impact that turns at x does not change the surface: it turns at first yield at most, or on the branch.
    #[inline(always)]
    pub(crate) fn is_elastic_at(&self, x: f64) -> bool {
        self.reloading_branch().map_or_else(|| !self.law.leaves_dent(x), |branch| x <= branch.peak.indentation)
    }

    /// True if an impact that turns at this peak leaves a dent, or a deeper dent. A peak without a residual indentation leaves no dent.
    pub(crate) fn keeps_mark_of(&self, peak: &ContactState) -> bool {
        !self.is_elastic_at(peak.indentation) && peak.residual() > 0.0
    }

    /// The drop of the loading force at the start of a piece. It is not zero only where a branch of another strain rate ends.
    pub(crate) fn fall_at_start(&self, index: usize) -> f64 {
        match self.reloading_branch {
            Some(branch) if index == 1 && self.is_of_other_rate => branch.peak.force - self.piece(index).force,
            _ => 0.0,
        }
    }

    /// x of first contact: x_r of the branch, 0 on fresh surface.
    pub fn first_contact(&self) -> f64 {
        self.reloading_branch().map_or(0.0, |branch| branch.peak.residual())
    }

    /// The peak that shaped the dent after an impact with the peak `peak`: the old peak if the impact turned on the branch.
    #[inline(always)]
    pub fn deepest_state(&self, peak: &ContactState) -> ContactState {
        self.reloading_branch_at(peak.indentation).map_or(*peak, |branch| branch.peak)
    }

    /// A piece of the reloading path.
    #[inline(always)]
    pub fn piece(&self, index: usize) -> &'a Piece {
        &self.reloading_path.pieces()[index]
    }

    /// True if an impact with this kinetic energy and this weight (in units of Φ L and Φ) turns on the branch.
    #[inline]
    pub(crate) fn turns_on_branch(&self, kinetic: f64, weight: f64) -> bool {
        self.reloading_branch().is_some_and(|branch| {
            kinetic + weight * branch.peak.elastic_approach <= branch.recoverable_energy() * (1.0 + OLD_PEAK_ROUNDING)
        })
    }

    /// The piece on which an impact with this kinetic energy and this weight turns, and the distance from the start of the piece. The
    /// work minus the work of the weight is convex, and does not exceed the energy before the peak.
    #[inline(always)]
    pub(crate) fn turning_point(&self, kinetic: f64, weight: f64) -> (usize, f64) {
        let remaining = |index: usize| {
            let sunk = if weight == 0.0 { 0.0 } else { weight * (self.piece(index).start - self.first_contact()) };
            kinetic + sunk - self.piece(index).work
        };
        let last = match weight {
            _ if self.turns_on_branch(kinetic, weight) => 0,
            0.0 => self.reloading_path.index_at_work(kinetic),
            _ => {
                (1..self.reloading_path.pieces().len()).take_while(|index| remaining(*index) >= 0.0).last().unwrap_or(0)
            }
        };
        (last, self.piece(last).turning_distance(nan_max(remaining(last), 0.0), weight))
    }

    /// The x at which the force during loading is `force` ≥ 0.
    pub(crate) fn indentation_at_force(&self, force: f64) -> f64 {
        match self.reloading_branch() {
            Some(branch) if force <= branch.peak.force => {
                branch.peak.residual() + branch.elastic_approach_at_force(force)
            }
            _ => self.law.loading.indentation_at_force(force),
        }
    }

    /// The state at a distance from the start of a piece.
    #[inline(always)]
    pub(crate) fn state_at(&self, index: usize, distance: f64) -> ContactState {
        match self.reloading_branch() {
            Some(branch) if index == 0 => branch.state_at(distance),
            _ => {
                let piece = self.piece(index);
                let indentation = piece.start + distance;
                let force = piece.force_at(indentation);
                ContactState { indentation, force, elastic_approach: self.law.elastic_approach(indentation, force) }
            }
        }
    }

    /// The state at x during loading, from which unloading may begin.
    pub fn loaded_state(&self, x: f64) -> ContactState {
        match self.reloading_branch_at(x) {
            Some(branch) => branch.state_at(x - branch.peak.residual()),
            None => self.law.loaded_state(x),
        }
    }

    /// The unloading branch from a turning point at a distance from the start of a piece. On the branch of a dent it is this branch.
    /// `work` is the work of loading of fresh surface, if it is known.
    #[inline(always)]
    pub(crate) fn unload(&self, index: usize, distance: f64, work: Option<f64>) -> Unloading {
        let piece = self.piece(index);
        let x = piece.start + distance;
        match self.reloading_branch {
            Some(branch) if index == 0 => branch.with_peak(branch.state_at(distance)),
            Some(branch) if x <= branch.peak.indentation => *branch,
            dent => {
                let work = work.filter(|_| dent.is_none());
                let at = LoadedPoint { indentation: x, force: piece.force_at(x), work, elastic_approach: None };
                let unloading = self.law.unload(at);
                if self.is_of_other_rate {
                    unloading.in_dent(self.first_contact(), self.reloading_path.work(x))
                } else {
                    unloading
                }
            }
        }
    }

    /// The piece at a distance from first contact, and the distance from the start of this piece.
    pub(crate) fn place_at(&self, distance: f64) -> (usize, f64) {
        match self.reloading_branch {
            Some(branch) if distance <= branch.peak.elastic_approach => (0, distance),
            _ => {
                let x = self.first_contact() + distance;
                let index = self.reloading_path.index_at(x);
                (index, x - self.piece(index).start)
            }
        }
    }

    /// The unloading branch from a distance from first contact.
    pub fn unload_at(&self, distance: f64) -> Unloading {
        let (index, distance) = self.place_at(distance);
        self.unload(index, distance, None)
    }

    /// Contact radius a/a_L at a peak, see [`Law::contact_radius`]. On the branch of a dent, which keeps its shape, the radius is
    /// proportional to f/ε.
    pub fn contact_radius(&self, peak: &ContactState) -> f64 {
        let Some(branch) = self.reloading_branch_at(peak.indentation) else { return self.law.contact_radius(peak) };
        let deepest = &branch.peak;
        // exactly 1 at the old peak
        let share = (peak.force / peak.elastic_approach) / (deepest.force / deepest.elastic_approach);
        self.law.contact_radius(deepest) * share
    }

    /// Checks that the law has an answer for the peak of this branch. In a dent that the law made it always has one.
    ///
    /// # Errors
    /// See [`Law::check`].
    #[inline]
    pub fn check(&self, unloading: &Unloading) -> Result<(), LawError> {
        let Some(law) = self.loading_law_at(unloading.peak.indentation) else { return Ok(()) };
        // the law is checked for the branch on fresh surface, not for the branch of the dent
        if self.is_of_other_rate {
            return law.check(&law.unload(law.loaded_state(unloading.peak.indentation)));
        }
        law.check(unloading)
    }

    /// Work from first contact to a state of loading. On the branch it follows from ε, which has more digits than x.
    pub(crate) fn loading_work(&self, state: &ContactState) -> f64 {
        match self.reloading_branch_at(state.indentation) {
            Some(branch) => branch.stored_energy_at(state.elastic_approach),
            None => self.reloading_path.work(state.indentation),
        }
    }

    /// Plastic work of an impact: w(x_m) − f_m ε_m/(n + 1); 0 on the branch, and 0 if it is rounding.
    pub fn plastic_work(&self, unloading: &Unloading) -> f64 {
        let spent = self.plastic_work_unrounded(unloading);
        if spent.abs() <= OLD_PEAK_ROUNDING * unloading.recoverable_energy() { 0.0 } else { spent }
    }

    /// Returns [`Surface::plastic_work`] without setting rounding to 0.
    pub fn plastic_work_unrounded(&self, unloading: &Unloading) -> f64 {
        let x = unloading.peak.indentation;
        if self.reloading_branch_at(x).is_some() {
            0.0
        } else {
            self.reloading_path.work(x) - unloading.recoverable_energy()
        }
    }

    /// The drop of the force where an impact turns into this branch; only a metal that relaxes has one, and not in a dent.
    pub(crate) fn force_drop_at_peak(&self, unloading: &Unloading) -> f64 {
        let ContactState { indentation, force, .. } = unloading.peak;
        let relaxes = |law: &&Law| law.relaxes() && law.leaves_dent(indentation);
        let fall =
            self.loading_law_at(indentation).filter(relaxes).map_or(0.0, |law| law.loading.force(indentation) - force);
        // a smaller drop is rounding
        if fall > OLD_PEAK_ROUNDING * force { fall } else { 0.0 }
    }

    /// The reported peak force: the relaxed force and a fifth of the drop, as in the finite elements. With damping
    /// `largest` is the largest force of loading.
    pub(crate) fn reported_force(&self, unloading: &Unloading, largest: Option<f64>) -> f64 {
        let step = self.force_drop_at_peak(unloading);
        largest.unwrap_or(unloading.peak.force + step) - UNREPORTED_STEP_SHARE * step
    }
}
