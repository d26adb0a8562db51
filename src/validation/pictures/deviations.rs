//! Pictures against depth: deviations of force, indentations and contact radius during loading, of the dent, of the
//! force during unloading, and of restitution; and restitution itself.

use super::super::EXPONENTS;
use super::super::cases::Case;
use super::super::check::deviation;
use super::super::loading::{QUANTITIES, along};
use super::super::restitution::restitution;
use super::super::unloading::{branch, farthest};
use super::{Picture, log_sampled, slug};
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::plot::{Axis, Guide, Series};
use crate::units::capital;

fn depth(title: &str) -> Axis {
    Axis::log(title, "")
}

const PEAK: &str = "Peak indentation over that at yield";

fn horizontal(levels: &[f64], label: &str) -> Vec<Guide> {
    levels.iter().map(|at| Guide::Horizontal { at: *at, label: label.to_owned() }).collect()
}

fn zero() -> Guide {
    Guide::Horizontal { at: 0.0, label: String::new() }
}

pub(super) fn pictures(cases: &[Case], coefficients: &PlmCoefficients) -> Vec<Picture> {
    let mut pictures = loading(cases, coefficients);
    pictures.push(residual(cases));
    for index in 0..EXPONENTS.len() {
        pictures.push(force(cases, coefficients, index));
    }
    pictures.push(restitution_deviation(cases, coefficients));
    pictures.extend(cases.iter().map(|case| restitution_itself(case, coefficients)));
    pictures
}

fn loading(cases: &[Case], coefficients: &PlmCoefficients) -> Vec<Picture> {
    let one = |quantity: &super::super::loading::Quantity| {
        let series = cases.iter().map(|case| {
            let law = case.law(coefficients, UnloadingExponent::Paper);
            let points = along(case, &law, quantity);
            let points = points.iter().map(|(x, [expected, got])| (*x, 100.0 * deviation(*expected, *got)));
            Series::marked_line(case.name, points.collect())
        });
        let y = Axis::linear(&format!("{}: law over finite elements − 1", capital(quantity.name)), "%");
        Picture::new(
            format!("error-{}", quantity.name.replace(' ', "-")),
            format!("Loading: deviation of the {}", quantity.name),
            [depth("Indentation over that at yield"), y],
            series.collect(),
        )
        .with_guides(vec![zero()])
    };
    QUANTITIES.iter().map(one).collect()
}

/// The deviation of the residual indentation, as in Fig. 6.
fn residual(cases: &[Case]) -> Picture {
    let series = cases.iter().map(|case| {
        let cycles = case
            .cycles
            .iter()
            .map(|cycle| (cycle.peak.indentation, 100.0 * deviation(cycle.residual, cycle.peak.residual())));
        Series::points(case.name, cycles.collect())
    });
    let mut guides = horizontal(&[3.0, -3.0], "3 %: the paper, from 3 × yield on");
    guides.extend(horizontal(&[2.0, -2.0], "2 %: the paper, from 6 × yield on"));
    guides.push(zero());
    Picture::new(
        "error-residual-indentation".to_owned(),
        "Dent depth from the peak of the finite elements (Eq. 23)".to_owned(),
        [depth(PEAK), Axis::linear("Deviation of δᵣ", "%").between(-3.6, 3.6)],
        series.collect(),
    )
    .with_guides(guides)
}

fn force(cases: &[Case], coefficients: &PlmCoefficients, index: usize) -> Picture {
    let (exponent, name) = EXPONENTS[index];
    let series = cases.iter().map(|case| {
        let cycles = case.cycles.iter().filter_map(|cycle| {
            let (_, numbers) = farthest(cycle, &branch(case, cycle, coefficients, exponent))?;
            Some((cycle.peak.indentation, 100.0 * (numbers[1] - numbers[0])))
        });
        Series::points(case.name, cycles.collect())
    });
    Picture::new(
        format!("error-unloading-force-{}", ["paper", "pressure-shape"][index.min(1)]),
        format!("Unloading force: largest deviation between peak and dent, {name}"),
        [depth(PEAK), Axis::linear("(Law − finite elements) over peak force", "%").between(-6.0, 6.0)],
        series.collect(),
    )
    .with_guides(vec![zero()])
}

fn restitution_deviation(cases: &[Case], coefficients: &PlmCoefficients) -> Picture {
    let series = EXPONENTS.into_iter().map(|(exponent, name)| {
        let of_case = |case: &Case| -> Vec<(f64, f64)> {
            let law = case.law(coefficients, exponent);
            let cycles = case.cycles.iter().filter_map(|cycle| {
                let x = cycle.peak.indentation;
                Some((x, 100.0 * deviation(cycle.restitution?, restitution(&law, x))))
            });
            cycles.collect()
        };
        Series::points(format!("law, {name}"), cases.iter().flat_map(of_case).collect())
    });
    Picture::new(
        "error-restitution".to_owned(),
        "Restitution of load cycles, five pairs of materials".to_owned(),
        [depth(PEAK), Axis::linear("Law over finite elements − 1", "%").between(-7.0, 4.0)],
        series.enumerate().map(|(i, series)| series.styled(i + 1)).collect(),
    )
    .with_guides(vec![zero()])
}

fn restitution_itself(case: &Case, coefficients: &PlmCoefficients) -> Picture {
    let deepest = case.cycles.last().map_or(10.0, |cycle| cycle.peak.indentation);
    let cycles = case.cycles.iter().filter_map(|cycle| Some((cycle.peak.indentation, cycle.restitution?)));
    let mut series = vec![Series::points("finite elements", cycles.collect())];
    for (i, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
        let law = case.law(coefficients, exponent);
        let curve = log_sampled(1.0, 1.1 * deepest, 300, |x| (x, restitution(&law, x)));
        series.push(Series::bare(format!("law, {name}"), curve).styled(i + 1));
    }
    Picture::new(
        format!("restitution-{}", slug(case.name)),
        format!("Restitution against depth: {}", case.name),
        [depth(PEAK), Axis::linear("Restitution e", "").between(0.15, 1.02)],
        series,
    )
}
