//! The results of an indentation, and the texts about it: `summary.json`, `trace.csv` and the blocks for people.

use serde_json::{Map, Value};

use super::blocks::{Block, note_blocks};
use super::files::csv_bytes;
use super::inputs::Inputs;
use super::overview;
use super::terminal::{self, Imprint};
use crate::contact::pair::imprint_name;
use crate::contact::strength::kind::IMPACT_STRAINS;
use crate::error::Error;
use crate::impact::indentation::{IndentationRow, SetPoint, SpecimenResult, StepResult};
use crate::results::hardness_scales::{brinell_hardness, is_brinell_ball, meyer_hardness};
use crate::results::{ResultSpec, result_specs, to_field_list, to_fields};
use crate::scenario::Scenario;
use crate::scenario::input::Body;
use crate::scenario::keys::interval::WHICH_STRENGTH;
use crate::scenario::keys::{ALL_KEYS, Part, key};
use crate::scenario::kinds::indentation::IndentationRequest;
use crate::units::{Dimension, format_si_and_short};

/// The results of one half-space, in the order of `summary.json`.
pub fn half_space_results() -> Vec<ResultSpec<SpecimenResult>> {
    result_specs! { |tested: SpecimenResult|
        /// Name of the half-space.
        "name" as "half-space" if NAMED: tested.specimen.name.clone();
        /// Young's modulus.
        "youngs_modulus_Pa" in Pressure as "youngs_modulus": tested.specimen.half_space.material.youngs_modulus;
        /// Poisson's ratio.
        "poissons_ratio" as "poissons_ratio": tested.specimen.half_space.material.poissons_ratio;
        /// Yield strength.
        "yield_strength_Pa" in Pressure as "yield_strength" if YIELDS: tested.specimen.half_space.yield_strength;
        /// Effective modulus E* of the pair of bodies (reduced modulus in nanoindentation).
        "effective_modulus_Pa" in Pressure as "effective modulus E*": tested.pair.effective_modulus;
        /// Fraction of the elastic approach in the sphere; 0 for a rigid sphere.
        "sphere_compliance" as "compliance fraction of the sphere kappa": tested.pair.sphere_compliance;
        /// Indentation at first yield.
        "yield_indentation_m" in Length as "yield indentation delta_Y" if REACHES:
            tested.pair.reachable_yield_point().map(|point| point.indentation);
        /// Force at first yield.
        "yield_force_N" in Force as "yield force F_Y" if REACHES:
            tested.pair.reachable_yield_point().map(|point| point.force);
        /// Work of all steps.
        "work_J" in Energy: tested.indentation.steps.iter().map(|step| step.work).sum::<f64>();
        /// Plastic work of all steps.
        "plastic_work_J" in Energy if YIELDS: tested.can_yield.then(|| {
            tested.indentation.steps.iter().map(|step| step.plastic_work).sum::<f64>()
        });
    }
}

/// The steps of one half-space.
fn numbered_steps(tested: &SpecimenResult) -> Vec<StepReport<'_>> {
    (1..).zip(&tested.indentation.steps).map(|(number, step)| StepReport { number, step, tested }).collect()
}

/// One step of an indentation.
#[derive(Debug, Clone, Copy)]
pub struct StepReport<'a> {
    number: usize,
    step: &'a StepResult,
    tested: &'a SpecimenResult,
}

impl StepReport<'_> {
    /// Diameter \[m\] of the dent, if the half-space alone can yield: `None` inside before the first dent.
    #[allow(clippy::option_option)] // a result that is not there, and one that is null
    fn dent_diameter(&self) -> Option<Option<f64>> {
        let partition = self.tested.pair.yield_point?.yield_partition;
        let peak = &self.step.peak;
        let diameter = (peak.residual_indentation > 0.0).then_some(2.0 * peak.contact_radius);
        (partition.is_half_space_alone() && !self.tested.is_spring).then_some(diameter)
    }

    /// Brinell number of the dent in a flat half-space.
    #[allow(clippy::option_option)]
    fn brinell_hardness(&self) -> Option<Option<f64>> {
        let (dent, pair) = (self.dent_diameter()?, &self.tested.pair);
        let ball = 2.0 * pair.radius;
        let is_test = self.tested.specimen.half_space.radius.is_none() && is_brinell_ball(ball);
        is_test.then(|| brinell_hardness(self.step.peak.force, ball, dent?))
    }
}

pub fn step_results<'a>() -> Vec<ResultSpec<StepReport<'a>>> {
    result_specs! { |row: StepReport<'a>|
        /// Number of the step, from 1.
        "step" as "step": row.number;
        /// Load at which the step ends.
        "target_load_N" in Force as "to" if GIVEN: match row.step.set_point {
            SetPoint::Load(load) => Some(load),
            SetPoint::Indentation(_) => None,
        };
        /// Indentation at which the step ends.
        "target_indentation_m" in Length as "to" if GIVEN: match row.step.set_point {
            SetPoint::Load(_) => None,
            SetPoint::Indentation(indentation) => Some(indentation),
        };
        /// Branch of the law at the end of the step: `elastic`, `plastic`, `unloading`, `reloading` or `separated`.
        "branch": row.step.branch.name();
        /// Indentation at the end of the step.
        "indentation_m" in Length as "indentation": row.step.indentation;
        /// Part of the indentation in the sphere, including its permanent flat.
        "sphere_indentation_m" in Length: row.step.sphere_indentation;
        /// Force at the end of the step.
        "force_N" in Force as "force": row.step.force;
        /// Work done in the step; negative on unloading.
        "work_J" in Energy as "work": row.step.work;
        /// Stored elastic energy at the end of the step.
        "stored_energy_J" in Energy: row.step.stored_energy;
        /// Plastic work of the step.
        "plastic_work_J" in Energy as "plastic work" if YIELDS: row.tested.can_yield.then_some(row.step.plastic_work);
        /// Maximum force so far.
        "peak_force_N" in Force: row.step.peak.force;
        /// Maximum indentation so far.
        "peak_indentation_m" in Length: row.step.peak.indentation;
        /// Contact radius at the maximum indentation so far.
        "peak_contact_radius_m" in Length as "contact radius": row.step.peak.contact_radius;
        /// Maximum force over its contact area: the hardness F/A of a nanoindentation.
        "peak_mean_pressure_Pa" in Pressure as "hardness F/A": row.step.peak.mean_pressure;
        /// Diameter of the dent: twice the contact radius at the maximum force so far.
        "dent_diameter_m" in Length as "dent diameter" if DENTS: row.dent_diameter();
        /// Brinell number in kgf/mm²: maximum force so far over the area of the cap of the dent, 2 F/(π D (D − √(D² − d²))) with the
        /// diameters D of the ball and d of the dent.
        "brinell_hardness_HBW" as "Brinell hardness HBW" if BRINELL: row.brinell_hardness();
        /// Meyer number in kgf/mm²: maximum force so far over the projected area of the dent, 4 F/(π d²).
        "meyer_hardness_kgf_per_mm2" if DENTS: row.dent_diameter().map(|diameter| {
            diameter.map(|_| meyer_hardness(row.step.peak.mean_pressure))
        });
        /// Residual indentation: dent depth plus flat depth.
        "residual_indentation_m" in Length as "dent depth" if YIELDS: row.tested.can_yield.then_some(row.step.peak.residual_indentation);
        /// Unloading stiffness S at the maximum force. Do not compute the modulus from S/(2 a) of a dent: the result exceeds E* by
        /// 10 to 16 % with the exponent `pressure-shape`, and by up to 30 % with 3/2 (`indentation-cycles`).
        "unloading_stiffness_N_per_m" in Stiffness as "stiffness S": row.step.peak.unloading_stiffness;
        /// Exponent of the unloading force.
        "unloading_exponent": row.step.peak.unloading_exponent;
    }
}

/// A row of the trace, with the name of the half-space.
pub type TraceReport<'a> = (Option<&'a str>, &'a IndentationRow);

/// The columns of `trace.csv`.
pub fn trace_columns<'a>() -> Vec<ResultSpec<TraceReport<'a>>> {
    result_specs! { |row: TraceReport<'a>|
        /// Name of the half-space.
        "half_space" if NAMED: row.0.map(str::to_owned);
        /// Number of the step, from 1.
        "step": row.1.step;
        /// Indentation.
        "indentation_m" in Length: row.1.indentation;
        /// Part of the indentation in the sphere, including its permanent flat.
        "sphere_indentation_m" in Length: row.1.sphere_indentation;
        /// Part of the indentation in the half-space.
        "half_space_indentation_m" in Length: row.1.half_space_indentation;
        /// Force.
        "force_N" in Force: row.1.force;
        /// Branch of the law: `elastic`, `plastic`, `unloading`, `reloading` or `separated`.
        "branch": row.1.branch.name();
    }
}

/// The results by their names.
pub fn summary_fields(tested: &[SpecimenResult], warnings: &[String]) -> Map<String, Value> {
    let of_half_space = |one| {
        let mut half_space = to_fields(&half_space_results(), one);
        half_space.insert("steps".to_owned(), to_field_list(&step_results(), &numbered_steps(one)));
        half_space
    };
    let half_spaces = tested.iter().map(of_half_space).collect();
    Map::from_iter([("half_spaces".to_owned(), half_spaces), ("warnings".to_owned(), warnings.into())])
}

/// `trace.csv`.
pub fn trace_csv(tested: &[SpecimenResult]) -> Result<Vec<u8>, Error> {
    let rows = tested.iter().flat_map(|one| {
        let name = one.specimen.name.as_deref();
        one.indentation.trace.iter().map(move |row| (name, row))
    });
    csv_bytes(&trace_columns(), rows)
}

/// For every half-space a table, with a row for each step.
pub fn result_blocks(tested: &[SpecimenResult]) -> Vec<Block> {
    let mut blocks = Vec::new();
    for one in tested {
        if let Some(name) = &one.specimen.name {
            if !blocks.is_empty() {
                blocks.push(Block::EmptyLine);
            }
            blocks.push(Block::Sentence(name.clone()));
        }
        let name = one.pair.yield_point.map_or("dent", |point| imprint_name(point.yield_partition.flat_share));
        let imprint = Imprint::new(one.is_spring && one.pair.yield_point.is_some(), name);
        let rows = terminal::result_columns(&step_results(), &numbered_steps(one), imprint);
        blocks.push(Block::table(rows, usize::MAX));
    }
    blocks
}

/// The inputs of an indentation, without its steps and half-spaces.
pub fn inputs(scenario: &Scenario, scene: &IndentationRequest) -> Inputs {
    let mut input = scenario.input().clone();
    if !input.can_yield() {
        let strength = scene.specimens.iter().find_map(|specimen| specimen.half_space.yield_strength);
        input.set(key!("half_space.yield_strength"), strength);
    }
    // every half-space has keys of its own
    let own = ALL_KEYS.iter().filter_map(|key| key.path.strip_prefix("indentation.half_space[]."));
    let own: Vec<String> = own.map(|name| format!("half_space.{name}")).collect();
    let mut inputs = Inputs::new(&input);
    inputs.0.retain(|entry| (entry.part.is_static() || entry.part == Part::Output) && !own.contains(&entry.path));
    inputs
}

/// A check as data: the inputs, and every half-space.
pub fn check_fields(tested: &[SpecimenResult], inputs: &Inputs) -> Map<String, Value> {
    let half_spaces = to_field_list(&half_space_results(), tested);
    Map::from_iter([("inputs".to_owned(), inputs.to_json().into()), ("half_spaces".to_owned(), half_spaces)])
}

/// The blocks of `check`: the inputs, the steps, the contact of every half-space, and the notes.
pub fn overview(
    scenario: &Scenario,
    scene: &IndentationRequest,
    tested: &[SpecimenResult],
    notes: &[String],
) -> Vec<Block> {
    let mut rows = overview::input_rows(&inputs(scenario, scene));
    for (i, target) in (1..).zip(&scene.targets) {
        let (kind, value) = match *target {
            SetPoint::Load(load) => ("load", format_si_and_short(load, Dimension::Force)),
            SetPoint::Indentation(indentation) => ("indentation", format_si_and_short(indentation, Dimension::Length)),
        };
        rows.push([format!("step {i}"), format!("{kind} {value}")]);
    }
    for one in tested {
        rows.push([String::new(), String::new()]);
        rows.extend(terminal::label_value_rows(&half_space_results(), one));
        rows.push(overview::yielding_row(&one.pair, one.pair.reachable_yield_point().is_some()));
    }
    [vec![Block::list(rows)], note_blocks(notes)].concat()
}

/// Notes for the user on the strength behind forces and indentations, if a body yields and the scenario does not describe its flow
/// stress further.
pub fn material_notes(scenario: &Scenario, tested: &[SpecimenResult]) -> Vec<String> {
    let input = scenario.input();
    let has_dent = |one: &&SpecimenResult| one.indentation.steps.iter().any(|step| step.plastic_work > 0.0);
    let softer = |one: &SpecimenResult| one.pair.yield_point.map(|point| point.yield_partition.for_softer(Body::ALL));
    let body = tested.iter().filter(has_dent).filter_map(softer).find(|body| input.has_vague_strength(*body));
    body.map(|body| {
        let key = body.yield_strength();
        format!(
            "{WHICH_STRENGTH} Forces hold if {key} is the flow stress at a plastic strain of {IMPACT_STRAINS}. If {key} is the 0.2 % proof stress of a metal that hardens, forces are too low and dents are too deep: scenarios/README.md#which-strength"
        )
    })
    .into_iter()
    .collect()
}
