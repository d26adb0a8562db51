//! A contact in a testing machine: dimensionless, stroke after stroke, all in closed form.

use crate::contact::law::{Branch, ContactState, Dent, Ground, Law, Unloading};

/// A step that moves by less than this share of the indentation counts as no move: it is rounding.
const STILL: f64 = 1e-12;

/// A contact that is indented slowly: its law, its present indentation, and the dent that it remembers.
#[derive(Debug)]
pub(super) struct Machine<'a> {
    law: &'a Law,
    dent: Option<Dent>,
    indentation: f64,
}

impl<'a> Machine<'a> {
    /// At first touch on fresh surface.
    pub fn new(law: &'a Law) -> Self {
        Self { law, dent: None, indentation: 0.0 }
    }

    /// The x at which the force is `force` ≥ 0.
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        Ground::new(self.law, self.dent.as_ref()).indentation_at_force(force)
    }

    /// Goes to `indentation` ≥ 0; `None` if the contact is there already.
    pub fn go_to(&mut self, indentation: f64) -> Option<Stroke<'a>> {
        let from = std::mem::replace(&mut self.indentation, indentation);
        if (indentation - from).abs() <= STILL * from.max(indentation) {
            return None;
        }
        let (law, before) = (self.law, self.dent.clone());
        let known = before.as_ref().map(|dent| dent.unloading);
        let memory = known.filter(|branch| indentation <= branch.peak.indentation).unwrap_or_else(|| {
            let dent = law.dented(law.loaded_to(indentation));
            self.dent.insert(dent).unloading
        });
        Some(Stroke { law, before, from, to: indentation, memory })
    }
}

/// One stroke of the machine: in or out, never both.
#[derive(Debug, Clone)]
pub(super) struct Stroke<'a> {
    law: &'a Law,
    /// The memory of the contact before this step.
    before: Option<Dent>,
    from: f64,
    to: f64,
    /// The branch from the largest state, the step included.
    pub memory: Unloading,
}

impl Stroke<'_> {
    fn ground(&self) -> Ground<'_> {
        Ground::new(self.law, self.before.as_ref())
    }

    /// True if the step goes deeper than all before it.
    pub fn is_new_peak(&self) -> bool {
        self.ground().branch().is_none_or(|branch| self.to > branch.peak.indentation)
    }

    /// x_r before the step.
    pub fn dent(&self) -> f64 {
        self.ground().touch()
    }

    /// The state at x between the two ends, and its branch.
    fn point(&self, x: f64) -> (ContactState, Branch) {
        if let Some(unloading) = self.ground().branch_at(x) {
            let recovered = x - unloading.peak.residual();
            let branch = match (recovered < 0.0, self.to > self.from) {
                (true, _) => Branch::Separated,
                (false, true) => Branch::Reloading,
                (false, false) => Branch::Unloading,
            };
            let elastic_approach = recovered.max(0.0);
            return (ContactState { indentation: x, force: unloading.force_of(recovered), elastic_approach }, branch);
        }
        let state = self.law.loaded_to(x);
        (state, if state.elastic_approach < x { Branch::Plastic } else { Branch::Elastic })
    }

    pub fn end(&self) -> (ContactState, Branch) {
        self.point(self.to)
    }

    /// `samples` ≥ 2 states, evenly spaced in x, both ends among them, and one at every change of branch.
    pub fn points(&self, samples: usize) -> impl Iterator<Item = (ContactState, Branch)> {
        let (low, high) = (self.from.min(self.to), self.from.max(self.to));
        let changes = self.ground().branch().map(|branch| [branch.peak.residual(), branch.peak.indentation]);
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
        indentations.into_iter().map(|x| self.point(x))
    }

    /// ∫ f dx over the step.
    pub fn work(&self) -> f64 {
        let work = |x: f64| self.ground().way_in.work(x.max(self.dent()));
        work(self.to) - work(self.from)
    }

    /// The part of it that does not come back.
    pub fn plastic_work(&self) -> f64 {
        if self.is_new_peak() { self.ground().plastic(&self.memory) } else { 0.0 }
    }
}
