//! The contact of Mindlin and Deresiewicz in its one-dimensional form (MDR): springs along the radius, each with its own
//! Coulomb stop.
//!
//! The friction follows the normal motion, from which it needs force f, radius α and time. With σ = 4γ s/μ in place of the slip
//! speed s, T in units of μ, and springs at 0 < ξ < α:
//!
//! ```text
//! stop      φ(ξ) = (3/2) (f/α) (1 − ξ²/α²)                  (∫ φ dξ = f)
//! spring    ζ' = (3/2) σ, clipped to |ζ| ≤ φ;  0 outside of the contact, from the time on at which the rim passes ξ
//! sphere    σ' = (5/2) χ T,   T = −∫₀^α ζ dξ
//! ```
//!
//! So an impact depends on σ_0 and χ alone. For Hertz this is the theory of Mindlin and Deresiewicz (Jäger 1993; Popov and Heß,
//! *Method of Dimensionality Reduction*, 2015), which Maw, Barber and Fawcett (1976), Wear 38, 101-114, solve numerically. With
//! plasticity it is an extension: the pressure has Hertz's shape, with the force and the radius of the law. It creates no energy.
//!
//! The displacement of the springs is exact in space (`profile.rs`). In time, with the shift M' = (3/2) σ of a spring that sticks,
//! M'' = (15/4) χ T is integrated by Nyström's method of order 4 in two stages, whose second stage is the first stage of the next
//! step. Two half steps are compared with a whole step, and the difference improves them. A step ends where T has a kink
//! (`kinks.rs`).

use super::kinks::{first_kink, parabola_slopes, sliding_share};
use super::normal_motion::NormalMotion;
use super::profile::{NormalState, SpringProfile};
use super::slip_result::{Friction, SlipResult, SlipStep};
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::numerics::ode::IntegrationError;

/// The state of a run.
#[derive(Debug, Clone)]
struct TangentialState {
    profile: SpringProfile,
    rim: NormalState,
    /// M', where M is the shift of the profile.
    speed: f64,
    /// M''.
    acceleration: f64,
    /// M''' at the end of the last step.
    jerk: f64,
}

impl TangentialState {
    /// One step over the middle to the end. M'' = `rate` T. Returns T at start, middle and end.
    fn step(&mut self, middle: NormalState, end: NormalState, rate: f64) -> [f64; 3] {
        let length = end.time - self.rim.time;
        let (half, first) = (0.5 * length, self.acceleration);
        // η is a parabola over the step
        let of_square = 4.0 * (end.square - 2.0 * middle.square + self.rim.square) / (length * length);
        let bend = |from: f64, to: f64, speed: f64, acceleration: f64| {
            let growth = (to - from) / half;
            let curved = -0.5 * (acceleration - speed * of_square / growth) / (growth * growth);
            if growth > 0.0 { curved } else { 0.0 }
        };
        let rims = [&self.rim, &middle, &end];
        let [stops, squares] = [rims.map(|rim| rim.coulomb_limit), rims.map(|rim| rim.square)].map(parabola_slopes);
        let fronts = |i: usize, speed: f64| {
            let NormalState { coulomb_limit: stop, square, .. } = rims[i];
            let fall = stop / square;
            let of_fall = (stops[i] - fall * squares[i]) / square;
            [1.0, -1.0].map(|side| (stops[i] - side * speed * length) / of_fall)
        };
        let way = half * (self.speed + half * (0.5 * first + half * self.jerk / 6.0));
        let bent = bend(self.rim.square, middle.square, self.speed + 0.5 * half * first, first);
        let speed = self.speed + half * (first + 0.5 * half * self.jerk);
        let second = rate * self.profile.advance([&self.rim, &middle], way, bent, fronts(1, speed));
        let whole = length * (self.speed + length * (first + 2.0 * second) / 6.0);
        let bent = bend(middle.square, end.square, self.speed + 1.5 * half * second, second);
        let speed = self.speed + length * second;
        let third = rate * self.profile.advance([&middle, &end], whole - way, bent, fronts(2, speed));
        self.speed += length * (first + 4.0 * second + third) / 6.0;
        self.acceleration = third;
        self.jerk = parabola_slopes([first, second, third])[2] / length;
        self.rim = end;
        [first / rate, second / rate, third / rate]
    }

    /// M' at start, middle and end of a step in which all springs are at their stops on this side. T then equals the contact force,
    /// whose impulse is known.
    fn sliding_speeds(&self, rims: &[NormalState; 5], side: f64, rate: f64) -> [f64; 3] {
        [rims[0], rims[2], rims[4]].map(|rim| self.speed - side * rate * (rim.impulse - self.rim.impulse))
    }

    /// Slides over a step with all springs at their stops on this side.
    fn slide(&mut self, rims: &[NormalState; 5], side: f64, rate: f64) {
        let [.., speed] = self.sliding_speeds(rims, side, rate);
        let friction = [rims[0], rims[2], rims[4]].map(|rim| -side * rate * rim.force());
        self.profile.slide(&rims[4], side);
        (self.speed, self.acceleration) = (speed, friction[2]);
        self.jerk = parabola_slopes(friction)[2] / (rims[4].time - rims[0].time);
        self.rim = rims[4];
    }

    /// M' and M.
    fn motion(&self) -> [f64; 2] {
        [self.speed, self.profile.shift]
    }

    /// How far this state differs from another, in M', M and M''.
    fn difference(&self, other: &Self) -> [f64; 3] {
        let [speed, shift] = [0, 1].map(|part| self.motion()[part] - other.motion()[part]);
        [speed, shift, self.acceleration - other.acceleration]
    }

    /// Improves two half steps by their difference to a whole step.
    fn extrapolate(&mut self, [speed, shift, acceleration]: [f64; 3]) {
        self.speed += speed;
        self.profile.shift += shift;
        self.acceleration += acceleration;
    }

    fn clone_from_state(&mut self, from: &Self) {
        self.profile.clone_from(&from.profile);
        (self.rim, self.speed, self.acceleration, self.jerk) = (from.rim, from.speed, from.acceleration, from.jerk);
    }
}

impl NormalMotion<'_> {
    /// The phase angle \[rad\] of a contact that sticks, at its largest stiffness: ω² = (15/4) χ α.
    pub(super) fn phase_angle(&self, chi: f64) -> f64 {
        let largest = self.state_at(self.durations[0]).square.sqrt();
        (3.0 * FORCE_FACTOR * chi * largest).sqrt() * self.durations[1]
    }

    /// σ_1/σ_0 to about this accuracy.
    pub fn ratio(&self, sigma: f64, chi: f64, accuracy: f64) -> Result<f64, IntegrationError> {
        self.run(sigma, chi, accuracy, false).map(|run| run.ratio)
    }

    /// The change of σ to about this accuracy.
    pub(super) fn run(
        &self,
        sigma: f64,
        chi: f64,
        accuracy: f64,
        has_steps: bool,
    ) -> Result<SlipResult, IntegrationError> {
        let mut run = SlipRun::new(self, sigma, chi, accuracy, has_steps);
        let peak = self.durations[0];
        for &end in &self.smooth_ends {
            let distance = (end - run.state.rim.time).min(peak - end);
            if end >= peak || distance >= run.min_piece {
                run.advance_to(end)?;
            }
        }
        let ratio = run.state.speed / run.first_speed;
        let SlipRun { error, is_sliding, steps, .. } = run;
        Ok(SlipResult { ratio, error, is_sliding, end: self.durations[1], steps: steps.unwrap_or_default() })
    }
}

/// The longest step and the first step, as fractions of half the contact time.
const MAX_STEP: f64 = 0.3;
const FIRST_STEP: f64 = 0.01;
/// Two half steps are compared with a whole step, and the difference improves them. This fraction of the difference is the
/// estimate of the error that remains.
const REMAINING_ERROR_SHARE: f64 = 0.12;
/// The fraction of the accuracy that every step may use, however short it is.
const MIN_STEP_ACCURACY_SHARE: f64 = 0.02;
/// The fraction of the accuracy that is allowed as the error of a piece of the profile.
const MERGE_ACCURACY_SHARE: f64 = 0.2;
/// Maximum number of steps of a run.
const MAX_STEPS: u64 = 50_000;

/// A run along the normal motion, from first contact on.
struct SlipRun<'a> {
    motion: &'a NormalMotion<'a>,
    /// (3/2) σ_0: M' at first contact.
    first_speed: f64,
    /// (15/4) χ: M'' over T.
    rate: f64,
    accuracy: f64,
    /// Half the contact time.
    duration: f64,
    /// A kink that is nearer to the end of a step costs less than the accuracy allows.
    near: f64,
    /// A joint of the law that is nearer to the joint before costs less than the accuracy allows.
    min_piece: f64,
    /// The error that is allowed in a piece of the profile.
    merge_error: f64,
    state: TangentialState,
    /// The state after a whole step, and after two half steps.
    trial_states: [TangentialState; 2],
    /// The length of the next step.
    length: f64,
    count: u64,
    /// The sum of the errors of the steps.
    error: f64,
    is_sliding: bool,
    /// The steps, if they are requested.
    steps: Option<Vec<SlipStep>>,
}

impl<'a> SlipRun<'a> {
    fn new(motion: &'a NormalMotion<'a>, sigma: f64, chi: f64, accuracy: f64, has_steps: bool) -> Self {
        // behind a jump a step is of first order, and the improved half steps have a larger error
        let accuracy = if motion.has_limit_jumps || !motion.is_smooth_at_touch { 0.2 * accuracy } else { accuracy };
        let (first_speed, rate) = (1.5 * sigma, 1.5 * 2.0 * FORCE_FACTOR * chi);
        let (rim, profile) = (motion.state_at(0.0), SpringProfile::new());
        let state = TangentialState { profile, rim, speed: first_speed, acceleration: 0.0, jerk: 0.0 };
        let [peak, last] = motion.durations;
        let duration = 0.5 * last;
        // on a plate or rod the sphere arrives fast and separates slowly
        let quick = duration.min(peak);
        let largest_radius = motion.state_at(peak).square.sqrt();
        Self {
            motion,
            first_speed,
            rate,
            accuracy,
            duration,
            near: 0.025 * accuracy.sqrt() * quick,
            min_piece: 0.3 * accuracy.sqrt().sqrt() * quick,
            merge_error: MERGE_ACCURACY_SHARE * accuracy * first_speed / (rate * largest_radius * duration),
            trial_states: [state.clone(), state.clone()],
            state,
            length: FIRST_STEP * quick,
            count: 0,
            error: 0.0,
            is_sliding: true,
            steps: has_steps.then(Vec::new),
        }
    }

    /// Steps to this time, until which the normal motion is smooth.
    fn advance_to(&mut self, end: f64) -> Result<(), IntegrationError> {
        while self.state.rim.time < end {
            self.count += 1;
            if self.count > MAX_STEPS {
                return Err(IntegrationError::TooManyFrictionSteps { steps: MAX_STEPS });
            }
            let rims = self.next_rims(end);
            if !self.try_sliding_step(&rims) {
                self.try_step(&rims);
            }
        }
        Ok(())
    }

    /// The normal motion at the start, the quarters and the end of the next step, which does not pass this time.
    fn next_rims(&mut self, end: f64) -> [NormalState; 5] {
        let at = self.state.rim.time;
        let left = end - at;
        self.length = self.length.min(MAX_STEP * self.duration);
        let is_last = self.length >= left * (1.0 - 1e-9);
        self.length = if is_last { left } else { self.length.min(0.5 * left) };
        let [first, second, third] = [0.25, 0.5, 0.75].map(|share| self.motion.state_at(at + share * self.length));
        let to = if is_last { end } else { at + self.length };
        [self.state.rim, first, second, third, self.motion.state_at(to)]
    }

    /// Makes a step if all springs slip, or shortens the next step to the time until which they slip. Returns false if they stick.
    fn try_sliding_step(&mut self, rims: &[NormalState; 5]) -> bool {
        let NormalState { time, coulomb_limit, impulse, .. } = rims[0];
        let side = match time {
            0.0 => self.motion.is_smooth_at_touch.then_some(1.0),
            _ => self.state.profile.slip_side(coulomb_limit),
        };
        let Some(side) = side.filter(|_| !self.motion.has_limit_jumps) else { return false };
        let step = self.step_from(time, self.length, self.state.speed, Friction::Sliding { side, impulse });
        let share = self.sliding_share_of_step(rims, side);
        if share == 1.0 {
            self.state.slide(rims, side, self.rate);
            if let Some(steps) = &mut self.steps {
                steps.push(step);
            }
            self.length = MAX_STEP * self.duration;
            return true;
        }
        let slips = share * self.length > self.near;
        if slips {
            self.length *= share;
        }
        slips
    }

    /// The share of a step up to which all springs slip to this side.
    fn sliding_share_of_step(&self, rims: &[NormalState; 5], side: f64) -> f64 {
        let is_last = rims[4].time >= self.motion.durations[1];
        let speeds = self.state.sliding_speeds(rims, side, self.rate);
        let (share, length) = (sliding_share(rims, speeds, side, is_last), rims[4].time - rims[0].time);
        // a short rest of a longer step slides too; in a step that is as short as the rest, nothing says that the springs slide
        if share * length > self.near && (1.0 - share) * length <= self.near { 1.0 } else { share }
    }

    /// Makes a step in which springs stick, as two half steps, if a kink or the error does not shorten it. Sets the length of the next step.
    fn try_step(&mut self, rims: &[NormalState; 5]) {
        self.is_sliding = false;
        let [whole, halves] = &mut self.trial_states;
        halves.clone_from_state(&self.state);
        let first = halves.step(rims[1], rims[2], self.rate);
        let middle = halves.motion();
        let second = halves.step(rims[3], rims[4], self.rate);
        let motion = [self.state.motion(), middle, halves.motion()];
        if let Some(share) = first_kink(rims, motion, self.state.profile.central_stretch(), self.near) {
            self.length *= share;
            return;
        }
        whole.clone_from_state(&self.state);
        whole.step(rims[2], rims[4], self.rate);
        let difference = halves.difference(whole);
        let error = self.error_of(difference, &rims[4]);
        let last = self.motion.durations[1];
        let tolerance = self.accuracy * (self.length / last + MIN_STEP_ACCURACY_SHARE);
        if error <= tolerance || self.length < 1e-7 * self.duration {
            let half = 0.5 * self.length;
            let steps = [
                self.step_from(rims[0].time, half, self.state.speed, Friction::Partial(first)),
                self.step_from(rims[2].time, half, middle[0], Friction::Partial(second)),
            ];
            if let Some(made) = &mut self.steps {
                made.extend(steps);
            }
            self.error += error;
            let halves = &mut self.trial_states[1];
            halves.extrapolate(difference.map(|part| part / 15.0));
            std::mem::swap(&mut self.state, halves);
            self.state.profile.merge_pieces(self.merge_error);
        }
        self.length *= (0.9 * (tolerance / error).sqrt().sqrt()).clamp(0.2, 3.0);
    }

    /// The error of σ_1/σ_0 that remains after two half steps, from their difference to a whole step.
    fn error_of(&self, difference: [f64; 3], end: &NormalState) -> f64 {
        // an error of the force acts for one oscillation at most
        let swing = (self.rate * end.square.sqrt()).sqrt().recip();
        let weights = [1.0, self.duration.recip(), swing.min(self.motion.durations[1] - end.time)];
        let error: f64 = difference.iter().zip(weights).map(|(part, weight)| part.abs() * weight).sum();
        REMAINING_ERROR_SHARE * error / self.first_speed.abs()
    }

    /// The step with this friction, for the trace.
    fn step_from(&self, start: f64, length: f64, speed: f64, friction: Friction) -> SlipStep {
        SlipStep { start, length, slip: speed / self.first_speed, rate: self.rate / self.first_speed, friction }
    }
}
