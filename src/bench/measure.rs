//! Time against error: every method with each of its settings on one problem. The settings are timed in turn, round after
//! round, and the best time of each counts.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::problems::BenchProblem;
use crate::impact::solve::{closed_form, fixed_steps};
use crate::impact::{Method, Solution, Solver, solve};
use crate::numerics::functions::pow;
use crate::numerics::ode::{IntegrationError, SolverStats};
use crate::numerics::power::nan_max;

/// The methods that are measured, in the order of the report.
pub const METHODS: [Method; 5] = [Method::Rk8, Method::Dop853, Method::Dopri5, Method::Verlet, Method::ClosedForm];

/// True if a method solves a problem: there is no closed form under viscous damping, or on a plate.
pub fn is_applicable(method: Method, problem: &BenchProblem) -> bool {
    method != Method::ClosedForm || problem.forces.is_none()
}

/// The settings of a method, from coarse to fine.
fn settings_for(method: Method, is_quick: bool) -> Vec<Setting> {
    let thinned = |settings: Vec<Setting>| if is_quick { settings.into_iter().step_by(3).collect() } else { settings };
    match method {
        Method::ClosedForm => vec![Setting::Exact],
        Method::Verlet => {
            let steps = [10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 500, 700, 1000, 2000, 5000, 10_000, 100_000];
            thinned(steps.map(Setting::Steps).to_vec())
        }
        _ => thinned((2..=26).map(|half| Setting::Tolerance(pow(10f64, -0.5 * f64::from(half)))).collect()),
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Setting {
    Tolerance(f64),
    /// Steps over the exact contact time T. In a DEM code a contact seldom lasts a whole number of steps. So five step
    /// sizes T/(steps + phase) are tried, and the largest error counts.
    Steps(u32),
    /// The method has no setting.
    Exact,
}

/// The phases of [`Setting::Steps`].
const PHASES: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// The measured error and time of a method with one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    pub method: Method,
    pub setting: Setting,
    /// |e/e_exact − 1|.
    pub restitution_error: f64,
    /// The relative error of the contact time, which a fixed step interpolates within its last step.
    pub contact_time_error: f64,
    pub peak_force_error: f64,
    /// Cost of one impact.
    pub stats: SolverStats,
    /// Best time of one impact \[ns\].
    pub ns_per_impact: f64,
}

impl Timing {
    /// True if e is within the threshold, contact time and peak force within 30 times it.
    pub fn is_within(&self, threshold: f64) -> bool {
        self.restitution_error <= threshold
            && nan_max(self.contact_time_error, self.peak_force_error) <= 30.0 * threshold
    }
}

impl Setting {
    /// One impact with its cost. Fixed steps have a phase.
    fn run(self, method: Method, phase: f64, problem: &BenchProblem) -> Result<Solution, IntegrationError> {
        let (law, speed, forces) = (black_box(&problem.law), black_box(problem.speed), &problem.forces);
        match self {
            Self::Exact => Ok(Solution::new(closed_form::solve(law, speed), SolverStats::default())),
            Self::Tolerance(tolerance) => {
                solve(law, speed, forces, None, &Solver { method, tolerance, ..Solver::default() }, None)
            }
            Self::Steps(steps) => {
                let step = problem.exact.contact_time / (f64::from(steps) + phase);
                fixed_steps::integrate_fixed_steps(law.into(), speed, forces, step, 10 * u64::from(steps), None)
            }
        }
    }

    /// Runs a setting for its time alone. An exact outcome is not moved, because the move would show in its time.
    fn run_discarding(self, method: Method, problem: &BenchProblem) {
        match self {
            Self::Exact => _ = black_box(&closed_form::solve(black_box(&problem.law), black_box(problem.speed))),
            _ => _ = black_box(&self.run(method, PHASES[0], problem)),
        }
    }

    /// Its errors and its cost, but for the time; `None` if a run fails, as with a Verlet step so coarse that the sphere never
    /// leaves. With a fixed step the largest error of all phases counts.
    fn evaluate(self, method: Method, problem: &BenchProblem) -> Option<Timing> {
        let relative = |got: f64, want: f64| (got / want - 1.0).abs();
        let phases = if matches!(self, Self::Steps(_)) { &PHASES[..] } else { &PHASES[..1] };
        let exact = &problem.exact;
        let runs: Result<Vec<Solution>, _> = phases.iter().map(|phase| self.run(method, *phase, problem)).collect();
        let runs = runs.ok()?;
        let worst = |error: &dyn Fn(&Solution) -> f64| runs.iter().map(error).fold(0.0, nan_max);
        Some(Timing {
            method,
            setting: self,
            restitution_error: worst(&|run| relative(run.outcome.restitution, exact.restitution)),
            contact_time_error: worst(&|run| relative(run.outcome.contact_time, exact.contact_time)),
            peak_force_error: worst(&|run| relative(run.outcome.largest_force, exact.largest_force)),
            stats: runs.first()?.stats,
            ns_per_impact: f64::INFINITY,
        })
    }
}

/// Measures every method on a problem, with all settings that do not fail. Each round times every setting for about `burst`.
pub fn measure(problem: &BenchProblem, is_quick: bool, rounds: u32, burst: Duration) -> Vec<Timing> {
    let methods = METHODS.into_iter().filter(|method| is_applicable(*method, problem));
    let settings =
        methods.flat_map(|method| settings_for(method, is_quick).into_iter().map(move |setting| (method, setting)));
    let mut all: Vec<Timing> = settings.filter_map(|(method, setting)| setting.evaluate(method, problem)).collect();
    let time = |measurement: &Timing, repetitions: u32| {
        let ((), ns) = time_call(|| {
            (0..repetitions).for_each(|_| measurement.setting.run_discarding(measurement.method, problem));
        });
        ns / f64::from(repetitions)
    };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let fit = |once: f64| (1e9 * burst.as_secs_f64() / once.max(20.0)).clamp(1.0, 1e5) as u32;
    let repetitions: Vec<u32> = all.iter().map(|measurement| fit(time(measurement, 1))).collect();
    for _ in 0..rounds {
        for (measurement, repetitions) in all.iter_mut().zip(&repetitions) {
            measurement.ns_per_impact = measurement.ns_per_impact.min(time(measurement, *repetitions));
        }
    }
    all
}

/// Returns what `work` returns, and its time \[ns\].
pub(super) fn time_call<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let done = black_box(work());
    (done, 1e9 * started.elapsed().as_secs_f64())
}
