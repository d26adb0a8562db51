//! Our own stepper for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event.
//!
//! **Variables.** On a power law d'' = γ − k d^n − drag the force is not smooth at d = 0. With d = r^m and
//! dσ = dt/(m r^(m−1))
//!
//! ```text
//! r' = u,   u' = m r^(m−1) (γ − k r^(mn) − drag),   t' = m r^(m−1)        (' = d/dσ; u is the speed d' = dd/dt)
//! ```
//!
//! For n = 3/2 these are polynomials with m = 2, and with m = 4 where the drag goes with √g'(d), that is with d^¼. On a
//! straight piece m = 1: y = d and σ = t. The loss ∫ drag d' dt is integrated along.
//!
//! **Landing.** A step that has passed an event is taken again with the length that the cubic through both its ends gives,
//! and that length is mended by Newton's method on the step itself, whose derivative the rates are: two or three repeats.

use super::dop853::{self, EVALUATIONS, Quad};
use super::forced::{Drag, ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState};
use super::motions::{Hertz, Piece, Power, Straight, cubic_minimum};
use super::{IntegrationError, Leg, Restoring, Sampler, State, Work};
use crate::smooth::Variable;
use curves::{Curve, Plain, Rooted};

mod curves;

/// More steps than a leg needs unless its drag is hundreds of times beyond critical: explicit steps are no longer than the
/// fast decay, a creep lasts as long as the slow one, and their ratio goes with the square of the drag.
const MOST_STEPS: u64 = 1_000_000;

/// The part of the tolerance that one step may take: with it the ledger of a whole impact closes to ten times the tolerance.
const PART: f64 = 0.05;

/// The stepper.
#[derive(Debug, Clone)]
pub struct Damped {
    tolerance: f64,
    work: Work,
}

impl Damped {
    /// A stepper with this relative tolerance.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, work: Work::default() }
    }
}

/// What ends a leg, as a function that falls through zero there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Event {
    Turning,
    End,
    LiftOff,
}

/// A leg in the variables of its piece.
struct Run<'a, P> {
    piece: P,
    path: &'a ForcedPath,
    end: f64,
    /// +1 outward, −1 back.
    direction: f64,
    inverse_sizes: [f64; 3],
}

impl<P: Piece> Run<'_, P> {
    /// The function of an event and its derivative along σ.
    fn event(&self, event: Event, node: &Quad, rates: &Quad) -> (f64, f64) {
        match event {
            Event::End => (self.direction * (self.end - node[0]), -self.direction * rates[0]),
            Event::Turning => (self.direction * node[1], self.direction * rates[1]),
            Event::LiftOff => self.piece.contact(node, rates),
        }
    }

    fn step(&self, work: &mut Work, node: &Quad, rates: &Quad, h: f64) -> dop853::Step {
        work.force_evaluations += EVALUATIONS;
        dop853::step(self.piece, node, rates, h, &self.inverse_sizes)
    }

    /// The step from `node` that ends at `event`, which the step of length `h` to `passed` has passed.
    fn land(&self, work: &mut Work, event: Event, start: (&Quad, &Quad), passed: &dop853::Step, h: f64) -> (f64, Quad) {
        let (node, rates) = start;
        let (before, slope_before) = self.event(event, node, rates);
        let (after, slope_after) = self.event(event, &passed.node, &passed.rates);
        let length = h * cubic_root(before, slope_before * h, after, slope_after * h);
        self.mend(work, event, start, length, h)
    }

    /// Newton's method on the length of the step.
    fn mend(&self, work: &mut Work, event: Event, start: (&Quad, &Quad), mut length: f64, most: f64) -> (f64, Quad) {
        let size = match event {
            Event::End => self.end.abs().max(start.0[0].abs()),
            Event::Turning => start.0[1].abs(),
            Event::LiftOff => self.event(event, start.0, start.1).0.abs(),
        };
        let mut landed = *start.0;
        for _ in 0..12 {
            let next = self.step(work, start.0, start.1, length);
            landed = next.node;
            let (miss, slope) = self.event(event, &next.node, &next.rates);
            let change = miss / slope;
            if miss.abs() <= 4.0 * f64::EPSILON * size || !change.is_finite() || change.abs() <= 1e-15 * length {
                break;
            }
            let better = (length - change).clamp(0.0, most);
            if better == length {
                break;
            }
            length = better;
        }
        match event {
            Event::End => landed[0] = self.end,
            Event::Turning => landed[1] = 0.0,
            Event::LiftOff => {}
        }
        (length, landed)
    }

    /// A shorter step to where the contact force is gone, if it vanishes and comes again within the step: under gravity a
    /// sphere that hardly lifts off falls back.
    fn dip(&self, work: &mut Work, start: (&Quad, &Quad), next: &dop853::Step, h: f64) -> Option<(dop853::Step, f64)> {
        let (before, slope_before) = self.event(Event::LiftOff, start.0, start.1);
        let (after, slope_after) = self.event(Event::LiftOff, &next.node, &next.rates);
        let at = cubic_minimum(before, slope_before * h, after, slope_after * h)?;
        let dip = self.step(work, start.0, start.1, at * h);
        (self.event(Event::LiftOff, &dip.node, &dip.rates).0 <= 0.0).then_some((dip, at * h))
    }

    /// The first event that the step from `start` to `next` has passed, landed on.
    fn landing(
        &self,
        work: &mut Work,
        start: (&Quad, &Quad),
        next: &dop853::Step,
        h: f64,
    ) -> Option<(ForcedLanding, f64, Quad)> {
        let is_past = |event, step: &dop853::Step| self.event(event, &step.node, &step.rates).0 <= 0.0;
        let outward = self.direction > 0.0;
        if outward && is_past(Event::Turning, next) {
            let (length, turned) = self.land(work, Event::Turning, start, next, h);
            if turned[0] <= self.end {
                return Some((ForcedLanding::Turning, length, turned));
            }
            // the piece ends a little before the turning point: y_t − y = ½ |y''| τ²
            let pull = self.piece.rates(turned[0], 0.0)[1].abs();
            let tau = (2.0 * (turned[0] - self.end) / pull).sqrt();
            let (length, node) = self.mend(work, Event::End, start, (length - tau).max(0.0), length);
            return Some((ForcedLanding::End, length, node));
        }
        if !outward && self.path.can_lift_off() && is_past(Event::LiftOff, next) {
            let (length, node) = self.land(work, Event::LiftOff, start, next, h);
            return Some((ForcedLanding::LiftOff, length, node));
        }
        if !outward
            && self.path.can_lift_off()
            && let Some((dip, length)) = self.dip(work, start, next, h)
        {
            let (length, node) = self.land(work, Event::LiftOff, start, &dip, length);
            return Some((ForcedLanding::LiftOff, length, node));
        }
        if !outward && is_past(Event::Turning, next) {
            let (length, node) = self.land(work, Event::Turning, start, next, h);
            return Some((ForcedLanding::Turning, length, node));
        }
        if is_past(Event::End, next) {
            let (length, node) = self.land(work, Event::End, start, next, h);
            return Some((ForcedLanding::End, length, node));
        }
        let is_at_rest = self.path.is_at_rest(P::distance_at(next.node[0]), next.node[1]);
        is_at_rest.then_some((ForcedLanding::Rest, h, next.node))
    }

    /// Takes every sample due before the node at the end of a step of this length: by a shorter step of its own.
    fn sample(&self, work: &mut Work, samples: &mut Sampler, start: (&Quad, &Quad), length: f64, end: &Quad) {
        let (node, rates) = start;
        while let Some(time) = samples.due_before(end[2]) {
            // the clock goes with y^m, between straight and this power
            let part = (time - node[2]) / (end[2] - node[2]);
            let mut h = length * if node[0] == 0.0 { part.powf(1.0 / f64::from(P::ROOT)) } else { part };
            let mut at = *node;
            for _ in 0..30 {
                let next = self.step(work, node, rates, h);
                at = next.node;
                let change = (at[2] - time) / next.rates[2];
                let better = (h - change).clamp(0.0, length);
                if !change.is_finite() || change.abs() <= 1e-14 * length || better == h {
                    break;
                }
                h = better;
            }
            samples.take(State { time, distance: P::distance_at(at[0]), speed: at[1] });
            samples.losses.push(at[3]);
        }
    }
}

/// Where in (0, 1) the cubic with these values and slopes at both ends is zero; `before` > 0 ≥ `after`.
fn cubic_root(before: f64, slope_before: f64, after: f64, slope_after: f64) -> f64 {
    let at = |x: f64| {
        let y = 1.0 - x;
        let value =
            y * y * ((1.0 + 2.0 * x) * before + x * slope_before) + x * x * ((3.0 - 2.0 * x) * after - y * slope_after);
        let slope =
            6.0 * x * y * (after - before) + y * (1.0 - 3.0 * x) * slope_before + x * (3.0 * x - 2.0) * slope_after;
        (value, slope)
    };
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = if before > after { before / (before - after) } else { 1.0 };
    for _ in 0..60 {
        let (value, slope) = at(x);
        if value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= 1e-12 {
            return next;
        }
        x = next;
    }
    x
}

impl Damped {
    fn run<P: Piece>(
        &mut self,
        piece: P,
        path: &ForcedPath,
        state: &mut ForcedState,
        mut samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError> {
        let sizes = &path.path.sizes;
        let (end, direction) = match path.path.leg {
            Leg::Outward(end) => (P::y_at(end), 1.0),
            Leg::Back => (P::y_at(path.back_to), -1.0),
        };
        let size = P::y_at(sizes.distance);
        let inverse = |size: f64| 1.0 / (PART * self.tolerance * size);
        let inverse_sizes = [inverse(size), inverse(sizes.speed), inverse(sizes.speed * sizes.speed)];
        let run = Run { piece, path, end, direction, inverse_sizes };
        let begun = state.state;
        // from zero, so that a short leg late in time keeps its digits
        let mut node = [P::y_at(begun.distance), begun.speed, begun.time, state.loss];
        let mut rates = piece.rates(node[0], node[1]);
        self.work.force_evaluations += 1;
        if direction > 0.0 && begun.speed <= 0.0 {
            // the piece began where the sphere turned, to the last bit
            state.state.speed = 0.0;
            return Ok(ForcedLanding::Turning);
        }
        // a first step that the error control may still shrink; not beyond the end, where a short leg is slow to feel force
        let far = if direction > 0.0 { end.min(size.max(node[0])) } else { node[0] };
        let mut h = self.tolerance.powf(0.125) / piece.frequency(far);
        if node[1] > 0.0 && far > node[0] {
            h = h.min((far - node[0]) / node[1]);
        }
        for _ in 0..MOST_STEPS {
            let next = run.step(&mut self.work, &node, &rates, h);
            if next.error > 1.0 {
                self.work.rejected += 1;
                h *= (0.9 * next.error.powf(-0.125)).max(0.2);
                if h < f64::MIN_POSITIVE {
                    return Err(IntegrationError::StepUnderflow { time: node[2], step: h });
                }
                continue;
            }
            self.work.steps += 1;
            let landed = run.landing(&mut self.work, (&node, &rates), &next, h);
            let (length, to) = landed.map_or((h, next.node), |(_, length, node)| (length, node));
            if let Some(samples) = samples.as_deref_mut() {
                run.sample(&mut self.work, samples, (&node, &rates), length, &to);
            }
            if let Some((landing, ..)) = landed {
                let distance = match (landing, path.path.leg) {
                    (ForcedLanding::End, Leg::Outward(end)) => end,
                    (ForcedLanding::End, Leg::Back) => path.back_to,
                    _ => P::distance_at(to[0]),
                };
                *state = ForcedState { state: State { time: to[2], distance, speed: to[1] }, loss: to[3] };
                return Ok(landing);
            }
            (node, rates) = (next.node, next.rates);
            h *= (0.9 * next.error.powf(-0.125)).min(5.0);
        }
        Err(IntegrationError::Creeping { steps: MOST_STEPS })
    }
}

impl ForcedIntegrator for Damped {
    fn traverse(
        &mut self,
        path: &ForcedPath,
        state: &mut ForcedState,
        samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError> {
        let pull = path.pull;
        let (chi, eta) = match path.drag {
            Drag::None => (0.0, 0.0),
            Drag::OfForce(chi) => (chi, 0.0),
            Drag::OfStiffness(eta) => (0.0, eta),
        };
        match path.path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                self.run(Straight { a, b, chi, c: eta * b.sqrt(), pull }, path, state, samples)
            }
            Restoring::Power { coefficient: k, exponent: n } => {
                let c = eta * (k * n).sqrt();
                match (n == 1.5, eta == 0.0) {
                    (true, true) => self.run(Hertz::<2> { k, chi, c, pull }, path, state, samples),
                    (true, false) => self.run(Hertz::<4> { k, chi, c, pull }, path, state, samples),
                    (false, true) => self.run(Power::<2> { k, n, chi, c, pull }, path, state, samples),
                    (false, false) => self.run(Power::<4> { k, n, chi, c, pull }, path, state, samples),
                }
            }
            Restoring::Smooth { force, start, factor } => {
                let curve = Curve { force, start, factor, chi, eta, pull };
                match (force.variable(), eta == 0.0) {
                    (Variable::Indentation, _) => self.run(Plain(curve), path, state, samples),
                    (Variable::RootOfDistance, true) => self.run(Rooted::<2>(curve), path, state, samples),
                    (Variable::RootOfDistance, false) => self.run(Rooted::<4>(curve), path, state, samples),
                }
            }
        }
    }

    fn work(&self) -> Work {
        self.work
    }
}
