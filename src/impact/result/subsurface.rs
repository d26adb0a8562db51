//! Plastic zone and residual stress below the centre of one dent in a half-space: formulas fitted to this project's finite elements.
//!
//! ```text
//! z_0/a   = 2.0 S^0.55 (Y/0.003)^−0.12 (a/(0.4 R))^−0.16            depth of the layer under compression
//! z_p/a   = 1.15 z_0/a                                              depth of the plastic zone
//! σ/σ_rep = −1.32 + 0.45 ln S + 0.14 ln(Y/0.003) − 0.36 (a/R − 0.4)  largest compression, radial, on the axis
//! ```
//!
//! a is the contact radius at the peak, σ_rep the representative flow stress of the law, S = σ_rep/σ_Y, and Y = σ_Y/E*. The finite
//! elements (no friction, isotropic hardening) are 34 states with a/R 0.16 to 0.58, S 1 to 3.3 and Y 0.002 to 0.007:
//! `reference/fe_residual.csv`.

use crate::numerics::functions::{ln, pow};

/// Root mean square of the relative error of the depth of the compressive layer.
pub const LAYER_DEPTH_SCATTER: f64 = 0.06;
/// Root mean square of the relative error of the depth of the plastic zone.
pub const ZONE_DEPTH_SCATTER: f64 = 0.06;
/// Root mean square of the error of the largest compression, over σ_rep.
pub const COMPRESSION_SCATTER: f64 = 0.065;
const ZONE_OVER_LAYER: f64 = 1.15;

/// The state below a dent at maximum compression. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Subsurface {
    /// a \[m\].
    pub contact_radius: f64,
    /// a/R.
    pub radius_ratio: f64,
    /// σ_Y \[Pa\].
    pub yield_strength: f64,
    /// S = σ_rep/σ_Y.
    pub strength_ratio: f64,
    /// E* \[Pa\].
    pub effective_modulus: f64,
}

impl Subsurface {
    /// Depth of the layer under radial compression \[m\].
    pub fn layer_depth(&self) -> f64 {
        let depth = 2.0 * pow(self.strength_ratio, 0.55) * pow(self.elastic_ratio(), -0.12);
        depth * pow(self.radius_ratio / 0.4, -0.16) * self.contact_radius
    }

    /// Depth of the plastic zone \[m\].
    pub fn zone_depth(&self) -> f64 {
        ZONE_OVER_LAYER * self.layer_depth()
    }

    /// The largest radial compression on the axis \[Pa\]; positive.
    pub fn largest_compression(&self) -> f64 {
        let share =
            1.32 - 0.45 * ln(self.strength_ratio) - 0.14 * ln(self.elastic_ratio()) + 0.36 * (self.radius_ratio - 0.4);
        share * self.representative_strength()
    }

    /// σ_rep \[Pa\].
    pub fn representative_strength(&self) -> f64 {
        self.strength_ratio * self.yield_strength
    }

    /// Y over its reference 0.003.
    fn elastic_ratio(&self) -> f64 {
        self.yield_strength / self.effective_modulus / 0.003
    }
}
