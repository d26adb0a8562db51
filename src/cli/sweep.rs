//! `plm-impact run` on a scenario with `[sweep]` or `[monte_carlo]`.

use std::path::Path;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::{OutputDirectory, SUMMARY};
use plm_impact::plot::sweep::PICTURES;
use plm_impact::provenance::Provenance;
use plm_impact::report;
use plm_impact::run::heed;
use plm_impact::run::table;
use plm_impact::scenario::Scenario;
use plm_impact::sweep::sidecar::Tally;
use plm_impact::sweep::{Format, Job, Partition, Shard};

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
    /// Sweeps: write a Parquet file for every value of this axis of words, such as law, into a folder `table-by-law`
    #[arg(long, value_name = "KEY", conflicts_with_all = ["shard", "shard_env"])]
    partition_by: Option<String>,
    /// Sweeps: write only this part of the table, counted from 0; `merge` puts the parts together
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
            ("--partition-by", self.partition_by.is_some()),
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

    /// What the table is written as.
    fn format(&self, is_divided: bool) -> Result<Format, Error> {
        match self.format {
            None if is_divided => Ok(Format::Parquet),
            Some(format) if is_divided && format != Format::Parquet => {
                Err(Error::input("--partition-by writes Parquet files; leave --format out".to_owned()))
            }
            format => Ok(format.unwrap_or(Format::Csv)),
        }
    }

    /// Which part of the table is written; `None`: all.
    fn shard(&self) -> Result<Option<Shard>, Error> {
        match (&self.shard, &self.shard_env) {
            (Some(text), _) => Ok(Some(Shard::parse(text)?)),
            (None, Some(text)) => Ok(Some(Shard::parse_with_variable(text, |name| std::env::var(name).ok())?)),
            (None, None) => Ok(None),
        }
    }
}

/// Writes the table of a scenario; for an undivided one also summary and pictures.
pub fn run(options: &Options, output: &Output, file: &Path, scenario: &Scenario) -> Result<(), Error> {
    let plan = &table::plan(scenario)?;
    let warnings = table::warnings(plan);
    warn(&warnings);
    heed(scenario, warnings.len(), output.strict)?;
    let shard = options.shard()?;
    let directory = &match shard {
        None => output.prepare(file, scenario)?,
        // every shard is checked by itself
        Some(_) => OutputDirectory::shared(&output.directory(file))?,
    };
    let partition = options.partition_by.as_ref().map(|key| Partition::of(plan, key)).transpose()?;
    let format = options.format(partition.is_some())?;
    let pictures = output.pictures.format;
    if shard.is_some() && output.json {
        let message = "--json prints the summary of a whole table, and a shard has none; leave one of the two out";
        return Err(Error::input(message.to_owned()));
    }
    let interrupt = Interrupt::listen()?;
    interrupt.end_the_slow()?;
    let bar = bar(output.quiet, "{human_pos}/{human_len} rows, {per_sec}, {eta} left");
    let source = scenario.source()?;
    let job = Job {
        plan,
        shard,
        format,
        partition,
        directory,
        source: &source,
        progress: &|rows, total| {
            bar.set_length(total);
            bar.set_position(rows);
        },
        is_cancelled: &interrupt.is_set,
    };
    if shard.is_none() {
        let drawn = PICTURES.map(|name| format!("{name}.{}", pictures.name()));
        let files = job.files().into_iter().chain(drawn).collect::<Vec<_>>();
        directory.check(files.iter().map(String::as_str).chain([SUMMARY]))?;
    }
    let written = super::threads::with(options.threads, || job.run());
    bar.finish_and_clear();
    let written = written?.map_err(|error| interrupt.explain(error))?;
    let mut files = Vec::new();
    if shard.is_none() {
        let provenance = Provenance::new(source.sha256(), &super::output::command_line());
        files = table::files(plan, &written.tally, &warnings, &provenance, pictures)?;
        directory.write(&files)?;
        written.close()?;
    }
    let resumed = match written.resumed {
        0 => String::new(),
        rows => format!("{rows} of these rows were there from an earlier run\n"),
    };
    let names = std::iter::once(written.table.display().to_string()).chain(files.iter().map(|file| file.name.clone()));
    let wrote = format!("{resumed}wrote {}", names.collect::<Vec<_>>().join(", "));
    output.report(&report::sweep::lines(&written.tally), &files, wrote)?;
    finish(&written.tally, &written.table)
}

/// Rows without a result make exit code 1.
pub fn finish(tally: &Tally, table: &Path) -> Result<(), Error> {
    if tally.failures == 0 {
        return Ok(());
    }
    let (failures, rows, table) = (tally.failures, tally.rows, table.display());
    let text = format!("{failures} of {rows} cases have no result: see the column status of {table}");
    Err(Error::failed(text).about(table))
}
