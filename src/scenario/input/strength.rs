//! The strength of a body: the keys that give it, which are the same for sphere and half-space, and what follows from them.

use super::{Body, Input, Value};
use crate::contact::body::Material;
use crate::contact::law::plm::hardness_test::strength_of_hardness;
use crate::contact::strength::flow_curve::FlowCurve;
use crate::contact::strength::strain_rate_hardening::{RateForm, StrainRateHardening};
use crate::scenario::keys::{KeyId, NUMBER, body_key};

impl Body {
    /// The path of its yield strength.
    pub fn yield_strength(self) -> &'static str {
        self.select(["sphere.yield_strength", "half_space.yield_strength"])
    }

    /// The path of its hardness.
    pub fn hardness(self) -> &'static str {
        self.select(["sphere.hardness", "half_space.hardness"])
    }

    /// The table of its flow curve.
    pub fn flow_stress(self) -> &'static str {
        self.select(["sphere.flow_stress", "half_space.flow_stress"])
    }

    /// The table that says how its strength rises with the rate of strain.
    pub fn rate_table(self) -> &'static str {
        self.select(["sphere.rate", "half_space.rate"])
    }

    /// The numbers from which its strength follows, where its hardness is given.
    pub fn strength_numbers(self) -> [KeyId<NUMBER>; 4] {
        [
            body_key!(self, "hardness"),
            body_key!(self, "youngs_modulus"),
            body_key!(self, "poissons_ratio"),
            body_key!(self, "flow_stress.power.exponent"),
        ]
    }
}

impl Input {
    /// The elastic constants of a body.
    #[inline]
    pub fn material(&self, body: Body) -> Material {
        let number = |at| self.number(at).unwrap_or(f64::NAN);
        Material {
            youngs_modulus: number(body_key!(body, "youngs_modulus")),
            poissons_ratio: number(body_key!(body, "poissons_ratio")),
        }
    }

    /// How the strength of a body rises with the rate of strain, where all numbers of a form are given.
    #[inline]
    pub fn rate(&self, body: Body) -> Option<StrainRateHardening> {
        let form = if let Some(c) = self.number(body_key!(body, "rate.johnson_cook.c")) {
            let reference = self.number(body_key!(body, "rate.johnson_cook.reference"));
            RateForm::JohnsonCook { c, reference: reference.unwrap_or(StrainRateHardening::DEFAULT_REFERENCE_RATE) }
        } else {
            let rate = self.number(body_key!(body, "rate.cowper_symonds.rate"))?;
            RateForm::CowperSymonds { rate, exponent: self.number(body_key!(body, "rate.cowper_symonds.exponent"))? }
        };
        Some(StrainRateHardening {
            form,
            test_rate: self.number(body_key!(body, "rate.tested_at")).unwrap_or(StrainRateHardening::DEFAULT_TEST_RATE),
        })
    }

    /// How the strengths of sphere and half-space rise with the rate of strain.
    #[inline]
    pub fn rates(&self) -> [Option<StrainRateHardening>; 2] {
        Body::ALL.map(|body| self.rate(body))
    }

    /// True if a strength rises with the rate of strain.
    pub fn has_rate(&self) -> bool {
        self.rates().iter().any(Option::is_some)
    }

    /// The yield strength of a body \[Pa\], by itself or by its hardness. A flow curve that begins at it has its part in that.
    #[inline]
    pub fn yield_strength(&self, body: Body, flow: Option<&FlowCurve>) -> Option<f64> {
        match self.number(body_key!(body, "hardness")) {
            Some(mean_pressure) => Some(strength_of_hardness(mean_pressure, flow, &self.material(body))),
            None => self.number(body_key!(body, "yield_strength")),
        }
    }

    /// True if a strength of the body is given.
    pub fn has_strength(&self, body: Body) -> bool {
        self.number(body_key!(body, "yield_strength")).or(self.number(body_key!(body, "hardness"))).is_some()
    }

    /// True if a body has a strength, without which nothing yields.
    pub fn can_yield(&self) -> bool {
        Body::ALL.into_iter().any(|body| self.has_strength(body))
    }

    /// The flow curve of a body, if all its numbers are given.
    pub fn flow_curve(&self, body: Body) -> Option<FlowCurve> {
        let number = |at| self.number(at);
        if let Some(exponent) = number(body_key!(body, "flow_stress.power.exponent")) {
            return Some(FlowCurve::Power { exponent });
        }
        let saturation = number(body_key!(body, "flow_stress.voce.saturation"));
        if let Some((saturation, rate)) = saturation.zip(number(body_key!(body, "flow_stress.voce.rate"))) {
            return Some(FlowCurve::Voce { saturation, rate });
        }
        if let Some(slope) = number(body_key!(body, "flow_stress.linear.slope")) {
            return Some(FlowCurve::Linear { slope });
        }
        let points = self.value(body_key!(body, "flow_stress.points"));
        if let Some(Value::Curve(curve)) = points.or_else(|| self.value(body_key!(body, "flow_stress.table"))) {
            Some(curve.clone())
        } else {
            None
        }
    }

    /// Puts the strength itself in place of what it follows from, and the points of a file in place of the file.
    pub(in crate::scenario) fn replace_strength(&mut self, body: Body, strength: Option<f64>) {
        self.set(body_key!(body, "yield_strength"), strength);
        if let Some(curve) = self.value(body_key!(body, "flow_stress.table")).cloned() {
            self.set_value(body_key!(body, "flow_stress.points"), Some(curve));
            self.set_value(body_key!(body, "flow_stress.table"), None);
        }
    }
}
