//! A contact in a testing machine: dimensionless, stroke after stroke, all in closed form.

use crate::law::unloading::GRAZING;
use crate::law::{Branch, Law, Peak, Unloading};

/// A step that moves by less than this share of the indentation counts as no move: it is rounding.
const STILL: f64 = 1e-12;

/// A contact that is indented slowly: where it is, and what it remembers.
#[derive(Debug, Clone)]
pub(super) struct Machine<'a> {
    law: &'a Law,
    indentation: f64,
    /// The branch from the largest state so far.
    memory: Option<Unloading>,
}

impl<'a> Machine<'a> {
    /// At first touch.
    pub fn new(law: &'a Law) -> Self {
        Self { law, indentation: 0.0, memory: None }
    }

    /// The x at which the force is `force` ≥ 0.
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        match &self.memory {
            Some(unloading) if force <= unloading.peak.force => {
                unloading.peak.residual() + unloading.recovered_at(force)
            }
            _ => self.law.loading.indentation_at_force(force),
        }
    }

    /// Goes to `indentation` ≥ 0; `None` if the contact is there already.
    pub fn go_to(&mut self, indentation: f64) -> Option<Stroke<'a>> {
        let from = self.indentation;
        if (indentation - from).abs() <= STILL * from.max(indentation) {
            return None;
        }
        let before = self.memory;
        if before.is_none_or(|unloading| indentation > unloading.peak.indentation) {
            self.memory = Some(self.law.unloading(self.law.loaded_to(indentation)));
        }
        self.indentation = indentation;
        // there is a memory now, as the first step goes in
        self.memory.map(|after| Stroke { law: self.law, from, to: indentation, before, after })
    }
}

/// One stroke of the machine: in or out, never both.
#[derive(Debug, Clone)]
pub(super) struct Stroke<'a> {
    law: &'a Law,
    from: f64,
    to: f64,
    before: Option<Unloading>,
    after: Unloading,
}

impl Stroke<'_> {
    /// The branch from the largest state, the step included.
    pub fn memory(&self) -> &Unloading {
        &self.after
    }

    /// Whether the step goes deeper than all before it.
    pub fn is_new_peak(&self) -> bool {
        self.to > self.deepest_before()
    }

    /// x_r before the step.
    pub fn dent(&self) -> f64 {
        self.before.map_or(0.0, |unloading| unloading.peak.residual())
    }

    /// The largest x before the step.
    fn deepest_before(&self) -> f64 {
        self.before.map_or(0.0, |unloading| unloading.peak.indentation)
    }

    /// The state at x between the two ends, and its branch.
    fn point(&self, x: f64) -> (Peak, Branch) {
        if let Some(unloading) = self.before.filter(|unloading| x <= unloading.peak.indentation) {
            let recovered = x - unloading.peak.residual();
            let branch = match (recovered < 0.0, self.to > self.from) {
                (true, _) => Branch::Separated,
                (false, true) => Branch::Reloading,
                (false, false) => Branch::Unloading,
            };
            let elastic_approach = recovered.max(0.0);
            return (Peak { indentation: x, force: unloading.force_of(recovered), elastic_approach }, branch);
        }
        let state = self.law.loaded_to(x);
        (state, if state.elastic_approach < x { Branch::Plastic } else { Branch::Elastic })
    }

    /// Where the step ends.
    pub fn end(&self) -> (Peak, Branch) {
        self.point(self.to)
    }

    /// `samples` ≥ 2 states, evenly spaced in x, both ends among them, and one at every change of branch.
    pub fn points(&self, samples: usize) -> impl Iterator<Item = (Peak, Branch)> {
        let (low, high) = (self.from.min(self.to), self.from.max(self.to));
        let changes = self.before.map(|unloading| [unloading.peak.residual(), unloading.peak.indentation]);
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
        let stored = |x: f64| self.before.map_or(0.0, |unloading| unloading.stored(x.min(unloading.peak.indentation)));
        stored(self.to) - stored(self.from) + self.loading_work()
    }

    /// The part of it on the loading curve.
    fn loading_work(&self) -> f64 {
        let deepest = self.deepest_before();
        if self.is_new_peak() { self.law.loading.work(self.to) - self.law.loading.work(deepest) } else { 0.0 }
    }

    /// The part of it that does not come back.
    pub fn plastic_work(&self) -> f64 {
        if !self.is_new_peak() {
            return 0.0;
        }
        let stored = |unloading: &Unloading| unloading.stored(unloading.peak.indentation);
        let plastic = self.loading_work() - (stored(&self.after) - self.before.as_ref().map_or(0.0, stored));
        // all comes back but for rounding
        if plastic.abs() <= GRAZING * stored(&self.after) { 0.0 } else { plastic }
    }
}
