//! From measurements to the keys of a scenario: what a material must be so that the law gives what was measured, how sure
//! that is, and whether the law fits at all.
//!
//! The keys that are wanted (one or two) have ranges. A grid over the ranges finds every basin of −2 ln of the likelihood;
//! Levenberg and Marquardt's method goes to the bottom of each. With noise of known standard deviations the likelihood is
//! normal, so that its sum is chi-square; with `robust` it has the long tails of Student's distribution with 4 degrees of
//! freedom. The law's own error is added to the noise in quadrature, as a share of each value, independent from value to
//! value. A noise that is not known is the same share of every value, and is estimated from the scatter.
//!
//! Intervals are those of the profile likelihood: all values of a key for which the sum, with the other key at its best, is
//! at most z² above the least (with an estimated noise, Student's t² in place of z²). The posterior has a flat prior on the
//! range, in the logarithm for a logarithmic range.
//!
//! An interval is refused where the keys can be moved together without a change of the predictions beyond the error that
//! laws have. So e(v) alone fixes only σ_Y⁵/(E*⁴ ρ v²): it does not give σ_Y and E together.

pub mod data;
mod error;
pub mod fit;
pub mod identify;
pub mod minimum;
pub mod problem;
pub mod profile;
pub mod quantity;
pub mod statistics;

use crate::law::LawChoice;
use crate::plan::Source as Text;
use crate::plan::free::Free;
use crate::progress::Counter;
use crate::scenario::calibrate::{Source, Wanted};
use crate::scenario::{Scenario, read_text};
use crate::scene::Scene;
use data::Data;
pub use error::{CalibrateError, NoAnswer};
pub use fit::Fit;
use fit::{covariance, in_order, shifts};
use identify::{Identifiability, LAW, identify};
use problem::Problem;
use profile::{Ends, Marginal, Sheet};
use quantity::{CURVE, MEASURED, Measured};
use statistics::{chance, chance_of_runs};

/// MiB of a file of measurements: a million lines.
const LARGEST: u64 = 64;
/// Residuals beyond so many standard deviations are outliers, where outliers are expected.
const OUTLIER: f64 = 3.0;
/// More outliers than this share of the values are no outliers.
const MOST_OUTLIERS: f64 = 0.2;
/// The law is rejected where the chance of what was measured is smaller.
const REJECTED: f64 = 0.01;

/// What is wanted, and the measurements.
#[derive(Debug, Clone)]
pub struct Measurements {
    /// What the scenario asks for.
    pub wanted: Wanted,
    /// What was measured.
    pub data: Data,
    /// SHA-256 of the file; `None` for numbers of the scenario.
    pub sha256: Option<String>,
    /// The largest value.
    largest: f64,
}

/// What is known of a key.
#[derive(Debug, Clone)]
pub struct Found {
    /// The key and its range.
    pub free: Free,
    /// Its best value, SI.
    pub estimate: f64,
    /// Standard deviation, SI; `None` where the measurements do not tell.
    pub sd: Option<f64>,
    /// The same if the error of the law is one and the same for all values of a quantity.
    pub sd_of_common_error: Option<f64>,
    /// Intervals of the profile likelihood at both levels, SI; an end is `None` where the range ends first.
    pub intervals: Option<[Ends; 2]>,
    /// The posterior; `None` without an interval.
    pub posterior: Option<Marginal>,
}

/// All that is known.
#[derive(Debug)]
pub struct Calibration<'a> {
    /// The best keys under the law of the scenario.
    pub fit: Fit<'a>,
    /// Each key.
    pub keys: Vec<Found>,
    /// Covariance of the shares of the ranges.
    pub covariance: Option<Vec<Vec<f64>>>,
    /// What is predicted for every value.
    pub predicted: Vec<f64>,
    /// Measured less predicted, over the standard deviation.
    pub residuals: Vec<f64>,
    /// By how much every key (in shares) would be shifted without a value, to first order.
    pub shifts: Option<Vec<Vec<f64>>>,
    /// Sum of the squares of the residuals, without those of outliers.
    pub chi_square: f64,
    /// Degrees of freedom of the residuals.
    pub freedom: usize,
    /// Values that are taken for outliers.
    pub outliers: usize,
    /// Root mean square of measured less predicted, as a share of the measured; the largest of all quantities.
    pub misfit: f64,
    /// The chance of this chi-square or a larger one; `None` where the noise is estimated.
    pub p: Option<f64>,
    /// The chance of so few runs of equal signs in the residuals, in the order of the speeds.
    pub p_of_runs: Option<f64>,
    /// What the measurements tell of the keys together.
    pub identifiability: Option<Identifiability>,
    /// Why there is no interval.
    pub refusal: Option<String>,
    /// The posterior on the plane of two keys.
    pub sheet: Option<Sheet>,
    /// Every law that was asked for with its fit, the best first.
    pub laws: Vec<(String, Result<Fit<'a>, NoAnswer>)>,
    /// Why the law does not fit.
    pub contradiction: Option<String>,
}

impl Measurements {
    /// Reads what a scenario asks for.
    ///
    /// # Errors
    /// [`CalibrateError`].
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
        let refuse = |message: String| Err(CalibrateError::Data { name: self.data.name.clone(), line: None, message });
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

    /// The standard deviation of every value, and whether these are only their ratios.
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
            let line = Some(self.data.rows[value.row].line);
            Err(CalibrateError::Data { name: self.data.name.clone(), line, message })
        };
        Ok((self.data.values.iter().map(deviation).collect::<Result<_, _>>()?, is_estimated))
    }

    /// What shares of a value are of. A force may be zero: along a curve it is the largest one.
    fn size(&self, value: &data::Value) -> f64 {
        if value.what == CURVE { self.largest } else { value.value }
    }

    /// The best keys under a law.
    ///
    /// # Errors
    /// [`CalibrateError`].
    pub fn fit(&self, law: &LawChoice) -> Result<Fit<'_>, CalibrateError> {
        let (deviations, is_estimated) = self.deviations()?;
        let scene = Scene { law: law.clone(), ..self.wanted.scene.clone() };
        let problem = Problem::new(&scene, &self.wanted.free, &self.data, deviations, self.wanted.is_robust);
        let reason = |reason| CalibrateError::NoAnswer { name: self.data.name.clone(), reason };
        Fit::of(problem, is_estimated).map_err(reason)
    }

    /// All that the measurements tell. Counted are the laws that are fitted, and the keys whose intervals are found.
    ///
    /// # Errors
    /// [`CalibrateError`].
    pub fn calibrate(&self, progress: &Counter) -> Result<Calibration<'_>, CalibrateError> {
        progress.expect((1 + self.wanted.laws.len() + self.wanted.free.len()) as u64);
        let mut laws = Vec::new();
        for law in &self.wanted.laws {
            laws.push((
                law.name(),
                match self.fit(law) {
                    Err(CalibrateError::NoAnswer { reason, .. }) => Err(reason),
                    fit => Ok(fit?),
                },
            ));
            progress.step();
        }
        let aic = |fit: &Result<Fit, NoAnswer>| fit.as_ref().map_or(f64::INFINITY, |fit| fit.aic);
        laws.sort_by(|a, b| aic(&a.1).total_cmp(&aic(&b.1)));
        let fit = self.fit(&self.wanted.scene.law)?;
        progress.step();
        let place = fit.minima[0].clone();
        let reason = |reason| CalibrateError::NoAnswer { name: self.data.name.clone(), reason };
        let predicted = fit.problem.predict(&place.shares).map_err(reason)?;
        let residuals = fit.problem.residuals(&place.shares).map_err(reason)?;
        let columns = fit.problem.jacobian(&place.shares).map_err(reason)?;
        let covariance = covariance(&fit.problem, &columns);
        let identifiability = identify(&fit.problem, &place);
        let refusal = if fit.has_no_noise {
            Some("no standard deviation was given, and as many values as keys leave no scatter to estimate it from: give calibrate.noise, or measure more".to_owned())
        } else {
            identifiability.as_ref().and_then(|told| told.refusal.clone())
        };
        let profile = fit.profile(covariance.as_deref());
        let (sheet, mut posteriors) = match fit.problem.free.len() {
            _ if fit.has_no_noise => (None, Vec::new()),
            1 => (None, vec![profile.posterior()]),
            _ => {
                let (sheet, first) = profile.sheet(0);
                (Some(sheet), vec![first, profile.sheet(1).1])
            }
        };
        let mut keys = Vec::new();
        for (i, free) in fit.problem.free.iter().enumerate() {
            let slope = free.slope(place.shares[i]);
            let told = || covariance.as_ref().filter(|_| refusal.is_none());
            let value = |ends: Ends| ends.map(|end| end.map(|share| free.at(share)));
            let common =
                |covariance: &Vec<Vec<f64>>| slope * self.of_common_error(&fit.problem, covariance, &columns, i);
            keys.push(Found {
                free: *free,
                estimate: free.at(place.shares[i]),
                sd: told().map(|covariance| slope * covariance[i][i].sqrt()),
                sd_of_common_error: told().filter(|_| self.wanted.model_error > 0.0).map(common),
                intervals: refusal.is_none().then(|| profile.intervals(i).map(value)),
                posterior: (!posteriors.is_empty()).then(|| posteriors.remove(0)),
            });
            progress.step();
        }
        let outlies = |residual: &&f64| self.wanted.is_robust && residual.abs() > OUTLIER;
        let outliers = residuals.iter().filter(outlies).count();
        let freedom = (residuals.len() - outliers).saturating_sub(keys.len());
        let chi_square =
            residuals.iter().filter(|residual| !outlies(residual)).map(|residual| residual * residual).sum();
        let p = if fit.freedom.is_some() || fit.has_no_noise { None } else { chance(chi_square, freedom) };
        let p_of_runs = chance_of_runs(&in_order(&fit.problem, &residuals));
        let shifts = covariance.as_ref().map(|covariance| shifts(&fit.problem, covariance, &columns, &residuals));
        let mut found = Calibration {
            fit,
            keys,
            covariance,
            misfit: misfit(&self.data, &predicted),
            predicted,
            residuals,
            shifts,
            chi_square,
            freedom,
            outliers,
            p,
            p_of_runs,
            identifiability,
            refusal,
            sheet,
            laws,
            contradiction: None,
        };
        found.contradiction = found.contradicts();
        Ok(found)
    }

    /// Standard deviation of a share where the error of the law is common to all values of a quantity.
    fn of_common_error(&self, problem: &Problem, covariance: &[Vec<f64>], columns: &[Vec<f64>], key: usize) -> f64 {
        let (mut own, mut common) = (0.0, [0.0; MEASURED.len()]);
        for (i, at) in problem.counted.iter().enumerate() {
            let gain: f64 = covariance[key].iter().zip(columns).map(|(part, column)| part * column[i]).sum();
            let (value, whole) = (&problem.data.values[*at], problem.deviations[*at]);
            let error = self.wanted.model_error * self.size(value) / whole;
            own += gain * gain * (1.0 - error * error).max(0.0);
            common[value.what] += gain * error;
        }
        (own + common.iter().map(|sum| sum * sum).sum::<f64>()).sqrt()
    }
}

impl Calibration<'_> {
    /// Why the law does not fit; `None` where it may.
    fn contradicts(&self) -> Option<String> {
        let values = self.residuals.len();
        let law = self.fit.problem.scene.law.name();
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        if self.outliers as f64 > MOST_OUTLIERS * values as f64 {
            let what = format!("{} of {values} values are more than {OUTLIER} standard deviations", self.outliers);
            return Some(format!("the law {law} does not fit: {what} from it; outliers are fewer"));
        }
        let unreached = self.residuals.iter().map(|residual| residual.abs()).fold(0.0, f64::max);
        if self.fit.has_no_noise && unreached > 1e-6 {
            let key = self.keys.iter().map(|key| key.free.key.path).collect::<Vec<_>>().join(", ");
            return Some(format!(
                "no value of {key} in its range gives what was measured under the law {law}; the nearest is off by {}",
                crate::units::rounded::percent(unreached)
            ));
        }
        let (p, what) = match self.p {
            Some(p) => (
                Some(p),
                format!(
                    "chi-square is {} on {} degrees of freedom",
                    crate::units::four_digits(self.chi_square),
                    self.freedom
                ),
            ),
            // a law that is off by less than laws are is no contradiction
            None => (
                self.p_of_runs.filter(|_| !self.fit.has_no_noise && self.misfit > LAW),
                format!(
                    "it is off by {}, and the residuals keep their signs for too long",
                    crate::units::rounded::percent(self.misfit)
                ),
            ),
        };
        let p = p.filter(|p| *p < REJECTED)?;
        Some(format!(
            "the law {law} does not fit these data within their noise: {what}, p = {}; look at the residuals, and at other laws with --law all",
            crate::units::four_digits(p)
        ))
    }

    /// Correlation of the two keys.
    pub fn correlation(&self) -> Option<f64> {
        let covariance = self.covariance.as_ref().filter(|covariance| covariance.len() == 2)?;
        Some(covariance[0][1] / (covariance[0][0] * covariance[1][1]).sqrt())
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
