//! `material`: the values that a named material gives to its body, if the scenario does not give them itself.

use super::Scenario;
use super::document::Document;
use super::input::{Body, BodyMaterial, Input, NumericKey, alternatives_to};
use super::keys::{ALL_KEYS, KeyId, KeySpec, NUMBER, Part, body_key, key};
use super::plan::varied::VariedKeys;
use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::materials::{MaterialEntry, PropertyValue};
use crate::scenario::plan::{AxisWord, Distribution, SweepAxis, Variable};

impl VariedKeys {
    /// Finds the values that the bodies take from their named materials, for keys that the scenario does not give. A material that is
    /// drawn becomes random keys.
    pub(super) fn apply_materials(&mut self, input: &Input, document: &Document) -> Result<Vec<BodyMaterial>, Error> {
        let mut all = Vec::new();
        for body in Body::ALL {
            let mut random = self.monte_carlo.iter().flat_map(|random| &random.materials);
            let is_drawn = random.any(|(drawn, _)| *drawn == body);
            let refuse = |message| document.refusal(&format!("monte_carlo.{}", body.material()), message);
            let Some(material) = self.first_material(input, body) else {
                if !is_drawn {
                    continue;
                }
                let table = body.table_name();
                return Err(refuse(format!(
                    "\"uniform\" requires a material in [{table}]. Add material = \"steel-s235\", or another."
                )));
            };
            let is_left = |at: KeyId<NUMBER>| self.defaults_to_material(input, document, body, &ALL_KEYS[at.index()]);
            let defaults = body.material_keys().into_iter().filter(|(at, _)| is_left(*at)).collect();
            let choice = BodyMaterial { body, material, defaults };
            for word in self.sweep.iter_mut().flatten().flat_map(SweepAxis::words_mut) {
                if let AxisWord::Material(other) = word
                    && other.body == body
                {
                    other.defaults.clone_from(&choice.defaults);
                }
            }
            if is_drawn {
                let variables = random_material_keys(input, &choice);
                if variables.is_empty() {
                    let name = &material.name;
                    return Err(refuse(format!("no property of {name} is left to vary. Remove this key.")));
                }
                self.replace_by_random_keys(body, variables);
            }
            all.push(choice);
        }
        Ok(all)
    }

    /// Replaces the drawn material of a body by random keys.
    fn replace_by_random_keys(&mut self, body: Body, drawn: Vec<Variable>) {
        let Some(random) = &mut self.monte_carlo else { return };
        let Some(&(_, place)) = random.materials.iter().find(|(known, _)| *known == body) else { return };
        for (_, later) in random.materials.iter_mut().filter(|(_, later)| *later >= place) {
            *later += drawn.len();
        }
        random.variables.splice(place..place, drawn);
    }

    /// The material of a body; its material in the first case if it varies.
    fn first_material(&self, input: &Input, body: Body) -> Option<&'static MaterialEntry> {
        let axis = self.sweep.iter().flatten().find(|axis| axis.path() == body.material());
        match axis.map(SweepAxis::word_values) {
            Some([AxisWord::Material(first), ..]) => Some(first.material),
            _ => input.named_material(body),
        }
    }

    /// True if a key takes its value from the material: the key has an effect, and neither the key nor its alternative is given.
    fn defaults_to_material(&self, input: &Input, document: &Document, body: Body, key: &KeySpec) -> bool {
        let has = |path: &str| document.contains(path);
        let varied = self.paths();
        let is_given = |path: &str| {
            let inner = format!("{path}.");
            // a calibration without free keys fits the strength
            let is_wanted = path == Body::HalfSpace.yield_strength() && has("calibrate") && self.free.is_none();
            is_wanted || has(path) || varied.iter().any(|varied| *varied == path || varied.starts_with(&inner))
        };
        let is_used = match key.part {
            Part::Motion if has("indentation") => false,
            // a plate and a rod need a density; elastic waves are not computed together with damping
            Part::Motion if key.path == "half_space.density" => {
                is_given("half_space.thickness") || is_given("half_space.rod_diameter") || !is_given("damping")
            }
            // other laws have no hardening, and a curve needs its own yield strength, or the hardness
            Part::Flow => {
                let is_plm = matches!(input.named_law, LawChoice::Plm(_)) && !varied.contains(&"law");
                is_plm && !is_given(body.yield_strength()) && !is_given(body.flow_stress())
            }
            // a rate is used only on request
            Part::Rate => takes_rate_from_material(input, body),
            _ => true,
        };
        is_used && !is_given(key.path) && !alternatives_to(key.path).any(is_given)
    }
}

/// True if the scenario gives `rate = "material"` for a body.
pub(super) fn takes_rate_from_material(input: &Input, body: Body) -> bool {
    input.text_value(body_key!(body, "rate")).is_some()
}

/// The values of a material as random keys, uniform between the ends of their ranges.
fn random_material_keys(input: &Input, choice: &BodyMaterial) -> Vec<Variable> {
    let is_rigid = input.number(key!("sphere.youngs_modulus")) == Some(f64::INFINITY);
    // a rigid sphere needs no Poisson's ratio
    let is_used = |path: &str| path != "sphere.poissons_ratio" || !is_rigid;
    let drawn = |(path, known): (&'static str, &PropertyValue)| {
        let [from, to] = [0, 1].map(|end| known.range[end].value);
        let key = NumericKey::find(path).filter(|_| from < to && is_used(path))?;
        Some(Variable::new(key, Distribution::Uniform { from, to }))
    };
    choice.known_values().filter_map(drawn).collect()
}

impl Scenario {
    /// Refuses an axis of half-spaces of which some yield and some do not, because their tables have different columns.
    pub(super) fn refuse_mixed_classes(&self, axes: &[SweepAxis]) -> Result<(), Error> {
        let materials = axes.iter().flat_map(SweepAxis::word_values).filter_map(|word| match word {
            AxisWord::Material(choice) => {
                choice.defaults.iter().any(|(at, _)| at.path() == Body::HalfSpace.hardness()).then_some(choice.material)
            }
            _ => None,
        });
        let (metals, others): (Vec<&MaterialEntry>, Vec<&MaterialEntry>) =
            materials.partition(|material| material.has_strength());
        let ([metal, ..], [other, ..]) = (&metals[..], &others[..]) else { return Ok(()) };
        let message = format!(
            "{} can yield and {} cannot, so their tables have different columns. Make two tables, or set half_space.yield_strength.",
            metal.name, other.name
        );
        Err(self.document.refusal("sweep.half_space.material", message))
    }
}
