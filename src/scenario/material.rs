//! `material`: the values that the bodies take from named materials, where the scenario does not give them itself.

use super::entries::Entries;
use super::flow::FLOW;
use super::values::{Fault, Refused};
use super::{Scenario, ScenarioError};
use crate::law::LawChoice;
use crate::materials::{Entry, Property, find};
use crate::plan::axis::{Axis, Word};
use crate::plan::random::{Distribution, Variable};
use crate::scene::Key;
use crate::scene::taken::{Body, Taken};

/// Keys that replace a value of the material, besides the key of that value.
fn instead(body: Body, property: Property) -> &'static [&'static str] {
    match (body, property) {
        (Body::Sphere, Property::Density) => &["sphere.mass"],
        (Body::HalfSpace, Property::Hardness) => &["half_space.yield_strength"],
        // a curve needs its own yield strength, or the hardness
        (Body::HalfSpace, Property::HardeningExponent) => &["half_space.yield_strength", FLOW, "compare"],
        _ => &[],
    }
}

impl Entries {
    /// Gives every body that names a material the values that the scenario leaves to it.
    pub(super) fn take_materials(&mut self) -> Result<Vec<Taken>, Refused> {
        let mut all = Vec::new();
        for body in Body::ALL {
            let drawn = self.draws(body);
            let refuse = |span, message| Fault { span, message }.of(format!("monte_carlo.{}", body.material()));
            let Some(material) = self.material(body) else {
                let Some(span) = drawn else { continue };
                let message = format!(
                    "the body has no material to draw from: add material = \"steel-s235\", or another, to [{}]",
                    body.table()
                );
                return Err(refuse(span, message));
            };
            let left: Vec<_> = Property::ALL.into_iter().filter(|property| self.is_left(body, *property)).collect();
            for word in self.axes.iter_mut().flatten().flat_map(Axis::words_mut) {
                if let Word::Material(taken) = word
                    && taken.body == body
                {
                    taken.left.clone_from(&left);
                }
            }
            let taken = Taken { body, material, left };
            let mut variables = Vec::new();
            for (path, known) in taken.values() {
                let [from, to] = taken.range(known);
                // the sphere's strength only serves to warn, and a rigid sphere needs no Poisson's ratio
                let is_used = path != "sphere.yield_strength"
                    && !(path == "sphere.poissons_ratio"
                        && self.number("sphere.youngs_modulus") == Some(f64::INFINITY));
                if drawn.is_some() && from < to && is_used {
                    let drawn = |key| Variable::of(key, Distribution::Uniform { from, to });
                    variables.extend(Key::find(path).map(drawn));
                } else {
                    self.give(path, taken.value(known));
                }
            }
            if let Some(span) = drawn {
                if variables.is_empty() {
                    let message = format!(
                        "the values that are taken from {} have no ranges, so there is nothing to draw: leave the key out",
                        material.name
                    );
                    return Err(refuse(span, message));
                }
                self.draw(body, variables);
            }
            all.push(taken);
        }
        Ok(all)
    }

    /// The material of a body: of the first case, where it varies.
    fn material(&self, body: Body) -> Option<&'static Entry> {
        let axis = self.axes.iter().flatten().find(|axis| axis.path() == body.material());
        match axis.map(Axis::words) {
            Some([Word::Material(first), ..]) => Some(first.material),
            _ => find(self.text(body.material())?),
        }
    }

    /// Whether the body takes this property from its material.
    fn is_left(&self, body: Body, property: Property) -> bool {
        let Some(path) = body.path(property) else { return false };
        let is_given = |path: &str| {
            let inner = format!("{path}.");
            // a calibration that names no key looks for the strength
            let is_wanted = path == "half_space.yield_strength" && self.has("calibrate") && self.free.is_none();
            is_wanted || self.has(path) || self.varied().any(|varied| varied == path || varied.starts_with(&inner))
        };
        let is_moving = !self.has("compare") && !self.has("indentation");
        let has_use = match (body, property) {
            (Body::Sphere, Property::Density) => is_moving,
            (Body::Sphere, Property::Hardness) => !self.has("compare"),
            // elastic waves are those of one impact by the law alone
            (Body::HalfSpace, Property::Density) => {
                is_moving && !["gravity", "damping", "repeat"].into_iter().any(is_given)
            }
            // no other law has hardening
            (Body::HalfSpace, Property::HardeningExponent) => {
                let is_other = |law: &str| law != "plm" && self.has(&format!("law.{law}"));
                !LawChoice::names().into_iter().chain(["combined"]).any(is_other) && !self.varies("law")
            }
            _ => true,
        };
        has_use && !is_given(path) && !instead(body, property).iter().any(|path| is_given(path))
    }
}

impl Scenario {
    /// Refuses an axis of half-spaces of which some yield and some do not: their tables have different columns.
    pub(super) fn refuse_mixture(&self, axes: &[Axis]) -> Result<(), ScenarioError> {
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
