//! What is written about an indentation: its inputs, `summary.json`, `trace.csv` and what the terminal shows.

use serde_json::Map;

use super::inputs::Inputs;
use super::rows::csv;
use super::{overview, terminal};
use crate::error::Error;
use crate::indentation::{Target, Tested};
use crate::provenance::Provenance;
use crate::scenario::Scenario;
use crate::scenario::indentation::IndentationScene;
use crate::scene::EVERY_KEY;
use crate::scene::at::at;
use crate::scene::key::Part;
use crate::scene::results::indentation::{self as results, stepped};
use crate::scene::results::{fields, lists};
use crate::scene::taken::Body;
use crate::units::aligned::aligned;
use crate::units::{self, Dimension, describe};

/// `summary.json`.
pub fn summary(
    tested: &[Tested],
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, Error> {
    let half_space = |one| {
        let mut half_space = fields(&results::half_space(), one);
        half_space.insert("steps".to_owned(), lists(&results::step(), &stepped(one)));
        half_space
    };
    let half_spaces = tested.iter().map(half_space).collect();
    let all = [("half_spaces".to_owned(), half_spaces), ("warnings".to_owned(), warnings.into())];
    super::summary::of(Map::from_iter(all), inputs, provenance)
}

/// `trace.csv`.
pub fn trace(tested: &[Tested]) -> Result<Vec<u8>, Error> {
    let rows = tested.iter().flat_map(|one| {
        let name = one.specimen.name.as_deref();
        one.indentation.trace.iter().map(move |row| (name, row))
    });
    csv(&results::trace(), rows)
}

/// The table for the terminal: for every half-space, a line for each step.
pub fn table(tested: &[Tested]) -> String {
    let mut text = String::new();
    for one in tested {
        if let Some(name) = &one.specimen.name {
            text.push_str(if text.is_empty() { "" } else { "\n" });
            text.push_str(name);
            text.push('\n');
        }
        text.push_str(&terminal::table(&results::step(), &stepped(one)));
    }
    text
}

/// The inputs of an indentation, without its steps and half-spaces.
pub fn inputs(scenario: &Scenario, scene: &IndentationScene) -> Inputs {
    let mut input = scenario.input().clone();
    if !input.can_yield() {
        let strength = scene.specimens.iter().find_map(|specimen| specimen.half_space.yield_strength);
        input.set(at!("half_space.yield_strength"), strength);
    }
    // every half-space has keys of its own
    let own = EVERY_KEY.iter().filter_map(|key| key.path.strip_prefix("indentation.half_space[]."));
    let own: Vec<String> = own.map(|name| format!("half_space.{name}")).collect();
    let mut inputs = Inputs::of(&input);
    inputs.0.retain(|held| (held.part.is_static() || held.part == Part::Output) && !own.contains(&held.path));
    inputs
}

/// What `check` prints of an indentation: the inputs, the steps, and the contact of every half-space.
pub fn overview(scenario: &Scenario, scene: &IndentationScene, tested: &[Tested]) -> String {
    let mut rows = overview::rows(&inputs(scenario, scene));
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value]);
    for (i, target) in (1..).zip(&scene.targets) {
        let (what, value) = match *target {
            Target::Load(load) => ("load", describe(load, Dimension::Force)),
            Target::Indentation(indentation) => ("indentation", describe(indentation, Dimension::Length)),
        };
        row(&format!("step {i}"), format!("{what} {value}"));
    }
    for Tested { specimen, pair, .. } in tested {
        let half_space = &specimen.half_space;
        row("", String::new());
        row("half-space", specimen.name.clone().unwrap_or_default());
        row("youngs_modulus", describe(half_space.material.youngs_modulus, Dimension::Pressure));
        row("poissons_ratio", units::number(half_space.material.poissons_ratio));
        if let Some(strength) = half_space.yield_strength {
            row("yield_strength", describe(strength, Dimension::Pressure));
        }
        for [name, value] in overview::paired(pair) {
            row(&name, value);
        }
    }
    let softer = |one: &Tested| one.pair.yield_point.map(|point| point.flow.of_softer(Body::ALL));
    let is_vague = |body: Body| !scenario.input().has_flow(body);
    aligned(&rows, |_| true) + overview::which_strength(tested.iter().filter_map(softer).any(is_vague))
}
