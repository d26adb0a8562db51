//! PLM loading: a piecewise-linear loading curve that gives force and elastic approach (Weng et al. 2021 in form).
//!
//! The original coefficients are printed in no public text. The built-in ones (`plm/coefficients.toml`,
//! [`PlmCoefficients::built_in`]) were fitted to finite-element curves, keeping the form: straight characteristics for
//! force, approach, and the shares of sphere and half-space. Whoever has better ones names a file in the scenario.
//!
//! ```text
//! f(x) = x^1.5                      up to the first knot x_1, then f = f_i + s_i (x − x_i)
//! ε    = min(x, ε_line(f))          for x > 1;  ε = x before
//! ε_line: ε = ε_i + s (A − A_i) with A = f/ε, so  ε = (b + √(b² + 4 s f))/2,  b = ε_i − s A_i
//! ```
//!
//! With the unloading of Xie et al. (2024) it is one of the laws of the [`catalogue`](super::catalogue), and either half can
//! be combined with the other half of another law.

pub mod approach;
pub mod coefficients;
pub mod contact_radius;
pub mod flattening;
pub mod hardening;
pub mod hardness_test;
pub mod unloading_rule;

use std::sync::{Arc, LazyLock};

use super::contact_law::{ContactLaw, YieldingPair};
use super::published::{LawParts, LoadedState, Loading};
use super::{Law, LawError, UnloadingExponent};
use crate::contact::pair::Pair;
use crate::contact::strength::flow_curve::FlowCurve;
use crate::numerics::curve::{Cached, LoadingCurve};
pub use approach::ApproachPolyline;
pub use coefficients::{CoefficientSource, CoefficientsError, PlmCoefficients};
pub use flattening::Flattening;
pub use hardening::Hardening;
pub use unloading_rule::PlmUnloadingRule;

/// The piecewise-linear model with the paper's unloading (Eqs. 19-25, [`super::unloading`]).
///
/// The paper's unloading needs the sphere's own indentation at the peak. Behind the loading of another law that is not known
/// unless it was measured; the elastic approach of the PLM at the same state stands for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Plm {
    /// The coefficients of loading, elastic approach and contact radius.
    pub coefficients: Arc<PlmCoefficients>,
    /// n of the unloading branch.
    pub exponent: UnloadingExponent,
    /// How sphere and half-space harden; `None` for a constant strength.
    pub flow: [Option<FlowCurve>; 2],
    /// By how much the rate of strain raises the whole flow curve of the body that yields; its strength has it already.
    pub rate_factor: f64,
    /// The curve of the first pair, with the coefficients and the κ² that it was made of: pairs of the same share it.
    pub cached_curve: Cached<(Arc<PlmCoefficients>, f64, Arc<LoadingCurve>)>,
}

impl Default for Plm {
    fn default() -> Self {
        Self {
            coefficients: Arc::clone(Self::built_in()),
            exponent: UnloadingExponent::Paper,
            flow: [None, None],
            rate_factor: 1.0,
            cached_curve: Cached::default(),
        }
    }
}

impl Plm {
    /// The built-in coefficients, which all laws share.
    fn built_in() -> &'static Arc<PlmCoefficients> {
        static BUILT_IN: LazyLock<Arc<PlmCoefficients>> =
            LazyLock::new(|| Arc::new(PlmCoefficients::built_in().clone()));
        &BUILT_IN
    }

    /// The PLM of these coefficients, with this exponent.
    pub fn new(coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Self {
        Self { coefficients: Arc::new(coefficients.clone()), exponent, ..Self::default() }
    }

    pub fn law_for_yielding_pair(&self, bodies: &YieldingPair) -> Law {
        self.unloading_by(self, bodies)
    }

    /// The loading of this PLM with the unloading of another one, or of itself.
    pub(super) fn unloading_by(&self, other: &Self, bodies: &YieldingPair) -> Law {
        let (loading, mut rule) = self.with_flat(bodies);
        if !std::ptr::eq(self, other) {
            (_, rule) = other.with_flat(bodies);
        }
        Law::plm(loading, rule)
    }

    /// Checks that the coefficients and the flow curves make a law for these bodies.
    ///
    /// # Errors
    /// [`LawError::Coefficients`], [`LawError::BothFlow`] and [`LawError::Flow`].
    pub(super) fn check(&self, bodies: &YieldingPair) -> Result<(), LawError> {
        // the coefficients that a file or the program brings are checked where they are read
        if !std::ptr::eq(&raw const *self.coefficients, &raw const **Self::built_in()) {
            self.coefficients.check_rules()?;
        }
        let flows = bodies.yield_point.yield_partition;
        let [sphere, half_space] = &self.flow;
        if flows.is_shared() && (sphere.is_some() || half_space.is_some()) {
            return Err(LawError::BothFlow { ratio: flows.ratio });
        }
        if let Some(flow) = flows.for_softer([sphere, half_space]) {
            flow.check_slope(bodies.modulus(), bodies.yield_point.strength / self.rate_factor)?;
        }
        Ok(())
    }

    /// The law of bodies of other strengths, whose loading is that of `law` in its own units (see [`Law::has_universal_curve`]).
    pub(crate) fn rescaled_law(&self, law: &Law, bodies: &YieldingPair) -> Law {
        let rule = self.coefficients.unloading_rule(&bodies.pair, bodies.yield_radius_ratio(), self.exponent);
        Law::plm(Arc::clone(&law.loading), rule)
    }

    /// The curve of a half-space that does not harden.
    fn perfectly_plastic_curve(&self, pair: &Pair) -> Arc<LoadingCurve> {
        let [kappa, _] = pair.law_shares();
        let square = kappa * kappa;
        let curve = || Arc::new(self.coefficients.force.curve(square));
        let (table, square_of_first, first) =
            self.cached_curve.0.get_or_init(|| (Arc::clone(&self.coefficients), square, curve()));
        if *square_of_first == square && Arc::ptr_eq(table, &self.coefficients) { Arc::clone(first) } else { curve() }
    }

    fn without_flat(&self, bodies: &YieldingPair) -> (Arc<LoadingCurve>, PlmUnloadingRule) {
        let (pair, ratio) = (&bodies.pair, bodies.yield_radius_ratio());
        let (perfect, rule) =
            (self.perfectly_plastic_curve(pair), self.coefficients.unloading_rule(pair, ratio, self.exponent));
        let [sphere, half_space] = &self.flow;
        let flows = bodies.yield_point.yield_partition;
        let Some(flow) = flows.for_softer([sphere, half_space]) else { return (perfect, rule) };
        let slow = bodies.yield_point.strength / self.rate_factor;
        let rise = flow.normalise(slow, bodies.modulus());
        let hardening = Hardening::new(rise, ratio, self.coefficients.approach_slopes(pair));
        (Arc::new(hardening.loading_curve(&perfect)), PlmUnloadingRule { hardening: Some(hardening), ..rule })
    }

    /// The halves with the flats of balls that flow.
    fn with_flat(&self, bodies: &YieldingPair) -> (Arc<LoadingCurve>, PlmUnloadingRule) {
        let (plain, rule) = self.without_flat(bodies);
        let pair = &bodies.pair;
        if pair.balls.iter().all(|ball| ball.share * ball.curvature == 0.0) {
            return (plain, rule);
        }
        let [_, rho] = pair.law_shares();
        let (curve, flattening) = Flattening::new(
            pair,
            bodies.yield_radius_ratio(),
            self.coefficients.plastic_from(rho),
            plain,
            rule.hertz_equivalent_radii(),
            |x, equivalent| rule.contact_radius_at(x, equivalent),
        );
        (Arc::new(curve), PlmUnloadingRule { flattening: Some(flattening), ..rule })
    }
}

impl ContactLaw for Plm {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let (curve, rule) = self.with_flat(bodies);
        let (limits, of_radius) = (rule.validity(), rule.clone());
        let radius = move |x, force| of_radius.contact_radius(&of_radius.state(x, force));
        let loading = Loading { curve, limits, contact_radius: Arc::new(radius) };
        LawParts {
            loading: self.check(bodies).map(|()| loading),
            recovery: Arc::new(move |at: LoadedState| rule.recovery(&at)),
        }
    }

    fn law(&self, bodies: &YieldingPair) -> Result<Law, LawError> {
        self.check(bodies)?;
        Ok(self.law_for_yielding_pair(bodies))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::body::{HalfSpace, Material, Sphere};

    /// The curve that pairs share is that of their coefficients and of their κ², whichever pair came first.
    #[test]
    fn a_shared_curve_is_that_of_the_pair() {
        let loading_of = |plm: &Plm, modulus: f64, strength: f64| {
            let sphere = Sphere::elastic(5e-3, Material { youngs_modulus: modulus, poissons_ratio: 0.3 }, 7850.0);
            let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
            let half_space = HalfSpace::flat(steel, Some(strength));
            plm.law_for_pair(&Pair::try_new(&sphere, &half_space).unwrap()).unwrap().loading
        };
        let plm = Plm::default();
        let first = loading_of(&plm, 210e9, 3e8);
        assert!(Arc::ptr_eq(&first, &loading_of(&plm, 210e9, 5e8)));
        assert_eq!(loading_of(&plm, 600e9, 3e8), loading_of(&Plm::default(), 600e9, 3e8));
        assert_ne!(loading_of(&plm, 600e9, 3e8), first);
        let mut coefficients = PlmCoefficients::built_in().clone();
        coefficients.force.slope[0] *= 1.1;
        let other = Plm::new(&coefficients, plm.exponent);
        let changed = Plm { coefficients: Arc::clone(&other.coefficients), ..plm };
        assert_eq!(loading_of(&changed, 210e9, 3e8), loading_of(&other, 210e9, 3e8));
        assert_ne!(loading_of(&changed, 210e9, 3e8), first);
    }
}
