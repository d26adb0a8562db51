//! What a spot remembers that was loaded before, and the curve along which it is loaded again.

use super::unloading::{Peak, Unloading};
use crate::curve::Curve;
use crate::curve::piece::Piece;

/// What a spot remembers that was loaded before.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reloaded {
    /// The unloading branch from the largest state so far.
    pub(super) branch: Unloading,
    /// a/a_L there.
    pub(super) radius: f64,
    /// Work of all loading so far that did not come back.
    pub(super) lost: f64,
}

impl Reloaded {
    /// Whether a state at x lies on the branch.
    #[inline]
    pub(super) fn holds_at(&self, x: f64) -> bool {
        x <= self.branch.peak.indentation
    }

    /// The state at a distance from x_r. The distance has digits that x has lost.
    #[cold]
    pub(super) fn state_at(&self, distance: f64) -> Peak {
        let peak = self.branch.peak;
        if distance >= peak.elastic_approach {
            return peak;
        }
        let indentation = (peak.residual() + distance).min(peak.indentation);
        Peak { indentation, force: self.branch.force_of(distance), elastic_approach: distance }
    }
}

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
        let first = Piece { start: peak.indentation, force: peak.force, work: stored, is_joint: false, shape };
        let rest =
            self.pieces[index + 1..].iter().map(|piece| Piece { work: stored + (piece.work - spent), ..piece.clone() });
        Self::of([branch.branch(), first].into_iter().chain(rest).collect())
    }
}
