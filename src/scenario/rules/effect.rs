//! Keys on which no result depends, and columns that a table does not have. One list of rules
//! over the inputs.

use crate::contact::pair::ALONE_FROM;
use crate::impact::Method;
use crate::results::Requirement;
use crate::results::hardness_scales::ImpactBody;
use crate::scenario::Kind;
use crate::scenario::input::read_input::is_at_or_below;
use crate::scenario::input::{Body, Input};
use crate::scenario::keys::interval::has_strength_parts;
use crate::scenario::keys::interval::law_error::has_law_error;
use crate::scenario::keys::key;

/// The facts that the rules may use.
#[derive(Debug, Clone, Copy)]
pub struct Facts<'a> {
    /// An input for every law and method of the scenario; at least one.
    pub inputs: &'a [Input],
    pub kind: Kind,
    /// The keys that vary.
    pub varied: &'a [&'static str],
}

/// A rule: something has no effect if a condition holds.
struct Rule {
    subject: Subject,
    /// Asked with the path of the key.
    applies: fn(&Facts, &str) -> bool,
    reason: &'static str,
}

#[derive(Clone, Copy)]
enum Subject {
    /// These keys, and the keys below them.
    Keys(&'static [&'static str]),
    /// The columns with one of these requirements.
    Columns(&'static [Requirement]),
}

const fn keys(keys: &'static [&'static str], applies: fn(&Facts, &str) -> bool, reason: &'static str) -> Rule {
    Rule { subject: Subject::Keys(keys), applies, reason }
}

const fn columns(needs: &'static [Requirement], applies: fn(&Facts, &str) -> bool, reason: &'static str) -> Rule {
    Rule { subject: Subject::Columns(needs), applies, reason }
}

const RULES: &[Rule] = &[
    keys(
        &["sphere.poissons_ratio"],
        |facts, _| facts.all(|input| input.number(key!("sphere.youngs_modulus")) == Some(f64::INFINITY)),
        "the sphere is rigid",
    ),
    keys(
        &["sphere.flow_stress"],
        |facts, _| facts.all(|input| input.is_harder(Body::Sphere, ALONE_FROM)),
        "only the half-space yields",
    ),
    keys(
        &["half_space.flow_stress"],
        |facts, _| facts.all(|input| input.is_harder(Body::HalfSpace, ALONE_FROM)),
        "only the sphere yields",
    ),
    keys(
        &["sphere.yield_strength", "sphere.hardness"],
        |facts, _| facts.all(|input| input.is_harder(Body::Sphere, 2.0)),
        "only the half-space yields; its strength is less than half the strength of the sphere",
    ),
    keys(
        &["half_space.yield_strength", "half_space.hardness"],
        |facts, _| facts.all(|input| input.is_harder(Body::HalfSpace, 2.0)),
        "only the sphere yields; its strength is less than half the strength of the half-space",
    ),
    keys(
        &[
            "sphere.density",
            "sphere.mass",
            "half_space.mass",
            "half_space.density",
            "half_space.thickness",
            "half_space.plate",
            "half_space.rod_diameter",
            "half_space.rod_length",
        ],
        |facts, _| facts.is_static(),
        "a quasi-static indentation needs no mass, density, plate or rod",
    ),
    keys(
        &["sphere.moment_of_inertia", "friction.coefficient"],
        |facts, _| facts.is_static() || facts.all(|input| !input.is_oblique()),
        "friction acts only if impact.angle or a spin of the sphere is given",
    ),
    keys(
        &["air.viscosity"],
        |facts, _| facts.all(|input| input.air().is_none_or(|air| air.drag.is_some())),
        "only drag = \"sphere\" uses a viscosity",
    ),
    keys(&["adhesion.work"], |facts, _| facts.kind == Kind::Repeat, "the impacts of a series rebound without adhesion"),
    keys(
        &["half_space.edge_distance", "half_space.rod_length"],
        |facts, _| !matches!(facts.kind, Kind::Impact | Kind::Repeat),
        "only a warning of single impacts uses this key",
    ),
    keys(
        &["solver.tolerance"],
        |facts, _| facts.has_verlet() && facts.inputs.iter().all(|input| is_verlet(input) || !facts.has_steps(input)),
        "verlet uses a fixed step (solver.steps_per_contact)",
    ),
    keys(
        &["solver.tolerance"],
        |facts, _| !facts.has_verlet() && !facts.inputs.iter().any(|input| facts.has_steps(input)),
        "this table uses the closed form; set solver.method to integrate",
    ),
    keys(&["solver.steps_per_contact"], |facts, _| !facts.has_verlet(), "only the method verlet has fixed steps"),
    keys(&["law"], |facts, path| path != "law" && !facts.is_of_a_law(path), "no case uses this law"),
    // these tables may name the default law: an elastic contact uses Hertz, and a scenario without a law uses the PLM, so
    // they always have an effect
    keys(
        &["law"],
        |facts, path| !["law.hertz", "law.plm"].contains(&path) && facts.all(|input| !input.can_yield()),
        "the contact is elastic because no body has a yield strength",
    ),
    columns(
        &[Requirement::Strength, Requirement::Subsurface],
        |facts, _| !facts.first().can_yield(),
        "no body has a yield strength, so there is no dent",
    ),
    columns(
        &[Requirement::Interval],
        |facts, _| !facts.has_interval(),
        "the uncertainty of the strength is unknown. Name a material, or give a hardness or strength_kind = \"proof\"",
    ),
    columns(
        &[Requirement::Peening, Requirement::MassFlow, Requirement::PeeningTime],
        |facts, _| facts.first().peening().is_none(),
        "the scenario has no [peening]. Add [peening] with coverage = 0.98",
    ),
    columns(
        &[Requirement::MassFlow, Requirement::PeeningTime],
        |facts, _| facts.first().peening().is_none_or(|peening| peening.mass_flux.is_none()),
        "a time requires peening.mass_flow and peening.area",
    ),
    columns(
        &[Requirement::PeeningTime],
        |facts, _| facts.first().number(key!("peening.time")).is_none(),
        "a coverage requires peening.time",
    ),
    columns(&[Requirement::Subsurface], |facts, _| !facts.first().asks_for_subsurface(), "no key asks for it"),
    columns(
        &[Requirement::Subsurface],
        |facts, _| {
            facts.is_on_waveguide() || facts.is_free() || facts.first().number(key!("half_space.radius")).is_some()
        },
        "the stress below a dent is known for a half-space only",
    ),
    columns(
        &[Requirement::Subsurface],
        |facts, _| facts.all(|input| input.yield_partition().is_some_and(|partition| !partition.is_half_space_alone())),
        "the stress below a dent is known only if the sphere does not yield",
    ),
    columns(
        &[Requirement::Adhesion],
        |facts, _| facts.first().number(key!("adhesion.work")).is_none(),
        "the scenario has no [adhesion]. Add [adhesion] with work = \"0.05 J/m^2\"",
    ),
    columns(&[Requirement::Rate], |facts, _| !facts.first().has_rate(), "no strain-rate model is given"),
    columns(
        &[Requirement::Flat],
        |facts, _| !facts.first().has_strength(Body::Sphere),
        "the sphere has no yield strength, so there is no flat",
    ),
    columns(
        &[Requirement::Flight],
        |facts, _| facts.first().free_flight().is_none(),
        "a height requires gravity.acceleration or impact.drop_height",
    ),
    columns(
        &[Requirement::Density],
        |facts, _| facts.first().number(key!("half_space.density")).is_none(),
        "elastic waves require half_space.density",
    ),
    columns(
        &[Requirement::Flight],
        |facts, _| facts.is_free(),
        "heights are not computed for a free target (half_space.mass)",
    ),
    columns(
        &[Requirement::Density],
        |facts, _| facts.is_free(),
        "elastic waves are not computed for a free target (half_space.mass)",
    ),
    columns(
        &[Requirement::Target, Requirement::Struck, Requirement::StruckCross],
        |facts, _| !facts.is_free(),
        "the target is fixed, because half_space.mass is not given",
    ),
    columns(
        &[Requirement::Incidence, Requirement::Struck],
        |facts, _| !facts.first().is_oblique(),
        "friction acts only if impact.angle or a spin of the sphere is given",
    ),
    columns(
        &[Requirement::Cross, Requirement::StruckCross],
        |facts, _| facts.first().cross_motion().is_none(),
        "the sphere stays in its plane of incidence, because neither sphere.spin_about_path nor sphere.spin_about_normal is given",
    ),
    columns(
        &[Requirement::Density],
        |facts, _| facts.is_on_waveguide(),
        "elastic waves of a half-space are not computed for a plate or rod; use plate_loss_fraction or rod_loss_fraction",
    ),
    columns(
        &[Requirement::LeebTester],
        |facts, _| facts.body_of_tester().is_none_or(|body| body.leeb_scale().is_none()),
        "mass, tip and speed of the sphere are not those of a Leeb tester in all rows",
    ),
    columns(
        &[Requirement::Scleroscope],
        |facts, _| facts.body_of_tester().is_none_or(|body| !body.is_of_scleroscope()),
        "mass, tip and drop height of the sphere are not those of a scleroscope in all rows",
    ),
    columns(
        &[Requirement::Thickness],
        |facts, _| facts.first().number(key!("half_space.thickness")).is_none(),
        "the target is not a plate, because half_space.thickness is not given",
    ),
    columns(
        &[Requirement::Rod],
        |facts, _| facts.first().number(key!("half_space.rod_diameter")).is_none(),
        "the target is not a rod, because half_space.rod_diameter is not given",
    ),
    columns(
        &[Requirement::Waveguide],
        |facts, _| !facts.is_on_waveguide(),
        "the target is neither a plate nor a rod, because half_space.thickness and half_space.rod_diameter are not given",
    ),
];

impl Facts<'_> {
    /// Why no result depends on a key, or on the table of a law; `None` if a result depends on it.
    pub fn why_unused(&self, path: &str) -> Option<&'static str> {
        self.reason(
            path,
            |subject| matches!(subject, Subject::Keys(keys) if keys.iter().any(|key| is_at_or_below(path, key))),
        )
    }

    /// Why a table lacks a column with this requirement; `None` if the table has it.
    pub fn why_no_column(&self, needs: Requirement) -> Option<&'static str> {
        self.reason("", |subject| matches!(subject, Subject::Columns(all) if all.contains(&needs)))
    }

    fn reason(&self, path: &str, is_about: impl Fn(Subject) -> bool) -> Option<&'static str> {
        let mut rules = RULES.iter().filter(|rule| is_about(rule.subject));
        rules.find(|rule| (rule.applies)(self, path)).map(|rule| rule.reason)
    }

    fn all(&self, is_so: fn(&Input) -> bool) -> bool {
        self.inputs.iter().all(is_so)
    }

    fn first(&self) -> &Input {
        &self.inputs[0]
    }

    fn is_static(&self) -> bool {
        self.kind == Kind::Indentation
    }

    fn has_verlet(&self) -> bool {
        self.inputs.iter().any(is_verlet)
    }

    fn has_steps(&self, input: &Input) -> bool {
        matches!(self.kind, Kind::Impact | Kind::Repeat) || self.kind.is_table() && input.is_integrated()
    }

    fn is_of_a_law(&self, path: &str) -> bool {
        self.inputs.iter().any(|input| input.is_law_key(path))
    }

    fn is_free(&self) -> bool {
        self.first().number(key!("half_space.mass")).is_some()
    }

    fn is_on_waveguide(&self) -> bool {
        self.first().forces().waveguide.is_some()
    }

    /// The body that hits a fixed target along the normal in all rows; `None` if it varies.
    fn body_of_tester(&self) -> Option<ImpactBody> {
        let input = self.first();
        let varies = self.varied.iter().any(|path| path.starts_with("sphere.") || path.starts_with("impact."));
        if varies || input.is_oblique() || self.is_free() {
            return None;
        }
        let (sphere, mass, speed) = (input.sphere(), input.mass()?, input.speed());
        let youngs_modulus = sphere.material.youngs_modulus;
        Some(ImpactBody { mass, radius: sphere.radius, youngs_modulus, energy: 0.5 * mass * speed * speed })
    }

    /// True if some rows have an interval of e that more than the law is a part of.
    fn has_interval(&self) -> bool {
        !self.varied.contains(&"law.plm.unloading_exponent")
            && self.inputs.iter().any(|input| has_law_error(&input.law()) && has_strength_parts(input))
    }
}

fn is_verlet(input: &Input) -> bool {
    input.solver().method == Method::Verlet
}
