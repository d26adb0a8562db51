//! How the PLM unloads: elastic approach, exponent and contact radius at a point of its loading curve.

use serde::{Deserialize, Serialize};

use super::approach::ApproachPolyline;
use super::contact_radius::RadiusTable;
use super::depth::Depth;
use super::flattening::Flattening;
use super::hardening::Hardening;
use crate::contact::law::published::{LoadedState, Recovery};
use crate::contact::law::unloading::{ContactState, LoadedPoint, UnloadingShape};
use crate::numerics::curve::LoadingCurve;

/// How the PLM unloads beyond first yield.
#[derive(Debug, Clone, PartialEq)]
pub struct PlmUnloadingRule {
    /// The elastic approach over the force.
    pub approach: ApproachPolyline,
    /// How a body that hardens changes it.
    pub hardening: Option<Hardening>,
    /// How a sphere that flows changes it.
    pub flattening: Option<Flattening>,
    /// How a deep dent changes it.
    pub depth: Option<Depth>,
    /// The contact radius, in units of a_Y.
    pub radius: RadiusTable,
    /// Largest a/R of the data behind the law.
    pub max_radius_ratio: f64,
    pub exponent: UnloadingExponent,
}

/// The largest a/R of the data behind the coefficients, for each kind of contact. The program warns beyond it. The defaults are the
/// limits of the law without [`DepthTable`](super::depth::DepthTable).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ValidityTable {
    /// The half-space yields, and does not harden.
    pub perfectly_plastic: f64,
    /// The half-space yields and hardens.
    pub hardening: f64,
    /// The sphere yields, or a half-space that is curved.
    pub yielding_sphere: f64,
    /// Both bodies yield.
    pub both_yield: f64,
}

impl Default for ValidityTable {
    fn default() -> Self {
        Self { perfectly_plastic: 0.45, hardening: 0.32, yielding_sphere: 0.3, both_yield: 0.2 }
    }
}

/// Which exponent n the unloading branch has.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum UnloadingExponent {
    /// n = 3/2, the paper's law.
    #[default]
    Paper,
    /// Any number in (1, 2], for comparison. Only the other two have a physical reason.
    Fixed(f64),
    /// n(Λ) from the contact pressure's shape at the peak: 3/2 for Hertz's ellipse, 3π/4 − 1 for uniform pressure.
    PressureShape,
}

impl UnloadingExponent {
    /// Takes the number 1.5 for the paper's law.
    pub fn from_value(value: f64) -> Self {
        if value == 1.5 { Self::Paper } else { Self::Fixed(value) }
    }
}

/// n(Λ) = 3/2 − [2 (10 − 3π)/(3π − 8)] (Λ − 1): the straight line between Hertz pressure (Λ = 1, n = 3/2) and uniform
/// pressure (Λ = 3π/8, n = 3π/4 − 1), both exact.
pub fn pressure_shape_exponent(radius_ratio: f64) -> f64 {
    const THREE_PI: f64 = 3.0 * std::f64::consts::PI;
    1.5 - 2.0 * (10.0 - THREE_PI) / (THREE_PI - 8.0) * (radius_ratio - 1.0)
}

impl PlmUnloadingRule {
    /// The state at a point (x, f) of the loading curve.
    #[inline(always)]
    pub(crate) fn state(&self, x: f64, force: f64) -> ContactState {
        ContactState { indentation: x, force, elastic_approach: self.elastic_approach(x, force) }
    }

    /// ε at a point (x, f) of the loading curve.
    #[inline(always)]
    pub(crate) fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        match self.depth_at(x) {
            None => self.shallow_approach(x, force),
            Some(depth) => self.deep_approach_and_radius(depth, x, depth.base().force(x))[0],
        }
    }

    /// ε at a point (x, f) of the loading curve of another law, which has no correction for deep dents.
    fn approach_of_other_loading(&self, x: f64, force: f64) -> f64 {
        match self.depth_at(x) {
            None => self.shallow_approach(x, force),
            Some(depth) => self.deep_approach_and_radius(depth, x, force)[0],
        }
    }

    /// ε and A at x of a deep dent with the force F_b.
    #[inline(never)]
    fn deep_approach_and_radius(&self, depth: &Depth, x: f64, force: f64) -> [f64; 2] {
        let approach = self.shallow_approach(x, force);
        let is_own = self.flattening.is_none() && x <= depth.constant_from();
        let radii =
            if is_own { self.in_strength(x, force / approach) } else { self.hertz_equivalent_radii_at(depth, x) };
        let y =
            depth.depth_at(
                x,
                |deepest| {
                    if deepest == x { radii[1] } else { self.hertz_equivalent_radii_at(depth, deepest)[1] }
                },
            );
        [(approach * depth.recovery_factor(y)).min(x), radii[0]]
    }

    /// The correction for deep dents, if it changes force and elastic approach at x.
    #[inline(always)]
    pub(super) fn depth_at(&self, x: f64) -> Option<&Depth> {
        self.depth.as_ref().filter(|depth| depth.applies_at(x))
    }

    /// The force at x of a deep dent, without the rest of the loading curve; `None` from where y is constant.
    pub(super) fn deep_force(&self, depth: &Depth, x: f64) -> Option<f64> {
        depth.force_at(x, |x| self.hertz_equivalent_radii_at(depth, x)[1])
    }

    /// The loading curve of a contact with a correction for deep dents.
    pub(super) fn deep_curve(&self) -> Option<&LoadingCurve> {
        self.depth.as_ref().map(|depth| depth.curve(|x| self.hertz_equivalent_radii_at(depth, x)[1]))
    }

    /// ε at a point (x, f) of the loading curve of shallow dents.
    #[inline(always)]
    pub(in crate::contact::law) fn shallow_approach(&self, x: f64, force: f64) -> f64 {
        match (&self.flattening, &self.hardening) {
            _ if x <= 1.0 => x,
            (None, _) => self.approach_without_flat(x, force),
            (Some(flattening), None) => (self.approach.approach(force) * flattening.recovery_factor(x, 1.0)).min(x),
            (Some(flattening), Some(hardening)) => {
                let share = flattening.recovery_factor(x, hardening.representative_strength(x));
                hardening.elastic_approach(x, force, share)
            }
        }
    }

    /// ε without the flat of a sphere, for x > 1.
    #[inline(always)]
    pub(super) fn approach_without_flat(&self, x: f64, force: f64) -> f64 {
        match &self.hardening {
            None => self.approach.approach(force).min(x),
            Some(hardening) => hardening.elastic_approach(x, force, 1.0),
        }
    }

    /// A = f/ε at a peak, without the flat of a sphere and the correction for deep dents.
    #[inline(always)]
    fn hertz_equivalent_radius(&self, peak: &ContactState) -> f64 {
        match (&self.flattening, self.depth_at(peak.indentation)) {
            (Some(flattening), _) if peak.indentation > 1.0 => {
                let force = flattening.unflattened_curve.force(peak.indentation);
                force / self.approach_without_flat(peak.indentation, force)
            }
            (_, Some(depth)) => self.hertz_equivalent_radii_at(depth, peak.indentation)[0],
            _ => peak.force / peak.elastic_approach,
        }
    }

    /// A at x, and A in units of the strength that the yielding body has reached, without the flat of a sphere and this correction
    /// for deep dents.
    fn hertz_equivalent_radii_at(&self, depth: &Depth, x: f64) -> [f64; 2] {
        let curve = self.flattening.as_ref().map_or(depth.base(), |flattening| &flattening.unflattened_curve);
        let force = curve.force(x);
        self.in_strength(x, if x <= 1.0 { force / x } else { force / self.approach_without_flat(x, force) })
    }

    /// A, and A in units of the strength that the yielding body has reached at x.
    fn in_strength(&self, x: f64, equivalent: f64) -> [f64; 2] {
        match &self.hardening {
            None => [equivalent; 2],
            Some(hardening) => [equivalent, hardening.pressure_shape(x, equivalent).equivalent],
        }
    }

    /// At points (x, f) beyond first yield of a law without a flat: A, and A in units of the strength that the yielding body has
    /// reached at this point.
    pub(super) fn hertz_equivalent_radii(&self) -> impl FnMut(f64, f64) -> [f64; 2] + '_ {
        let mut on_line = self.approach.sequential_lookup();
        move |x, force| match &self.hardening {
            None => [force / on_line(force).min(x); 2],
            Some(hardening) => {
                let equivalent = force / hardening.elastic_approach(x, force, 1.0);
                [equivalent, hardening.pressure_shape(x, equivalent).equivalent]
            }
        }
    }

    /// The state at a point of the loading curve, and the exponent that is requested there.
    #[inline(always)]
    pub(crate) fn peak_and_exponent(&self, at: &LoadedPoint) -> (ContactState, f64) {
        let &LoadedPoint { indentation, force, .. } = at;
        let peak = |elastic_approach| ContactState { indentation, force, elastic_approach };
        match (at.elastic_approach, self.depth_at(indentation)) {
            (None, Some(depth)) => {
                let base = depth.base().force(indentation);
                let [approach, equivalent] = self.deep_approach_and_radius(depth, indentation, base);
                let peak = peak(approach);
                (peak, self.exponent_at(&peak, || equivalent))
            }
            (known, _) => {
                let peak = peak(known.unwrap_or_else(|| self.shallow_approach(indentation, force)));
                (peak, self.exponent_at(&peak, || self.hertz_equivalent_radius(&peak)))
            }
        }
    }

    /// The elastic approach and the exponent at a peak on the loading curve of another law. Its force need not be that of this
    /// rule, so A is this force over the elastic approach that belongs to it.
    pub(super) fn recovery(&self, at: &LoadedState) -> Recovery {
        let of_plm = ContactState {
            indentation: at.indentation,
            force: at.force,
            elastic_approach: self.approach_of_other_loading(at.indentation, at.force),
        };
        let elastic_approach = at.elastic_approach.unwrap_or(of_plm.elastic_approach);
        let equivalent = || match at.elastic_approach {
            None if at.indentation > 1.0 => at.force / self.approach_without_flat(at.indentation, at.force),
            _ => at.force / elastic_approach,
        };
        let exponent = self.exponent_at(&ContactState { elastic_approach, ..of_plm }, equivalent);
        Recovery { elastic_approach, shape: UnloadingShape::Power(exponent) }
    }

    /// The requested exponent at a peak with this A. The exponent by the shape of the contact pressure is at least 1: with a smaller
    /// exponent the stiffness would be infinite at separation.
    #[inline(always)]
    fn exponent_at(&self, peak: &ContactState, equivalent: impl FnOnce() -> f64) -> f64 {
        match self.exponent {
            UnloadingExponent::Fixed(n) if peak.residual() > 0.0 => n,
            UnloadingExponent::PressureShape if peak.indentation > 1.0 => {
                let equivalent = equivalent();
                let exponent = match &self.hardening {
                    None => pressure_shape_exponent(self.radius.pressure_shape_at(equivalent)),
                    Some(hardening) => {
                        let shape = hardening.pressure_shape(peak.indentation, equivalent);
                        pressure_shape_exponent(self.radius.pressure_shape_at(shape.equivalent)) - shape.exponent_loss()
                    }
                };
                exponent.max(1.0)
            }
            _ => 1.5,
        }
    }

    /// a/a_Y at a peak, a = â/(Λ G) with the Hertz-equivalent A = f/ε.
    pub(crate) fn contact_radius(&self, peak: &ContactState) -> f64 {
        self.contact_radius_at(peak.indentation, self.hertz_equivalent_radius(peak))
    }

    /// a/a_Y at x, where A is this.
    pub(in crate::contact::law) fn contact_radius_at(&self, x: f64, equivalent: f64) -> f64 {
        match &self.hardening {
            None => self.radius.true_radius(equivalent),
            Some(hardening) => {
                let shape = hardening.pressure_shape(x, equivalent);
                let geometry = self.radius.geometry_factor_at(equivalent);
                let radius =
                    equivalent / (self.radius.pressure_shape_at(shape.equivalent) * geometry * shape.pile_up_factor());
                self.depth.as_ref().map_or(radius, |depth| {
                    radius / depth.radius_factor(equivalent, || shape.local_hardening_exponent())
                })
            }
        }
    }
}
