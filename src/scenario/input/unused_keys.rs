//! Finds given keys that have no effect on the results.

use super::{Body, Input};
use crate::impact::Method;
use crate::scenario::keys::key;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunKind {
    Table,
    Impact,
    Indentation,
}

/// Why no result of these inputs depends on a key, or on the table of a law; `None` if a result depends on it. Keys that are not
/// named here always have an effect.
pub fn unused_reason(path: &str, inputs: &[Input], purpose: RunKind) -> Option<&'static str> {
    let all = |is_so: fn(&Input) -> bool| inputs.iter().all(is_so);
    let is_verlet = |input: &Input| input.solver().method == Method::Verlet;
    let is_moving = purpose != RunKind::Indentation;
    let has_steps = |input: &Input| purpose == RunKind::Impact || purpose == RunKind::Table && input.is_integrated();
    let (is_idle, why) = match path {
        "sphere.poissons_ratio" => {
            (all(|input| input.number(key!("sphere.youngs_modulus")) == Some(f64::INFINITY)), "the sphere is rigid")
        }
        _ if path.starts_with("sphere.flow_stress") && all(|input| input.is_harder(Body::Sphere, 1.25)) => {
            (true, "the half-space yields alone; leave it out")
        }
        _ if path.starts_with("half_space.flow_stress") && all(|input| input.is_harder(Body::HalfSpace, 1.25)) => {
            (true, "the sphere yields alone; leave it out")
        }
        "sphere.yield_strength" | "sphere.hardness" => (
            all(|input| input.is_harder(Body::Sphere, 2.0)),
            "the half-space yields alone, as it has less than half of that strength; leave the key out",
        ),
        "half_space.yield_strength" | "half_space.hardness" => (
            all(|input| input.is_harder(Body::HalfSpace, 2.0)),
            "the sphere yields alone, as it has less than half of that strength; leave the key out",
        ),
        "sphere.density"
        | "sphere.mass"
        | "half_space.mass"
        | "half_space.density"
        | "half_space.thickness"
        | "half_space.plate" => (!is_moving, "nothing moves here; leave the key out"),
        "sphere.moment_of_inertia" | "friction.coefficient" => (
            !is_moving || all(|input| input.incidence().is_none()),
            "without impact.angle or sphere.spin nothing slides; give one of them, or leave the key out",
        ),
        "air.viscosity" => (
            all(|input| input.air().is_none_or(|air| air.drag.is_some())),
            "only drag = \"sphere\" needs it; leave the key out",
        ),
        "half_space.edge_distance" => {
            (purpose != RunKind::Impact, "it only warns of single impacts; leave the key out")
        }
        "solver.tolerance" if inputs.iter().any(is_verlet) => (
            inputs.iter().all(|input| is_verlet(input) || !has_steps(input)),
            "verlet takes steps of one length; leave the key out",
        ),
        "solver.tolerance" => (!inputs.iter().any(has_steps), "the closed form takes no steps; give solver.method too"),
        "solver.steps_per_contact" => {
            (!inputs.iter().any(is_verlet), "only the method verlet takes so many steps; leave the key out")
        }
        _ if path != "law" && !inputs.iter().any(|input| input.is_law_key(path)) => (
            path.starts_with("law."),
            "no case is under that law; name it in \"law\" of [sweep] or as the only law, or leave the key out",
        ),
        // these tables may name the default law: an elastic contact uses Hertz, and a scenario without a law uses the PLM, so
        // these tables always have an effect
        "law.hertz" | "law.plm" => (false, ""),
        _ => (
            all(|input| !input.can_yield()),
            "no body has a yield_strength, so the contact stays elastic; give one, or leave the key out",
        ),
    };
    is_idle.then_some(why)
}

impl Input {
    /// True if only the other body yields: this one is stronger by at least the factor `least`, and the other body does not harden.
    fn is_harder(&self, body: Body, least: f64) -> bool {
        let flow = self.contact().ok().and_then(|contact| Some(contact.pair().yield_point?.yield_partition));
        let law = self.law();
        flow.is_some_and(|flow| {
            flow.for_softer(Body::ALL) != body && flow.ratio >= least && flow.for_softer(law.flow_curves()).is_none()
        })
    }
}
