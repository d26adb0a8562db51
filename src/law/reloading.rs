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

use super::memory::Reloaded;
use super::unloading::GRAZING;
use super::{Law, Peak, Unloading};

impl Law {
    /// The law of a spot whose largest state so far is `memory`, a peak of this law. The deeper of two memories stays.
    #[must_use]
    pub fn reloaded(&self, memory: Peak) -> Self {
        if self.branch_at(memory.indentation).is_some() {
            return self.clone();
        }
        let branch = self.unloading(memory);
        let lost = self.work_since_fresh(memory.indentation) - branch.capacity();
        let memory = Reloaded { branch, radius: self.contact_radius(&memory), lost };
        Self { loading: self.loading.reloaded(&branch), memory: Some(Box::new(memory)), ..self.clone() }
    }

    /// Work of all loading to x beyond the branch, since the surface was fresh.
    pub(super) fn work_since_fresh(&self, x: f64) -> f64 {
        self.loading.work(x) + self.memory.as_ref().map_or(0.0, |memory| memory.lost)
    }

    /// The unloading branch that a reload runs back up; `None` on fresh surface.
    #[inline]
    pub fn branch(&self) -> Option<&Unloading> {
        self.memory.as_ref().map(|memory| &memory.branch)
    }

    /// The branch, if a state at x lies on it.
    #[inline]
    pub(crate) fn branch_at(&self, x: f64) -> Option<&Unloading> {
        self.memory.as_ref().filter(|memory| memory.holds_at(x)).map(|memory| &memory.branch)
    }

    /// x up to which loading is elastic: all of the approach is recovered, on the loading curve itself.
    #[inline(always)]
    pub fn elastic_until(&self) -> f64 {
        self.branch().map_or(self.limits.elastic_until, |branch| branch.peak.indentation)
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
        self.branch().is_some_and(|branch| {
            kinetic + weight * branch.peak.elastic_approach <= branch.capacity() * (1.0 + GRAZING)
        })
    }

    /// Index of the piece that an impact with this kinetic energy (in units of Φ L) turns on.
    #[inline(always)]
    pub(crate) fn turning_piece(&self, kinetic: f64) -> usize {
        if self.stays_on_branch(kinetic, 0.0) { 0 } else { self.loading.index_at_work(kinetic) }
    }

    /// Whether an impact that turns at x leaves the contact as it was: at most first yield, or on the branch.
    #[inline(always)]
    pub(crate) fn is_elastic_to(&self, x: f64) -> bool {
        x <= self.elastic_until()
    }

    /// The state at a distance from the start of a piece.
    #[inline(always)]
    pub(crate) fn state_at(&self, index: usize, distance: f64) -> Peak {
        if let Some(memory) = self.memory.as_ref().filter(|_| index == 0) {
            return memory.state_at(distance);
        }
        let piece = &self.loading.pieces()[index];
        let indentation = piece.start + distance;
        let force = piece.force_at(indentation);
        Peak { indentation, force, elastic_approach: self.elastic_approach(indentation, force) }
    }

    /// Work from first touch to a state of the loading curve; on the branch it follows from ε, which has more digits than x.
    pub(crate) fn work_to(&self, state: &Peak) -> f64 {
        match self.branch_at(state.indentation) {
            Some(branch) => branch.stored_of(state.elastic_approach),
            None => self.loading.work(state.indentation),
        }
    }

    /// Work that an impact spent on the dent: w(x_m) − f_m ε_m/(n + 1), nothing on the branch, and 0 where it is rounding.
    pub fn plastic(&self, unloading: &Unloading) -> f64 {
        let spent = self.spent(unloading);
        if spent.abs() <= GRAZING * unloading.capacity() { 0.0 } else { spent }
    }

    pub fn spent(&self, unloading: &Unloading) -> f64 {
        let x = unloading.peak.indentation;
        if self.branch_at(x).is_some() { 0.0 } else { self.loading.work(x) - unloading.stored(x) }
    }
}
