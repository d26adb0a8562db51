//! Predictions of the law for every measured value, and their differences from the measurements.

use std::collections::HashMap;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::data::{MeasuredValue, MeasurementData, MeasurementRow};
use crate::contact::body::Sphere;
use crate::files::Progress;
use crate::impact::ImpactError;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::indentation::{IndentationError, SetPoint, StaticContact};
use crate::numerics::functions::{ln, ln_1p};
use crate::scenario::input::Input;
use crate::scenario::plan::FreeKey;

#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PredictionError {
    /// An impact has no result.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// An indentation has no result.
    #[error(transparent)]
    Indentation(#[from] IndentationError),
    /// The sphere stays in its dent, so a measured quantity such as the contact time does not exist.
    #[error("a measured quantity does not exist there, because the sphere does not separate.")]
    Captured,
    /// The calibration was stopped.
    #[error("the calibration was stopped")]
    Stopped,
}

/// Degrees of freedom of the likelihood with long tails.
pub const STUDENT_DEGREES: f64 = 4.0;

/// Number of rows that one thread computes at a time.
const CHUNK: usize = 512;

/// The fitted keys, a law, and measurements with their noise. A point in the ranges of the keys is given by
/// shares: 0 is the lower end of a range and 1 is the upper end.
#[derive(Debug, Clone)]
pub struct CalibrationProblem<'a> {
    pub input: Input,
    /// The input with values for the fitted keys and for the keys of the data.
    template: Input,
    /// The fitted keys.
    pub free: &'a [FreeKey],
    pub data: &'a MeasurementData,
    /// Standard deviation of each value of the data.
    pub deviations: Vec<f64>,
    /// True if the likelihood has long tails.
    pub is_robust: bool,
    /// Batches of rows. All rows of a batch have the same contact, or are points of one curve.
    batches: Vec<Vec<usize>>,
    /// The values that are used: all of them, or a subsample.
    pub used_values: Vec<usize>,
    /// For every row, the range of its values.
    value_ranges: Vec<std::ops::Range<usize>>,
    /// The stop flag.
    progress: Option<&'a Progress>,
}

impl<'a> CalibrationProblem<'a> {
    /// A problem with all rows of the data.
    pub fn new(
        input: &Input,
        free: &'a [FreeKey],
        data: &'a MeasurementData,
        deviations: Vec<f64>,
        is_robust: bool,
    ) -> Self {
        let mut ranges = vec![0..0; data.rows.len()];
        for (at, value) in data.values.iter().enumerate() {
            let range = &mut ranges[value.row];
            *range = if range.end == 0 { at..at + 1 } else { range.start..at + 1 };
        }
        let mut filled = input.clone();
        for key in free.iter().map(|free| free.key).chain(data.keys.iter().copied()) {
            // the key removes its alternative
            key.set_exclusive(&mut filled, 1.0);
        }
        let (input, pieces, counted, progress) = (input.clone(), Vec::new(), Vec::new(), None);
        let empty = Self {
            input,
            template: filled,
            free,
            data,
            deviations,
            is_robust,
            batches: pieces,
            used_values: counted,
            value_ranges: ranges,
            progress,
        };
        empty.with_rows(0..data.rows.len())
    }

    /// Returns this problem with a stop flag: it ends with an error if `progress` is stopped.
    pub fn with_progress(self, progress: &'a Progress) -> Self {
        Self { progress: Some(progress), ..self }
    }

    /// Replaces the data, to predict them by the same keys and law. Every standard deviation becomes 1.
    pub fn for_prediction<'b>(&'b self, data: &'b MeasurementData) -> CalibrationProblem<'b> {
        CalibrationProblem::new(&self.input, self.free, data, vec![1.0; data.values.len()], false)
    }

    /// Keeps at most `most` impacts: one of each group of consecutive rows, all groups of one size. If the data repeat a pattern, every
    /// n-th row may be of one kind; so the place in the group changes from group to group, by multiples of 610/987, which is near the
    /// golden ratio. A curve keeps all points.
    pub fn subsampled(&self, most: usize) -> Self {
        let rows = self.data.rows.len();
        let size = if self.data.is_curve() { 1 } else { rows.div_ceil(most) };
        let row = |group: usize| group * size + (610 * group % 987) * size / 987;
        self.clone().with_rows((0..rows.div_ceil(size)).map(row).filter(|row| *row < rows))
    }

    fn with_rows(mut self, rows: impl Iterator<Item = usize>) -> Self {
        let contacts: Vec<usize> =
            (0..self.data.keys.len()).filter(|at| self.data.keys[*at].part().changes_contact()).collect();
        let most = if self.data.is_curve() { usize::MAX } else { CHUNK };
        let mut places: HashMap<Vec<u64>, usize> = HashMap::new();
        (self.batches, self.used_values) = (Vec::new(), Vec::new());
        for row in rows {
            let keys = &self.data.rows[row].keys;
            let contact: Vec<u64> = contacts.iter().map(|at| keys[*at].to_bits()).collect();
            let place = places.entry(contact).or_insert(usize::MAX);
            if *place == usize::MAX || self.batches[*place].len() >= most {
                *place = self.batches.len();
                self.batches.push(Vec::new());
            }
            self.batches[*place].push(row);
            self.used_values.extend(self.value_ranges[row].clone());
        }
        self
    }

    /// Values of the keys at these shares, SI.
    pub fn values(&self, shares: &[f64]) -> Vec<f64> {
        self.free.iter().zip(shares).map(|(free, share)| free.value_at_share(*share)).collect()
    }

    /// The input with the fitted keys at these shares.
    fn input_at(&self, shares: &[f64]) -> Input {
        let mut input = self.template.clone();
        for (free, share) in self.free.iter().zip(shares) {
            input.set(free.key, Some(free.value_at_share(*share)));
        }
        input
    }

    /// The input of the impact of a row, with the fitted keys at these shares.
    pub(super) fn row_input(&self, row: usize, shares: &[f64]) -> Input {
        let mut input = self.input_at(shares);
        self.set_row_keys(&mut input, row, 0.0);
        input
    }

    /// The prediction for every value of the data; NaN for values that are not used.
    ///
    /// # Errors
    /// [`PredictionError`] if a row has no result, or the calibration was stopped.
    pub fn predict(&self, shares: &[f64]) -> Result<Vec<f64>, PredictionError> {
        let input = self.input_at(shares);
        let predicted = |piece: &Vec<usize>| {
            let mut input = input.clone();
            self.set_row_keys(&mut input, piece[0], 0.0);
            if self.data.is_curve() { self.curve(&input, piece) } else { self.impacts(input, piece) }
        };
        let found: Result<Vec<Vec<f64>>, PredictionError> = if self.batches.len() > 1 {
            self.batches.par_iter().with_min_len(CHUNK.div_ceil(self.batches[0].len())).map(predicted).collect()
        } else {
            self.batches.iter().map(predicted).collect()
        };
        let mut all = vec![f64::NAN; self.data.values.len()];
        for (piece, values) in self.batches.iter().zip(found?) {
            let places = piece.iter().flat_map(|row| self.value_ranges[*row].clone());
            places.zip(values).for_each(|(place, value)| all[place] = value);
        }
        Ok(all)
    }

    /// Returns an error if the calibration was stopped.
    fn check_cancelled(&self) -> Result<(), PredictionError> {
        if self.progress.is_some_and(Progress::is_stopped) { Err(PredictionError::Stopped) } else { Ok(()) }
    }

    /// The impact speed of every row \[m/s\]; NaN for a row without one.
    pub fn speeds(&self) -> Vec<f64> {
        let mut input = self.template.clone();
        let speed = |row| {
            self.set_row_keys(&mut input, row, 0.0);
            input.speed()
        };
        (0..self.data.rows.len()).map(speed).collect()
    }

    /// The first value that exceeds the value of a rebound without loss, with this limit.
    pub fn exceeding_value(&self) -> Option<(&MeasuredValue, f64)> {
        let mut input = self.template.clone();
        self.data.values.iter().find_map(|value| {
            self.set_row_keys(&mut input, value.row, 0.0);
            let limit = value.quantity.from_restitution(1.0, &input)?;
            (value.value > limit * (1.0 + 1e-12)).then_some((value, limit))
        })
    }

    /// Sets the keys of a row in an input. The flight before its impact lasts for the interval minus the contact time.
    fn set_row_keys(&self, input: &mut Input, row: usize, in_contact: f64) {
        let MeasurementRow { keys, preceding_interval: interval_before, .. } = &self.data.rows[row];
        for (key, value) in self.data.keys.iter().zip(keys) {
            input.set(*key, Some(*value));
        }
        if let Some(interval) = interval_before {
            let flying = input.free_flight().unwrap_or(FreeFlight::in_vacuum(input.drop_gravity()));
            let height = flying.rise_height(flying.take_off_speed((interval - in_contact).max(0.0)));
            for (key, _) in self.data.keys.iter().zip(keys).filter(|(_, value)| value.is_nan()) {
                let is_height = key.path() == "impact.drop_height";
                input.set(*key, Some(if is_height { height } else { flying.landing_speed(height) }));
            }
        }
    }

    /// The predictions for rows of one contact. The input has the keys of the first row.
    fn impacts(&self, mut input: Input, rows: &[usize]) -> Result<Vec<f64>, PredictionError> {
        let contact = input.contact()?;
        let mut predicted = Vec::with_capacity(rows.len());
        for row in rows {
            self.check_cancelled()?;
            self.set_row_keys(&mut input, *row, 0.0);
            if self.data.rows[*row].preceding_interval.is_some() {
                // the previous contact took about as long as this one
                let first = contact.row(input.speed(), &input.solver())?;
                self.set_row_keys(&mut input, *row, first.contact_time);
            }
            let result = contact.row(input.speed(), &input.solver())?;
            for value in &self.data.values[self.value_ranges[*row].clone()] {
                let found = value.quantity.predict(&result, &input).filter(|value| value.is_finite());
                predicted.push(found.ok_or(PredictionError::Captured)?);
            }
        }
        Ok(predicted)
    }

    /// The forces along an indentation curve. A point at the indentation of the point before adds no step; nor does a
    /// first point at zero indentation.
    fn curve(&self, input: &Input, rows: &[usize]) -> Result<Vec<f64>, PredictionError> {
        self.check_cancelled()?;
        let law = input.law();
        let (sphere, half_space) = input.bodies(&law);
        let sphere = Sphere { yield_strength: None, ..sphere };
        let contact = StaticContact::try_new(&sphere, &half_space, law.as_contact_law())?;
        let (mut targets, mut steps, mut last) = (Vec::new(), Vec::with_capacity(rows.len()), 0.0);
        for row in rows {
            let indentation = self.data.rows[*row].indentation.unwrap_or(0.0);
            if (indentation - last).abs() > 1e-9 * indentation.max(last) {
                targets.push(SetPoint::Indentation(indentation));
                last = indentation;
            }
            steps.push(targets.len());
        }
        let indentation = contact.indent(&targets, None)?;
        Ok(steps.into_iter().map(|step| if step == 0 { 0.0 } else { indentation.steps[step - 1].force }).collect())
    }

    /// The residual of every value that is used: measured minus predicted, over the standard deviation.
    pub fn residuals(&self, shares: &[f64]) -> Result<Vec<f64>, PredictionError> {
        let predicted = self.predict(shares)?;
        let residual = |at: &usize| (self.data.values[*at].value - predicted[*at]) / self.deviations[*at];
        Ok(self.used_values.iter().map(residual).collect())
    }

    /// The part of a residual in −2 ln of the likelihood.
    pub fn likelihood_term(&self, residual: f64) -> f64 {
        let square = residual * residual;
        if self.is_robust { (STUDENT_DEGREES + 1.0) * ln_1p(square / STUDENT_DEGREES) } else { square }
    }

    /// −2 ln of the likelihood without its constants; infinite if the law gives no result.
    pub fn objective(&self, shares: &[f64]) -> f64 {
        let residuals = self.residuals(shares);
        let sum =
            residuals.map_or(f64::INFINITY, |all| all.into_iter().map(|residual| self.likelihood_term(residual)).sum());
        if f64::is_nan(sum) { f64::INFINITY } else { sum }
    }

    /// −2 ln of the likelihood with its constants, from the objective. It is compared between laws.
    pub fn neg2_log_likelihood(&self, sum: f64) -> f64 {
        let tau = 2.0 * std::f64::consts::PI;
        let constant = if self.is_robust { 0.980_829_253_011_726_3 } else { 0.5 * ln(tau) };
        self.used_values.iter().map(|at| 2.0 * ln(self.deviations[*at]) + 2.0 * constant).sum::<f64>() + sum
    }

    /// Derivatives of the predictions, over the standard deviations, by the shares: a row for every value that is used,
    /// a column for every key.
    pub fn jacobian(&self, shares: &[f64]) -> Result<DMatrix<f64>, PredictionError> {
        let column = |i: usize| {
            let moved = |by: f64| {
                let mut moved = shares.to_vec();
                moved[i] = (shares[i] + by).clamp(0.0, 1.0);
                Ok::<_, PredictionError>((moved[i], DVector::from_vec(self.residuals(&moved)?)))
            };
            let ((low, before), (high, after)) = (moved(-DIFFERENCE_STEP)?, moved(DIFFERENCE_STEP)?);
            Ok((before - after) / (high - low))
        };
        let columns: Vec<DVector<f64>> = (0..shares.len()).map(column).collect::<Result<_, PredictionError>>()?;
        Ok(if columns.is_empty() { DMatrix::zeros(self.used_values.len(), 0) } else { DMatrix::from_columns(&columns) })
    }
}

/// Step of finite differences, as a share of the range of a key.
const DIFFERENCE_STEP: f64 = 1e-6;
