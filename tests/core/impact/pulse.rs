//! The force at a fixed step, and its spectrum: the exact pulse of Hertz, the momentum, and steps that do not fit.

use std::f64::consts::PI;

use crate::common::prelude::*;
use plm_impact::numerics::fft::{magnitude_at, magnitudes};

/// Corner frequency and first zero of the exact Hertz pulse, times its contact time: Gauss quadrature of x'' = −(5/4) x^1.5 with x^2.5 =
/// sin²(y⁵), in which the pulse is smooth. Its contact time over δ_m/v is 2.94327518432, and its impulse 2 m v to 1e-13.
const HERTZ_CORNER: f64 = 0.669_616_411_532;
const HERTZ_ZERO: f64 = 1.804_028_461_695;

fn impact(text: &str, set: &[&str]) -> (Contact, Impact, Pulse) {
    let (contact, speed) = (contact(text, set), 1.0);
    let impact = contact.impact(speed, &Solver::default(), None).unwrap();
    let request = PulseRequest { step: impact.row.contact_time / 2000.3, padding: None };
    let pulse = contact.pulse(speed, &Solver::default(), &request).unwrap();
    (contact, impact, pulse)
}

fn magnitude_at_first_minimum(pulse: &Pulse) -> f64 {
    pulse.step * magnitude_at(&pulse.forces, pulse.first_minimum.unwrap() * pulse.step)
}

#[test]
fn hertz_pulse_has_exact_spectrum() {
    let (contact, impact, pulse) = impact(STEEL, &["half_space.yield_strength=none"]);
    let time = impact.row.contact_time;
    assert!(relative_error(pulse.contact_time, time) < 1e-9);
    assert!(relative_error(pulse.impulse, 2.0 * contact.mass()) < 1e-7, "{:e}", pulse.impulse_error);
    assert!(relative_error(pulse.corner_frequency.unwrap() * time, HERTZ_CORNER) < 1e-7, "{pulse:?}");
    assert!(relative_error(pulse.first_minimum.unwrap() * time, HERTZ_ZERO) < 1e-6);
    // a symmetric pulse has a zero there
    assert!(magnitude_at_first_minimum(&pulse) < 1e-6 * pulse.impulse);
    // 2001 steps, with a zero after separation, and the spectrum of 8 times as many
    assert_eq!((pulse.forces.len(), pulse.spectrum.len()), (2002, 8192 + 1));
    assert_eq!((pulse.forces[0], pulse.forces[2001]), (0.0, 0.0));
    assert!(relative_error(pulse.frequency_step * pulse.step, 1.0 / 16384.0) < 1e-14);
    // sin^(3/2) of the same peak and contact time: too high by up to 2.43 % of the peak, and its first zero is at 1.75
    let share = |time: f64| (PI * (time / pulse.contact_time).min(1.0)).sin().max(0.0).powf(1.5);
    let most = pulse.samples().map(|(time, force)| share(time) - force / pulse.peak_force).fold(0.0, f64::max);
    assert!((most - 0.024_317).abs() < 1e-5, "{most}");
}

/// The zeros of the transform of sin^μ are at f t_c = 1 + μ/2, 2 + μ/2, ... (poles of the gamma function).
#[test]
fn transform_of_sine_power_has_known_zero() {
    let samples: Vec<f64> = (0..=4000).map(|k| (PI * f64::from(k) / 4000.0).sin().max(0.0).powf(1.5)).collect();
    let all = magnitudes(&samples, 1 << 17);
    // |F| falls and rises linearly beside a zero
    let lowest = (1..9_000).min_by(|a, b| all[*a].total_cmp(&all[*b])).unwrap();
    let first = (1..100).find(|j| all[j + 1] > all[*j]).unwrap();
    assert!(
        (f64::from(u32::try_from(first).unwrap()) * 4000.0 / f64::from(1 << 17) - 1.75).abs()
            < 4000.0 / f64::from(1 << 17)
    );
    assert!(all[lowest] < 1e-3 * all[0]);
}

/// The impulse is m (v + v') + m g t_c in every scene, and the peak is that of the trace; the trapezoidal rule has 2000 steps, and its largest error is that
/// of a force that drops when the metal relaxes.
#[test]
fn impulse_is_change_of_momentum() {
    for set in [
        &[][..],
        &["damping.viscous=0.1"],
        &["damping.hunt_crossley=0.2", "gravity.acceleration=1e4"],
        &["half_space.density=7850", "half_space.thickness=10 mm"],
        &["half_space.density=7850", "half_space.rod_diameter=20 mm"],
        &["half_space.radius=20 mm", "half_space.mass=0.1"],
        &["half_space.rate.johnson_cook.c=0.014"],
        &["solver.method=verlet"],
        &["law.thornton={}"],
    ] {
        let (contact, impact, pulse) = impact(STEEL, set);
        assert!(pulse.impulse_error.abs() < 1e-4, "{set:?}: {:e}", pulse.impulse_error);
        assert!(relative_error(pulse.contact_time, impact.row.contact_time) < 1e-8, "{set:?}");
        let trace = contact.impact(1.0, &Solver::default(), Some(2000)).unwrap().trace;
        let largest = trace.iter().map(|row| row.force).fold(0.0, f64::max);
        assert!((pulse.peak_force / largest - 1.0).abs() < 1e-4, "{set:?}: {} {largest}", pulse.peak_force);
    }
}

/// A dent makes the pulse steeper at its end, so the spectrum has a minimum that is no zero.
#[test]
fn dent_fills_first_zero_of_spectrum() {
    let (.., pulse) = impact(STEEL, &[]);
    let corner = pulse.corner_frequency.unwrap() * pulse.contact_time;
    assert!((corner - HERTZ_CORNER).abs() > 1e-3, "{corner}");
    let lowest = magnitude_at_first_minimum(&pulse) / pulse.impulse;
    assert!(lowest > 1e-3 && lowest < 0.2, "{lowest:e}");
}

#[test]
fn padding_puts_zeros_behind_pulse() {
    let contact = contact(STEEL, NO_OVERRIDES);
    let time = contact.impact(1.0, &Solver::default(), None).unwrap().row.contact_time;
    let of = |padding| contact.pulse(1.0, &Solver::default(), &PulseRequest { step: time / 100.0, padding }).unwrap();
    let (plain, padded) = (of(None), of(Some(3)));
    assert_eq!(padded.forces.len(), 512);
    assert_eq!(padded.forces[..plain.forces.len()], plain.forces);
    assert!(padded.forces[plain.forces.len()..].iter().all(|force| *force == 0.0));
    assert_eq!((padded.spectrum.len(), plain.spectrum.len()), (257, 513));
    assert!(relative_error(padded.impulse, plain.impulse) < 1e-14);
}

#[test]
fn steps_that_do_not_fit_are_refused() {
    let contact = contact(STEEL, NO_OVERRIDES);
    let time = contact.impact(1.0, &Solver::default(), None).unwrap().row.contact_time;
    let of = |step: f64| contact.pulse(1.0, &Solver::default(), &PulseRequest { step, padding: None });
    let Err(PulseError::LongStep { most, .. }) = of(time / 10.0) else { panic!() };
    assert!(of(0.999 * most).is_ok() && of(1.001 * most).is_err());
    let Err(PulseError::ShortStep { least, .. }) = of(1e-7 * time) else { panic!() };
    assert!(of(1.001 * least).is_ok() && of(0.999 * least).is_err());
    let held = contact.clone().with_forces(Forces { gravity: Some(1e7), ..Forces::default() });
    let request = PulseRequest { step: time / 100.0, padding: None };
    assert_eq!(held.pulse(1e-3, &Solver::default(), &request), Err(PulseError::Captured));
}
