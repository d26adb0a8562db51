//! The rules of a published law: contact radius along the loading curve, and unloading from a peak.
//!
//! No contact recovers more energy than it has absorbed, and no dent is higher than the surface. If the formulas of a law break
//! these rules, the elastic approach is reduced to the largest possible value. If they break them by more than [`MAX_CLIPPING`],
//! the law has no answer ([`LawError`]).
//!
//! The law has no answer for: `mesarovic_johnson` and `johnson` near yield (case 3 of Xie et al. 2024: below 14 yield
//! indentations); `stronge` between x = 1.1 and 2.5, where it would recover up to 17 % more energy than was spent; the
//! residual of Jackson, Chusoipin and Green beyond x = 10⁴, where δ_r > δ_m; and fits beyond a = R or δ = R/2.

use std::fmt;
use std::sync::Arc;

use thiserror::Error;

use super::{ContactState, Unloading, UnloadingShape};
use crate::contact::pair::ALONE_FROM;
use crate::contact::strength::flow_curve::FlowError;
use crate::numerics::comparison::is_above;
use crate::numerics::curve::LoadingCurve;
use crate::numerics::root::bisect;
use crate::units::{format_four_digits, format_percent};

/// The formulas of a law may exceed the approach, or the energy spent, by this fraction. Above it the law has no answer.
pub const MAX_CLIPPING: f64 = 0.05;

/// A point of a loading curve from which the contact unloads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedState {
    /// x_m.
    pub indentation: f64,
    /// f_m.
    pub force: f64,
    /// a_m/a_Y.
    pub contact_radius: f64,
    /// (E_s*/E*) δ_sm/δ_Y, if the indentation of the sphere is known, as from a measurement.
    pub elastic_approach: Option<f64>,
    /// W/(F_Y δ_Y): the work of loading.
    pub loading_work: f64,
}

impl LoadedState {
    /// The unloading branch from here by this rule.
    ///
    /// # Errors
    /// [`LawError`] where the law has no answer.
    pub fn unload(&self, recovery: &RecoveryRule) -> Result<Unloading, LawError> {
        let (unloading, problem) = self.clipped_unloading(recovery(*self));
        problem.map_or(Ok(unloading), |problem| Err(LawError::Range { ratio: self.indentation, problem }))
    }

    /// The branch whose ε is at most x and at most the limit of the work of loading; and this limit, if the formulas of the law
    /// exceed it by more than [`MAX_CLIPPING`].
    fn clipped_unloading(&self, raw: Recovery) -> (Unloading, Option<&'static str>) {
        let &Self { indentation, force, loading_work: spent, .. } = self;
        let branch =
            |elastic_approach| Unloading::new(ContactState { indentation, force, elastic_approach }, raw.shape);
        let approach = raw.elastic_approach;
        let reachable = if approach > 0.0 { approach.min(indentation) } else { indentation };
        let most = (branch(reachable).exponent + 1.0) * spent / force;
        let bounded = reachable.min(most);
        let problem = match () {
            () if approach.is_nan() || approach <= 0.0 => {
                Some("its residual indentation would be the whole indentation or more")
            }
            () if approach > (1.0 + MAX_CLIPPING) * indentation => Some("its residual indentation would be negative"),
            () if reachable > (1.0 + MAX_CLIPPING) * most => Some("the recovered energy would exceed the loading work"),
            () => None,
        };
        (branch(if bounded < (1.0 - NEGLIGIBLE_DENT) * indentation { bounded } else { indentation }), problem)
    }
}

/// A dent that is a smaller fraction of the indentation than this comes from rounding, and is ignored.
const NEGLIGIBLE_DENT: f64 = 1e-13;

/// The unloading from a peak by the formulas of the law, before the limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recovery {
    /// ε = x_m − x_r.
    pub elastic_approach: f64,
    pub shape: UnloadingShape,
}

/// The rule of Hertz-type unloading, n = 3/2, with this elastic approach.
pub fn hertz_unloading(elastic_approach: impl Fn(LoadedState) -> f64 + Send + Sync + 'static) -> RecoveryRule {
    let shape = UnloadingShape::Power(1.5);
    Arc::new(move |peak| Recovery { elastic_approach: elastic_approach(peak), shape })
}

pub type RecoveryRule = Arc<dyn Fn(LoadedState) -> Recovery + Send + Sync>;

/// a/R up to which the paraboloid of Hertz represents a sphere: at 0.3 the force of the paraboloid is 1 % larger than the force of
/// a rigid sphere (Sneddon 1965), at 0.45 it is 2 % larger.
pub const MAX_PARABOLOID_RADIUS_RATIO: f64 = 0.3;

/// The range in which a loading holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Validity {
    /// Loading is elastic up to this x, along Hertz's curve.
    pub elastic_until: f64,
    /// A peak may be up to this x; beyond, the law has no answer.
    pub max_indentation: f64,
    /// The range of x that the authors state, if they do.
    pub fitted_range: Option<(f64, f64)>,
    /// Largest a/R of the data behind the loading, or of its assumptions.
    pub max_radius_ratio: f64,
}

impl Validity {
    /// A loading that is elastic up to `elastic_until` and holds everywhere beyond.
    pub fn new(elastic_until: f64, max_radius_ratio: f64) -> Self {
        Self { elastic_until, max_indentation: f64::INFINITY, fitted_range: None, max_radius_ratio }
    }

    /// True if a contact with this a/R is too wide.
    pub fn is_exceeded(&self, radius_ratio: f64) -> bool {
        is_above(radius_ratio, self.max_radius_ratio)
    }
}

/// The loading half of a law.
#[derive(Clone)]
pub struct Loading {
    /// f(x).
    pub curve: Arc<LoadingCurve>,
    pub limits: Validity,
    /// a/a_Y at (x, f) of the loading curve.
    pub contact_radius: RadiusRule,
}

/// The contact radius a/a_Y at (x, f) of a loading curve.
pub type RadiusRule = Arc<dyn Fn(f64, f64) -> f64 + Send + Sync>;

impl Loading {
    /// A loading curve that is Hertz's up to `elastic_until` and holds everywhere beyond.
    pub fn new(
        curve: LoadingCurve,
        elastic_until: f64,
        contact_radius: impl Fn(f64, f64) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let limits = Validity::new(elastic_until, MAX_PARABOLOID_RADIUS_RATIO);
        let curve = if curve.has_polynomial_pieces() { curve.with_transit_series() } else { curve };
        Self { curve: Arc::new(curve), limits, contact_radius: Arc::new(contact_radius) }
    }
}

/// The two halves of a law.
#[derive(Clone)]
pub struct LawParts {
    /// The loading; [`LawError::Incomplete`] for a law that has only unloading.
    pub loading: Result<Loading, LawError>,
    pub recovery: RecoveryRule,
}

impl LawParts {
    pub fn new(loading: Loading, recovery: RecoveryRule) -> Self {
        Self { loading: Ok(loading), recovery }
    }
}

/// A peak, or a whole impact, for which the law has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum LawError {
    /// Outside the range of its formulas.
    #[error(
        "the law is not defined for a maximum indentation of {} times its yield indentation: {problem}. Use another law, or another speed or depth.",
        format_four_digits(*.ratio)
    )]
    Range {
        /// The peak indentation over the yield indentation of the law.
        ratio: f64,
        /// The reason, in words.
        problem: &'static str,
    },
    /// An unloading exponent that would recover too much energy.
    #[error(
        "with the unloading exponent {} and a maximum indentation of {} times the yield indentation, the recovered energy would exceed the loading work by {}. Use a larger exponent, or another speed or depth.",
        format_four_digits(*.requested), format_four_digits(*.ratio), format_percent(*.gain)
    )]
    Exponent {
        /// n.
        requested: f64,
        /// The peak indentation over the yield indentation of the law.
        ratio: f64,
        /// The recovered energy over the spent energy, minus 1.
        gain: f64,
    },
    /// A table of coefficients that breaks a rule.
    #[error("the coefficients of the law: {key} is not allowed: {rule}")]
    Coefficients {
        /// The position in the table.
        key: &'static str,
        /// The allowed values of the key.
        rule: &'static str,
    },
    /// The points or the numbers make no flow curve.
    #[error("the flow curve of the body that yields: {0}")]
    Flow(#[from] FlowError),
    /// A flow curve although both bodies yield.
    #[error(
        "both bodies yield (strength ratio {}, below {ALONE_FROM}), and a flow curve can be used only if one body yields. Give both bodies a yield_strength at the strain of the impact, without flow_stress, or increase the ratio to at least {ALONE_FROM}.",
        format_four_digits(*.ratio)
    )]
    BothFlow {
        /// The strength of the harder body over that of the softer, as pressures at first yield.
        ratio: f64,
    },
    #[error(
        "the law \"{name}\" defines only loading or only unloading. Use [law.combined] with a law that has the other half."
    )]
    Incomplete { name: &'static str },
}

/// The rules of a published law beyond its elastic regime.
#[derive(Clone)]
pub struct PublishedRule {
    /// a/a_Y of its loading.
    pub contact_radius: RadiusRule,
    pub recovery: RecoveryRule,
}

impl fmt::Debug for PublishedRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Published").finish_non_exhaustive()
    }
}

impl PublishedRule {
    /// A point of the loading curve with the loading work `spent`.
    fn loaded_state(&self, indentation: f64, force: f64, spent: f64) -> LoadedState {
        let radius = (self.contact_radius)(indentation, force);
        LoadedState { indentation, force, contact_radius: radius, elastic_approach: None, loading_work: spent }
    }

    /// The branch from a point of the loading curve with the loading work `spent`.
    #[cold] // keeps the closed form of the PLM fast: these calls are not inlined into it
    pub(super) fn unload(&self, indentation: f64, force: f64, spent: f64) -> Unloading {
        let at = self.loaded_state(indentation, force, spent);
        at.clipped_unloading((self.recovery)(at)).0
    }

    /// True if the elastic approach at a point of the loading curve is one of the limits, and not the approach of the formulas.
    #[cold]
    pub(super) fn limits_approach(&self, indentation: f64, force: f64, spent: f64) -> bool {
        let at = self.loaded_state(indentation, force, spent);
        let raw = (self.recovery)(at);
        at.clipped_unloading(raw).0.peak.elastic_approach != raw.elastic_approach
    }

    /// Why the law has no answer for a peak with the loading work `spent`; `None` if it has an answer.
    #[cold]
    pub(super) fn failure_reason(&self, peak: &ContactState, spent: f64) -> Option<&'static str> {
        let &ContactState { indentation, force, elastic_approach } = peak;
        // an approach well below both limits (n is at least 1) is the approach of the formulas
        if elastic_approach < indentation && force * elastic_approach < 1.9 * spent {
            return None;
        }
        let at = self.loaded_state(indentation, force, spent);
        at.clipped_unloading((self.recovery)(at)).1
    }
}

/// Where two printed pieces that do not join intersect: the zero of an excess that is positive at `from`. `None` if the excess
/// is not positive at `from`, or has no zero before `until`.
pub(super) fn intersection(excess: impl Fn(f64) -> f64, from: f64, until: f64) -> Option<f64> {
    /// Steps of the search.
    const GROWTH: f64 = 1.02;
    let mut high = from;
    while excess(high) > 0.0 {
        high *= GROWTH;
        if high.is_nan() || high >= GROWTH * until {
            return None;
        }
    }
    (high > from).then(|| bisect(high / GROWTH, high, |x| excess(x) > 0.0).1)
}
