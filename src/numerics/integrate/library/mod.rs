//! The crate `ode_solvers` (Dormand-Prince 5(4) and 8(5,3)) behind [`Integrator`].
//!
//! That crate stops *after* the accepted step that passed an event. The step is discarded. Without pull and drag the motion
//! from the state before it to the event is integrated again with another independent variable (`henon`); with them the
//! stepper of [`super::damped`] goes on from there to the end of the leg, at the same tolerance.
//!
//! The crate takes one absolute tolerance for all components, so it is given variables of size one. In release 0.6.2 the
//! twelfth node of Dop853 is 0 instead of 1 (found here: the row sums of its tableau are right, and with an explicit
//! independent variable the order drops to 3), so nothing here depends on the independent variable explicitly.
//!
//! The rows of a trace between its steps are those of that stepper at the same tolerance: the crate tells no stages.

mod driver;
mod henon;

use nalgebra::Vector3;
use ode_solvers::System;

use super::damped::DragStepper;
use super::dop853::{self, Continuous};
use super::event::DenseStep;
use super::piece::{AnyDragged, Motion};
use super::{Arrival, Drag, Effort, IntegrationError, Integrator, Landing, Leg, Path, Segment, Sizes, State};
use crate::numerics::power::max_or_nan;
use driver::Node;
pub use driver::{Library, Scheme};

/// The equations in variables of size one, y = (d, u, loss), up to the last step before an event.
struct Equations<'a> {
    path: &'a Path<'a>,
    nodes: &'a mut Vec<Node>,
}

impl System<f64, Vector3<f64>> for Equations<'_> {
    fn system(&self, _time: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        let Sizes { distance, speed } = self.path.sizes;
        let [_, acceleration, _, loss] = AnyDragged::<1>(*self.path).rates(y[0] * distance, y[1] * speed);
        let unit = distance / (speed * speed);
        *dy = Vector3::new(y[1], acceleration * unit, loss * unit / speed);
    }

    fn solout(&mut self, time: f64, y: &Vector3<f64>, _dy: &Vector3<f64>) -> bool {
        let (path, Sizes { distance, speed }) = (self.path, self.path.sizes);
        let (d, u) = (y[0] * distance, y[1] * speed);
        let sign = path.leg.direction();
        if time <= 0.0 {
            return false;
        }
        let ends = sign * u <= 0.0 || sign * (path.leg.end() - d) <= 0.0;
        let lifts = path.can_lift_off() && {
            let before = self.nodes.last().map_or([0.0; 4], |node| *node);
            let growth = |d: f64, u: f64| path.growth_of_force(d * distance, u * speed);
            let may_dip = path.pull > 0.0 && growth(before[1], before[2]) < 0.0 && growth(y[0], y[1]) > 0.0;
            may_dip || path.contact_force(d, u) <= 0.0
        };
        if ends || lifts || path.is_at_rest(d, u) {
            return true;
        }
        self.nodes.push([time, y[0], y[1], y[2]]);
        false
    }
}

/// The continuous solution of the step between two states.
fn between(path: &Path, from: &State, to: &State) -> Continuous {
    let (motion, node) = (AnyDragged::<1>(*path), [from.distance, from.speed, from.time, from.loss]);
    let h = to.time - from.time;
    dop853::step(motion, &node, &motion.rates(from.distance, from.speed), h, &[1.0; 3]).continuous(motion, &node, h)
}

impl Library {
    /// The states of a leg with pull or drag up to the last step before an event.
    fn steps(&mut self, path: &Path, start: Node) -> Result<Vec<Node>, IntegrationError> {
        /// Longer than any leg, except that of an overdamped sphere that creeps.
        const LONG: f64 = 1e6;
        let mut nodes = vec![start];
        if matches!(path.leg, Leg::Outward(_)) && start[2] <= 0.0 {
            return Ok(nodes);
        }
        let equations = Equations { path, nodes: &mut nodes };
        self.drive(equations, 0.0, LONG, Vector3::new(start[1], start[2], start[3]))?;
        Ok(nodes)
    }
}

impl Integrator for Library {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        track: Option<&mut Vec<Segment>>,
    ) -> Result<Arrival, IntegrationError> {
        self.taken_before_leg = self.work.steps + self.work.rejected;
        let Sizes { distance, speed } = path.sizes;
        let begun = *state;
        let absolute = |[t, d, u, loss]: Node| State {
            time: begun.time + t * distance / speed,
            distance: d * distance,
            speed: u * speed,
            loss: loss * speed * speed,
        };
        let start = [0.0, begun.distance / distance, begun.speed / speed, begun.loss / (speed * speed)];
        let is_free = path.pull == 0.0 && path.drag == Drag::NONE;
        let mut landing = None;
        let nodes = if is_free {
            let (mut nodes, landed, end) = henon::run(self, path, start)?;
            nodes.push(end);
            landing = Some(landed);
            nodes
        } else {
            self.steps(path, start)?
        };
        let mut states: Vec<State> = nodes.into_iter().map(absolute).collect();
        if let (Some(landing), Some(last)) = (landing, states.last_mut()) {
            last.distance = path.landed_at(landing, last.distance);
        }
        let mut largest = f64::NEG_INFINITY;
        for pair in states.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let falls = |state: &State| path.growth_of_force(state.distance, state.speed) <= 0.0;
            if path.drag.is_in_contact() && !falls(&from) && falls(&to) {
                let solution = between(path, &from, &to);
                largest = DenseStep { path, end: path.leg.end(), solution }.crest::<AnyDragged<1>>(1.0);
            }
        }
        if let Some(track) = track {
            DragStepper::new(self.tolerance).traverse(path, &mut begun.clone(), Some(track))?;
        }
        *state = states.last().copied().unwrap_or(begun);
        if landing.is_none() {
            let mut stepper = DragStepper::new(self.tolerance);
            let arrival = stepper.run(AnyDragged::<1>(*path), path, state, None);
            self.work = self.work + stepper.work();
            let Arrival { landing: landed, largest_force } = arrival?;
            landing = Some(landed);
            largest = max_or_nan(largest, largest_force);
        }
        let largest_force = max_or_nan(largest, path.larger_force(&begun, state));
        Ok(Arrival { landing: landing.unwrap_or(Landing::End), largest_force })
    }

    fn work(&self) -> Effort {
        self.work
    }
}
