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

pub mod coefficients;
pub mod contact_radius;
pub mod flattening;
pub mod hardening;
pub mod hardness;
pub mod lines;
pub mod rule;

use std::sync::{Arc, LazyLock};

use super::contact_law::{Bodies, ContactLaw};
use super::published::{Loading, PeakState, Recovered, Rules};
use super::{Law, OutsideLaw, Peak, UnloadingExponent, UnloadingShape};
use crate::curve::Curve;
use crate::material::Pair;
use crate::strength::flow::FlowCurve;
pub use coefficients::{CoefficientsError, PlmCoefficients, Provenance};
pub use flattening::Flattening;
pub use hardening::Hardening;
pub use lines::ElasticLine;
pub use rule::PlmRule;

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
    /// By how much the rate of strain raises their whole flow curves; the strengths of the bodies have it already.
    pub rate_factors: [f64; 2],
}

impl Default for Plm {
    fn default() -> Self {
        static BUILT_IN: LazyLock<Arc<PlmCoefficients>> =
            LazyLock::new(|| Arc::new(PlmCoefficients::built_in().clone()));
        let coefficients = Arc::clone(&BUILT_IN);
        Self { coefficients, exponent: UnloadingExponent::Paper, flow: [None, None], rate_factors: [1.0; 2] }
    }
}

impl Plm {
    /// The PLM of these coefficients, with this exponent.
    pub fn new(coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Self {
        Self { coefficients: Arc::new(coefficients.clone()), exponent, ..Self::default() }
    }

    pub fn of_bodies(&self, bodies: &Bodies) -> Law {
        let (loading, rule) = self.flattened(bodies);
        Law::plm(loading, rule)
    }

    /// The law of bodies of other strengths, whose loading is that of `law` in its own units (see [`Law::has_one_curve`]).
    pub(crate) fn of_same_curve(&self, law: &Law, bodies: &Bodies) -> Law {
        Law::plm(law.loading.clone(), self.coefficients.rule(&bodies.pair, bodies.yield_radius_ratio(), self.exponent))
    }

    fn halves(&self, bodies: &Bodies) -> (Curve, PlmRule) {
        let (pair, ratio) = (&bodies.pair, bodies.yield_radius_ratio());
        let (perfect, rule) = self.coefficients.halves(pair, ratio, self.exponent);
        let [sphere, half_space] = &self.flow;
        let flows = bodies.yield_point.flow;
        let Some(flow) = flows.of_softer([sphere, half_space]) else { return (perfect, rule) };
        let slow = bodies.yield_strength / flows.of_softer(self.rate_factors);
        let rise = flow.rise(slow, bodies.modulus());
        let hardening = Hardening::new(rise, ratio, self.coefficients.line_slopes(pair));
        (hardening.loading(&perfect), PlmRule { hardening: Some(hardening), ..rule })
    }

    /// The halves with the flat of a sphere that flows.
    fn flattened(&self, bodies: &Bodies) -> (Curve, PlmRule) {
        let (plain, rule) = self.halves(bodies);
        let Bodies { pair, yield_point, .. } = bodies;
        if yield_point.flow.sphere_share == 0.0 {
            return (plain, rule);
        }
        let (ratio, compliance) = (bodies.yield_radius_ratio(), pair.sphere_compliance);
        let plastic_from = self.coefficients.line_slopes(pair).plastic_from;
        let (curve, flattening) =
            Flattening::of(yield_point, compliance, ratio, plastic_from, plain, |x, force| rule.radii(x, force));
        (curve, PlmRule { flattening: Some(flattening), ..rule })
    }
}

impl ContactLaw for Plm {
    fn rules(&self, bodies: &Bodies) -> Rules {
        let (curve, rule) = self.halves(bodies);
        let (limits, of_unloading) = (rule.limits(), rule.clone());
        let radius = move |indentation, force| {
            let elastic_approach = rule.elastic_approach(indentation, force);
            rule.contact_radius(&Peak { indentation, force, elastic_approach })
        };
        let recovery = move |at: PeakState| {
            let of_plm = || of_unloading.elastic_approach(at.indentation, at.force);
            let elastic_approach = at.elastic_approach.unwrap_or_else(of_plm);
            let peak = |elastic_approach| Peak { indentation: at.indentation, force: at.force, elastic_approach };
            let exponent = match of_unloading.exponent {
                UnloadingExponent::Paper => 1.5,
                UnloadingExponent::Fixed(n) => n,
                UnloadingExponent::PressureShape => of_unloading.pressure_shape(&peak(elastic_approach)),
            };
            Recovered { elastic_approach, shape: UnloadingShape::Power(exponent) }
        };
        Rules::of(Loading { curve, limits, radius: Arc::new(radius) }, Arc::new(recovery))
    }

    fn law(&self, bodies: &Bodies) -> Result<Law, OutsideLaw> {
        Ok(self.of_bodies(bodies))
    }

    fn of_pair(&self, pair: &Pair) -> Result<Option<Law>, OutsideLaw> {
        let Some(bodies) = Bodies::new(pair) else { return Ok(None) };
        let flows = bodies.yield_point.flow;
        let [sphere, half_space] = &self.flow;
        if flows.is_of_both() && (sphere.is_some() || half_space.is_some()) {
            return Err(OutsideLaw::BothFlow { ratio: flows.ratio });
        }
        if let Some(flow) = flows.of_softer([sphere, half_space]) {
            flow.is_flatter_than(bodies.modulus(), bodies.yield_strength / flows.of_softer(self.rate_factors))?;
        }
        Ok(Some(self.of_bodies(&bodies)))
    }
}
