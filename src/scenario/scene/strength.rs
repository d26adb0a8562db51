//! The strength of a body: the keys that give it, which are the same for sphere and half-space, and what follows from them.

use super::{At, Body, Input, NUMBER, OTHER, Value, known};
use crate::contact::law::plm::hardness::strength_of_hardness;
use crate::contact::material::Material;
use crate::contact::strength::flow::FlowCurve;
use crate::contact::strength::rate::{Form, Rate};

/// The keys of the strength of a body.
#[derive(Debug)]
pub struct StrengthKeys {
    /// The table of the flow curve.
    pub flow_stress: &'static str,
    pub yield_strength: At<NUMBER>,
    pub hardness: At<NUMBER>,
    pub exponent: At<NUMBER>,
    saturation: At<NUMBER>,
    rate: At<NUMBER>,
    slope: At<NUMBER>,
    points: At<OTHER>,
    table: At<OTHER>,
    pub modulus: At<NUMBER>,
    pub poissons_ratio: At<NUMBER>,
}

/// The keys that say how the strength of a body rises with the rate of strain.
#[derive(Debug)]
pub struct RateKeys {
    pub table: &'static str,
    /// The word in place of the table.
    pub word: At<OTHER>,
    pub c: At<NUMBER>,
    pub reference: At<NUMBER>,
    rate: At<NUMBER>,
    exponent: At<NUMBER>,
    tested_at: At<NUMBER>,
}

macro_rules! keys_of {
    ($body:literal) => {
        StrengthKeys {
            flow_stress: concat!($body, ".flow_stress"),
            yield_strength: known(concat!($body, ".yield_strength")),
            hardness: known(concat!($body, ".hardness")),
            exponent: known(concat!($body, ".flow_stress.power.exponent")),
            saturation: known(concat!($body, ".flow_stress.voce.saturation")),
            rate: known(concat!($body, ".flow_stress.voce.rate")),
            slope: known(concat!($body, ".flow_stress.linear.slope")),
            points: known(concat!($body, ".flow_stress.points")),
            table: known(concat!($body, ".flow_stress.table")),
            modulus: known(concat!($body, ".youngs_modulus")),
            poissons_ratio: known(concat!($body, ".poissons_ratio")),
        }
    };
}

macro_rules! rate_of {
    ($body:literal) => {
        RateKeys {
            table: concat!($body, ".rate"),
            word: known(concat!($body, ".rate")),
            c: known(concat!($body, ".rate.johnson_cook.c")),
            reference: known(concat!($body, ".rate.johnson_cook.reference")),
            rate: known(concat!($body, ".rate.cowper_symonds.rate")),
            exponent: known(concat!($body, ".rate.cowper_symonds.exponent")),
            tested_at: known(concat!($body, ".rate.tested_at")),
        }
    };
}

impl Body {
    /// The keys of its strength.
    #[inline]
    pub fn strength_keys(self) -> &'static StrengthKeys {
        const SPHERE: StrengthKeys = keys_of!("sphere");
        const HALF_SPACE: StrengthKeys = keys_of!("half_space");
        self.pick([&SPHERE, &HALF_SPACE])
    }

    /// The numbers from which its strength follows, where its hardness is given.
    pub fn strength_numbers(self) -> [At<NUMBER>; 4] {
        let keys = self.strength_keys();
        [keys.hardness, keys.modulus, keys.poissons_ratio, keys.exponent]
    }

    /// The keys that say how its strength rises with the rate of strain.
    #[inline]
    pub fn rate_keys(self) -> &'static RateKeys {
        const SPHERE: RateKeys = rate_of!("sphere");
        const HALF_SPACE: RateKeys = rate_of!("half_space");
        self.pick([&SPHERE, &HALF_SPACE])
    }
}

impl Input {
    /// The elastic constants of a body.
    #[inline]
    pub fn material(&self, body: Body) -> Material {
        let keys = body.strength_keys();
        let number = |at| self.number(at).unwrap_or(f64::NAN);
        Material { youngs_modulus: number(keys.modulus), poissons_ratio: number(keys.poissons_ratio) }
    }

    /// How the strength of a body rises with the rate of strain, where all numbers of a form are given.
    #[inline]
    pub fn rate(&self, body: Body) -> Option<Rate> {
        let keys = body.rate_keys();
        let number = |at| self.number(at);
        let form = match (number(keys.c), number(keys.rate), number(keys.exponent)) {
            (Some(c), ..) => {
                Form::JohnsonCook { c, reference: number(keys.reference).unwrap_or(Rate::USUAL_REFERENCE) }
            }
            (_, Some(rate), Some(exponent)) => Form::CowperSymonds { rate, exponent },
            _ => return None,
        };
        Some(Rate { form, tested_at: number(keys.tested_at).unwrap_or(Rate::USUAL_TEST) })
    }

    /// How the strengths of sphere and half-space rise with the rate of strain.
    #[inline]
    pub fn rates(&self) -> [Option<Rate>; 2] {
        Body::ALL.map(|body| self.rate(body))
    }

    /// True if a strength rises with the rate of strain.
    pub fn has_rate(&self) -> bool {
        self.rates().iter().any(Option::is_some)
    }

    /// The yield strength of a body \[Pa\], by itself or by its hardness. A flow curve that begins at it has its part in that.
    #[inline]
    pub fn yield_strength(&self, body: Body, flow: Option<&FlowCurve>) -> Option<f64> {
        let keys = body.strength_keys();
        match self.number(keys.hardness) {
            Some(mean_pressure) => Some(strength_of_hardness(mean_pressure, flow, &self.material(body))),
            None => self.number(keys.yield_strength),
        }
    }

    /// True if a strength of the body is given.
    pub fn has_strength(&self, body: Body) -> bool {
        let keys = body.strength_keys();
        self.number(keys.yield_strength).or(self.number(keys.hardness)).is_some()
    }

    /// True if a body has a strength, without which nothing yields.
    pub fn can_yield(&self) -> bool {
        Body::ALL.into_iter().any(|body| self.has_strength(body))
    }

    /// The flow curve of a body, if all its numbers are given.
    pub fn flow_curve(&self, body: Body) -> Option<FlowCurve> {
        let keys = body.strength_keys();
        let number = |at| self.number(at);
        if let Some(exponent) = number(keys.exponent) {
            return Some(FlowCurve::Power { exponent });
        }
        if let Some((saturation, rate)) = number(keys.saturation).zip(number(keys.rate)) {
            return Some(FlowCurve::Voce { saturation, rate });
        }
        if let Some(slope) = number(keys.slope) {
            return Some(FlowCurve::Linear { slope });
        }
        let (points, table) = (self.value(keys.points), || self.value(keys.table));
        if let Some(Value::Curve(curve)) = points.or_else(table) { Some(curve.clone()) } else { None }
    }

    /// Puts the strength itself in place of what it follows from, and the points of a file in place of the file.
    pub(super) fn fill_strength(&mut self, body: Body, strength: Option<f64>) {
        let keys = body.strength_keys();
        self.set(keys.yield_strength, strength);
        if let Some(curve) = self.value(keys.table).cloned() {
            self.put_value(keys.points, Some(curve));
            self.put_value(keys.table, None);
        }
    }
}
