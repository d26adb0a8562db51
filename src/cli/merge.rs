//! `plm-impact merge`

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::{OutputDirectory, OutputFile};
use plm_impact::report;
use plm_impact::sweep::merge;

/// Put the shards of a table together: byte for byte the table of an undivided run
#[derive(Debug, Args)]
pub struct Arguments {
    /// Tables of shards, or directories of them
    #[arg(required = true, value_name = "DIR|FILE")]
    inputs: Vec<PathBuf>,
    /// The whole table; summary.json goes beside it
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Errors only
    #[arg(long)]
    quiet: bool,
}

pub fn merge(arguments: &Arguments) -> anyhow::Result<()> {
    let parent = arguments.out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let directory = OutputDirectory::prepare(parent)?;
    let merged = merge::merge(&arguments.inputs, &arguments.out).map_err(Error::from)?;
    let provenance = report::sweep::Provenance {
        version: &merged.sidecar.version,
        scenario_sha256: &merged.sidecar.scenario_sha256,
        command: &super::run::command_line(),
    };
    let summary = report::sweep::summary(None, &merged.tally, provenance).map_err(Error::from)?;
    directory.write(&[OutputFile { name: "summary.json".to_owned(), bytes: summary.into_bytes() }])?;
    if !arguments.quiet {
        super::print(&report::sweep::lines(&merged.tally)).context("standard output")?;
        super::note(format_args!("wrote {}, summary.json", arguments.out.display()));
    }
    super::sweep::finish(&merged.tally, arguments.out.clone())
}
