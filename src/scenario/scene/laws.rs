//! The contact law of an input: the law that the scenario names, with the numbers that it gives to it.

use std::sync::Arc;

use super::{At, Body, Input, NUMBER, Value, at};
use crate::contact::law::catalogue::jackson_green::Hardness;
use crate::contact::law::{LawChoice, UnloadingExponent};

impl Input {
    /// The law, with its parameters and with the flow curves of the bodies.
    pub fn law(&self) -> LawChoice {
        let mut law = self.named_law.clone();
        let number = |at: At<NUMBER>| self.number(at);
        let replace = |value: &mut f64, at: At<NUMBER>| *value = number(at).unwrap_or(*value);
        match &mut law {
            LawChoice::Plm(law) => {
                law.exponent = match number(at!("law.plm.unloading_exponent")) {
                    None => law.exponent,
                    Some(f64::INFINITY) => UnloadingExponent::PressureShape,
                    Some(value) => UnloadingExponent::of(value),
                };
                if let Some(Value::Coefficients(table)) = self.value(at!("law.plm.coefficients")) {
                    law.coefficients = Arc::clone(table);
                }
                law.flow = Body::ALL.map(|body| self.flow_curve(body));
            }
            LawChoice::Thornton(law) => law.yield_pressure = number(at!("law.thornton.yield_pressure")),
            LawChoice::Stronge(law) => {
                replace(&mut law.yield_pressure_ratio, at!("law.stronge.yield_pressure_ratio"));
                replace(&mut law.unloading_factor, at!("law.stronge.unloading_factor"));
            }
            LawChoice::JacksonGreen(law) => {
                law.yield_factor = number(at!("law.jackson_green.yield_factor"));
                let hardness = self.word(at!("law.jackson_green.hardness"));
                law.hardness = hardness.map_or(law.hardness, |place| Hardness::ALL[place]);
            }
            LawChoice::KogutEtsion(law) => law.yield_factor = number(at!("law.kogut_etsion.yield_factor")),
            LawChoice::YigitChristoforou(law) => {
                law.yield_factor = number(at!("law.yigit_christoforou.yield_factor"));
            }
            LawChoice::MaLiu(law) => {
                replace(&mut law.hardness_ratio, at!("law.ma_liu.hardness_ratio"));
                replace(&mut law.transition_ratio, at!("law.ma_liu.transition_ratio"));
            }
            LawChoice::MesarovicJohnson(law) => {
                replace(&mut law.area_factor, at!("law.mesarovic_johnson.area_factor"));
            }
            LawChoice::WaltonBraun(law) => {
                replace(&mut law.loading_stiffness, at!("law.walton_braun.loading_stiffness"));
                replace(&mut law.stiffness_ratio, at!("law.walton_braun.stiffness_ratio"));
            }
            LawChoice::Johnson(law) => law.dynamic_pressure = number(at!("law.johnson.dynamic_pressure")),
            LawChoice::Hertz(_) | LawChoice::KogutKomvopoulos(_) | LawChoice::Brake(_) | LawChoice::Combined(_) => {}
        }
        law
    }

    /// True if the key stands in the table of the law.
    pub fn is_of_law(&self, path: &str) -> bool {
        path.split('.').take(2).eq(["law", self.named_law.about().name])
    }
}
