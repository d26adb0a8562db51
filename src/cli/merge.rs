//! `plm-impact merge`

use std::path::PathBuf;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::{self, OutputDirectory};
use plm_impact::provenance::Provenance;
use plm_impact::report;
use plm_impact::run::table;
use plm_impact::scenario::plan_of;
use plm_impact::sweep::merge;

use super::pictures::PictureArguments;

/// Put the shards of a table together: byte for byte table and pictures of an undivided run
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact merge shards --out whole/table.csv
  plm-impact merge shards/table-0-of-2.csv shards/table-1-of-2.csv --out table.csv --pictures none")]
pub struct Arguments {
    /// Tables of shards, or directories of them
    #[arg(required = true, value_name = "DIR|FILE")]
    inputs: Vec<PathBuf>,
    /// The whole table; summary.json and the pictures go beside it
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Replace files that this program did not write, and results of other shards
    #[arg(long)]
    force: bool,
    /// Warnings and errors only
    #[arg(long)]
    quiet: bool,
    #[command(flatten)]
    pictures: PictureArguments,
}

pub fn merge(arguments: &Arguments) -> Result<(), Error> {
    let parent = output::folder(&arguments.out);
    let mut directory = OutputDirectory::shared(parent)?;
    let merged = merge::merge(&arguments.inputs, &mut directory, &arguments.out, arguments.force, plan_of);
    let merged = merged?;
    let warnings = table::warnings(&merged.plan);
    super::output::warn(&warnings);
    // the shards are of this version, or they would not have been merged
    let provenance = Provenance::new(merged.sidecar.scenario_sha256.clone(), &super::output::command_line());
    let files = table::files(&merged.plan, &merged.tally, &warnings, &provenance, arguments.pictures.format)?;
    directory.write(&files)?;
    if !arguments.quiet {
        super::terminal::print(&report::sweep::lines(&merged.tally))?;
        let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
        super::terminal::note(format_args!("wrote {}, {}", arguments.out.display(), names.join(", ")));
    }
    super::sweep::finish(&merged.tally, &arguments.out)
}
