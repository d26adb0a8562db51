//! Intervals by the profile likelihood, and the region of two keys.

use std::f64::consts::PI;

use nalgebra::{Cholesky, DMatrix};

use super::fit::Fit;
use super::minimise::{BasinSearch, ParameterPoint, ShareRange};
use super::statistics::{LEVELS, half_width};
use crate::numerics::functions::{exp_m1, ln_1p, sin_cos};
use crate::numerics::root::newton_bisection;

/// Both ends of an interval; `None` if an end lies outside of the range of the key.
pub type IntervalEnds = [Option<f64>; 2];

impl Fit<'_> {
    fn sd(&self, key: usize) -> f64 {
        self.covariance.as_ref().map_or(1.0, |covariance| covariance[(key, key)].sqrt()).min(1.0)
    }

    /// The deviance at this share of a key: the objective minimised over the other keys, minus its global minimum.
    fn deviance(&self, key: usize, share: f64) -> f64 {
        let mut ranges = vec![ShareRange::WHOLE; self.problem.free.len()];
        ranges[key] = ShareRange::with_share(share);
        (BasinSearch::new(&self.problem).profile_minimum(&ranges).sum - self.best().sum).max(0.0)
    }

    /// The intervals of the share of a key at both levels.
    pub fn intervals(&self, key: usize) -> [IntervalEnds; 2] {
        LEVELS.map(|level| self.interval_ends(key, half_width(level, self.degrees_of_freedom())))
    }

    /// The shares on both sides at which the deviance is the square of `reach`.
    fn interval_ends(&self, key: usize, reach: f64) -> IntervalEnds {
        let level = reach * reach;
        [-1.0, 1.0].map(|direction| {
            let beyond = |share: &f64, than: f64| direction * (share - than) > 0.0;
            // the outermost share that is certainly inside of the interval: a minimum, or a cell of the grid
            let basins = self.minima.iter().filter(|place| place.sum - self.best().sum < level);
            let mut inside = basins.map(|place| place.shares[key]).fold(self.best().shares[key], |outermost, share| {
                if beyond(&share, outermost) { share } else { outermost }
            });
            let cells = (0..CELLS).map(|i| (f64::from(i) + 0.5) / f64::from(CELLS));
            let mut cells: Vec<f64> = cells.filter(|cell| beyond(cell, inside)).collect();
            cells.sort_by(|a, b| (direction * b).total_cmp(&(direction * a)));
            // if there is only one basin, the steps in `end` find the end
            if self.minima.len() > 1 {
                inside = cells.into_iter().find(|cell| self.deviance(key, *cell) < level).unwrap_or(inside);
            }
            self.interval_end(key, direction, inside, reach)
        })
    }

    fn interval_end(&self, key: usize, direction: f64, mut inside: f64, reach: f64) -> Option<f64> {
        let bound = if direction < 0.0 { 0.0 } else { 1.0 };
        let mut step = (1.1 * reach * self.sd(key)).max(1e-9);
        let outside = loop {
            let next = if direction < 0.0 { (inside - step).max(bound) } else { (inside + step).min(bound) };
            if self.deviance(key, next) >= reach * reach {
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
            let root = self.deviance(key, at(t)).sqrt();
            let slope = root / (at(t) - self.best().shares[key]) * width;
            (reach - root, -slope)
        };
        let is_near = |t: f64, next: f64| (t - next).abs() < 1e-6;
        Some(at(newton_bisection((0.0, 1.0), 0.9, is_near, rise)))
    }

    /// The outlines of the confidence region of two keys at this probability, as shares: one outline around every minimum inside of the
    /// region. The deviance on the outline follows from the F distribution with 2 degrees of freedom, or from chi-square if the noise
    /// is known.
    pub fn region(&self, probability: f64) -> Vec<Vec<[f64; 2]>> {
        let beyond = -2.0 * ln_1p(-probability);
        let rise = self.degrees_of_freedom().map_or(beyond, |freedom| freedom * exp_m1(beyond / freedom));
        let Some(axes) = self.covariance.clone().and_then(Cholesky::new) else { return Vec::new() };
        let minima = self.minima.iter().filter(|place| place.sum - self.best().sum < rise);
        minima.map(|place| self.outline(place, &axes.l(), rise)).collect()
    }

    /// The points on rays from a minimum at which the deviance has this value, or at which the range of a key ends. The rays have even
    /// angles on the scale of the standard deviations.
    fn outline(&self, from: &ParameterPoint, axes: &DMatrix<f64>, rise: f64) -> Vec<[f64; 2]> {
        let [x, y] = [from.shares[0], from.shares[1]];
        let place = |ray: u32| {
            let (sin, cos) = sin_cos(2.0 * PI * f64::from(ray % RAYS) / f64::from(RAYS));
            let [dx, dy] = [0, 1].map(|key| axes[(key, 0)] * cos + axes[(key, 1)] * sin);
            let at = |t: f64| [x + t * dx, y + t * dy];
            let room = |from: f64, by: f64| if by > 0.0 { (1.0 - from) / by } else { from / -by };
            let end = room(x, dx).min(room(y, dy));
            // the square root of the rise is nearly linear
            let short =
                |t: f64| (rise.sqrt() - (self.problem.objective(&at(t)) - self.best().sum).max(0.0).sqrt(), -1.0);
            let (mut inside, mut outside) = (0.0, rise.sqrt().min(end));
            while short(outside).0 > 0.0 && outside < end {
                (inside, outside) = (outside, (2.0 * outside).min(end));
            }
            let is_near = |t: f64, next: f64| (t - next).abs() < 1e-3 * next;
            at(if short(outside).0 > 0.0 {
                end
            } else {
                newton_bisection((inside, outside), rise.sqrt(), is_near, short)
            })
        };
        (0..=RAYS).map(place).collect()
    }
}

const RAYS: u32 = 72;
/// The number of shares at which separate basins are searched.
const CELLS: u32 = 32;
