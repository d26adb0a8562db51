//! One contact as another code computed it: time, indentation and force of its steps, and what follows from them. The law of that code
//! is not needed: speeds are differences of the indentation, and energies are the work of the force.

mod read;

pub use read::TraceError;

/// A step of the other code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceStep {
    /// Line in the file, counted from 1.
    pub line: u64,
    /// \[s\].
    pub time: f64,
    /// δ, positive in contact \[m\].
    pub indentation: f64,
    /// Force on the sphere, positive if it pushes \[N\].
    pub force: f64,
}

/// The steps of one contact, with the steps before and after the contact that the file has.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTrace {
    pub steps: Vec<TraceStep>,
    /// The steps with a force: index of the first, and of the last.
    contact: [usize; 2],
    /// Assumptions about the columns, for the user.
    pub notes: Vec<String>,
}

/// The results of the contact that the other code computed.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceMeasures {
    /// Speed into the contact \[m/s\].
    pub speed: f64,
    /// Speed out of the contact \[m/s\].
    pub rebound_speed: f64,
    /// True if both speeds are those of steps without a force.
    pub are_free_speeds: bool,
    /// e by the work of the force and the mass; `None` without a mass.
    pub restitution_by_work: Option<f64>,
    pub contact_time: f64,
    pub n_steps: usize,
    pub peak_force: f64,
    pub peak_indentation: f64,
    /// Work of the force on the body that is hit while δ rises \[J\].
    pub loading_work: f64,
    /// Work that the contact has taken \[J\]; below zero, the contact has created energy.
    pub net_work: f64,
    /// Error of the works by the finite steps \[J\].
    pub work_error: f64,
    /// Largest force that pulls \[N\], and the number of such steps.
    pub pull: Option<(f64, usize)>,
    /// Largest change of the force from one step to the next \[N\], and the time after it.
    pub largest_jump: (f64, f64),
    /// Overlap of the first step in contact, over the way of one step.
    pub first_overlap_in_steps: f64,
}

/// A smaller fraction of the largest force counts as zero.
const NO_FORCE: f64 = 1e-12;
/// A contact with fewer steps has no speeds and no work.
const MIN_STEPS: usize = 4;
/// Fewer steps are a warning.
const FEW_STEPS: usize = 20;
/// A file that begins or ends inside of the contact has a force there that is larger than this fraction of the peak.
const MAX_END_FORCE: f64 = 0.05;
/// A net work below zero by more than this fraction of the work of loading is energy that the contact made, and no rounding.
const ENERGY_TOLERANCE: f64 = 1e-6;
/// A rebound that is faster than the impact by more than this fraction is no rounding of the file.
const SPEED_TOLERANCE: f64 = 1e-3;

impl TraceMeasures {
    /// e by the speeds.
    pub fn restitution(&self) -> f64 {
        self.rebound_speed / self.speed
    }

    /// True if the work of the force is below zero: the loop of force and indentation runs the wrong way.
    fn made_work(&self) -> bool {
        self.net_work < -(self.work_error + ENERGY_TOLERANCE * self.loading_work)
    }

    /// True if the sphere leaves faster than it came.
    fn gained_speed(&self) -> bool {
        self.are_free_speeds && self.restitution() > 1.0 + SPEED_TOLERANCE
    }

    /// True if more energy came out than went in.
    pub fn made_energy(&self) -> bool {
        self.made_work() || self.gained_speed()
    }

    /// The faults of the contact, each with its cure.
    pub fn warnings(&self) -> Vec<String> {
        let percent = |part: f64, whole: f64| format!("{:.3} %", 100.0 * part / whole);
        let mut warnings = Vec::new();
        if self.gained_speed() {
            warnings.push(format!(
                "the contact creates energy: the separation speed is {} of the approach speed. Use a smaller time step, or more damping.",
                percent(self.rebound_speed, self.speed)
            ));
        } else if self.made_work() {
            warnings.push(format!(
                "the contact creates energy: the recovered work exceeds the loading work by {}. Use a smaller time step, or a force that depends on its history.",
                percent(-self.net_work, self.loading_work)
            ));
        }
        if let Some((force, n)) = self.pull {
            warnings.push(format!(
                "the force pulls in {n} steps, up to {} of the peak force. A contact without adhesion never pulls: set a negative force to zero.",
                percent(force, self.peak_force)
            ));
        }
        if self.first_overlap_in_steps > 1.0 + 1e-6 {
            warnings.push(format!(
                "the first overlap is {:.2} times the largest overlap that one time step makes. Insert the bodies without overlap, and detect contacts in every step.",
                self.first_overlap_in_steps
            ));
        }
        if self.n_steps < FEW_STEPS {
            warnings.push(format!(
                "the contact has {} steps, so e has an error of some per cent. Use a time step with at least 50 steps per contact.",
                self.n_steps
            ));
        }
        // a smooth contact changes by π/N of the peak in a step, and with hysteresis by some more
        let (jump, time) = self.largest_jump;
        #[allow(clippy::cast_precision_loss)] // steps
        let smooth = 10.0 / self.n_steps as f64;
        if jump > smooth.clamp(0.05, 0.5) * self.peak_force {
            warnings.push(format!(
                "the force jumps by {} of the peak force at {time:e} s. A jump absorbs or creates energy, by an amount that depends on the time step.",
                percent(jump, self.peak_force)
            ));
        }
        warnings
    }
}

impl ContactTrace {
    /// The steps with a force and one step on each side.
    pub fn contact_steps(&self) -> &[TraceStep] {
        let [first, last] = self.contact;
        &self.steps[first.saturating_sub(1)..(last + 2).min(self.steps.len())]
    }

    /// The results of the other code, for this mass of the relative motion.
    pub fn measures(&self, mass: Option<f64>) -> TraceMeasures {
        let [first, last] = self.contact;
        let (steps, rows) = (&self.steps, self.contact_steps());
        let speed_at = |i: usize| {
            let (from, to) = (steps[i], steps[i + 1]);
            (to.indentation - from.indentation) / (to.time - from.time)
        };
        let (has_entry, has_exit) = (first >= 2, last + 2 < steps.len());
        let entry = if has_entry { first - 2 } else { first.saturating_sub(1) };
        let exit = if has_exit { last + 1 } else { (last + 1).min(steps.len() - 1) - 1 };
        let (speed, rebound_speed) = (speed_at(entry), -speed_at(exit));
        let (net_work, loading_work) = work(rows);
        let every_second: Vec<TraceStep> =
            rows.iter().enumerate().filter(|(i, _)| i % 2 == 0 || i + 1 == rows.len()).map(|(_, row)| *row).collect();
        let work_error = (work(&every_second).0 - net_work).abs();
        let peak = |value: fn(&TraceStep) -> f64| rows.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
        let peak_force = peak(|step| step.force);
        let pulls = || rows.iter().filter(|step| step.force < -NO_FORCE * peak_force);
        let largest_pull = pulls().map(|step| -step.force).fold(0.0, f64::max);
        let jumps = rows.windows(2).map(|pair| ((pair[1].force - pair[0].force).abs(), pair[1].time));
        let step = if first > 0 { steps[first].time - steps[first - 1].time } else { steps[1].time - steps[0].time };
        let kinetic = mass.map(|mass| 0.5 * mass * speed * speed);
        TraceMeasures {
            speed,
            rebound_speed,
            are_free_speeds: has_entry && has_exit,
            restitution_by_work: kinetic.map(|kinetic| (1.0 - net_work / kinetic).max(0.0).sqrt()),
            contact_time: steps[last].time - steps[first].time + step,
            n_steps: last - first + 1,
            peak_force,
            peak_indentation: peak(|step| step.indentation),
            loading_work,
            net_work,
            work_error,
            pull: (largest_pull > 0.0).then(|| (largest_pull, pulls().count())),
            largest_jump: jumps.fold((0.0, f64::NAN), |largest, jump| if jump.0 > largest.0 { jump } else { largest }),
            first_overlap_in_steps: steps[first].indentation / (speed * step),
        }
    }
}

/// The work of the force over the steps, and its part while δ rises.
fn work(steps: &[TraceStep]) -> (f64, f64) {
    steps.windows(2).fold((0.0, 0.0), |(net, loading), pair| {
        let distance = pair[1].indentation - pair[0].indentation;
        let work = 0.5 * (pair[0].force + pair[1].force) * distance;
        (net + work, if distance > 0.0 { loading + work } else { loading })
    })
}
