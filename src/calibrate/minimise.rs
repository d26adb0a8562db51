//! The minimum of the objective, by recursion. With one free key the objective itself is searched. With two free keys the profile is
//! searched: the objective minimised over the other key.
//!
//! The sum has a kink wherever an impact passes a knot of the law, and a plateau where impacts stay elastic. So no derivatives
//! are used.
//!
//! [`super::inverse`] searches the keys of a wanted result with the same functions.

use rayon::prelude::*;

use super::problem::CalibrationProblem;

/// This number of impacts is enough to find the cells with basins.
const MAX_SCREENED_ROWS: usize = 1000;
/// Cells along the range of a key, and along the range of a key inside of a profile.
const CELLS: u32 = 64;
const CELLS_INSIDE: u32 = 24;
/// The maximum number of basins whose minimum is computed.
const MAX_BASINS: usize = 8;
/// Two minima are in different basins if the sum between them rises by this multiple of its mean per value.
const BARRIER_PER_VALUE: f64 = 1.0;
/// Tolerance of the share of the first key, and of a key inside of a profile.
const TOLERANCE: f64 = 1e-9;
const INNER_TOLERANCE: f64 = 1e-7;

/// A point in the ranges of the keys, and its objective.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterPoint {
    /// Shares of the ranges.
    pub shares: Vec<f64>,
    /// −2 ln of the likelihood.
    pub sum: f64,
}

/// A function of shares that is minimised: a sum with one term for each value.
pub trait Objective: Sync {
    /// The sum; infinite if the law gives no result.
    fn objective(&self, shares: &[f64]) -> f64;

    /// The number of terms.
    fn n_values(&self) -> usize;
}

impl Objective for CalibrationProblem<'_> {
    fn objective(&self, shares: &[f64]) -> f64 {
        CalibrationProblem::objective(self, shares)
    }

    fn n_values(&self) -> usize {
        self.used_values.len()
    }
}

/// A part of the range of a key, as shares, and the cells in it. A key that is held has a range without width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShareRange {
    low: f64,
    high: f64,
    cells: u32,
}

impl ShareRange {
    pub const WHOLE: Self = Self { low: 0.0, high: 1.0, cells: CELLS };

    /// The whole range with another number of cells.
    pub fn with_cells(cells: u32) -> Self {
        Self { cells, ..Self::WHOLE }
    }

    pub fn with_share(share: f64) -> Self {
        Self { low: share, high: share, cells: 0 }
    }

    /// The range of one cell on each side of a share.
    pub fn with_centre(share: f64) -> Self {
        let cell = 1.0 / f64::from(CELLS);
        Self { low: (share - cell).max(0.0), high: (share + cell).min(1.0), cells: 4 }
    }

    /// The nodes: both ends, and the middles of the cells between them.
    pub(super) fn nodes(self) -> Vec<f64> {
        let width = (self.high - self.low) / f64::from(self.cells);
        let middles = (0..self.cells).map(|i| self.low + (f64::from(i) + 0.5) * width);
        [self.low].into_iter().chain(middles).chain([self.high]).collect()
    }
}

/// True if two sums differ only by rounding.
pub fn is_equal_within_rounding(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= 1e-11 * a.abs().max(b.abs()) + 1e-24
}

/// The problem with all measurements, and a smaller problem with a subsample, which is used to find the basins.
#[derive(Debug, Clone)]
pub struct BasinSearch<'p, 'a> {
    whole: &'p CalibrationProblem<'a>,
    subsampled: CalibrationProblem<'a>,
}

impl<'p, 'a> BasinSearch<'p, 'a> {
    pub fn new(problem: &'p CalibrationProblem<'a>) -> Self {
        Self { whole: problem, subsampled: problem.subsampled(MAX_SCREENED_ROWS) }
    }

    /// The minima of all basins in these ranges, the lowest first; empty if the law gives no result anywhere.
    pub fn minima(&self, ranges: &[ShareRange]) -> Vec<ParameterPoint> {
        find_minima(self.whole, &self.subsampled, ranges, TOLERANCE)
    }

    /// The point with the lowest objective; the objective is infinite if the law gives no result anywhere.
    pub fn profile_minimum(&self, ranges: &[ShareRange]) -> ParameterPoint {
        profile_minimum(self.whole, &self.subsampled, ranges)
    }
}

fn profile_minimum<O: Objective>(whole: &O, subsampled: &O, ranges: &[ShareRange]) -> ParameterPoint {
    let ranges: Vec<ShareRange> =
        ranges.iter().map(|range| ShareRange { cells: range.cells.min(CELLS_INSIDE), ..*range }).collect();
    let nowhere = || ParameterPoint { shares: ranges.iter().map(|range| range.low).collect(), sum: f64::INFINITY };
    find_minima(whole, subsampled, &ranges, INNER_TOLERANCE).into_iter().next().unwrap_or_else(nowhere)
}

/// The minima of all basins in these ranges, the lowest first, to this tolerance of the shares. The problem `subsampled` is enough
/// to find the cells with basins.
pub fn find_minima<O: Objective>(whole: &O, subsampled: &O, ranges: &[ShareRange], exact: f64) -> Vec<ParameterPoint> {
    let Some(key) = ranges.iter().position(|range| range.cells > 0) else {
        let shares: Vec<f64> = ranges.iter().map(|range| range.low).collect();
        let place = ParameterPoint { sum: whole.objective(&shares), shares };
        return Some(place).filter(|place| place.sum.is_finite()).into_iter().collect();
    };
    let with = |share: f64| {
        let mut ranges = ranges.to_vec();
        ranges[key] = ShareRange::with_share(share);
        ranges
    };
    let sum_at = |share: &f64| profile_minimum(subsampled, subsampled, &with(*share)).sum;
    let mut nodes = ranges[key].nodes();
    let mut sums: Vec<f64> = nodes.par_iter().map(sum_at).collect();
    split_equal_pairs(&mut nodes, &mut sums, sum_at);
    let place = |share: f64| profile_minimum(whole, subsampled, &with(share));
    let bottom = |[first, last]: [usize; 2]| {
        let [before, after] = [first.saturating_sub(1), (last + 1).min(nodes.len() - 1)].map(|at| nodes[at]);
        if first == last {
            return (first, brent([before, after], nodes[first], exact, place));
        }
        // the minimum may lie beside a plateau, on either side
        let sides = [(before, nodes[first], nodes[first]), (nodes[last], after, nodes[last])];
        let sides = sides.into_iter().filter(|(low, high, _)| low < high);
        let found = sides.map(|(low, high, start)| brent([low, high], start, exact, place));
        let lower = |a: ParameterPoint, b: ParameterPoint| {
            if b.sum < a.sum && !is_equal_within_rounding(a.sum, b.sum) { b } else { a }
        };
        (first, found.reduce(lower).unwrap_or_else(|| place(nodes[first])))
    };
    let bottoms = basins(&sums).into_iter().take(MAX_BASINS).map(bottom);
    let mut found: Vec<(usize, ParameterPoint)> = bottoms.filter(|(_, place)| place.sum.is_finite()).collect();
    found.sort_by(|a, b| a.1.sum.total_cmp(&b.1.sum));
    let mut apart: Vec<(usize, ParameterPoint)> = Vec::new();
    for (at, place) in found {
        let least = place.sum + BARRIER_PER_VALUE * place.sum / whole.n_values() as f64 + f64::MIN_POSITIVE.sqrt();
        let is_apart = |(other, _): &(usize, ParameterPoint)| {
            sums[(*other).min(at)..=(*other).max(at)].iter().copied().fold(0.0, f64::max) > least
        };
        if apart.iter().all(is_apart) {
            apart.push((at, place));
        }
    }
    apart.into_iter().map(|(_, place)| place).collect()
}

/// Two neighbouring nodes with equal sums lie on a plateau, or on both sides of a minimum or a maximum. The middle between them
/// decides: it becomes a node if its sum is another one. More than two nodes with equal sums are a plateau.
fn split_equal_pairs(nodes: &mut Vec<f64>, sums: &mut Vec<f64>, sum_at: impl Fn(&f64) -> f64) {
    let mut pairs = basins(sums);
    pairs.retain(|[first, last]| last - first == 1);
    // the last pair first, because a new node shifts all nodes after it
    pairs.sort_unstable_by(|a, b| b.cmp(a));
    for [first, last] in pairs {
        let middle = 0.5 * (nodes[first] + nodes[last]);
        let sum = sum_at(&middle);
        if !is_equal_within_rounding(sum, sums[first]) {
            nodes.insert(last, middle);
            sums.insert(last, sum);
        }
    }
}

/// The first and the last node with the lowest objective in each basin. The lowest basin comes first.
fn basins(sums: &[f64]) -> Vec<[usize; 2]> {
    let (mut basins, mut first) = (Vec::new(), 0);
    for level in sums.chunk_by(|a, b| is_equal_within_rounding(*a, *b)) {
        let last = first + level.len() - 1;
        let mut neighbours = [first.checked_sub(1), Some(last + 1)].into_iter().flatten().filter_map(|at| sums.get(at));
        if level[0].is_finite() && neighbours.all(|sum| *sum > level[0]) {
            basins.push([first, last]);
        }
        first = last + 1;
    }
    basins.sort_by(|a, b| sums[a[0]].total_cmp(&sums[b[0]]));
    basins
}

/// The minimum between two shares by the method of Brent (1973): parabolas, and the golden section where they do not help.
/// If two sums are equal, the share that is farther from the start is taken. So a search that starts on a plateau stops at the
/// end of the plateau.
fn brent(
    [mut low, mut high]: [f64; 2],
    start: f64,
    exact: f64,
    place: impl Fn(f64) -> ParameterPoint,
) -> ParameterPoint {
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    let mut best = (start, place(start));
    let (mut second, mut third) = (best.clone(), best.clone());
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    while (best.0 - 0.5 * (low + high)).abs() + 0.5 * (high - low) > 2.0 * exact {
        let x = best.0;
        let r = (x - second.0) * (best.1.sum - third.1.sum);
        let q = (x - third.0) * (best.1.sum - second.1.sum);
        let parabolic = -((x - third.0) * q - (x - second.0) * r) / (2.0 * (q - r));
        let is_good = parabolic.abs() < 0.5 * before.abs() && x + parabolic > low && x + parabolic < high;
        (before, step) = if is_good {
            (step, parabolic)
        } else {
            let rest = if x < 0.5 * (low + high) { high - x } else { low - x };
            (rest, GOLDEN * rest)
        };
        let share = (x + if step.abs() < exact { exact.copysign(step) } else { step }).clamp(low, high);
        let tried = (share, place(share));
        let is_better = if is_equal_within_rounding(tried.1.sum, best.1.sum) {
            (share - start).abs() > (x - start).abs()
        } else {
            tried.1.sum < best.1.sum
        };
        if is_better {
            *(if share >= x { &mut low } else { &mut high }) = x;
            (third, second, best) = (second, best, tried);
        } else {
            *(if share < x { &mut low } else { &mut high }) = share;
            if tried.1.sum <= second.1.sum || second.0 == x {
                (third, second) = (second, tried);
            } else if tried.1.sum <= third.1.sum || third.0 == x || third.0 == second.0 {
                third = tried;
            }
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::{Objective, ShareRange, find_minima};
    use crate::numerics::functions::powi;

    struct Function(fn(f64) -> f64);

    impl Objective for Function {
        fn objective(&self, shares: &[f64]) -> f64 {
            (self.0)(shares[0])
        }

        fn n_values(&self) -> usize {
            1
        }
    }

    /// Asserts that the minima of this function from 0 to 1 are these.
    fn assert_minima(function: fn(f64) -> f64, wanted: &[f64]) {
        let function = Function(function);
        let minima = find_minima(&function, &function, &[ShareRange::WHOLE], 1e-9);
        let mut shares: Vec<f64> = minima.iter().map(|place| place.shares[0]).collect();
        shares.sort_by(f64::total_cmp);
        let is_close = |(share, wanted): (&f64, &f64)| (share - wanted).abs() < 1e-6;
        assert!(shares.len() == wanted.len() && shares.iter().zip(wanted).all(is_close), "{shares:?}, not {wanted:?}");
    }

    /// The distance between the middle of the range and the nodes beside it, which have equal sums below.
    const HALF_CELL: f64 = 1.0 / 128.0;

    #[test]
    fn minimum_between_equal_nodes_is_found() {
        assert_minima(|x| powi(x - 0.5, 2), &[0.5]);
        // equal nodes at the lower end of the range
        assert_minima(|x| powi(x - 0.5 * HALF_CELL, 2), &[0.5 * HALF_CELL]);
        // a flat bottom narrower than a cell: the middle is the start of the search, which ends at one end of the bottom
        let flat = |x: f64| ((x - 0.5).abs() - 0.5 * HALF_CELL).max(0.0);
        let place = find_minima(&Function(flat), &Function(flat), &[ShareRange::WHOLE], 1e-9).remove(0);
        assert_eq!(place.sum, 0.0);
    }

    #[test]
    fn equal_nodes_beside_maximum_are_two_minima() {
        const OUTSIDE: f64 = 1.6 * HALF_CELL;
        const BETWEEN: f64 = 0.8 * HALF_CELL;
        assert_minima(|x| powi(powi(x - 0.5, 2) - OUTSIDE * OUTSIDE, 2), &[0.5 - OUTSIDE, 0.5 + OUTSIDE]);
        assert_minima(|x| powi(powi(x - 0.5, 2) - BETWEEN * BETWEEN, 2), &[0.5 - BETWEEN, 0.5 + BETWEEN]);
    }

    #[test]
    fn search_on_plateau_ends_where_it_ends() {
        assert_minima(|x| (x - 0.3).max(0.0), &[0.3]);
        assert_minima(|x| (0.7 - x).max(0.0), &[0.7]);
        // two nodes on it
        assert_minima(|x| ((x - 0.501).abs() - 0.011).max(0.0), &[0.49]);
    }

    /// A function that is 1 from 0.3 to 0.588 and rises below. It has a dip between 0.588 and the next node.
    fn plateau_with_dip(x: f64) -> f64 {
        1.0 + (0.3 - x).max(0.0) + if x > 0.588 { 1000.0 * powi(x - 0.593, 2) - 0.025 } else { 0.0 }
    }

    #[test]
    fn minimum_beside_plateau_is_found() {
        assert_minima(plateau_with_dip, &[0.593]);
        assert_minima(|x| plateau_with_dip(1.0 - x), &[0.407]);
    }
}
