//! `material`: the values that the bodies take from named materials, where the scenario does not give them itself.

use super::Scenario;
use super::beside::FLOW;
use super::document::Document;
use super::varied::Varied;
use crate::error::Error;
use crate::law::LawChoice;
use crate::materials::{self, Entry, Property};
use crate::plan::axis::{Axis, Word};
use crate::plan::random::{Distribution, Variable};
use crate::scene::at::at;
use crate::scene::taken::{Body, Taken};
use crate::scene::{Input, Key};

/// Keys that replace a value of the material, besides the key of that value.
fn instead(body: Body, property: Property) -> &'static [&'static str] {
    match (body, property) {
        (Body::Sphere, Property::Density) => &["sphere.mass"],
        (Body::HalfSpace, Property::Hardness) => &["half_space.yield_strength"],
        // a curve needs its own yield strength, or the hardness
        (Body::HalfSpace, Property::HardeningExponent) => &["half_space.yield_strength", FLOW],
        _ => &[],
    }
}

impl Varied {
    /// What the bodies take from the materials that they name: the values that the scenario leaves to them. A material that
    /// is drawn becomes random keys.
    pub(super) fn take_materials(&mut self, input: &Input, document: &Document) -> Result<Vec<Taken>, Error> {
        let mut all = Vec::new();
        for body in Body::ALL {
            let mut random = self.monte_carlo.iter().flat_map(|random| &random.materials);
            let is_drawn = random.any(|(drawn, _)| *drawn == body);
            let refuse = |message| document.refuse(&format!("monte_carlo.{}", body.material()), message);
            let Some(material) = self.material(input, body) else {
                if !is_drawn {
                    continue;
                }
                let table = body.material().trim_end_matches(".material");
                return Err(refuse(format!(
                    "the body has no material to draw from: add material = \"steel-s235\", or another, to [{table}]"
                )));
            };
            let left = Property::ALL.into_iter().filter(|property| self.is_left(input, document, body, *property));
            let taken = Taken { body, material, left: left.collect() };
            for word in self.sweep.iter_mut().flatten().flat_map(Axis::words_mut) {
                if let Word::Material(other) = word
                    && other.body == body
                {
                    other.left.clone_from(&taken.left);
                }
            }
            if is_drawn {
                let variables = drawn(input, &taken);
                if variables.is_empty() {
                    let name = &material.name;
                    return Err(refuse(format!(
                        "the values that are taken from {name} have no ranges, so there is nothing to draw: leave the key out"
                    )));
                }
                self.draw(body, variables);
            }
            all.push(taken);
        }
        Ok(all)
    }

    /// Replaces the drawn material of a body by random keys.
    fn draw(&mut self, body: Body, drawn: Vec<Variable>) {
        let Some(random) = &mut self.monte_carlo else { return };
        let Some(&(_, place)) = random.materials.iter().find(|(known, _)| *known == body) else { return };
        for (_, later) in random.materials.iter_mut().filter(|(_, later)| *later >= place) {
            *later += drawn.len();
        }
        random.variables.splice(place..place, drawn);
    }

    /// The material of a body: of the first case, where it varies.
    fn material(&self, input: &Input, body: Body) -> Option<&'static Entry> {
        let axis = self.sweep.iter().flatten().find(|axis| axis.path() == body.material());
        match axis.map(Axis::words) {
            Some([Word::Material(first), ..]) => Some(first.material),
            _ => materials::all().get(input.word(body.material_key())?),
        }
    }

    /// Whether the body takes this property from its material.
    fn is_left(&self, input: &Input, document: &Document, body: Body, property: Property) -> bool {
        let Some(path) = body.path(property) else { return false };
        let has = |path: &str| document.has(path);
        let varied = self.paths();
        let is_given = |path: &str| {
            let inner = format!("{path}.");
            // a calibration that names no key looks for the strength
            let is_wanted = path == "half_space.yield_strength" && has("calibrate") && self.free.is_none();
            is_wanted || has(path) || varied.iter().any(|varied| *varied == path || varied.starts_with(&inner))
        };
        let is_moving = !has("indentation");
        let has_use = match (body, property) {
            (Body::Sphere, Property::Density) => is_moving,
            // a plate needs it; there are no elastic waves beside damping
            (Body::HalfSpace, Property::Density) => {
                is_moving && (is_given("half_space.thickness") || !is_given("damping"))
            }
            // no other law has hardening
            (Body::HalfSpace, Property::HardeningExponent) => {
                matches!(input.law, LawChoice::Plm(_)) && !varied.contains(&"law")
            }
            _ => true,
        };
        has_use && !is_given(path) && !instead(body, property).iter().any(|path| is_given(path))
    }
}

/// The values of a material as random keys: even between the ends of their ranges.
fn drawn(input: &Input, taken: &Taken) -> Vec<Variable> {
    let is_rigid = input.number(at!("sphere.youngs_modulus")) == Some(f64::INFINITY);
    let drawn = |(path, known): (&'static str, _)| {
        let [from, to] = taken.range(known);
        // the sphere's strength only serves to warn, and a rigid sphere needs no Poisson's ratio
        let is_used = path != "sphere.yield_strength" && !(path == "sphere.poissons_ratio" && is_rigid);
        let key = Key::find(path).filter(|_| from < to && is_used)?;
        Some(Variable::of(key, Distribution::Uniform { from, to }))
    };
    taken.values().filter_map(drawn).collect()
}

impl Scenario {
    /// Refuses an axis of half-spaces of which some yield and some do not: their tables have different columns.
    pub(super) fn refuse_mixture(&self, axes: &[Axis]) -> Result<(), Error> {
        let materials = axes.iter().flat_map(Axis::words).filter_map(|word| match word {
            Word::Material(Taken { body: Body::HalfSpace, left, material }) if left.contains(&Property::Hardness) => {
                Some(material)
            }
            _ => None,
        });
        let (metals, others): (Vec<&Entry>, Vec<&Entry>) = materials.partition(|material| material.is_metal());
        let ([metal, ..], [other, ..]) = (&metals[..], &others[..]) else { return Ok(()) };
        let message = format!(
            "{} yields and {} has no strength, and their tables have different columns: make a table of each kind, or give yield_strength to [half_space]",
            metal.name, other.name
        );
        Err(self.document.refuse("sweep.half_space.material", message))
    }
}
