//! The law of a spot that was loaded before: back up the old unloading branch, then on along the old loading curve.
//!
//! ```text
//! f = the branch, f_m ((x − x_r)/ε_m)^n x_r ≤ x ≤ x_m     (a turn here leaves the memory as it is)
//! f, ε as on fresh surface              x > x_m           (a turn here is the new memory)
//! ```
//!
//! x is measured from the surface as it was before the first impact, so first touch is at x_r. On the branch the work is
//! counted from x_r. A reload turns at the old peak if its kinetic energy is just the energy stored there, f_m ε_m/(n + 1).
//! A faster one goes on along the loading curve, and the energy in excess is the further work of loading:
//!
//! ```text
//! w(x_m2) = w(x_m) + (kinetic − f_m ε_m/(n + 1))
//! ```

use super::curve::Curve;
use super::piece::Piece;
use super::unloading::GRAZING;
use super::{ElasticApproach, Law, Peak, Reloaded, Unloading};

impl Curve {
    /// The curve of a spot that was loaded along this one, fresh, to the peak of `branch`: first that branch, then what is
    /// left of this curve. Its work counts from the zero of the branch.
    #[must_use]
    pub fn reloaded(&self, branch: &Unloading) -> Self {
        let peak = branch.peak;
        let stored = branch.capacity();
        let index = self.index_at(peak.indentation);
        let cut = &self.pieces[index];
        let shape = cut.shape.later(peak.indentation - cut.start);
        let spent = cut.work_at(peak.indentation);
        let first = Piece { start: peak.indentation, force: peak.force, work: stored, shape };
        let rest = self.pieces[index + 1..].iter().map(|piece| Piece { work: stored + (piece.work - spent), ..*piece });
        Self::of([branch.branch(), first].into_iter().chain(rest).collect())
    }
}

impl Reloaded {
    fn is_on_branch(&self, x: f64) -> bool {
        x <= self.branch.peak.indentation
    }

    /// ε at (x, f).
    #[cold]
    pub(super) fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        if self.is_on_branch(x) { x - self.branch.peak.residual() } else { self.fresh.elastic_approach(x, force) }
    }

    /// The unloading branch from a peak.
    #[cold]
    pub(super) fn unloading(&self, peak: Peak) -> Unloading {
        if self.is_on_branch(peak.indentation) { self.branch.below(peak) } else { self.fresh.unloading(peak) }
    }

    /// a/a_Y at a peak.
    pub(super) fn contact_radius(&self, peak: &Peak) -> f64 {
        if self.is_on_branch(peak.indentation) {
            let deepest = &self.branch.peak;
            // exactly 1 at the old peak
            let share = (peak.force / peak.elastic_approach) / (deepest.force / deepest.elastic_approach);
            self.radius * share
        } else {
            self.fresh.contact_radius(peak)
        }
    }

    /// Whether a reload with this energy turns on the branch.
    #[inline]
    fn holds(&self, kinetic: f64) -> bool {
        kinetic <= self.branch.capacity() * (1.0 + GRAZING)
    }

    /// The state at a distance from x_r. The distance has digits that x has lost.
    #[cold]
    fn state_at(&self, distance: f64) -> Peak {
        let peak = self.branch.peak;
        if distance >= peak.elastic_approach {
            return peak;
        }
        let indentation = (peak.residual() + distance).min(peak.indentation);
        Peak { indentation, force: self.branch.force_of(distance), elastic_approach: distance }
    }
}

impl Law {
    /// The law of a spot whose largest state so far is `memory`, a peak of this law. The deeper of two memories stays.
    #[must_use]
    pub fn reloaded(&self, memory: Peak) -> Self {
        if self.branch_at(memory.indentation).is_some() {
            return self.clone();
        }
        let fresh = self.fresh().clone();
        let branch = fresh.unloading(memory);
        let radius = fresh.contact_radius(&memory);
        Self {
            loading: fresh.loading.reloaded(&branch),
            radius: fresh.radius.clone(),
            exponent: fresh.exponent,
            elastic: ElasticApproach::Reloaded(Box::new(Reloaded { branch, radius, fresh })),
        }
    }

    /// The law of the surface before any impact.
    #[inline]
    pub(super) fn fresh(&self) -> &Self {
        self.memory_of().map_or(self, |reloaded| &reloaded.fresh)
    }

    fn memory_of(&self) -> Option<&Reloaded> {
        match &self.elastic {
            ElasticApproach::Reloaded(reloaded) => Some(reloaded),
            _ => None,
        }
    }

    /// The unloading branch that a reload runs back up; `None` on fresh surface.
    pub fn branch(&self) -> Option<&Unloading> {
        self.memory_of().map(|reloaded| &reloaded.branch)
    }

    /// The branch, if a state at x lies on it.
    pub(crate) fn branch_at(&self, x: f64) -> Option<&Unloading> {
        self.branch().filter(|branch| x <= branch.peak.indentation)
    }

    /// x of first touch: x_r of the branch, 0 on fresh surface.
    pub fn touch(&self) -> f64 {
        self.branch().map_or(0.0, |branch| branch.peak.residual())
    }

    /// The peak that shaped the dent of an impact that turned at `peak`: the memory, if it turned on the branch.
    #[inline(always)]
    pub fn dent<'a>(&'a self, peak: &'a Peak) -> &'a Peak {
        self.branch_at(peak.indentation).map_or(peak, |branch| &branch.peak)
    }

    /// Whether an impact with this kinetic energy and this weight (in units of Φ L and Φ) turns on the branch.
    #[inline]
    pub(crate) fn stays_on_branch(&self, kinetic: f64, weight: f64) -> bool {
        self.memory_of()
            .is_some_and(|reloaded| reloaded.holds(kinetic + weight * reloaded.branch.peak.elastic_approach))
    }

    /// Index of the piece that an impact with this kinetic energy (in units of Φ L) turns on.
    #[inline(always)]
    pub(crate) fn turning_piece(&self, kinetic: f64) -> usize {
        match &self.elastic {
            ElasticApproach::Reloaded(reloaded) if reloaded.holds(kinetic) => 0,
            _ => self.loading.index_at_work(kinetic),
        }
    }

    /// Whether an impact that turns at x leaves the contact as it was: at most first yield, or on the branch.
    #[inline(always)]
    pub(crate) fn is_elastic_to(&self, x: f64) -> bool {
        x <= self.elastic_until()
    }

    /// The state at a distance from the start of a piece.
    #[inline(always)]
    pub(crate) fn state_at(&self, index: usize, distance: f64) -> Peak {
        match &self.elastic {
            ElasticApproach::Reloaded(reloaded) if index == 0 => reloaded.state_at(distance),
            _ => {
                let piece = &self.loading.pieces()[index];
                let indentation = piece.start + distance;
                let force = piece.force_at(indentation);
                Peak { indentation, force, elastic_approach: self.elastic_approach(indentation, force) }
            }
        }
    }

    /// Work from first touch to a state of the loading curve; on the branch it follows from ε, which has more digits than x.
    pub(crate) fn work_to(&self, state: &Peak) -> f64 {
        match self.branch_at(state.indentation) {
            Some(branch) => branch.stored_of(state.elastic_approach),
            None => self.loading.work(state.indentation),
        }
    }

    /// [`Law::spent`] for a report: 0 where it is rounding.
    pub fn plastic(&self, unloading: &Unloading) -> f64 {
        let spent = self.spent(unloading);
        if spent.abs() <= GRAZING * unloading.capacity() { 0.0 } else { spent }
    }

    /// Work that an impact spent on the dent: w(x_m) − f_m ε_m/(n + 1), and nothing on the branch.
    pub fn spent(&self, unloading: &Unloading) -> f64 {
        let peak = &unloading.peak;
        match self.branch_at(peak.indentation) {
            Some(_) => 0.0,
            None => self.loading.work(peak.indentation) - unloading.stored(peak.indentation),
        }
    }
}
