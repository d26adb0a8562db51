//! Warns where the measured impacts leave the range of the model, with the keys that were found. As for a table, the impacts
//! at the ends are computed: those with the smallest and the largest value of every column, and the slowest and the fastest.

use super::Calibration;
use super::data::MeasuredValue;
use super::problem::CalibrationProblem;
use crate::impact::Warning;
use crate::scenario::input::MeasuredQuantity;

impl Calibration<'_> {
    /// The worst warning of each kind, with the line of its impact, which measurements of the scenario itself do not have. A
    /// slow indentation has no warnings here.
    pub fn range_warnings(&self) -> Vec<(Warning, Option<u64>)> {
        let (problem, mut worst) = (&self.fit.problem, Vec::new());
        let rows = if problem.data.is_curve() { Vec::new() } else { extreme_rows(problem) };
        for row in rows {
            let input = problem.row_input(row, &self.fit.best().shares);
            let Ok(contact) = input.contact() else { continue };
            let Ok(impact) = contact.impact(input.speed(), &input.solver(), None) else { continue };
            let line = Some(problem.data.rows[row].line).filter(|line| *line > 0);
            let risen = |value: &MeasuredValue| match value.quantity {
                MeasuredQuantity::ReboundHeight => Some(value.value),
                MeasuredQuantity::BounceInterval => {
                    Some(impact.row.restitution * impact.row.restitution * input.drop_height()?)
                }
                // a restitution may come from speeds, which air does not change
                _ => None,
            };
            let values = problem.data.values.iter().filter(|value| value.row == row);
            let risen = values.filter_map(risen).reduce(f64::max);
            let of_flight = input.height_warning().into_iter().chain(input.measured_air_warning(risen));
            for warning in impact.warnings.into_iter().chain(of_flight) {
                warning.keep_worst(&mut worst, || line);
            }
        }
        worst.sort_by_key(|(warning, _)| !warning.is_fatal());
        worst
    }
}

/// The rows at the ends.
fn extreme_rows(problem: &CalibrationProblem) -> Vec<usize> {
    let rows = &problem.data.rows;
    let column = |at: usize| rows.iter().map(|row| row.keys[at]).collect();
    let ends_of = |values: Vec<f64>| {
        // a speed that follows from an interval is empty
        let known = || values.iter().enumerate().filter(|(_, value)| !value.is_nan());
        let smallest = known().min_by(|a, b| a.1.total_cmp(b.1));
        let largest = known().max_by(|a, b| a.1.total_cmp(b.1));
        [smallest, largest].map(|end| end.map(|(row, _)| row))
    };
    let columns = (0..problem.data.keys.len()).map(column).chain([problem.speeds()]);
    let mut ends: Vec<usize> = columns.flat_map(ends_of).flatten().collect();
    ends.sort_unstable();
    ends.dedup();
    ends
}
