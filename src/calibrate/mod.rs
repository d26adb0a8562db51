//! Fits keys of a scenario to measurements: the best values of the keys, their uncertainty, and whether the data are compatible with the
//! law.
//!
//! One or two keys are fitted, and each has a range. Without a key the measurements are only compared with the law. The
//! profile of −2 ln of the likelihood along the first key, minimised over the second, gives every basin and its minimum. If
//! the standard deviations of the noise are known, the likelihood is normal and the sum is chi-square. With `robust` the
//! likelihood has the long tails of Student's distribution with 4 degrees of freedom. The error of the law is a share of each value; it is added to
//! the noise in quadrature, and is independent from value to value. If the noise is not known, it is taken as the same
//! share of every value that the law gives, and estimated from the scatter.
//!
//! The intervals are profile-likelihood intervals. An interval holds all values of a key for which the sum,
//! minimised over the other key, is at most z² above its minimum. If the noise is estimated, Student's t² replaces z².
//! With two keys the same sum also gives the regions that hold both of them with these probabilities.
//!
//! No interval is given if the keys can be changed together while the predictions change by less than the error of the
//! law. For example, e(v) alone determines only σ_Y⁵/(E*⁴ ρ v²), so it does not give σ_Y and E together. No interval
//! is given either if the noise is unknown: readings that repeat to the last digit are rounded and hide the noise.

pub mod data;
pub mod fit;
pub mod identifiability;
pub mod inverse;
pub mod minimise;
pub mod problem;
pub mod profile;
mod range_warnings;
mod result;
pub mod statistics;

use crate::contact::law::LawChoice;
use crate::error::{Error, ErrorKind};
use crate::files::Progress;
use crate::numerics::functions::hypot;
use crate::scenario::input::MeasuredQuantity;
use crate::scenario::kinds::calibration::{CalibrationRequest, MeasurementSource};
use crate::scenario::{Scenario, ScenarioSource as Text};
use crate::units::{format_four_digits, format_input};
use data::{MeasurementData, csv_file_error};
pub use fit::{Fit, Noise};
use fit::{NoiseModel, leave_one_out_shifts, ordered_residuals};
use identifiability::{Identifiability, identify};
use problem::CalibrationProblem;
pub use problem::PredictionError;
use result::OUTLIER_LIMIT;
pub use result::{Calibration, KeyEstimate, LawFit, Verdict};
use statistics::{chi_square_p_value, runs_test};

/// The smallest standard deviation, relative to the value. With it squares of residuals stay finite.
const MIN_DEVIATION: f64 = 1e-9;

/// The request of a calibration, and the measurements.
#[derive(Debug, Clone)]
pub struct CalibrationTask {
    /// The request of the scenario.
    pub request: CalibrationRequest,
    pub data: MeasurementData,
    /// SHA-256 of the file; `None` if the measurements are in the scenario.
    pub sha256: Option<String>,
}

impl CalibrationTask {
    /// Reads the request of a scenario and its measurements.
    pub fn new(scenario: &Scenario) -> Result<Self, Error> {
        let wanted = scenario.calibration_request()?;
        let of_text = |name: &str, text: String| {
            let data = MeasurementData::parse(name, &text)?;
            let text = Text { text, ..Text::default() };
            Ok::<_, Error>((data, Some(text.sha256())))
        };
        let (data, sha256) = match &wanted.source {
            MeasurementSource::Numbers(numbers) => {
                (MeasurementData::single_impact(scenario.document.name(), numbers), None)
            }
            MeasurementSource::Text(name, text) => of_text(name, text.clone())?,
        };
        scenario.check_varied(&wanted, &data.keys, !data.is_curve())?;
        let measured = Self { request: wanted, data, sha256 };
        measured.check()?;
        Ok(measured)
    }

    /// The request and the data without deviations.
    fn problem(&self) -> CalibrationProblem<'_> {
        let ones = vec![1.0; self.data.values.len()];
        CalibrationProblem::new(&self.request.input, &self.request.free, &self.data, ones, false)
    }

    fn check(&self) -> Result<(), Error> {
        let refuse = |message: String| Err(self.data_error(None, message));
        let (values, keys, measured) =
            (self.data.values.len(), self.request.free.len(), self.data.measured_quantities());
        if values < keys {
            return refuse(format!("{values} value cannot determine {keys} keys. Measure more, or fit fewer keys."));
        }
        let is_idle =
            |name: &String| !MeasuredQuantity::from_name(name).is_some_and(|quantity| measured.contains(&quantity));
        if let Some((name, _)) = self.request.deviations.iter().find(|(name, _)| is_idle(name)) {
            return refuse(format!("calibrate.noise.{name} is given, but no {name} was measured. Remove this key."));
        }
        // the limit is known if speed and gravity are not to be found
        let is_open = |path: &str| path.starts_with("impact.") || path.starts_with("gravity.");
        match self.problem().exceeding_value() {
            Some((value, limit)) if !self.request.free.iter().any(|free| is_open(free.key.path())) => {
                let shown =
                    [value.value, limit].map(|value_of| format_input(value_of, value.quantity.quantity().dimension));
                let [found, limit] = shown.map(|text| text.trim_end().to_owned());
                let message = format!(
                    "{} = {found} exceeds the elastic limit, {limit}. Check columns and units.",
                    value.quantity.name()
                );
                Err(self.data_error(self.value_line(value), message))
            }
            _ => Ok(()),
        }
    }

    /// The line of a value; `None` if the measurements are in the scenario.
    fn value_line(&self, value: &data::MeasuredValue) -> Option<u64> {
        self.sha256.is_some().then(|| self.data.rows[value.row].line)
    }

    /// The noise of every value, from the standard deviations and the model error that are given.
    fn noise_model(&self) -> Result<NoiseModel, Error> {
        let CalibrationRequest { deviations, model_error, is_estimated, .. } = &self.request;
        let of_quantity = |name: &str| deviations.iter().find(|given| given.0 == name).map(|given| given.1);
        let given = |value: &data::MeasuredValue| value.deviation.or_else(|| of_quantity(value.quantity.name()));
        let values = &self.data.values;
        let is_given = values.iter().any(|value| given(value).is_some());
        let is_estimated = *is_estimated || *model_error == 0.0 && !is_given && deviations.is_empty();
        if is_estimated && !is_given {
            return Ok(NoiseModel { instrument: vec![0.0; values.len()], share: 1.0, is_estimated });
        }
        let instrument = |(value, size): (&data::MeasuredValue, f64)| {
            let name = value.quantity.name();
            let sd = given(value);
            let whole = hypot(sd.unwrap_or(0.0), size * model_error);
            let message = if sd.is_none() && *model_error == 0.0 {
                format!(
                    "the {name} of this line has no standard deviation. Give calibrate.noise.{name}, or a column {name}_sd, or noise = \"estimate\"."
                )
            } else if whole < MIN_DEVIATION * size {
                format!(
                    "the standard deviation of this {name} is {}, which is implausibly small (less than {} of the value). Give the scatter of the readings.",
                    format_four_digits(whole),
                    format_four_digits(MIN_DEVIATION)
                )
            } else {
                return Ok(sd.unwrap_or(0.0));
            };
            Err(self.data_error(self.value_line(value), message))
        };
        let instrument = values.iter().zip(self.data.error_scales()).map(instrument).collect::<Result<_, _>>()?;
        Ok(NoiseModel { instrument, share: *model_error, is_estimated })
    }

    fn data_error(&self, line: Option<u64>, message: String) -> Error {
        csv_file_error(&self.data.name)((line, message))
    }

    /// The error where the law gives no result anywhere in the ranges of the keys, or where the calibration was stopped.
    fn no_fit_error(&self, reason: &PredictionError) -> Error {
        if *reason == PredictionError::Stopped {
            return Error::new(ErrorKind::Stopped(130), reason.to_string());
        }
        let place = " within the search range";
        let [place, way_out] = if self.request.free.is_empty() { ["", ""] } else { [place, " Change the range."] };
        let reason = format!("the law is not defined for these measurements{place}: {reason}{way_out}");
        Error::for_file(ErrorKind::Input, &self.data.name, reason)
    }

    /// The best keys under a law.
    fn fit<'a>(&'a self, law: &LawChoice, progress: &'a Progress) -> Result<Result<Fit<'a>, PredictionError>, Error> {
        let noise = self.noise_model()?;
        let deviations = noise.deviations(&self.data.error_scales());
        let mut input = self.request.input.clone();
        input.named_law.clone_from(law);
        let problem =
            CalibrationProblem::new(&input, &self.request.free, &self.data, deviations, self.request.is_robust);
        Ok(Fit::new(problem.with_progress(progress), &noise))
    }

    /// The fits of all laws that were asked for, the best first.
    fn ranked_fits<'a>(&'a self, progress: &'a Progress) -> Result<Vec<LawFit<'a>>, Error> {
        let mut laws = Vec::new();
        for law in &self.request.laws {
            laws.push((law.name(), self.fit(law, progress)?));
            progress.advance();
        }
        let aic = |fit: &Result<Fit, PredictionError>| fit.as_ref().map_or(f64::INFINITY, |fit| fit.aic);
        laws.sort_by(|a, b| aic(&a.1).total_cmp(&aic(&b.1)));
        Ok(laws)
    }

    /// The whole calibration. `progress` counts the laws that are fitted and the keys whose intervals are found.
    ///
    /// # Errors
    /// [`Error`] of the kind `Stopped` if `progress` is asked to stop; others if there is no answer.
    pub fn calibrate<'a>(&'a self, progress: &'a Progress) -> Result<Calibration<'a>, Error> {
        progress.add_total((1 + self.request.laws.len() + self.request.free.len()) as u64);
        let laws = self.ranked_fits(progress)?;
        let no_answer = |reason: PredictionError| self.no_fit_error(&reason);
        let fit = self.fit(&self.request.input.named_law, progress)?.map_err(no_answer)?;
        progress.advance();
        let (problem, shares) = (&fit.problem, &fit.best().shares);
        let predicted = problem.predict(shares).map_err(no_answer)?;
        let residuals = problem.residuals(shares).map_err(no_answer)?;
        let matrix = problem.jacobian(shares).map_err(no_answer)?;
        let identifiability = identify(problem, fit.best());
        let refusal = reason_without_interval(&fit, identifiability.as_ref());
        let keys = (0..problem.free.len()).map(|key| {
            let found = estimate_of_key(&fit, key, refusal.is_none());
            progress.advance();
            found
        });
        let keys: Vec<KeyEstimate> = keys.collect();
        let has_sd = self.request.is_robust && !fit.is_noise_unknown();
        let outlies = |residual: &&f64| has_sd && residual.abs() > OUTLIER_LIMIT;
        let outliers = residuals.iter().filter(outlies).count();
        let freedom = (residuals.len() - outliers).saturating_sub(keys.len());
        let inliers = residuals.iter().filter(|residual| !outlies(residual));
        let chi_square = inliers.map(|residual| residual * residual).sum();
        let calibration = Calibration {
            p: if fit.noise == Noise::Given { chi_square_p_value(chi_square, freedom) } else { None },
            runs: runs_test(&ordered_residuals(problem, &residuals)),
            shifts: fit
                .covariance
                .as_ref()
                .map(|covariance| leave_one_out_shifts(problem, covariance, &matrix, &residuals)),
            misfit: misfit(&self.data, &predicted),
            fit,
            keys,
            predicted,
            residuals,
            chi_square,
            degrees_of_freedom: freedom,
            outliers,
            identifiability,
            reason_without_intervals: refusal,
            laws,
        };
        if progress.is_stopped() { Err(self.no_fit_error(&PredictionError::Stopped)) } else { Ok(calibration) }
    }
}

/// The result for one key. It has an interval only if the measurements determine the keys (`is_determined`).
fn estimate_of_key(fit: &Fit, key: usize, is_determined: bool) -> KeyEstimate {
    let (free, share) = (fit.problem.free[key], fit.best().shares[key]);
    let covariance = fit.covariance.as_ref().filter(|_| is_determined);
    let intervals = || fit.intervals(key).map(|ends| ends.map(|end| end.map(|share| free.value_at_share(share))));
    KeyEstimate {
        free,
        estimate: free.value_at_share(share),
        sd: covariance.map(|covariance| free.slope_at_share(share) * covariance[(key, key)].sqrt()),
        intervals: is_determined.then(intervals),
    }
}

/// Why the keys get no interval; `None` if they get one.
fn reason_without_interval(fit: &Fit, identifiability: Option<&Identifiability>) -> Option<String> {
    let problem = &fit.problem;
    if let Some([low, high]) = fit.plateau() {
        let free = problem.free[0];
        let [low, high] = [low, high].map(|share| free.format_value(free.value_at_share(share), 4));
        return Some(format!(
            "every {} from {low} to {high} fits equally well: this key does not change the predictions there. If the impacts stay elastic, measure at higher speeds. Otherwise measure another quantity, or fix the key at its known value.",
            free.key.path()
        ));
    }
    let message = match fit.noise {
        Noise::TooFew => {
            "the noise is unknown, because there are only as many values as keys. Give calibrate.noise, or more measurements."
        }
        Noise::NoScatter => {
            "repeated readings are identical, so the noise is unknown. Give calibrate.noise (at least half of the last digit)."
        }
        _ => return identifiability.and_then(|found| found.reason_without_intervals.clone()),
    };
    Some(message.to_owned())
}

/// See [`Calibration::misfit`].
fn misfit(data: &MeasurementData, predicted: &[f64]) -> f64 {
    let share_off = |quantity: MeasuredQuantity| {
        let values = data.values.iter().zip(predicted).filter(|(value, _)| value.quantity == quantity);
        let (off, size) = values.fold((0.0, 0.0), |(off, size), (value, predicted)| {
            (off + (value.value - predicted) * (value.value - predicted), size + value.value * value.value)
        });
        f64::sqrt(off / size)
    };
    data.measured_quantities().into_iter().map(share_off).fold(0.0, f64::max)
}
