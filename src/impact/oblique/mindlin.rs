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
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::numerics::ode::IntegrationError;

/// The change of the slip speed.
#[derive(Debug)]
pub(in crate::impact) struct SlipResult {
    /// σ_1/σ_0, which is s_1/s_0.
    pub(super) ratio: f64,
    /// Its error: the sum of the errors of the steps.
    pub(super) error: f64,
    /// True if the contact point slides during the whole contact.
    pub(super) is_sliding: bool,
    /// The time of its end.
    pub(super) end: f64,
    /// The steps, in order of time; empty if they are not requested or not needed.
    pub(super) steps: Vec<SlipStep>,
}

/// A step of a run, for its trace.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipStep {
    start: f64,
    length: f64,
    /// σ/σ_0 at the start.
    slip: f64,
    /// (5/2) χ/σ_0: what T changes of σ/σ_0.
    rate: f64,
    friction: Friction,
}

/// T during a step.
#[derive(Debug, Clone, Copy)]
enum Friction {
    /// T equals the contact force, and acts against a slip to this side. `impulse` is the impulse at the start.
    Sliding { side: f64, impulse: f64 },
    /// T at start, middle and end, interpolated by a parabola.
    Partial([f64; 3]),
}

impl SlipStep {
    /// σ/σ_0 and T at a time of the step, where the contact has this force and this impulse so far.
    fn slip_and_force(&self, time: f64, force: f64, impulse: f64) -> [f64; 2] {
        match self.friction {
            Friction::Sliding { side, impulse: before } => {
                [self.slip - side * self.rate * (impulse - before), -side * force]
            }
            Friction::Partial([a, b, c]) => {
                let z = ((time - self.start) / self.length).clamp(0.0, 1.0);
                let (slope, curve) = (-3.0 * a + 4.0 * b - c, 2.0 * (a - 2.0 * b + c));
                let way = z * (a + z * (0.5 * slope + z * curve / 3.0));
                [self.slip + self.rate * self.length * way, a + z * (slope + z * curve)]
            }
        }
    }
}

impl SlipResult {
    /// A change that is known without steps.
    pub(super) fn without_steps(ratio: f64, is_sliding: bool) -> Self {
        Self { ratio, error: 0.0, is_sliding, end: 0.0, steps: Vec::new() }
    }

    /// The change from a smaller σ_0, in this ratio to the σ_0 of the run. Both are so small that springs slip only at the rim, so σ is
    /// proportional to σ_0.
    pub(super) fn scale_by(mut self, share: f64) -> Self {
        for step in &mut self.steps {
            if let Friction::Partial(friction) = &mut step.friction {
                *friction = friction.map(|part| part * share);
                step.rate /= share;
            }
        }
        self
    }

    /// σ/σ_0 and T at a time, where the contact has this force and this impulse so far.
    pub(super) fn slip_and_force(&self, time: f64, force: f64, impulse: f64) -> [f64; 2] {
        let step = self.steps.partition_point(|step| step.start <= time).saturating_sub(1);
        self.steps.get(step).map_or([self.ratio, 0.0], |step| step.slip_and_force(time, force, impulse))
    }
}

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

    /// Slides over the middle to the end with all springs at their stops on this side, if they keep slipping; otherwise returns the
    /// fraction of the step up to which they slip. T then equals the contact force, whose impulse is known.
    fn slide(&mut self, rims: &[NormalState; 5], side: f64, rate: f64, near: f64) -> f64 {
        let ends = [rims[0], rims[2], rims[4]];
        let speeds = ends.map(|rim| self.speed - side * rate * (rim.impulse - self.rim.impulse));
        let (share, length) = (sliding_share(rims, speeds, side), rims[4].time - rims[0].time);
        // a short rest of a longer step slides too; in a step that is as short as the rest, nothing says that the springs slide
        let share = if share * length > near && (1.0 - share) * length <= near { 1.0 } else { share };
        if share == 1.0 {
            self.profile.slide(&rims[4], side);
            let friction = ends.map(|rim| -side * rate * rim.force());
            (self.speed, self.acceleration) = (speeds[2], friction[2]);
            self.jerk = parabola_slopes(friction)[2] / length;
            self.rim = rims[4];
        }
        share
    }

    /// M' and M.
    fn motion(&self) -> [f64; 2] {
        [self.speed, self.profile.shift]
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
        // behind a jump a step is of first order, and the improved half steps have a larger error
        let accuracy = if self.has_limit_jumps || !self.is_smooth_at_touch { 0.2 * accuracy } else { accuracy };
        let rate = 1.5 * 2.0 * FORCE_FACTOR * chi;
        let start = 1.5 * sigma;
        let rim = self.state_at(0.0);
        let mut state =
            TangentialState { profile: SpringProfile::new(), rim, speed: start, acceleration: 0.0, jerk: 0.0 };
        let (mut whole, mut halves) = (state.clone(), state.clone());
        let (mut steps, mut sum, mut is_sliding) = (Vec::new(), 0.0, true);
        let [peak, last] = self.durations;
        let duration = 0.5 * last;
        // on a plate or rod the sphere arrives fast and separates slowly
        let quick = duration.min(peak);
        let mut length = FIRST_STEP * quick;
        // a kink that is nearer to the end of a step costs less than allowed, and so does a joint that is nearer to the joint before
        let near = 0.025 * accuracy.sqrt() * quick;
        let apart = 0.3 * accuracy.sqrt().sqrt() * quick;
        let joined = MERGE_ACCURACY_SHARE * accuracy * start / (rate * self.state_at(peak).square.sqrt() * duration);
        let mut count = 0;
        for &end in &self.smooth_ends {
            if end < peak && (end - state.rim.time).min(peak - end) < apart {
                continue;
            }
            while state.rim.time < end {
                count += 1;
                if count > MAX_STEPS {
                    return Err(IntegrationError::TooManyFrictionSteps { steps: MAX_STEPS });
                }
                let left = end - state.rim.time;
                length = length.min(MAX_STEP * duration);
                let is_last = length >= left * (1.0 - 1e-9);
                length = if is_last { left } else { length.min(0.5 * left) };
                let at = state.rim.time;
                let to = if is_last { end } else { at + length };
                let [first, second, third] = [0.25, 0.5, 0.75].map(|share| self.state_at(at + share * length));
                let rims = [state.rim, first, second, third, self.state_at(to)];
                let side = if at == 0.0 {
                    self.is_smooth_at_touch.then_some(1.0)
                } else {
                    state.profile.slip_side(state.rim.coulomb_limit)
                };
                if let Some(side) = side.filter(|_| !self.has_limit_jumps) {
                    let friction = Friction::Sliding { side, impulse: state.rim.impulse };
                    let step = SlipStep { start: at, length, slip: state.speed / start, friction, rate: rate / start };
                    let share = state.slide(&rims, side, rate, near);
                    if share == 1.0 {
                        if has_steps {
                            steps.push(step);
                        }
                        length = MAX_STEP * duration;
                        continue;
                    }
                    if share * length > near {
                        length *= share;
                        continue;
                    }
                }
                is_sliding = false;
                halves.clone_from_state(&state);
                let first = halves.step(rims[1], rims[2], rate);
                let middle = halves.motion();
                let second = halves.step(rims[3], rims[4], rate);
                let motion = [state.motion(), middle, halves.motion()];
                if let Some(share) = first_kink(&rims, motion, state.profile.central_stretch(), near) {
                    length *= share;
                    continue;
                }
                whole.clone_from_state(&state);
                whole.step(rims[2], rims[4], rate);
                let off = |part: fn(&TangentialState) -> f64| part(&halves) - part(&whole);
                let offs = [off(|s| s.speed), off(|s| s.profile.shift), off(|s| s.acceleration)];
                // an error of the force acts for one oscillation at most
                let swing = (rate * rims[4].square.sqrt()).sqrt().recip();
                let weights = [1.0, duration.recip(), swing.min(last - to)];
                let error: f64 = offs.iter().zip(weights).map(|(off, weight)| off.abs() * weight).sum();
                let error = REMAINING_ERROR_SHARE * error / start.abs();
                let tolerance = accuracy * (length / last + MIN_STEP_ACCURACY_SHARE);
                if error <= tolerance || length < 1e-7 * duration {
                    if has_steps {
                        let half = |time: f64, speed: f64, friction| {
                            let slip = speed / start;
                            let friction = Friction::Partial(friction);
                            SlipStep { start: time, length: 0.5 * length, slip, friction, rate: rate / start }
                        };
                        steps.push(half(at, state.speed, first));
                        steps.push(half(rims[2].time, middle[0], second));
                    }
                    sum += error;
                    halves.extrapolate(offs.map(|off| off / 15.0));
                    std::mem::swap(&mut state, &mut halves);
                    state.profile.merge_pieces(joined);
                }
                length *= (0.9 * (tolerance / error).sqrt().sqrt()).clamp(0.2, 3.0);
            }
        }
        Ok(SlipResult { ratio: state.speed / start, error: sum, is_sliding, end: last, steps })
    }
}
