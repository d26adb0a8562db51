//! The dent of a spot that was loaded before: the path that reloading follows, from the unloading branch on ([`surface`](super::surface)).

use std::sync::Arc;

use super::{ContactState, Law, Unloading};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::curve::piece::Piece;
use crate::numerics::root::bisect;

/// The dent of a spot that was loaded before.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadingHistory {
    /// The unloading branch from the largest state so far.
    pub unloading: Unloading,
    pub(super) reloading_path: Arc<LoadingCurve>,
    /// True if the branch was made at another rate of strain than that of the law.
    pub(super) is_of_other_rate: bool,
}

impl Law {
    /// The dent of a spot that was loaded to this peak.
    pub fn history_after(&self, peak: ContactState) -> LoadingHistory {
        self.history_after_unloading(self.unload(peak))
    }

    /// The dent of a spot with this unloading branch, which ends on the loading curve.
    pub(crate) fn history_after_unloading(&self, unloading: Unloading) -> LoadingHistory {
        self.dented_with(unloading, unloading.peak.force, false)
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

    /// Like [`Law::history_after_unloading`], but the loading curve behind the branch begins with this force.
    fn dented_with(&self, unloading: Unloading, force: f64, is_of_other_rate: bool) -> LoadingHistory {
        let start = unloading.peak.indentation;
        let index = self.loading.index_at(start);
        let (cut, behind) = (&self.loading.pieces()[index], &self.loading.pieces()[index + 1..]);
        let (stored, spent) = (unloading.recoverable_energy(), cut.work_at(start));
        let first =
            Piece { start, force, work: stored, is_subdivision: false, shape: cut.shape.with_shift(start - cut.start) };
        let behind = behind.iter().map(|piece| Piece { work: stored + (piece.work - spent), ..piece.clone() });
        let pieces = [unloading.to_piece(), first].into_iter().chain(behind).collect();
        LoadingHistory { unloading, reloading_path: Arc::new(LoadingCurve::new(pieces)), is_of_other_rate }
    }
}
