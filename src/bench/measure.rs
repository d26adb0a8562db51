//! Time against error: every method with each of its settings on one problem. The settings are timed in turn, round after
//! round, and the best time of each counts.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::problems::Problem;
use crate::impact::{Computed, Method, ScaledForces, Solver, batch, closed_form, run, verlet};
use crate::integrate::{IntegrationError, Work};
use crate::math::functions::pow;
use crate::math::power::max_or_nan;

/// What is measured: the methods of the scenarios, and the batch form of rk8.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contender {
    /// A method as in a scenario.
    Method(Method),
    /// rk8 in lock step.
    Batch,
}

impl Contender {
    /// All of them, in the order of the report.
    pub const ALL: [Self; 6] = [
        Self::Method(Method::Rk8),
        Self::Batch,
        Self::Method(Method::Dop853),
        Self::Method(Method::Dopri5),
        Self::Method(Method::Verlet),
        Self::Method(Method::ClosedForm),
    ];

    /// Its name as in a scenario; the batch form is `rk8_batch`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Method(method) => method.name(),
            Self::Batch => "rk8_batch",
        }
    }

    /// Its settings, from coarse to fine.
    fn rungs(self, is_quick: bool) -> Vec<Rung> {
        let thinned = |rungs: Vec<Rung>| if is_quick { rungs.into_iter().step_by(3).collect() } else { rungs };
        match self {
            Self::Method(Method::ClosedForm) => vec![Rung::Exact],
            Self::Method(Method::Verlet) => {
                let steps = [10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 500, 700, 1000, 2000, 5000, 10_000, 100_000];
                thinned(steps.map(Rung::Steps).to_vec())
            }
            _ => thinned((2..=26).map(|half| Rung::Tolerance(pow(10f64, -0.5 * f64::from(half)))).collect()),
        }
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
    pub contender: Contender,
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

/// The methods are compared on impacts by the law alone.
const NONE: ScaledForces = ScaledForces::NONE;

/// Impacts of one batch. Their speeds differ by up to a thousandth, so that the lanes do not all take the same steps.
const BATCH: usize = 512;

/// A method with its setting.
enum Runner<'a> {
    Method(Solver),
    /// Fixed steps of this length.
    Verlet {
        step: f64,
        most_steps: u64,
    },
    Exact,
    Batch {
        problems: Vec<batch::Problem<'a>>,
        tolerance: f64,
    },
}

impl<'a> Runner<'a> {
    fn new(contender: Contender, rung: Rung, phase: f64, problem: &'a Problem) -> Self {
        match (contender, rung) {
            (Contender::Method(_), Rung::Steps(steps)) => {
                let step = problem.exact.contact_time / (f64::from(steps) + phase);
                Self::Verlet { step, most_steps: 10 * u64::from(steps) }
            }
            (Contender::Method(method), Rung::Tolerance(tolerance)) => {
                Self::Method(Solver { method, tolerance, ..Solver::default() })
            }
            (Contender::Batch, Rung::Tolerance(tolerance)) => {
                #[allow(clippy::cast_precision_loss)]
                let speed = |i: usize| problem.speed * (1.0 + 1e-3 * (i % 61) as f64 / 61.0);
                Self::Batch { problems: (0..BATCH).map(|i| (&problem.law, speed(i), NONE)).collect(), tolerance }
            }
            (_, Rung::Exact | Rung::Steps(_)) => Self::Exact,
        }
    }

    /// One impact with its cost. Of a batch all impacts: the outcome is that of the first, the problem itself, and the cost
    /// is left out.
    fn run(&self, problem: &Problem) -> Result<Computed, IntegrationError> {
        let (law, speed) = (black_box(&problem.law), black_box(problem.speed));
        let without_cost = |outcome| Computed::new(outcome, Work::default());
        match self {
            Self::Method(solver) => run(law, speed, &NONE, None, solver, None),
            Self::Verlet { step, most_steps } => verlet::march(law, speed, &NONE, *step, *most_steps, None),
            Self::Exact => Ok(without_cost(closed_form::solve(law, speed))),
            Self::Batch { problems, tolerance } => {
                batch::integrate(black_box(problems), *tolerance).swap_remove(0).map(without_cost)
            }
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

    /// How many impacts a run computes.
    fn size(&self) -> usize {
        if let Self::Batch { problems, .. } = self { problems.len() } else { 1 }
    }
}

/// Relative errors of e, contact time, separation as it is seen, and peak force. With a fixed step the largest of all phases
/// counts. `None` if a run fails.
fn errors(contender: Contender, rung: Rung, problem: &Problem) -> Option<[f64; 4]> {
    let relative = |got: f64, want: f64| (got / want - 1.0).abs();
    let phases = if matches!(rung, Rung::Steps(_)) { &PHASES[..] } else { &PHASES[..1] };
    let exact = &problem.exact;
    let mut worst = [0.0_f64; 4];
    for phase in phases {
        let Computed { outcome, fixed_steps, .. } = Runner::new(contender, rung, *phase, problem).run(problem).ok()?;
        let seen = fixed_steps.map_or(outcome.contact_time, |fixed| fixed.contact_time);
        let errors = [
            relative(outcome.restitution, exact.restitution),
            relative(outcome.contact_time, exact.contact_time),
            relative(seen, exact.contact_time),
            relative(outcome.unloading.peak.force, exact.unloading.peak.force),
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
    for contender in Contender::ALL {
        for rung in contender.rungs(is_quick) {
            let runner = Runner::new(contender, rung, PHASES[0], problem);
            let Some(errors) = errors(contender, rung, problem) else { continue };
            // a lane of a batch takes the steps that rk8 takes alone
            let alone = if contender == Contender::Batch { Contender::Method(Method::Rk8) } else { contender };
            let Ok(Computed { work, .. }) = Runner::new(alone, rung, PHASES[0], problem).run(problem) else { continue };
            let started = Instant::now();
            runner.spend(problem);
            let once = started.elapsed().max(Duration::from_nanos(20));
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let repetitions = (burst.as_secs_f64() / once.as_secs_f64()).clamp(1.0, 1e5) as u32;
            let measurement = Measurement {
                contender,
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
            #[allow(clippy::cast_precision_loss)]
            let impacts = f64::from(*repetitions) * runner.size() as f64;
            measurement.ns_per_impact = measurement.ns_per_impact.min(started.elapsed().as_secs_f64() * 1e9 / impacts);
        }
    }
    entries.into_iter().map(|(.., measurement)| measurement).collect()
}
