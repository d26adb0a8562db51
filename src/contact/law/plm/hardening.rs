//! The PLM of a body that hardens: the yield strength grows with the strain under the contact.
//!
//! ```text
//! s     = √(δ/R) − √(δ_Y/R)                             a measure of the strain, for δ > δ_Y
//! σ_rep = ½ [σ(0.025 s) + σ(0.37 s)],  r = σ_rep/σ_Y     two strains stand for the strain field
//! x' = x/r²,  f' = f/r³,  ε' = ε/r²,  A' = f'/ε'         in units of the yield point that belongs to σ_rep
//!
//! f = r³ f_PLM(x/r²)                                    at points at most 10 % apart, straight between them
//! ε = r² min(x', ε_line(f'))                            ε = x where x' ≤ 1
//! n = n(Λ(A')) − 0.14 ν,  ν = 2 d ln σ_rep/d ln δ        for the exponent "pressure-shape"
//! a = â/(Λ(A') G)/(1 + 0.25 ν w),  w = (A' − 4)/16 from 0 to 1
//! ```
//!
//! Against finite elements of ten metals that harden, at contact radii up to 0.32 R: e rms 1.1 %, largest 2.7 %; peak force
//! 1.1 % and 2.8 %; contact radius 1.2 % and 2.9 %. Deeper dents: [`depth`](super::depth). Not covered: softening, yield plateaus, kinematic hardening. The
//! strain rate is a separate factor of the strength. A sphere that hardens uses the same
//! formulas, without its own finite elements. A hardened dent is assumed to reload like any other dent.

use std::iter::successors;

use super::approach::ApproachSlopes;
use crate::contact::strength::flow_curve::NormalisedFlowCurve;
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::{exp, ln};

/// The plastic strains that stand for the strain field, divided by s.
const STRAIN_FACTORS: [f64; 2] = [0.025, 0.37];

/// Largest ratio of neighbouring points of the loading curve: straight between them, the force is off by less than 0.1 %.
pub(super) const MAX_POINT_RATIO: f64 = 1.1;
const LN_RATIO: f64 = 0.095_310_179_804_324_93;

/// Least d ln f/d ln x of a piece. With the flow curves of metals it is above 1; a kink in a measured curve may give less.
const MIN_LOG_SLOPE: f64 = 0.01;

/// How a flow curve changes the PLM, in units of the first yield point.
#[derive(Debug, Clone, PartialEq)]
pub struct Hardening {
    /// σ/σ_Y over plastic strain.
    flow_curve: NormalisedFlowCurve,
    /// a_Y/R.
    yield_radius_ratio: f64,
    /// The polyline of the elastic approach, for any strength.
    approach_slopes: ApproachSlopes,
}

impl Hardening {
    /// For a body with this flow curve, which yields first at this a_Y/R.
    pub(super) fn new(
        flow_curve: NormalisedFlowCurve,
        yield_radius_ratio: f64,
        approach_slopes: ApproachSlopes,
    ) -> Self {
        Self { flow_curve, yield_radius_ratio, approach_slopes }
    }

    /// σ_rep/σ_Y at x; 1 below first yield.
    pub fn representative_strength(&self, x: f64) -> f64 {
        let s = self.yield_radius_ratio * (x.sqrt() - 1.0);
        if s <= 0.0 {
            return 1.0;
        }
        0.5 * (self.flow_curve.relative_stress(STRAIN_FACTORS[0] * s)
            + self.flow_curve.relative_stress(STRAIN_FACTORS[1] * s))
    }

    /// The largest plastic strain for which loading to x needs the flow curve, and the largest strain of the curve. `None` if the
    /// curve covers this strain.
    pub(crate) fn beyond_flow_curve(&self, x: f64) -> Option<(f64, f64)> {
        let strain = STRAIN_FACTORS[1] * self.yield_radius_ratio * (x.sqrt() - 1.0);
        let last = self.flow_curve.curve.last_strain()?;
        (strain > last).then_some((strain, last))
    }

    /// ε at a point (x, f) with x > 1, where this fraction of ε_line is recovered.
    #[inline(never)]
    pub(crate) fn elastic_approach(&self, x: f64, force: f64, share: f64) -> f64 {
        let r = self.representative_strength(x);
        let yield_indentation = r * r;
        if x <= yield_indentation {
            return x;
        }
        let on_line = self.approach_slopes.approach(force / (yield_indentation * r), self.yield_radius_ratio * r);
        (yield_indentation * on_line * share).min(x)
    }

    /// The shape of the contact pressure at x, where the Hertz-equivalent radius is A = f/ε.
    pub(crate) fn pressure_shape(&self, x: f64, equivalent: f64) -> PressureShape<'_> {
        let strength = self.representative_strength(x);
        PressureShape { hardening: self, x, strength, equivalent: equivalent / strength }
    }

    /// Hertz up to the first knot of the perfectly plastic curve, then straight through points at most 10 % apart: its
    /// knots, points between them in equal ratios, and points beyond the last knot until δ = R.
    pub(super) fn loading_curve(&self, perfect: &LoadingCurve) -> LoadingCurve {
        let knots = perfect.pieces().get(1..).unwrap_or_default();
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return perfect.clone() };
        let first = first.start;
        let force = |x: f64| {
            let r = self.representative_strength(x);
            let scaled = x / (r * r);
            if scaled <= first { x * x.sqrt() } else { r * r * r * perfect.force(scaled) }
        };
        let end = 1.0 / (self.yield_radius_ratio * self.yield_radius_ratio);
        let mut before = [first, force(first)];
        let inside = knots.windows(2).flat_map(|pair| geometric_points(pair[0].start, pair[1].start));
        let hardened = inside.chain(geometric_points_beyond(last.start, end)).map(|x| {
            let [start, from] = before;
            before = [x, force(x).max(from * (1.0 + MIN_LOG_SLOPE * (x - start) / start))];
            before
        });
        LoadingCurve::hertz().then_points([first, force(first)], hardened).with_transit_series()
    }
}

/// The numbers that the shape of the contact pressure depends on.
pub(crate) struct PressureShape<'a> {
    hardening: &'a Hardening,
    x: f64,
    /// σ_rep/σ_Y at x.
    strength: f64,
    /// A'.
    pub(crate) equivalent: f64,
}

impl PressureShape<'_> {
    /// ν, from the last tenth of the loading.
    pub(super) fn local_hardening_exponent(&self) -> f64 {
        2.0 * ln(self.strength / self.hardening.representative_strength(self.x / MAX_POINT_RATIO)) / LN_RATIO
    }

    /// The reduction of the exponent "pressure-shape" by hardening.
    pub(crate) fn exponent_loss(&self) -> f64 {
        0.14 * self.local_hardening_exponent()
    }

    /// The factor by which the contact is narrower, because less material piles up around it.
    pub(crate) fn pile_up_factor(&self) -> f64 {
        let share = ((self.equivalent - 4.0) / 16.0).clamp(0.0, 1.0);
        // the hardening exponent costs as much time as all the rest, and is not needed below A' = 4
        if share == 0.0 { 1.0 } else { 1.0 + 0.25 * self.local_hardening_exponent() * share }
    }
}

/// Where straight pieces from one knot to the next end: points in equal ratios, and the next knot.
pub(super) fn geometric_points(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let whole = ln(to / from);
    // less a rounding, as points of another curve are just so far apart
    let ratio = exp(whole / (whole / LN_RATIO - 1e-12).ceil().max(1.0));
    // half a step before the end, so that rounding neither adds nor loses a point
    let until = to / ratio.sqrt();
    successors(Some(from * ratio), move |x| Some(x * ratio)).take_while(move |x| *x < until).chain([to])
}

/// Points in ratios of 1.1 from the last knot, without it, to the first that is not before this end.
fn geometric_points_beyond(last: f64, end: f64) -> impl Iterator<Item = f64> {
    successors(Some(MAX_POINT_RATIO * last), move |x| (*x < end).then_some(MAX_POINT_RATIO * x))
}
