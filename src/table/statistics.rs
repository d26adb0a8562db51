//! Mean, standard deviation and quantiles of e over any number of rows, in limited memory. The rows are added in the
//! order of the cases, so threads and shards do not change the result.

/// Up to this number of samples the quantiles are exact; with more samples they come from bins.
const EXACT: usize = 1_000_000;
const BIN: f64 = 1e-6;
/// The bins cover e from 0 to 1.25. Above 1, e is possible only for a sphere that falls into its own dent.
const BINS: usize = 1_250_000;

/// Statistics of the restitutions of random cases; [`crate::report::text::sweep`] says what each number is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub struct Distribution {
    pub samples: u64,
    pub mean: f64,
    pub standard_deviation: f64,
    pub quantile_05: f64,
    pub quantile_50: f64,
    pub quantile_95: f64,
    pub quantile_resolution: f64,
}

/// Collects e, case after case.
#[derive(Debug, Clone, Default)]
pub struct Statistics {
    count: u64,
    mean: f64,
    /// Sum of squared deviations from the mean.
    deviation: f64,
    /// All values, up to [`EXACT`] of them.
    values: Vec<f64>,
    /// Number of values in each bin, once there are more than [`EXACT`].
    bins: Vec<u64>,
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // negative values and NaN: first bin
fn bin(value: f64) -> usize {
    ((value / BIN) as usize).min(BINS - 1)
}

impl Statistics {
    /// Adds one value of e (Welford 1962).
    pub fn push(&mut self, value: f64) {
        self.count += 1;
        let from_old = value - self.mean;
        self.mean += from_old / self.count as f64;
        self.deviation += from_old * (value - self.mean);
        if self.bins.is_empty() {
            self.values.push(value);
            if self.values.len() > EXACT {
                self.bins = vec![0; BINS];
                for value in std::mem::take(&mut self.values) {
                    self.bins[bin(value)] += 1;
                }
            }
        } else {
            self.bins[bin(value)] += 1;
        }
    }

    /// The summary; `None` without samples.
    pub fn distribution(&self) -> Option<Distribution> {
        let mut sorted = self.values.clone();
        sorted.sort_by(f64::total_cmp);
        let quantile = |share: f64| if self.bins.is_empty() { of_sorted(&sorted, share) } else { self.of_bins(share) };
        (self.count > 0).then(|| Distribution {
            samples: self.count,
            mean: self.mean,
            standard_deviation: if self.count > 1 { (self.deviation / (self.count - 1) as f64).sqrt() } else { 0.0 },
            quantile_05: quantile(0.05),
            quantile_50: quantile(0.5),
            quantile_95: quantile(0.95),
            quantile_resolution: if self.bins.is_empty() { 0.0 } else { BIN },
        })
    }

    fn of_bins(&self, share: f64) -> f64 {
        let wanted = share * self.count as f64;
        let mut below = 0.0;
        for (i, count) in self.bins.iter().enumerate() {
            let count = *count as f64;
            if below + count >= wanted && count > 0.0 {
                return (i as f64 + (wanted - below) / count) * BIN;
            }
            below += count;
        }
        BINS as f64 * BIN
    }

    /// Counts of e in `n` even bins from the smallest to the largest value, with the edges of the first and last bin.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn histogram(&self, n: usize) -> Option<(f64, f64, Vec<u64>)> {
        let fine: Vec<(f64, u64)> = if self.bins.is_empty() {
            self.values.iter().map(|value| (*value, 1)).collect()
        } else {
            (0..)
                .zip(&self.bins)
                .filter(|(_, count)| **count > 0)
                .map(|(i, count)| ((f64::from(i) + 0.5) * BIN, *count))
                .collect()
        };
        let low = fine.iter().map(|(value, _)| *value).min_by(f64::total_cmp)?;
        let high = fine.iter().map(|(value, _)| *value).max_by(f64::total_cmp)?;
        // if all samples are equal, the bins still need a width
        let width = ((high - low) / n as f64).max(BIN);
        let mut counts = vec![0; n];
        for (value, count) in fine {
            counts[(((value - low) / width) as usize).min(n - 1)] += count;
        }
        Some((low, low + width * n as f64, counts))
    }
}

/// Linear interpolation between order statistics at (n − 1) × share (Hyndman and Fan 1996, type 7).
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn of_sorted(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let at = share * last as f64;
    let below = at as usize;
    let above = (below + 1).min(last);
    sorted[below] + (at - below as f64) * (sorted[above] - sorted[below])
}
