//! `plm-impact run` on a scenario with `[sweep]` or `[monte_carlo]`.

use std::path::Path;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::report;
use plm_impact::run::heed;
use plm_impact::run::table;
use plm_impact::scenario::Scenario;
use plm_impact::sweep::count::Tally;
use plm_impact::sweep::{Format, Job, Shard};

use super::interrupt::Interrupt;
use super::names::one_of;
use super::output::{Output, warn};
use super::watched::bar;

/// Options of sweeps.
#[derive(Debug, Args)]
pub struct Options {
    /// Sweeps: what the table is written as [default: csv]
    #[arg(long, value_parser = one_of(Format::ALL, Format::name))]
    format: Option<Format>,
    /// Sweeps: compute only each N-th part of the table, from the I-th, counted from 0; without it the rest is computed
    #[arg(long, value_name = "I/N")]
    shard: Option<String>,
    /// Sweeps: the same, its number taken from an environment variable: SLURM_ARRAY_TASK_ID/16
    #[arg(long, value_name = "VARIABLE/N", conflicts_with = "shard")]
    shard_env: Option<String>,
    /// Sweeps: threads [default: one a core]; the table is the same whatever their number
    #[arg(long, value_name = "N", value_parser = super::threads::allowed())]
    threads: Option<u16>,
}

impl Options {
    /// Refuses options of tables for `scene`, which has none.
    pub fn refuse_for(&self, scene: &str) -> Result<(), Error> {
        let given = [
            ("--format", self.format.is_some()),
            ("--shard", self.shard.is_some()),
            ("--shard-env", self.shard_env.is_some()),
            ("--threads", self.threads.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) => Err(Error::input(format!(
                "{name} is for tables, those of a [sweep] or a [monte_carlo], and this scenario is {scene}"
            ))),
            None => Ok(()),
        }
    }

    /// Which part of the table is written; `None`: all.
    fn shard(&self) -> Result<Option<Shard>, Error> {
        match (&self.shard, &self.shard_env) {
            (Some(text), _) => Shard::parse(text, None).map(Some),
            (None, Some(text)) => Shard::parse(text, Some(&|name| std::env::var(name).ok())).map(Some),
            (None, None) => Ok(None),
        }
    }
}

/// Rows of a part, for tests of small tables.
const ROWS_PER_PART: &str = "PLM_IMPACT_ROWS_PER_PART";

/// Writes the table of a scenario, or a shard of it; with a whole table also summary and pictures.
pub fn run(options: &Options, output: &Output, file: &Path, scenario: &Scenario) -> Result<(), Error> {
    let plan = &table::plan(scenario)?;
    let warnings = table::warnings(plan);
    warn(&warnings);
    heed(scenario, warnings.len(), output.strict)?;
    let shard = options.shard()?;
    let pictures = output.pictures.format;
    if shard.is_some() && output.json {
        let message = "--json prints the summary of a whole table, and a shard has none; leave one of the two out";
        return Err(Error::input(message.to_owned()));
    }
    let directory = &output.prepare(file, scenario)?;
    let interrupt = Interrupt::listen()?;
    let bar = bar(output.quiet, "{human_pos}/{human_len} rows, {per_sec}, {eta} left");
    let source = scenario.source();
    let job = Job {
        plan,
        shard,
        format: options.format.unwrap_or(Format::Csv),
        rows_per_part: std::env::var(ROWS_PER_PART).ok().and_then(|rows| rows.parse().ok()),
        directory,
        source: &source,
        progress: &|rows, total| {
            bar.set_length(total);
            bar.set_position(rows);
        },
        is_cancelled: &interrupt.is_set,
    };
    interrupt.leave(if job.is_in_parts() {
        "the same command goes on from the parts that are whole"
    } else {
        "nothing was written; the same command starts anew"
    });
    interrupt.end_the_slow()?;
    let written = super::threads::with(options.threads, || job.run());
    bar.finish_and_clear();
    let written = written?.map_err(|error| interrupt.explain(error))?;
    let mut files = Vec::new();
    if shard.is_none() {
        interrupt.leave("the table is written, its summary is not; give the same command again");
        let provenance = scenario.provenance(&super::output::command_line());
        files = table::files(plan, &written.tally, &warnings, &provenance, pictures)?;
        directory.write(&files)?;
    }
    let found = match written.found {
        0 => String::new(),
        rows => format!("{rows} of these rows were there\n"),
    };
    let names = std::iter::once(written.table.display().to_string()).chain(files.iter().map(|file| file.name.clone()));
    let wrote = format!("{found}wrote {}", names.collect::<Vec<_>>().join(", "));
    output.report(&report::sweep::lines(&written.tally), &files, wrote)?;
    let Tally { failures, rows, .. } = written.tally;
    if failures == 0 {
        return Ok(());
    }
    // rows without a result make exit code 1
    let table = written.table.display();
    let text = format!("{failures} of {rows} cases have no result: see the column status of {table}");
    Err(Error::failed(text).about(table))
}
