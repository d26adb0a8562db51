//! The rate of the work, as the progress bar shows it.

use std::collections::VecDeque;
use std::time::Duration;

use indicatif::{HumanCount, HumanDuration};

/// The rate is that of this last time: parts of a table that are only read are fast, and the others follow.
const WINDOW: Duration = Duration::from_secs(10);
/// Less time gives no rate to rely on.
const MIN_TIME: Duration = Duration::from_secs(1);

/// The progress of the last seconds.
#[derive(Debug, Default)]
pub struct Pace {
    /// The time since the beginning, and how much is done.
    samples: VecDeque<(Duration, u64)>,
}

impl Pace {
    pub fn add(&mut self, time: Duration, done: u64) {
        self.samples.push_back((time, done));
        while self.samples.get(1).is_some_and(|(first, _)| time.saturating_sub(*first) >= WINDOW) {
            self.samples.pop_front();
        }
    }

    /// How much is done, and with a rate the time that is left: `1,200/5,000 rows, 300/s, 13s left`.
    pub fn describe(&self, total: u64, counted: &str) -> String {
        let done = self.samples.back().map_or(0, |(_, done)| *done);
        let text = format!("{}/{} {counted}", HumanCount(done), HumanCount(total));
        let Some(rate) = self.rate() else { return text };
        let left = Duration::try_from_secs_f64(total.saturating_sub(done) as f64 / rate).unwrap_or(Duration::MAX);
        format!("{text}, {}/s, {:#} left", rate_digits(rate), HumanDuration(left))
    }

    /// How many are done in a second; `None` where that is not known yet.
    fn rate(&self) -> Option<f64> {
        let (&(from, before), &(until, done)) = self.samples.front().zip(self.samples.back())?;
        let time = until.saturating_sub(from);
        (time >= MIN_TIME && done > before).then(|| (done - before) as f64 / time.as_secs_f64())
    }
}

/// Whole numbers from 10 on, and below one decimal.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // positive
fn rate_digits(rate: f64) -> String {
    if rate < 9.95 { format!("{rate:.1}") } else { HumanCount(rate.round() as u64).to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pace(samples: &[(f64, u64)]) -> Pace {
        let mut pace = Pace::default();
        for (time, done) in samples {
            pace.add(Duration::from_secs_f64(*time), *done);
        }
        pace
    }

    #[test]
    fn rate_is_rounded_and_uses_last_seconds() {
        // within the first second nothing is known of the rate
        assert_eq!(pace(&[(0.0, 0), (0.5, 16)]).describe(5_000_000, "rows"), "16/5,000,000 rows");
        let steady = pace(&[(0.0, 0), (2.0, 420_759)]);
        assert_eq!(steady.describe(5_000_000, "rows"), "420,759/5,000,000 rows, 210,380/s, 22s left");
        // rows that an earlier run left are read at once, and say nothing of those to come
        let resumed: Vec<(f64, u64)> = (0..=300_u32)
            .map(|i| (f64::from(i) / 10.0, if i == 0 { 0 } else { 1_000_000 + 10 * u64::from(i) }))
            .collect();
        assert_eq!(pace(&resumed).describe(2_003_000, "rows"), "1,003,000/2,003,000 rows, 100/s, 3h left");
        assert_eq!(pace(&[(0.0, 0), (10.0, 5)]).describe(10, "done"), "5/10 done, 0.5/s, 10s left");
    }
}
