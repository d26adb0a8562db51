//! `plm-impact validate`

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::Args;
use plm_impact::error::Error;
use plm_impact::law::PlmCoefficients;
use plm_impact::output::{Origin, OutputDirectory, OutputFile};
use plm_impact::scenario::{LARGEST_SCENARIO, read_text};
use plm_impact::validation::{self, ValidationError, Verdict, check, report};

/// Compare with finite elements, published values and closed forms: CSV, Markdown, pictures, a summary on the terminal
///
/// Exit code 3 if a deviation exceeds its tolerance and is not on record as known.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Output directory
    #[arg(long, value_name = "DIR", default_value = "plots/validate")]
    out: PathBuf,
    /// Replace files that this program did not write
    #[arg(long)]
    force: bool,
    /// Validate the law with these coefficients instead of the built-in ones
    #[arg(long, value_name = "FILE")]
    coefficients: Option<PathBuf>,
    /// Tables only
    #[arg(long)]
    no_pictures: bool,
}

pub fn validate(arguments: &Arguments) -> anyhow::Result<()> {
    let own = arguments.coefficients.as_deref().map(load).transpose().map_err(Error::from)?;
    let coefficients = own.as_ref().unwrap_or_else(|| PlmCoefficients::built_in());
    let directory =
        OutputDirectory::prepare(&arguments.out, Origin::Command("validate"), arguments.force).map_err(Error::from)?;
    super::run::say_what_is_replaced(&directory);
    let checks = validation::checks(coefficients).map_err(Error::from)?;
    let mut files = vec![
        OutputFile { name: "validation.csv".into(), bytes: report::csv(&checks)? },
        OutputFile {
            name: "README.md".into(),
            bytes: report::page(&checks, &coefficients.provenance.name, own.is_none()).into_bytes(),
        },
    ];
    if !arguments.no_pictures {
        let pictures = super::threads::with(None, || validation::pictures(coefficients))?;
        files.extend(pictures.map_err(Error::from)?);
    }
    let out = directory.path().to_owned();
    directory.write(&files).map_err(Error::from)?;
    super::terminal::print(&report::table(&checks)).context("standard output")?;
    super::terminal::note(format_args!(
        "wrote validation.csv, README.md and {} pictures to {}",
        files.len() - 2,
        out.display()
    ));
    match check::count(&checks, Verdict::Miss) {
        0 => Ok(()),
        missed => Err(Error::Missed { missed, checks: checks.len(), table: out.join("validation.csv") }.into()),
    }
}

fn load(path: &Path) -> Result<PlmCoefficients, ValidationError> {
    let text = read_text(path, LARGEST_SCENARIO).map_err(ValidationError::Unreadable)?;
    PlmCoefficients::from_toml(&text).map_err(|error| ValidationError::Coefficients {
        file: path.display().to_string(),
        problem: error.to_string().trim_end().to_owned(),
    })
}
