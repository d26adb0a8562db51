//! The law of a contact as numbers: Hertz's contact up to the first yield, and polynomials beyond. A code that has these numbers computes
//! the force without this library.
//!
//! ```text
//! x = δ/L            f = F/Φ = x^1.5 and ε = x               up to the start of the table
//!                    f(x), ε(x), n(x), p(x): polynomials      beyond, p = plastic work/(Φ L)
//! unloading          f = f_b ((x − x_m + ε_b)/ε_b)^n          from the largest indentation x_m
//! ```
//!
//! f_b and ε_b are f and ε at x_m, except for a metal that relaxes at maximum compression: then they have polynomials of their own.

use thiserror::Error;

use crate::contact::law::{Law, Surface};
use crate::impact::problem::contact::Contact;
use crate::numerics::piecewise_fit::{FittedInterval, fit_piecewise};
use crate::numerics::power::power;

/// The quantities of the table: f, ε, n, p, f_b, ε_b.
pub const N_QUANTITIES: usize = 6;

/// Largest error of a polynomial: relative for forces and lengths, absolute for n, relative to the work of loading for p.
const TOLERANCE: f64 = 1e-14;

/// A law as polynomials.
#[derive(Debug, Clone, PartialEq)]
pub struct LawTable {
    /// L \[m\].
    pub length: f64,
    /// Φ \[N\].
    pub force: f64,
    /// False for a contact that stays elastic: it has no memory and no intervals.
    pub yields: bool,
    /// True if f_b and ε_b are not f and ε.
    pub relaxes: bool,
    pub intervals: Vec<FittedInterval<N_QUANTITIES>>,
}

/// Why a law cannot be written as such a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum LawTableError {
    #[error("its loading does not begin with Hertz's law")]
    NoElasticLoading,
    #[error("its unloading curve is not a power of the distance")]
    UnloadingCurve,
    #[error("its formulas cannot be followed to 14 digits")]
    Fit,
}

impl Contact {
    /// The law as a table, up to an indentation of the radius of the smaller body, or the end of the formulas of the law.
    ///
    /// # Errors
    /// [`LawTableError`] for a law of another form.
    pub fn law_table(&self) -> Result<LawTable, LawTableError> {
        let Self { scales, law, .. } = self;
        let units = &scales.units;
        let end = (self.pair().smaller_radius / units.length).min(law.validity.max_indentation);
        let start = law.recovers_fully_until().min(law.validity.elastic_until);
        let table = |intervals| LawTable {
            length: units.length,
            force: units.force,
            yields: self.pair().yield_point.is_some(),
            relaxes: law.relaxes(),
            intervals,
        };
        let is_hertz = |x: f64| (law.loading.force(x) - power(x, 1.5)).abs() <= TOLERANCE * power(x, 1.5);
        if start <= 0.0 || ![0.1, 0.5, 1.0].into_iter().all(|share| is_hertz(share * start.min(end))) {
            return Err(LawTableError::NoElasticLoading);
        }
        if start >= end {
            return Ok(table(Vec::new()));
        }
        let octaves = std::iter::successors(Some(start), |x| Some(2.0 * x)).take_while(|x| *x < end);
        let mut knots: Vec<f64> = octaves.chain([end]).collect();
        let has_curve = |x: &f64| law.unload(law.loaded_state(*x)).has_curve();
        if knots[1..].iter().any(has_curve) {
            return Err(LawTableError::UnloadingCurve);
        }
        let ends = law.loading.pieces().iter().map(|piece| piece.start).chain([law.validity.elastic_until]);
        knots.extend(ends.filter(|x| start < *x && *x < end));
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let intervals = fit_piecewise(&|x| values_and_scales(law, x), &knots, TOLERANCE);
        intervals.map(table).ok_or(LawTableError::Fit)
    }
}

/// The quantities of the table at x, and the scales of their errors.
fn values_and_scales(law: &Law, x: f64) -> ([f64; N_QUANTITIES], [f64; N_QUANTITIES]) {
    let state = law.loaded_state(x);
    let unloading = law.unload(state);
    let peak = unloading.peak;
    let plastic = Surface::from(law).plastic_work_unrounded(&unloading);
    let values = [state.force, state.elastic_approach, unloading.exponent, plastic, peak.force, peak.elastic_approach];
    let work = plastic + unloading.recoverable_energy();
    (values, [state.force, state.elastic_approach, 1.0, work, peak.force, peak.elastic_approach])
}
