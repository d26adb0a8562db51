//! The crate `ode_solvers` (Dormand-Prince 5(4) and 8(5,3)) behind [`Integrator`]; [`super::ode_forced`] puts motions with
//! drag on top of it. No file beside these two uses the crate.
//!
//! That crate stops *after* the accepted step that passed an event. So the step that passes the end of a piece is
//! thrown away, and from the state before it the last stretch is integrated with another independent variable (Hénon
//! 1982, Physica D 5, 412-414), which ends exactly where it should:
//!
//! * the turning point with the speed u: d' = −u/g, t' = −1/g from u to 0;
//! * the end of a piece, crossed fast, with the distance: u' = −g/u, t' = 1/u;
//! * crossed so slowly that 1/u is no smooth function: with the speed again, and with the u² that makes d the end found
//!   by Newton's method (d is almost linear in u²).
//!
//! The crate takes one absolute tolerance for all components, so it is given variables of size one. In release 0.6.2 the
//! twelfth node of Dop853 is 0 instead of 1 (found here: the row sums of its tableau are right, and with an explicit
//! independent variable the order drops to 3), so the landing carries its independent variable as a component.

use std::cell::{Cell, RefCell};

use nalgebra::{DefaultAllocator, Dim, OVector, Vector2, Vector3, allocator::Allocator};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System};

use super::{IntegrationError, Integrator, Landing, Leg, MOST_STEPS, Path, Sampler, State, Work};

/// Which of the crate's two adaptive methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Order 5(4).
    Dopri5,
    /// Order 8(5,3).
    Dop853,
}

/// `ode_solvers` with landing.
#[derive(Debug, Clone)]
pub struct OdeSolvers {
    method: Method,
    pub(super) tolerance: f64,
    work: Work,
    /// Steps of the legs before this one.
    taken_before_leg: u64,
}

/// Independent variable of a landing.
#[derive(Clone, Copy)]
enum Along {
    Distance,
    Speed,
}

/// The equations in variables of size one: y = (d, u) along the time, y = (d, u, t) along another variable.
struct Equations<'a> {
    path: &'a Path,
    along: Along,
    /// Given: stops once past the end of the leg, and collects the nodes \[t, d, u\] before it.
    nodes: Option<&'a RefCell<Vec<[f64; 3]>>>,
    evaluations: &'a Cell<u64>,
}

/// g in units of speed²/distance, at a distance in units of its size.
fn scaled_deceleration(path: &Path, distance: f64) -> f64 {
    let sizes = &path.sizes;
    path.restoring.at(distance * sizes.distance) * sizes.distance / (sizes.speed * sizes.speed)
}

impl Equations<'_> {
    /// Deceleration in units of speed²/distance.
    fn deceleration(&self, distance: f64) -> f64 {
        self.evaluations.set(self.evaluations.get() + 1);
        scaled_deceleration(self.path, distance)
    }
}

impl System<f64, Vector2<f64>> for Equations<'_> {
    fn system(&self, _time: f64, y: &Vector2<f64>, dy: &mut Vector2<f64>) {
        *dy = Vector2::new(y[1], -self.deceleration(y[0]));
    }

    fn solout(&mut self, x: f64, y: &Vector2<f64>, _dy: &Vector2<f64>) -> bool {
        let Some(nodes) = self.nodes else { return false };
        let is_past = match self.path.leg {
            Leg::Outward(end) => y[1] <= 0.0 || y[0] * self.path.sizes.distance >= end,
            Leg::Back => y[0] <= 0.0,
        };
        if !is_past {
            nodes.borrow_mut().push([x, y[0], y[1]]);
        }
        is_past
    }
}

impl System<f64, Vector3<f64>> for Equations<'_> {
    fn system(&self, _along: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        let g = self.deceleration(y[0]);
        let rates = Vector3::new(y[1], -g, 1.0);
        *dy = match self.along {
            Along::Distance => rates / y[1],
            Along::Speed => rates / -g,
        };
    }
}

impl OdeSolvers {
    /// An integrator with this relative tolerance.
    #[must_use]
    pub fn new(method: Method, tolerance: f64) -> Self {
        Self { method, tolerance, work: Work::default(), taken_before_leg: 0 }
    }

    /// A leg begins: its steps are counted from here.
    pub(super) fn begin_leg(&mut self) {
        self.taken_before_leg = self.work.steps + self.work.rejected;
    }

    fn run<D: Dim>(
        &mut self,
        equations: Equations,
        from: f64,
        to: f64,
        start: OVector<f64, D>,
    ) -> Result<OVector<f64, D>, IntegrationError>
    where
        for<'a> Equations<'a>: System<f64, OVector<f64, D>>,
        DefaultAllocator: Allocator<D>,
    {
        let evaluations = equations.evaluations;
        self.drive(equations, evaluations, from, to, start)
    }

    /// Carries `start` from `from` to `to`; `evaluations` is what the equations count themselves.
    pub(super) fn drive<S, D: Dim>(
        &mut self,
        equations: S,
        evaluations: &Cell<u64>,
        from: f64,
        to: f64,
        start: OVector<f64, D>,
    ) -> Result<OVector<f64, D>, IntegrationError>
    where
        S: System<f64, OVector<f64, D>>,
        DefaultAllocator: Allocator<D>,
    {
        /// Largest step in units of size one: no step may jump over a turning point (a quarter period is about 1.5).
        const LARGEST_STEP: f64 = 0.5;
        if from == to {
            return Ok(start);
        }
        // the steps of one leg, however many calls they come in
        let taken = self.work.steps + self.work.rejected - self.taken_before_leg;
        let most_steps = u32::try_from(MOST_STEPS.saturating_sub(taken)).unwrap_or(u32::MAX);
        if most_steps == 0 {
            return Err(IntegrationError::TooManySteps { steps: MOST_STEPS });
        }
        macro_rules! integrate {
            ($stepper:ident, $beta:expr, $shrink:expr, $grow:expr) => {{
                let mut stepper = $stepper::from_param(
                    equations,
                    from,
                    to,
                    to - from,
                    start,
                    self.tolerance,
                    self.tolerance,
                    0.9,
                    $beta,
                    $shrink,
                    $grow,
                    LARGEST_STEP,
                    0.0,
                    most_steps,
                    u32::MAX,
                    OutputType::Sparse,
                );
                (stepper.integrate(), stepper.y_out().last().cloned())
            }};
        }
        let (result, last) = match self.method {
            Method::Dopri5 => integrate!(Dopri5, 0.04, 0.2, 10.0),
            Method::Dop853 => integrate!(Dop853, 0.0, 0.333, 6.0),
        };
        self.work.force_evaluations += evaluations.take();
        let stats = result.map_err(|error| match error {
            ode_solvers::dop_shared::IntegrationError::MaxNumStepReached { .. } => {
                IntegrationError::TooManySteps { steps: MOST_STEPS }
            }
            ode_solvers::dop_shared::IntegrationError::StepSizeUnderflow { x }
            | ode_solvers::dop_shared::IntegrationError::StiffnessDetected { x } => {
                IntegrationError::StepUnderflow { time: x, step: 0.0 }
            }
        })?;
        self.work.steps += u64::from(stats.accepted_steps);
        self.work.rejected += u64::from(stats.rejected_steps);
        last.filter(|end| end.iter().all(|value| value.is_finite())).ok_or(IntegrationError::NotFinite { time: from })
    }

    /// [t, d, u] after `time` from a node.
    fn advance(&mut self, path: &Path, node: [f64; 3], time: f64) -> Result<[f64; 3], IntegrationError> {
        let equations = Equations { path, along: Along::Distance, nodes: None, evaluations: &Cell::new(0) };
        let end = self.run(equations, node[0], time, Vector2::new(node[1], node[2]))?;
        Ok([time, end[0], end[1]])
    }

    /// [t, d, u] where the distance or the speed reaches `to`.
    fn reach(&mut self, path: &Path, along: Along, node: [f64; 3], to: f64) -> Result<[f64; 3], IntegrationError> {
        let [t, d, u] = node;
        let from = match along {
            Along::Distance => d,
            Along::Speed => u,
        };
        let equations = Equations { path, along, nodes: None, evaluations: &Cell::new(0) };
        let end = self.run(equations, from, to, Vector3::new(d, u, t))?;
        Ok(match along {
            Along::Distance => [end[2], to, end[1]],
            Along::Speed => [end[2], end[0], to],
        })
    }

    /// From a node [t, d, u] before the end of the leg to that end.
    fn land(&mut self, path: &Path, node: [f64; 3]) -> Result<(Landing, [f64; 3]), IntegrationError> {
        let [_, d, u] = node;
        let Leg::Outward(end) = path.leg else {
            return Ok((Landing::End, self.reach(path, Along::Distance, node, 0.0)?));
        };
        let end = end / path.sizes.distance;
        // u² at the end of the piece, by the work of a straight line from here to there
        let g = 0.5 * (scaled_deceleration(path, d) + scaled_deceleration(path, end));
        let left = u * u - 2.0 * g * (end - d);
        if end.is_finite() && left > 0.25 * u * u {
            return Ok((Landing::End, self.reach(path, Along::Distance, node, end)?));
        }
        let turn = self.reach(path, Along::Speed, node, 0.0)?;
        if turn[1] < end {
            return Ok((Landing::Turning, turn));
        }
        let g_end = scaled_deceleration(path, end);
        let mut square = 2.0 * g_end * (turn[1] - end);
        let mut landed = turn;
        for _ in 0..8 {
            landed = self.reach(path, Along::Speed, node, square.sqrt())?;
            let miss = landed[1] - end;
            if miss.abs() <= 4.0 * f64::EPSILON * end {
                break;
            }
            square = (square + 2.0 * g_end * miss).max(0.0);
        }
        Ok((Landing::End, [landed[0], end, landed[2]]))
    }
}

impl Integrator for OdeSolvers {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        /// Longer than any leg: a quarter period is about 1.5 in units of size one.
        const LONG: f64 = 1e3;
        self.begin_leg();
        let super::Sizes { distance, speed } = path.sizes;
        let unit_of_time = distance / speed;
        let start = [0.0, state.distance / distance, state.speed / speed];
        let nodes = RefCell::new(vec![start]);
        let equations = Equations { path, along: Along::Distance, nodes: Some(&nodes), evaluations: &Cell::new(0) };
        self.run(equations, 0.0, LONG, Vector2::new(start[1], start[2]))?;
        let nodes = nodes.into_inner();
        let last = nodes.last().copied().unwrap_or(start);
        let (landing, end) = self.land(path, last)?;

        let begun = state.time;
        if let Some(samples) = samples {
            while let Some(time) = samples.due_before(begun + end[0] * unit_of_time) {
                let t = (time - begun) / unit_of_time;
                let node = nodes[nodes.partition_point(|node| node[0] <= t).saturating_sub(1)];
                let [_, d, u] = self.advance(path, node, t)?;
                samples.take(State { time, distance: d * distance, speed: u * speed });
            }
        }
        let landed_distance = match (landing, path.leg) {
            (Landing::End, Leg::Outward(at)) => at,
            (Landing::End, Leg::Back) => 0.0,
            (Landing::Turning, _) => end[1] * distance,
        };
        *state = State { time: begun + end[0] * unit_of_time, distance: landed_distance, speed: end[2] * speed };
        Ok(landing)
    }

    fn work(&self) -> Work {
        self.work
    }
}
