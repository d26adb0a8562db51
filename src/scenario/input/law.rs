//! The contact law of an input: the law that the scenario names, with its given numbers.

use std::sync::Arc;

use super::{Body, Input, Value};
use crate::contact::law::catalogue::jackson_green::HardnessFit;
use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::contact::pair::{ALONE_FROM, yield_factor};
use crate::contact::strength::flow_curve::FlowCurve;
use crate::numerics::comparison::is_below;
use crate::scenario::keys::{KeyId, NUMBER, body_key, key};

impl Input {
    /// The law, with its parameters and with the flow curves of the bodies.
    pub fn law(&self) -> LawChoice {
        let mut law = self.named_law.clone();
        let number = |at: KeyId<NUMBER>| self.number(at);
        let replace = |value: &mut f64, at: KeyId<NUMBER>| *value = number(at).unwrap_or(*value);
        match &mut law {
            LawChoice::Plm(law) => {
                law.exponent = match number(key!("law.plm.unloading_exponent")) {
                    None => law.exponent,
                    Some(f64::INFINITY) => UnloadingExponent::PressureShape,
                    Some(value) => UnloadingExponent::from_value(value),
                };
                if let Some(Value::Coefficients(table)) = self.value(key!("law.plm.coefficients")) {
                    law.coefficients = Arc::clone(table);
                }
                law.flow = self.flow_curves();
            }
            LawChoice::Thornton(law) => law.yield_pressure = number(key!("law.thornton.yield_pressure")),
            LawChoice::Stronge(law) => {
                replace(&mut law.yield_pressure_ratio, key!("law.stronge.yield_pressure_ratio"));
                replace(&mut law.unloading_factor, key!("law.stronge.unloading_factor"));
            }
            LawChoice::JacksonGreen(law) => {
                law.yield_factor = number(key!("law.jackson_green.yield_factor"));
                let hardness = self.word(key!("law.jackson_green.hardness"));
                law.hardness = hardness.map_or(law.hardness, |place| HardnessFit::ALL[place]);
            }
            LawChoice::KogutEtsion(law) => law.yield_factor = number(key!("law.kogut_etsion.yield_factor")),
            LawChoice::YigitChristoforou(law) => {
                law.yield_factor = number(key!("law.yigit_christoforou.yield_factor"));
            }
            LawChoice::MaLiu(law) => {
                replace(&mut law.hardness_ratio, key!("law.ma_liu.hardness_ratio"));
                replace(&mut law.transition_ratio, key!("law.ma_liu.transition_ratio"));
            }
            LawChoice::MesarovicJohnson(law) => {
                replace(&mut law.area_factor, key!("law.mesarovic_johnson.area_factor"));
            }
            LawChoice::WaltonBraun(law) => {
                replace(&mut law.loading_stiffness, key!("law.walton_braun.loading_stiffness"));
                replace(&mut law.stiffness_ratio, key!("law.walton_braun.stiffness_ratio"));
            }
            LawChoice::Johnson(law) => law.dynamic_pressure = number(key!("law.johnson.dynamic_pressure")),
            LawChoice::Hertz(_) | LawChoice::KogutKomvopoulos(_) | LawChoice::Brake(_) | LawChoice::Combined(_) => {}
        }
        law
    }

    /// The flow curves of the bodies. If both bodies yield, the law has no flow curve. The exponent of a material is then ignored, and the
    /// hardness alone gives the strength, at a plastic strain of 0.08.
    fn flow_curves(&self) -> [Option<FlowCurve>; 2] {
        let curves = Body::ALL.map(|body| self.flow_curve(body));
        let is_of_material = |body: Body| {
            let exponent = body_key!(body, "flow_stress.power.exponent");
            let mut choices = self.materials().iter().filter(|choice| choice.body == body);
            body.select([&curves[0], &curves[1]]).is_none()
                || choices.any(|choice| choice.defaults.iter().any(|(at, _)| *at == exponent))
        };
        if curves.iter().all(Option::is_none) || !Body::ALL.into_iter().all(is_of_material) {
            return curves;
        }
        let pressure = |body: Body| {
            let strength = self.yield_strength(body, body.select([&curves[0], &curves[1]]).as_ref())?;
            Some(strength * yield_factor(self.material(body).poissons_ratio))
        };
        match Body::ALL.map(pressure) {
            [Some(sphere), Some(half_space)]
                if is_below(sphere.max(half_space), ALONE_FROM * sphere.min(half_space)) =>
            {
                [None, None]
            }
            _ => curves,
        }
    }

    /// True if the flow curves of the law may depend on the strengths of the bodies.
    pub fn has_flow_of_materials(&self) -> bool {
        Body::ALL.into_iter().all(|body| self.has_strength(body))
            && Body::ALL.into_iter().any(|body| self.flow_curve(body).is_some())
    }

    /// True if the key belongs to the table of the law.
    pub fn is_law_key(&self, path: &str) -> bool {
        path.split('.').take(2).eq(["law", self.named_law.info().name])
    }
}
