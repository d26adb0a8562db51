//! `plm-impact validate`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::{Error, ErrorKind};
use plm_impact::law::PlmCoefficients;
use plm_impact::output::{Origin, OutputDirectory, OutputFile};
use plm_impact::plot::Pictures;
use plm_impact::scenario::{LARGEST_SCENARIO, read_text};
use plm_impact::validation::{self, Verdict, check, experiments, report};

use super::output::PictureArguments;
use super::watched::Watch;

/// Compare the law with finite elements and measurements: CSV, Markdown, pictures, a summary on the terminal
///
/// Exit code 3 if a deviation exceeds its tolerance and is not on record as known.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact validate --out validation --pictures none
  plm-impact validate --out mine --experiments measurements")]
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
    /// Compare with measurements of your own too: every CSV file of this directory
    ///
    /// The columns are those of `calibrate`: speed_m_per_s or drop_height_mm, restitution, rebound_height_mm and others,
    /// with standard deviations (restitution_sd) if known. Comment lines name the bodies, as keys of a scenario:
    /// `# sphere.diameter = 3 mm`, `# half_space.hardness = 300 HV`; `# law = thornton` another law; `# source = ...` says
    /// who measured.
    #[arg(long, value_name = "DIR")]
    experiments: Option<PathBuf>,
    #[command(flatten)]
    pictures: PictureArguments,
}

pub fn validate(arguments: &Arguments) -> Result<(), Error> {
    let own = arguments.coefficients.as_deref().map(load).transpose()?;
    let is_built_in = own.is_none();
    let coefficients = own.unwrap_or_else(|| PlmCoefficients::built_in().clone());
    let measured = arguments.experiments.as_deref().map(|path| experiments::load(path, &coefficients));
    let measured = measured.transpose()?.unwrap_or_default();
    let directory = OutputDirectory::prepare(&arguments.out, Origin::Command("validate"), arguments.force)?;
    let name = coefficients.provenance.name.clone();
    let format = arguments.pictures.format;
    let (checks, laws, measured, pictures) = Watch::without_files(false).watch(move |progress| {
        let checks = validation::checks(&coefficients, progress)?;
        let laws = validation::laws::laws(&coefficients)?;
        let draw = || validation::pictures(&coefficients, &measured, format, progress);
        let pictures = super::threads::with(None, draw)??;
        Ok((checks, laws, measured, pictures))
    })?;
    let mut page = report::page(&checks, &laws, &name, is_built_in);
    let mut files = vec![OutputFile { name: "validation.csv".into(), bytes: report::csv(&checks)? }];
    let mut said = report::table(&checks);
    if !measured.is_empty() {
        page += &experiments::section(&measured);
        said = experiments::table(&measured) + "\n" + &said;
        files.push(OutputFile { name: "experiments.csv".into(), bytes: experiments::csv(&measured)? });
    }
    if format == Pictures::Svg {
        page = page.replace(".png", ".svg");
    }
    files.push(OutputFile { name: "README.md".into(), bytes: page.into_bytes() });
    let tables = files.len();
    files.extend(pictures);
    let out = directory.path().to_owned();
    directory.write(&files)?;
    super::terminal::print(&said)?;
    let names: Vec<&str> = files[..tables].iter().map(|file| file.name.as_str()).collect();
    let pictures = files.len() - tables;
    super::terminal::note(format_args!("wrote {} and {pictures} pictures to {}", names.join(", "), out.display()));
    match check::count(&checks, Verdict::Miss) {
        0 => Ok(()),
        missed => {
            let (count, table) = (checks.len(), out.join("validation.csv"));
            let text = format!("{missed} of {count} checks missed their tolerance: see {}", table.display());
            Err(Error::new(ErrorKind::Mismatch, text).about(table.display()))
        }
    }
}

fn load(path: &Path) -> Result<PlmCoefficients, Error> {
    let text = read_text(path, LARGEST_SCENARIO)?;
    PlmCoefficients::from_toml(&text)
        .map_err(|error| Error::in_file(ErrorKind::Input, &path.display().to_string(), error.to_string().trim_end()))
}
