//! The true contact radius of the PLM from the Hertz-equivalent one, â = 3F/(4 E* δ_e).
//!
//! ```text
//! a = â/(Λ G)
//! Λ: the shape of the contact pressure, straight in A = â/a_Y; 1 is Hertz, 3π/8 is uniform pressure
//! G = 1 + (g + g_κ κ²) max(0, â/R − g_0 − max(0, a_Y/R − g_0)/A): a deep contact is narrower than that of a half-space
//! ```
//!
//! An elastic contact has the radius of Hertz at every depth. G was fitted to finite elements of bodies that yield at a_Y/R < g_0:
//! there the last term is 0. A harder body is elastic beyond g_0, and the last term makes G = 1 up to first yield (A = 1). The
//! term decays with 1/A, so that a contact far beyond first yield has the fitted G.
//!
//! Force, elastic approach and restitution do not depend on G. Dent radius and mean pressure do.

use serde::{Deserialize, Serialize};

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadiusTable {
    /// A of the knots of Λ.
    pub from: Vec<f64>,
    /// Λ there.
    pub ratio: Vec<f64>,
    /// g_0: â/R from which the depth of the contact matters.
    #[serde(default)]
    pub geometry_from: f64,
    /// g; a table without it has G = 1.
    #[serde(default)]
    pub geometry_slope: f64,
    /// g_κ.
    #[serde(default)]
    pub geometry_slope_kappa_squared: f64,
}

impl RadiusTable {
    /// This fit in units of a_Y, for a sphere of this κ² on a half-space that yields at this a_Y/R.
    #[must_use]
    pub fn for_contact(&self, kappa_squared: f64, yield_radius_ratio: f64) -> Self {
        let slope = self.geometry_slope + self.geometry_slope_kappa_squared * kappa_squared;
        Self {
            geometry_from: self.geometry_from / yield_radius_ratio,
            geometry_slope: slope * yield_radius_ratio,
            geometry_slope_kappa_squared: 0.0,
            ..self.clone()
        }
    }

    /// Λ at A: a polyline, constant outside its knots.
    pub fn pressure_shape_at(&self, equivalent_radius: f64) -> f64 {
        let above = self.from.partition_point(|knot| *knot <= equivalent_radius);
        match (above.checked_sub(1), self.from.get(above)) {
            (None, _) => self.ratio.first().copied().unwrap_or(1.0),
            (Some(last), None) => self.ratio[last],
            (Some(below), Some(next)) => {
                let share = (equivalent_radius - self.from[below]) / (next - self.from[below]);
                self.ratio[below] + share * (self.ratio[above] - self.ratio[below])
            }
        }
    }

    /// a/a_Y = A/(Λ G) at A, of a table in units of a_Y.
    pub fn true_radius(&self, equivalent_radius: f64) -> f64 {
        equivalent_radius / (self.pressure_shape_at(equivalent_radius) * self.geometry_factor_at(equivalent_radius))
    }

    /// G at A, of a table in units of a_Y.
    pub fn geometry_factor_at(&self, equivalent_radius: f64) -> f64 {
        let beyond = equivalent_radius - self.geometry_from;
        // a body that yields beyond g_0 has Hertz's radius up to first yield
        let elastic = 1.0 - self.geometry_from;
        let beyond = if elastic > 0.0 { beyond - elastic / equivalent_radius } else { beyond };
        1.0 + self.geometry_slope * beyond.max(0.0)
    }
}
