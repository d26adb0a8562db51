//! A formula on a stretch of a loading curve as a polynomial, made once a contact: work, the way that a work goes, and
//! times cost a few products there, and no integration.
//!
//! A panel begins at x_0 with the work w_0, and the distance from the singular point of the formula doubles over it. It takes
//! the polynomial of the force on an interval that is a little longer at both ends, and holds the quotient Q of its integral,
//! w = w_0 + (t − t_0) Q(t), with t from −1 to 1 over the interval: so the work from x_0 on has all digits, however short the
//! way.

use super::piece::Piece;
use crate::math::chebyshev::{Polynomial, TERMS, polynomial, value};
use crate::math::functions::{ln, pow};
use crate::math::quadrature::gauss;

/// How far before its start and behind its end a panel holds, over the distance of that place from the singular point.
const OVERLAP: f64 = 0.05;

/// One stretch of a formula.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    /// Index of the piece of the curve.
    pub piece: usize,
    /// x_0.
    pub start: f64,
    /// w_0.
    pub work: f64,
    pub length: f64,
    /// How far before its start the polynomial holds, and how far behind its end.
    overlaps: [f64; 2],
    /// t_0.
    first: f64,
    /// dt/dx.
    scale: f64,
    /// Of Q.
    coefficients: Polynomial,
}

/// The panels of the piece of this index from its start to `end`, for a formula that is singular at `pole`.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few panels
pub(super) fn panels(index: usize, piece: &Piece, end: f64, pole: f64) -> Vec<Panel> {
    let whole = (end - pole) / (piece.start - pole);
    let count = (ln(whole) / std::f64::consts::LN_2).ceil().max(1.0);
    let ratio = pow(whole, 1.0 / count);
    let mut panels: Vec<Panel> = Vec::with_capacity(count as usize);
    let (mut start, mut work) = (piece.start, piece.work);
    for number in 1..=count as usize {
        let to = if number == count as usize { end } else { pole + (start - pole) * ratio };
        let panel = Panel::new(index, piece, [start, to, work], [start, to].map(|x| OVERLAP * (x - pole)));
        (start, work) = (to, work + panel.work_beyond(panel.length));
        panels.push(panel);
    }
    panels
}

impl Panel {
    fn new(index: usize, piece: &Piece, [start, end, work]: [f64; 3], overlaps: [f64; 2]) -> Self {
        let half = 0.5 * (end - start + overlaps[0] + overlaps[1]);
        let middle = start - overlaps[0] + half;
        let force = polynomial(|t| piece.force_at(middle + half * t));
        // the antiderivative over t − t_0
        let first = (start - middle) / half;
        #[allow(clippy::cast_precision_loss)] // a few terms
        let (mut coefficients, mut sum, mut power) = ([0.0; TERMS], 0.0, TERMS as f64);
        for (quotient, coefficient) in coefficients.iter_mut().zip(&force).rev() {
            sum = sum * first + half * coefficient / power;
            *quotient = sum;
            power -= 1.0;
        }
        Self { piece: index, start, work, length: end - start, overlaps, first, scale: 1.0 / half, coefficients }
    }

    /// Work from the start of the panel to a distance from there.
    #[inline]
    pub fn work_beyond(&self, distance: f64) -> f64 {
        let by = distance * self.scale;
        by * value(&self.coefficients, self.first + by)
    }

    /// The distance from the start of the panel at which the work from there is `rest`: Newton's method from the square root
    /// that meets both ends, as the work goes about with x².
    pub fn distance_at_work(&self, rest: f64) -> f64 {
        let (start, end) = (self.start, self.start + self.length);
        let share = rest / self.work_beyond(self.length);
        let square = share * (end - start) * (end + start);
        let mut distance = square / ((start * start + square).sqrt() + start);
        for _ in 0..50 {
            let by = distance * self.scale;
            let t = self.first + by;
            let (quotient, slope) = self
                .coefficients
                .iter()
                .rev()
                .fold((0.0, 0.0), |(value, slope), coefficient| (value * t + coefficient, slope * t + value));
            let step = (by * quotient - rest) / (self.scale * (quotient + by * slope));
            distance -= step;
            if step.abs() <= 1e-9 * distance || step.is_nan() {
                break;
            }
        }
        distance
    }

    /// How far behind `to` > 0 this much more work is done, if the polynomial still holds there.
    fn beyond(&self, to: f64, work: f64) -> Option<f64> {
        if work == 0.0 {
            return None;
        }
        let most = self.length - to + self.overlaps[1];
        let above = self.below(to);
        // work over the mean force on the way, which hardly changes with the way
        let way = |before: f64| work / (self.scale * value(&above, self.first + (to + before) * self.scale));
        let mut beyond = way(0.0);
        for _ in 0..20 {
            if beyond.is_nan() || beyond > 1.1 * most {
                return None;
            }
            let next = way(beyond);
            let change = (next - beyond).abs();
            beyond = next;
            if change <= f64::EPSILON * beyond {
                break;
            }
        }
        (beyond <= most).then_some(beyond)
    }

    /// The time of a `way` that ends at a distance `to` from the start of this panel, where the speed is `exit`. It may begin
    /// on the panels before.
    ///
    /// With d = to − ζ (ζ + 2 z), z² = exit²/(2 c f(to)), the root in u² = exit² + 2 c (w(to) − w) loses its singularity. At
    /// the nodes on this panel the difference of the works is that of its polynomial, in which nothing cancels.
    fn time(&self, lower: &[Self], way: f64, to: f64, exit: f64, c: f64) -> f64 {
        let (below, work) = (self.below(to), self.work_beyond(to));
        let force = self.scale * value(&below, self.first + to * self.scale);
        let z = (0.5 * exit * exit / (c * force)).max(0.0).sqrt();
        let far = way / ((way + z * z).sqrt() + z);
        let (nodes, weights) = gauss();
        let mut total = 0.0;
        for (node, weight) in nodes.iter().zip(weights) {
            let zeta = far * node;
            let gap = zeta * (zeta + 2.0 * z);
            let (distance, x) = (to - gap, self.start + to - gap);
            let work = match lower.iter().rev().find(|panel| panel.start <= x) {
                Some(panel) if distance < -self.overlaps[0] => {
                    (self.work - panel.work) - panel.work_beyond(x - panel.start) + work
                }
                _ => gap * self.scale * value(&below, self.first + distance * self.scale),
            };
            total += weight * (zeta + z) / (exit * exit + 2.0 * c * work).sqrt();
        }
        2.0 * far * total
    }

    /// R(t) = (w(t_1) − w(t))/(t_1 − t) for the place `to`, at t_1.
    fn below(&self, to: f64) -> Polynomial {
        let by = to * self.scale;
        let (t, mut divided, mut quotient) = (self.first + by, 0.0, [0.0; TERMS]);
        for (entry, coefficient) in quotient.iter_mut().zip(&self.coefficients).rev() {
            *entry = coefficient + by * divided;
            divided = coefficient + t * divided;
        }
        quotient
    }
}

/// The time of a motion d'' = −c f over these panels, from `from` to a distance `to` beyond the start of the last one, where
/// the speed is `exit` (0 at a turning point).
pub(super) fn time(panels: &[Panel], from: f64, to: f64, exit: f64, c: f64) -> f64 {
    /// So many panels are done at once: one rule over more of them would be too coarse.
    const MOST: usize = 3;
    let Some((last, lower)) = panels.split_last() else { return 0.0 };
    if let Some(split) = lower.len().checked_sub(MOST).map(|split| split + 1) {
        let (middle, before) = (&panels[split], &panels[split - 1]);
        let work = last.work - middle.work + last.work_beyond(to);
        let speed = (exit * exit + 2.0 * c * work).sqrt();
        return time(&panels[..split], from, before.length, speed, c)
            + time(&panels[split..], middle.start, to, exit, c);
    }
    let way = last.start - from + to;
    // a small speed at the end is lost soon behind it: up to there, less the rest
    last.beyond(to, 0.5 * exit * exit / c).map_or_else(
        || last.time(lower, way, to, exit, c),
        |beyond| last.time(lower, way + beyond, to + beyond, 0.0, c) - last.time(lower, beyond, to + beyond, 0.0, c),
    )
}
