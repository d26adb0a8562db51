//! Least squares by the method of Levenberg and Marquardt, with derivatives from central differences.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

const STEP: f64 = 1e-6;

struct Differences<F> {
    numbers: DVector<f64>,
    residuals: F,
}

impl<F: Fn(&DVector<f64>) -> Option<Vec<f64>>> Differences<F> {
    fn at(&self, numbers: &DVector<f64>) -> Option<DVector<f64>> {
        let residuals = (self.residuals)(numbers)?;
        residuals.iter().all(|residual| residual.is_finite()).then(|| DVector::from_vec(residuals))
    }
}

impl<F: Fn(&DVector<f64>) -> Option<Vec<f64>>> LeastSquaresProblem<f64, Dyn, Dyn> for Differences<F> {
    type ParameterStorage = Owned<f64, Dyn>;
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;

    fn set_params(&mut self, numbers: &DVector<f64>) {
        self.numbers.copy_from(numbers);
    }

    fn params(&self) -> DVector<f64> {
        self.numbers.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.at(&self.numbers)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let column = |i: usize| {
            let moved = |by: f64| {
                let mut numbers = self.numbers.clone();
                numbers[i] += by;
                self.at(&numbers)
            };
            Some((moved(STEP)? - moved(-STEP)?) / (2.0 * STEP))
        };
        let columns: Option<Vec<DVector<f64>>> = (0..self.numbers.len()).map(column).collect();
        columns.map(|columns| DMatrix::from_columns(&columns))
    }
}

/// The numbers at which the sum of the squares of the residuals is smallest, searched from `start` on, and why the search
/// ended. The residuals are `None`, or not all finite, where a function has no value.
pub(crate) fn least_squares(
    method: LevenbergMarquardt<f64>,
    start: DVector<f64>,
    residuals: impl Fn(&DVector<f64>) -> Option<Vec<f64>>,
) -> (DVector<f64>, TerminationReason) {
    let (found, report) = method.minimize(Differences { numbers: start, residuals });
    (found.numbers, report.termination)
}
