//! The best values of the keys under one law, and what follows from the derivatives there.

use nalgebra::DMatrix;

use super::error::NoAnswer;
use super::minimum::{Grid, Place, minima};
use super::problem::{Problem, TAILS};

/// The best values of the keys under one law.
#[derive(Debug, Clone)]
pub struct Fit<'a> {
    /// Keys, law and measurements. Its standard deviations include the estimated noise.
    pub problem: Problem<'a>,
    /// The minima of all basins, the lowest first.
    pub minima: Vec<Place>,
    /// The grid on which the basins were found.
    pub(super) grid: Grid,
    /// Covariance of the keys, as shares of their ranges; `None` if the measurements do not determine a key.
    pub covariance: Option<Vec<Vec<f64>>>,
    /// Degrees of freedom of the estimated noise; `None` if the noise is known.
    pub freedom: Option<f64>,
    /// Whether the noise would have to be estimated, but there are only as many values as keys.
    pub has_no_noise: bool,
    /// Akaike's information criterion: lower is better.
    pub aic: f64,
}

impl<'a> Fit<'a> {
    /// Finds the best values of the keys. With `is_estimated` only the ratios of the standard deviations in the problem
    /// are known.
    ///
    /// # Errors
    /// [`NoAnswer`] if the law gives no result anywhere in the ranges.
    pub fn of(mut problem: Problem<'a>, is_estimated: bool) -> Result<Self, NoAnswer> {
        let (values, keys) = (problem.counted.len(), problem.free.len());
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        let (count, freedom) = (values as f64, values.saturating_sub(keys) as f64);
        let is_robust = problem.is_robust && !(is_estimated && values <= keys);
        problem.is_robust = is_robust && !is_estimated;
        let mut grid = Grid::of(&problem);
        let mut found = minima(&problem, &grid);
        if is_estimated && values > keys {
            // with long tails the scale comes from the median of the residuals; scale and keys are found in turn
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
                // data without scatter would give a scale of 0
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
        let covariance = problem.jacobian(&best.shares).ok().and_then(|columns| covariance(&problem, &columns));
        Ok(Self { problem, minima: found, grid, covariance, freedom, has_no_noise, aic })
    }

    /// The lowest minimum.
    pub fn best(&self) -> &Place {
        &self.minima[0]
    }

    /// The best values of the keys, SI.
    pub fn values(&self) -> Vec<f64> {
        self.problem.values(&self.best().shares)
    }
}

/// Covariance of the shares: the inverse of the Fisher information; `None` if that has no inverse.
fn covariance(problem: &Problem, columns: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    // with long tails the same residuals hold less information
    let factor = if problem.is_robust { (TAILS + 1.0) / (TAILS + 3.0) } else { 1.0 };
    let product = |i: usize, j: usize| factor * columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum::<f64>();
    let inverse = DMatrix::from_fn(columns.len(), columns.len(), product).try_inverse()?;
    let rows: Vec<Vec<f64>> = inverse.row_iter().map(|row| row.iter().copied().collect()).collect();
    (0..rows.len()).all(|i| rows[i][i].is_finite() && rows[i][i] > 0.0).then_some(rows)
}

/// For each value, the change of each key (in shares) if this value were left out: the first step of Newton's method.
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

/// The residuals, quantity after quantity, in the order of rising speed. Points of a curve stay in their order.
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
