//! Whether a key has an effect: it is changed, and what the computation gets is compared.

use super::at::at;
use super::keys::Key;
use super::{Input, Scene};
use crate::impact::{Method, Solver};
use crate::law::LawChoice;
use crate::material::Pair;

/// What is computed of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// The rows of a table.
    Rows,
    /// An impact, or several.
    Impact,
    /// A slow indentation.
    Indentation,
}

/// A key with a whole number.
pub const STEPS: &str = "solver.steps_per_contact";

/// Why nothing that is computed of these inputs depends on a key; `None` if something does. Only numeric keys and keys of laws
/// are looked at, a law by its table too.
pub fn without_effect(path: &str, inputs: &[Input], of: Use) -> Option<&'static str> {
    let is_idle = |input: &Input| {
        changed(path, input).is_some_and(|other| other.resolve().reaching(of) == input.resolve().reaching(of))
    };
    inputs.iter().all(is_idle).then(|| why(path, inputs))
}

/// The input with another value of a key.
fn changed(path: &str, input: &Input) -> Option<Input> {
    let mut other = input.clone();
    match Key::find(path) {
        Some(key) => key.set(&mut other, Some(key.other_value(input)?)),
        None if path == STEPS => {
            let steps = input.solver().steps_per_contact;
            other.set_count(at!("solver.steps_per_contact"), u64::from(steps) + 1);
        }
        // these tables name what holds without them: an elastic contact is under the law of Hertz, and PLM is the law of a
        // scenario that names none
        None if matches!(path, "law.hertz" | "law.plm") && is_of_law(path, input) => return None,
        None if is_of_law(path, input) => {
            other.law = LawChoice::all().into_iter().find(|law| law.name() != input.law.name())?;
        }
        None if path.starts_with("law.") => {}
        None => return None,
    }
    Some(other)
}

/// Whether a key is that of the law of an input, or stands in the table of that law.
fn is_of_law(path: &str, input: &Input) -> bool {
    let mut parts = path.split('.');
    parts.next() == Some("law") && parts.next().is_none_or(|law| law == input.law.about().name)
}

fn is_verlet(input: &Input) -> bool {
    input.solver().method == Method::Verlet
}

/// Why a key has no effect on these inputs.
fn why(path: &str, inputs: &[Input]) -> &'static str {
    match path {
        "half_space.density" => "there are no elastic waves beside damping, nor without motion; leave the key out",
        "sphere.yield_strength" => "it only warns of single impacts and of indentations; leave the key out",
        "sphere.poissons_ratio" => "the sphere is rigid",
        "friction.coefficient" | "sphere.moment_of_inertia" => {
            "without impact.angle or sphere.spin nothing slides; give one of them, or leave the key out"
        }
        "half_space.thickness" => "a large plate gives way only to what moves; leave the key out",
        "half_space.edge_distance" => "it only warns of single impacts; leave the key out",
        "sphere.density" | "sphere.mass" => "nothing moves here; leave the key out",
        "solver.tolerance" if inputs.iter().any(is_verlet) => "verlet takes steps of one length; leave the key out",
        "solver.steps_per_contact" => "only the method verlet takes so many steps; leave the key out",
        path if path.starts_with("solver.") => "the closed form takes no steps; give solver.method too",
        path if inputs.iter().any(|input| is_of_law(path, input)) => {
            "the half-space has no yield_strength, so the contact stays elastic; give it one, or leave the key out"
        }
        path if path.starts_with("law.") => {
            "no case is under that law; name it in \"law\" of [sweep] or as the only law, or leave the key out"
        }
        _ => "nothing that is computed here depends on it; leave the key out",
    }
}

impl Key {
    /// Another value than that of the input.
    fn other_value(&self, input: &Input) -> Option<f64> {
        let example = self.quantity.example_value();
        let Some(own) = self.get(input).filter(|own| own.is_finite()) else {
            return example.or(Some(self.quantity.range().0.max(1.0)));
        };
        let mut near = [Some(1.01 * own), Some(0.99 * own), example].into_iter().flatten();
        near.find(|value| *value != own && self.quantity.check(*value).is_ok())
    }
}

impl Scene {
    /// What a computation gets of the scene, as text with all digits.
    fn reaching(&self, of: Use) -> String {
        let pair = Pair::try_new(self.sphere.radius, &self.sphere.material, &self.half_space);
        let law = self.half_space.yield_strength.map(|_| &self.law);
        let is_moving = matches!(of, Use::Rows | Use::Impact);
        let mut forces = self.forces;
        if let Some(plate) = forces.plate.as_mut().filter(|_| of == Use::Rows) {
            plate.edge_distance = None;
        }
        let sliding = self.incidence.map(|incidence| (incidence, self.input.number(at!("sphere.moment_of_inertia"))));
        let motion = is_moving.then_some((
            self.sphere.density,
            self.input.number(at!("sphere.mass")),
            self.speed,
            forces,
            sliding,
        ));
        let waves = self.half_space.density.filter(|_| is_moving && forces.damping.is_none());
        let steps = (of == Use::Impact || of == Use::Rows && self.is_stepped()).then(|| {
            let Solver { method, tolerance, steps_per_contact } = self.solver;
            let is_verlet = method == Method::Verlet;
            (method, (!is_verlet).then_some(tolerance), is_verlet.then_some(steps_per_contact))
        });
        let doubts = self.sphere.yield_strength.filter(|_| matches!(of, Use::Impact | Use::Indentation));
        format!("{pair:?} {law:?} {motion:?} {waves:?} {steps:?} {doubts:?}")
    }

    /// Whether a row of this scene is integrated, or its times are.
    pub fn is_stepped(&self) -> bool {
        let method = self.solver.method.chosen(&self.forces, false);
        self.forces.gravity.is_some() || method.is_some_and(|method| method != Method::ClosedForm)
    }
}
