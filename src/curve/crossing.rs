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
use crate::math::quadrature::gauss;

const TERMS: usize = 14;
/// The largest w_i/E that the series is used for.
const LARGEST_SHARE: f64 = 0.1;
/// One of so many knots of a curve of straight pieces has a series: series for all would take four times the room and save
/// little.
const EVERY: usize = 4;

/// No series is made for a knot of more work: the powers of the work would leave double precision.
const LARGEST_WORK: f64 = 1e20;

/// A longer piece is integrated in parts, and there are no series behind one that is longest: lengths over x where it begins.
const LONG: f64 = 0.12;
const LONGEST: f64 = 20.0;

/// Gauss's rule with four nodes on (0, 1). It is exact for w, w² and w³, and on a part that is not [`LONG`] it integrates the
/// higher powers as well as they count.
const NODES: [f64; 4] =
    [0.069_431_844_202_973_71, 0.330_009_478_207_571_9, 0.669_990_521_792_428_1, 0.930_568_155_797_026_3];
const WEIGHTS: [f64; 4] =
    [0.173_927_422_568_726_93, 0.326_072_577_431_273_07, 0.326_072_577_431_273_07, 0.173_927_422_568_726_93];

/// (2k)!/(4^k k!²).
#[allow(clippy::cast_precision_loss)] // fourteen terms
const BINOMIALS: [f64; TERMS] = {
    let (mut binomials, mut k) = ([1.0; TERMS], 1);
    while k < TERMS {
        binomials[k] = binomials[k - 1] * (k as f64 - 0.5) / k as f64;
        k += 1;
    }
    binomials
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
            coefficients[k] = BINOMIALS[k] * moments[k] * unit;
        }
        Self { piece, start, work, coefficients }
    }

    /// Whether the series is good for a sphere of this energy.
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

/// Adds to the moments what these nodes add: their terms, which begin as their weights, times the powers of their works.
fn add<const N: usize>(moments: &mut [f64; TERMS], mut terms: [f64; N], works: &[f64; N]) {
    for moment in moments {
        let mut sum = 0.0;
        for (term, work) in terms.iter_mut().zip(works) {
            sum += *term;
            *term *= work;
        }
        *moment += sum;
    }
}

/// The series for the knots of a curve that begins with a power law from zero; there are none behind a piece that is neither
/// straight nor a formula.
pub(super) fn crossings(pieces: &[Piece]) -> Vec<Crossing> {
    let is_long = !pieces.iter().any(|piece| matches!(piece.shape, Shape::Polynomial(_)));
    let mut crossings = Vec::with_capacity(pieces.len());
    // ∫ w^k dx from 0 to the start of a piece
    let mut moments = [0.0; TERMS];
    for (index, pair) in (1..).zip(pieces.windows(2)).take_while(|(_, pair)| pair[1].work < LARGEST_WORK) {
        let (piece, next) = (&pair[0], &pair[1]);
        let length = next.start - piece.start;
        match &piece.shape {
            #[allow(clippy::cast_precision_loss)] // fourteen terms
            Shape::Power { exponent, lead: 0.0, .. } => {
                let mut term = length;
                for (k, moment) in moments.iter_mut().enumerate() {
                    *moment = term / (k as f64 * (exponent + 1.0) + 1.0);
                    term *= next.work;
                }
            }
            Shape::Straight { slope, .. } if length < LONGEST * piece.start => {
                let count = (length / (LONG * piece.start)).ceil();
                let (mut begun, part) = (0.0, length / count);
                while begun < length * (1.0 - 0.5 / count) {
                    let works = NODES.map(|node| {
                        let d = begun + node * part;
                        piece.work + d * (piece.force + 0.5 * slope * d)
                    });
                    add(&mut moments, WEIGHTS.map(|weight| weight * part), &works);
                    begun += part;
                }
            }
            Shape::Polynomial(poly) => {
                let (nodes, weights) = gauss();
                let works = nodes.map(|node| piece.work + poly.work(node * length));
                add(&mut moments, weights.map(|weight| weight * length), &works);
            }
            Shape::Straight { .. } | Shape::Power { .. } | Shape::Branch(_) => break,
        }
        if !is_long || index % EVERY == 0 {
            crossings.push(Crossing::new(index, next.start, next.work, &moments));
        }
    }
    crossings
}
