//! The result of a calibration.

use nalgebra::DMatrix;

use super::fit::{Fit, Noise};
use super::identifiability::{Identifiability, MODEL_ERROR};
use super::problem::PredictionError;
use super::profile::IntervalEnds;
use super::statistics::{RunsTest, chi_square_p_value};
use crate::scenario::input::Input;
use crate::scenario::plan::FreeKey;
use crate::units::{format_four_digits, format_percent};

/// With `robust`, residuals of more than this many standard deviations are outliers.
pub(super) const OUTLIER_LIMIT: f64 = 3.0;
/// If more than this share of the values are outliers, the law is taken not to fit.
const MAX_OUTLIER_SHARE: f64 = 0.2;
/// The law is rejected if the measurements have a smaller probability than this.
const REJECTION_P: f64 = 0.01;

pub type LawFit<'a> = (String, Result<Fit<'a>, PredictionError>);

/// The result for one key.
#[derive(Debug, Clone)]
pub struct KeyEstimate {
    /// The key and its range.
    pub free: FreeKey,
    /// Its best value, SI.
    pub estimate: f64,
    /// Standard deviation, SI; `None` if the measurements do not determine the key.
    pub sd: Option<f64>,
    /// Intervals of the profile likelihood at both levels, SI; an end is `None` if it lies outside of the range of the
    /// key.
    pub intervals: Option<[IntervalEnds; 2]>,
}

/// The result of a calibration.
#[derive(Debug)]
pub struct Calibration<'a> {
    /// The best keys under the law of the scenario.
    pub fit: Fit<'a>,
    pub keys: Vec<KeyEstimate>,
    /// The prediction for every value.
    pub predicted: Vec<f64>,
    /// Residual of every value: measured minus predicted, over the standard deviation.
    pub residuals: Vec<f64>,
    /// For every value (row), the change of every key (in shares) if this value were left out, to first order.
    pub shifts: Option<DMatrix<f64>>,
    /// Sum of the squares of the residuals, without outliers.
    pub chi_square: f64,
    /// Degrees of freedom of the residuals.
    pub degrees_of_freedom: usize,
    /// Number of values that are taken as outliers.
    pub outliers: usize,
    /// Root mean square of measured minus predicted over root mean square of measured. It is computed for each
    /// quantity, and this is the largest.
    pub misfit: f64,
    /// Probability of this chi-square or a larger one; `None` if the noise is estimated.
    pub p: Option<f64>,
    /// The test of runs of equal signs in the residuals, in the order of the speeds.
    pub runs: Option<RunsTest>,
    /// How well the measurements determine the keys together.
    pub identifiability: Option<Identifiability>,
    /// Why there is no interval; `None` if there is one.
    pub reason_without_intervals: Option<String>,
    /// The fit of every requested law, the best first.
    pub laws: Vec<LawFit<'a>>,
}

/// Whether the data are compatible with the law.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The law fits within the noise.
    Fits,
    /// The law does not fit, for this reason.
    Contradicted(String),
    /// The law deviates from the data. The measurements cannot decide whether the deviation is noise, for this reason.
    Undecided(String),
    /// The measurements leave nothing by which to judge.
    NotJudged,
}

impl Verdict {
    /// True if the data are compatible with the law; `None` if the measurements cannot decide.
    pub fn is_compatible(&self) -> Option<bool> {
        match self {
            Self::Fits => Some(true),
            Self::Contradicted(_) => Some(false),
            Self::Undecided(_) | Self::NotJudged => None,
        }
    }

    /// The reason why the law does not fit; `None` if it may fit.
    pub fn contradiction_reason(self) -> Option<String> {
        if let Self::Contradicted(reason) = self { Some(reason) } else { None }
    }

    /// The reason why the measurements cannot decide whether the law fits; `None` if they can.
    pub fn undecided_reason(self) -> Option<String> {
        if let Self::Undecided(reason) = self { Some(reason) } else { None }
    }
}

impl Calibration<'_> {
    /// The input of the first impact of the data with the values that were found.
    pub fn input(&self) -> Input {
        self.fit.problem.row_input(0, &self.fit.best().shares)
    }

    /// True if the law fits: by the outliers, then by chi-square if the noise is known, or by the signs of the residuals if it
    /// is estimated.
    pub fn verdict(&self) -> Verdict {
        let values = self.residuals.len();
        let law = self.fit.problem.input.named_law.name();
        if self.outliers as f64 > MAX_OUTLIER_SHARE * values as f64 {
            return Verdict::Contradicted(format!(
                "the law {law} does not fit: {} of {values} values deviate by more than {OUTLIER_LIMIT} standard deviations. So many values cannot be outliers.",
                self.outliers
            ));
        }
        match self.fit.noise {
            Noise::TooFew => self.unmatched_reason(&law).map_or(Verdict::NotJudged, Verdict::Contradicted),
            Noise::NoScatter => Verdict::NotJudged,
            Noise::Given => {
                // with as many values as keys the law can meet all of them, if their noise allows it
                let freedom = self.degrees_of_freedom.max(1);
                let p = chi_square_p_value(self.chi_square, freedom).unwrap_or(1.0);
                if p < REJECTION_P {
                    let chi_square = format_four_digits(self.chi_square);
                    return rejection(&law, &format!("chi-square is {chi_square} on {freedom} degrees of freedom"), p);
                }
                if self.degrees_of_freedom > 0 { Verdict::Fits } else { Verdict::NotJudged }
            }
            Noise::Estimated { .. } => self.runs_test_verdict(&law),
        }
    }

    /// Why as many keys as values do not meet the values; `None` if they do.
    fn unmatched_reason(&self, law: &str) -> Option<String> {
        let unreached = self.residuals.iter().map(|residual| residual.abs()).fold(0.0, f64::max);
        let off = if unreached < 10.0 {
            format_percent(unreached)
        } else {
            format_four_digits(unreached) + " times the value"
        };
        let keys = self.keys.iter().map(|key| key.free.key.path()).collect::<Vec<_>>().join(", ");
        (unreached > 1e-6).then(|| {
            format!(
                "no value of {keys} in the search range reproduces the measurement with the law {law}; the best deviates by {off}"
            )
        })
    }

    /// The verdict of the test of runs, where the law is off by more than the usual error of laws.
    fn runs_test_verdict(&self, law: &str) -> Verdict {
        let off = format_percent(self.misfit);
        match self.runs.filter(|_| self.misfit > MODEL_ERROR) {
            Some(runs) if runs.p < REJECTION_P => {
                let reason = format!("rms misfit {off}, and the residuals are not random (runs test)");
                rejection(law, &reason, runs.p)
            }
            Some(runs) if runs.min_p >= REJECTION_P => Verdict::Undecided(format!(
                "the goodness of fit is unknown: rms misfit {off}, but {} values are too few for the runs test (its p cannot be below {}). Give calibrate.noise, or more measurements.",
                self.residuals.len(),
                format_four_digits(runs.min_p)
            )),
            _ if self.degrees_of_freedom > 0 => Verdict::Fits,
            _ => Verdict::NotJudged,
        }
    }

    /// Correlation of the two keys.
    pub fn correlation(&self) -> Option<f64> {
        let covariance = self.fit.covariance.as_ref().filter(|covariance| covariance.ncols() == 2)?;
        Some(covariance[(0, 1)] / (covariance[(0, 0)] * covariance[(1, 1)]).sqrt())
    }

    /// The smallest AIC of all laws; NaN without one.
    pub fn min_aic(&self) -> f64 {
        self.laws.first().and_then(|(_, fit)| fit.as_ref().ok()).map_or(f64::NAN, |fit| fit.aic)
    }
}

fn rejection(law: &str, reason: &str, p: f64) -> Verdict {
    Verdict::Contradicted(format!(
        "the law {law} does not fit the data: {reason}, p = {}. Inspect residuals.png; compare laws with --all-laws.",
        format_four_digits(p)
    ))
}
