//! The Fourier transform of real samples: at all frequencies of a fast transform, and at any one frequency.
//!
//! Sines and cosines come from [`functions`](super::functions), so that a spectrum has the same bits on every machine. The crates for
//! fast transforms take them from the C library.

use std::f64::consts::TAU;

use super::functions::sin_cos;

/// |Σ x_k e^(−2πi jk/n)| for j = 0 to n/2, where zeros follow the samples up to the length n, the next power of two from `least` on.
pub fn magnitudes(samples: &[f64], least: usize) -> Vec<f64> {
    let length = least.max(samples.len()).max(2).next_power_of_two();
    let mut values = vec![[0.0; 2]; length];
    for (value, sample) in values.iter_mut().zip(samples) {
        value[0] = *sample;
    }
    transform(&mut values);
    values[..=length / 2].iter().map(|[re, im]| (re * re + im * im).sqrt()).collect()
}

/// The transform of Cooley and Tukey, in place; the length is a power of two.
#[allow(clippy::cast_precision_loss)] // lengths below 2^53
fn transform(values: &mut [[f64; 2]]) {
    let length = values.len();
    let shift = usize::BITS - length.trailing_zeros();
    for i in 0..length {
        let mirrored = i.reverse_bits() >> shift;
        if i < mirrored {
            values.swap(i, mirrored);
        }
    }
    let turns: Vec<[f64; 2]> = (0..length / 2)
        .map(|k| {
            let (sin, cos) = sin_cos(TAU * (k as f64 / length as f64));
            [cos, -sin]
        })
        .collect();
    let mut half = 1;
    while half < length {
        let stride = length / (2 * half);
        for block in values.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for ((a, b), [cos, sin]) in low.iter_mut().zip(high).zip(turns.iter().step_by(stride)) {
                let turned = [b[0] * cos - b[1] * sin, b[0] * sin + b[1] * cos];
                *b = [a[0] - turned[0], a[1] - turned[1]];
                *a = [a[0] + turned[0], a[1] + turned[1]];
            }
        }
        half *= 2;
    }
}

/// |Σ x_k e^(−2πi fk)| at any frequency f in units of the inverse of the step.
pub fn magnitude_at(samples: &[f64], frequency: f64) -> f64 {
    let (sin, cos) = sin_cos(TAU * frequency);
    let [re, im] = samples
        .iter()
        .rev()
        .fold([0.0, 0.0], |[re, im]: [f64; 2], sample| [re * cos + im * sin + sample, im * cos - re * sin]);
    (re * re + im * im).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum itself, term by term.
    #[allow(clippy::cast_precision_loss)]
    fn sum(samples: &[f64], frequency: f64) -> f64 {
        let term = |k: usize| sin_cos(TAU * ((frequency * k as f64) % 1.0));
        let [re, im] = samples.iter().enumerate().fold([0.0, 0.0], |[re, im], (k, sample)| {
            let (sin, cos) = term(k);
            [re + sample * cos, im - sample * sin]
        });
        (re * re + im * im).sqrt()
    }

    #[test]
    #[allow(clippy::cast_precision_loss)]
    fn transform_equals_its_sum() {
        let samples: Vec<f64> = (0..23).map(|k| f64::from(k * k % 7) - 1.5).collect();
        for least in [2, 23, 64, 100] {
            let all = magnitudes(&samples, least);
            let length = 2 * (all.len() - 1);
            assert!(length.is_power_of_two() && length >= least && length >= samples.len());
            for (j, got) in all.iter().enumerate() {
                let frequency = j as f64 / length as f64;
                let want = sum(&samples, frequency);
                assert!((got - want).abs() < 1e-13 * 23.0, "{j}: {got} {want}");
                assert!((magnitude_at(&samples, frequency) - want).abs() < 1e-13 * 23.0, "{j}");
            }
        }
    }

    /// Parseval: the squares of both sides have the same sum.
    #[test]
    #[allow(clippy::cast_precision_loss)]
    fn transform_keeps_sum_of_squares() {
        let samples: Vec<f64> = (0..1000).map(|k| f64::from(k * 37 % 101)).collect();
        let all = magnitudes(&samples, 1024);
        let inner: f64 = all[1..512].iter().map(|value| 2.0 * value * value).sum();
        let total = inner + all[0] * all[0] + all[512] * all[512];
        let want: f64 = samples.iter().map(|value| value * value).sum();
        assert!((total / 1024.0 / want - 1.0).abs() < 1e-13, "{total} {want}");
    }
}
