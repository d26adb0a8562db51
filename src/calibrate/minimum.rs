//! The minimum of the sum over the keys that are not held, by recursion: over one key the sum is searched as it is, over two
//! keys the sum is that of the profile, which is minimised over the other key.
//!
//! The sum has a kink wherever an impact passes a knot of the law, and a plateau where impacts stay elastic. So no derivatives
//! are used.

use rayon::prelude::*;

use super::problem::Problem;
use crate::math::root::halved;

/// With this number of impacts the cells with basins are found.
const ENOUGH: usize = 1000;
/// Cells along the range of a key.
const CELLS: u32 = 64;
/// Nodes by which a basin is divided again, and how often this is done beside a plateau, where it may be narrower than a cell.
const FINER: u32 = 12;
const ZOOMS: u32 = 4;
/// Largest number of basins whose minimum is computed.
const MOST_BASINS: usize = 8;
/// Two minima are in different basins if the sum between them rises by this multiple of its mean per value.
const RISE: f64 = 1.0;
/// How exactly a share of the first key is found, and one of a key inside of a profile.
const EXACT: f64 = 1e-9;
const INSIDE: f64 = 1e-7;

/// A place in the ranges of the keys, and the sum there.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Shares of the ranges.
    pub shares: Vec<f64>,
    /// −2 ln of the likelihood.
    pub sum: f64,
}

/// A part of the range of a key, as shares, and the cells in it. A key that is held has a range without width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    low: f64,
    high: f64,
    cells: u32,
}

impl Range {
    pub const WHOLE: Self = Self { low: 0.0, high: 1.0, cells: CELLS };

    pub fn held(share: f64) -> Self {
        Self { low: share, high: share, cells: 0 }
    }

    /// Up to a cell on each side of a share.
    pub fn about(share: f64) -> Self {
        let cell = 1.0 / f64::from(CELLS);
        Self { low: (share - cell).max(0.0), high: (share + cell).min(1.0), cells: 4 }
    }

    /// Both ends, and the middles of the cells between them.
    pub(super) fn nodes(self) -> Vec<f64> {
        let width = (self.high - self.low) / f64::from(self.cells);
        let middles = (0..self.cells).map(|i| self.low + (f64::from(i) + 0.5) * width);
        [self.low].into_iter().chain(middles).chain([self.high]).collect()
    }
}

/// Whether two sums differ only by rounding.
pub fn is_same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) + 1e-24
}

/// The measurements, and every few of them, which tell where the basins are.
#[derive(Debug, Clone)]
pub struct Profile<'p, 'a> {
    whole: &'p Problem<'a>,
    thinned: Problem<'a>,
}

impl<'p, 'a> Profile<'p, 'a> {
    pub fn of(problem: &'p Problem<'a>) -> Self {
        Self { whole: problem, thinned: problem.thinned(ENOUGH) }
    }

    /// The minima of all basins in these ranges, the lowest first; empty if the law gives no result anywhere.
    pub fn minima(&self, ranges: &[Range]) -> Vec<Place> {
        minima(self.whole, &self.thinned, ranges, EXACT)
    }

    /// The place with the lowest sum; the sum is infinite if the law gives no result anywhere.
    pub fn lowest(&self, ranges: &[Range]) -> Place {
        lowest(self.whole, &self.thinned, ranges)
    }
}

fn lowest(whole: &Problem, thinned: &Problem, ranges: &[Range]) -> Place {
    let nowhere = || Place { shares: ranges.iter().map(|range| range.low).collect(), sum: f64::INFINITY };
    minima(whole, thinned, ranges, INSIDE).into_iter().next().unwrap_or_else(nowhere)
}

fn minima(whole: &Problem, thinned: &Problem, ranges: &[Range], exact: f64) -> Vec<Place> {
    let Some(key) = ranges.iter().position(|range| range.cells > 0) else {
        let shares: Vec<f64> = ranges.iter().map(|range| range.low).collect();
        let place = Place { sum: whole.sum(&shares), shares };
        return Some(place).filter(|place| place.sum.is_finite()).into_iter().collect();
    };
    let with = |share: f64| {
        let mut ranges = ranges.to_vec();
        ranges[key] = Range::held(share);
        ranges
    };
    let low = |share: f64| lowest(thinned, thinned, &with(share)).sum;
    let fine = |share: f64| lowest(whole, thinned, &with(share));
    Search { low: &low, fine: &fine, exact }.minima(ranges[key], whole.counted.len())
}

/// A search over one key: the sum of the thinned measurements, and the place with the sum of all of them.
struct Search<'f> {
    low: &'f (dyn Fn(f64) -> f64 + Sync),
    fine: &'f dyn Fn(f64) -> Place,
    exact: f64,
}

/// Nodes that follow each other with the same sum.
struct Run {
    first: usize,
    last: usize,
    sum: f64,
}

/// The runs of these sums, and whether each is lower than its neighbours.
fn runs(sums: &[f64]) -> Vec<(Run, bool)> {
    let (mut runs, mut first): (Vec<Run>, usize) = (Vec::new(), 0);
    for run in sums.chunk_by(|a, b| is_same(*a, *b)) {
        runs.push(Run { first, last: first + run.len() - 1, sum: run[0] });
        first += run.len();
    }
    let sum = |at: Option<usize>| at.and_then(|at| runs.get(at)).map_or(f64::INFINITY, |run: &Run| run.sum);
    let is_lowest: Vec<bool> = (0..runs.len())
        .map(|i| runs[i].sum.is_finite() && runs[i].sum <= sum(i.checked_sub(1)).min(sum(Some(i + 1))))
        .collect();
    runs.into_iter().zip(is_lowest).collect()
}

impl Search<'_> {
    /// The minima in this range, the lowest first.
    fn minima(&self, range: Range, values: usize) -> Vec<Place> {
        let nodes = range.nodes();
        let sums: Vec<f64> = nodes.par_iter().map(|share| (self.low)(*share)).collect();
        let mut lowest: Vec<Run> = runs(&sums).into_iter().filter_map(|(run, is)| is.then_some(run)).collect();
        lowest.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        let bottoms = lowest.iter().take(MOST_BASINS).map(|run| (run.first, self.beside(&nodes, run, ZOOMS)));
        let mut found: Vec<(usize, Place)> = bottoms.filter(|(_, place)| place.sum.is_finite()).collect();
        found.sort_by(|a, b| a.1.sum.total_cmp(&b.1.sum));
        let mut apart: Vec<(usize, Place)> = Vec::new();
        for (at, place) in found {
            #[allow(clippy::cast_precision_loss)] // counts of measurements
            let least = place.sum + RISE * place.sum / values as f64 + f64::MIN_POSITIVE.sqrt();
            let is_apart = |(other, _): &(usize, Place)| {
                sums[(*other).min(at)..=(*other).max(at)].iter().copied().fold(0.0, f64::max) > least
            };
            if apart.iter().all(is_apart) {
                apart.push((at, place));
            }
        }
        apart.into_iter().map(|(_, place)| place).collect()
    }

    /// The minimum of the basin about a node, or of the one beside a plateau.
    fn beside(&self, nodes: &[f64], run: &Run, zooms: u32) -> Place {
        let [before, after] = [run.first.saturating_sub(1), (run.last + 1).min(nodes.len() - 1)];
        if run.first == run.last {
            return self.inside(nodes[before], nodes[after], zooms.min(1));
        }
        let sides = [(nodes[before], nodes[run.first]), (nodes[run.last], nodes[after])];
        let sides = sides.into_iter().filter(|(low, high)| low < high);
        let lowest = sides.map(|(low, high)| self.inside(low, high, zooms)).min_by(|a, b| a.sum.total_cmp(&b.sum));
        let on = (self.fine)(nodes[run.first]);
        match lowest {
            Some(lower) if lower.sum < on.sum && !is_same(lower.sum, on.sum) => lower,
            // the end of the plateau where the sum rises
            _ => {
                let (outer, inner) = if before < run.first { (before, run.first) } else { (after, run.last) };
                let is_above = |share| !is_same((self.fine)(share).sum, on.sum);
                (self.fine)(halved(nodes[outer], nodes[inner], is_above).1)
            }
        }
    }

    /// The minimum between two places, of which the parts are looked at so many times.
    fn inside(&self, low: f64, high: f64, zooms: u32) -> Place {
        if zooms == 0 || high - low < self.exact {
            return self.brent(low, high);
        }
        let nodes = Range { low, high, cells: FINER }.nodes();
        let sums: Vec<f64> = nodes.iter().map(|share| (self.low)(*share)).collect();
        let lowest = runs(&sums).into_iter().filter(|(_, is_lowest)| *is_lowest).map(|(run, _)| run);
        match lowest.min_by(|a, b| a.sum.total_cmp(&b.sum)) {
            Some(run) => self.beside(&nodes, &run, zooms - 1),
            None => (self.fine)(low),
        }
    }

    /// The method of Brent (1973): parabolas, and the golden section where they do not help.
    fn brent(&self, mut low: f64, mut high: f64) -> Place {
        const GOLDEN: f64 = 0.381_966_011_250_105_1;
        let ends = [low, high];
        let at = |share: f64| (share, (self.fine)(share));
        let mut best = at(low + GOLDEN * (high - low));
        let (mut second, mut third) = (best.clone(), best.clone());
        let (mut step, mut before) = (0.0_f64, 0.0_f64);
        for _ in 0..100 {
            let (x, middle) = (best.0, 0.5 * (low + high));
            if (x - middle).abs() + 0.5 * (high - low) <= 2.0 * self.exact {
                break;
            }
            let r = (x - second.0) * (best.1.sum - third.1.sum);
            let q = (x - third.0) * (best.1.sum - second.1.sum);
            let p = (x - third.0) * q - (x - second.0) * r;
            let parabolic = -p / (2.0 * (q - r));
            let is_good = parabolic.abs() < 0.5 * before.abs() && x + parabolic > low && x + parabolic < high;
            (before, step) = if is_good {
                (step, parabolic)
            } else {
                let rest = if x < middle { high - x } else { low - x };
                (rest, GOLDEN * rest)
            };
            let share = (x + if step.abs() < self.exact { self.exact.copysign(step) } else { step }).clamp(low, high);
            let tried = at(share);
            if tried.1.sum <= best.1.sum {
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
        // an end of the range has not been tried
        let ends = ends.into_iter().filter(|end| (end - best.0).abs() <= 4.0 * self.exact).map(self.fine);
        ends.chain([best.1.clone()]).min_by(|a, b| a.sum.total_cmp(&b.sum)).unwrap_or(best.1)
    }
}
