//! A check before the fit: do the measurements determine the wanted keys? If not, it names another measurement that would.
//!
//! A law has an error of one or two per cent. If the keys can be changed together while all predictions stay the same
//! within this error, the measurements do not determine them, even if there are many of them with little noise.

use nalgebra::{DMatrix, DVector};

use super::data::{MeasuredValue, MeasurementData};
use super::minimise::ParameterPoint;
use super::problem::CalibrationProblem;
use crate::numerics::functions::{exp, ln};
use crate::scenario::input::MeasuredQuantity;
use crate::units::{format_four_digits, format_percent};

/// Usual error of a law, as a share of a prediction.
pub const MODEL_ERROR: f64 = 0.02;
/// This number of impacts is enough to find which other measurement would help.
const MAX_SCREENED_ROWS: usize = 100;

/// How well the measurements determine the keys together.
#[derive(Debug, Clone, PartialEq)]
pub struct Identifiability {
    /// Singular values of the derivatives of ln prediction by ln key, root mean square over the values; the largest
    /// first.
    pub singular_values: Vec<f64>,
    /// Relative change of the predictions along the direction in which they change least, for a step that doubles the
    /// key that changes most.
    pub change: f64,
    /// Exponents of the combination of the keys that the measurements determine best; the first is 1.
    pub exponents: Vec<f64>,
    /// Relative standard deviation of that combination.
    pub deviation: f64,
    /// Why the keys get no interval, and what would help; `None` if they get one.
    pub reason_without_intervals: Option<String>,
}

/// Derivatives of the predictions by the logarithms of the keys, over the standard deviations: one column for every
/// key.
fn log_jacobian(problem: &CalibrationProblem, place: &ParameterPoint) -> Option<DMatrix<f64>> {
    let mut matrix = problem.jacobian(&place.shares).ok()?;
    for ((mut column, free), share) in matrix.column_iter_mut().zip(problem.free).zip(&place.shares) {
        let value = free.value_at_share(*share);
        // a key at 0 has no logarithm: a step over its whole range counts as a doubling
        column *= if value == 0.0 { (free.to - free.from) / ln(2.0) } else { value } / free.slope_at_share(*share);
    }
    Some(matrix)
}

/// Singular values and right singular vectors, the largest value first.
fn singular_vectors(matrix: &DMatrix<f64>) -> Option<Vec<(f64, DVector<f64>)>> {
    // from the eigenvalues of the product, which is small even if there are many rows
    let eigen = matrix.tr_mul(matrix).symmetric_eigen();
    let vectors = eigen.eigenvectors.column_iter().map(nalgebra::Matrix::into_owned);
    let mut all: Vec<_> = eigen.eigenvalues.iter().map(|square| square.max(0.0).sqrt()).zip(vectors).collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.iter().all(|(value, _)| value.is_finite()).then_some(all)
}

/// Length of the step along a unit direction that doubles the key that changes most.
fn doubling_step(direction: &DVector<f64>) -> f64 {
    ln(2.0) / direction.amax()
}

/// How well the measurements determine the keys, at the best place; `None` without a key.
pub fn identify(problem: &CalibrationProblem, place: &ParameterPoint) -> Option<Identifiability> {
    if problem.free.is_empty() {
        return None;
    }
    let matrix = log_jacobian(problem, place)?;
    let root = (problem.used_values.len() as f64).sqrt();
    let sizes = MeasuredQuantity::ALL.map(|quantity| typical_size(problem, quantity));
    let mut relative = matrix.clone();
    for (mut row, at) in relative.row_iter_mut().zip(&problem.used_values) {
        row *= problem.deviations[*at] / sizes[problem.data.values[*at].quantity as usize] / root;
    }
    let relative = singular_vectors(&relative)?;
    let (least, direction) = relative.last()?;
    let change = least * doubling_step(direction);
    let (strongest, combination) = singular_vectors(&matrix)?.swap_remove(0);
    let refusal = (change < MODEL_ERROR).then(|| unidentifiable_message(problem, place, direction, change));
    Some(Identifiability {
        singular_values: relative.iter().map(|(value, _)| *value).collect(),
        change,
        exponents: combination.iter().map(|part| part / combination[0]).collect(),
        deviation: 1.0 / (strongest * combination[0].abs()),
        reason_without_intervals: refusal,
    })
}

/// Root mean square of the values of a quantity.
fn typical_size(problem: &CalibrationProblem, quantity: MeasuredQuantity) -> f64 {
    let values =
        problem.used_values.iter().map(|at| &problem.data.values[*at]).filter(|value| value.quantity == quantity);
    let (count, sum) = values.fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value.value * value.value));
    f64::sqrt(sum / count)
}

fn unidentifiable_message(
    problem: &CalibrationProblem,
    place: &ParameterPoint,
    direction: &DVector<f64>,
    change: f64,
) -> String {
    let names: Vec<&str> = problem.free.iter().map(|free| free.key.path()).collect();
    let off = format_percent(MODEL_ERROR);
    let statement = if let [name] = names[..] {
        format!("doubling {name} changes the predictions by only {} (model error {off})", format_percent(change))
    } else {
        let step = doubling_step(direction);
        let factors: Vec<String> = names
            .iter()
            .zip(direction.iter())
            .map(|(name, part)| (name, format_four_digits(exp(step * part))))
            // a key that does not change has no part in it
            .filter(|(_, factor)| factor != "1")
            .map(|(name, factor)| format!("{name} by {factor}"))
            .collect();
        format!(
            "the data cannot identify the keys separately: changing {} (factors) alters the predictions by only {} (model error {off})",
            factors.join(" and "),
            format_percent(change)
        )
    };
    let mut helpful = helpful_quantities(problem, place, direction);
    helpful.sort_by(|a, b| b.1.total_cmp(&a.1));
    let helpful: Vec<String> =
        helpful.iter().map(|(name, change)| format!("{name} ({})", format_percent(*change))).collect();
    let way_out = if problem.data.is_curve() {
        ". Measure the unloading too, or fix one key at its known value.".to_owned()
    } else if helpful.is_empty() {
        ". Fix one key at its known value.".to_owned()
    } else {
        format!(". Measure one of these, with its change: {}. Or fix one key at its known value.", helpful.join(", "))
    };
    let is_of_rate = names.len() > 1 && names.iter().any(|name| name.contains(".rate."));
    let of_rate = if is_of_rate {
        " Strength and strain-rate sensitivity have nearly the same effect on e(v) (difference 0.7 % per decade of speed). Give the hardness or the static strength of the metal."
    } else {
        ""
    };
    statement + &way_out + of_rate
}

/// Quantities that were not measured but change along a direction, each with its relative change.
fn helpful_quantities(
    problem: &CalibrationProblem,
    place: &ParameterPoint,
    direction: &DVector<f64>,
) -> Vec<(&'static str, f64)> {
    if problem.data.is_curve() {
        return Vec::new();
    }
    let measured = problem.data.measured_quantities();
    let has_restitution = measured.iter().any(|quantity| quantity.follows_from_restitution());
    let is_new = |quantity: &MeasuredQuantity| {
        !(measured.contains(quantity) || has_restitution && quantity.follows_from_restitution())
    };
    let change = |quantity: MeasuredQuantity| {
        let rows = 0..problem.data.rows.len();
        let values = rows.map(|row| MeasuredValue { row, quantity, value: 1.0, deviation: None }).collect();
        let data = MeasurementData { values, ..problem.data.clone() };
        let problem = problem.for_prediction(&data).subsampled(MAX_SCREENED_ROWS);
        let predicted = problem.predict(&place.shares).ok()?;
        let moved = (log_jacobian(&problem, place)? * direction).norm();
        let size = problem.used_values.iter().map(|at| predicted[*at] * predicted[*at]).sum::<f64>().sqrt();
        Some((quantity.name(), doubling_step(direction) * moved / size))
            .filter(|(_, change)| *change > 2.0 * MODEL_ERROR)
    };
    let of_impacts = MeasuredQuantity::ALL.into_iter().filter(|quantity| *quantity != MeasuredQuantity::Force);
    of_impacts.filter(is_new).filter_map(change).collect()
}
