//! `plm-impact run` on a scenario with `[sweep]` or `[monte_carlo]`.

use std::num::NonZeroU64;
use std::time::Duration;

use clap::{Args, value_parser};
use plm_impact::error::Error;
use plm_impact::files::OutputDirectory;
use plm_impact::report::run::table::{TableWarnings, files as table_files, table_blocks, table_warnings};
use plm_impact::report::text::to_text;
use plm_impact::scenario::Scenario;
use plm_impact::scenario::plan::Plan;
use plm_impact::table::{FinishedTable, Format, PartLayout, Shard, TableJob, Tally};
use rayon::ThreadPoolBuilder;

use super::output::{OutputArguments, command_line, parse_choice};
use super::results::Results;
use super::watch::Watch;

/// More threads could stop a machine.
const MAX_THREADS: u16 = 1024;
/// The variable with the number of threads, where no option gives it.
const THREADS_VARIABLE: &str = "RAYON_NUM_THREADS";

/// Options of sweeps.
#[derive(Debug, Default, Args)]
pub struct Options {
    /// Sweeps: format of the table [default: csv]
    #[arg(long, value_parser = parse_choice(Format::ALL, Format::name))]
    format: Option<Format>,
    /// Sweeps: compute shard I of N (I = 0 to N-1); run once without --shard to finish; auto takes I and N from a Slurm
    /// array job
    #[arg(long, value_name = "I/N|auto")]
    shard: Option<String>,
    /// Sweeps: threads [default: one per core]; the number of threads does not change the table
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=i64::from(MAX_THREADS)))]
    threads: Option<u16>,
}

impl Options {
    /// Refuses options of tables for `scene`, which has none.
    pub fn refuse_for(&self, scene: &str) -> Result<(), Error> {
        let given = [
            self.format.map(|_| "--format"),
            self.shard.as_ref().map(|_| "--shard"),
            self.threads.map(|_| "--threads"),
        ];
        match given.into_iter().flatten().next() {
            Some(name) => Err(Error::input(format!(
                "{name} applies to [sweep] and [monte_carlo] only, and this scenario is {scene}"
            ))),
            None => Ok(()),
        }
    }
}

/// Time that a table has to stop by itself after a signal.
const GRACE_PERIOD: Duration = Duration::from_millis(700);
/// Rows of a part, for tests of small tables.
const ROWS_PER_PART_VARIABLE: &str = "PLM_IMPACT_TEST_ROWS_PER_PART";

/// The table that a scenario and the options ask for.
pub struct TableRequest {
    plan: Plan,
    warnings_and_notes: TableWarnings,
    shard: Option<Shard>,
    format: Format,
    threads: Option<u16>,
}

impl TableRequest {
    /// Plans the table, and prints its warnings before any row is computed.
    pub fn new(scenario: &Scenario, options: &Options, output: &OutputArguments) -> Result<Self, Error> {
        let plan = scenario.plan()?;
        let warnings_and_notes = table_warnings(&plan, None);
        output.print_warnings(scenario, &warnings_and_notes.warnings)?;
        let shard = options.shard.as_deref().map(parse_shard).transpose()?;
        if shard.is_some() && output.json {
            let message =
                "--json and --shard exclude each other, because a shard has no summary. Remove one of the two.";
            return Err(Error::input(message.to_owned()));
        }
        let format = options.format.unwrap_or(Format::Csv);
        Ok(Self { plan, warnings_and_notes, shard, format, threads: options.threads })
    }

    /// Writes the table, or a shard of it; a whole table also has a summary and pictures.
    pub fn compute<'a>(
        self,
        scenario: &Scenario,
        directory: OutputDirectory,
        output: &'a OutputArguments,
    ) -> Result<Results<'a>, Error> {
        let Self { plan, warnings_and_notes, shard, format, threads } = self;
        let layout = part_layout(&plan);
        let resume = if layout.is_split(shard, &directory) { RESUME_TEXT } else { NOTHING_WRITTEN };
        let watch = Watch { is_quiet: output.quiet, counted: "rows", grace_period: GRACE_PERIOD, on_abandon: resume };
        let source = scenario.source();
        let (directory, plan, table) = watch.watch(move |progress| {
            let job = TableJob { plan: &plan, shard, format, layout, directory: &directory, source: &source, progress };
            let table = with_threads(threads, || job.run())??;
            Ok((directory, plan, table))
        })?;
        let text = to_text(&table_blocks(&plan, &table.tally, &warnings_and_notes));
        let flaw = missing_rows_error(&table);
        let files = if shard.is_some() {
            Vec::new()
        } else {
            let mut provenance = scenario.provenance(&command_line());
            // the parts of a table are no file
            let name = table.table.file_name().filter(|_| table.table.is_file());
            provenance.files.extend(name.map(|name| name.to_string_lossy().into_owned()));
            provenance.files.extend(other_table(&directory, &provenance.files));
            let (tally, pictures) = (table.tally.clone(), output.pictures.format);
            Watch { on_abandon: NO_SUMMARY, ..Watch::without_files(output.quiet) }
                .watch(move |_| table_files(&plan, &tally, &warnings_and_notes, provenance, pictures))?
        };
        Ok(Results { directory, output, text, files, table: Some(table), removed: Vec::new(), flaw })
    }
}

/// The end of the message about an interrupted table.
const RESUME_TEXT: &str = "run the same command again to resume";
const NOTHING_WRITTEN: &str = "no files were written";
const NO_SUMMARY: &str = "the table is complete, but summary and plots are missing; run the same command again";

/// The parts of the table of a plan.
fn part_layout(plan: &Plan) -> PartLayout {
    let mut layout = PartLayout::new(plan);
    if let Some(rows) = std::env::var(ROWS_PER_PART_VARIABLE).ok().and_then(|rows| rows.parse::<NonZeroU64>().ok()) {
        layout.rows_per_part = rows.get();
    }
    layout
}

/// The error of a table with rows without a result, which make exit code 1.
fn missing_rows_error(FinishedTable { table, tally, .. }: &FinishedTable) -> Option<Error> {
    let Tally { failures, rows, .. } = tally;
    let table = table.display();
    let text = format!("{failures} of {rows} cases have no result. See the column `status` in {table}.");
    (*failures > 0).then(|| Error::failed(text).with_file(table))
}

fn parse_shard(text: &str) -> Result<Shard, Error> {
    if text == "auto" { Shard::from_slurm(|name| std::env::var(name).ok()) } else { Shard::parse(text) }
}

/// The table of an earlier run in another format. It stays, because it may have cost hours.
fn other_table(directory: &OutputDirectory, written: &[String]) -> Option<String> {
    let names = Format::ALL.map(|format| format!("table.{}", format.name()));
    let is_there = |name: &String| {
        !written.contains(name) && directory.same_results().contains(name) && directory.path().join(name).is_file()
    };
    names.into_iter().find(is_there)
}

/// Does the work on as many threads as the option says, or the environment, or on one per core.
///
/// # Errors
/// [`Error`] if the number in the environment is not allowed, or if the system does not start that number of threads.
pub fn with_threads<R: Send>(option: Option<u16>, work: impl FnOnce() -> R + Send) -> Result<R, Error> {
    let threads = option.map_or_else(threads_from_environment, Ok)?;
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build()
        .map_err(|error| Error::input(format!("cannot start {threads} threads: {error}. Use a smaller --threads.")))?;
    Ok(pool.install(work))
}

/// The number of threads by the environment; 0 is one per core.
fn threads_from_environment() -> Result<u16, Error> {
    let Some(text) = std::env::var_os(THREADS_VARIABLE).filter(|text| !text.is_empty()) else { return Ok(0) };
    let threads = text.to_str().and_then(|text| text.parse().ok()).filter(|threads| *threads <= MAX_THREADS);
    threads.ok_or_else(|| {
        let text = text.to_string_lossy();
        Error::input(format!("{THREADS_VARIABLE}={}: a number of threads is 0 to {MAX_THREADS}", text.escape_debug()))
    })
}
