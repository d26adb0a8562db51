//! The best keys under one law, and what follows from the derivatives there.

use nalgebra::DMatrix;

use super::error::NoAnswer;
use super::minimum::{Grid, Place, minima};
use super::problem::{Problem, TAILS};
use super::profile::{Ends, Profile};

/// The best keys under one law.
#[derive(Debug, Clone)]
pub struct Fit<'a> {
    /// Keys, law and measurements; an estimated noise is in its standard deviations.
    pub problem: Problem<'a>,
    /// The bottoms of all basins, the lowest first.
    pub minima: Vec<Place>,
    grid: Grid,
    /// Degrees of freedom of an estimated noise; `None` for a noise that is known.
    pub freedom: Option<f64>,
    /// Whether there is no noise to estimate an interval from: as many values as keys.
    pub has_no_noise: bool,
    /// Akaike's criterion: less is better.
    pub aic: f64,
}

impl<'a> Fit<'a> {
    /// The best keys; with `is_estimated` the standard deviations of the problem are only ratios.
    ///
    /// # Errors
    /// [`NoAnswer`] where the law has none anywhere.
    pub fn of(mut problem: Problem<'a>, is_estimated: bool) -> Result<Self, NoAnswer> {
        let (values, keys) = (problem.counted.len(), problem.free.len());
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        let (count, freedom) = (values as f64, values.saturating_sub(keys) as f64);
        let is_robust = problem.is_robust && !(is_estimated && values <= keys);
        problem.is_robust = is_robust && !is_estimated;
        let mut grid = Grid::of(&problem);
        let mut found = minima(&problem, &grid);
        if is_estimated && values > keys {
            // with long tails the scale is that of the middle of the residuals, and both are sought in turn
            for _ in 0..if is_robust { 8 } else { 1 } {
                let Some(place) = found.first() else { break };
                let residuals = problem.residuals(&place.shares)?;
                let scale = if is_robust {
                    let mut sizes: Vec<f64> = residuals.iter().map(|residual| residual.abs()).collect();
                    sizes.sort_by(f64::total_cmp);
                    1.482_602_218_505_602 * sizes[values / 2] * (count / freedom).sqrt()
                } else {
                    (residuals.iter().map(|residual| residual * residual).sum::<f64>() / freedom).sqrt()
                };
                // data without any scatter have no noise
                problem.deviations.iter_mut().for_each(|deviation| *deviation *= scale.max(1e-12));
                problem.is_robust = is_robust;
                if is_robust {
                    grid = Grid::of(&problem);
                    found = minima(&problem, &grid);
                } else {
                    for place in &mut found {
                        place.sum = problem.sum(&place.shares);
                    }
                }
            }
        }
        let Some(best) = found.first() else {
            return Err(problem.predict(&vec![0.5; keys]).err().unwrap_or(NoAnswer::Captured));
        };
        #[allow(clippy::cast_precision_loss)] // a few keys
        let parameters = (keys + usize::from(is_estimated)) as f64;
        let aic = problem.full(best.sum) + 2.0 * parameters;
        let has_no_noise = is_estimated && values <= keys;
        let freedom = (is_estimated && !has_no_noise).then_some(freedom);
        Ok(Self { problem, minima: found, grid, freedom, has_no_noise, aic })
    }

    /// The best values of the keys, SI.
    pub fn values(&self) -> Vec<f64> {
        self.problem.values(&self.minima[0].shares)
    }

    /// The profile of the sum, for intervals.
    pub fn interval(&self, key: usize) -> [Ends; 2] {
        let covariance =
            self.problem.jacobian(&self.minima[0].shares).ok().and_then(|columns| covariance(&self.problem, &columns));
        self.profile(covariance.as_deref())
            .intervals(key)
            .map(|ends| ends.map(|end| end.map(|share| self.problem.free[key].at(share))))
    }

    /// The sum about its least value; the covariance is that of the shares.
    pub(super) fn profile<'s>(&'s self, covariance: Option<&'s [Vec<f64>]>) -> Profile<'s, 'a> {
        Profile { problem: &self.problem, grid: &self.grid, minima: &self.minima, covariance, freedom: self.freedom }
    }
}

/// The inverse of the information of the derivatives; `None` where it has none.
pub(super) fn covariance(problem: &Problem, columns: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    // long tails tell less
    let factor = if problem.is_robust { (TAILS + 1.0) / (TAILS + 3.0) } else { 1.0 };
    let product = |i: usize, j: usize| factor * columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum::<f64>();
    let inverse = DMatrix::from_fn(columns.len(), columns.len(), product).try_inverse()?;
    let rows: Vec<Vec<f64>> = inverse.row_iter().map(|row| row.iter().copied().collect()).collect();
    (0..rows.len()).all(|i| rows[i][i].is_finite() && rows[i][i] > 0.0).then_some(rows)
}

/// By how much each value, if it were left out, would shift each key, in shares: the first step of Newton's method.
pub(super) fn shifts(
    problem: &Problem,
    covariance: &[Vec<f64>],
    columns: &[Vec<f64>],
    residuals: &[f64],
) -> Vec<Vec<f64>> {
    let of = |i: usize| {
        let row: Vec<f64> = columns.iter().map(|column| column[i]).collect();
        let gain: Vec<f64> = covariance.iter().map(|line| line.iter().zip(&row).map(|(a, b)| a * b).sum()).collect();
        let leverage: f64 = gain.iter().zip(&row).map(|(a, b)| a * b).sum();
        let weight = if problem.is_robust { (TAILS + 1.0) / (TAILS + residuals[i] * residuals[i]) } else { 1.0 };
        gain.into_iter().map(|gain| -gain * weight * residuals[i] / (1.0 - leverage).max(f64::EPSILON)).collect()
    };
    (0..residuals.len()).map(of).collect()
}

/// Residuals of each quantity by rising speed, those of a curve in its own order.
pub(super) fn in_order(problem: &Problem, residuals: &[f64]) -> Vec<f64> {
    let speeds = problem.speeds();
    let mut order: Vec<usize> = (0..residuals.len()).collect();
    let value = |i: &usize| &problem.data.values[problem.counted[*i]];
    order.sort_by(|a, b| {
        let (a, b) = (value(a), value(b));
        a.what.cmp(&b.what).then(speeds[a.row].total_cmp(&speeds[b.row]))
    });
    order.into_iter().map(|i| residuals[i]).collect()
}
