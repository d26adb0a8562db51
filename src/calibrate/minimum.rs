//! The minimum of the sum: a grid over the ranges finds all basins, and Levenberg-Marquardt finds the minimum of each.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::DVector;

use super::problem::Problem;
use crate::math::functions::{asin, sin};
use crate::math::least_squares::least_squares;

/// This number of impacts is enough to find the basins.
const ENOUGH: usize = 1000;
/// Largest number of basins whose minimum is computed.
const MOST_BASINS: usize = 8;
/// Two minima are in different basins if the sum between them rises by this multiple of its mean per value.
const RISE: f64 = 1.0;

/// A place in the ranges of the keys, and the sum there.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Shares of the ranges.
    pub shares: Vec<f64>,
    /// −2 ln of the likelihood.
    pub sum: f64,
}

/// The sums of the thinned data on a grid over the ranges of the keys, with `side` places along each range.
#[derive(Debug, Clone)]
pub struct Grid {
    side: usize,
    sums: Vec<f64>,
    n_keys: usize,
}

impl Grid {
    /// Computes the sums.
    pub fn of(problem: &Problem) -> Self {
        let problem = problem.thinned(ENOUGH);
        let n_keys = problem.free.len();
        let side = if n_keys == 1 { 64 } else { 32 };
        let mut grid = Self { side, sums: Vec::new(), n_keys };
        grid.sums = (0..if n_keys == 1 { side } else { side * side }).map(|at| problem.sum(&grid.shares(at))).collect();
        grid
    }

    /// The shares at the middle of a cell.
    #[allow(clippy::cast_precision_loss)] // a few cells
    fn shares(&self, at: usize) -> Vec<f64> {
        let share = |place: usize| (place as f64 + 0.5) / self.side as f64;
        if self.n_keys == 1 { vec![share(at)] } else { vec![share(at / self.side), share(at % self.side)] }
    }

    /// The middles of the cells that are not higher than any neighbour, the lowest first.
    fn basins(&self) -> Vec<Vec<f64>> {
        let side = self.side.cast_signed();
        let rows = if self.n_keys == 1 { 1 } else { side };
        let is_lowest = |at: usize| {
            let (row, column) = (at.cast_signed() / side, at.cast_signed() % side);
            let inside = |&(row, column): &(isize, isize)| (0..rows).contains(&row) && (0..side).contains(&column);
            let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (row + i, column + j)));
            let mut around =
                around.filter(inside).map(|(row, column)| self.sums[(row * side + column).cast_unsigned()]);
            self.sums[at].is_finite() && around.all(|other| other >= self.sums[at])
        };
        let mut lowest: Vec<usize> = (0..self.sums.len()).filter(|at| is_lowest(*at)).collect();
        lowest.sort_by(|a, b| self.sums[*a].total_cmp(&self.sums[*b]));
        lowest.truncate(MOST_BASINS);
        lowest.into_iter().map(|at| self.shares(at)).collect()
    }

    /// The cell with the lowest sum among those that contain this share of the key `held`.
    pub(super) fn best_beside(&self, held: usize, share: f64) -> Option<Vec<f64>> {
        #[allow(clippy::cast_precision_loss)] // a few cells
        let near = |at: &usize| (self.shares(*at)[held] - share).abs() <= 0.5 / self.side as f64 + 1e-12;
        let best = (0..self.sums.len()).filter(near).min_by(|a, b| self.sums[*a].total_cmp(&self.sums[*b]));
        best.map(|at| self.shares(at))
    }
}

/// The minima of all basins, the lowest first; empty if the law gives no result anywhere.
pub fn minima(problem: &Problem, grid: &Grid) -> Vec<Place> {
    let starts = grid.basins();
    let mut places: Vec<Place> = starts.iter().map(|start| polished(problem, start, None)).collect();
    places.retain(|place| place.sum.is_finite());
    places.sort_by(|a, b| a.sum.total_cmp(&b.sum));
    let mut found: Vec<Place> = Vec::new();
    for place in places {
        if found.iter().all(|other| is_apart(problem, other, &place)) {
            found.push(place);
        }
    }
    found
}

/// Whether the sum rises between two places. If it does not, both are in one flat basin or on one plateau.
fn is_apart(problem: &Problem, lower: &Place, upper: &Place) -> bool {
    #[allow(clippy::cast_precision_loss)] // counts of measurements
    let least = RISE * upper.sum / problem.counted.len() as f64 + f64::MIN_POSITIVE.sqrt();
    (1..8).any(|i| {
        let way = f64::from(i) / 8.0;
        let between = lower.shares.iter().zip(&upper.shares).map(|(from, to)| from + way * (to - from));
        problem.sum(&between.collect::<Vec<_>>()) > upper.sum + least
    })
}

/// The minimum of the basin that `start` lies in. A key `held` keeps its share.
pub fn polished(problem: &Problem, start: &[f64], held: Option<usize>) -> Place {
    let moving: Vec<usize> = (0..start.len()).filter(|at| Some(*at) != held).collect();
    let first = Place { shares: start.to_vec(), sum: problem.sum(start) };
    // a share is (1 + sin a)/2, so every angle a gives a value within the range
    let angles = moving.iter().map(|at| asin(2.0 * start[*at].clamp(1e-9, 1.0 - 1e-9) - 1.0));
    let shares_at = |angles: &DVector<f64>| {
        let mut shares = start.to_vec();
        moving.iter().zip(angles.iter()).for_each(|(at, angle)| shares[*at] = 0.5 + 0.5 * sin(*angle));
        shares
    };
    let roots = |angles: &DVector<f64>| {
        let residuals = problem.residuals(&shares_at(angles)).ok()?;
        // the square of each is the part of the residual in the sum
        Some(residuals.iter().map(|residual| problem.loss(*residual).sqrt().copysign(*residual)).collect())
    };
    let angles = DVector::from_iterator(moving.len(), angles);
    let (angles, _) = least_squares(LevenbergMarquardt::new().with_patience(40), angles, roots);
    let mut shares = shares_at(&angles);
    // near an end of the range the share changes only with the square of the angle, so the end itself is never reached
    for share in &mut shares {
        if *share < 1e-9 || *share > 1.0 - 1e-9 {
            *share = share.round();
        }
    }
    let sum = problem.sum(&shares);
    if sum <= first.sum { Place { shares, sum } } else { first }
}
