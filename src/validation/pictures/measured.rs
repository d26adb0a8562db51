//! Picture of the rebound hardness of steels against their tensile strength: as measured, and by the law with two
//! strengths that are often used as yield strength.

use std::sync::Arc;

use super::super::measured::restitution;
use super::{Picture, sampled};
use crate::error::Error;
use crate::law::PlmCoefficients;
use crate::plot::axis::extremes;
use crate::plot::{Axis, Chart, Series};
use crate::reference::measured::{Steel, devices, steels};

/// 0.2 % yield strength of a structural steel over its tensile strength.
const YIELD_RATIO: f64 = 0.65;

/// The outline of the band between the lowest and the highest hardness of all steels, whose hardness is linear in the
/// tensile strength.
fn band(steels: &[Steel]) -> Vec<(f64, f64)> {
    let (weakest, strongest) = extremes(steels.iter().flat_map(Steel::ends).map(|(strength, _)| strength));
    let at = |tensile: f64| {
        let hardnesses = steels.iter().filter_map(move |steel| {
            let [(low, low_hardness), (high, high_hardness)] = steel.ends();
            let share = (tensile - low) / (high - low);
            (0.0..=1.0).contains(&share).then_some(low_hardness + share * (high_hardness - low_hardness))
        });
        extremes(hardnesses)
    };
    let lower = sampled(weakest, strongest, 400, |tensile| (tensile, at(tensile).0));
    let upper = sampled(weakest, strongest, 400, |tensile| (tensile, at(tensile).1));
    lower.into_iter().chain(upper.into_iter().rev()).collect()
}

pub(super) fn picture(coefficients: &PlmCoefficients) -> Result<Picture, Error> {
    let coefficients = Arc::new(coefficients.clone());
    let steels = steels()?;
    let ends = steels.iter().flat_map(Steel::ends).collect();
    let mut series = vec![
        Series::points("measured, ten steels", ends).and("ends of their ranges"),
        Series::bare("between them", band(&steels)).and("lowest and highest").styled(0),
    ];
    if let Some(device) = devices()?.first() {
        let lines = [
            (1.0, "law, tensile strength", "as yield strength"),
            (YIELD_RATIO, "law, 0.2 % strength", "0.65 × tensile"),
        ];
        for (i, (share, name, taken)) in lines.into_iter().enumerate() {
            let mut points = Vec::new();
            for step in 0..=60 {
                let tensile = 350.0 + 2350.0 * f64::from(step) / 60.0;
                points.push((tensile, 1000.0 * restitution(device, 1e6 * share * tensile, &coefficients)?));
            }
            series.push(Series::bare(name, points).and(taken).styled(1 + i));
        }
    }
    let axes =
        [Axis::linear("Tensile strength", "MPa"), Axis::linear("HLD = 1000 × restitution", "").between(150.0, 900.0)];
    let lines = Chart::new("Rebound hardness of steels (Leeb, device D)", axes, series);
    Ok(("measured-leeb-tensile-strength".to_owned(), lines))
}
