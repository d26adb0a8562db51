//! The force of an impact as a source: F(t) at a fixed step, and its spectrum.
//!
//! The stepper rk8 computes the motion at the tolerance of the solver, whatever its method, and its continuous solution gives the force at
//! every sample. The force is 0 at first contact and after separation, so the sum of the samples times the step is the trapezoidal rule for
//! the impulse, and the discrete transform times the step is that for the spectrum F(f) = ∫F e^(−2πi f t) dt.

use thiserror::Error;

use super::problem::contact::Contact;
use super::problem::error::ImpactError;
use super::solve::outcome::ImpactEnd;
use super::solve::recorder::TraceRecorder;
use super::solve::{Solver, motion};
use crate::numerics::fft::{magnitude_at, magnitudes};
use crate::numerics::ode::rk8::Rk8;
use crate::numerics::root::illinois;
use crate::units::{Dimension, format_input};

/// The fewest steps in the contact time: with fewer the corner frequency is off by a per cent.
pub const MIN_PULSE_STEPS: f64 = 20.0;
/// The most samples with zeros, of which both files have some hundred megabytes.
pub const MAX_PULSE_SAMPLES: f64 = 4_194_304.0;
/// Length of the samples of the transform over the contact time, if the scenario gives none.
const DEFAULT_PADDING: u64 = 8;

/// The request of a pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PulseRequest {
    /// Time from sample to sample \[s\].
    pub step: f64,
    /// The pulse with zeros is at least this many times as long as the contact; `None` for no zeros in the pulse itself.
    pub padding: Option<u64>,
}

/// A pulse and its spectrum. SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Pulse {
    /// Time from sample to sample \[s\].
    pub step: f64,
    /// The contact force \[N\] at 0, `step`, ..., from first contact to the first sample after separation, and zeros if asked for.
    pub forces: Vec<f64>,
    /// Contact time \[s\].
    pub contact_time: f64,
    /// Peak of the samples \[N\].
    pub peak_force: f64,
    /// Distance of the frequencies \[Hz\].
    pub frequency_step: f64,
    /// |F| \[N s\] at 0, `frequency_step`, ..., up to half the inverse of the step.
    pub spectrum: Vec<f64>,
    /// |F(0)| \[N s\].
    pub impulse: f64,
    /// The impulse over the change of momentum m (v + v') + m g t_c, less 1.
    pub impulse_error: f64,
    /// The frequency \[Hz\] at which |F| has fallen to |F(0)|/√2.
    pub corner_frequency: Option<f64>,
    /// The frequency \[Hz\] of the first minimum of |F|, which is a zero if the pulse is symmetric in time.
    pub first_minimum: Option<f64>,
}

/// Why an impact has no pulse.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PulseError {
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// The pulse has no end.
    #[error("the sphere does not separate, so the pulse has no end")]
    Captured,
    #[error(
        "the step is too long for a contact time of {}, because a pulse needs at least {MIN_PULSE_STEPS} steps. The step must be at most {}.",
        format_input(*.contact_time, Dimension::Time), format_input(*.most, Dimension::Time)
    )]
    LongStep {
        /// \[s\].
        contact_time: f64,
        /// The longest possible step \[s\].
        most: f64,
    },
    #[error(
        "the step is too short for a contact time of {}, because a pulse has at most {MAX_PULSE_SAMPLES} samples with its zeros. The step must be at least {}.",
        format_input(*.contact_time, Dimension::Time), format_input(*.least, Dimension::Time)
    )]
    ShortStep {
        /// \[s\].
        contact_time: f64,
        /// The shortest possible step \[s\].
        least: f64,
    },
}

impl Contact {
    /// The pulse of an impact at this speed \[m/s\] normal to the surface.
    ///
    /// # Errors
    /// [`PulseError`] if the impact has no result, the sphere does not separate, or the step does not fit the contact time.
    pub fn pulse(&self, speed: f64, solver: &Solver, request: &PulseRequest) -> Result<Pulse, PulseError> {
        self.at_speed(speed)?.pulse_at(speed, solver, request)
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)] // below MAX_PULSE_SAMPLES
    fn pulse_at(&self, speed: f64, solver: &Solver, request: &PulseRequest) -> Result<Pulse, PulseError> {
        let case = self.scaled_impact(None, speed)?;
        let mut recorder = TraceRecorder::default();
        let mut integrator = Rk8::new(solver.tolerance);
        let outcome = motion::integrate(case.ground, case.q, &case.forces, &mut integrator, Some(&mut recorder))
            .map_err(ImpactError::from)?;
        if outcome.end == ImpactEnd::Captured {
            return Err(PulseError::Captured);
        }
        let (PulseRequest { step, padding }, unit) = (*request, case.scales.time());
        let contact_time = outcome.contact_time * unit;
        let (steps, factor) = (contact_time / step, padding.unwrap_or(DEFAULT_PADDING) as f64);
        if steps < MIN_PULSE_STEPS {
            return Err(PulseError::LongStep { contact_time, most: contact_time / MIN_PULSE_STEPS });
        }
        // the next power of two may be twice as many
        if 2.0 * factor * (steps + 2.0) > MAX_PULSE_SAMPLES {
            let least = contact_time / (0.5 * MAX_PULSE_SAMPLES / factor - 2.0);
            return Err(PulseError::ShortStep { contact_time, least });
        }
        let inner = steps.ceil() as usize - 1;
        let times = (1..=inner).map(|k| k as f64 * step / unit);
        let points = recorder.into_points(case.ground, &outcome.unloading, case.forces.damping, times);
        let of_samples = points.iter().filter(|point| point.event.is_none());
        let mut forces = vec![0.0];
        forces.extend(of_samples.map(|point| point.total_force * case.scales.units.force));
        // the last sample lies within rounding of separation
        forces.resize(inner + 2, 0.0);
        let peak_force = forces.iter().copied().fold(0.0, f64::max);
        let spectrum: Vec<f64> = magnitudes(&forces, (factor * forces.len() as f64) as usize);
        let length = 2 * (spectrum.len() - 1);
        let spectrum: Vec<f64> = spectrum.into_iter().map(|value| value * step).collect();
        let gravity = self.forces().gravity.unwrap_or(0.0);
        let momentum = self.reduced_mass() * speed * (1.0 + outcome.restitution) + self.mass() * gravity * contact_time;
        let impulse = spectrum[0];
        let [corner_frequency, first_minimum] =
            [corner_frequency(&forces, &spectrum), first_minimum(&forces, &spectrum)]
                .map(|place| place.map(|frequency| frequency / step));
        if padding.is_some() {
            forces.resize(length, 0.0);
        }
        Ok(Pulse {
            step,
            forces,
            contact_time,
            peak_force,
            frequency_step: 1.0 / (length as f64 * step),
            spectrum,
            impulse,
            impulse_error: impulse / momentum - 1.0,
            corner_frequency,
            first_minimum,
        })
    }
}

impl Pulse {
    /// Times \[s\] and forces \[N\].
    #[allow(clippy::cast_precision_loss)] // below MAX_PULSE_SAMPLES
    pub fn samples(&self) -> impl Iterator<Item = (f64, f64)> + Clone + '_ {
        self.forces.iter().enumerate().map(|(k, force)| (k as f64 * self.step, *force))
    }

    /// Frequencies \[Hz\] and magnitudes \[N s\].
    #[allow(clippy::cast_precision_loss)] // below MAX_PULSE_SAMPLES
    pub fn lines(&self) -> impl Iterator<Item = (f64, f64)> + Clone + '_ {
        self.spectrum.iter().enumerate().map(|(j, magnitude)| (j as f64 * self.frequency_step, *magnitude))
    }
}

/// The frequency, in units of the inverse of the step, at which the magnitude first falls to 1/√2 of its value at 0.
#[allow(clippy::cast_precision_loss)] // below MAX_PULSE_SAMPLES
fn corner_frequency(samples: &[f64], spectrum: &[f64]) -> Option<f64> {
    let level = spectrum[0] * std::f64::consts::FRAC_1_SQRT_2;
    let after = spectrum.iter().position(|magnitude| *magnitude < level)?;
    let frequency = |j: usize| j as f64 / (2 * (spectrum.len() - 1)) as f64;
    let sum: f64 = samples.iter().sum();
    let excess = |f: f64| magnitude_at(samples, f) / sum - std::f64::consts::FRAC_1_SQRT_2;
    Some(illinois((frequency(after.checked_sub(1)?), frequency(after)), excess))
}

/// The frequency, in units of the inverse of the step, of the first minimum of the magnitude.
#[allow(clippy::cast_precision_loss)] // below MAX_PULSE_SAMPLES
fn first_minimum(samples: &[f64], spectrum: &[f64]) -> Option<f64> {
    /// 2/(1 + √5).
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let at = 1 + spectrum.windows(3).position(|window| window[1] <= window[0] && window[1] < window[2])?;
    let frequency = |j: usize| j as f64 / (2 * (spectrum.len() - 1)) as f64;
    let (mut low, mut high) = (frequency(at - 1), frequency(at + 1));
    // 40 shares of 0.618 are 4e-9 of two lines
    for _ in 0..40 {
        let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if magnitude_at(samples, left) < magnitude_at(samples, right) {
            high = right;
        } else {
            low = left;
        }
    }
    Some(0.5 * (low + high))
}
