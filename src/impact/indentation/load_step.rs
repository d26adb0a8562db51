//! A stroke of a testing machine, in or out: dimensionless, in closed form.

use crate::contact::law::{Branch, ContactState, Surface, Unloading};

/// One stroke of the machine: in or out, never both.
#[derive(Debug, Clone)]
pub(super) struct LoadStep<'a> {
    /// The law, and the dent before this stroke.
    pub ground: Surface<'a>,
    pub from: f64,
    pub to: f64,
    /// The branch from the largest state, the stroke included.
    pub branch: Unloading,
}

impl LoadStep<'_> {
    /// True if the stroke goes deeper than all before it.
    pub fn is_new_peak(&self) -> bool {
        self.ground.reloading_branch_at(self.to).is_none()
    }

    /// The state at x between the two ends, and its branch.
    pub fn state_at(&self, x: f64) -> (ContactState, Branch) {
        if let Some(unloading) = self.ground.reloading_branch_at(x) {
            let recovered = x - unloading.peak.residual();
            let branch = match (recovered < 0.0, self.to > self.from) {
                (true, _) => Branch::Separated,
                (false, true) => Branch::Reloading,
                (false, false) => Branch::Unloading,
            };
            let elastic_approach = recovered.max(0.0);
            return (
                ContactState {
                    indentation: x,
                    force: unloading.force_at_elastic_approach(recovered),
                    elastic_approach,
                },
                branch,
            );
        }
        let state = self.ground.law.loaded_state(x);
        (state, if state.elastic_approach < x { Branch::Plastic } else { Branch::Elastic })
    }

    /// `samples` ≥ 2 states, evenly spaced in x, both ends among them, and one at every change of branch.
    pub fn sampled_states(&self, samples: usize) -> impl Iterator<Item = (ContactState, Branch)> {
        let (low, high) = (self.from.min(self.to), self.from.max(self.to));
        let changes = self.ground.reloading_branch().map(|branch| [branch.peak.residual(), branch.peak.indentation]);
        #[allow(clippy::cast_precision_loss)] // at most 10^7 samples
        let share = |i: usize| i as f64 / (samples - 1) as f64;
        let even =
            (0..samples).map(|i| if i + 1 == samples { self.to } else { self.from + (self.to - self.from) * share(i) });
        let inner = changes.into_iter().flatten().filter(|x| low < *x && *x < high);
        let mut indentations: Vec<f64> = even.chain(inner).collect();
        indentations.sort_by(f64::total_cmp);
        if self.to < self.from {
            indentations.reverse();
        }
        indentations.dedup();
        indentations.into_iter().map(|x| self.state_at(x))
    }

    /// ∫ f dx over the stroke.
    pub fn work(&self) -> f64 {
        let work = |x: f64| self.ground.reloading_path.work(x.max(self.ground.first_contact()));
        work(self.to) - work(self.from)
    }

    /// The part of it that does not come back.
    pub fn plastic_work(&self) -> f64 {
        if self.is_new_peak() { self.ground.plastic_work(&self.branch) } else { 0.0 }
    }
}
