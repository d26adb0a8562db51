//! Finds keys of a scenario from measurements: the values for which the law gives what was measured, their uncertainty,
//! and whether the law fits at all.
//!
//! One or two keys are wanted, and each has a range. A grid over the ranges finds every basin of −2 ln of the
//! likelihood; the method of Levenberg and Marquardt finds the minimum of each basin. If the standard deviations of the
//! noise are known, the likelihood is normal and the sum is chi-square. With `robust` the likelihood has the long tails
//! of Student's distribution with 4 degrees of freedom. The error of the law is a share of each value; it is added to
//! the noise in quadrature, and is independent from value to value. If the noise is not known, it is taken as the same
//! share of every value and estimated from the scatter.
//!
//! The intervals are those of the profile likelihood. An interval holds all values of a key for which the sum,
//! minimised over the other key, is at most z² above its minimum. If the noise is estimated, Student's t² replaces z².
//! The posterior has a flat prior on the range of the key; for a logarithmic range it is flat in the logarithm.
//!
//! No interval is given if the keys can be changed together while the predictions change by less than the error of the
//! law. For example, e(v) alone determines only σ_Y⁵/(E*⁴ ρ v²), so it does not give σ_Y and E together.

pub mod data;
mod error;
pub mod fit;
mod found;
pub mod identify;
pub mod minimum;
pub mod problem;
pub mod profile;
pub mod quantity;
pub mod statistics;

use crate::law::LawChoice;
use crate::plan::Source as Text;
use crate::progress::Counter;
use crate::scenario::calibrate::{Source, Wanted};
use crate::scenario::{Scenario, read_text};
use crate::scene::Scene;
use crate::units::csv_text::TableError;
use data::Data;
pub use error::{CalibrateError, NoAnswer};
pub use fit::Fit;
use fit::{in_order, shifts};
use found::OUTLIER;
pub use found::{Calibration, Found};
use identify::identify;
use problem::Problem;
use quantity::{CURVE, MEASURED, Measured};
use statistics::{chance, chance_of_runs};

/// Largest file of measurements \[MiB\]: enough for a million lines.
const LARGEST: u64 = 64;

/// The keys that are wanted, and the measurements.
#[derive(Debug, Clone)]
pub struct Measurements {
    /// The request of the scenario.
    pub wanted: Wanted,
    /// The measurements.
    pub data: Data,
    /// SHA-256 of the file; `None` if the measurements are in the scenario.
    pub sha256: Option<String>,
    /// The largest measured value.
    largest: f64,
}

impl Measurements {
    /// Reads the request of a scenario and its measurements.
    pub fn of(scenario: &Scenario) -> Result<Self, CalibrateError> {
        let wanted = scenario.wanted()?;
        let (data, sha256) = match &wanted.source {
            Source::Numbers(numbers) => (Data::of_numbers(scenario.document.name(), numbers), None),
            Source::File(path) => {
                let text = read_text(path, LARGEST)?;
                let data = Data::parse(&path.display().to_string(), &text)?;
                let text = Text { text, overrides: Vec::new(), coefficients: None, flow_table: None };
                (data, Some(text.sha256()))
            }
        };
        scenario.check_varied(&wanted, &data.keys, !data.is_curve())?;
        let largest = data.values.iter().map(|value| value.value).fold(0.0, f64::max);
        let measured = Self { wanted, data, sha256, largest };
        measured.check()?;
        Ok(measured)
    }

    fn check(&self) -> Result<(), CalibrateError> {
        let refuse = |message: String| Err(self.refusal(None, message));
        let (values, keys) = (self.data.values.len(), self.wanted.free.len());
        if values < keys {
            return refuse(format!("{values} value for {keys} keys: measure more, or free fewer keys"));
        }
        let has_height = self.data.measured().iter().any(|what| MEASURED[*what].name == "rebound_height");
        if has_height && self.wanted.scene.forces.gravity.is_none() {
            return refuse(
                "a rebound height needs gravity: add [gravity] with acceleration = \"9.81 m/s^2\"".to_owned(),
            );
        }
        let measured = self.data.measured();
        let is_idle = |name: &String| !Measured::find(name).is_some_and(|what| measured.contains(&what));
        if let Some((name, _)) = self.wanted.deviations.iter().find(|(name, _)| is_idle(name)) {
            return refuse(format!("calibrate.noise.{name} is given, but no {name} was measured; leave it out"));
        }
        Ok(())
    }

    /// The standard deviation of every value, and whether only their ratios are known.
    fn deviations(&self) -> Result<(Vec<f64>, bool), CalibrateError> {
        let Wanted { deviations, model_error, is_estimated, .. } = &self.wanted;
        let given = |what: usize| deviations.iter().find(|(name, _)| name == MEASURED[what].name).map(|(_, sd)| *sd);
        let of = |value: &data::Value| value.deviation.or_else(|| given(value.what));
        let is_known = |value: &data::Value| of(value).is_some();
        let is_given = self.data.values.iter().any(is_known);
        let is_estimated = *is_estimated || *model_error == 0.0 && !is_given && deviations.is_empty();
        let deviation = |value: &data::Value| {
            let size = self.size(value);
            if is_estimated && !is_given {
                return Ok(size);
            }
            if is_known(value) || *model_error > 0.0 {
                return Ok(crate::math::functions::hypot(of(value).unwrap_or(0.0), size * model_error));
            }
            let name = MEASURED[value.what].name;
            let message = format!(
                "the {name} of this line has no standard deviation: give calibrate.noise.{name}, or a column for it, or noise = \"estimate\""
            );
            Err(self.refusal(Some(self.data.rows[value.row].line), message))
        };
        Ok((self.data.values.iter().map(deviation).collect::<Result<_, _>>()?, is_estimated))
    }

    /// The number that relative errors of a value refer to: the value itself, or for a curve its largest force, because
    /// a force may be zero.
    fn size(&self, value: &data::Value) -> f64 {
        if value.what == CURVE { self.largest } else { value.value }
    }

    fn refusal(&self, line: Option<u64>, message: String) -> CalibrateError {
        TableError::of(&self.data.name)((line, message)).into()
    }

    fn no_answer(&self, reason: NoAnswer) -> CalibrateError {
        CalibrateError::NoAnswer { name: self.data.name.clone(), reason }
    }

    /// The best keys under a law.
    fn fit(&self, law: &LawChoice) -> Result<Fit<'_>, CalibrateError> {
        let (deviations, is_estimated) = self.deviations()?;
        let scene = Scene { law: law.clone(), ..self.wanted.scene.clone() };
        let problem = Problem::new(&scene, &self.wanted.free, &self.data, deviations, self.wanted.is_robust);
        Fit::of(problem, is_estimated).map_err(|reason| self.no_answer(reason))
    }

    /// The whole calibration. `progress` counts the laws that are fitted and the keys whose intervals are found.
    pub fn calibrate(&self, progress: &Counter) -> Result<Calibration<'_>, CalibrateError> {
        progress.expect((1 + self.wanted.laws.len() + self.wanted.free.len()) as u64);
        let mut laws = Vec::new();
        for law in &self.wanted.laws {
            let fit = match self.fit(law) {
                Err(CalibrateError::NoAnswer { reason, .. }) => Err(reason),
                fit => Ok(fit?),
            };
            laws.push((law.name(), fit));
            progress.step();
        }
        let aic = |fit: &Result<Fit, NoAnswer>| fit.as_ref().map_or(f64::INFINITY, |fit| fit.aic);
        laws.sort_by(|a, b| aic(&a.1).total_cmp(&aic(&b.1)));
        let fit = self.fit(&self.wanted.scene.law)?;
        progress.step();
        let (problem, best) = (&fit.problem, fit.best());
        let no_answer = |reason| self.no_answer(reason);
        let predicted = problem.predict(&best.shares).map_err(no_answer)?;
        let residuals = problem.residuals(&best.shares).map_err(no_answer)?;
        let columns = problem.jacobian(&best.shares).map_err(no_answer)?;
        let identifiability = identify(problem, best);
        let refusal = if fit.has_no_noise {
            Some("no standard deviation was given, and as many values as keys leave no scatter to estimate it from: give calibrate.noise, or measure more".to_owned())
        } else {
            identifiability.as_ref().and_then(|told| told.refusal.clone())
        };
        let (sheet, posteriors) = match problem.free {
            free if fit.has_no_noise => (None, vec![None; free.len()]),
            [_] => (None, vec![Some(fit.posterior())]),
            _ => {
                let (sheet, first) = fit.sheet(0);
                (Some(sheet), vec![Some(first), Some(fit.sheet(1).1)])
            }
        };
        let mut keys = Vec::new();
        let told = fit.covariance.as_ref().filter(|_| refusal.is_none());
        for ((i, free), posterior) in problem.free.iter().enumerate().zip(posteriors) {
            let slope = free.slope(best.shares[i]);
            let common = told.filter(|_| self.wanted.model_error > 0.0);
            let intervals = || fit.intervals(i).map(|ends| ends.map(|end| end.map(|share| free.at(share))));
            keys.push(Found {
                free: *free,
                estimate: free.at(best.shares[i]),
                sd: told.map(|covariance| slope * covariance[i][i].sqrt()),
                sd_of_common_error: common
                    .map(|covariance| slope * self.of_common_error(problem, &covariance[i], &columns)),
                intervals: refusal.is_none().then(intervals),
                posterior,
            });
            progress.step();
        }
        let outlies = |residual: &&f64| self.wanted.is_robust && residual.abs() > OUTLIER;
        let outliers = residuals.iter().filter(outlies).count();
        let freedom = (residuals.len() - outliers).saturating_sub(keys.len());
        let chi_square =
            residuals.iter().filter(|residual| !outlies(residual)).map(|residual| residual * residual).sum();
        Ok(Calibration {
            p: if fit.freedom.is_some() || fit.has_no_noise { None } else { chance(chi_square, freedom) },
            p_of_runs: chance_of_runs(&in_order(problem, &residuals)),
            shifts: fit.covariance.as_ref().map(|covariance| shifts(problem, covariance, &columns, &residuals)),
            misfit: misfit(&self.data, &predicted),
            fit,
            keys,
            predicted,
            residuals,
            chi_square,
            freedom,
            outliers,
            identifiability,
            refusal,
            sheet,
            laws,
        })
    }

    /// Standard deviation of the share of a key, if the law has the same error for all values of a quantity.
    /// `covariance` has the covariances of this key.
    fn of_common_error(&self, problem: &Problem, covariance: &[f64], columns: &[Vec<f64>]) -> f64 {
        let (mut own, mut common) = (0.0, [0.0; MEASURED.len()]);
        for (i, at) in problem.counted.iter().enumerate() {
            let gain: f64 = covariance.iter().zip(columns).map(|(part, column)| part * column[i]).sum();
            let (value, whole) = (&problem.data.values[*at], problem.deviations[*at]);
            let error = self.wanted.model_error * self.size(value) / whole;
            own += gain * gain * (1.0 - error * error).max(0.0);
            common[value.what] += gain * error;
        }
        (own + common.iter().map(|sum| sum * sum).sum::<f64>()).sqrt()
    }
}

/// See [`Calibration::misfit`].
fn misfit(data: &Data, predicted: &[f64]) -> f64 {
    let of = |what: usize| {
        let values = data.values.iter().zip(predicted).filter(|(value, _)| value.what == what);
        let (off, size) = values.fold((0.0, 0.0), |(off, size), (value, predicted)| {
            (off + (value.value - predicted) * (value.value - predicted), size + value.value * value.value)
        });
        f64::sqrt(off / size)
    };
    data.measured().into_iter().map(of).fold(0.0, f64::max)
}
