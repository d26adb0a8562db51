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
pub mod deferred_curve;
pub mod depth;
pub mod flattening;
pub mod hardening;
pub mod hardness_test;
pub mod poisson;
pub mod unloading_rule;

use std::sync::{Arc, LazyLock};

use super::contact_law::{ContactLaw, YieldingPair};
use super::published::{LawParts, LoadedState, Loading, Validity};
use super::{Law, LawError, UnloadingExponent};
use crate::contact::pair::Pair;
use crate::contact::strength::flow_curve::FlowCurve;
use crate::numerics::curve::{Cached, LoadingCurve};
pub use approach::ApproachPolyline;
pub use coefficients::{CoefficientSource, CoefficientsError, PlmCoefficients};
pub use deferred_curve::DeferredCurve;
pub use depth::Depth;
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
    /// The loading of the first pair: pairs with the same source share it.
    pub shared_loading: Cached<(LoadingSource, Arc<LoadingCurve>)>,
}

/// The numbers that the loading of shallow dents is made of: the coefficients, κ² and c ([`poisson`]).
#[derive(Debug, Clone)]
pub struct LoadingSource(Arc<PlmCoefficients>, f64, f64);

impl PartialEq for LoadingSource {
    /// Tables are equal only if they are the same table.
    fn eq(&self, other: &Self) -> bool {
        self.1 == other.1 && self.2 == other.2 && Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Default for Plm {
    fn default() -> Self {
        Self {
            coefficients: Arc::clone(Self::built_in()),
            exponent: UnloadingExponent::Paper,
            flow: [None, None],
            rate_factor: 1.0,
            shared_loading: Cached::default(),
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
        let (shallow, rule) = self.for_bodies(bodies);
        Law::plm(shallow, rule)
    }

    /// The loading of this PLM with the unloading of another one.
    pub(super) fn unloading_by(&self, other: &Self, bodies: &YieldingPair) -> Law {
        let (shallow, rule) = self.for_bodies(bodies);
        let (_, of_other) = other.for_bodies(bodies);
        // the approach follows from the force of shallow dents of the loading
        let depth = of_other.depth.clone().map(|depth| depth.on(&shallow));
        Law {
            loading: DeferredCurve::new(Arc::clone(&shallow), &rule),
            ..Law::plm(shallow, Arc::new(PlmUnloadingRule { depth, ..(*of_other).clone() }))
        }
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

    /// The law of bodies of other strengths, whose loading in shallow dents is that of `law` in its own units (see
    /// [`Law::universal_curve`]).
    pub(crate) fn rescaled_law(&self, shallow: &Arc<LoadingCurve>, bodies: &YieldingPair) -> Law {
        let (pair, ratio) = (&bodies.pair, bodies.yield_radius_ratio());
        let rule = self.coefficients.unloading_rule(pair, ratio, self.exponent);
        let depth = self.coefficients.depth(pair, ratio, shallow);
        Law::plm(Arc::clone(shallow), Arc::new(PlmUnloadingRule { depth, ..rule }))
    }

    /// The loading of shallow dents in a half-space that does not harden.
    fn shallow_loading(&self, pair: &Pair) -> Arc<LoadingCurve> {
        let [kappa, _] = pair.law_shares();
        let (square, ratio) = (kappa * kappa, poisson::pressure_ratio(pair));
        let source = LoadingSource(Arc::clone(&self.coefficients), square, ratio);
        let loading = || self.coefficients.shallow_loading(square, ratio);
        let (first_source, first) = self.shared_loading.0.get_or_init(|| (source.clone(), loading()));
        if *first_source == source { first.clone() } else { loading() }
    }

    /// The loading of shallow dents, and how the pair loads and unloads at any depth. A body of constant strength comes first. Then
    /// hardening, the flats of balls that flow, and deep dents change what comes before.
    fn for_bodies(&self, bodies: &YieldingPair) -> (Arc<LoadingCurve>, Arc<PlmUnloadingRule>) {
        let YieldingPair { pair, yield_point } = bodies;
        let (flows, ratio, limits) =
            (yield_point.yield_partition, bodies.yield_radius_ratio(), self.coefficients.validity);
        let mut curve = self.shallow_loading(pair);
        let mut rule = self.coefficients.unloading_rule(pair, ratio, self.exponent);
        let [sphere, half_space] = &self.flow;
        if let Some(flow) = flows.for_softer([sphere, half_space]) {
            let rise = flow.normalise(yield_point.strength / self.rate_factor, bodies.modulus());
            let hardening = Hardening::new(rise, ratio, self.coefficients.approach_slopes(pair));
            curve = Arc::new(hardening.loading_curve(&curve));
            rule = PlmUnloadingRule { hardening: Some(hardening), max_radius_ratio: limits.hardening, ..rule };
        }
        if pair.balls.iter().any(|ball| ball.share * ball.curvature != 0.0) {
            let [_, rho] = pair.law_shares();
            let plastic_from = self.coefficients.plastic_from(rho);
            let radius = |x, equivalent| rule.contact_radius_at(x, equivalent);
            let equivalents = rule.hertz_equivalent_radii();
            let (flat_curve, flattening) = Flattening::new(pair, ratio, plastic_from, curve, equivalents, radius);
            curve = Arc::new(flat_curve);
            let max_radius_ratio = if flows.is_shared() { limits.both_yield } else { limits.yielding_sphere };
            rule = PlmUnloadingRule { flattening: Some(flattening), max_radius_ratio, ..rule };
        }
        rule.depth = self.coefficients.depth(pair, ratio, &curve);
        (curve, Arc::new(rule))
    }
}

impl ContactLaw for Plm {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let (shallow, rule) = self.for_bodies(bodies);
        let curve = rule.deep_curve().map_or(shallow, |deep| Arc::new(deep.clone()));
        let (limits, of_radius) = (Validity::new(1.0, rule.max_radius_ratio), Arc::clone(&rule));
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

    /// The curve that pairs share is that of their coefficients, their κ² and their Poisson's ratio, whichever pair came first.
    #[test]
    fn a_shared_curve_is_that_of_the_pair() {
        let loading_of = |plm: &Plm, modulus: f64, strength: f64, poissons_ratio: f64| {
            let sphere = Sphere::elastic(5e-3, Material { youngs_modulus: modulus, poissons_ratio: 0.3 }, 7850.0);
            let youngs_modulus = 210e9 / 0.91 * (1.0 - poissons_ratio * poissons_ratio);
            let half_space = HalfSpace::flat(Material { youngs_modulus, poissons_ratio }, Some(strength));
            Arc::clone(plm.law_for_pair(&Pair::try_new(&sphere, &half_space).unwrap()).unwrap().loading.shallow())
        };
        let plm = Plm::default();
        let first = loading_of(&plm, 210e9, 3e8, 0.3);
        assert!(Arc::ptr_eq(&first, &loading_of(&plm, 210e9, 5e8, 0.3)));
        for (modulus, poissons_ratio) in [(600e9, 0.3), (210e9, 0.1)] {
            let other = loading_of(&plm, modulus, 3e8, poissons_ratio);
            assert_eq!(other, loading_of(&Plm::default(), modulus, 3e8, poissons_ratio));
            assert_ne!(other, first);
        }
        let mut coefficients = PlmCoefficients::built_in().clone();
        coefficients.force.slope[0] *= 1.1;
        let other = Plm::new(&coefficients, plm.exponent);
        let changed = Plm { coefficients: Arc::clone(&other.coefficients), ..plm };
        assert_eq!(loading_of(&changed, 210e9, 3e8, 0.3), loading_of(&other, 210e9, 3e8, 0.3));
        assert_ne!(loading_of(&changed, 210e9, 3e8, 0.3), first);
    }
}
