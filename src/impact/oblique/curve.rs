//! The curve of Maw, Barber and Fawcett: in an elastic impact s_1/s_0 depends on ψ_1 and χ alone, so that one curve serves all
//! angles, speeds and coefficients of friction of a table.

use std::sync::OnceLock;

use super::mindlin::Motion;
use crate::integrate::IntegrationError;

/// s_1/s_0 over |ψ_1| at one χ, up to gross sliding, at nodes that are computed when they are asked for.
///
/// At ψ_1 = 1, from where on the contact slips at first touch, the curve has a kink. On either side a polynomial of degree 5
/// through the nearest nodes is within 4e-5 of a run for solid spheres (5e-5 below ψ_1 = 0.01).
#[derive(Debug, Clone)]
pub struct Curve {
    chi: f64,
    /// Up to ψ_1 = 1, and from there on.
    sides: [Box<[OnceLock<f64>]>; 2],
}

/// The largest error of a value of the curve.
pub const ERROR: f64 = 5e-5;
/// Nodes of both sides.
const NODES: [usize; 2] = [121, 241];
/// Nodes of a polynomial.
const NEAR: usize = 6;

impl Curve {
    pub fn new(chi: f64) -> Self {
        Self { chi, sides: NODES.map(|nodes| vec![OnceLock::new(); nodes].into()) }
    }

    /// s_1/s_0 at 0 < |ψ_1| ≤ 4χ − 1.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small counts
    pub fn ratio(&self, psi: f64) -> Result<f64, IntegrationError> {
        let motion = Motion::elastic()?;
        let (side, from, to) =
            if psi < 1.0 { (&self.sides[0], 0.0, 1.0) } else { (&self.sides[1], 1.0, 4.0 * self.chi - 1.0) };
        let step = (to - from) / (side.len() - 1) as f64;
        let place = (psi - from) / step;
        let first = (place as usize).saturating_sub(NEAR / 2 - 1).min(side.len() - NEAR);
        let node = |i: usize| {
            // with next to no slip speed nothing slips
            let psi = from + step * (i as f64).max(1e-6);
            *side[i].get_or_init(|| motion.run(psi, self.chi, 1, |_, _| ()))
        };
        let term = |i: usize| {
            let others = (first..first + NEAR).filter(|other| *other != i);
            node(i) * others.map(|other| (place - other as f64) / (i as f64 - other as f64)).product::<f64>()
        };
        Ok((first..first + NEAR).map(term).sum())
    }
}
