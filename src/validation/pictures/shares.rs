//! Pictures of single unloadings: the shape (Fig. 5), and force against the approach and the indentations of sphere and
//! half-space (Fig. 8).

use super::super::EXPONENTS;
use super::super::cases::{Case, Cycle};
use super::super::unloading::branch;
use super::{Picture, loop_axes, sampled, slug};
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::math::functions::pow;
use crate::plot::{Axis, Chart, Series};
use crate::units::capital;
use crate::units::rounded::number;

/// Largest number of unloadings in a picture of shapes.
const MOST_SHAPES: usize = 6;
/// Largest number of depths in pictures of force against approach and indentations.
const DEPTHS: usize = 4;

/// `count` of the items at even steps, including the first and the last.
fn spread<T: Copy>(items: &[T], count: usize) -> Vec<T> {
    if items.len() <= count || count < 2 {
        return items.to_vec();
    }
    (0..count).map(|i| items[i * (items.len() - 1) / (count - 1)]).collect()
}

/// Force over peak force against the approach still to be recovered, as a share of all that is recovered.
pub(super) fn shape(case: &Case, coefficients: &PlmCoefficients) -> Picture {
    let cycles = spread(&case.distinct_cycles(), MOST_SHAPES);
    let mut series: Vec<Series> = cycles
        .iter()
        .map(|cycle| {
            let elastic = cycle.row.x - cycle.residual();
            let points = cycle.points.iter().map(|[x, f, _]| ((x - cycle.residual()) / elastic, f / cycle.row.f));
            Series::points(format!("from {} × yield", number(cycle.row.x)), points.collect())
        })
        .collect();
    for (exponent, name) in EXPONENTS {
        // the deepest unloading has the smallest exponent
        let Some(cycle) = cycles.last() else { continue };
        let n = branch(case, cycle, coefficients, exponent).exponent;
        let name = if n == 1.5 { name.to_owned() } else { format!("{name}, deepest: n = {}", number(n)) };
        series.push(Series::bare(name, sampled(0.0, 1.0, 100, |u| (u, pow(u, n)))));
    }
    let title = format!("Shape of the unloading curve: {}", case.name);
    let axes = ["(δ − δᵣ)/(δₘ − δᵣ)", "F/Fₘ"].map(|title| Axis::linear(title, "").between(0.0, 1.04));
    (format!("unloading-shape-{}", slug(case.name)), Chart::new(title, axes, series))
}

pub(super) fn pictures(case: &Case, coefficients: &PlmCoefficients) -> Vec<Picture> {
    spread(&case.distinct_cycles(), DEPTHS).into_iter().map(|cycle| picture(case, cycle, coefficients)).collect()
}

/// The factor by which the indentation of the sphere is enlarged in the picture.
fn magnification(share: f64) -> f64 {
    [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0]
        .into_iter()
        .take_while(|times| times * share < 0.9)
        .last()
        .unwrap_or(1.0)
}

fn picture(case: &Case, cycle: &Cycle, coefficients: &PlmCoefficients) -> Picture {
    let kappa = case.sphere_compliance();
    let peak = cycle.peak;
    let times = magnification(kappa * peak.elastic_approach / peak.indentation);
    let loading = || thinned(case, peak.indentation);
    let unloading = || cycle.points.iter().copied();
    let law = case.law(coefficients, UnloadingExponent::Paper).unloading(peak);
    let of_law = |x: f64| {
        let sphere = kappa * (x - peak.residual());
        [x, times * sphere, x - sphere]
    };
    let (axes, unit) = loop_axes(&peak, 1.05);
    let mut series = Vec::new();
    let magnified = if times > 1.0 { format!("sphere δₛ × {times}") } else { "sphere δₛ".to_owned() };
    for (i, name) in ["approach δ", &magnified, "half-space δₕ"].into_iter().enumerate() {
        let share = |[x, f, sphere]: [f64; 3]| ([x, times * sphere, x - sphere][i], f / unit);
        let points =
            loading().chain(unloading()).chain([[peak.indentation, peak.force, kappa * peak.elastic_approach]]);
        series.push(Series::points(format!("{name}, finite elements"), points.map(share).collect()).styled(i));
        let curve = sampled(peak.residual(), peak.indentation, 100, |x| (of_law(x)[i], law.force(x) / unit));
        series.push(Series::bare(format!("{name}, unloading law"), curve).styled(i));
    }
    let depth = number(peak.indentation);
    let title = format!("{}: unloading from {depth} × the yield indentation, exponent 3/2", capital(case.name));
    let lines = Chart::new(title, axes, series).with_notes(["Law: from the peak", "of the finite elements"]);
    (format!("unloading-{}-from-{:.0}", slug(case.name), peak.indentation), lines)
}

/// Points x, f and x_s of the loading curve below the indentation `up_to`, at distances of at least a twentieth of
/// `up_to`.
pub(super) fn thinned(case: &Case, up_to: f64) -> impl Iterator<Item = [f64; 3]> {
    let kappa = case.sphere_compliance();
    let mut last = f64::NEG_INFINITY;
    case.loading
        .points
        .iter()
        .take_while(move |point| point.indentation < 0.99 * up_to)
        .filter(move |point| {
            let is_kept = point.indentation - last > 0.05 * up_to;
            if is_kept {
                last = point.indentation;
            }
            is_kept
        })
        .map(move |point| [point.indentation, point.force, kappa * point.elastic_approach])
}
