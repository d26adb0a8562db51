//! Deep dents: beyond a/R = 0.3 the metal gives way more easily, and recovers more, than the law of shallow dents says.
//!
//! ```text
//! y = D (min(δ/R, 0.2) − 0.035) max(0, 1 − A_fp/A)         from δ/R = 0.035 on; constant beyond δ/R = 0.2
//! F = F_b/(1 + 0.55 y)                                     at points at most 10 % apart, straight between them
//! ε = min(x, ε_b (1 + 1.4 (0.75 − κ) y))
//! a = a_b/(1 + 0.14 D min(1, h/0.1) max(0, â/R − 0.4))     a body that hardens
//! ```
//!
//! F_b, ε_b and a_b are those of the law of shallow dents; ε_b belongs to F_b. A is that of the law without the flat of a
//! sphere, and in units of the strength that the body has reached. h is the local exponent of hardening. D is the fraction of the
//! yielding that is in the half-space; the sphere has its own correction ([`flattening`](super::flattening)). For two balls the
//! fraction of each is multiplied by the difference of the radii over their sum, if this ball is the larger one.
//!
//! `plm-impact validate` has the errors against finite elements of eight metals to a/R = 0.58. Not covered: friction of 0.2 under the
//! sphere raises the force by 3 to 5 % there.
//!
//! Most impacts end before δ/R = 0.035. So the curve beyond is computed when the first impact goes there.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::hardening::geometric_points;
use crate::contact::pair::Pair;
use crate::numerics::curve::{Cached, LoadingCurve};

/// h from which the whole correction of the contact radius applies.
const FULL_HARDENING: f64 = 0.1;

/// The numbers of the correction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DepthTable {
    /// δ/R from which it applies.
    pub from: f64,
    /// δ/R from which it is constant.
    pub to: f64,
    pub force: f64,
    pub recovery: f64,
    /// κ from which on a contact recovers less, and not more.
    pub recovery_kappa: f64,
    pub radius: f64,
    /// â/R from which the contact radius changes.
    pub radius_from: f64,
}

/// The correction for a pair of bodies, in units of first yield.
#[derive(Debug, Clone, PartialEq)]
pub struct Depth {
    table: DepthTable,
    /// D.
    share: f64,
    kappa: f64,
    yield_radius_ratio: f64,
    /// A_fp.
    plastic_from: f64,
    /// F_b.
    base: Arc<LoadingCurve>,
    /// The x from which it applies, and the x from which it is constant.
    range: [f64; 2],
    /// The work of loading to the start of the range.
    work: f64,
    /// F, once an impact needs it.
    curve: Cached<LoadingCurve>,
}

/// D of a pair.
fn half_space_share(pair: &Pair) -> f64 {
    let [sphere, half_space] = &pair.balls;
    let difference = sphere.curvature - half_space.curvature;
    half_space.share * difference.clamp(0.0, 1.0) + sphere.share * (-difference).max(0.0)
}

impl Depth {
    /// `None` if this pair has no correction: no yielding in the half-space, or bodies that yield so late that the whole range of the
    /// correction is elastic.
    pub(super) fn new(
        table: DepthTable,
        pair: &Pair,
        yield_radius_ratio: f64,
        plastic_from: f64,
        base: &Arc<LoadingCurve>,
    ) -> Option<Self> {
        let share = half_space_share(pair);
        let is_none = table.force == 0.0 && table.recovery == 0.0 && table.radius == 0.0;
        let square = yield_radius_ratio * yield_radius_ratio;
        let range @ [from, to] = [table.from / square, table.to / square];
        let first_knot = base.pieces().get(1)?.start;
        if is_none || share == 0.0 || to <= first_knot {
            return None;
        }
        let [kappa, _] = pair.law_shares();
        let work = base.work(from);
        let (base, curve) = (Arc::clone(base), Cached::default());
        Some(Self { table, share, kappa, yield_radius_ratio, plastic_from, base, range, work, curve })
    }

    /// This correction of another loading curve.
    pub(super) fn on(self, base: &Arc<LoadingCurve>) -> Self {
        Self { work: base.work(self.range[0]), base: Arc::clone(base), curve: Cached::default(), ..self }
    }

    /// F_b.
    pub(super) fn base(&self) -> &Arc<LoadingCurve> {
        &self.base
    }

    /// The x from which y is constant.
    pub(super) fn constant_from(&self) -> f64 {
        self.range[1]
    }

    /// True if it changes force and elastic approach at x.
    #[inline(always)]
    pub(super) fn applies_at(&self, x: f64) -> bool {
        x > self.range[0]
    }

    /// True if a sphere with this kinetic energy and weight turns well before the correction applies. The margin is for methods with
    /// fixed steps, whose energy has an error.
    #[inline(always)]
    pub(super) fn is_out_of_reach(&self, kinetic: f64, weight: f64) -> bool {
        const MARGIN: f64 = 0.9;
        kinetic + weight * self.range[0] < MARGIN * self.work
    }

    /// y at x, where `equivalent` computes A at an x.
    #[inline]
    pub(super) fn depth_at(&self, x: f64, equivalent: impl FnOnce(f64) -> f64) -> f64 {
        let [from, to] = self.range;
        if x <= from {
            return 0.0;
        }
        let x = x.min(to);
        let depth = x * self.yield_radius_ratio * self.yield_radius_ratio - self.table.from;
        self.share * depth * (1.0 - self.plastic_from / equivalent(x)).max(0.0)
    }

    /// The factor of ε_b where y is this.
    #[inline]
    pub(super) fn recovery_factor(&self, y: f64) -> f64 {
        1.0 + self.table.recovery * (self.table.recovery_kappa - self.kappa) * y
    }

    /// The factor by which the contact of a body that hardens is narrower, at A in units of first yield. `exponent` computes h.
    #[inline]
    pub(super) fn radius_factor(&self, equivalent: f64, exponent: impl FnOnce() -> f64) -> f64 {
        let beyond = equivalent * self.yield_radius_ratio - self.table.radius_from;
        if beyond <= 0.0 {
            return 1.0;
        }
        1.0 + self.table.radius * self.share * (exponent() / FULL_HARDENING).min(1.0) * beyond
    }

    /// F at x from the two points around x; `None` from where y is constant.
    pub(super) fn force_at(&self, x: f64, mut equivalent: impl FnMut(f64) -> f64) -> Option<f64> {
        let [from, to] = self.range;
        let pieces = self.base.pieces();
        let index = self.base.index_at(x);
        if index == 0 || x >= to {
            return None;
        }
        let start = pieces[index].start.max(from);
        let end = pieces.get(index + 1).map_or(to, |next| next.start.min(to));
        let mut before = start;
        let after = geometric_points(start, end).find(|point| {
            let is_after = *point > x;
            before = if is_after { before } else { *point };
            is_after
        })?;
        let is_first = before == pieces[1].start.max(from);
        let [low, high] = [before, after].map(|point| self.base.force(point) / self.divisor(point, &mut equivalent));
        let low = if is_first { self.base.force(before) } else { low };
        Some(low + (high - low) * (x - before) / (after - before))
    }

    /// F_b/F at a point of the curve.
    fn divisor(&self, x: f64, equivalent: impl FnOnce(f64) -> f64) -> f64 {
        1.0 + self.table.force * self.depth_at(x, equivalent)
    }

    /// F, where `equivalent` computes A at points with rising x.
    #[inline]
    pub(super) fn curve(&self, equivalent: impl FnMut(f64) -> f64) -> &LoadingCurve {
        self.curve.0.get_or_init(|| self.new_curve(equivalent))
    }

    #[cold]
    fn new_curve(&self, mut equivalent: impl FnMut(f64) -> f64) -> LoadingCurve {
        let [from, to] = self.range;
        let pieces = self.base.pieces();
        // the points begin behind Hertz's part
        let first = pieces.get(1).map_or(from, |piece| piece.start.max(from));
        let kept = pieces.partition_point(|piece| piece.start < first).max(1);
        let (inside, beyond) = pieces[kept..].split_at(pieces[kept..].partition_point(|piece| piece.start < to));
        let mut divisor_at = |x: f64| self.divisor(x, &mut equivalent);
        let (mut points, mut start) = (Vec::with_capacity(64), first);
        for end in inside.iter().map(|piece| piece.start).filter(|start| *start > first).chain([to]) {
            points.extend(geometric_points(start, end).map(|x| [x, self.base.force(x) / divisor_at(x)]));
            start = end;
        }
        let divisor = divisor_at(to);
        points.extend(beyond.iter().filter(|piece| piece.start > to).map(|piece| [piece.start, piece.force / divisor]));
        let last = pieces.last().map_or(1.0, |piece| piece.slope_at(piece.start)) / divisor;
        let end = points.last().map_or(to, |[x, _]| *x);
        LoadingCurve::new(pieces[..kept].to_vec())
            .then_points([first, self.base.force(first)], points.into_iter())
            .then_line(end, last)
            .with_transit_series()
    }
}
