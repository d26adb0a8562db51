//! Flow curves: the true stress at which a metal yields, as a function of plastic strain.
//!
//! ε is the plastic strain, σ_Y the yield strength, which is the stress at ε = 0, and E Young's modulus of the metal.

use std::sync::Arc;

use thiserror::Error;

use crate::numerics::functions::{exp, exp_m1, ln, ln_1p};
use crate::numerics::root::newton_convex;
use crate::units::{Dimension, format_number, format_si_and_short};

/// A point of a measured curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowPoint {
    pub strain: f64,
    /// True stress \[Pa\].
    pub stress: f64,
}

/// The shape of a flow curve. The yield strength from which it starts is given separately.
#[derive(Debug, Clone, PartialEq)]
pub enum FlowCurve {
    /// σ_Y (1 + E ε/σ_Y)^N.
    Power {
        /// N, from 0 to 0.5.
        exponent: f64,
    },
    /// σ_Y (1 + b (1 − exp(−c ε))).
    Voce {
        /// b ≥ 0: the total rise of the stress, in units of the yield strength.
        saturation: f64,
        /// c > 0: how fast the stress rises with strain.
        rate: f64,
    },
    /// σ_Y + H ε.
    Linear {
        /// H ≥ 0 \[Pa\]: rise of stress per plastic strain.
        slope: f64,
    },
    /// Linear from (0, σ_Y) through measured points in the order of rising strain, constant after the last; see
    /// [`FlowCurve::from_points`].
    Points(Arc<[FlowPoint]>),
}

/// Why points are refused as a flow curve.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum FlowError {
    /// There are fewer than two points.
    #[error(
        "has {0} points, and a curve requires at least 2. For a straight line write linear = {{ slope = \"4 GPa\" }}"
    )]
    TooFew(usize),
    /// The strain of a point is negative, not finite, or not above the strain of the point before.
    #[error(
        "point {place}: plastic strain {} is not allowed. Plastic strains must be finite, at least 0 and increasing.",
        format_number(*.strain)
    )]
    Strain {
        /// Place of the point, counted from 1.
        place: usize,
        strain: f64,
    },
    /// The stress falls from one point to the next, or is not a positive finite number.
    #[error(
        "point {place}: the stress falls from {} to {}, and the law does not model softening. End the curve at its largest stress.",
        format_si_and_short(*.before, Dimension::Pressure),
        format_si_and_short(*.stress, Dimension::Pressure)
    )]
    Falls {
        /// Place of the point, counted from 1.
        place: usize,
        /// Stress of the point before \[Pa\].
        before: f64,
        /// Stress of the point \[Pa\].
        stress: f64,
    },
    /// The curve does not start from the yield strength.
    #[error(
        "the first point ({} at plastic strain {}) is {} the yield strength ({}), which is the stress at plastic strain 0. Correct one of the two.",
        format_si_and_short(*.stress, Dimension::Pressure),
        format_number(*.strain),
        if stress < yield_strength { "below" } else { "above" },
        format_si_and_short(*.yield_strength, Dimension::Pressure)
    )]
    Start {
        strain: f64,
        /// Stress of the first point \[Pa\].
        stress: f64,
        /// Yield strength \[Pa\].
        yield_strength: f64,
    },
    /// The curve is steeper than the elastic line.
    #[error(
        "{} the flow stress rises by {} per strain, more than Young's modulus ({}). Give {}.",
        if to.is_finite() { format!("between plastic strain {} and {}", format_number(*.from), format_number(*.to)) } else { "at every plastic strain".to_owned() },
        format_si_and_short(*.slope, Dimension::Pressure),
        format_si_and_short(*.modulus, Dimension::Pressure),
        if *.is_measured { "points farther apart, or a larger yield strength" } else { "a smaller rise, or a larger yield strength" }
    )]
    Steep {
        /// Where the steepest part begins.
        from: f64,
        to: f64,
        /// Its slope \[Pa\].
        slope: f64,
        /// Young's modulus \[Pa\].
        modulus: f64,
        /// True if the curve is of points.
        is_measured: bool,
    },
}

impl FlowCurve {
    /// A curve through measured points.
    ///
    /// # Errors
    /// [`FlowError`] for fewer than two points, strains that are negative or do not rise, and stresses that fall.
    pub fn from_points(points: impl Into<Arc<[FlowPoint]>>) -> Result<Self, FlowError> {
        let points = points.into();
        if points.len() < 2 {
            return Err(FlowError::TooFew(points.len()));
        }
        let mut before = FlowPoint { strain: -f64::MIN_POSITIVE, stress: 0.0 };
        for (place, point) in (1..).zip(points.iter()) {
            if !(point.strain > before.strain && point.strain >= 0.0 && point.strain.is_finite()) {
                return Err(FlowError::Strain { place, strain: point.strain });
            }
            // a stress that is not positive and finite is refused with the same error
            if !(point.stress >= before.stress && point.stress > 0.0 && point.stress.is_finite()) {
                return Err(FlowError::Falls { place, before: before.stress, stress: point.stress });
            }
            before = *point;
        }
        Ok(Self::Points(points))
    }

    /// True if the curve starts from this yield strength \[Pa\].
    ///
    /// # Errors
    /// [`FlowError::Start`] if the first point is below the yield strength, or is at strain 0 with another stress.
    pub fn check_start(&self, yield_strength: f64) -> Result<(), FlowError> {
        if let Self::Points(points) = self
            && let Some(&FlowPoint { strain, stress }) = points.first()
            && (strain == 0.0 || stress < yield_strength)
            && (stress / yield_strength - 1.0).abs() > STRESS_TOLERANCE
        {
            return Err(FlowError::Start { strain, stress, yield_strength });
        }
        Ok(())
    }

    /// True if the curve of this yield strength \[Pa\] is nowhere steeper than the elastic line, whose slope is Young's modulus
    /// \[Pa\]. The power form never is.
    ///
    /// # Errors
    /// [`FlowError::Steep`] with the steepest place.
    pub fn check_slope(&self, modulus: f64, yield_strength: f64) -> Result<(), FlowError> {
        let (from, to, slope) = match self {
            Self::Power { .. } => return Ok(()),
            // up to there the stress has risen by all but 1/e of its whole rise
            Self::Voce { saturation, rate } => (0.0, 1.0 / rate, yield_strength * saturation * rate),
            Self::Linear { slope } => (0.0, f64::INFINITY, *slope),
            Self::Points(points) => {
                let start = FlowPoint { strain: 0.0, stress: yield_strength };
                let before = std::iter::once(start).chain(points.iter().copied());
                // a first point at strain 0 is the yield strength itself
                let parts = before.zip(points.iter()).filter(|(low, high)| high.strain > low.strain);
                let slopes = parts.map(|(low, high)| {
                    (low.strain, high.strain, (high.stress - low.stress) / (high.strain - low.strain))
                });
                slopes.max_by(|a, b| a.2.total_cmp(&b.2)).unwrap_or((0.0, 0.0, 0.0))
            }
        };
        let is_measured = matches!(self, Self::Points(_));
        if slope <= modulus { Ok(()) } else { Err(FlowError::Steep { from, to, slope, modulus, is_measured }) }
    }

    /// The strain of the last measured point; `None` for a formula.
    pub fn last_strain(&self) -> Option<f64> {
        let Self::Points(points) = self else { return None };
        points.last().map(|point| point.strain)
    }

    /// The flow curve over its yield strength \[Pa\], for a metal of this Young's modulus \[Pa\].
    pub fn normalise(&self, yield_strength: f64, youngs_modulus: f64) -> NormalisedFlowCurve {
        NormalisedFlowCurve { curve: self.clone(), yield_strength, modulus_ratio: youngs_modulus / yield_strength }
    }
}

/// Relative difference up to which the first point counts as the yield strength: one may be written in MPa and the
/// other in Pa.
const STRESS_TOLERANCE: f64 = 1e-9;

/// σ/σ_Y as a function of plastic strain, for one metal. It starts from 1 and never falls.
#[derive(Debug, Clone, PartialEq)]
pub struct NormalisedFlowCurve {
    pub curve: FlowCurve,
    /// σ_Y \[Pa\].
    yield_strength: f64,
    /// E/σ_Y.
    modulus_ratio: f64,
}

impl NormalisedFlowCurve {
    /// σ/σ_Y at a plastic strain ≥ 0.
    pub fn relative_stress(&self, strain: f64) -> f64 {
        match &self.curve {
            FlowCurve::Power { exponent } => exp(exponent * ln_1p(self.modulus_ratio * strain)),
            FlowCurve::Voce { saturation, rate } => 1.0 - saturation * exp_m1(-rate * strain),
            FlowCurve::Linear { slope } => 1.0 + slope / self.yield_strength * strain,
            FlowCurve::Points(points) => {
                let next = points.partition_point(|point| point.strain <= strain);
                let start = FlowPoint { strain: 0.0, stress: self.yield_strength };
                let low = next.checked_sub(1).map_or(start, |below| points[below]);
                let stress = points.get(next).map_or(low.stress, |high| {
                    let share = (strain - low.strain) / (high.strain - low.strain);
                    low.stress + share * (high.stress - low.stress)
                });
                stress / self.yield_strength
            }
        }
    }
}

/// Yield strength \[Pa\] of the power curve with this exponent that has this stress \[Pa\] at this plastic strain.
pub fn yield_strength_of_power(stress: f64, strain: f64, exponent: f64, youngs_modulus: f64) -> f64 {
    let elastic = youngs_modulus * strain;
    // with y = ln σ_Y: y + N ln(1 + E ε/exp(y)) = ln σ. The left side rises and is convex, so Newton's method from σ_Y
    // = σ converges downwards and does not pass the root
    exp(newton_convex(ln(stress), |y| {
        let ratio = elastic * exp(-y);
        (y + exponent * ln_1p(ratio) - ln(stress)) / (1.0 - exponent * ratio / (1.0 + ratio))
    }))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn points(list: &[(f64, f64)]) -> Result<FlowCurve, FlowError> {
        FlowCurve::from_points(list.iter().map(|&(strain, stress)| FlowPoint { strain, stress }).collect::<Vec<_>>())
    }

    #[test]
    fn every_form_is_its_formula() -> Result<(), FlowError> {
        // σ_Y = 200 MPa, E = 100 GPa; the stress in MPa at these strains, by hand
        let forms = [
            (FlowCurve::Power { exponent: 0.5 }, [(0.0, 200.0), (0.03, 800.0)]),
            (FlowCurve::Voce { saturation: 1.5, rate: 10.0 }, [(0.0, 200.0), (0.1, 389.636_167_648_567_3)]),
            (FlowCurve::Linear { slope: 4e9 }, [(0.0, 200.0), (0.05, 400.0)]),
            (points(&[(0.01, 250e6), (0.03, 270e6)])?, [(0.005, 225.0), (0.02, 260.0)]),
            (points(&[(0.0, 200e6), (0.03, 260e6)])?, [(0.01, 220.0), (0.5, 260.0)]),
        ];
        for (curve, wanted) in forms {
            let rise = curve.normalise(200e6, 100e9);
            for (strain, stress) in wanted {
                assert_relative_eq!(200.0 * rise.relative_stress(strain), stress, max_relative = 1e-14);
            }
        }
        Ok(())
    }

    #[test]
    fn nan_makes_no_curve_and_rounding_is_tolerated() -> Result<(), FlowError> {
        for list in
            [[(0.01, 3e8), (f64::NAN, 4e8)], [(0.01, f64::NAN), (0.02, 2e8)], [(0.01, 3e8), (0.02, f64::INFINITY)]]
        {
            assert!(points(&list).is_err(), "{list:?}");
        }
        // nor do stresses that are not positive
        for stress in [0.0, -1.0] {
            let refused = Err(FlowError::Falls { place: 1, before: 0.0, stress });
            assert_eq!(points(&[(0.01, stress), (0.02, 3e8)]), refused);
        }
        let later = points(&[(0.002, 300e6), (0.01, 340e6)])?;
        assert_eq!((later.check_start(280e6), later.check_start(300e6)), (Ok(()), Ok(())));
        let at_once = points(&[(0.0, 300e6), (0.01, 340e6)])?;
        assert_eq!(at_once.check_start(300e6 * (1.0 + 1e-15)), Ok(()));
        Ok(())
    }

    #[test]
    fn power_curve_yield_strength_recovers_its_stress() {
        for exponent in [0.0, 0.02, 0.1, 0.3, 0.5] {
            for stress in [1e5, 1e8, 3e9, 1e12] {
                let strength = yield_strength_of_power(stress, 0.08, exponent, 210e9);
                let back = strength * FlowCurve::Power { exponent }.normalise(strength, 210e9).relative_stress(0.08);
                assert_relative_eq!(back, stress, max_relative = 1e-13);
                assert!(strength <= stress * (1.0 + 1e-14));
            }
        }
    }
}
