//! Intervals by the profile likelihood, and the posterior on a grid.

use super::error::NoAnswer;
use super::fit::Fit;
use super::minimum::{Place, polished};
use super::statistics::{LEVELS, reach};
use crate::math::functions::{exp, ln_1p};
use crate::math::root::bracketed;

/// Both ends of an interval; `None` if an end lies outside of the range of the key.
pub type Ends = [Option<f64>; 2];

/// The posterior of one key.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Marginal {
    /// Shares of the key, rising.
    pub shares: Vec<f64>,
    /// Probability density at each share; its integral over the shares is 1.
    pub density: Vec<f64>,
}

/// The posterior of two keys: each share of the first key, with shares of the second key and the density there.
pub type Sheet = Vec<(f64, Vec<(f64, f64)>)>;

impl Fit<'_> {
    fn sd(&self, key: usize) -> f64 {
        self.covariance.as_ref().map_or(1.0, |covariance| covariance[key][key].sqrt()).min(1.0)
    }

    /// The place with the lowest sum that has this share of this key.
    fn lowest(&self, key: usize, share: f64) -> Place {
        let best = &self.best().shares;
        let mut start = best.clone();
        if best.len() == 1 {
            return Place { shares: vec![share], sum: self.problem.sum(&[share]) };
        }
        let other = 1 - key;
        if let Some(covariance) = &self.covariance {
            let slope = covariance[0][1] / covariance[key][key];
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
        LEVELS.map(|level| self.ends(key, reach(level, self.freedom)))
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
            Ok::<_, NoAnswer>((reach - root, -slope))
        };
        let is_near = |t: f64, next: f64| (t - next).abs() < 1e-6;
        bracketed((0.0, 1.0), 0.9, is_near, rise).ok().map(at)
    }

    /// The likelihood over that of the best place. If the noise is estimated, the likelihood is integrated over the
    /// noise.
    fn relative(&self, sum: f64) -> f64 {
        let excess = (sum - self.best().sum).max(0.0);
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        let values = self.problem.counted.len() as f64;
        exp(self.freedom.map_or(-0.5 * excess, |freedom| -0.5 * values * ln_1p(excess / freedom)))
    }

    /// Shares of a key at which the posterior is computed.
    fn nodes(&self, key: usize, count: u32) -> Vec<f64> {
        let [low, high] = self.ends(key, WIDE);
        let (low, high) = (low.unwrap_or(0.0), high.unwrap_or(1.0));
        let even = |low: f64, high: f64| (0..=count).map(move |i| low + (high - low) * f64::from(i) / f64::from(count));
        let sd = self.sd(key);
        let about = self.minima.iter().filter(|place| place.sum - self.best().sum < WIDE * WIDE);
        let about = about.map(|place| place.shares[key]).filter(|_| WIDE * sd < 0.25 * (high - low));
        let about: Vec<f64> = about.flat_map(|at| even(at - WIDE * sd, at + WIDE * sd)).collect();
        let mut nodes: Vec<f64> = even(low, high).chain(about).filter(|at| (low..=high).contains(at)).collect();
        nodes.sort_by(f64::total_cmp);
        nodes.dedup();
        nodes
    }

    /// The posterior of the only key.
    pub fn posterior(&self) -> Marginal {
        let shares = self.nodes(0, if self.problem.counted.len() > MANY { 60 } else { 400 });
        let density = shares.iter().map(|share| self.relative(self.problem.sum(&[*share]))).collect();
        Marginal { shares, density }.normalised()
    }

    /// The posterior of both keys, for every share of `key`, and the posterior of `key` alone. If the measurements
    /// determine a combination of the keys, the posterior is a narrow ridge. So for each share of `key` the other key
    /// is sampled around the crest of the ridge.
    pub fn sheet(&self, key: usize) -> (Sheet, Marginal) {
        let other = 1 - key;
        let many = if self.problem.counted.len() > MANY { (20, 12) } else { (80, 30) };
        let sheet: Sheet =
            self.nodes(key, many.0).into_iter().map(|share| (share, self.across(key, other, share, many.1))).collect();
        let mass = |line: &Vec<(f64, f64)>| trapezoids(line.iter().copied());
        let (shares, density) = sheet.iter().map(|(share, line)| (*share, mass(line))).unzip();
        (sheet, Marginal { shares, density }.normalised())
    }

    fn across(&self, key: usize, other: usize, share: f64, count: u32) -> Vec<(f64, f64)> {
        let crest = self.lowest(key, share);
        let columns = self.problem.jacobian(&crest.shares);
        let square = columns.map(|columns| columns[other].iter().map(|slope| slope * slope).sum::<f64>());
        let sd = square.map_or(1.0, |square| 1.0 / square.sqrt()).min(1.0);
        let (low, high) = ((crest.shares[other] - WIDE * sd).max(0.0), (crest.shares[other] + WIDE * sd).min(1.0));
        let at = |i: u32| low + (high - low) * f64::from(i) / f64::from(count);
        let density = |at: f64| {
            let mut shares = crest.shares.clone();
            shares[other] = at;
            (at, self.relative(self.problem.sum(&shares)))
        };
        (0..=count).map(|i| density(at(i))).collect()
    }
}

/// With more values than this each place takes seconds. The posterior is then smooth, so fewer places are enough.
const MANY: usize = 3000;
/// Range of the posterior on each side, in standard deviations.
const WIDE: f64 = 4.5;
/// Number of places at which separate basins are searched.
const CELLS: u32 = 32;

/// The area under the points, by the trapezoidal rule.
fn trapezoids(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<(f64, f64)> = points.collect();
    points.windows(2).map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1)).sum()
}

impl Marginal {
    fn normalised(mut self) -> Self {
        let area = trapezoids(self.shares.iter().copied().zip(self.density.iter().copied()));
        self.density.iter_mut().for_each(|density| *density /= area);
        self
    }

    /// The share below which the posterior has this probability.
    pub fn quantile(&self, probability: f64) -> f64 {
        let mut below = 0.0;
        for (x, p) in self.shares.windows(2).zip(self.density.windows(2)) {
            let area = 0.5 * (x[1] - x[0]) * (p[0] + p[1]);
            if below + area >= probability && area > 0.0 {
                return x[0] + (x[1] - x[0]) * (probability - below) / area;
            }
            below += area;
        }
        self.shares.last().copied().unwrap_or(f64::NAN)
    }
}
