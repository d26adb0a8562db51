//! Pictures of several unloadings: from the peaks of the finite elements (Fig. 9), and by the law alone with its
//! loading curve (Fig. 11).

use super::super::EXPONENTS;
use super::super::cases::{Case, Cycle};
use super::shares::thinned;
use super::{Picture, SISTER, loop_axes, sampled, slug};
use crate::law::{PlmCoefficients, Unloading, UnloadingExponent};
use crate::plot::{Chart, Series};
use crate::units::capital;

/// Number of unloadings in the picture of loading and unloading by the law alone.
const COMBINED: usize = 3;

pub(super) fn pictures(case: &Case, coefficients: &PlmCoefficients) -> Vec<Picture> {
    let cycles = case.distinct_cycles();
    let (small, large) = cycles.split_at(cycles.len().div_ceil(2));
    let mut pictures: Vec<Picture> = [("small", small), ("large", large)]
        .into_iter()
        .filter_map(|(name, cycles)| from_their_peaks(case, name, cycles, coefficients))
        .collect();
    pictures.extend(combined(case, &cycles[cycles.len().saturating_sub(COMBINED)..], coefficients));
    pictures
}

/// Several curves as one series, separated by points of NaN.
fn joined(curves: impl Iterator<Item = Vec<(f64, f64)>>) -> Vec<(f64, f64)> {
    curves.flat_map(|curve| curve.into_iter().chain([(f64::NAN, f64::NAN)])).collect()
}

/// Points of the finite elements: x or x_h, and f over `unit`.
fn points(case: &Case, cycles: &[&Cycle], of_half_space: bool, unit: f64) -> Vec<(f64, f64)> {
    let kappa = case.sphere_compliance();
    let deepest = cycles.last().map_or(0.0, |cycle| cycle.row.x);
    let peak = |cycle: &Cycle| [cycle.row.x, cycle.row.f, kappa * cycle.peak.elastic_approach];
    let unloading = cycles.iter().flat_map(|cycle| cycle.points.iter().copied().chain([peak(cycle)]));
    let place = |[x, f, sphere]: [f64; 3]| (if of_half_space { x - sphere } else { x }, f / unit);
    thinned(case, deepest).chain(unloading).map(place).collect()
}

/// The unloading branch of the law: x or x_h, and f over `unit`.
fn curve(case: &Case, unloading: &Unloading, of_half_space: bool, unit: f64) -> Vec<(f64, f64)> {
    let kappa = if of_half_space { case.sphere_compliance() } else { 0.0 };
    let peak = unloading.peak;
    sampled(peak.residual(), peak.indentation, 60, |x| (x - kappa * (x - peak.residual()), unloading.force(x) / unit))
}

const SHARES: [(&str, bool); 2] = [("approach δ", false), ("half-space δₕ", true)];

fn from_their_peaks(case: &Case, name: &str, cycles: &[&Cycle], coefficients: &PlmCoefficients) -> Option<Picture> {
    let deepest = cycles.last()?;
    let law = case.law(coefficients, UnloadingExponent::Paper);
    let (axes, unit) = loop_axes(&deepest.peak, 1.05);
    let mut series = Vec::new();
    for (i, (share, of_half_space)) in SHARES.into_iter().enumerate() {
        let points = points(case, cycles, of_half_space, unit);
        series.push(Series::points(format!("{share}, finite elements"), points).styled(i));
        let curves = cycles.iter().map(|cycle| curve(case, &law.unloading(cycle.peak), of_half_space, unit));
        series.push(Series::bare(format!("{share}, unloading law"), joined(curves)).styled(i));
    }
    let title = format!("{}: {name} indentations, exponent 3/2", capital(case.name));
    let lines = Chart::new(title, axes, series).with_notes(["Law: from the peaks", "of the finite elements"]);
    Some((format!("cycles-{}-{name}", slug(case.name)), lines))
}

fn combined(case: &Case, cycles: &[&Cycle], coefficients: &PlmCoefficients) -> Option<Picture> {
    let deepest = cycles.last()?;
    let depth = deepest.peak.indentation;
    let (axes, unit) = loop_axes(&deepest.peak, 1.07);
    let mut series = Vec::new();
    for (i, (share, of_half_space)) in SHARES.into_iter().enumerate() {
        let points = points(case, cycles, of_half_space, unit);
        series.push(Series::points(format!("{share}, finite elements"), points).styled(i));
        let law = case.law(coefficients, UnloadingExponent::Paper);
        let kappa = if of_half_space { case.sphere_compliance() } else { 0.0 };
        let loading = sampled(0.0, depth, 200, |x| {
            let peak = law.loaded_to(x.max(1e-9));
            (x - kappa * peak.elastic_approach, peak.force / unit)
        });
        for (which, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
            let law = case.law(coefficients, exponent);
            let unloadings = cycles
                .iter()
                .map(|cycle| curve(case, &law.unloading(law.loaded_to(cycle.peak.indentation)), of_half_space, unit));
            let first = if which == 0 { loading.clone() } else { Vec::new() };
            let curves = joined(std::iter::once(first).chain(unloadings));
            series.push(Series::bare(format!("{share}, law, {name}"), curves).styled(i + SISTER * which));
        }
    }
    let title = format!("{}: loading and unloading by the law alone", capital(case.name));
    Some((format!("combined-{}", slug(case.name)), Chart::new(title, axes, series)))
}
