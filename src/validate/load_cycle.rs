//! A quasi-static load cycle by the law: to the same depth as the finite elements, or with the same work.

use crate::contact::law::{ContactState, Law};

pub(super) struct LoadCycle {
    pub(super) peak: ContactState,
    /// Restitution √(recovered/spent work).
    pub(super) restitution: f64,
    /// Contact radius at the peak, a_m/a_Y.
    pub(super) contact_radius: f64,
}

impl LoadCycle {
    /// The cycle to a depth, in units of first yield.
    pub(super) fn to_depth(law: &Law, depth: f64) -> Self {
        Self::with_peak(law, law.loaded_state(depth), law.loading.work(depth))
    }

    /// The cycle in which loading takes this work, in units of first yield.
    pub(super) fn with_work(law: &Law, spent: f64) -> Self {
        let piece = &law.loading.pieces()[law.loading.index_at_work(spent)];
        Self::with_peak(law, law.loaded_state(piece.indentation_at_work(spent)), spent)
    }

    fn with_peak(law: &Law, peak: ContactState, spent: f64) -> Self {
        let restitution = (law.unload(peak).recoverable_energy() / spent).sqrt();
        Self { peak, restitution, contact_radius: law.contact_radius(&peak) }
    }
}
