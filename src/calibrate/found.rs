//! The result of a calibration.

use nalgebra::DMatrix;

use super::fit::{Fit, Noise};
use super::identify::{Identifiability, LAW};
use super::problem::NoAnswer;
use super::profile::Ends;
use super::statistics::{Runs, chance};
use crate::plan::free::Free;
use crate::units::four_digits;
use crate::units::rounded::percent;

/// With `robust`, residuals of more than this many standard deviations are outliers.
pub(super) const OUTLIER: f64 = 3.0;
/// If more than this share of the values are outliers, the law is taken not to fit.
const MOST_OUTLIERS: f64 = 0.2;
/// The law is rejected if the measurements have a smaller probability than this.
const REJECTED: f64 = 0.01;

/// The fit of a law, by the name of the law.
pub type OfLaw<'a> = (String, Result<Fit<'a>, NoAnswer>);

/// The result for one key.
#[derive(Debug, Clone)]
pub struct Found {
    /// The key and its range.
    pub free: Free,
    /// Its best value, SI.
    pub estimate: f64,
    /// Standard deviation, SI; `None` if the measurements do not determine the key.
    pub sd: Option<f64>,
    /// Intervals of the profile likelihood at both levels, SI; an end is `None` if it lies outside of the range of the
    /// key.
    pub intervals: Option<[Ends; 2]>,
}

/// The result of a calibration.
#[derive(Debug)]
pub struct Calibration<'a> {
    /// The best keys under the law of the scenario.
    pub fit: Fit<'a>,
    /// The result for each key.
    pub keys: Vec<Found>,
    /// The prediction for every value.
    pub predicted: Vec<f64>,
    /// Residual of every value: measured minus predicted, over the standard deviation.
    pub residuals: Vec<f64>,
    /// For every value (row), the change of every key (in shares) if this value were left out, to first order.
    pub shifts: Option<DMatrix<f64>>,
    /// Sum of the squares of the residuals, without outliers.
    pub chi_square: f64,
    /// Degrees of freedom of the residuals.
    pub freedom: usize,
    /// Number of values that are taken as outliers.
    pub outliers: usize,
    /// Root mean square of measured minus predicted over root mean square of measured. It is computed for each
    /// quantity, and this is the largest.
    pub misfit: f64,
    /// Probability of this chi-square or a larger one; `None` if the noise is estimated.
    pub p: Option<f64>,
    /// The test of runs of equal signs in the residuals, in the order of the speeds.
    pub runs: Option<Runs>,
    /// How well the measurements determine the keys together.
    pub identifiability: Option<Identifiability>,
    /// Why there is no interval; `None` if there is one.
    pub refusal: Option<String>,
    /// The fit of every law that was asked for, the best first.
    pub laws: Vec<OfLaw<'a>>,
}

impl Calibration<'_> {
    /// Why the law does not fit; `None` if it may.
    pub fn contradiction(&self) -> Option<String> {
        let values = self.residuals.len();
        let law = self.fit.problem.scene.law.name();
        #[allow(clippy::cast_precision_loss)] // counts of measurements
        if self.outliers as f64 > MOST_OUTLIERS * values as f64 {
            let what = format!("{} of {values} values are more than {OUTLIER} standard deviations", self.outliers);
            return Some(format!("the law {law} does not fit: {what} from it; outliers are fewer"));
        }
        let unreached = self.residuals.iter().map(|residual| residual.abs()).fold(0.0, f64::max);
        if self.fit.noise == Noise::TooFew && unreached > 1e-6 {
            let key = self.keys.iter().map(|key| key.free.key.path).collect::<Vec<_>>().join(", ");
            return Some(format!(
                "no value of {key} in its range gives what was measured under the law {law}; the nearest is off by {}",
                if unreached < 10.0 {
                    percent(unreached)
                } else {
                    format!("{} times the value", four_digits(unreached))
                }
            ));
        }
        let (p, what) = if self.fit.noise == Noise::Given {
            // with as many values as keys the law can meet all of them, if their noise allows it
            let freedom = self.freedom.max(1);
            let p = chance(self.chi_square, freedom)?;
            (p, format!("chi-square is {} on {freedom} degrees of freedom", four_digits(self.chi_square)))
        } else {
            let p = self.doubtful()?.p;
            let off = percent(self.misfit);
            (p, format!("it is off by {off}, and the residuals keep their signs for too long"))
        };
        (p < REJECTED).then(|| {
            format!(
                "the law {law} does not fit these data within their noise: {what}, p = {}; look at the residuals, and at other laws with --law all",
                four_digits(p)
            )
        })
    }

    /// The test of runs where it decides: the noise is estimated, and the law is off by more than the usual error of
    /// laws.
    fn doubtful(&self) -> Option<Runs> {
        self.runs.filter(|_| self.fit.freedom().is_some() && self.misfit > LAW)
    }

    /// Why it cannot be judged whether the law fits, although it is off; `None` if it can.
    pub fn undecided(&self) -> Option<String> {
        let few = self.doubtful().filter(|runs| runs.p >= REJECTED && runs.least >= REJECTED)?;
        Some(format!(
            "whether the law fits cannot be judged: it is off by {}, but with {} values any noise explains that (the test of runs cannot fall below p = {}); give calibrate.noise, or measure more",
            percent(self.misfit),
            self.residuals.len(),
            four_digits(few.least)
        ))
    }

    /// Whether the law fits; `None` if these measurements cannot tell.
    pub fn fits(&self) -> Option<bool> {
        let is_judged = self.freedom > 0 && !self.fit.has_no_noise() && self.undecided().is_none();
        if self.contradiction().is_some() { Some(false) } else { is_judged.then_some(true) }
    }

    /// Correlation of the two keys.
    pub fn correlation(&self) -> Option<f64> {
        let covariance = self.fit.covariance.as_ref().filter(|covariance| covariance.ncols() == 2)?;
        Some(covariance[(0, 1)] / (covariance[(0, 0)] * covariance[(1, 1)]).sqrt())
    }

    /// The smallest AIC of all laws; NaN without one.
    pub fn least_aic(&self) -> f64 {
        self.laws.first().and_then(|(_, fit)| fit.as_ref().ok()).map_or(f64::NAN, |fit| fit.aic)
    }
}
