//! The best values of the keys under one law, and what follows from the derivatives there.

use nalgebra::DMatrix;

use super::minimise::{BasinSearch, ParameterPoint, ShareRange, is_equal_within_rounding};
use super::problem::{CalibrationProblem, PredictionError, STUDENT_DEGREES};
use crate::numerics::functions::hypot;

/// The smallest scatter of real readings, relative to the value. If the scatter is smaller, the readings are rounded.
pub(crate) const MIN_SCATTER: f64 = 1e-6;
/// The noise may be a fraction of the predicted value. If the prediction is below this fraction of the reading, the noise is a fraction
/// of the reading times this number.
const MIN_MODEL_TO_READING: f64 = 0.5;

/// How the standard deviations are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Noise {
    /// The standard deviations are given.
    Given,
    /// Only the ratios of the standard deviations are given. The rest comes from the scatter.
    Estimated {
        /// Degrees of freedom of the estimate.
        freedom: f64,
        /// The noise as a share of every value, if it is the same share of all.
        share: Option<f64>,
    },
    /// There are as many keys as values, so there is no scatter to estimate the noise from.
    TooFew,
    /// All values, or more than half of them if outliers are expected, are met to the last digit.
    NoScatter,
}

/// The noise before the fit: the standard deviation of the instrument for each value, and a share of what the law gives, added
/// in quadrature.
#[derive(Debug, Clone)]
pub struct NoiseModel {
    pub instrument: Vec<f64>,
    pub share: f64,
    pub is_estimated: bool,
}

impl NoiseModel {
    /// The standard deviations, for these values of the law.
    pub fn deviations(&self, law: &[f64]) -> Vec<f64> {
        self.instrument.iter().zip(law).map(|(sd, law)| hypot(*sd, self.share * law)).collect()
    }
}

/// The best values of the keys under one law.
#[derive(Debug, Clone)]
pub struct Fit<'a> {
    /// Keys, law and measurements. Its standard deviations include the estimated noise.
    pub problem: CalibrationProblem<'a>,
    /// The minima of all basins, the lowest first.
    pub minima: Vec<ParameterPoint>,
    /// Covariance of the keys, as shares of their ranges; `None` if the measurements do not determine a key.
    pub covariance: Option<DMatrix<f64>>,
    pub noise: Noise,
    /// Akaike's information criterion: lower is better.
    pub aic: f64,
}

impl<'a> Fit<'a> {
    /// Finds the best values of the keys.
    pub fn new(mut problem: CalibrationProblem<'a>, noise_model: &NoiseModel) -> Result<Self, PredictionError> {
        let (values, keys, is_estimated) = (problem.used_values.len(), problem.free.len(), noise_model.is_estimated);
        let is_robust = problem.is_robust && !(is_estimated && values <= keys);
        problem.is_robust = is_robust && !is_estimated;
        let anywhere = vec![ShareRange::WHOLE; keys];
        let mut found = BasinSearch::new(&problem).minima(&anywhere);
        let mut noise = match is_estimated {
            true if values <= keys => Noise::TooFew,
            true => Noise::from_scale(&problem, 1.0),
            false => Noise::Given,
        };
        // relative noise refers to the predicted value. Relative to the readings it would give low readings more weight, and the
        // fitted law would be too low. With outliers the size of the noise follows from the median of the residuals. In both cases
        // noise and keys are estimated alternately
        let has_shares = noise_model.share > 0.0 && noise != Noise::TooFew && !problem.data.is_curve();
        let rounds = match (is_estimated && is_robust, has_shares, is_estimated) {
            (true, ..) => 8,
            (_, true, _) => 3,
            (.., is_scaled) => u32::from(is_scaled),
        };
        let (mut whole, sizes) = (1.0, problem.data.error_scales());
        for round in 1..=rounds {
            let (false, Some(place)) = (noise == Noise::TooFew, found.first()) else { break };
            if has_shares {
                let law = problem.predict(&place.shares)?.into_iter().zip(&sizes);
                let law: Vec<f64> = law.map(|(law, size)| law.abs().max(MIN_MODEL_TO_READING * size)).collect();
                problem.deviations = noise_model.deviations(&law);
                problem.deviations.iter_mut().for_each(|deviation| *deviation *= whole);
            }
            if is_estimated {
                let residuals = problem.residuals(&place.shares)?;
                let scale = residual_scale(&residuals, keys, is_robust);
                let shares = problem.used_values.iter().map(|at| scale * problem.deviations[*at] / sizes[*at]);
                if shares.fold(0.0, f64::max) < MIN_SCATTER {
                    noise = Noise::NoScatter;
                    break;
                }
                whole *= scale;
                noise = Noise::from_scale(&problem, whole);
                problem.deviations.iter_mut().for_each(|deviation| *deviation *= scale);
                problem.is_robust = is_robust;
            }
            found = if is_robust {
                BasinSearch::new(&problem).minima(&anywhere)
            } else if round < rounds {
                let profile = BasinSearch::new(&problem);
                let near = |place: &ParameterPoint| {
                    place.shares.iter().map(|share| ShareRange::with_centre(*share)).collect::<Vec<_>>()
                };
                found.iter().filter_map(|place| profile.minima(&near(place)).into_iter().next()).collect()
            } else {
                let again = |ParameterPoint { shares, .. }| ParameterPoint { sum: problem.objective(&shares), shares };
                found.into_iter().map(again).collect()
            };
            found.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        }
        let Some(best) = found.first() else {
            return Err(problem.predict(&vec![0.5; keys]).err().unwrap_or(PredictionError::Captured));
        };
        let parameters = (keys + usize::from(is_estimated)) as f64;
        let aic = problem.neg2_log_likelihood(best.sum) + 2.0 * parameters;
        let covariance = problem.jacobian(&best.shares).ok().and_then(|matrix| covariance(&problem, &matrix));
        Ok(Self { problem, minima: found, covariance, noise, aic })
    }

    /// The range of shares around the best one of the only key in which the sum is the same; `None` if it is one point.
    pub(super) fn plateau(&self) -> Option<[f64; 2]> {
        let [best] = self.best().shares[..] else { return None };
        let is_level = |share: &f64| is_equal_within_rounding(self.problem.objective(&[*share]), self.best().sum);
        let nodes = ShareRange::WHOLE.nodes();
        let above = nodes.iter().copied().filter(|node| *node > best).take_while(is_level).last();
        let below = nodes.iter().rev().copied().filter(|node| *node < best).take_while(is_level).last();
        (above.is_some() || below.is_some()).then(|| [below.unwrap_or(best), above.unwrap_or(best)])
    }

    /// The lowest minimum.
    pub fn best(&self) -> &ParameterPoint {
        &self.minima[0]
    }

    /// The best values of the keys, SI.
    pub fn values(&self) -> Vec<f64> {
        self.problem.values(&self.best().shares)
    }

    /// True if the noise is unknown; then the intervals are unknown too.
    pub fn is_noise_unknown(&self) -> bool {
        matches!(self.noise, Noise::TooFew | Noise::NoScatter)
    }

    /// Degrees of freedom of the estimated noise; `None` if the noise is not estimated.
    pub fn degrees_of_freedom(&self) -> Option<f64> {
        if let Noise::Estimated { freedom, .. } = self.noise { Some(freedom) } else { None }
    }
}

impl Noise {
    fn from_scale(problem: &CalibrationProblem, scale: f64) -> Self {
        let freedom = (problem.used_values.len() - problem.free.len()) as f64;
        let is_share = problem.data.values.iter().all(|value| value.deviation.is_none());
        Self::Estimated { freedom, share: is_share.then_some(scale) }
    }
}

/// The scale of the residuals of a fit with this number of keys.
fn residual_scale(residuals: &[f64], keys: usize, is_robust: bool) -> f64 {
    let (count, freedom) = (residuals.len() as f64, (residuals.len() - keys) as f64);
    if is_robust {
        1.482_602_218_505_602 * median(residuals.iter().map(|residual| residual.abs())) * (count / freedom).sqrt()
    } else {
        (residuals.iter().map(|residual| residual * residual).sum::<f64>() / freedom).sqrt()
    }
}

/// The median: of an even number of values the mean of the two in the middle. NaN without values.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match (sorted.get(middle), sorted.get(middle.wrapping_sub(1))) {
        (Some(upper), Some(lower)) if sorted.len().is_multiple_of(2) => 0.5 * (lower + upper),
        (Some(value), _) => *value,
        (None, _) => f64::NAN,
    }
}

/// Covariance of the shares: the inverse of the Fisher information; `None` if the information is singular.
fn covariance(problem: &CalibrationProblem, matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    // with long tails equal residuals have less information
    let factor = if problem.is_robust { (STUDENT_DEGREES + 1.0) / (STUDENT_DEGREES + 3.0) } else { 1.0 };
    let inverse = (matrix.tr_mul(matrix) * factor).try_inverse()?;
    inverse.diagonal().iter().all(|square| square.is_finite() && *square > 0.0).then_some(inverse)
}

/// For each value (row), the change of each key (in shares) if this value were left out: the first step of Newton's
/// method.
pub(super) fn leave_one_out_shifts(
    problem: &CalibrationProblem,
    covariance: &DMatrix<f64>,
    matrix: &DMatrix<f64>,
    residuals: &[f64],
) -> DMatrix<f64> {
    let mut gains = matrix * covariance;
    for ((mut gain, row), residual) in gains.row_iter_mut().zip(matrix.row_iter()).zip(residuals) {
        let leverage = gain.dot(&row);
        let weight =
            if problem.is_robust { (STUDENT_DEGREES + 1.0) / (STUDENT_DEGREES + residual * residual) } else { 1.0 };
        gain *= -weight * residual / (1.0 - leverage).max(f64::EPSILON);
    }
    gains
}

/// The residuals, quantity after quantity, in the order of rising speed. Points of a curve stay in their order.
pub(super) fn ordered_residuals(problem: &CalibrationProblem, residuals: &[f64]) -> Vec<f64> {
    let speeds = problem.speeds();
    let mut sorted: Vec<usize> = (0..residuals.len()).collect();
    let value = |i: &usize| &problem.data.values[problem.used_values[*i]];
    sorted.sort_by(|a, b| {
        let (a, b) = (value(a), value(b));
        a.quantity.cmp(&b.quantity).then(speeds[a.row].total_cmp(&speeds[b.row]))
    });
    sorted.into_iter().map(|i| residuals[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::median;

    #[test]
    fn even_median_is_mean_of_two_middle_values() {
        assert_eq!(median([4.0, 1.0, 3.0, 9.0].into_iter()), 3.5);
        assert_eq!(median([4.0, 1.0, 9.0].into_iter()), 4.0);
        assert_eq!(median([7.0].into_iter()), 7.0);
        assert!(median(std::iter::empty()).is_nan());
    }
}
