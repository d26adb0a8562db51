//! `plm-impact check`

use anyhow::Context as _;
use clap::Args;
use plm_impact::error::Error;
use plm_impact::report::overview::{of_comparison, of_indentation, overview};
use plm_impact::report::plan::plan_lines;
use plm_impact::report::repeat::repeat_lines;
use plm_impact::run::repeat::Computed;
use plm_impact::run::{self, table};
use plm_impact::scenario::{Kind, Scenario};

use super::scenario::ScenarioArguments;

/// Print what is understood of a scenario, its yield point and the warnings of a run; write nothing
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
}

pub fn check(arguments: &Arguments) -> anyhow::Result<()> {
    let scenario = arguments.scenario.load().map_err(Error::from)?;
    match scenario.kind().map_err(Error::from)? {
        Kind::Impact => impact(&scenario),
        Kind::Sweep | Kind::MonteCarlo => sweep(&scenario),
        Kind::Repeat => repeat(&scenario),
        Kind::Compare => {
            let comparison = scenario.comparison().map_err(Error::from)?;
            super::run::warn(&comparison.warnings);
            let text = plm_impact::report::compare::state(&comparison) + "\n" + &of_comparison(&scenario, &comparison);
            super::terminal::print(&text).context("standard output")
        }
        Kind::Indentation => indentation(&scenario),
    }
}

fn sweep(scenario: &Scenario) -> anyhow::Result<()> {
    let Some(plan) = scenario.plan().map_err(Error::from)? else { return Ok(()) };
    let contact = plan.scene.contact().map_err(|error| Error::impact(scenario, error))?;
    super::run::warn(&table::warnings(&plan));
    let text = plan_lines(&plan) + &overview(&plan.scene, &contact);
    super::terminal::print(&text).context("standard output")
}

fn repeat(scenario: &Scenario) -> anyhow::Result<()> {
    let Computed { scene, contact, repeat, warnings, .. } = run::repeat::compute(scenario)?;
    super::run::warn(&warnings);
    super::terminal::print(&(repeat_lines(&repeat) + &overview(&scene, &contact))).context("standard output")
}

fn impact(scenario: &Scenario) -> anyhow::Result<()> {
    let (scene, contact, impact) = run::compute(scenario, None)?;
    super::run::warn(&impact.warnings);
    super::terminal::print(&overview(&scene, &contact)).context("standard output")
}

fn indentation(scenario: &Scenario) -> anyhow::Result<()> {
    let (scene, tested, warnings) = run::indentation::compute(scenario, None)?;
    super::run::warn(&warnings);
    super::terminal::print(&of_indentation(scenario, &scene, &tested)).context("standard output")
}
