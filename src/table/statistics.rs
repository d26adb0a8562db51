//! Mean, standard deviation and quantiles of a column over any number of rows, in limited memory. The rows are added in the
//! order of the cases, so threads and shards do not change the result.

use std::collections::BTreeMap;

/// Up to this number of samples the quantiles are exact; with more samples they come from bins.
const MAX_EXACT_SAMPLES: usize = 1_000_000;
/// A bin holds the numbers that differ in this number of last bits of their 52: it is 2⁻¹⁷ of a power of two wide.
const BIN_BITS: u32 = 35;
/// Samples that scatter by a smaller share of their size are equal within rounding.
const ROUNDING: f64 = 1e-9;

/// Statistics of a column of random cases; [`crate::report::text::sweep`] says what each number is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub struct ColumnStatistics {
    pub samples: u64,
    pub mean: f64,
    pub standard_deviation: f64,
    pub quantile_05: f64,
    pub quantile_50: f64,
    pub quantile_95: f64,
    pub quantile_resolution: f64,
    /// True if all samples are equal within rounding.
    pub is_constant: bool,
}

/// Collects the values of a column, case after case.
#[derive(Debug, Clone)]
pub struct RunningStatistics {
    count: u64,
    mean: f64,
    /// Sum of squared deviations from the mean.
    deviation: f64,
    /// The smallest and the largest value.
    ends: (f64, f64),
    /// All values, up to [`MAX_EXACT_SAMPLES`] of them.
    values: Vec<f64>,
    /// Number of values in each bin that has some, once there are more than [`MAX_EXACT_SAMPLES`].
    bins: BTreeMap<u64, u64>,
}

impl Default for RunningStatistics {
    fn default() -> Self {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        Self { count: 0, mean: 0.0, deviation: 0.0, ends, values: Vec::new(), bins: BTreeMap::new() }
    }
}

/// The bin of a value; bins rise with their values.
fn bin_index(value: f64) -> u64 {
    let bits = value.to_bits();
    let rising = if value.is_sign_negative() { !bits } else { bits | (1 << 63) };
    rising >> BIN_BITS
}

/// The lower edge of a bin, which is the upper one of the bin below it.
fn edge(bin: u64) -> f64 {
    let rising = bin << BIN_BITS;
    f64::from_bits(if rising >> 63 == 1 { rising ^ (1 << 63) } else { !rising })
}

impl RunningStatistics {
    /// Adds one value (Welford 1962). One that is not finite does not count.
    pub fn push(&mut self, value: f64) {
        if !value.is_finite() {
            return;
        }
        self.count += 1;
        self.ends = (self.ends.0.min(value), self.ends.1.max(value));
        let from_old = value - self.mean;
        self.mean += from_old / self.count as f64;
        self.deviation += from_old * (value - self.mean);
        if self.bins.is_empty() {
            self.values.push(value);
            if self.values.len() > MAX_EXACT_SAMPLES {
                for value in std::mem::take(&mut self.values) {
                    *self.bins.entry(bin_index(value)).or_default() += 1;
                }
            }
        } else {
            *self.bins.entry(bin_index(value)).or_default() += 1;
        }
    }

    /// The summary; `None` without samples.
    pub fn distribution(&self) -> Option<ColumnStatistics> {
        let mut sorted = self.values.clone();
        sorted.sort_by(f64::total_cmp);
        let quantile = |share: f64| {
            if self.bins.is_empty() { (quantile_of_sorted(&sorted, share), 0.0) } else { self.quantile_of_bins(share) }
        };
        let [(quantile_05, low), (quantile_50, middle), (quantile_95, high)] = [0.05, 0.5, 0.95].map(quantile);
        let (least, largest) = self.ends;
        (self.count > 0).then(|| ColumnStatistics {
            samples: self.count,
            mean: self.mean,
            standard_deviation: if self.count > 1 { (self.deviation / (self.count - 1) as f64).sqrt() } else { 0.0 },
            quantile_05,
            quantile_50,
            quantile_95,
            quantile_resolution: low.max(middle).max(high),
            is_constant: largest - least <= ROUNDING * least.abs().max(largest.abs()),
        })
    }

    /// A quantile from the bins, and the width of its bin.
    fn quantile_of_bins(&self, share: f64) -> (f64, f64) {
        let wanted = share * self.count as f64;
        let mut below = 0.0;
        for (bin, count) in &self.bins {
            let count = *count as f64;
            if below + count >= wanted {
                let (low, high) = (edge(*bin), edge(bin + 1));
                return (low + (high - low) * (wanted - below) / count, high - low);
            }
            below += count;
        }
        (self.ends.1, 0.0)
    }

    /// Counts in `n` even bars from the smallest to the largest value, with the edges of the first and last bar. `None` if all
    /// samples are equal within rounding, so that there is nothing to draw.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn histogram(&self, n: usize) -> Option<(f64, f64, Vec<u64>)> {
        self.distribution().filter(|distribution| !distribution.is_constant)?;
        let (low, high) = self.ends;
        let width = (high - low) / n as f64;
        let mut counts = vec![0; n];
        let mut add = |value: f64, count: u64| counts[(((value - low) / width) as usize).min(n - 1)] += count;
        self.values.iter().for_each(|value| add(*value, 1));
        self.bins.iter().for_each(|(bin, count)| add(0.5 * (edge(*bin) + edge(bin + 1)), *count));
        Some((low, high, counts))
    }
}

/// Linear interpolation between order statistics at (n − 1) × share (Hyndman and Fan 1996, type 7).
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn quantile_of_sorted(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let at = share * last as f64;
    let below = at as usize;
    let above = (below + 1).min(last);
    sorted[below] + (at - below as f64) * (sorted[above] - sorted[below])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_are_narrow_ordered_and_hold_their_values() {
        let values = [-3e5, -1.0, -1e-30, 0.0, 1e-300, 1e-6, 0.69, 0.7, 1.0, 4e9];
        for value in values {
            let (low, high) = (edge(bin_index(value)), edge(bin_index(value) + 1));
            assert!(low <= value && value <= high, "{low} {value} {high}");
            assert!(high - low <= value.abs() / f64::from(1_u32 << 16) + 1e-300, "{low} {high}");
        }
        assert!(values.windows(2).all(|pair| bin_index(pair[0]) < bin_index(pair[1])));
    }

    #[test]
    fn many_samples_have_the_quantiles_of_few() {
        let value = |i: usize| 1e-4 * (1.0 + (i * 7919 % 1_000_003) as f64 / 1_000_003.0);
        let mut all = RunningStatistics::default();
        for i in 0..1_000_003 {
            all.push(value(i));
        }
        assert!(all.values.is_empty() && !all.bins.is_empty());
        let found = all.distribution().expect("there are samples");
        for (quantile, share) in [(found.quantile_05, 0.05), (found.quantile_50, 0.5), (found.quantile_95, 0.95)] {
            assert!((quantile / (1e-4 * (1.0 + share)) - 1.0).abs() < 1e-5, "{quantile} at {share}");
        }
        assert!(found.quantile_resolution > 0.0 && found.quantile_resolution < 2e-9);
        let (low, high, counts) = all.histogram(10).expect("they differ");
        assert!(low == 1e-4 && (high / 2e-4 - 1.0).abs() < 1e-5);
        assert!(counts.iter().all(|count| count.abs_diff(100_000) < 100), "{counts:?}");
    }

    #[test]
    fn equal_samples_differ_from_scattered_samples() {
        let of = |values: &[f64]| {
            let mut all = RunningStatistics::default();
            for value in values {
                all.push(*value);
            }
            all
        };
        let equal = of(&[0.7, 0.7 + 1e-16, 0.7 - 1e-16]);
        assert!(equal.distribution().is_some_and(|found| found.is_constant) && equal.histogram(60).is_none());
        let scattered = of(&[1e-9, 2e-9, f64::NAN]);
        let found = scattered.distribution();
        assert!(found.is_some_and(|found| !found.is_constant && found.samples == 2));
        assert!(scattered.histogram(60).is_some());
    }
}
