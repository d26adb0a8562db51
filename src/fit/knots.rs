//! Changes the knots of the force in a table of coefficients.

use crate::error::Error;
use crate::law::PlmCoefficients;
use crate::law::curve::Curve;

/// A table with the knots of the force at `knots`. Its slopes are the mean slopes of `table` between these knots.
///
/// # Errors
/// [`Error`] if there are no knots, if they do not rise, or if the first is below 1.
pub fn with_knots(table: &PlmCoefficients, knots: &[f64]) -> Result<PlmCoefficients, Error> {
    let is_rising = knots.windows(2).all(|pair| pair[0] < pair[1]) && knots.iter().all(|knot| knot.is_finite());
    if !is_rising || knots.first().is_none_or(|first| *first < 1.0) {
        let message = format!(
            "--knots {knots:?}: give delta/delta_Y of each knot, rising, the first at least 1, such as 1.7,3.4,9,36,250"
        );
        return Err(Error::input(message));
    }
    let [soft, stiff] = [0.0, 1.0].map(|kappa_squared| table.force.curve(kappa_squared));
    let mut new = table.clone();
    new.force.from = knots.to_vec();
    let ends: Vec<f64> = knots.iter().skip(1).copied().chain(knots.last().map(|last| 10.0 * last)).collect();
    let mean = |curve: &Curve, from: f64, to: f64| (curve.force(to) - curve.force(from)) / (to - from);
    let slopes =
        |curve: &Curve| -> Vec<f64> { knots.iter().zip(&ends).map(|(from, to)| mean(curve, *from, *to)).collect() };
    new.force.slope = slopes(&soft);
    new.force.slope_kappa_squared =
        slopes(&stiff).iter().zip(&new.force.slope).map(|(stiff, soft)| stiff - soft).collect();
    Ok(new)
}
