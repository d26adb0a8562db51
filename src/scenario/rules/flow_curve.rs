//! `flow_stress` of a body: its hardening, and which keys may be combined with it.

use crate::contact::law::LawChoice;
use crate::contact::strength::flow_curve::FlowCurve;
use crate::error::Error;
use crate::scenario::Scenario;
use crate::scenario::input::read_input::names_in_table;
use crate::scenario::input::{Body, Input, NumericKey};
use crate::scenario::keys::ALL_KEYS;
use crate::units::{Dimension, format_result};

/// The four forms of a curve.
const FLOW_CURVE_EXAMPLE: &str = "power = { exponent = 0.1 }, voce = { saturation = 1.5, rate = 15 }, linear = { slope = \"4.2 GPa\" }, points = [[0.002, \"300 MPa\"], [0.01, \"340 MPa\"]] or table = \"flow.csv\"";

impl Scenario {
    /// Refuses two forms of a flow curve, a missing form, and a form that lacks a number.
    pub(in crate::scenario) fn check_flow(&self, input: &Input) -> Result<(), Error> {
        Body::ALL.into_iter().try_for_each(|body| self.check_curve(input, body.flow_stress()))
    }

    fn check_curve(&self, input: &Input, table: &str) -> Result<(), Error> {
        let path = |form: &str| format!("{table}.{form}");
        let mut forms = names_in_table(table).into_iter().filter(|form| self.origin(&path(form)).is_given_or_varies());
        let Some(form) = forms.next() else {
            return if self.is_given(table) {
                Err(self.document.refusal(table, format!("no flow curve is given. Use one of {FLOW_CURVE_EXAMPLE}.")))
            } else {
                Ok(())
            };
        };
        if let Some(second) = forms.next() {
            return Err(self.document.refuse_both(&path(form), &path(second)));
        }
        self.check_numbers(input, &path(form))
    }

    /// Refuses a form of a flow curve, or of a rate, that lacks a number; numbers with a default may be omitted.
    pub(in crate::scenario) fn check_numbers(&self, input: &Input, form: &str) -> Result<(), Error> {
        let begin = format!("{form}.");
        let needed = ALL_KEYS.iter().filter(|key| key.path.starts_with(&begin) && key.default.is_empty());
        let is_missing = |key: &NumericKey| input.number(*key).is_none();
        let missing = needed.filter_map(|key| NumericKey::find(key.path)).find(is_missing);
        match missing.and_then(|key| key.path().rsplit_once('.')) {
            Some((table, name)) => Err(self.document.missing_key(table, name)),
            None => Ok(()),
        }
    }

    /// Refuses laws and keys that cannot be combined with a flow curve.
    pub(in crate::scenario) fn check_strength(&self, input: &Input) -> Result<(), Error> {
        Body::ALL.into_iter().try_for_each(|body| self.check_strength_of(input, body))
    }

    fn check_strength_of(&self, input: &Input, body: Body) -> Result<(), Error> {
        let varies = |key: &str| self.origin(key).varies;
        let (yield_strength, hardness) = (body.yield_strength(), body.hardness());
        let (sphere, half_space) = input.bodies(&input.law());
        let strength = body.select([sphere.yield_strength, half_space.yield_strength]);
        if strength.is_some_and(f64::is_nan) && !varies(hardness) {
            let modulus = format_result(input.material(body).youngs_modulus, Dimension::Pressure);
            let message = format!(
                "is too high: an indenter would cause only elastic contact in a body with Young's modulus {modulus}. Check the units."
            );
            return Err(self.document.refusal(hardness, message));
        }
        let Some(flow) = input.flow_curve(body) else { return Ok(()) };
        let refuse = |message: &str| Err(self.document.refusal(body.flow_stress(), message));
        if !matches!(input.named_law, LawChoice::Plm(_)) {
            let name = input.named_law.name();
            return refuse(&format!(
                "a flow curve requires the law plm, and the law is {name}. Use plm, or remove this table."
            ));
        }
        if varies("law") {
            return refuse("a flow curve requires the law plm. Remove this table, or the axis \"law\".");
        }
        let Some(strength) = strength else {
            return refuse(
                "requires a yield_strength, the stress at plastic strain 0. Add the yield_strength of the body.",
            );
        };
        if (self.is_given(hardness) || varies(hardness)) && !matches!(flow, FlowCurve::Power { .. }) {
            return refuse("a hardness can be combined with flow_stress.power only. Give yield_strength instead.");
        }
        if flow.last_strain().is_some() && (varies(yield_strength) || varies(hardness)) {
            return refuse(
                "the yield strength cannot vary if flow_stress.points or flow_stress.table is given. Use power or voce.",
            );
        }
        let modulus = body.select([sphere.material, half_space.material]).youngs_modulus;
        let sound = flow.check_start(strength).and_then(|()| flow.check_slope(modulus, strength));
        sound.or_else(|error| refuse(&error.to_string()))
    }
}
