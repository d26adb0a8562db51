//! Unloading and reloading: the paper's law (Xie et al. 2024, Eqs. 19-25) for any exponent n, and the shapes of published
//! laws that are no power law. Everything is dimensionless, in the scales of the contact.

use std::f64::consts::PI;

use crate::numerics::curve::piece::{Piece, Shape};
use crate::numerics::curve::unloading_curve::{UnloadingCurve, UnloadingCurveKind};
use crate::numerics::power::{power, quarter_period_factor, work_factor};

/// A state of the contact. The state of the largest indentation so far is the whole memory of the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState {
    /// x_m.
    pub indentation: f64,
    /// f_m.
    pub force: f64,
    /// ε_m, the part of x_m that is recovered on unloading: (E_s*/E*) δ_sm in units of L. Finite for a rigid sphere too.
    pub elastic_approach: f64,
}

impl ContactState {
    /// Residual indentation x_r = x_m − ε_m (Eq. 23).
    pub fn residual(&self) -> f64 {
        self.indentation - self.elastic_approach
    }

    /// R_e/R = f_m²/ε_m³: unloading radius over sphere radius (Eq. 24). At least 1, and 1 without a dent.
    pub fn unloading_radius_ratio(&self) -> f64 {
        let per_approach = self.force / self.elastic_approach;
        per_approach * per_approach / self.elastic_approach
    }
}

/// A point of a loading curve from which the contact unloads, and what is known about it already.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedPoint {
    /// x.
    pub indentation: f64,
    /// f.
    pub force: f64,
    /// The work of loading; `None` if it is to be taken from the curve.
    pub work: Option<f64>,
    /// ε, if the contact remembers it.
    pub elastic_approach: Option<f64>,
}

impl From<ContactState> for LoadedPoint {
    /// A state that a contact remembers.
    fn from(state: ContactState) -> Self {
        let ContactState { indentation, force, elastic_approach } = state;
        Self { indentation, force, work: None, elastic_approach: Some(elastic_approach) }
    }
}

/// How the force falls between the peak and the residual indentation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum UnloadingShape {
    /// f = f_m (d/ε_m)^n, with this n.
    Power(f64),
    /// A published curve that is no power law.
    Curve(UnloadingCurveKind),
}

/// Reloading with this relative excess over the energy that the branch can store still ends at the old peak. The excess is about
/// ten rounding errors: a sphere that returns with the speed of its rebound has just this energy, except for rounding.
pub const OLD_PEAK_ROUNDING: f64 = 32.0 * f64::EPSILON;

/// The unloading branch from a peak; d = x − x_r is the distance from the end of unloading.
///
/// ```text
/// f = f_m ((x − x_r)/ε_m)^n,   x_r ≤ x ≤ x_m        (Eq. 19 for n = 3/2)
/// ```
///
/// or another [`UnloadingShape`]. Reloading runs back up the same curve. The branch meets the loading curve at (x_m, f_m) with
/// a kink, and its force is zero at x_r.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unloading {
    pub peak: ContactState,
    /// n. A scenario gives it in (1, 2]; the straight branch of Walton and Braun has 1. Other shapes have the n of the power
    /// law that gives back the same energy, f_m ε_m/(n + 1).
    pub exponent: f64,
    /// The exponent that the law asks for; `exponent` is larger if the branch would recover more than was spent.
    pub(super) requested: f64,
    /// The curve of the branch from x_r on; `None` for a power law.
    pub(super) curve: Option<UnloadingCurve>,
}

/// The exponent of a branch that recovers no more energy than loading spent. This is the exponent `requested`. If a branch
/// with `requested` would recover more than the work of loading to the peak, it is the exponent that recovers just this work.
///
/// ```text
/// n = requested                 where f_m ε_m ≤ w_m (requested + 1)
///     f_m ε_m/w_m − 1       elsewhere
/// ```
///
/// At first yield f_m ε_m/w_m − 1 is 3/2. From there n falls to the requested exponent if that is below 3/2; if it is above, n
/// jumps to it. An impact warns of a larger exponent than requested. It has no answer if the requested one would recover over
/// 5 % more than was spent ([`Law::check`](super::Law::check)). A code that computes the force alone always gets an exponent.
#[inline(always)]
pub(crate) fn allowed_exponent(spent: f64, peak: &ContactState, requested: f64) -> f64 {
    let whole = peak.force * peak.elastic_approach;
    // rounding alone changes no exponent; one of −1 and less would give back energy without end
    if whole > spent * (1.0 + 0.5 * OLD_PEAK_ROUNDING) * (requested + 1.0) { whole / spent - 1.0 } else { requested }
}

impl Unloading {
    /// A branch of that shape from a peak. If the shape is no power law, the exponent follows from the energy given back.
    pub fn new(peak: ContactState, shape: UnloadingShape) -> Self {
        match shape {
            UnloadingShape::Power(exponent) => Self::power(peak, exponent),
            // not moved at all: Hertz itself
            UnloadingShape::Curve(UnloadingCurveKind::ShiftedHertz) if peak.residual() <= 0.0 => Self::power(peak, 1.5),
            UnloadingShape::Curve(kind) => {
                let ContactState { force, elastic_approach: length, .. } = peak;
                Self::with_curve(peak, UnloadingCurve::new(kind, length, force, peak.residual().max(0.0)))
            }
        }
    }

    /// The power law f_m (d/ε_m)^n.
    #[inline(always)]
    pub const fn power(peak: ContactState, exponent: f64) -> Self {
        Self { peak, exponent, requested: exponent, curve: None }
    }

    /// The power law with the requested exponent, or with a larger one that recovers no more than was spent.
    #[inline(always)]
    pub(super) fn power_within(peak: ContactState, requested: f64, spent: f64) -> Self {
        Self { requested, ..Self::power(peak, allowed_exponent(spent, &peak, requested)) }
    }

    /// A branch along this curve. From its whole peak, the branch of uniform pressure has the energy of n = 3π/4 − 1.
    fn with_curve(peak: ContactState, curve: UnloadingCurve) -> Self {
        let is_whole = curve.length == peak.elastic_approach;
        let exponent = if curve.kind == UnloadingCurveKind::UniformPressure && is_whole {
            0.75 * PI - 1.0
        } else {
            let (_, energy) = curve.derivatives_and_work(peak.elastic_approach);
            peak.force * peak.elastic_approach / energy - 1.0
        };
        Self { peak, exponent, requested: exponent, curve: Some(curve) }
    }

    /// True if the branch is no power law.
    pub(crate) fn has_curve(&self) -> bool {
        self.curve.is_some()
    }

    /// The time from the peak to x_r, times the speed there over ε_m.
    #[inline]
    pub(crate) fn quarter_period_factor(&self) -> f64 {
        self.curve
            .as_ref()
            .map_or_else(|| quarter_period_factor(self.exponent), |curve| self.curve_quarter_period_factor(curve))
    }

    #[cold]
    fn curve_quarter_period_factor(&self, curve: &UnloadingCurve) -> f64 {
        /// ∫₀¹ dd/√(1 − w(d)/w(1)), from integration with 60 digits.
        const UNIFORM: f64 = 1.493_167_350_244_138_5;
        let approach = self.peak.elastic_approach;
        // from the whole peak, and not from a lower point of its branch
        if curve.kind == UnloadingCurveKind::UniformPressure && curve.length == approach {
            return UNIFORM;
        }
        curve.travel_time(approach, approach, 0.0, 1.0) * (2.0 * self.recoverable_energy()).sqrt() / approach
    }

    /// Returns this branch with another end: the point where reloading turned on it, or a point beyond.
    #[inline]
    #[must_use]
    pub fn with_peak(&self, peak: ContactState) -> Self {
        match self.curve {
            None => Self::power(peak, self.exponent),
            Some(_) if peak.indentation == self.peak.indentation => *self,
            Some(curve) => Self::with_curve(peak, curve),
        }
    }

    /// This branch in a dent with that residual indentation, in which the impact has spent this work: the dent becomes no
    /// shallower, and the branch recovers no more than was spent.
    pub(super) fn in_dent(&self, residual: f64, spent: f64) -> Self {
        let elastic_approach = self.peak.elastic_approach.min(self.peak.indentation - residual);
        let peak = ContactState { elastic_approach, ..self.peak };
        let exponent = allowed_exponent(spent, &peak, self.exponent);
        let is_same = elastic_approach == self.peak.elastic_approach && exponent == self.exponent;
        if is_same { *self } else { Self { requested: self.requested, ..Self::power(peak, exponent) } }
    }

    /// The branch in other units: lengths times `length`, forces times `force`.
    #[must_use]
    pub(crate) fn in_units(&self, length: f64, force: f64) -> Self {
        let ContactState { indentation, force: of_peak, elastic_approach } = self.peak;
        let peak = ContactState {
            indentation: indentation * length,
            force: of_peak * force,
            elastic_approach: elastic_approach * length,
        };
        let curve = self.curve.map(|curve| curve.in_units(length, force));
        Self { peak, curve, ..*self }
    }

    /// The state at a distance from x_r, at most the peak. The distance has digits that x has lost.
    pub(crate) fn state_at(&self, distance: f64) -> ContactState {
        let peak = self.peak;
        if distance >= peak.elastic_approach {
            return peak;
        }
        let indentation = (peak.residual() + distance).min(peak.indentation);
        ContactState { indentation, force: self.force_at_elastic_approach(distance), elastic_approach: distance }
    }

    /// True if the branch is f = f_m (d/ε_m)^n from this peak.
    pub(crate) fn is_power_from(&self, peak: &ContactState) -> bool {
        self.curve.is_none() && self.peak == *peak
    }

    /// Force at x; zero below the residual indentation (the surfaces have parted, there is no adhesion).
    #[inline]
    pub fn force(&self, x: f64) -> f64 {
        self.force_at_elastic_approach(x - self.peak.residual())
    }

    /// Force at the distance `recovered` = x − x_r from the end of unloading.
    pub(crate) fn force_at_elastic_approach(&self, recovered: f64) -> f64 {
        match recovered {
            _ if recovered <= 0.0 => 0.0,
            _ if recovered == self.peak.elastic_approach => self.peak.force,
            _ => self.to_piece().force_at_distance(recovered),
        }
    }

    /// Elastic energy stored at x, f (x − x_r)/(n + 1); what unloading from the peak gives back is this at x_m.
    #[inline]
    pub fn stored_energy(&self, x: f64) -> f64 {
        self.stored_energy_at(if x == self.peak.indentation {
            self.peak.elastic_approach
        } else {
            x - self.peak.residual()
        })
    }

    /// Elastic energy stored at the distance `recovered` = x − x_r from the end of unloading.
    pub(crate) fn stored_energy_at(&self, recovered: f64) -> f64 {
        match recovered {
            _ if recovered <= 0.0 => 0.0,
            _ if recovered == self.peak.elastic_approach => self.recoverable_energy(),
            _ => self.to_piece().work_at_distance(recovered),
        }
    }

    /// Elastic energy stored at the peak, f_m ε_m/(n + 1). Unloading from the peak gives it back; a reload with more energy
    /// goes beyond the peak.
    #[inline(always)]
    pub fn recoverable_energy(&self) -> f64 {
        self.peak.force * self.peak.elastic_approach * work_factor(self.exponent)
    }

    /// df/dx at the distance `recovered` = x − x_r from the end of unloading; n f_m/ε_m where unloading begins.
    pub(crate) fn slope_at(&self, recovered: f64) -> f64 {
        self.to_piece().slope_at_distance(recovered)
    }

    /// Radius of the contact that friction acts on, in units of the radius at x = 1: f_m/ε_m where unloading begins, then in
    /// proportion to the stiffness.
    pub(crate) fn radius_ratio(&self, recovered: f64) -> f64 {
        let (ContactState { force, elastic_approach, .. }, branch) = (self.peak, self.to_piece());
        force / elastic_approach * branch.slope_at_distance(recovered.max(0.0))
            / branch.slope_at_distance(elastic_approach)
    }

    /// Returns x − x_r where the force is `force`; from f_m on it is ε_m.
    pub(crate) fn elastic_approach_at_force(&self, force: f64) -> f64 {
        let whole = self.peak.elastic_approach;
        if force >= self.peak.force { whole } else { self.to_piece().distance_at_force(force).min(whole) }
    }

    /// k of f = k d^n with d = x − x_r, the recovered approach still stored. For other shapes than powers this is the power
    /// law that gives back the same energy; [`Unloading::to_piece`] is the branch itself.
    pub fn power_stiffness(&self) -> f64 {
        self.peak.force / power(self.peak.elastic_approach, self.exponent)
    }

    /// The branch as a piece that begins at x_r without force: what reloading runs along.
    pub fn to_piece(&self) -> Piece {
        let shape = self.curve.map_or_else(|| Shape::power(self.power_stiffness(), self.exponent), Shape::Unloading);
        Piece { start: self.peak.residual(), force: 0.0, work: 0.0, is_subdivision: false, shape }
    }
}
