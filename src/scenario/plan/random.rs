//! Random values that depend on seed, variable and case number alone: sample k is the same on every thread and machine.
//!
//! The 64-bit word k of stream a of ChaCha8 (keyed by the seed) is the uniform number of variable a in case k. The inverse of the
//! distribution function converts it to a value. A distribution is truncated at the allowed range of the key by restricting the
//! interval of the uniform number. No draw is rejected, so the count of words equals the case number.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::numerics::functions::{exp, ln, ln_1p, normal_cdf, normal_quantile, powi};
use crate::scenario::input::NumericKey;

/// A distribution of a key's values, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Uniform between two ends.
    Uniform { from: f64, to: f64 },
    Normal {
        /// Mean before truncation.
        mean: f64,
        /// Standard deviation before truncation, > 0.
        sd: f64,
    },
    /// A distribution whose logarithm is normal.
    Lognormal {
        /// Mean of the value itself, > 0.
        mean: f64,
        /// Standard deviation of the value itself, > 0.
        sd: f64,
    },
}

/// A key with random values.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    pub key: NumericKey,
    /// The distribution, truncated at the allowed range.
    pub distribution: Distribution,
    /// The allowed range.
    range: (f64, f64),
    /// The probabilities of values below either end of the range.
    cdf_range: (f64, f64),
}

impl Variable {
    /// The variable, truncated at the allowed range of its key (the ends may be infinite).
    pub fn new(key: NumericKey, distribution: Distribution) -> Self {
        let range = key.quantity().range();
        let cdf_range = (distribution.cdf(range.0), distribution.cdf(range.1));
        Self { key, distribution, range, cdf_range }
    }

    /// The probability of the allowed range.
    pub fn probability_in_range(&self) -> f64 {
        self.cdf_range.1 - self.cdf_range.0
    }

    /// The median.
    pub fn median(&self) -> f64 {
        self.value(0.5)
    }

    /// The value at the uniform number `u` in (0, 1).
    pub fn value(&self, u: f64) -> f64 {
        let (low, high) = self.cdf_range;
        let value = self.distribution.quantile(low + u * (high - low));
        // rounding at the very ends of an open range
        value.clamp(self.range.0.next_up(), self.range.1.next_down())
    }
}

impl Distribution {
    /// Its name, and its two ends, or mean and standard deviation before truncation.
    pub fn name_and_parameters(&self) -> (&'static str, [f64; 2]) {
        match *self {
            Self::Uniform { from, to } => ("uniform", [from, to]),
            Self::Normal { mean, sd } => ("normal", [mean, sd]),
            Self::Lognormal { mean, sd } => ("lognormal", [mean, sd]),
        }
    }

    /// Standard deviation and mean of the logarithm of a lognormal.
    fn log_parameters(mean: f64, sd: f64) -> (f64, f64) {
        let variance = ln_1p(powi(sd / mean, 2));
        (variance.sqrt(), ln(mean) - 0.5 * variance)
    }

    /// Probability of a value below x.
    fn cdf(&self, x: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => {
                if from == to {
                    f64::from(u8::from(x > from))
                } else {
                    ((x - from) / (to - from)).clamp(0.0, 1.0)
                }
            }
            Self::Normal { mean, sd } => normal_cdf((x - mean) / sd),
            Self::Lognormal { .. } if x <= 0.0 => 0.0,
            Self::Lognormal { mean, sd } => {
                let (sigma, mu) = Self::log_parameters(mean, sd);
                normal_cdf((ln(x) - mu) / sigma)
            }
        }
    }

    /// The quantile of the probability p.
    fn quantile(&self, p: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => from + p * (to - from),
            Self::Normal { mean, sd } => mean + sd * normal_quantile(p),
            Self::Lognormal { mean, sd } => {
                let (sigma, mu) = Self::log_parameters(mean, sd);
                exp(mu + sigma * normal_quantile(p))
            }
        }
    }
}

/// Draws the values of consecutive cases of one variable.
#[derive(Debug)]
pub struct VariableSampler<'a> {
    pub variable: &'a Variable,
    generator: ChaCha8Rng,
}

impl<'a> VariableSampler<'a> {
    /// From case `first` on; `stream` is the index of the variable in the file.
    pub fn new(variable: &'a Variable, seed: u64, stream: u64, first: u64) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(stream);
        // a 64-bit number is two words
        generator.set_word_pos(2 * u128::from(first));
        Self { variable, generator }
    }

    pub fn next_value(&mut self) -> f64 {
        const STEP: f64 = 1.0 / (1u64 << 53) as f64;
        // the middle of one of 2^53 equal steps: never 0, never 1
        let u = ((self.generator.next_u64() >> 11) as f64 + 0.5) * STEP;
        self.variable.value(u)
    }
}
