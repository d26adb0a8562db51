//! The strain rate of an impact, and the factors by which it raises the strength. [`super::rate`] computes them.

use crate::contact::law::LawChoice;
use crate::contact::strength::rate::Rate;

/// How the strengths of the bodies rise with the rate, and the law that they go into.
#[derive(Debug, Clone)]
pub(super) struct Rates {
    /// The rise of the sphere's strength and that of the half-space.
    pub(super) of_bodies: [Option<Rate>; 2],
    pub(super) law: LawChoice,
}

/// Strain rate and factors of strength of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rated {
    /// 0.2 w \[1/s\].
    pub strain_rate: f64,
    /// g of the body that yields.
    pub factor: f64,
    /// g_t of that body.
    pub factor_at_turn: f64,
    /// How its strength rises; `None` if the rate of the other body alone is known.
    pub(super) rate: Option<Rate>,
}
