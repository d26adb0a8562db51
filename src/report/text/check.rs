//! The output of `check --json`: the inputs, and the numbers that follow from them before anything is run.

use std::borrow::Cow;

use serde_json::{Map, Value};

use super::inputs::Inputs;
use crate::impact::Contact;
use crate::results::{ResultSpec, result_specs, to_fields};
use crate::scenario::input::Input;
use crate::scenario::plan::Plan;

/// The numbers of a contact at which no sphere has arrived.
pub fn contact_results() -> Vec<ResultSpec<Contact>> {
    result_specs! { |contact: Contact|
        /// Mass of the sphere.
        "sphere_mass_kg" in Mass as "sphere mass": contact.mass();
        /// Mass of the target.
        "target_mass_kg" in Mass as "target mass" if FREE: contact.target_mass();
        /// Effective mass of both bodies.
        "effective_mass_kg" in Mass as "effective mass m*" if FREE:
            contact.target_mass().map(|_| contact.reduced_mass());
        /// Effective radius of both bodies; for a flat target the radius of the sphere.
        "effective_radius_m" in Length as "effective radius R": contact.pair().radius;
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure as "effective modulus E*": contact.pair().effective_modulus;
        /// Fraction of the elastic approach in the sphere; 0 for a rigid sphere.
        "sphere_compliance" as "compliance fraction of the sphere kappa": contact.pair().sphere_compliance;
        /// Indentation at first yield.
        "yield_indentation_m" in Length as "yield indentation delta_Y" if REACHES:
            contact.pair().reachable_yield_point().map(|point| point.indentation);
        /// Force at first yield.
        "yield_force_N" in Force as "yield force F_Y" if REACHES: contact.pair().reachable_yield_point().map(|point| point.force);
        /// Contact radius at first yield.
        "yield_contact_radius_m" in Length as "yield contact radius a_Y" if REACHES:
            contact.pair().reachable_yield_point().map(|point| point.contact_radius);
        /// Impact speed above which a body yields.
        "yield_speed_m_per_s" in Speed as "yield speed v_Y" if REACHES: contact.yield_speed();
    }
}

/// The contact with the strengths at the strain rate of the speed, where they depend on it.
pub(super) fn contact_at_own_speed(input: &Input, contact: &Contact) -> Contact {
    let speed = input.approach().normal;
    contact.at_speed(speed).map_or_else(|_| contact.clone(), Cow::into_owned)
}

/// A scenario of impacts; of a table, it is its first case.
pub fn contact_fields(input: &Input, contact: &Contact) -> Map<String, Value> {
    let inputs = Inputs::new(input).to_json().into();
    let numbers = to_fields(&contact_results(), &contact_at_own_speed(input, contact)).into();
    Map::from_iter([("inputs".to_owned(), inputs), ("contact".to_owned(), numbers)])
}

/// A table: also its size and its columns.
pub fn plan_fields(plan: &Plan, contact: &Contact) -> Map<String, Value> {
    let mut all = contact_fields(&plan.input, contact);
    all.insert("cases".to_owned(), plan.n_cases().into());
    all.insert("columns".to_owned(), plan.column_names().into());
    all
}
