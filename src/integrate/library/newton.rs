//! Motions with pull and drag. The independent variable is the time, and the time of an event is found by Newton's method:
//! the derivative of the event along the time is known from the state.

use nalgebra::Vector3;
use ode_solvers::System;

use super::driver::{Library, Node};
use crate::integrate::cubic::dips;
use crate::integrate::{Crossing, IntegrationError, Landing, Leg, Path};
use crate::math::root::Bracket;

/// The landing on a crossing, and the state there.
fn landing_on(event: Crossing, at: Node) -> (Landing, Node) {
    match event {
        Crossing::End => (Landing::End, at),
        Crossing::Turning => (Landing::Turning, [at[0], at[1], 0.0, at[3]]),
        Crossing::LiftOff => (Landing::LiftOff, at),
    }
}

/// The loosest tolerance of a leg that may end in a creep. The error of the speed is measured against the largest speed of the
/// impact, and a creep is much slower: with a looser tolerance the steps may stop before the creep has ended.
const LOOSEST_CREEP: f64 = 1e-5;

fn tolerance(library: &Library, path: &Path) -> f64 {
    if path.rest.is_some() { library.tolerance.min(LOOSEST_CREEP) } else { library.tolerance }
}

/// Times nearer to each other than this, in units of size one, are one time.
const RESOLUTION: f64 = 1e-14;

/// The nodes of a motion before the end of its leg, and whether it has come to rest at the last of them.
struct Log {
    nodes: Vec<Node>,
    is_at_rest: bool,
}

/// The equations in variables of size one: y = (d, u, loss).
struct Equations<'a> {
    path: &'a Path,
    /// If given, the motion stops once past the end of the leg, and this is written.
    log: Option<&'a mut Log>,
}

impl Equations<'_> {
    /// Acceleration and what drag takes, in units of speed²/distance.
    fn accelerations(&self, d: f64, u: f64) -> (f64, f64) {
        let sizes = &self.path.sizes;
        let (distance, speed) = (d * sizes.distance, u * sizes.speed);
        let unit = sizes.distance / (sizes.speed * sizes.speed);
        let (force, drag) = self.path.forces(distance, speed);
        ((self.path.pull - (force + drag)) * unit, drag * unit)
    }

    /// A function that falls through zero at the event, and its derivative along the time.
    fn event(&self, event: Crossing, [_, d, u, _]: Node) -> (f64, f64) {
        let sizes = &self.path.sizes;
        let (sign, end) = (self.path.leg.direction(), self.path.leg.end());
        let (acceleration, _) = self.accelerations(d, u);
        match event {
            Crossing::End => (sign * (end / sizes.distance - d), -sign * u),
            Crossing::Turning => (sign * u, sign * acceleration),
            Crossing::LiftOff => {
                let of = |d: f64, u: f64| {
                    let (force, drag) = self.path.forces(d * sizes.distance, u * sizes.speed);
                    let force = force + drag;
                    // for d < 0 the formulas give a force of the other sign but the same drag: no contact there
                    if d > 0.0 { force } else { force.min(0.0) }
                };
                // derivative along the motion by a central difference: accurate enough for Newton's method to stay fast
                let by = 1e-6;
                let next = of(d + by * u, u + by * acceleration);
                let last = of(d - by * u, u - by * acceleration);
                (of(d, u), (next - last) / (2.0 * by))
            }
        }
    }

    /// The event between two nodes; at the start of a leg they are one.
    fn passed(&self, last: Node, node: Node) -> Option<Crossing> {
        let is_past = |event| self.event(event, node).0 <= 0.0;
        if self.path.can_lift_off() && is_past(Crossing::LiftOff) {
            return Some(Crossing::LiftOff);
        }
        if node[0] > 0.0 && is_past(Crossing::Turning) && !self.cannot_turn(last, node) {
            return Some(Crossing::Turning);
        }
        is_past(Crossing::End).then_some(Crossing::End)
    }

    /// Whether a sphere at rest in this place would be pushed further along the leg. Then it cannot have turned there.
    fn is_pushed_on(&self, d: f64) -> bool {
        let pushes = self.path.leg.direction() * self.accelerations(d, 0.0).0 > 0.0;
        pushes && !self.path.is_next_to_rest(d * self.path.sizes.distance, LOOSEST_CREEP)
    }

    /// Whether a speed of the wrong sign is only an error of the speed, as in a creep slower than that error. This is so if
    /// the sphere, even without drag, cannot get from `last` to a place where it could turn.
    fn cannot_turn(&self, last: Node, node: Node) -> bool {
        let sign = self.path.leg.direction();
        let time = node[0] - last[0];
        // on the way out only the pull speeds the sphere up; on the way back only the law does, and its force falls
        let sizes = &self.path.sizes;
        let push = if sign > 0.0 { self.path.pull } else { self.path.restoring.at(last[1] * sizes.distance) };
        let push = push * sizes.distance / (sizes.speed * sizes.speed);
        let way = ((sign * last[2]).max(0.0) + push * time) * time;
        self.is_pushed_on(last[1] + sign * way)
    }

    /// Whether the contact force vanishes and comes back within the step to this node.
    fn dips_before(&self, node: Node) -> bool {
        let Some(&last) = self.log.as_ref().and_then(|log| log.nodes.last()) else { return false };
        if !self.path.can_lift_off() || node[0] <= last[0] {
            return false;
        }
        let h = node[0] - last[0];
        let ((before, falls), (after, rises)) =
            (self.event(Crossing::LiftOff, last), self.event(Crossing::LiftOff, node));
        dips(before, falls * h, after, rises * h)
    }
}

impl System<f64, Vector3<f64>> for Equations<'_> {
    fn system(&self, _time: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        let (acceleration, drag) = self.accelerations(y[0], y[1]);
        *dy = Vector3::new(y[1], acceleration, drag * y[1]);
    }

    fn solout(&mut self, time: f64, y: &Vector3<f64>, _dy: &Vector3<f64>) -> bool {
        let node = [time, y[0], y[1], y[2]];
        let Some(last) = self.log.as_ref().map(|log| log.nodes.last().copied().unwrap_or(node)) else { return false };
        let is_past = self.passed(last, node).is_some() || self.dips_before(node);
        let Some(log) = self.log.as_mut().filter(|_| !is_past) else { return true };
        log.nodes.push(node);
        let sizes = &self.path.sizes;
        log.is_at_rest = time > 0.0 && self.path.is_at_rest(y[0] * sizes.distance, y[1] * sizes.speed);
        log.is_at_rest
    }
}

impl Library {
    /// The state a `time` after a node.
    pub(super) fn after(&mut self, path: &Path, node: Node, time: f64) -> Result<Node, IntegrationError> {
        let ([from, d, u, loss], to) = (node, node[0] + time);
        let equations = Equations { path, log: None };
        let end = self.drive(equations, tolerance(self, path), from, to, Vector3::new(d, u, loss))?;
        Ok([to, end[0], end[1], end[2]])
    }

    /// From the last node before an event to the event that comes first; `None` if at a loose tolerance the shorter steps
    /// of the search do not find what the long one had passed.
    fn land(&mut self, path: &Path, node: Node) -> Result<Option<(Landing, Node)>, IntegrationError> {
        let equations = Equations { path, log: None };
        let is_back = matches!(path.leg, Leg::Back(_));
        let candidates = [if path.can_lift_off() { Crossing::LiftOff } else { Crossing::End }, Crossing::Turning];
        let mut first: Option<(Crossing, Node)> = None;
        for event in candidates {
            let limit = first.map_or(f64::INFINITY, |(_, at)| at[0] - node[0]);
            let Some(at) = self.reach(&equations, event, node, limit)? else { continue };
            if event == Crossing::Turning && equations.is_pushed_on(at[1]) {
                continue;
            }
            if first.is_none_or(|(_, earlier)| at[0] < earlier[0]) {
                first = Some((event, at));
            }
            // at this event the sphere still moves along the leg, so it has not turned before
            if event != Crossing::Turning && (at[2] > 0.0) != is_back {
                break;
            }
        }
        Ok(first.map(|(event, at)| landing_on(event, at)))
    }

    /// The state at an event behind `node`, by Newton's method on the time; `None` if it is not within reach.
    fn reach(
        &mut self,
        equations: &Equations,
        event: Crossing,
        node: Node,
        limit: f64,
    ) -> Result<Option<Node>, IntegrationError> {
        /// Longer than any step of the library, so also than the one that passed the event.
        const FAR: f64 = 1.0;
        let (mut low, mut high) = (0.0, FAR.min(limit));
        let (mut tau, mut at) = (0.0, node);
        let (mut is_passed, mut is_met) = (false, false);
        let mut turns = 0;
        for _ in 0..60 {
            let (value, slope) = equations.event(event, at);
            if value > 0.0 && slope < 0.0 {
                low = tau;
            } else if value > 0.0 && tau > 0.0 {
                // the function rises: the event lies earlier, or is not met at all; after three rises the search ends
                high = tau;
                turns += 1;
                if turns > 3 {
                    return Ok(None);
                }
            } else if value <= 0.0 {
                (high, is_passed) = (tau, true);
            }
            let newton = tau - value / slope;
            let is_inside = newton >= low && newton <= high;
            let next = if is_inside { newton } else { 0.5 * (low + high) };
            if (next - tau).abs() <= RESOLUTION * (1.0 + node[0].abs()) || (is_passed && value == 0.0) {
                is_met = is_inside;
                break;
            }
            tau = next;
            at = self.after(equations.path, node, tau)?;
        }
        // found if the bracket has closed, if Newton's method has converged, or if the function is zero but for rounding
        let size = if event == Crossing::LiftOff { equations.event(event, node).0 } else { 1.0 };
        let is_there = is_passed || is_met || equations.event(event, at).0.abs() <= 1e-9 * size;
        Ok(is_there.then_some(at))
    }

    /// The state at an event that lies between `node` and a `time` after it, by Newton's method inside a bracket.
    fn between(
        &mut self,
        equations: &Equations,
        event: Crossing,
        node: Node,
        time: f64,
    ) -> Result<Node, IntegrationError> {
        let mut bracket = Bracket { low: 0.0, high: time };
        let mut at = node;
        for _ in 0..100 {
            let tau = at[0] - node[0];
            let next = bracket.next(tau, equations.event(event, at));
            at = self.after(equations.path, node, next)?;
            if (next - tau).abs() <= RESOLUTION * (1.0 + node[0].abs()) {
                break;
            }
        }
        Ok(at)
    }
}

/// The nodes of a leg, its landing and the state there.
pub(super) fn run(
    library: &mut Library,
    path: &Path,
    start: Node,
) -> Result<(Vec<Node>, Landing, Node), IntegrationError> {
    /// Longer than any leg, except that of an overdamped sphere that creeps.
    const LONG: f64 = 1e6;
    /// A long step may seem to pass an event that shorter steps do not meet. The motion is then followed for a `STRETCH`
    /// and goes on from there, this many times at most.
    const MOST_ATTEMPTS: u64 = 10_000;
    const STRETCH: f64 = 0.25;
    let mut log = Log { nodes: vec![start], is_at_rest: false };
    let mut last = start;
    for _ in 0..MOST_ATTEMPTS {
        let equations = Equations { path, log: Some(&mut log) };
        let [t, d, u, loss] = last;
        library.drive(equations, tolerance(library, path), t, LONG, Vector3::new(d, u, loss))?;
        last = log.nodes.last().copied().unwrap_or(start);
        let landed = if log.is_at_rest { Some((Landing::Rest, last)) } else { library.land(path, last)? };
        if let Some((landing, end)) = landed {
            return Ok((log.nodes, landing, end));
        }
        let further = library.after(path, last, STRETCH)?;
        let equations = Equations { path, log: None };
        if let Some(event) = equations.passed(last, further)
            && equations.event(event, last).0 > 0.0
        {
            let at = library.between(&equations, event, last, STRETCH)?;
            if event != Crossing::Turning || !equations.is_pushed_on(at[1]) {
                let (landing, end) = landing_on(event, at);
                return Ok((log.nodes, landing, end));
            }
        }
        log.nodes.push(further);
        last = further;
    }
    Err(IntegrationError::TooManySteps { steps: MOST_ATTEMPTS })
}
