//! The contact of Mindlin and Deresiewicz in its one-dimensional form (MDR): springs along the radius, each with its own
//! Coulomb stop.
//!
//! The friction rides on the normal motion, of which it needs force f, radius α and time. With σ = 4γ s/μ in place of the
//! slip speed s, T in units of μ, and springs at 0 < ξ < α:
//!
//! ```text
//! stop      φ(ξ) = (3/2) (f/α) (1 − ξ²/α²)                  (∫ φ dξ = f)
//! spring    ζ' = (3/2) σ, clipped to |ζ| ≤ φ;  0 outside of the contact, from the time on at which the rim passes ξ
//! sphere    σ' = (5/2) χ T,   T = −∫₀^α ζ dξ
//! radius    α = f/ε on the way in,   α ∝ df/dx on the way out
//! ```
//!
//! So an impact depends on σ_0 and χ alone. For Hertz this is the theory of Mindlin and Deresiewicz (Jäger 1993; Popov and Heß,
//! *Method of Dimensionality Reduction*, 2015), and what Maw, Barber and Fawcett (1976), Wear 38, 101-114, solve. With
//! plasticity it is an extension: pressure of Hertz's shape with the force and the radius of the law. It creates no energy.
//!
//! Velocity Verlet, order 2: with as many springs as steps a leg, N = 1000, the error of s_1/s_0 is below 1e-5.

use std::sync::LazyLock;

use crate::impact::course;
use crate::impact::forces::ScaledForces;
use crate::impact::record::{Point, Recorder};
use crate::impact::scales::ACCELERATION;
use crate::integrate::IntegrationError;
use crate::integrate::rk8::Rk8;
use crate::law::Law;

/// N: springs, and steps of each leg of the impact.
pub const SPRINGS: usize = 1000;

/// The normal motion at equal times on the way in, and on the way out.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Time between two points on the way in, and on the way out.
    step: [f64; 2],
    /// α; the peak is in the middle.
    radius: Vec<f64>,
    /// f/α.
    pressure: Vec<f64>,
}

impl Motion {
    /// The motion at q = v/V.
    pub fn new(law: &Law, q: f64, forces: &ScaledForces) -> Result<Self, IntegrationError> {
        let mut recorder = Recorder::on();
        let outcome = course::integrate(law, q, forces, &mut Rk8::new(1e-10), &mut recorder)?;
        let radius = |point: &Point| {
            if point.is_unloading {
                outcome.unloading.grip_of(point.state.elastic_approach)
            } else {
                point.state.force / point.state.elastic_approach
            }
        };
        #[allow(clippy::cast_precision_loss)]
        let step =
            [outcome.loading_time, outcome.contact_time - outcome.loading_time].map(|time| time / SPRINGS as f64);
        let mut motion = Self { step, radius: vec![0.0], pressure: vec![0.0] };
        let times = (1..2 * SPRINGS).map(|k| Self::time_of(step, k));
        let points = recorder.points(law, &outcome.unloading, forces.drag, times);
        for point in points.iter().filter(|point| point.event.is_none()) {
            motion.push(radius(point), point.state.force);
        }
        motion.radius.resize(2 * SPRINGS + 1, 0.0);
        motion.pressure.resize(2 * SPRINGS + 1, 0.0);
        Ok(motion)
    }

    /// That of an elastic impact, which is one for all of them in units of its own peak and speed.
    pub fn elastic() -> Result<&'static Self, IntegrationError> {
        static ELASTIC: LazyLock<Result<Motion, IntegrationError>> =
            LazyLock::new(|| Motion::new(&Law::hertz(), 1.0, &ScaledForces::NONE));
        ELASTIC.as_ref().map_err(Clone::clone)
    }

    fn push(&mut self, radius: f64, force: f64) {
        let is_touching = radius > 0.0;
        self.radius.push(if is_touching { radius } else { 0.0 });
        self.pressure.push(if is_touching { force / radius } else { 0.0 });
    }

    /// The time of point `k`.
    pub fn time(&self, k: usize) -> f64 {
        Self::time_of(self.step, k)
    }

    #[allow(clippy::cast_precision_loss)] // counts up to 2 N
    fn time_of(step: [f64; 2], k: usize) -> f64 {
        let [inward, outward] = [k.min(SPRINGS), k.saturating_sub(SPRINGS)].map(|k| k as f64);
        step[0] * inward + step[1] * outward
    }

    /// The last point at or before a time.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)] // below 2 N
    pub fn place(&self, time: f64) -> usize {
        let inward = self.time(SPRINGS);
        let [leg, since] =
            if time < inward { [0.0, time / self.step[0]] } else { [SPRINGS as f64, (time - inward) / self.step[1]] };
        ((leg + since) as usize).min(2 * SPRINGS)
    }

    /// How far the steps shift the phase of the swings of a contact that sticks \[rad\]: Σ (ω Δτ)³/24 with ω² = (15/4) χ α.
    /// From a step of ω Δτ = 2 on they grow without end.
    pub fn shift(&self, chi: f64) -> f64 {
        let at = |k: usize| {
            let step = self.step[usize::from(k > SPRINGS)];
            let square = 3.0 * ACCELERATION * chi * self.radius[k] * step * step;
            square * square.sqrt() / 24.0
        };
        (1..2 * SPRINGS).map(at).sum()
    }

    /// σ_1/σ_0 with every `stride`-th point and spring. `record` gets σ and T at each point.
    #[allow(clippy::cast_precision_loss)] // counts up to 2 N
    pub fn run(&self, sigma: f64, chi: f64, stride: usize, mut record: impl FnMut(f64, f64)) -> f64 {
        let springs = SPRINGS / stride;
        let width = self.radius.iter().copied().fold(0.0, f64::max) / springs as f64;
        let squares: Vec<f64> = (0..springs).map(|i| (i as f64 + 0.5) * width).map(|at| at * at).collect();
        // springs within a radius: those whose place i + ½ is below it
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let within = |radius: f64| ((radius / width + 0.5) as usize).min(springs);
        let rate = 2.0 * ACCELERATION * chi;
        let mut stretches = vec![0.0; springs];
        let (mut at, mut force) = (sigma, 0.0);
        record(at, force);
        for k in (0..2 * SPRINGS).step_by(stride) {
            let dt = self.step[k / SPRINGS] * (stride as f64);
            let half = at + 0.5 * dt * rate * force;
            let [before, after] = [self.radius[k], self.radius[k + stride]];
            let [inside, until] = [within(before.min(after)), within(after)];
            let [old, new] = [before * before, after * after];
            let stop = 1.5 * self.pressure[k + stride];
            let fall = if new > 0.0 { stop / new } else { 0.0 };
            let moved = 1.5 * half * dt;
            let mut sum = stretched(&mut stretches[..inside], &squares[..inside], moved, stop, fall);
            // the rim passes these on the way; α² is almost straight in time
            for (stretch, square) in stretches[inside..until].iter_mut().zip(&squares[inside..until]) {
                let share = ((new - square) / (new - old)).clamp(0.0, 1.0);
                *stretch = clipped(moved * share, stop - fall * square);
                sum += *stretch;
            }
            stretches[until..].fill(0.0);
            force = -width * sum;
            at = half + 0.5 * dt * rate * force;
            record(at, force);
        }
        at / sigma
    }
}

impl Motion {
    /// σ_1/σ_0 with one spring in place of all, as the contact of a DEM code carries it (`mindlin_rescale/force` of LAMMPS;
    /// Thornton, Cummins and Cleary 2013): on the way out the force is scaled with the radius first.
    ///
    /// ```text
    /// T' = −(3/2) α σ,   |T| ≤ f
    /// ```
    pub fn run_on_one_spring(&self, sigma: f64, chi: f64) -> f64 {
        let rate = 2.0 * ACCELERATION * chi;
        let (mut at, mut force) = (sigma, 0.0);
        for k in 0..2 * SPRINGS {
            let (dt, [before, after]) = (self.step[k / SPRINGS], [self.radius[k], self.radius[k + 1]]);
            let half = at + 0.5 * dt * rate * force;
            let kept = if after < before { force * after / before } else { force };
            let radius = 0.5 * (before + after);
            force = clipped(kept - 1.5 * radius * half * dt, self.pressure[k + 1] * after);
            at = half + 0.5 * dt * rate * force;
        }
        at / sigma
    }
}

/// Moves springs that stay in contact, and gives the sum of their stretches. The stop of a spring is `stop − fall ξ²`.
fn stretched(stretches: &mut [f64], squares: &[f64], moved: f64, stop: f64, fall: f64) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (stretches, last) = stretches.as_chunks_mut::<LANES>();
    let (squares, last_squares) = squares.as_chunks::<LANES>();
    for (stretches, squares) in stretches.iter_mut().zip(squares) {
        for ((stretch, square), sum) in stretches.iter_mut().zip(squares).zip(&mut sums) {
            *stretch = clipped(*stretch + moved, stop - fall * square);
            *sum += *stretch;
        }
    }
    let mut sum: f64 = sums.iter().sum();
    for (stretch, square) in last.iter_mut().zip(last_squares) {
        *stretch = clipped(*stretch + moved, stop - fall * square);
        sum += *stretch;
    }
    sum
}

/// A number within ± `limit`; without the care for NaN of `clamp`, so that the loop runs in vectors.
#[inline(always)]
fn clipped(value: f64, limit: f64) -> f64 {
    let below = if value < limit { value } else { limit };
    if below > -limit { below } else { -limit }
}
