//! The change of the slip speed in a contact, and the slip and the friction at any time of it.

/// The change of the slip speed.
#[derive(Debug)]
pub(in crate::impact) struct SlipResult {
    /// σ_1/σ_0, which is s_1/s_0.
    pub(super) ratio: f64,
    /// Its error: the sum of the errors of the steps.
    pub(super) error: f64,
    /// True if the contact point slides during the whole contact.
    pub(super) is_sliding: bool,
    /// The time of its end.
    pub(super) end: f64,
    /// The steps, in order of time; empty if they are not requested or not needed.
    pub(super) steps: Vec<SlipStep>,
}

/// A step of a run, for its trace.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipStep {
    pub(super) start: f64,
    pub(super) length: f64,
    /// σ/σ_0 at the start.
    pub(super) slip: f64,
    /// (5/2) χ/σ_0: what T changes of σ/σ_0.
    pub(super) rate: f64,
    pub(super) friction: Friction,
}

/// T during a step.
#[derive(Debug, Clone, Copy)]
pub(super) enum Friction {
    /// T equals the contact force, and acts against a slip to this side. `impulse` is the impulse at the start.
    Sliding { side: f64, impulse: f64 },
    /// T at start, middle and end, interpolated by a parabola.
    Partial([f64; 3]),
}

impl SlipStep {
    /// σ/σ_0 and T at a time of the step, where the contact has this force and this impulse so far.
    fn slip_and_force(&self, time: f64, force: f64, impulse: f64) -> [f64; 2] {
        match self.friction {
            Friction::Sliding { side, impulse: before } => {
                [self.slip - side * self.rate * (impulse - before), -side * force]
            }
            Friction::Partial([a, b, c]) => {
                let z = ((time - self.start) / self.length).clamp(0.0, 1.0);
                let (slope, curve) = (-3.0 * a + 4.0 * b - c, 2.0 * (a - 2.0 * b + c));
                let way = z * (a + z * (0.5 * slope + z * curve / 3.0));
                [self.slip + self.rate * self.length * way, a + z * (slope + z * curve)]
            }
        }
    }
}

impl SlipResult {
    /// A change that is known without steps.
    pub(super) fn without_steps(ratio: f64, is_sliding: bool) -> Self {
        Self { ratio, error: 0.0, is_sliding, end: 0.0, steps: Vec::new() }
    }

    /// The change from a smaller σ_0, in this ratio to the σ_0 of the run. Both are so small that springs slip only at the rim, so σ is
    /// proportional to σ_0.
    pub(super) fn scale_by(mut self, share: f64) -> Self {
        for step in &mut self.steps {
            if let Friction::Partial(friction) = &mut step.friction {
                *friction = friction.map(|part| part * share);
                step.rate /= share;
            }
        }
        self
    }

    /// σ/σ_0 and T at a time, where the contact has this force and this impulse so far.
    pub(super) fn slip_and_force(&self, time: f64, force: f64, impulse: f64) -> [f64; 2] {
        let step = self.steps.partition_point(|step| step.start <= time).saturating_sub(1);
        self.steps.get(step).map_or([self.ratio, 0.0], |step| step.slip_and_force(time, force, impulse))
    }
}
