//! Pictures of the dent after unloading, with the circle of Eq. 25 (Fig. 7).

use super::super::cases::Case;
use super::super::dents::residual_radius;
use super::{Picture, sampled, slug};
use crate::math::functions::powi;
use crate::plot::{Axis, Chart, Guide, Series};
use crate::units::capital;
use crate::units::rounded::number;

pub(super) fn picture(case: &Case) -> Option<Picture> {
    let cycle = case.cycles.iter().find(|cycle| !cycle.dent.is_empty())?;
    let radius = residual_radius(&cycle.peak);
    // lengths are in units of R, and δ_Y/R = (a_Y/R)²
    let depth = cycle.peak.residual() * powi(case.loading.yield_radius_ratio, 2);
    let points = cycle.dent.iter().map(|[r, z]| (*r, 1e3 * z)).collect();
    let contact_radius = cycle.row.contact_radius;
    let circle = sampled(0.0, contact_radius, 100, |r| (r, 1e3 * (radius - (radius * radius - r * r).sqrt() - depth)));
    let title = format!("{}: dent left by {} × the yield indentation", capital(case.name), number(cycle.row.x));
    let axes = [Axis::linear("Radius r/R", ""), Axis::linear("Height of the surface, 1000 z/R", "")];
    let series = vec![
        Series::points("finite elements", points),
        Series::bare(format!("circle of Eqs. 23-25, Rᵣₑₛ = {} R", number(radius)), circle).styled(1),
    ];
    let lines = Chart::new(title, axes, series)
        .with_guides(vec![
            Guide::vertical(contact_radius, "contact radius at the peak"),
            Guide::horizontal(0.0, "undeformed"),
        ])
        .with_notes([format!("circle fitted to it: {} R", number(cycle.row.residual_radius))]);
    Some((format!("dent-{}", slug(case.name)), lines))
}
