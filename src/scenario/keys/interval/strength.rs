//! The parts of the interval of e that follow from the strengths of the bodies: the range of a hardness, hardening, proof stress,
//! strain rate. The sizes are those of the table in `scenarios/README.md#which-strength` and of `scenarios/trust.md#strain-rate`.

use super::law_error::paper_exponent_error;
use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::contact::strength::kind::{IMPACT_STRAINS, StrengthKind};
use crate::impact::{Contact, TOO_HIGH_BY};
use crate::materials::{MaterialEntry, PropertyValue};
use crate::results::restitution_interval::{HARDNESS, IntervalPart, PartKind};
use crate::scenario::input::{Body, Input};
use crate::scenario::keys::{body_key, key};
use crate::units::{Dimension, format_input};

/// e of a cold-worked or quenched metal from its hardness is too low by at most this fraction.
const HARDENED_TOO_LOW_BY: f64 = 0.041;
/// e from the 0.2 % proof stress of a metal that hardens is too low by at most this fraction.
const PROOF_TOO_LOW_BY: f64 = 0.38;

/// The true e relative to the computed e, minus 1, if the computed e is too low by a fraction of the true e.
fn true_over_computed(too_low_by: f64) -> f64 {
    1.0 / (1.0 - too_low_by) - 1.0
}

/// No metal that keeps its strength at room temperature has a lower Young's modulus \[Pa\]: magnesium has 41 to 45 GPa, concrete 30, wood
/// along its fibres up to 15. Tin has 45 GPa, and lead, which creeps, 16.
const SOFTEST_METAL: f64 = 35e9;

/// The hardness of a named material in its range: its name, and the strengths of the bodies at its lowest and its highest value.
/// Two bodies of one material have one hardness.
#[derive(Debug, Clone, PartialEq)]
pub struct HardnessRange {
    pub name: String,
    pub strengths: [[Option<f64>; 2]; 2],
}

/// The ranges of hardness of an input, valid for all inputs with the same strengths.
#[derive(Debug, Clone, PartialEq)]
pub struct HardnessRanges {
    bodies: [BodyRange; 2],
    ranges: Vec<HardnessRange>,
}

/// The strengths of a body at the lowest and the highest hardness of its material.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BodyRange {
    origin: RangeOrigin,
    strengths: [Option<f64>; 2],
}

/// The numbers, the material, and the presence of a range and of a flow curve, from which the range of a body follows.
type RangeOrigin = ([Option<f64>; 4], Option<usize>, [bool; 2]);

impl HardnessRanges {
    pub fn new(input: &Input, law: &LawChoice) -> Self {
        Self::from_earlier(input, law, None)
    }

    /// The ranges of another input. A body whose strength is the same keeps its range.
    pub fn with_input(self, input: &Input, law: &LawChoice) -> Self {
        let is_same = |body: Body| body.select(self.bodies).origin == origin(input, law, body);
        if Body::ALL.into_iter().all(is_same) { self } else { Self::from_earlier(input, law, Some(self.bodies)) }
    }

    fn from_earlier(input: &Input, law: &LawChoice, earlier: Option<[BodyRange; 2]>) -> Self {
        let known = Body::ALL.map(|body| known_range(input, body));
        let strength = |body: Body, end: usize| {
            let flow = body.select(law.flow_curves());
            let hardness = body.select(known)?.range[end].value;
            let mut input = input.clone();
            input.set(body_key!(body, "hardness"), Some(hardness));
            input.yield_strength(body, flow)
        };
        let bodies = Body::ALL.map(|body| {
            let origin = origin(input, law, body);
            let same = earlier.map(|bodies| body.select(bodies)).filter(|one| one.origin == origin);
            same.unwrap_or_else(|| BodyRange { origin, strengths: [0, 1].map(|end| strength(body, end)) })
        });
        let range = |of: &[Body], name: &str, known: &PropertyValue| {
            let at_end =
                |end: usize| Body::ALL.map(|body| body.select(bodies).strengths[end].filter(|_| of.contains(&body)));
            let [low, high] = known.range.each_ref().map(|end| end.text.as_str());
            HardnessRange { name: format!("{HARDNESS}{name} {low} to {high}"), strengths: [at_end(0), at_end(1)] }
        };
        let entries = Body::ALL.map(|body| input.named_material(body).map(|entry| &entry.name));
        let ranges = match known {
            [Some(one), Some(_)] if entries[0] == entries[1] => vec![range(&Body::ALL, "", one)],
            [sphere, half_space] => {
                let sphere = sphere.map(|known| range(&[Body::Sphere], " of the sphere", known));
                let half_space = half_space.map(|known| range(&[Body::HalfSpace], "", known));
                sphere.into_iter().chain(half_space).collect()
            }
        };
        Self { bodies, ranges }
    }

    pub(super) fn ranges(&self) -> &[HardnessRange] {
        &self.ranges
    }
}

fn origin(input: &Input, law: &LawChoice, body: Body) -> RangeOrigin {
    let numbers = body.strength_numbers().map(|at| input.number(at));
    let has = [known_range(input, body).is_some(), body.select(law.flow_curves()).is_some()];
    (numbers, input.word(body_key!(body, "material")), has)
}

/// The property of the material behind the hardness of a body; `None` if the hardness is not taken from a material.
fn known_range(input: &Input, body: Body) -> Option<&'static PropertyValue> {
    let at = body_key!(body, "hardness");
    let choice = input.materials().iter().find(|choice| choice.body == body)?;
    let (_, known) = choice.known_values().find(|(key, _)| *key == at.path())?;
    (input.number(at) == Some(known.value.value) && !input.is_calibrated(body)).then_some(known)
}

/// True if the interval of e has a part for the strength of a body, whatever the impact.
pub fn has_strength_parts(input: &Input) -> bool {
    Body::ALL.into_iter().any(|body| {
        let is_hard = input.number(body_key!(body, "hardness")).is_some();
        let has_kind = input.strength_kind(body) == Some(StrengthKind::Proof);
        let is_named = input.named_material(body).is_some() && input.has_strength(body);
        is_hard || has_kind || is_named
    })
}

/// The parts of the yielding bodies of a contact that do not depend on the speed; `None` for a body for which the law was not
/// made.
pub(super) fn strength_parts(input: &Input, contact: &Contact, law: &LawChoice) -> Option<Vec<IntervalPart>> {
    let flow = contact.pair().yield_point?.yield_partition;
    let shares = [flow.sphere_share, 1.0 - flow.sphere_share];
    let is_alike =
        input.named_material(Body::Sphere).is_some_and(|entry| Some(entry) == input.named_material(Body::HalfSpace));
    let mut parts: Vec<IntervalPart> = Vec::new();
    for body in Body::ALL.into_iter().filter(|body| body.select(shares) > 0.0) {
        if is_no_metal(input, body) {
            return None;
        }
        let share = if is_alike { 1.0 } else { body.select(shares) };
        for (name, ends) in body_parts(input, body, law) {
            let kind = if ends.is_some() { PartKind::Shift } else { PartKind::NotIncluded };
            // a body that takes a share of the yielding changes e by that share at least, and by the whole at most
            let [low, high] = ends.map_or([0.0; 2], |[low, high]| [low.min(share * low), high.max(share * high)]);
            match parts.iter_mut().find(|part| part.name == name) {
                // e lies between what the one and the other body make of it; two bodies of one material share the error
                Some(part) if part.kind == kind => (part.low, part.high) = (part.low.min(low), part.high.max(high)),
                Some(_) => parts.push(IntervalPart { name: format!("{name} of the half-space"), kind, low, high }),
                None => parts.push(IntervalPart { name, kind, low, high }),
            }
        }
    }
    Some(parts)
}

/// True for a body given by numbers with a modulus that no metal has: wood, a polymer, ice.
fn is_no_metal(input: &Input, body: Body) -> bool {
    input.named_material(body).is_none()
        && !input.is_calibrated(body)
        && input.material(body).youngs_modulus < SOFTEST_METAL
}

/// The parts of one yielding body: names, and both ends relative to e, minus 1; `None` for an error of unknown size.
fn body_parts(input: &Input, body: Body, law: &LawChoice) -> Vec<(String, Option<[f64; 2]>)> {
    let entry = input.named_material(body);
    let may_harden = entry.map(|entry| entry.lacks_exponent || entry.has_hardening());
    let is_by_hardness = input.number(body_key!(body, "hardness")).is_some();
    let has_curve = body.select(law.flow_curves()).is_some();
    let kind = input.strength_kind(body);
    let mut parts = Vec::new();
    if kind == Some(StrengthKind::Flow) {
        return parts;
    }
    let [least, most] = TOO_HIGH_BY.map(|share| 1.0 / (1.0 + share) - 1.0);
    let hardening = match (is_by_hardness, may_harden) {
        _ if has_curve => None,
        (true, Some(true)) => Some([most, least]),
        // e of a metal that hardens no further is too low by its strain rate, which has its own part if it is known
        (true, Some(false)) if input.rate(body).is_some() || entry.is_some_and(|entry| entry.rate_rise().is_some()) => {
            None
        }
        (true, Some(false)) => Some([0.0, true_over_computed(HARDENED_TOO_LOW_BY)]),
        // it may be either
        (true, None) => Some([most, true_over_computed(HARDENED_TOO_LOW_BY)]),
        (false, _) => None,
    };
    parts.extend(hardening.map(|ends| ("hardening".to_owned(), Some(ends))));
    let is_proof = kind == Some(StrengthKind::Proof) || may_harden == Some(true);
    if !is_by_hardness && !has_curve && is_proof {
        parts.push(("proof stress".to_owned(), Some([0.0, true_over_computed(PROOF_TOO_LOW_BY)])));
    }
    // a strength given by a number is the strength in the impact, as a note states
    let is_slow = is_by_hardness || has_curve || kind.is_some() || entry.is_some();
    if input.rate(body).is_none() && is_slow {
        parts.push(("strain rate".to_owned(), entry.and_then(MaterialEntry::rate_rise)));
    }
    parts
}

/// The note on a strength begins with this.
pub const WHICH_STRENGTH: &str = "Which strength?";

/// Notes for the user on the strength and on the exponent of the law behind e, if the scenario leaves them open: at most one
/// paragraph for each. Without a dent e needs neither, and there are no notes. `varied` holds the varied keys of a table.
pub fn strength_notes(input: &Input, contact: &Contact, has_dent: bool, varied: &[&str]) -> Vec<String> {
    let mut notes = Vec::new();
    let Some(point) = contact.pair().yield_point.filter(|_| has_dent) else { return notes };
    let body = point.yield_partition.for_softer(Body::ALL);
    let is_vague = input.has_vague_strength(body);
    if is_no_metal(input, body) {
        notes.push(format!(
            "e has no interval: the law was made for metals, and no metal has a Young's modulus as low as {}.youngs_modulus = {}.",
            body.table_name(),
            format_input(input.material(body).youngs_modulus, Dimension::Pressure)
        ));
    } else if let Some(strength) = input.number(body_key!(body, "yield_strength")).filter(|_| is_vague) {
        let key = body.yield_strength();
        let value = if varied.contains(&key) {
            String::new()
        } else {
            format!(" = {}", format_input(strength, Dimension::Pressure))
        };
        notes.push(format!(
            "{WHICH_STRENGTH} e holds if {key}{value} is the flow stress at a plastic strain of {IMPACT_STRAINS}. If {key} is the 0.2 % proof stress of a metal that hardens, e is up to 38 % too low. Set {}.strength_kind to \"flow\" or \"proof\": scenarios/README.md#which-strength",
            body.table_name()
        ));
    }
    let is_of_paper = matches!(input.law(), LawChoice::Plm(law) if law.exponent == UnloadingExponent::Paper);
    let exponent = key!("law.plm.unloading_exponent");
    let is_default = input.number(exponent).is_none() && !varied.contains(&exponent.path());
    if let (true, true, Some(error)) = (is_of_paper, is_default, paper_exponent_error()) {
        let [mean, high, low] = [error.mean, error.high, error.low].map(|share| -100.0 * share);
        notes.push(format!(
            "Which exponent? With the exponent 3/2 of the paper, the default, e is {mean:.1} % too low ({high:.1} to {low:.1} %). Set law.plm.unloading_exponent = \"pressure-shape\"."
        ));
    }
    notes
}

/// [`strength_notes`] on a contact of which no impact is computed: none if an impact at the speed of the input stays elastic.
pub fn expected_notes(input: &Input, contact: &Contact) -> Vec<String> {
    let speed = input.approach().normal;
    let is_plastic = contact.yield_speed().is_none_or(|slowest| speed.is_nan() || speed > slowest);
    strength_notes(input, contact, is_plastic, &[])
}

impl Input {
    /// True if the yield strength of a body may be its flow stress or its proof stress: the scenario describes neither the flow
    /// stress further nor the kind of the strength.
    pub fn has_vague_strength(&self, body: Body) -> bool {
        !self.has_flow(body) && self.strength_kind(body).is_none()
    }

    /// The kind of strength that a body has, if the scenario states it.
    pub fn strength_kind(&self, body: Body) -> Option<StrengthKind> {
        self.word(body_key!(body, "strength_kind")).map(|place| StrengthKind::ALL[place])
    }

    /// True if the strength of a body is that of its impacts, such as one that a rebound was calibrated with.
    fn is_calibrated(&self, body: Body) -> bool {
        self.strength_kind(body) == Some(StrengthKind::Flow)
    }
}
