//! The time of a fast sphere on the first part of a curve of many straight pieces, as a power series.
//!
//! A sphere with the energy E at first contact (its speed is q) has the speed q √(1 − w/E) where the contact has absorbed the
//! work w. So the time from first contact to a knot x_i is
//!
//! ```text
//! t = (1/q) ∫ dx/√(1 − w/E) = (1/q) Σ c_k E^(−k),   c_k = (2k)!/(4^k k!²) ∫ w^k dx from 0 to x_i
//! ```
//!
//! The c_k of a knot follow from those of the knot before. They are computed when the first impact needs them. Up to
//! w_i = E/10 fourteen terms are enough: the rest of the series is below 1e-16 of the time of loading. A hardening half-space
//! and a sphere that yields have about 40 to 100 pieces, and this series gives the time on most of them.

use std::sync::OnceLock;

use super::piece::{Piece, Shape};
use crate::numerics::quadrature::gauss_legendre;

const SERIES_TERMS: usize = 14;
/// The largest w_i/E that the series is used for.
const MAX_WORK_RATIO: f64 = 0.1;
/// A knot with more work than this has no series: the powers of the work would leave double precision.
const MAX_WORK: f64 = 1e20;

/// (2k)!/(4^k k!²) over its value for k − 1, 1/(2k + 1), and k times the product of both, for k from 1 on.
#[allow(clippy::cast_precision_loss)] // fourteen terms
const SERIES_FACTORS: [[f64; 3]; SERIES_TERMS - 1] = {
    let (mut constants, mut term) = ([[0.0; 3]; SERIES_TERMS - 1], 1);
    while term < SERIES_TERMS {
        let k = term as f64;
        constants[term - 1] = [(k - 0.5) / k, 1.0 / (2.0 * k + 1.0), (k - 0.5) / (2.0 * k + 1.0)];
        term += 1;
    }
    constants
};

/// The series of a curve.
#[derive(Debug, Clone)]
pub(super) struct TransitSeries {
    /// The knots behind the first pieces, in order.
    knots: Vec<OnceLock<TransitKnot>>,
}

impl TransitSeries {
    /// The series of a curve that begins with a power law from zero. No series is computed yet. The knots behind the first piece that
    /// is neither straight nor a formula have no series.
    pub(super) fn new(pieces: &[Piece]) -> Self {
        let is_covered = |pair: &&[Piece]| {
            let has_series = match pair[0].shape {
                Shape::Power { offset, .. } => offset == 0.0,
                Shape::Unloading(_) => false,
                Shape::Linear { .. } | Shape::Polynomial(_) => true,
            };
            has_series && pair[1].work < MAX_WORK
        };
        let count = pieces.windows(2).take_while(is_covered).count();
        Self { knots: (0..count).map(|_| OnceLock::new()).collect() }
    }

    /// The last knot that a sphere of this energy reaches fast enough for its series.
    #[inline(always)]
    pub(super) fn last_knot(&self, pieces: &[Piece], kinetic: f64) -> Option<&TransitKnot> {
        let slow_from = pieces.partition_point(|piece| piece.work <= MAX_WORK_RATIO * kinetic);
        let count = slow_from.saturating_sub(1).min(self.knots.len());
        let (last, before) = self.knots[..count].split_last()?;
        Some(last.get_or_init(|| TransitKnot::after(before, &pieces[..=count])))
    }
}

/// A knot with the series of the time to it.
#[derive(Debug, Clone)]
pub(super) struct TransitKnot {
    /// Index of the piece that begins there.
    piece: usize,
    /// w_i.
    work: f64,
    /// c_k.
    coefficients: [f64; SERIES_TERMS],
}

impl TransitKnot {
    /// The knot where the last of the pieces begins. The sum continues from the last of the knots `before` that has its series, or from
    /// first contact. The knots between keep none: a contact with one impact asks for one knot.
    #[cold]
    fn after(before: &[OnceLock<Self>], pieces: &[Piece]) -> Self {
        let known = before.iter().rev().find_map(OnceLock::get);
        let (begin, mut coefficients) = known.map_or((0, [0.0; SERIES_TERMS]), |knot| (knot.piece, knot.coefficients));
        for pair in pieces[begin..].windows(2) {
            add_piece(&mut coefficients, &pair[0], &pair[1]);
        }
        let last = pieces.len() - 1;
        Self { piece: last, work: pieces[last].work, coefficients }
    }

    /// The knot, and when it is passed.
    #[inline]
    pub(super) fn transit(&self, kinetic: f64, speed: f64) -> Transit {
        let inverse = 1.0 / kinetic;
        let square = inverse * inverse;
        // even and odd terms apart, so that neither waits for the other
        let (even, odd) = self
            .coefficients
            .chunks_exact(2)
            .rev()
            .fold((0.0, 0.0), |(even, odd), pair| (even * square + pair[0], odd * square + pair[1]));
        Transit { piece: self.piece, work: self.work, time: (even + inverse * odd) / speed }
    }
}

/// A position during loading.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Transit {
    pub piece: usize,
    pub work: f64,
    /// The time since first contact.
    pub time: f64,
}

/// Adds what a piece brings to the c_k.
fn add_piece(coefficients: &mut [f64; SERIES_TERMS], piece: &Piece, next: &Piece) {
    let length = next.start - piece.start;
    let [first, others @ ..] = coefficients;
    match &piece.shape {
        Shape::Power { exponent, .. } => {
            let (mut term, mut power) = (length, 1.0);
            *first += length;
            for (coefficient, [growth, ..]) in others.iter_mut().zip(&SERIES_FACTORS) {
                term *= next.work * growth;
                power += exponent + 1.0;
                *coefficient += term / power;
            }
        }
        Shape::Polynomial(poly) => {
            let (nodes, weights) = gauss_legendre();
            for (node, weight) in nodes.iter().zip(weights) {
                let (mut term, work) = (weight * length, piece.work + poly.work(node * length));
                *first += term;
                for (coefficient, [growth, ..]) in others.iter_mut().zip(&SERIES_FACTORS) {
                    term *= work * growth;
                    *coefficient += term;
                }
            }
        }
        Shape::Linear { slope, .. } => {
            // by parts: (2k + 1) ∫ w^k dx = [f w^k]/s + k (2w − f²/s) ∫ w^(k−1) dx, where 2w − f²/s is constant
            let (mut integral, mut before) = (length, piece.force / slope);
            let (mut after, excess) = (before + length, 2.0 * piece.work - piece.force * before);
            *first += length;
            for (coefficient, [growth, of_ends, of_rest]) in others.iter_mut().zip(&SERIES_FACTORS) {
                before *= piece.work * growth;
                after *= next.work * growth;
                integral = (after - before) * of_ends + of_rest * excess * integral;
                *coefficient += integral;
            }
        }
        Shape::Unloading(_) => {}
    }
}
