//! Intervals by the profile likelihood, and the posterior of two keys on a grid.

use super::fit::Fit;
use super::minimum::{Place, polished};
use super::statistics::{LEVELS, reach};
use crate::math::functions::{exp, hypot, ln, ln_1p, pow, sinh};
use crate::math::root::bracketed;

/// Both ends of an interval; `None` if an end lies outside of the range of the key.
pub type Ends = [Option<f64>; 2];

/// The posterior of two keys: each share of the first key, with shares of the second key and the density there.
pub type Sheet = Vec<(f64, Vec<(f64, f64)>)>;

impl Fit<'_> {
    fn sd(&self, key: usize) -> f64 {
        self.covariance.as_ref().map_or(1.0, |covariance| covariance[(key, key)].sqrt()).min(1.0)
    }

    /// The place with the lowest sum that has this share of this key.
    fn lowest(&self, key: usize, share: f64) -> Place {
        let best = &self.best().shares;
        let mut start = best.clone();
        if best.len() == 1 {
            return Place { shares: vec![share], sum: self.problem.sum(&[share]) };
        }
        // there are two keys
        let other = 1 - key;
        if let Some(covariance) = &self.covariance {
            let slope = covariance[(0, 1)] / covariance[(key, key)];
            start[other] = (best[other] + slope * (share - best[key])).clamp(0.0, 1.0);
        }
        start[key] = share;
        if let Some(mut from_grid) = self.grid.best_beside(key, share) {
            from_grid[key] = share;
            if self.problem.sum(&from_grid) < self.problem.sum(&start) {
                start = from_grid;
            }
        }
        polished(&self.problem, &start, Some(key))
    }

    fn excess(&self, key: usize, share: f64) -> f64 {
        (self.lowest(key, share).sum - self.best().sum).max(0.0)
    }

    /// The intervals of the share of a key at both levels.
    pub fn intervals(&self, key: usize) -> [Ends; 2] {
        LEVELS.map(|level| self.ends(key, reach(level, self.freedom())))
    }

    /// The shares on both sides at which the sum has risen by the square of `reach`.
    fn ends(&self, key: usize, reach: f64) -> Ends {
        let level = reach * reach;
        [-1.0, 1.0].map(|way| {
            let beyond = |share: &f64, than: f64| way * (share - than) > 0.0;
            // the outermost place known to be inside of the interval: a minimum, or a cell of the grid
            let basins = self.minima.iter().filter(|place| place.sum - self.best().sum < level);
            let mut inside = basins.map(|place| place.shares[key]).fold(self.best().shares[key], |outermost, share| {
                if beyond(&share, outermost) { share } else { outermost }
            });
            let cells = (0..CELLS).map(|i| (f64::from(i) + 0.5) / f64::from(CELLS));
            let mut cells: Vec<f64> = cells.filter(|cell| beyond(cell, inside)).collect();
            cells.sort_by(|a, b| (way * b).total_cmp(&(way * a)));
            // if there is only one basin, the steps in `end` find the end
            if self.minima.len() > 1 {
                inside = cells.into_iter().find(|cell| self.excess(key, *cell) < level).unwrap_or(inside);
            }
            self.end(key, way, inside, reach)
        })
    }

    fn end(&self, key: usize, way: f64, mut inside: f64, reach: f64) -> Option<f64> {
        let bound = if way < 0.0 { 0.0 } else { 1.0 };
        let mut step = (1.1 * reach * self.sd(key)).max(1e-9);
        let outside = loop {
            let next = if way < 0.0 { (inside - step).max(bound) } else { (inside + step).min(bound) };
            if self.excess(key, next) >= reach * reach {
                break next;
            }
            if next == bound {
                return None;
            }
            (inside, step) = (next, 2.0 * step);
        };
        let (at, width) = (|t: f64| inside + t * (outside - inside), outside - inside);
        // the square root of the rise is nearly linear
        let rise = |t: f64| {
            let root = self.excess(key, at(t)).sqrt();
            let slope = root / (at(t) - self.best().shares[key]) * width;
            (reach - root, -slope)
        };
        let is_near = |t: f64, next: f64| (t - next).abs() < 1e-6;
        Some(at(bracketed((0.0, 1.0), 0.9, is_near, rise)))
    }

    /// The likelihood over that of the best place. If the noise is estimated, the likelihood is integrated over the
    /// noise.
    fn relative(&self, sum: f64) -> f64 {
        let excess = (sum - self.best().sum).max(0.0);
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        let values = self.problem.counted.len() as f64;
        exp(self.freedom().map_or(-0.5 * excess, |freedom| -0.5 * values * ln_1p(excess / freedom)))
    }

    /// The density of the posterior of two keys around the region of this probability, over its largest value: that of
    /// a normal distribution, or of Student's if the noise is estimated.
    pub fn density_around(&self, probability: f64) -> f64 {
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        let values = self.problem.counted.len() as f64;
        pow(1.0 - probability, self.freedom().map_or(1.0, |freedom| values / freedom))
    }

    /// The posterior of both keys. If the measurements determine a combination of the keys, it is a narrow ridge. So for
    /// each share of the first key the second is sampled around the crest of the ridge.
    pub fn sheet(&self) -> Sheet {
        let (nodes, across) = if self.problem.counted.len() > MANY { (20, 12) } else { (80, 30) };
        let wide = self.wide();
        let [low, high] = self.ends(0, wide);
        let (low, high) = (low.unwrap_or(0.0), high.unwrap_or(1.0));
        let sd = self.sd(0);
        let about = self.minima.iter().filter(|place| place.sum - self.best().sum < wide * wide);
        let about = about.map(|place| place.shares[0]).filter(|_| WIDE * sd < 0.25 * (high - low));
        let about = about.flat_map(|at| spread(at, sd, wide, nodes));
        let even = (0..=nodes).map(|i| low + (high - low) * f64::from(i) / f64::from(nodes));
        let mut shares: Vec<f64> = even.chain(about).filter(|at| (low..=high).contains(at)).collect();
        shares.sort_by(f64::total_cmp);
        shares.dedup();
        shares.into_iter().map(|share| (share, self.across(share, wide, across))).collect()
    }

    /// Half of the range of the posterior, in standard deviations. Student's distribution, for an estimated noise, is
    /// wider than the normal one.
    fn wide(&self) -> f64 {
        reach(OUTSIDE, self.freedom()).min(MOST_WIDE)
    }

    /// The posterior along the second key.
    fn across(&self, share: f64, wide: f64, count: u32) -> Vec<(f64, f64)> {
        let crest = self.lowest(0, share);
        let columns = self.problem.jacobian(&crest.shares);
        let sd = columns.map_or(1.0, |columns| 1.0 / columns.column(1).norm()).min(1.0);
        let density = |at: f64| (at, self.relative(self.problem.sum(&[share, at])));
        let mut places: Vec<f64> = spread(crest.shares[1], sd, wide, count).map(|at| at.clamp(0.0, 1.0)).collect();
        places.dedup();
        places.into_iter().map(density).collect()
    }
}

/// With more values than this each place takes seconds. The posterior is then smooth, so fewer places are enough.
const MANY: usize = 3000;
/// The normal distribution is sampled this far on each side, in standard deviations;
const WIDE: f64 = 4.5;
/// this is its probability inside, which others are sampled to as well, but not farther than
const OUTSIDE: f64 = 0.999_993_204_653_750_7;
/// so many standard deviations.
const MOST_WIDE: f64 = 1000.0;
/// Number of places at which separate basins are searched.
const CELLS: u32 = 32;

/// Places about `at`, dense near it, up to `wide` standard deviations away; nearly even up to [`WIDE`].
fn spread(at: f64, sd: f64, wide: f64, count: u32) -> impl Iterator<Item = f64> {
    let end = ln(wide / WIDE + hypot(wide / WIDE, 1.0));
    (0..=count).map(move |i| at + WIDE * sd * sinh(end * (2.0 * f64::from(i) / f64::from(count) - 1.0)))
}
