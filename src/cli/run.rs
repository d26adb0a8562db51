//! `plm-impact run`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::output::{Origin, OutputDirectory};
use plm_impact::run::{Outcome, Run, heed, table, way};
use plm_impact::scenario::Scenario;

use super::scenario::ScenarioArguments;

/// Run a scenario: summary, trace and pictures into a directory, a table to the terminal
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    #[command(flatten)]
    output: Output,
    #[command(flatten)]
    sweep: super::sweep::Options,
}

/// What is written, and where.
#[derive(Debug, Args)]
pub struct Output {
    /// Output directory [default: plots/<scenario name>]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Replace files that this program did not write, and results of another scenario
    #[arg(long)]
    force: bool,
    /// Take warnings for errors: write nothing, exit code 1
    #[arg(long)]
    strict: bool,
    /// Neither table nor progress; warnings and errors only
    #[arg(long)]
    quiet: bool,
}

pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let scenario = arguments.scenario.load().map_err(Error::from)?;
    match way(scenario.kind().map_err(Error::from)?).run {
        Run::Once { what, run } => {
            arguments.sweep.refuse_for(what)?;
            arguments.output.once(&arguments.scenario.scenario, &scenario, run)
        }
        Run::Table => sweep(arguments, &scenario),
    }
}

fn sweep(arguments: &Arguments, scenario: &Scenario) -> anyhow::Result<()> {
    let plan = table::plan(scenario)?;
    let warnings = table::warnings(&plan);
    warn(&warnings);
    let (output, file) = (&arguments.output, &arguments.scenario.scenario);
    heed(scenario, warnings.len(), output.strict)?;
    let directory = if arguments.sweep.shard()?.is_none() {
        output.prepare(file, scenario)?
    } else {
        // each shard is looked after by itself
        OutputDirectory::shared(&output.directory(file)).map_err(Error::from)?
    };
    super::sweep::run(&arguments.sweep, scenario, &plan, &warnings, &directory, &command_line(), output.quiet)
}

/// Says that results without a list of files are there.
pub fn say_what_is_replaced(directory: &OutputDirectory) {
    if directory.is_of_earlier_version() {
        let path = directory.path().display();
        super::terminal::note(format_args!(
            "{path}: the results of an earlier version that are there will be replaced"
        ));
    }
}

/// Warnings to standard error.
pub fn warn(warnings: &[String]) {
    for warning in warnings {
        super::terminal::note(format_args!("warning: {warning}"));
    }
}

impl Output {
    /// Runs a scenario at once. Warnings and where the files are to standard error, the files to the directory, the table to
    /// standard output.
    pub fn once(
        &self,
        file: &Path,
        scenario: &Scenario,
        run: fn(&Scenario, &str) -> Result<Outcome, Error>,
    ) -> anyhow::Result<()> {
        let directory = self.prepare(file, scenario)?;
        let Outcome { warnings, text, files, contradiction } = run(scenario, &command_line())?;
        warn(&warnings);
        heed(scenario, warnings.len(), self.strict)?;
        let out = directory.path().to_owned();
        directory.write(&files).map_err(Error::from)?;
        if !self.quiet {
            super::terminal::print(&text)?;
            let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
            super::terminal::note(format_args!("wrote {} to {}", names.join(", "), out.display()));
        }
        let name = || scenario.document.name().to_owned();
        contradiction.map_or(Ok(()), |reason| Err(Error::Contradicted { scenario: name(), reason }.into()))
    }

    /// Where the outputs go.
    fn directory(&self, file: &Path) -> PathBuf {
        let default = || Path::new("plots").join(file.file_stem().unwrap_or(file.as_os_str()));
        self.out.clone().unwrap_or_else(default)
    }

    /// The same, ready to be written to.
    fn prepare(&self, file: &Path, scenario: &Scenario) -> anyhow::Result<OutputDirectory> {
        let hash = scenario.sha256().map_err(Error::from)?;
        let origin = Origin::File(file, &hash);
        let directory = OutputDirectory::prepare(&self.directory(file), origin, self.force).map_err(Error::from)?;
        say_what_is_replaced(&directory);
        Ok(directory)
    }
}

/// As typed, but for the program's directory, which says nothing about the run.
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1).map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once(env!("CARGO_PKG_NAME").to_owned()).chain(arguments).collect::<Vec<_>>().join(" ")
}

/// Quoted for a shell where it has to be.
fn quoted(argument: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+@%".contains(c);
    if !argument.is_empty() && argument.chars().all(is_plain) {
        argument.to_owned()
    } else {
        format!("'{}'", argument.replace('\'', r"'\''"))
    }
}
