//! The fit: Levenberg-Marquardt for force and elastic approach, linear least squares for the contact radius.

use levenberg_marquardt::{LevenbergMarquardt, TerminationReason};
use nalgebra::{DMatrix, DVector};

use super::curve::LoadingCurve;
use super::parameters::encode;
use super::residuals::{Residuals, deviations, rises};
use crate::error::Error;
use crate::law::plm::contact_radius::RadiusTable;
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::math::least_squares::least_squares;
use crate::math::power::{farther_or_nan, max_or_nan};

/// Largest number of evaluations for each varied number.
const PATIENCE: usize = 20;

/// Relative precision of the sum of squares and of the numbers. The knots of the law make kinks in the sum of squares.
/// With a stricter precision the fit moves along the kinks in tiny steps without getting better.
const PRECISION: f64 = 1e-8;

/// Where the fit starts, and whether it moves the knots.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The knots, and the coefficients from which the fit starts. Coefficients that the curves do not determine keep
    /// these values.
    pub start: PlmCoefficients,
    /// Whether knots are fitted too.
    pub has_knots: bool,
}

/// Size of the relative deviations of one quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Root mean square, with weights uniform in ln x.
    pub rms: f64,
    /// The deviation that is largest in magnitude, with its sign.
    pub largest: f64,
}

/// How well a law fits one curve.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseFit<'c> {
    /// The curve.
    pub curve: &'c LoadingCurve,
    /// Deviations of the force.
    pub force: Spread,
    /// Deviations of the elastic approach.
    pub approach: Spread,
    /// Deviations of the contact radius, if the curve has it.
    pub radius: Option<Spread>,
    /// Deviations of force and elastic approach from a law fitted to the other curves; `None` with fewer than three
    /// curves.
    pub left_out: Option<(Spread, Spread)>,
    /// Largest rise of ln e above its smallest value at lower indentations.
    pub restitution_rise: f64,
}

/// The result of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit<'c> {
    /// The coefficients; their provenance is that of the start.
    pub coefficients: PlmCoefficients,
    /// How well the law fits each curve.
    pub cases: Vec<CaseFit<'c>>,
}

/// Fits the coefficients to all curves. Then leaves out each curve in turn and fits to the others.
///
/// # Errors
/// [`Error`] without curves, and if the fit does not converge.
pub fn fit<'c>(curves: &'c [LoadingCurve], plan: &Plan) -> Result<Fit<'c>, Error> {
    let all: Vec<&LoadingCurve> = curves.iter().collect();
    let coefficients = coefficients(&all, plan)?;
    let cases = curves.iter().enumerate().map(|(i, curve)| {
        let others: Vec<&LoadingCurve> =
            curves.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, curve)| curve).collect();
        let left_out = if others.len() < 2 {
            None
        } else {
            let fitted = self::coefficients(&others, plan)?;
            let case = case_fit(curve, &fitted);
            Some((case.force, case.approach))
        };
        Ok(CaseFit { left_out, ..case_fit(curve, &coefficients) })
    });
    let cases = cases.collect::<Result<Vec<_>, Error>>()?;
    Ok(Fit { coefficients, cases })
}

fn coefficients(curves: &[&LoadingCurve], plan: &Plan) -> Result<PlmCoefficients, Error> {
    if curves.is_empty() {
        return Err(Error::input("no curves: name at least one file"));
    }
    let Plan { start, has_knots } = plan;
    let problem = Residuals { curves, form: start, has_knots: *has_knots, start: encode(start, *has_knots) };
    let method = LevenbergMarquardt::new().with_ftol(PRECISION).with_xtol(PRECISION).with_patience(PATIENCE);
    let (numbers, ended) = least_squares(method, problem.start.clone(), |numbers| Some(problem.at(numbers)));
    match ended {
        TerminationReason::Converged { .. }
        | TerminationReason::Orthogonal
        | TerminationReason::ResidualsZero
        // as close as rounding errors allow
        | TerminationReason::NoImprovementPossible(_) => {}
        TerminationReason::LostPatience => {
            return Err(not_converged(&format!("no minimum after {PATIENCE} evaluations for each coefficient")));
        }
        other => return Err(not_converged(&format!("{other:?}"))),
    }
    let mut table = problem.table_at(&numbers);
    table.contact_radius = radius_table(curves, &plan.start.contact_radius);
    table.check().map_err(|error| not_converged(&error.to_string()))?;
    Ok(table)
}

fn not_converged(why: &str) -> Error {
    Error::failed(format!(
        "the least-squares fit did not converge ({why}); take other knots, or curves with less scatter"
    ))
}

/// Λ at the knots of `start`, by linear least squares of Λ/Λ_point − 1. Λ at the first knot and the geometry factor G
/// keep the values of `start`.
fn radius_table(curves: &[&LoadingCurve], start: &RadiusTable) -> RadiusTable {
    let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
    let free = start.from.len().saturating_sub(1);
    for curve in curves {
        let kappa = curve.pair.sphere_compliance;
        let started = start.of(kappa * kappa, curve.yield_radius_ratio);
        for (point, weight) in curve.points.iter().zip(curve.log_weights()) {
            let Some(radius) = point.contact_radius else { continue };
            let equivalent = point.force / point.elastic_approach;
            let wanted = equivalent / (radius * started.geometry_at(equivalent));
            let scale = weight.sqrt() / wanted;
            // the polyline is linear in its values: the share of a knot is the polyline with 1 at this knot and 0 at
            // the others
            let share = |knot: usize| {
                let ratio = (0..=free).map(|i| if i == knot { 1.0 } else { 0.0 }).collect();
                RadiusTable { ratio, ..started.clone() }.ratio_at(equivalent)
            };
            let shares: Vec<f64> = (1..=free).map(|knot| scale * share(knot)).collect();
            rows.push((shares, scale * (wanted - started.ratio_at(equivalent))));
        }
    }
    if rows.is_empty() || free == 0 {
        return start.clone();
    }
    let shares = DMatrix::from_fn(rows.len(), free, |i, j| rows[i].0[j]);
    let missing = DVector::from_fn(rows.len(), |i, _| rows[i].1);
    // the solution of least norm: knots that no point determines keep their values
    let Ok(change) = shares.svd(true, true).solve(&missing, 1e-9) else { return start.clone() };
    let mut fitted = start.clone();
    for (ratio, change) in fitted.ratio.iter_mut().skip(1).zip(change.iter()) {
        *ratio = (*ratio + change).clamp(1.0, 1.6);
    }
    fitted
}

/// How well these coefficients fit a curve.
pub fn case_fit<'c>(curve: &'c LoadingCurve, coefficients: &PlmCoefficients) -> CaseFit<'c> {
    let law = coefficients.law(&curve.pair, curve.yield_radius_ratio, UnloadingExponent::Paper);
    let all: Vec<_> = deviations(curve, &law).collect();
    let spread = |values: Vec<(f64, f64)>| {
        let largest = values.iter().map(|(_, deviation)| *deviation).fold(0.0, farther_or_nan);
        let total: f64 = values.iter().map(|(weight, _)| weight).sum();
        let square: f64 = values.iter().map(|(weight, deviation)| weight * deviation * deviation).sum();
        Spread { rms: (square / total).sqrt(), largest }
    };
    let radius: Vec<(f64, f64)> = all.iter().filter_map(|d| Some((d.weight, d.radius?))).collect();
    CaseFit {
        curve,
        force: spread(all.iter().map(|d| (d.weight, d.force)).collect()),
        approach: spread(all.iter().map(|d| (d.weight, d.approach)).collect()),
        radius: (!radius.is_empty()).then(|| spread(radius)),
        left_out: None,
        restitution_rise: rises(&law, curve).fold(0.0, max_or_nan),
    }
}
