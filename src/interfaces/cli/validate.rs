//! `plm-impact validate`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::contact::law::PlmCoefficients;
use plm_impact::error::{Error, ErrorKind};
use plm_impact::files::{OutputDirectory, OutputFile, ResultOrigin};
use plm_impact::report::chart::PictureFormat;
use plm_impact::scenario::{MAX_SCENARIO_MIB, read_text};
use plm_impact::validate;
use plm_impact::validate::report;

use super::output::{PictureArguments, note_replaced};
use super::watch::{Signals, Watch};

/// For maintainers: compare the law with finite elements and measurements (CSV, Markdown, pictures)
///
/// Measurements of your own are compared by `plm-impact calibrate FILE DATA.csv --set calibrate.free={}`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact validate --out validation --pictures none
  plm-impact validate --coefficients mine.toml --out mine")]
pub struct ValidateArguments {
    /// Output directory
    #[arg(long, value_name = "DIR", default_value = "plots/validate")]
    out: PathBuf,
    /// Replace files that this program did not write
    #[arg(long)]
    force: bool,
    /// Also validate the law with the coefficients of this file
    #[arg(long, value_name = "FILE")]
    coefficients: Option<PathBuf>,
    #[command(flatten)]
    pictures: PictureArguments,
}

pub fn validate(arguments: &ValidateArguments) -> Result<(), Error> {
    let own = arguments.coefficients.as_deref().map(load_coefficients).transpose()?;
    let is_built_in = own.is_none();
    let coefficients = own.unwrap_or_else(|| PlmCoefficients::built_in().clone());
    Signals::listen()?;
    let directory = OutputDirectory::prepare(&arguments.out, ResultOrigin::Command("validate"), arguments.force)?;
    let name = coefficients.provenance.name.clone();
    let format = arguments.pictures.format;
    let (compared, laws, pictures, atlas, sections) = Watch::without_files(false).watch(move |progress| {
        let compared = validate::comparisons(&coefficients, progress)?;
        let laws = validate::laws::law_deviations(&coefficients)?;
        let draw = || validate::pictures(&coefficients, format, progress);
        let mut pictures = super::table::with_threads(None, draw)??;
        let questions = validate::atlas::questions(&coefficients, &laws)?;
        let draw = || validate::atlas::pictures(&questions, format, progress);
        pictures.extend(super::table::with_threads(None, draw)??);
        let mut sections = validate::measured::page::section(&coefficients)?;
        // the interval is known for the built-in coefficients
        if is_built_in {
            sections += &super::table::with_threads(None, validate::coverage::section)??;
        }
        sections += validate::atlas::SECTION;
        Ok((compared, laws, pictures, validate::atlas::csv(&questions), sections))
    })?;
    let page = with_pictures(&(report::page(&compared, &laws, &name, is_built_in) + &sections), format);
    let mut files = vec![
        OutputFile { name: "validation.csv".into(), bytes: report::csv(&compared)? },
        OutputFile { name: "atlas.csv".into(), bytes: atlas.into_bytes() },
        OutputFile { name: "README.md".into(), bytes: page.into_bytes() },
    ];
    let count = pictures.len();
    files.extend(pictures);
    let out = directory.path().to_owned();
    let removed = directory.write(&files)?;
    note_replaced(&directory, &removed);
    super::terminal::print(&report::table(&compared))?;
    super::terminal::note(format_args!(
        "wrote validation.csv, atlas.csv, README.md and {count} pictures to {}",
        out.display()
    ));
    Ok(())
}

/// The page with the pictures of this format, or without pictures.
fn with_pictures(page: &str, format: PictureFormat) -> String {
    match format {
        PictureFormat::Png => page.to_owned(),
        PictureFormat::Svg | PictureFormat::NarrowSvg => page.replace(".png", ".svg"),
        PictureFormat::None => {
            page.lines().filter(|line| !line.starts_with("![")).map(|line| line.to_owned() + "\n").collect()
        }
    }
}

fn load_coefficients(path: &Path) -> Result<PlmCoefficients, Error> {
    let text = read_text(path, MAX_SCENARIO_MIB)?;
    PlmCoefficients::from_toml(&text)
        .map_err(|error| Error::for_file(ErrorKind::Input, &path.display().to_string(), error.to_string().trim_end()))
}
