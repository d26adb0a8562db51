//! Time against error: every method with each of its settings on one problem. The settings are timed in turn, round after
//! round, and the best time of each counts.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::problems::Problem;
use crate::impact::{Computed, Method, Solver, closed_form, run, verlet};
use crate::integrate::{IntegrationError, Work};
use crate::math::functions::pow;
use crate::math::power::max_or_nan;

/// What is measured, in the order of the report.
pub const METHODS: [Method; 5] = [Method::Rk8, Method::Dop853, Method::Dopri5, Method::Verlet, Method::ClosedForm];

/// Whether a method solves a problem: there is no closed form under viscous damping, or on a plate.
pub fn serves(method: Method, problem: &Problem) -> bool {
    method != Method::ClosedForm || problem.forces.is_none()
}

/// The settings of a method, from coarse to fine.
fn rungs(method: Method, is_quick: bool) -> Vec<Rung> {
    let thinned = |rungs: Vec<Rung>| if is_quick { rungs.into_iter().step_by(3).collect() } else { rungs };
    match method {
        Method::ClosedForm => vec![Rung::Exact],
        Method::Verlet => {
            let steps = [10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 500, 700, 1000, 2000, 5000, 10_000, 100_000];
            thinned(steps.map(Rung::Steps).to_vec())
        }
        _ => thinned((2..=26).map(|half| Rung::Tolerance(pow(10f64, -0.5 * f64::from(half)))).collect()),
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rung {
    Tolerance(f64),
    /// Steps over the exact contact time T. In a DEM code a contact seldom lasts a whole number of steps. So five step
    /// sizes T/(steps + phase) are tried, and the largest error counts.
    Steps(u32),
    /// Nothing to set.
    Exact,
}

/// The phases of [`Rung::Steps`].
const PHASES: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// What was measured of a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    pub method: Method,
    pub rung: Rung,
    /// |e/e_exact − 1|.
    pub restitution_error: f64,
    /// The same for the contact time, which a fixed step interpolates within its last step.
    pub contact_time_error: f64,
    /// The same for the time at which separation is seen: in whole steps with a fixed step, else the contact time.
    pub separation_error: f64,
    pub peak_force_error: f64,
    /// Cost of one impact.
    pub work: Work,
    /// Best time of one impact \[ns\].
    pub ns_per_impact: f64,
}

impl Measurement {
    /// Whether e is within the threshold, contact time and peak force within 30 times it.
    pub fn reaches(&self, threshold: f64) -> bool {
        self.restitution_error <= threshold
            && max_or_nan(self.contact_time_error, self.peak_force_error) <= 30.0 * threshold
    }
}

/// A method with its setting.
enum Runner {
    Method(Solver),
    /// Fixed steps of this length.
    Verlet {
        step: f64,
        most_steps: u64,
    },
    Exact,
}

impl Runner {
    fn new(method: Method, rung: Rung, phase: f64, problem: &Problem) -> Self {
        match rung {
            Rung::Steps(steps) => {
                let step = problem.exact.contact_time / (f64::from(steps) + phase);
                Self::Verlet { step, most_steps: 10 * u64::from(steps) }
            }
            Rung::Tolerance(tolerance) => Self::Method(Solver { method, tolerance, ..Solver::default() }),
            Rung::Exact => Self::Exact,
        }
    }

    /// One impact with its cost.
    fn run(&self, problem: &Problem) -> Result<Computed, IntegrationError> {
        let (law, speed, forces) = (black_box(&problem.law), black_box(problem.speed), &problem.forces);
        match self {
            Self::Method(solver) => run(law, speed, forces, None, solver, None),
            Self::Verlet { step, most_steps } => verlet::march(law, speed, forces, *step, *most_steps),
            Self::Exact => Ok(Computed::new(closed_form::solve(law, speed), Work::default())),
        }
    }

    /// The same for its time alone. An exact outcome is not moved, because the move would show in its time.
    fn spend(&self, problem: &Problem) {
        let (law, speed) = (black_box(&problem.law), black_box(problem.speed));
        match self {
            Self::Exact => _ = black_box(&closed_form::solve(law, speed)),
            _ => _ = black_box(&self.run(problem)),
        }
    }
}

/// Relative errors of e, contact time, separation as it is seen, and peak force. With a fixed step the largest of all phases
/// counts. `None` if a run fails.
fn errors(method: Method, rung: Rung, problem: &Problem) -> Option<[f64; 4]> {
    let relative = |got: f64, want: f64| (got / want - 1.0).abs();
    let phases = if matches!(rung, Rung::Steps(_)) { &PHASES[..] } else { &PHASES[..1] };
    let exact = &problem.exact;
    let mut worst = [0.0_f64; 4];
    for phase in phases {
        let Computed { outcome, fixed_steps, .. } = Runner::new(method, rung, *phase, problem).run(problem).ok()?;
        let seen = fixed_steps.map_or(outcome.contact_time, |fixed| fixed.contact_time);
        let errors = [
            relative(outcome.restitution, exact.restitution),
            relative(outcome.contact_time, exact.contact_time),
            relative(seen, exact.contact_time),
            relative(outcome.largest_force, exact.largest_force),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = max_or_nan(*worst, error);
        }
    }
    Some(worst)
}

/// Measures every method on a problem. A setting that fails, such as a Verlet step so coarse that the sphere never leaves,
/// is left out. Each round times every other setting for about `burst`.
pub fn measure(problem: &Problem, is_quick: bool, rounds: u32, burst: Duration) -> Vec<Measurement> {
    let mut entries: Vec<(Runner, u32, Measurement)> = Vec::new();
    for method in METHODS.into_iter().filter(|method| serves(*method, problem)) {
        for rung in rungs(method, is_quick) {
            let runner = Runner::new(method, rung, PHASES[0], problem);
            let Some(errors) = errors(method, rung, problem) else { continue };
            let Ok(Computed { work, .. }) = runner.run(problem) else { continue };
            let started = Instant::now();
            runner.spend(problem);
            let once = started.elapsed().max(Duration::from_nanos(20));
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let repetitions = (burst.as_secs_f64() / once.as_secs_f64()).clamp(1.0, 1e5) as u32;
            let measurement = Measurement {
                method,
                rung,
                restitution_error: errors[0],
                contact_time_error: errors[1],
                separation_error: errors[2],
                peak_force_error: errors[3],
                work,
                ns_per_impact: f64::INFINITY,
            };
            entries.push((runner, repetitions, measurement));
        }
    }
    for _ in 0..rounds {
        for (runner, repetitions, measurement) in &mut entries {
            let started = Instant::now();
            for _ in 0..*repetitions {
                runner.spend(problem);
            }
            let ns = started.elapsed().as_secs_f64() * 1e9 / f64::from(*repetitions);
            measurement.ns_per_impact = measurement.ns_per_impact.min(ns);
        }
    }
    entries.into_iter().map(|(.., measurement)| measurement).collect()
}
