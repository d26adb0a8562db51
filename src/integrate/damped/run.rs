//! The run along one leg. It gives the length of the next step from its node, and decides what follows from a step of that
//! length. Error control and landing are here alone.
//!
//! ```text
//! march ── an event is passed ──► mend ── on the event ──► landed
//!   │ ▲                            ▲
//!   ▼ └── not: go on               │
//!  dip ── the force was gone ──────┘
//! ```

use crate::integrate::cubic::{cubic_minimum, cubic_root};
use crate::integrate::dop853::{EVALUATIONS, Step};
use crate::integrate::piece::{Dragged, Quad};
use crate::integrate::{Crossing, IntegrationError, Landing, MOST_STEPS, Path, State, Work};
use crate::math::functions::pow;

/// Repeats of a landing step.
const MOST_ROUNDS: u32 = 12;
/// Repeats of a step to a lift-off. Under weak damping, on a piece that is no power law, the contact force falls like a high
/// power of r until close to its zero. Each step of Newton's method then covers only a part of the remaining way.
const MOST_ROUNDS_TO_LIFT_OFF: u32 = 60;

/// Where Newton's method would change the length of a landing step by less than this times √tolerance, the end of the step is
/// moved along its rates and the step is not repeated. What that leaves out is 10⁻⁴ of the tolerance.
const NEAR: f64 = 1e-2;

/// The part of the tolerance that one step may take: with it the ledger of a whole impact closes to ten times the tolerance.
const PART: f64 = 0.05;

/// The least share of the error of order 5 that counts as the error of a step.
///
/// The pair estimates the error by e5²/e3, which assumes that both errors have the same leading terms. Near r = 0 this does
/// not hold: a weak pull or drag enters with a low power of r, which order 3 misses, and the force with the ninth power,
/// which both miss.
/// Without a least share the error was up to 3000 times the estimate there, and the ledger of one impact in 10⁵ closed to
/// 40 times the tolerance. This share goes with the square of the step, as e5²/e3 does on a smooth motion, so that the steps
/// of smooth motions stay as they are.
pub fn least_share(tolerance: f64) -> f64 {
    2.0 * (PART * tolerance).sqrt().sqrt()
}

/// What the next step is for.
#[derive(Debug, Clone, Copy)]
enum Aim {
    /// To go on.
    March,
    /// To see whether the contact force is gone within a step of length `h` to `next`.
    Dip { next: Step, h: f64, verdict: Verdict },
    /// To end on an event, not farther than `most`.
    Mend { event: Crossing, size: f64, most: f64, rounds: u32 },
}

/// The judgement of a step by the error control.
#[derive(Debug, Clone, Copy)]
pub struct Verdict {
    /// The error over its limit; at most 1 if the step is accepted.
    pub error: f64,
    /// The length of the next one in units of this one's: 0.9 error^(−1/8), before it is bounded.
    pub pace: f64,
}

impl Verdict {
    /// Of a step that is not under error control.
    pub const NONE: Self = Self { error: 0.0, pace: 1.0 };

    #[inline(always)]
    pub fn of(step: &Step, h: f64, least: f64) -> Self {
        let error = step.error(h, least);
        Self { error, pace: Self::pace(error) }
    }

    #[inline(always)]
    pub fn pace(error: f64) -> f64 {
        0.9 * pow(error, -0.125)
    }
}

/// What follows from a step.
#[derive(Debug, Clone, Copy)]
pub enum Progress {
    /// Another step from the same node is to be taken.
    Again,
    /// The node is the end of a step of this length.
    Moved { length: f64 },
    /// The leg has ended, after a step of this length.
    Landed { landing: Landing, length: f64, state: State },
}

/// A leg on its way, in the variables of its piece.
#[derive(Debug, Clone, Copy)]
pub struct Run {
    pub node: Quad,
    pub rates: Quad,
    /// Of the next step.
    pub length: f64,
    pub inverse_sizes: [f64; 3],
    /// See [`least_share`].
    pub least: f64,
    tolerance: f64,
    pub work: Work,
    aim: Aim,
    end: f64,
    /// +1 outward, −1 back.
    direction: f64,
    path: Path,
}

impl Run {
    /// A run at its first node; `None` for an outward leg without speed, which has turned already.
    pub fn begin<P: Dragged>(piece: P, path: &Path, begun: &State, tolerance: f64) -> Option<Self> {
        let sizes = &path.sizes;
        let (end, direction) = (P::y_at(path.leg.end()), path.leg.direction());
        let size = P::y_at(sizes.distance);
        let inverse = |size: f64| 1.0 / (PART * tolerance * size);
        let inverse_sizes = [inverse(size), inverse(sizes.speed), inverse(sizes.speed * sizes.speed)];
        let State { time, distance, speed, loss } = *begun;
        // from zero, so that a short leg late in time keeps its digits
        let node = [P::y_at(distance), speed, time, loss];
        if direction > 0.0 && speed <= 0.0 {
            return None;
        }
        // a first step that the error control may still shrink. It does not go beyond the end: on a short leg the force may be
        // too weak to limit it
        let far = if direction > 0.0 { end.min(size.max(node[0])) } else { node[0] };
        let mut length = pow(tolerance, 0.125) / piece.frequency(far);
        if node[1] > 0.0 && far > node[0] {
            length = length.min((far - node[0]) / node[1]);
        }
        let rates = piece.rates(node[0], node[1]);
        let work = Work { force_evaluations: 1, ..Work::default() };
        let least = least_share(tolerance);
        let (aim, path) = (Aim::March, *path);
        Some(Self { node, rates, length, inverse_sizes, least, tolerance, work, aim, end, direction, path })
    }

    /// Whether the next step is under error control: others need no verdict.
    #[inline(always)]
    pub fn is_marching(&self) -> bool {
        matches!(self.aim, Aim::March)
    }

    /// Decides what follows from a step of [`Run::length`] from the node.
    #[inline]
    pub fn tell<P: Dragged>(&mut self, piece: P, next: &Step, verdict: Verdict) -> Result<Progress, IntegrationError> {
        self.work.force_evaluations += EVALUATIONS;
        match self.aim {
            Aim::March => self.marched(piece, next, verdict),
            Aim::Dip { next: passed, h, verdict } => {
                self.aim = Aim::March;
                if self.is_past(piece, Crossing::LiftOff, next) {
                    return Ok(self.land(piece, Crossing::LiftOff, next, self.length));
                }
                Ok(self.go_on(piece, &passed, h, verdict))
            }
            Aim::Mend { event, size, most, rounds } => Ok(self.mended(piece, next, event, size, most, rounds)),
        }
    }

    /// The function whose zero a landing on an event searches, and its derivative along σ.
    fn aimed<P: Dragged>(&self, piece: P, event: Crossing, node: &Quad, rates: &Quad) -> (f64, f64) {
        if event == Crossing::LiftOff { piece.lift_off(node, rates) } else { self.event(piece, event, node, rates) }
    }

    /// The function of an event and its derivative along σ.
    #[inline(always)]
    fn event<P: Dragged>(&self, piece: P, event: Crossing, node: &Quad, rates: &Quad) -> (f64, f64) {
        match event {
            Crossing::End => (self.direction * (self.end - node[0]), -self.direction * rates[0]),
            Crossing::Turning => (self.direction * node[1], self.direction * rates[1]),
            Crossing::LiftOff => piece.contact(node, rates),
        }
    }

    fn is_past<P: Dragged>(&self, piece: P, event: Crossing, step: &Step) -> bool {
        self.event(piece, event, &step.node, &step.rates).0 <= 0.0
    }

    /// A step under error control: rejected, or the first event that it has passed is landed on.
    #[inline(always)]
    fn marched<P: Dragged>(&mut self, piece: P, next: &Step, verdict: Verdict) -> Result<Progress, IntegrationError> {
        if self.work.steps + self.work.rejected >= MOST_STEPS {
            return Err(IntegrationError::Creeping { steps: MOST_STEPS });
        }
        let h = self.length;
        // NaN where a stage left the range of a formula: a shorter step may stay inside
        if verdict.error > 1.0 || verdict.error.is_nan() {
            self.work.rejected += 1;
            self.length = h * verdict.pace.max(0.2);
            if self.length < f64::MIN_POSITIVE && !self.rates.iter().all(|rate| rate.is_finite()) {
                return Err(IntegrationError::NotFinite { time: self.node[2] });
            }
            if self.length < f64::MIN_POSITIVE {
                return Err(IntegrationError::StepUnderflow { time: self.node[2], step: self.length });
            }
            return Ok(Progress::Again);
        }
        self.work.steps += 1;
        if self.direction > 0.0 {
            if self.is_past(piece, Crossing::Turning, next) {
                return Ok(self.land(piece, Crossing::Turning, next, h));
            }
        } else if self.path.can_lift_off() {
            let (after, slope_after) = self.event(piece, Crossing::LiftOff, &next.node, &next.rates);
            if after <= 0.0 {
                return Ok(self.land(piece, Crossing::LiftOff, next, h));
            }
            // a shorter step to where the contact force is gone, if it vanishes and comes again within the step: under
            // gravity a sphere that hardly lifts off falls back
            let (before, slope_before) = self.event(piece, Crossing::LiftOff, &self.node, &self.rates);
            if let Some(at) = cubic_minimum(before, slope_before * h, after, slope_after * h) {
                (self.aim, self.length) = (Aim::Dip { next: *next, h, verdict }, at * h);
                return Ok(Progress::Again);
            }
        }
        Ok(self.go_on(piece, next, h, verdict))
    }

    /// Looks for the other events; the motion goes on from the end of the step if it has passed none.
    #[inline(always)]
    fn go_on<P: Dragged>(&mut self, piece: P, next: &Step, h: f64, verdict: Verdict) -> Progress {
        if self.direction < 0.0 && self.is_past(piece, Crossing::Turning, next) {
            return self.land(piece, Crossing::Turning, next, h);
        }
        if self.is_past(piece, Crossing::End, next) {
            return self.land(piece, Crossing::End, next, h);
        }
        if self.path.is_at_rest(P::distance_at(next.node[0]), next.node[1]) {
            return self.landed::<P>(Landing::Rest, h, &next.node);
        }
        (self.node, self.rates) = (next.node, next.rates);
        self.length = longer(h, verdict.pace);
        Progress::Moved { length: h }
    }

    /// Whether a turning point found at y is false, because a sphere at rest there would be pushed on. Under strong drag a
    /// creep is slower than the error that a loose tolerance allows, and a step may end with a speed of the wrong sign.
    fn is_false_turn<P: Dragged>(&self, piece: P, y: f64) -> bool {
        self.direction * piece.rates(y, 0.0)[1] > 0.0 && !self.path.is_next_to_rest(P::distance_at(y), self.tolerance)
    }

    /// Repeats an accepted step of length `h` with half its length.
    fn take_back(&mut self, h: f64) -> Progress {
        self.work.steps -= 1;
        self.work.rejected += 1;
        (self.aim, self.length) = (Aim::March, 0.5 * h);
        Progress::Again
    }

    /// A first guess of the step that ends at `event`, which the step of length `h` to `passed` has passed.
    #[inline(never)]
    fn land<P: Dragged>(&mut self, piece: P, event: Crossing, passed: &Step, h: f64) -> Progress {
        let (before, slope_before) = self.aimed(piece, event, &self.node, &self.rates);
        let (after, slope_after) = self.aimed(piece, event, &passed.node, &passed.rates);
        let length = h * cubic_root(before, slope_before * h, after, slope_after * h);
        self.mend(piece, event, length, h)
    }

    fn mend<P: Dragged>(&mut self, piece: P, event: Crossing, length: f64, most: f64) -> Progress {
        let size = match event {
            Crossing::End => self.end.abs().max(self.node[0].abs()),
            Crossing::Turning => self.node[1].abs(),
            Crossing::LiftOff => self.aimed(piece, event, &self.node, &self.rates).0.abs(),
        };
        (self.aim, self.length) = (Aim::Mend { event, size, most, rounds: 1 }, length);
        Progress::Again
    }

    /// Newton's method on the length of the step.
    #[inline(never)]
    fn mended<P: Dragged>(
        &mut self,
        piece: P,
        next: &Step,
        event: Crossing,
        size: f64,
        most: f64,
        rounds: u32,
    ) -> Progress {
        let (miss, slope) = self.aimed(piece, event, &next.node, &next.rates);
        let change = miss / slope;
        let is_there = miss.abs() <= 4.0 * f64::EPSILON * size || !change.is_finite();
        let is_near = !is_there && change.abs() <= NEAR * self.tolerance.sqrt() * self.length;
        if !is_there && !is_near {
            let better = (self.length - change).clamp(0.0, most);
            let is_better = better != self.length;
            self.length = better;
            let most_rounds = if event == Crossing::LiftOff { MOST_ROUNDS_TO_LIFT_OFF } else { MOST_ROUNDS };
            if is_better && rounds < most_rounds {
                self.aim = Aim::Mend { event, size, most, rounds: rounds + 1 };
                return Progress::Again;
            }
        }
        let (mut length, mut to) = (self.length, next.node);
        if is_near {
            length -= change;
            for (part, rate) in to.iter_mut().zip(next.rates) {
                *part -= change * rate;
            }
        }
        let landing = match event {
            Crossing::End if self.direction * to[1] <= 0.0 && self.is_false_turn(piece, self.end) => {
                return self.take_back(most);
            }
            Crossing::End => {
                to[0] = self.end;
                Landing::End
            }
            Crossing::Turning if self.is_false_turn(piece, to[0]) => return self.take_back(most),
            Crossing::Turning => {
                to[1] = 0.0;
                if self.direction < 0.0 || to[0] <= self.end {
                    Landing::Turning
                } else {
                    // the piece ends a little before the turning point: y_t − y = ½ |y''| τ²
                    let pull = piece.rates(to[0], 0.0)[1].abs();
                    let tau = (2.0 * (to[0] - self.end) / pull).sqrt();
                    return self.mend(piece, Crossing::End, (length - tau).max(0.0), length);
                }
            }
            Crossing::LiftOff => Landing::LiftOff,
        };
        self.landed::<P>(landing, length, &to)
    }

    fn landed<P: Dragged>(&self, landing: Landing, length: f64, to: &Quad) -> Progress {
        let distance = self.path.landed_at(landing, P::distance_at(to[0]));
        let state = State { time: to[2], distance, speed: to[1], loss: to[3] };
        Progress::Landed { landing, length, state }
    }
}

/// The next step after one of length `h` that was accepted.
#[inline(always)]
pub fn longer(h: f64, pace: f64) -> f64 {
    h * pace.min(5.0)
}
