//! `[half_space.rate]` and `[sphere.rate]`: how a strength rises with the strain rate, and which keys may be combined with it.

use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::materials::{Property, all_materials};
use crate::scenario::Scenario;
use crate::scenario::body_materials::takes_rate_from_material;
use crate::scenario::input::{Body, Input};
use crate::units::{format_four_digits, format_number};

/// The forms of strain-rate hardening.
const RATE_EXAMPLE: &str = "johnson_cook = { c = 0.014 } or cowper_symonds = { rate = \"6844 1/s\", exponent = 3.91 }";

impl Scenario {
    /// Refuses two forms, a missing form, a form that lacks a number or gives no strength, and keys that cannot be combined with it.
    pub(in crate::scenario) fn check_rates(&self, input: &Input) -> Result<(), Error> {
        let mut given = Body::ALL.into_iter().filter(|body| self.origin(body.rate_table()).is_given_or_varies());
        given.try_for_each(|body| self.check_rate(input, body))
    }

    fn check_rate(&self, input: &Input, body: Body) -> Result<(), Error> {
        let table = body.rate_table();
        let of_body = table.trim_end_matches(".rate");
        let refuse = |message: String| Err(self.refusal_where_varied(table, message));
        if takes_rate_from_material(input, body) && input.rate(body).is_none() {
            let known: Vec<&str> = all_materials()
                .iter()
                .filter(|entry| entry.get(Property::RateSensitivity).is_some())
                .map(|entry| &*entry.name)
                .collect();
            return refuse(format!(
                "rate = \"material\" is not available for the material of [{of_body}], only for {}. Give constants: {RATE_EXAMPLE}.",
                known.join(", ")
            ));
        }
        let forms = ["johnson_cook", "cowper_symonds"].map(|form| format!("{table}.{form}"));
        match forms.each_ref().map(|form| self.origin(form).is_given_or_varies()) {
            [true, true] => return Err(self.document.refuse_both(&forms[0], &forms[1])),
            [true, false] => self.check_numbers(input, &forms[0])?,
            [false, true] => self.check_numbers(input, &forms[1])?,
            // a material gives c of the first form
            [false, false] if takes_rate_from_material(input, body) => {}
            [false, false] => return refuse(format!("no strain-rate model is given. Write {RATE_EXAMPLE}.")),
        }
        if !input.has_strength(body) {
            return refuse(format!(
                "requires a yield strength in [{of_body}]. Add a yield strength, or remove this table."
            ));
        }
        if !matches!(input.named_law, LawChoice::Plm(_)) {
            let name = input.named_law.name();
            return refuse(format!(
                "strain-rate dependence requires the law plm, and the law is {name}. Use plm, or remove this table."
            ));
        }
        if self.origin("law").varies {
            return refuse(
                "strain-rate dependence requires the law plm. Remove this table, or the axis \"law\".".to_owned(),
            );
        }
        let Some(rate) = input.rate(body) else { return Ok(()) };
        let rise = rate.raw_factor(rate.test_rate);
        if rise > 0.0 {
            return Ok(());
        }
        refuse(format!(
            "the strain-rate factor 1 + c ln(rate/reference) at tested_at = {} 1/s is {}, and must be positive. Reduce c, or correct tested_at.",
            format_number(rate.test_rate),
            format_four_digits(rise)
        ))
    }
}
