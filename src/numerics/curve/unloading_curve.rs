//! Forces over the distance from their zero that are neither power laws nor straight lines, with force, slope, curvature and
//! work in closed form: the two unloading branches of published laws that are no powers.

use std::f64::consts::{PI, SQRT_2};

use super::polynomial::NEAR_END_SHARE;
use crate::numerics::functions::atan2;
use crate::numerics::quadrature::gauss_legendre;
use crate::numerics::root::newton_convex;

/// How the force rises from its zero to f_m at the distance ε.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnloadingCurveKind {
    /// f = (2 f_m/π)(θ − sin θ cos θ), 1 − cos θ = d/ε: unloading from uniform pressure (Mesarovic and Johnson 2000).
    UniformPressure,
    /// f = f_m ((d + x_r)^1.5 − x_r^1.5)/((ε + x_r)^1.5 − x_r^1.5): the Hertz curve, moved down (Yigit and Christoforou 1994).
    ShiftedHertz,
}

/// A branch up to its whole length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnloadingCurve {
    pub kind: UnloadingCurveKind,
    /// ε.
    pub length: f64,
    /// f_m.
    force: f64,
    /// x_r, the indentation at the zero of the force.
    residual: f64,
    /// 4 f_m/π of uniform pressure, k of f = k ((d + x_r)^1.5 − x_r^1.5).
    scale: f64,
}

/// (d + l)^1.5 − l^1.5 from a = √(d + l) and b = √l. Only a − b = d/(a + b) cancels, which is not formed.
fn difference_of_cubes(d: f64, a: f64, b: f64) -> f64 {
    d / (a + b) * (a * a + a * b + b * b)
}

impl UnloadingCurve {
    /// A branch of this kind that rises to `force` over `length`, from the indentation `residual`.
    pub fn new(kind: UnloadingCurveKind, length: f64, force: f64, residual: f64) -> Self {
        let scale = match kind {
            UnloadingCurveKind::UniformPressure => 4.0 / PI * force,
            UnloadingCurveKind::ShiftedHertz => {
                force / difference_of_cubes(length, (length + residual).sqrt(), residual.sqrt())
            }
        };
        Self { kind, length, force, residual, scale }
    }

    /// The branch in other units: lengths times `length`, forces times `force`.
    pub(crate) fn in_units(&self, length: f64, force: f64) -> Self {
        Self::new(self.kind, self.length * length, self.force * force, self.residual * length)
    }

    /// f, f', f'' and the work from zero; continued as an odd function, as a power from zero is.
    pub fn derivatives_and_work(&self, d: f64) -> ([f64; 3], f64) {
        match self.kind {
            _ if d < 0.0 => {
                let ([f, slope, curvature], work) = self.derivatives_and_work(-d);
                ([-f, slope, -curvature], work)
            }
            UnloadingCurveKind::UniformPressure if d == 0.0 => ([0.0; 3], 0.0),
            UnloadingCurveKind::UniformPressure => {
                let (s, unit) = (d / self.length, self.scale);
                let (sine, cosine) = ((s * (2.0 - s)).sqrt(), 1.0 - s);
                let (f, work) = if s < 0.25 {
                    // ∫ of f' = unit √(2 s) √(1 − s/2), and again
                    let (mut f, mut work, mut term) = (0.0, 0.0, SQRT_2 * s * s.sqrt());
                    for k in 0..18 {
                        let k = f64::from(k);
                        f += term / (k + 1.5);
                        work += term * s / ((k + 1.5) * (k + 2.5));
                        term *= 0.5 * s * (k - 0.5) / (k + 1.0);
                    }
                    (f, work)
                } else {
                    let theta = atan2(sine, cosine);
                    (0.5 * (theta - sine * cosine), 0.5 * (sine - theta * cosine - sine * sine * sine / 3.0))
                };
                let per = unit / self.length;
                ([unit * f, per * sine, per / self.length * cosine / sine], unit * self.length * work)
            }
            UnloadingCurveKind::ShiftedHertz => {
                let (k, a, b) = (self.scale, (d + self.residual).sqrt(), self.residual.sqrt());
                let above = d / (a + b);
                let work = above * above * (a * a * (0.4 * a + 0.8 * b) + b * b * (1.2 * a + 0.6 * b));
                ([k * difference_of_cubes(d, a, b), 1.5 * k * a, 0.75 * k / a], k * work)
            }
        }
    }

    /// The turning distance of a motion that begins at zero with the kinetic energy `rest`, under a constant force `pull`. Work and
    /// force are convex, so Newton's method converges monotonically from the end.
    pub fn turning_distance(&self, rest: f64, pull: f64) -> f64 {
        newton_convex(self.length, |d| {
            let ([f, ..], work) = self.derivatives_and_work(d);
            (work - pull * d - rest) / (f - pull)
        })
    }

    /// The distance at which the force is `force`, at most the length.
    pub fn distance_at_force(&self, force: f64) -> f64 {
        newton_convex(self.length, |d| {
            let ([f, slope, _], _) = self.derivatives_and_work(d);
            (f - force) / slope
        })
    }

    /// The time of a motion d'' = −c f over this distance up to `to`, where the speed is `exit` (0 at a turning point).
    ///
    /// In y, d = y (y + 2 b) with b = √x_r, the work of the shifted Hertz curve is a polynomial however shallow the dent; with
    /// y = Y − ζ (ζ + 2 z) the root in u² = exit² + 2 c (w(to) − w) loses its singularity.
    pub fn travel_time(&self, distance: f64, to: f64, exit: f64, c: f64) -> f64 {
        if distance == 0.0 {
            return 0.0;
        }
        let b = if self.kind == UnloadingCurveKind::ShiftedHertz { self.residual.sqrt() } else { 0.0 };
        let y_at = |d: f64| d / (b + (d + b * b).sqrt());
        let ([f, slope, curvature], whole) = self.derivatives_and_work(to);
        let (end, more) = (y_at(to), 0.5 * exit * exit / c);
        let (nodes, weights) = gauss_legendre();
        // Y − y of the whole way, (d_2 − d_1)/(y_1 + y_2 + 2 b)
        let most = distance / (end + 2.0 * b + if distance < to { y_at(to - distance) } else { 0.0 });
        let behind = 0.5 * more / ((end + b) * f);
        if behind > 0.0 && behind < NEAR_END_SHARE * most {
            // the time to the turn, less the rest, which is short
            let mean = |rest: f64| {
                nodes
                    .iter()
                    .zip(weights)
                    .map(|(node, weight)| weight * self.derivatives_and_work(to + rest * node).0[0])
                    .sum::<f64>()
            };
            let rest = (0..30).fold(more / f, |rest, _| more / mean(rest));
            return self.travel_time(distance + rest, to + rest, 0.0, c) - self.travel_time(rest, to + rest, 0.0, c);
        }
        let z = behind.sqrt();
        let far = most / ((most + behind).sqrt() + z);
        let at = |(node, weight): (&f64, &f64)| {
            let gap = far * node * (far * node + 2.0 * z);
            let y = end - gap;
            let before = gap * (end + y + 2.0 * b);
            let work = if before < 1e-4 * to {
                before * (f - before * (slope / 2.0 - before * curvature / 6.0))
            } else {
                whole - self.derivatives_and_work(y * (y + 2.0 * b)).1
            };
            weight * 2.0 * (y + b) * (far * node + z) / (more + work).sqrt()
        };
        far * nodes.iter().zip(weights).map(at).sum::<f64>() * (2.0 / c).sqrt()
    }
}
