//! `plm-impact merge`

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::OutputDirectory;
use plm_impact::report;
use plm_impact::run::table;
use plm_impact::sweep::merge;

/// Put the shards of a table together: byte for byte table and pictures of an undivided run
#[derive(Debug, Args)]
pub struct Arguments {
    /// Tables of shards, or directories of them
    #[arg(required = true, value_name = "DIR|FILE")]
    inputs: Vec<PathBuf>,
    /// The whole table; summary.json and the pictures go beside it
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Warnings and errors only
    #[arg(long)]
    quiet: bool,
}

pub fn merge(arguments: &Arguments) -> anyhow::Result<()> {
    let parent = arguments.out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let directory = OutputDirectory::prepare(parent)?;
    let merged = merge::merge(&arguments.inputs, &arguments.out).map_err(Error::from)?;
    let warnings = table::warnings(&merged.plan);
    super::run::warn(&warnings);
    let provenance = report::sweep::Provenance {
        version: &merged.sidecar.version,
        scenario_sha256: &merged.sidecar.scenario_sha256,
        command: &super::run::command_line(),
    };
    let files = table::files(&merged.plan, &merged.tally, &warnings, provenance)?;
    directory.write(&files)?;
    if !arguments.quiet {
        super::print(&report::sweep::lines(&merged.tally)).context("standard output")?;
        let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
        super::note(format_args!("wrote {}, {}", arguments.out.display(), names.join(", ")));
    }
    super::sweep::finish(&merged.tally, arguments.out.clone())
}
