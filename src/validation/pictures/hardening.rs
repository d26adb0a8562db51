//! Picture of restitution against depth on half-spaces that harden, by the law with the flow curve and with the initial
//! yield strength.

use super::super::hardening::{at_energy, law};
use super::{Picture, log_sampled};
use crate::error::Error;
use crate::law::PlmCoefficients;
use crate::plot::{Axis, Chart, Series, Style};
use crate::reference::hardening::unloadings;

/// The materials that are drawn, and their names in the picture.
const DRAWN: [(&str, &str); 3] =
    [("c3n10", "steel, N = 0.1"), ("alvoce", "aluminium, Voce"), ("cun30", "copper, N = 0.3")];

pub(super) fn picture(coefficients: &PlmCoefficients) -> Result<Picture, Error> {
    let rows = unloadings()?;
    let mut series = Vec::new();
    for (i, (name, called)) in DRAWN.into_iter().enumerate() {
        let of_material: Vec<_> = rows.iter().filter(|(_, row)| row.material == name).collect();
        let Some((materials, _)) = of_material.first() else { continue };
        let points: Vec<(f64, f64)> = of_material.iter().map(|(_, row)| (row.x, row.restitution)).collect();
        let deepest = points.iter().map(|point| point.0).fold(1.0, f64::max);
        series.push(Series::points(called, points).styled(i));
        for (which, hardens) in [true, false].into_iter().enumerate() {
            let Some((law, ratio)) = law(materials, coefficients, hardens)? else { continue };
            let curve =
                log_sampled(1.0, 1.2 * deepest, 300, |x| (x, at_energy(&law, ratio, law.loading.work(x)).restitution));
            series.push(Series::bare("", curve).styled(Style::of(i).branch(which)));
        }
    }
    let axes = [
        Axis::log("Peak indentation over that at first yield", ""),
        Axis::linear("Restitution e, pressure-shape", "").between(0.1, 1.02),
    ];
    let chart = Chart::new("Restitution on metals that harden", axes, series);
    let chart =
        chart.with_branches(&["law, flow curve", "law, initial strength"]).with_notes(["points: finite elements"]);
    Ok(("hardening-restitution".to_owned(), chart))
}
