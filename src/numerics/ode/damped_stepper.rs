//! The stepper of rk8 for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event. Straight
//! pieces need no steps during loading if the drag is linear: see `damped_oscillator.rs`.
//!
//! **Landing.** The step that would reach the end of the leg, by the speed and its rate at the start of the step, is made a
//! little longer than that. Where a step has passed an event, the event is located on the continuous solution of the step,
//! which costs three evaluations. If it lies near the end of the step, the state there is that of the continuous solution,
//! whose error vanishes at both ends of the step with the square of the distance. If it lies well inside, a step that ends
//! a little behind it is taken in place of this one.

use super::damped_oscillator::Oscillation;
use super::dop853::{self, CONTINUOUS_EVALUATIONS, Continuous, EVALUATIONS};
use super::equations::linear::DraggedStraight;
use super::equations::power::DraggedHertz;
use super::equations::{AnyDragged, Dragged, DraggedState};
use super::event::{DenseStep, Landed, has_crested};
use super::{Arrival, Drag, Effort, IntegrationError, Integrator, Landing, MOST_STEPS, Path, Segment, State};
use crate::numerics::curve::piece::Shape;
use crate::numerics::functions::pow;
use crate::numerics::root::bracketed;

/// The part of the tolerance that one step may take: with it the ledger of a whole impact closes to ten times the tolerance.
const PART: f64 = 0.05;

/// The first step on a leg is this times tolerance^(1/8) in units of 1/ω.
const FIRST_STEP: f64 = 2.0;

/// The longest step of the rebound under gravity, in units of 1/ω: half an oscillation takes π.
const LONGEST: f64 = 2.0;

/// A step to the predicted end of a leg is longer by this factor.
const BEYOND: f64 = 1.005;
/// Up to here in a step (0 ≤ θ ≤ 1) its continuous solution may have a larger error than the step.
pub(super) const WELL_INSIDE: f64 = 0.98;
/// How often the step to an event is taken again.
pub(super) const MOST_ROUNDS: u32 = 3;

/// The least share of the error of order 5 that counts as the error of a step.
///
/// The pair estimates the error by e5²/e3, which assumes that both errors have the same leading terms. Near r = 0 this does
/// not hold: a weak pull or drag enters with a low power of r, which order 3 misses, and the force with the ninth power,
/// which both miss. This share goes with the square of the step, as e5²/e3 does on a smooth motion, so that the steps
/// of smooth motions stay as they are.
fn least_share(tolerance: f64) -> f64 {
    2.0 * (PART * tolerance).sqrt().sqrt()
}

#[derive(Debug, Clone)]
pub struct DragStepper {
    tolerance: f64,
    work: Effort,
}

impl DragStepper {
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, work: Effort::default() }
    }

    /// Along a piece in its own variables.
    pub(super) fn run<P: Dragged>(
        &mut self,
        piece: P,
        path: &Path,
        state: &mut State,
        mut track: Option<&mut Vec<Segment>>,
    ) -> Result<Arrival, IntegrationError> {
        let sign = path.leg.direction();
        let end = P::y_at(path.leg.end());
        let begun = *state;
        self.work.force_evaluations += 1;
        if let Some(arrival) = path.turned_already(state) {
            return Ok(arrival);
        }
        let size = P::y_at(path.sizes.distance);
        let speed = path.sizes.speed;
        let inverse_sizes = [size, speed, speed * speed].map(|size| 1.0 / (PART * self.tolerance * size));
        let least = least_share(self.tolerance);
        let mut node = [P::y_at(begun.distance), begun.speed, begun.time, begun.loss];
        let mut rates = piece.rates(node[0], node[1]);
        // the error control may still shrink the first step; on a short leg the force may be too weak to limit it
        let far = if sign > 0.0 { end.min(size.max(node[0])) } else { node[0] };
        let mut h = FIRST_STEP * pow(self.tolerance, 0.125) / P::frequency(path, far);
        if node[1] > 0.0 && far > node[0] && end.is_infinite() {
            h = h.min((far - node[0]) / node[1]);
        }
        // where the pull nearly balances the force, a swing may be smaller than the error of a step, and no step may pass it whole
        let longest = if path.pull > 0.0 && sign < 0.0 { LONGEST / P::frequency(path, node[0]) } else { f64::INFINITY };
        let mut largest = f64::NEG_INFINITY;
        // without drag in the contact, its force is largest at an end of the leg
        let mut is_falling = sign < 0.0 || !path.drag.is_in_contact() || has_crested::<P>(path, &node);
        let most = self.work.steps + self.work.rejected + MOST_STEPS;
        let mut rounds = 0;
        loop {
            if self.work.steps + self.work.rejected >= most {
                return Err(out_of_steps(path));
            }
            let last = step_to(sign * (end - node[0]), sign * rates[0], sign * rates[1]);
            // no tiny step for the end
            let is_half = h < last && 2.0 * h > last && rounds == 0;
            h = if is_half { 0.5 * last } else { h.min(last) };
            let next = dop853::step(piece, &node, &rates, h, &inverse_sizes);
            self.work.force_evaluations += EVALUATIONS;
            let error = next.error(h, least);
            let pace = 0.9 * pow(error, -0.125);
            // NaN where a stage left the range of a formula: a shorter step may stay inside
            if error > 1.0 || error.is_nan() {
                h = self.rejected(h * pace.max(0.2), &node, &rates)?;
                continue;
            }
            let mut solved: Option<Continuous> = None;
            let solve = || next.continuous(piece, &node, h);
            let mut landed = None;
            if may_end::<P>(path, end, &node, &next.node) {
                let solution = *solved.get_or_insert_with(solve);
                landed = DenseStep { path, end, solution }.landed::<P>();
            }
            // an event well inside of the step is located again, on a step that ends a little behind it
            if let Some(Landed { theta, .. }) = landed
                && theta < WELL_INSIDE
                && rounds < MOST_ROUNDS
            {
                rounds += 1;
                self.work.force_evaluations += CONTINUOUS_EVALUATIONS;
                h = step_beyond(h * theta);
                continue;
            }
            if landed.is_some_and(|landed| is_false_turn(piece, path, &landed)) {
                self.work.force_evaluations += CONTINUOUS_EVALUATIONS;
                self.work.rejected += 1;
                h *= 0.5;
                continue;
            }
            (self.work.steps, rounds) = (self.work.steps + 1, 0);
            let to = landed.map_or(next.node, |landed| landed.node);
            if !is_falling && has_crested::<P>(path, &to) {
                is_falling = true;
                let limit = landed.map_or(1.0, |landed| landed.theta);
                let solution = *solved.get_or_insert_with(solve);
                largest = DenseStep { path, end, solution }.crest::<P>(limit);
            }
            self.work.force_evaluations += if solved.is_some() { CONTINUOUS_EVALUATIONS } else { 0 };
            if let Some(track) = track.as_deref_mut() {
                track.push(segment(solved.unwrap_or_else(solve), to[2], P::distance_at));
            }
            if let Some(Landed { landing, .. }) = landed {
                let at = State { time: to[2], distance: P::distance_at(to[0]), speed: to[1], loss: to[3] };
                return Ok(path.arrive(landing, at, state, largest));
            }
            (node, rates) = (next.node, next.rates);
            h = (h * pace.min(5.0)).min(longest);
        }
    }

    /// Notes a rejected step; `h` is the length of the next one, which has to move something.
    fn rejected(&mut self, h: f64, node: &DraggedState, rates: &DraggedState) -> Result<f64, IntegrationError> {
        self.work.rejected += 1;
        let time = node[2];
        match () {
            () if !rates.iter().all(|rate| rate.is_finite()) => Err(IntegrationError::NotFinite { time }),
            () if node.iter().zip(rates).all(|(part, rate)| part + h * rate == *part) => {
                Err(IntegrationError::StepUnderflow { time, step: h })
            }
            () => Ok(h),
        }
    }

    /// Along any piece. On curves that begin without force r = d^(1/M): M = 4 where the drag goes with the stiffness, else 2.
    fn in_root<const M: u8>(
        &mut self,
        path: &Path,
        state: &mut State,
        track: Option<&mut Vec<Segment>>,
    ) -> Result<Arrival, IntegrationError> {
        let c = path.factor;
        match path.piece.shape {
            Shape::Straight { slope, .. } => {
                let piece = DraggedStraight::along(c * path.piece.force, c * slope, path);
                let Some(closed) = Oscillation::along(&piece, path.leg, *state) else {
                    return self.run(piece, path, state, track);
                };
                self.work = self.work + Effort { steps: 1, rejected: 0, force_evaluations: 1 };
                Ok(closed.land(path, state, track))
            }
            Shape::Power { stiffness, exponent: 1.5, .. } => {
                self.run(DraggedHertz::<M>::along(c * stiffness, path), path, state, track)
            }
            Shape::Polynomial(_) => self.run(AnyDragged::<1>(*path), path, state, track),
            Shape::Power { .. } | Shape::Branch(_) => self.run(AnyDragged::<M>(*path), path, state, track),
        }
    }
}

/// Why a leg did not end.
pub(super) fn out_of_steps(path: &Path) -> IntegrationError {
    let steps = MOST_STEPS;
    if path.drag == Drag::NONE {
        IntegrationError::TooManySteps { steps }
    } else {
        IntegrationError::Creeping { steps }
    }
}

/// A step that ends a little behind this one.
pub(super) fn step_beyond(step: f64) -> f64 {
    BEYOND * step
}

/// True if a sphere at rest at this state would be pushed on in the direction of the leg. Under strong drag the creep may be
/// slower than the error of a loose tolerance, so that a step ends with a speed of the wrong sign.
pub(super) fn is_false_turn<P: Dragged>(motion: P, path: &Path, landed: &Landed) -> bool {
    let (Landed { landing, node, .. }, sign) = (landed, path.leg.direction());
    let is_turn = *landing == Landing::Turning || *landing == Landing::End && sign * node[1] <= 0.0;
    is_turn && sign * motion.rates(node[0], 0.0)[1] > 0.0
}

/// The step that goes a little beyond this distance, for a speed and its rate of change; infinite if they do not lead there.
pub(super) fn step_to(distance: f64, speed: f64, rate: f64) -> f64 {
    let square = speed * speed + 2.0 * rate * distance;
    let pace = speed + square.sqrt();
    if distance > 0.0 && distance.is_finite() && square >= 0.0 && pace > 0.0 {
        step_beyond(2.0 * distance / pace)
    } else {
        f64::INFINITY
    }
}

/// True if a step to this node may have passed an event.
#[inline]
pub(super) fn may_end<P: Dragged>(path: &Path, end: f64, from: &DraggedState, to: &DraggedState) -> bool {
    let sign = path.leg.direction();
    if sign * to[1] <= 0.0 || sign * (end - to[0]) <= 0.0 || path.is_at_rest(P::distance_at(to[0]), to[1]) {
        return true;
    }
    // under a pull the force may vanish and come again within the step
    let growth = |node: &DraggedState| path.growth_of_force(P::distance_at(node[0]), node[1]);
    let may_dip = || path.pull > 0.0 && growth(from) < 0.0 && growth(to) > 0.0;
    path.can_lift_off() && (path.contact_force(P::distance_at(to[0]), to[1]) <= 0.0 || may_dip())
}

/// The continuous solution of a step as a function of the time.
pub(super) fn segment(solution: Continuous, end: f64, distance_at: fn(f64) -> f64) -> Segment {
    Segment::new(end, move |time| {
        let miss = |theta| {
            let (at, rate) = solution.part(2, theta);
            (time - at, -rate)
        };
        let is_near = |last: f64, next: f64| (next - last).abs() <= f64::EPSILON;
        let theta = bracketed((0.0, 1.0), 1.0, is_near, miss);
        let [y, speed, _, loss] = solution.at(theta);
        State { time, distance: distance_at(y), speed, loss }
    })
}

impl Integrator for DragStepper {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        track: Option<&mut Vec<Segment>>,
    ) -> Result<Arrival, IntegrationError> {
        if path.drag.eta == 0.0 { self.in_root::<2>(path, state, track) } else { self.in_root::<4>(path, state, track) }
    }

    fn work(&self) -> Effort {
        self.work
    }
}
