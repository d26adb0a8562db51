//! What most tests use.

pub use plm_impact::impact::*;
pub use plm_impact::law::*;
pub use plm_impact::material::*;
pub use proptest::prelude::*;

pub use approx::assert_relative_eq;
pub use plm_impact::bench::problems::problems;
pub use plm_impact::calibrate::Fit;
pub use plm_impact::error::Error;
pub use plm_impact::indentation::{Indentation, IndentationError, Indenter, StaticContact};
pub use plm_impact::integrate::damped::Damped;
pub use plm_impact::integrate::rk8::Rk8;
pub use plm_impact::integrate::{IntegrationError, Integrator};
pub use plm_impact::law::catalogue::jackson_green::{Hardness, JacksonGreen};
pub use plm_impact::law::catalogue::kogut_etsion::KogutEtsion;
pub use plm_impact::law::catalogue::kogut_komvopoulos::KogutKomvopoulos;
pub use plm_impact::law::catalogue::stronge::Stronge;
pub use plm_impact::law::catalogue::thornton::Thornton;
pub use plm_impact::law::catalogue::walton_braun::WaltonBraun;
pub use plm_impact::law::published::Recovered;
pub use plm_impact::materials::{Property, all, find};
pub use plm_impact::math::power::max_or_nan;
pub use plm_impact::plan::Cases;
pub use plm_impact::progress::Counter;
pub use plm_impact::repeat::{Drive, Place, Repeat};
pub use plm_impact::run;
pub use plm_impact::scenario::{Kind, Scenario};
pub use plm_impact::scene::{EVERY_KEY, Input, Key};
pub use plm_impact::strength::flow::FlowCurve;
pub use plm_impact::sweep::evaluator::{Evaluator, Failure, Rows};
pub use plm_impact::validation::comparison::largest;
pub use roxmltree::Document;
pub use serde_json::{Value, json};
pub use std::fs;
pub use std::path::Path;

pub use super::command::*;
pub use super::picture::*;
pub use super::reference::records;
pub use super::run;
pub use super::*;

/// The number that an input has for this key.
pub fn given(input: &Input, path: &str) -> Option<f64> {
    Key::find(path).unwrap().get(input)
}
