//! The rules of a published law: contact radius along the loading curve, and unloading from a peak.
//!
//! No contact gives back more energy than it has taken, and no dent is higher than the surface. Where the formulas of a law
//! break this, the elastic approach is reduced to the largest possible one. Where they break it by more than
//! [`LARGEST_CUT`], the law has no answer ([`OutsideLaw`]).
//!
//! The law has no answer for: `mesarovic_johnson` and `johnson` near yield (case 3 of Xie et al. 2024: below 14 yield
//! indentations); `stronge` between x = 1.1 and 2.5, where it gives back up to 17 % more energy than was spent; the
//! residual of Jackson, Chusoipin and Green beyond x = 10⁴, where δ_r > δ_m; and fits beyond a = R or δ = R/2.

use std::fmt;
use std::sync::Arc;

use thiserror::Error;

use super::curve::Curve;
use super::{Peak, Unloading, UnloadingShape};
use crate::strength::flow::FlowError;
use crate::units::four_digits;

/// How much a law's own formulas may exceed the approach, or the energy spent, before the law is refused there: more than
/// the 3 % by which the force of Kogut and Etsion jumps at first yield.
pub const LARGEST_CUT: f64 = 0.05;

/// A point of a loading curve, as unloading sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakState {
    /// x_m.
    pub indentation: f64,
    /// f_m.
    pub force: f64,
    /// a_m/a_Y.
    pub radius: f64,
    /// (E_s*/E*) δ_sm/δ_Y, where the sphere's own indentation is known, as from a measurement.
    pub elastic_approach: Option<f64>,
    /// W/(F_Y δ_Y): the work of loading.
    pub spent: f64,
}

impl PeakState {
    /// The unloading branch from here by this rule.
    ///
    /// # Errors
    /// [`OutsideLaw`] where the law has no answer.
    pub fn unload(&self, recovery: &RecoveryRule) -> Result<Unloading, OutsideLaw> {
        let raw = recovery(*self);
        raw.accept(self)?;
        Ok(raw.branch(self, raw.bounded(self)))
    }
}

/// A dent that is a smaller share of the indentation than this comes from rounding, and counts as none.
const NO_DENT: f64 = 1e-13;

/// The unloading from a peak by the law's own formulas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recovered {
    /// ε = x_m − x_r.
    pub elastic_approach: f64,
    /// The shape.
    pub shape: UnloadingShape,
}

impl Recovered {
    /// The branch with this elastic approach.
    fn branch(&self, at: &PeakState, elastic_approach: f64) -> Unloading {
        let &PeakState { indentation, force, .. } = at;
        Unloading::new(Peak { indentation, force, elastic_approach }, self.shape)
    }

    /// ε, at most x and at most what the work of loading allows.
    fn bounded(&self, at: &PeakState) -> f64 {
        let &PeakState { indentation: x, force, spent, .. } = at;
        let raw = self.elastic_approach;
        let bounded = if raw > 0.0 { raw.min(x) } else { x };
        let bounded = bounded.min((self.branch(at, bounded).exponent + 1.0) * spent / force);
        if bounded < (1.0 - NO_DENT) * x { bounded } else { x }
    }

    /// Refuses formulas that break a limit by more than [`LARGEST_CUT`].
    fn accept(&self, at: &PeakState) -> Result<(), OutsideLaw> {
        let &PeakState { indentation: x, force, spent, .. } = at;
        let refuse = |problem| Err(OutsideLaw::Range { indentation: x, problem });
        let raw = self.elastic_approach;
        if raw.is_nan() || raw <= 0.0 {
            return refuse("its residual indentation is the whole indentation or more");
        }
        if raw > (1.0 + LARGEST_CUT) * x {
            return refuse("its residual indentation is negative");
        }
        let bounded = raw.min(x);
        let given_back = force * bounded / (self.branch(at, bounded).exponent + 1.0);
        if given_back > (1.0 + LARGEST_CUT) * spent {
            return refuse("it gives back more energy than was spent");
        }
        Ok(())
    }
}

/// The rule of Hertz-type unloading, n = 3/2, with this elastic approach.
pub(super) fn hertzian(elastic_approach: impl Fn(PeakState) -> f64 + Send + Sync + 'static) -> RecoveryRule {
    let shape = UnloadingShape::Power(1.5);
    Arc::new(move |peak| Recovered { elastic_approach: elastic_approach(peak), shape })
}

/// The unloading from a peak.
pub type RecoveryRule = Arc<dyn Fn(PeakState) -> Recovered + Send + Sync>;

/// a/R up to which a sphere may be taken for the paraboloid of Hertz: at 0.3 its force is 1 % larger than that of the sphere
/// itself (Sneddon 1965, a rigid one), at 0.45 it is 2 %.
pub const WIDEST_PARABOLOID: f64 = 0.3;

/// The loading half of a law.
#[derive(Clone)]
pub struct Loading {
    /// f(x).
    pub curve: Curve,
    /// x up to which it is elastic.
    pub elastic_until: f64,
    /// x up to which a peak can be on it: beyond, the law has no answer.
    pub holds_until: f64,
    /// The range of x that its authors state, if they do.
    pub stated: Option<(f64, f64)>,
    /// Largest a/R of the data behind it, or of what it takes for granted.
    pub widest: f64,
    /// a/a_Y at (x, f) of the loading curve.
    pub radius: Arc<dyn Fn(f64, f64) -> f64 + Send + Sync>,
}

impl Loading {
    /// A loading curve that is Hertz's up to `elastic_until` and holds everywhere beyond.
    pub fn new(curve: Curve, elastic_until: f64, radius: impl Fn(f64, f64) -> f64 + Send + Sync + 'static) -> Self {
        let (holds_until, widest) = (f64::INFINITY, WIDEST_PARABOLOID);
        let curve = curve.with_crossings_of_panels();
        Self { curve, elastic_until, holds_until, stated: None, widest, radius: Arc::new(radius) }
    }
}

/// A peak, or a whole impact, that the law has no answer for.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum OutsideLaw {
    /// Outside the range of its formulas.
    #[error(
        "the law has no answer for a peak indentation of {} x the yield indentation: {problem}; use another law, or another speed or depth",
        four_digits(*.indentation)
    )]
    Range {
        /// x_m.
        indentation: f64,
        /// What is wrong there.
        problem: &'static str,
    },
    /// A flow curve that is none.
    #[error("the flow curve of the half-space: {0}")]
    Flow(#[from] FlowError),
    /// Only one half of a law.
    #[error(
        "the law \"{name}\" lacks its loading or its unloading, so that an impact has no answer; combine it with a law that has that half"
    )]
    Incomplete {
        /// Of the law.
        name: &'static str,
    },
}

/// A published law: both halves.
#[derive(Clone)]
pub struct Published {
    /// How it loads.
    pub loading: Loading,
    /// How it unloads.
    pub recovery: RecoveryRule,
}

impl fmt::Debug for Published {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Published").field("curve", &self.loading.curve).finish_non_exhaustive()
    }
}

impl PartialEq for Published {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.loading.radius, &other.loading.radius) && Arc::ptr_eq(&self.recovery, &other.recovery)
    }
}

impl Published {
    /// Whether loading to x is elastic, but for the last digit of x.
    fn is_elastic(&self, x: f64) -> bool {
        x <= self.loading.elastic_until * (1.0 + f64::EPSILON)
    }

    /// A point of the loading curve that took the work `spent`, and the unloading from it by the law's own formulas.
    fn recovered(&self, indentation: f64, force: f64, spent: f64) -> (PeakState, Recovered) {
        let radius = (self.loading.radius)(indentation, force);
        let at = PeakState { indentation, force, radius, elastic_approach: None, spent };
        (at, (self.recovery)(at))
    }

    /// ε, at most x and at most what the work of loading allows.
    #[cold] // keeps the closed form of the PLM fast: these calls are not inlined into it
    pub(super) fn elastic_approach(&self, x: f64, force: f64) -> f64 {
        self.unloading_from(x, force, self.loading.curve.work(x)).peak.elastic_approach
    }

    /// The branch from a point of the loading curve that took the work `spent`.
    #[cold]
    pub(super) fn unloading_from(&self, indentation: f64, force: f64, spent: f64) -> Unloading {
        if self.is_elastic(indentation) {
            return Unloading::power(Peak { indentation, force, elastic_approach: indentation }, 1.5);
        }
        let (at, recovered) = self.recovered(indentation, force, spent);
        recovered.branch(&at, recovered.bounded(&at))
    }

    /// The branch from a peak.
    #[cold]
    pub(super) fn unloading(&self, peak: Peak) -> Unloading {
        if self.is_elastic(peak.indentation) {
            return Unloading::power(peak, 1.5);
        }
        let spent = self.loading.curve.work(peak.indentation);
        Unloading::new(peak, self.recovered(peak.indentation, peak.force, spent).1.shape)
    }

    /// a/a_Y at a peak.
    #[cold]
    pub(super) fn contact_radius(&self, peak: &Peak) -> f64 {
        if self.is_elastic(peak.indentation) {
            return peak.indentation.sqrt();
        }
        (self.loading.radius)(peak.indentation, peak.force)
    }

    /// The range that its authors state, where a plastic peak is outside of it.
    pub(super) fn outside_stated(&self, peak: &Peak) -> Option<(f64, f64)> {
        let is_inside = |(from, to): (f64, f64)| (from..=to).contains(&peak.indentation);
        self.loading.stated.filter(|range| !self.is_elastic(peak.indentation) && !is_inside(*range))
    }

    /// Whether the law has an answer for a peak.
    #[cold]
    pub(super) fn accept(&self, peak: &Peak) -> Result<(), OutsideLaw> {
        let &Peak { indentation, force, elastic_approach } = peak;
        if self.is_elastic(indentation) {
            return Ok(());
        }
        if indentation > self.loading.holds_until {
            return Err(OutsideLaw::Range { indentation, problem: "outside the range of its loading formulas" });
        }
        let spent = self.loading.curve.work(indentation);
        // an approach that is well below both limits (n is at least 1) is that of the formulas
        if elastic_approach < indentation && force * elastic_approach < 1.9 * spent {
            return Ok(());
        }
        let (at, recovered) = self.recovered(indentation, force, spent);
        recovered.accept(&at)
    }
}
