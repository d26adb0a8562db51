//! Finds given keys that have no effect on the results.

use super::{Body, Input};
use crate::contact::pair::ALONE_FROM;
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
        _ if path.starts_with("sphere.flow_stress") && all(|input| input.is_harder(Body::Sphere, ALONE_FROM)) => {
            (true, "only the half-space yields")
        }
        _ if path.starts_with("half_space.flow_stress")
            && all(|input| input.is_harder(Body::HalfSpace, ALONE_FROM)) =>
        {
            (true, "only the sphere yields")
        }
        "sphere.yield_strength" | "sphere.hardness" => (
            all(|input| input.is_harder(Body::Sphere, 2.0)),
            "only the half-space yields; its strength is less than half the strength of the sphere",
        ),
        "half_space.yield_strength" | "half_space.hardness" => (
            all(|input| input.is_harder(Body::HalfSpace, 2.0)),
            "only the sphere yields; its strength is less than half the strength of the half-space",
        ),
        "sphere.density"
        | "sphere.mass"
        | "half_space.mass"
        | "half_space.density"
        | "half_space.thickness"
        | "half_space.plate" => (!is_moving, "a quasi-static indentation needs no mass, density or plate"),
        "sphere.moment_of_inertia" | "friction.coefficient" => (
            !is_moving || all(|input| input.incidence().is_none()),
            "friction acts only if impact.angle or sphere.spin is given",
        ),
        "air.viscosity" => {
            (all(|input| input.air().is_none_or(|air| air.drag.is_some())), "only drag = \"sphere\" uses a viscosity")
        }
        "half_space.edge_distance" => (purpose != RunKind::Impact, "only a warning of single impacts uses this key"),
        "solver.tolerance" if inputs.iter().any(is_verlet) => (
            inputs.iter().all(|input| is_verlet(input) || !has_steps(input)),
            "verlet uses a fixed step (solver.steps_per_contact)",
        ),
        "solver.tolerance" => {
            (!inputs.iter().any(has_steps), "this table uses the closed form; set solver.method to integrate")
        }
        "solver.steps_per_contact" => (!inputs.iter().any(is_verlet), "only the method verlet has fixed steps"),
        _ if path != "law" && !inputs.iter().any(|input| input.is_law_key(path)) => {
            (path.starts_with("law."), "no case uses this law")
        }
        // these tables may name the default law: an elastic contact uses Hertz, and a scenario without a law uses the PLM, so
        // these tables always have an effect
        "law.hertz" | "law.plm" => (false, ""),
        _ => (all(|input| !input.can_yield()), "the contact is elastic because no body has a yield strength"),
    };
    is_idle.then_some(why)
}

impl Input {
    /// True if only the other body yields: this one is stronger by at least the factor `least`, and the other body does not harden.
    fn is_harder(&self, body: Body, least: f64) -> bool {
        let flow = self.yield_partition();
        let law = self.law();
        flow.is_some_and(|flow| {
            flow.for_softer(Body::ALL) != body && flow.ratio >= least && flow.for_softer(law.flow_curves()).is_none()
        })
    }
}
