//! Rebound hardness of steels against their tensile strength: what is measured, and the law with two strengths that are often
//! taken for the one that it wants.

use std::sync::Arc;

use super::super::ValidationError;
use super::super::measured::restitution;
use super::Picture;
use crate::law::PlmCoefficients;
use crate::plot::{Axis, Series};
use crate::reference::measured::{devices, steels};

/// 0.2 % yield strength of a structural steel over its tensile strength.
const YIELD_RATIO: f64 = 0.65;

pub(super) fn picture(coefficients: &PlmCoefficients) -> Result<Picture, ValidationError> {
    let coefficients = Arc::new(coefficients.clone());
    let mut series = Vec::new();
    for steel in steels()? {
        series.push(Series::marked_line(format!("measured: {}", steel.steel), steel.ends().to_vec()));
    }
    let measured = series.len();
    let all_devices = devices()?;
    if let Some(device) = all_devices.first() {
        let lines = [
            (1.0, "law, tensile strength as yield strength"),
            (YIELD_RATIO, "law, 0.2 % yield strength, 0.65 × tensile"),
        ];
        for (i, (share, name)) in lines.into_iter().enumerate() {
            let mut points = Vec::new();
            for step in 0..=60 {
                let tensile = 350.0 + 2350.0 * f64::from(step) / 60.0;
                points.push((tensile, 1000.0 * restitution(device, 1e6 * share * tensile, &coefficients)?));
            }
            series.push(Series::bare(name, points).styled(measured + i));
        }
    }
    Ok(Picture::new(
        "measured-leeb-tensile-strength".to_owned(),
        "Rebound hardness of steels (Leeb, device D)".to_owned(),
        [Axis::linear("Tensile strength", "MPa"), Axis::linear("HLD = 1000 × restitution", "").between(150.0, 900.0)],
        series,
    ))
}
