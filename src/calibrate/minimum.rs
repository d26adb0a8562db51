//! The minimum of the sum: a grid over the ranges finds all basins, and Levenberg-Marquardt finds the minimum of each.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::DVector;

use super::problem::Problem;
use crate::math::functions::{asin, sin};
use crate::math::least_squares::least_squares;

/// This number of impacts is enough to find the basins.
const ENOUGH: usize = 1000;
/// Number of finer grids on which the edge of a plateau is searched, and cells along their sides.
const ZOOMS: u32 = 4;
const FINER: u32 = 32;
/// With more values than this the kinks of single values are too small to matter.
const MOST_KINKS: usize = 20_000;
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

/// The sums of the thinned data in the middles of cells, along the range of each key or along a part of it.
#[derive(Debug, Clone)]
pub struct Grid {
    places: Vec<Place>,
    /// Width of a cell, as a share of the range.
    cell: f64,
}

impl Grid {
    /// Computes the sums over the whole ranges.
    pub fn of(problem: &Problem) -> Self {
        let n_keys = problem.free.len();
        Self::over(&problem.thinned(ENOUGH), &vec![0.0; n_keys], 1.0, if n_keys == 1 { 64 } else { 32 })
    }

    /// The grid over parts of the ranges, with their lower ends and their common width.
    fn over(problem: &Problem, low: &[f64], width: f64, side: u32) -> Self {
        let cell = width / f64::from(side);
        let mut all = vec![Vec::new()];
        for low in low {
            let middles = (0..side).map(|i| low + (f64::from(i) + 0.5) * cell);
            all = all.iter().flat_map(|shares| middles.clone().map(move |at| [&shares[..], &[at]].concat())).collect();
        }
        let place = |shares: Vec<f64>| Place { sum: problem.sum(&shares), shares };
        Self { places: all.into_iter().map(place).collect(), cell }
    }

    /// The sums of the cells around a cell.
    fn around(&self, middle: &Place) -> impl Iterator<Item = f64> {
        let reach = 1.5 * self.cell;
        let near = move |(a, b): (&f64, &f64)| (a - b).abs() < reach;
        let others = self.places.iter().filter(|other| other.shares != middle.shares);
        others.filter(move |other| other.shares.iter().zip(&middle.shares).all(near)).map(|other| other.sum)
    }

    /// The cells that are not higher than any neighbour, the lowest first. Cells inside of a plateau do not count.
    fn lowest(&self) -> Vec<&Place> {
        let is_lowest = |place: &&Place| {
            let (own, mut has_higher) = (place.sum, false);
            let mut around = self.around(place);
            own.is_finite()
                && around.all(|other| {
                    has_higher |= !is_same(other, own);
                    other >= own || is_same(other, own)
                })
                && has_higher
        };
        let mut lowest: Vec<&Place> = self.places.iter().filter(is_lowest).collect();
        if lowest.is_empty() {
            // one plateau is everywhere
            lowest.extend(self.places.iter().find(|place| place.sum.is_finite()));
        }
        lowest.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        lowest
    }

    /// A place in every basin, the lowest first. Where impacts stay elastic, e is 1 and the sum has a plateau. The basin
    /// beside it may be narrower than a cell, so the edge of the plateau is searched on finer grids.
    fn basins(&self, problem: &Problem) -> Vec<Vec<f64>> {
        let problem = problem.thinned(ENOUGH);
        let start = |lowest: &Place| {
            let (mut finer, mut place) = (self.clone(), lowest.clone());
            for _ in 0..ZOOMS {
                if !finer.around(&place).any(|other| is_same(other, place.sum)) {
                    break;
                }
                let width = 4.0 * finer.cell;
                let low = place.shares.iter().map(|share| (share - 0.5 * width).clamp(0.0, 1.0 - width));
                finer = Self::over(&problem, &low.collect::<Vec<_>>(), width, FINER);
                let Some(lowest) = finer.lowest().first().copied() else { break };
                place = lowest.clone();
            }
            place.shares
        };
        self.lowest().into_iter().take(MOST_BASINS).map(start).collect()
    }

    /// The cell with the lowest sum among those that contain this share of the key `held`.
    pub(super) fn best_beside(&self, held: usize, share: f64) -> Option<Vec<f64>> {
        let near = |place: &&Place| (place.shares[held] - share).abs() <= 0.5 * self.cell + 1e-12;
        let best = self.places.iter().filter(near).min_by(|a, b| a.sum.total_cmp(&b.sum));
        best.map(|place| place.shares.clone())
    }

    /// The range of shares around `place` of the only key in which the sum is the same; `None` if it is one point.
    pub(super) fn plateau(&self, problem: &Problem, place: &Place) -> Option<[f64; 2]> {
        let [best] = place.shares[..] else { return None };
        let is_level = |share: &f64| is_same(problem.sum(&[*share]), place.sum);
        let cells: Vec<f64> = self.places.iter().map(|place| place.shares[0]).collect();
        let level = |end: f64, cells: &mut dyn Iterator<Item = f64>| {
            let last = cells.take_while(is_level).last();
            last.map(|last| if (last - end).abs() < self.cell && is_level(&end) { end } else { last })
        };
        let above = level(1.0, &mut cells.iter().copied().filter(|cell| *cell > best));
        let below = level(0.0, &mut cells.iter().rev().copied().filter(|cell| *cell < best));
        (above.is_some() || below.is_some()).then(|| [below.unwrap_or(best), above.unwrap_or(best)])
    }
}

/// Whether two sums differ only by rounding.
fn is_same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-24
}

/// The minima of all basins, the lowest first; empty if the law gives no result anywhere.
pub fn minima(problem: &Problem, grid: &Grid) -> Vec<Place> {
    minima_from(problem, &grid.basins(problem))
}

/// The minima of the basins in which these places lie, the lowest first.
pub fn minima_from(problem: &Problem, starts: &[Vec<f64>]) -> Vec<Place> {
    let lowest = |start: &Vec<f64>| match start[..] {
        [] => Place { sum: problem.sum(start), shares: Vec::new() },
        _ => past_kinks(problem, polished(problem, start, None)),
    };
    let mut places: Vec<Place> = starts.iter().map(lowest).collect();
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

/// The sum has a kink wherever an impact passes a knot of the law. The method of Levenberg and Marquardt takes the sum for
/// smooth, so it may stop at a kink from which the sum falls to one side. From there a search in steps along the
/// principal axes goes on, first of one standard deviation, then of ever smaller ones.
fn past_kinks(problem: &Problem, place: Place) -> Place {
    let values = problem.counted.len();
    let Ok(matrix) = problem.jacobian(&place.shares) else { return place };
    if values > MOST_KINKS || !place.sum.is_finite() {
        return place;
    }
    #[allow(clippy::cast_precision_loss)] // counts of measurements
    let per_value = place.sum / values as f64;
    let eigen = matrix.tr_mul(&matrix).symmetric_eigen();
    let axes: Vec<DVector<f64>> = eigen
        .eigenvectors
        .column_iter()
        .zip(eigen.eigenvalues.iter())
        .map(|(axis, square)| axis * (per_value / square).sqrt().clamp(0.0, 0.1))
        .collect();
    let mut directions = axes.clone();
    if let [a, b] = &axes[..] {
        directions.extend([a + b, a - b]);
    }
    let (mut best, mut step) = (place.clone(), 1.0);
    while step > 1e-5 {
        let tried = directions.iter().flat_map(|direction| [step, -step].map(|step| direction * step)).map(|move_by| {
            let shares: Vec<f64> =
                best.shares.iter().zip(move_by.iter()).map(|(share, by)| (share + by).clamp(0.0, 1.0)).collect();
            Place { sum: problem.sum(&shares), shares }
        });
        match tried.min_by(|a, b| a.sum.total_cmp(&b.sum)).filter(|tried| tried.sum < best.sum - 1e-9 * per_value) {
            Some(lower) => best = lower,
            None => step *= 0.5,
        }
    }
    // a smooth minimum stays where it was found
    if best.sum < place.sum - 1e-5 * per_value { best } else { place }
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
