//! Most tests use these names.

pub use plm_impact::contact::body::*;
pub use plm_impact::contact::law::*;
pub use plm_impact::contact::pair::*;
pub use plm_impact::impact::*;
pub use proptest::prelude::*;

pub use approx::assert_relative_eq;
pub use plm_impact::bench::problems::problems;
pub use plm_impact::calibrate::Fit;
pub use plm_impact::contact::law::catalogue::jackson_green::{HardnessFit, JacksonGreen};
pub use plm_impact::contact::law::catalogue::kogut_etsion::KogutEtsion;
pub use plm_impact::contact::law::catalogue::kogut_komvopoulos::KogutKomvopoulos;
pub use plm_impact::contact::law::catalogue::stronge::Stronge;
pub use plm_impact::contact::law::catalogue::thornton::Thornton;
pub use plm_impact::contact::law::catalogue::walton_braun::WaltonBraun;
pub use plm_impact::contact::law::published::Recovery;
pub use plm_impact::contact::strength::flow_curve::FlowCurve;
pub use plm_impact::error::Error;
pub use plm_impact::files::progress::Progress;
pub use plm_impact::impact::indentation::{Indentation, IndentationError, StaticContact};
pub use plm_impact::impact::series::{ImpactSeries, SeriesMode, SpotMode};
pub use plm_impact::materials::{Property, all_materials, find};
pub use plm_impact::numerics::ode::damped_stepper::DampedStepper;
pub use plm_impact::numerics::ode::rk8::Rk8;
pub use plm_impact::numerics::ode::{IntegrationError, Integrator};
pub use plm_impact::numerics::power::nan_max;
pub use plm_impact::report::run;
pub use plm_impact::scenario::input::{Input, NumericKey};
pub use plm_impact::scenario::keys::ALL_KEYS;
pub use plm_impact::scenario::plan::Cases;
pub use plm_impact::scenario::{Kind, Override, Scenario};
pub use plm_impact::table::evaluator::{Evaluator, RowFailure, Rows};
pub use plm_impact::validate::comparison::max_magnitude;
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
pub fn number_of_key(input: &Input, path: &str) -> Option<f64> {
    input.number(NumericKey::find(path).unwrap())
}
