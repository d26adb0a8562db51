//! Motions that only the restoring force acts on, landed with another independent variable (Hénon 1982, Physica D 5,
//! 412-414), which ends exactly where it should:
//!
//! * the turning point with the speed u: d' = −u/g, t' = −1/g from u to 0;
//! * the end of a piece, crossed fast, with the distance: u' = −g/u, t' = 1/u;
//! * the end of a piece, crossed so slowly that 1/u is not smooth: with the speed again. The u² at which d is the end is found
//!   by Newton's method (d is almost linear in u²).

use nalgebra::{Vector2, Vector3};
use ode_solvers::System;

use super::driver::{Library, Node};
use crate::numerics::integrate::{IntegrationError, Landing, Leg, Path};

/// The independent variable of a landing, as its index in (d, u).
const DISTANCE: usize = 0;
const SPEED: usize = 1;

/// The equations in variables of size one: y = (d, u) along the time, y = (d, u, t) along another variable.
struct Equations<'a> {
    path: &'a Path<'a>,
    /// [`DISTANCE`] or [`SPEED`]; not used along the time.
    along: usize,
    /// If given, the motion stops once past the end of the leg, and the nodes before it are collected here.
    nodes: Option<&'a mut Vec<Node>>,
}

/// g in units of speed²/distance, at a distance in units of its size.
fn scaled_deceleration(path: &Path, distance: f64) -> f64 {
    let sizes = &path.sizes;
    path.restoring(distance * sizes.distance) * sizes.distance / (sizes.speed * sizes.speed)
}

impl System<f64, Vector2<f64>> for Equations<'_> {
    fn system(&self, _time: f64, y: &Vector2<f64>, dy: &mut Vector2<f64>) {
        *dy = Vector2::new(y[1], -scaled_deceleration(self.path, y[0]));
    }

    fn solout(&mut self, x: f64, y: &Vector2<f64>, _dy: &Vector2<f64>) -> bool {
        let Some(nodes) = self.nodes.as_mut() else { return false };
        let is_past = match self.path.leg {
            Leg::Outward(end) => y[1] <= 0.0 || y[0] * self.path.sizes.distance >= end,
            Leg::Back(end) => y[0] * self.path.sizes.distance <= end,
        };
        if !is_past {
            nodes.push([x, y[0], y[1], 0.0]);
        }
        is_past
    }
}

impl System<f64, Vector3<f64>> for Equations<'_> {
    fn system(&self, _along: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        let g = scaled_deceleration(self.path, y[0]);
        let rates = Vector3::new(y[1], -g, 1.0);
        *dy = rates / rates[self.along];
    }
}

/// The nodes of a leg, its landing and the state there.
pub(super) fn run(
    library: &mut Library,
    path: &Path,
    start: Node,
) -> Result<(Vec<Node>, Landing, Node), IntegrationError> {
    /// Longer than any leg: a quarter period is about 1.5 in units of size one.
    const LONG: f64 = 1e3;
    let mut nodes = vec![start];
    let equations = Equations { path, along: DISTANCE, nodes: Some(&mut nodes) };
    library.drive(equations, 0.0, LONG, Vector2::new(start[1], start[2]))?;
    let last = nodes.last().copied().unwrap_or(start);
    let (landing, [t, d, u, _]) = land(library, path, last)?;
    Ok((nodes, landing, [t, d, u, start[3]]))
}

/// The state where the distance or the speed reaches `to`.
fn reach(library: &mut Library, path: &Path, along: usize, node: Node, to: f64) -> Result<Node, IntegrationError> {
    let [t, d, u, loss] = node;
    let equations = Equations { path, along, nodes: None };
    let end = library.drive(equations, [d, u][along], to, Vector3::new(d, u, t))?;
    let mut at = [end[2], end[0], end[1], loss];
    at[1 + along] = to;
    Ok(at)
}

/// From a node before the end of the leg to that end.
fn land(library: &mut Library, path: &Path, node: Node) -> Result<(Landing, Node), IntegrationError> {
    let [_, d, u, _] = node;
    let end = match path.leg {
        Leg::Outward(end) => end / path.sizes.distance,
        Leg::Back(end) => {
            return Ok((Landing::End, reach(library, path, DISTANCE, node, end / path.sizes.distance)?));
        }
    };
    // u² at the end of the piece, by the work of a straight line from here to there
    let g = 0.5 * (scaled_deceleration(path, d) + scaled_deceleration(path, end));
    let u_squared_at_end = u * u - 2.0 * g * (end - d);
    if end.is_finite() && u_squared_at_end > 0.25 * u * u {
        return Ok((Landing::End, reach(library, path, DISTANCE, node, end)?));
    }
    let turn = reach(library, path, SPEED, node, 0.0)?;
    if turn[1] < end {
        return Ok((Landing::Turning, turn));
    }
    let g_end = scaled_deceleration(path, end);
    let mut square = 2.0 * g_end * (turn[1] - end);
    let mut landed = turn;
    for _ in 0..8 {
        landed = reach(library, path, SPEED, node, square.sqrt())?;
        let miss = landed[1] - end;
        if miss.abs() <= 4.0 * f64::EPSILON * end {
            break;
        }
        square = (square + 2.0 * g_end * miss).max(0.0);
    }
    Ok((Landing::End, [landed[0], end, landed[2], landed[3]]))
}
