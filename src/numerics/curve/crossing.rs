//! The time of a fast sphere on the first part of a curve of many straight pieces, as a power series.
//!
//! A sphere that comes with the energy E (its speed is then q) has the speed q √(1 − w/E) where the contact has taken the
//! work w. So the time from first touch to a knot x_i is
//!
//! ```text
//! t = (1/q) ∫ dx/√(1 − w/E) = (x_i/q) Σ c_k (w_i/E)^k,   c_k = (2k)!/(4^k k!²) · mean of (w/w_i)^k from 0 to x_i
//! ```
//!
//! The c_k belong to the curve and are computed once. Up to w_i = E/10 fourteen terms are enough: the rest of the
//! series is below 1e-16 of the time of loading. A hardening half-space and a sphere that yields have about 60 to 100 pieces, and
//! this series gives the time on most of them.

use super::piece::{Piece, Shape};
use crate::numerics::quadrature::gauss;

const TERMS: usize = 14;
/// The largest w_i/E that the series is used for.
const LARGEST_SHARE: f64 = 0.1;
/// One of so many knots of a curve of straight pieces has a series: series for all would take four times the room and save
/// little.
const EVERY: usize = 4;

/// No series is made for a knot of more work: the powers of the work would leave double precision.
const LARGEST_WORK: f64 = 1e20;

/// (2k)!/(4^k k!²) and 1/(2k + 1).
#[allow(clippy::cast_precision_loss)] // fourteen terms
const CONSTANTS: [[f64; 2]; TERMS] = {
    let (mut constants, mut k) = ([[1.0; 2]; TERMS], 1);
    while k < TERMS {
        constants[k] = [constants[k - 1][0] * (k as f64 - 0.5) / k as f64, 1.0 / (2.0 * k as f64 + 1.0)];
        k += 1;
    }
    constants
};

/// A knot with the series of the time to it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Crossing {
    /// Index of the piece that begins there.
    piece: usize,
    /// x_i.
    start: f64,
    /// w_i.
    work: f64,
    /// c_k.
    coefficients: [f64; TERMS],
}

impl Crossing {
    fn new(piece: usize, start: f64, work: f64, moments: &[f64; TERMS]) -> Self {
        let (mut coefficients, mut unit, per_work) = ([1.0; TERMS], 1.0 / start, 1.0 / work);
        for k in 1..TERMS {
            unit *= per_work;
            coefficients[k] = CONSTANTS[k][0] * moments[k] * unit;
        }
        Self { piece, start, work, coefficients }
    }

    /// True if the series is good for a sphere of this energy.
    #[inline(always)]
    pub(super) fn is_good(&self, kinetic: f64) -> bool {
        self.work <= LARGEST_SHARE * kinetic
    }

    /// The knot, and when it is passed.
    #[inline]
    pub(super) fn reached(&self, kinetic: f64, speed: f64) -> Reached {
        let share = self.work / kinetic;
        let square = share * share;
        // even and odd terms apart, so that neither waits for the other
        let (even, odd) = self
            .coefficients
            .chunks_exact(2)
            .rev()
            .fold((0.0, 0.0), |(even, odd), pair| (even * square + pair[0], odd * square + pair[1]));
        let &Self { piece, start, work, .. } = self;
        Reached { piece, work, time: start / speed * (even + share * odd) }
    }
}

/// A place on the way in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reached {
    pub piece: usize,
    pub work: f64,
    /// The time since first touch.
    pub time: f64,
}

/// The series for the knots of a curve that begins with a power law from zero; there are none behind a piece that is neither
/// straight nor a formula.
#[allow(clippy::cast_precision_loss)] // fourteen terms
pub(super) fn crossings(pieces: &[Piece]) -> Vec<Crossing> {
    let is_long = !pieces.iter().any(|piece| matches!(piece.shape, Shape::Polynomial(_)));
    let mut crossings = Vec::with_capacity(pieces.len());
    // ∫ w^k dx from 0 to the start of a piece
    let mut moments = [0.0; TERMS];
    for (index, pair) in (1..).zip(pieces.windows(2)).take_while(|(_, pair)| pair[1].work < LARGEST_WORK) {
        let (piece, next) = (&pair[0], &pair[1]);
        let length = next.start - piece.start;
        match &piece.shape {
            Shape::Power { exponent, offset: 0.0, .. } => {
                let mut term = length;
                for (k, moment) in moments.iter_mut().enumerate() {
                    *moment = term / (k as f64 * (exponent + 1.0) + 1.0);
                    term *= next.work;
                }
            }
            // by parts: (2k + 1) ∫ w^k dx = [f w^k]/s + k (2w − f²/s) ∫ w^(k−1) dx, where the last bracket is constant
            Shape::Straight { slope, .. } => {
                let [mut before, mut after] = [0.0, length].map(|d| piece.force_beyond(d) / slope);
                let excess = 2.0 * piece.work - piece.force * before;
                let mut integral = length;
                moments[0] += length;
                for k in 1..TERMS {
                    before *= piece.work;
                    after *= next.work;
                    integral = (after - before + k as f64 * excess * integral) * CONSTANTS[k][1];
                    moments[k] += integral;
                }
            }
            Shape::Polynomial(poly) => {
                let (nodes, weights) = gauss();
                for (node, weight) in nodes.iter().zip(weights) {
                    let (mut term, work) = (weight * length, piece.work + poly.work(node * length));
                    for moment in &mut moments {
                        *moment += term;
                        term *= work;
                    }
                }
            }
            Shape::Power { .. } | Shape::Branch(_) => break,
        }
        if !is_long || index % EVERY == 0 {
            crossings.push(Crossing::new(index, next.start, next.work, &moments));
        }
    }
    crossings
}
