//! Pictures against depth: deviations of force and contact radius during loading, of the dent and of the restitution; and
//! the restitution itself.

use super::super::EXPONENTS;
use super::super::cases::{Case, Cycle};
use super::super::check::deviation;
use super::super::quasi_static::{QUANTITIES, Quantity, along, restitution};
use super::{Picture, log_sampled, slug};
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::plot::{Axis, Chart, Guide, Series};
use crate::units::capital;

/// A picture over depth, with a line at zero.
fn picture(name: &str, title: impl Into<String>, y: Axis, series: Vec<Series>) -> Picture {
    let x = Axis::log("Peak indentation over that at yield", "");
    let zero = Guide::horizontal(0.0, "");
    (name.to_owned(), Chart::new(title, [x, y], series).with_guides(vec![zero]))
}

/// A series of points for every case.
fn by_case(cases: &[Case], points: impl Fn(&Case, &Cycle) -> Option<(f64, f64)>) -> Vec<Series> {
    let of_case = |case: &Case| case.cycles.iter().filter_map(|cycle| points(case, cycle)).collect();
    cases.iter().map(|case| Series::points(case.name, of_case(case))).collect()
}

pub(super) fn pictures(cases: &[Case], coefficients: &PlmCoefficients) -> Vec<Picture> {
    let drawn = QUANTITIES.iter().filter(|quantity| ["force", "contact radius"].contains(&quantity.name));
    let mut pictures: Vec<Picture> = drawn.map(|quantity| loading(cases, coefficients, quantity)).collect();
    pictures.push(residual(cases));
    pictures.push(restitution_deviation(cases, coefficients));
    pictures
        .extend(cases.iter().filter(|case| case.name == "case 3").map(|case| restitution_itself(case, coefficients)));
    pictures
}

fn loading(cases: &[Case], coefficients: &PlmCoefficients, quantity: &Quantity) -> Picture {
    let series = cases.iter().map(|case| {
        let law = case.law(coefficients, UnloadingExponent::Paper);
        let points = along(case, &law, quantity);
        let points = points.iter().map(|(x, [expected, got])| (*x, 100.0 * deviation(*expected, *got)));
        Series::marked_line(case.name, points.collect())
    });
    let y = Axis::linear(&format!("{}: law over finite elements − 1", capital(quantity.name)), "%");
    let name = format!("error-{}", quantity.name.replace(' ', "-"));
    let title = format!("Loading: deviation of the {}", quantity.name);
    let (name, mut chart) = picture(&name, title, y, series.collect());
    chart.x = Axis::log("Indentation over that at yield", "");
    (name, chart)
}

/// The deviation of the residual indentation, as in Fig. 6.
fn residual(cases: &[Case]) -> Picture {
    let series =
        by_case(cases, |_, cycle| Some((cycle.row.x, 100.0 * deviation(cycle.residual(), cycle.peak.residual()))));
    let of_paper = [(3.0, "3 %: the paper, from 3 × yield on"), (2.0, "2 %: the paper, from 6 × yield on")];
    let title = "Dent depth from the peak of the finite elements (Eq. 23)";
    let y = Axis::linear("Deviation of δᵣ", "%").between(-3.6, 3.6);
    let (name, mut lines) = picture("error-residual-indentation", title, y, series);
    let limits = of_paper.into_iter().flat_map(|(limit, label)| [limit, -limit].map(|at| Guide::horizontal(at, label)));
    lines.panels[0].guides.splice(..0, limits);
    (name, lines)
}

fn restitution_deviation(cases: &[Case], coefficients: &PlmCoefficients) -> Picture {
    let mut series = Vec::new();
    for (i, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
        let of_case = |case: &Case| {
            let law = case.law(coefficients, exponent);
            let off = |cycle: &Cycle| {
                Some((cycle.row.x, 100.0 * deviation(cycle.row.restitution?, restitution(&law, cycle.row.x))))
            };
            case.cycles.iter().filter_map(off).collect::<Vec<_>>()
        };
        let points = cases.iter().flat_map(of_case).collect();
        series.push(Series::points(format!("law, {name}"), points).styled(i + 1));
    }
    let y = Axis::linear("Law over finite elements − 1", "%").between(-7.0, 4.0);
    picture("error-restitution", "Restitution of load cycles, five pairs of materials", y, series)
}

fn restitution_itself(case: &Case, coefficients: &PlmCoefficients) -> Picture {
    let deepest = case.cycles.last().map_or(10.0, |cycle| cycle.row.x);
    let cycles = case.cycles.iter().filter_map(|cycle| Some((cycle.row.x, cycle.row.restitution?)));
    let mut series = vec![Series::points("finite elements", cycles.collect())];
    for (i, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
        let law = case.law(coefficients, exponent);
        let curve = log_sampled(1.0, 1.1 * deepest, 300, |x| (x, restitution(&law, x)));
        series.push(Series::bare(format!("law, {name}"), curve).styled(i + 1));
    }
    let y = Axis::linear("Restitution e", "").between(0.15, 1.02);
    let title = format!("Restitution against depth: {}", case.name);
    picture(&format!("restitution-{}", slug(case.name)), title, y, series)
}
