//! `plm-impact export`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::files::{begins_like, foreign_file_error, refuse_special, replace, unwritable_error};
use plm_impact::interfaces::export::header::header_files;
use plm_impact::interfaces::export::{ExportRequest, TargetCode, export as lines};
use plm_impact::scenario::keys::quantity::SPEED;

use super::output::parse_choice;
use super::scenario::ScenarioArguments;

/// Print contact parameters for a code that moves bodies, or a table e(v); or write the law as a C header
///
/// `--to header` writes the law of this pair as a C header without dependencies, with vectors and a program that tests a build of it.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact export impact.toml --to lammps --speed \"1 m/s\"
  plm-impact export impact.toml --to header --out my-code")]
pub struct ExportArguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// Target code, or csv (table e(v)) or header (the law in C)
    #[arg(long, value_name = "CODE", value_parser = parse_choice(TARGETS, Target::name))]
    to: Target,
    /// Impact speed [default: speed of the scenario]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    /// First and last speed of a table e(v), such as "0.1 m/s,10 m/s" [default: a tenth to ten times the speed]
    #[arg(long, value_name = "FROM,TO", conflicts_with = "speed", allow_hyphen_values = true)]
    speeds: Option<String>,
    /// Folder for the files of --to header [default: current directory]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The targets of `--to`.
#[derive(Debug, Clone, Copy)]
enum Target {
    /// Lines for a code, on standard output.
    Lines(TargetCode),
    /// Files in C.
    Header,
}

const TARGETS: [Target; TargetCode::ALL.len() + 1] = {
    let mut targets = [Target::Header; TargetCode::ALL.len() + 1];
    let mut i = 0;
    while i < TargetCode::ALL.len() {
        targets[i] = Target::Lines(TargetCode::ALL[i]);
        i += 1;
    }
    targets
};

impl Target {
    fn name(self) -> &'static str {
        match self {
            Self::Lines(code) => code.name(),
            Self::Header => "header",
        }
    }
}

pub fn export(arguments: &ExportArguments) -> Result<(), Error> {
    let target = match arguments.to {
        Target::Header => return write_header(arguments),
        Target::Lines(code) => code,
    };
    if let Some(out) = &arguments.out {
        let message =
            format!("--out {}: --to {} prints its lines. Remove --out, or write > FILE.", out.display(), target.name());
        return Err(Error::input(message));
    }
    let request = ExportRequest {
        target,
        speed: arguments.speed.as_deref().map(|text| speed("--speed", text)).transpose()?,
        speeds: arguments.speeds.as_deref().map(speeds).transpose()?,
    };
    let scenario = arguments.scenario.load()?;
    let text = lines(&scenario, &request, &super::output::command_line())?;
    super::terminal::print(&text)
}

/// Writes header, vectors and test program, or none of them where a file of others is in the way.
fn write_header(arguments: &ExportArguments) -> Result<(), Error> {
    for (option, value) in [("--speed", &arguments.speed), ("--speeds", &arguments.speeds)] {
        if value.is_some() {
            let message = format!(
                "{option}: a header does not depend on a speed, because it computes the force at every indentation. Remove {option}; if the strength depends on the strain rate, write --set impact.speed=\"3 m/s\"."
            );
            return Err(Error::input(message));
        }
    }
    let stem = arguments.scenario.name().file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let scenario = arguments.scenario.load()?;
    let files = header_files(&scenario, &stem.unwrap_or_default(), &super::output::command_line())?;
    let folder = arguments.out.as_deref().unwrap_or(Path::new("."));
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.name)).collect();
    for (path, file) in paths.iter().zip(&files) {
        refuse_special(path).map_err(unwritable_error(path))?;
        if path.exists() && !begins_like(path, &file.bytes).map_err(unwritable_error(path))? {
            return Err(foreign_file_error(path, "Move the file, or choose another --out."));
        }
    }
    for (path, file) in paths.iter().zip(&files) {
        replace(path, &file.bytes).map_err(unwritable_error(path))?;
    }
    let [header, vectors, test] = [0, 1, 2].map(|i| paths[i].display());
    super::terminal::note(format_args!(
        "wrote {header}, {vectors} and {test}. Next: `cc {test} -lm -o prove && ./prove {vectors}`"
    ));
    Ok(())
}

/// A speed with its unit, or a number in m/s.
fn speed(option: &str, text: &str) -> Result<f64, Error> {
    let number = text.parse::<f64>().map(|number| format!("{number} m/s"));
    SPEED.parse(number.as_deref().unwrap_or(text)).map_err(|problem| Error::input(format!("{option}: {problem}")))
}

fn speeds(text: &str) -> Result<(f64, f64), Error> {
    let both = text.split_once(',').ok_or_else(|| {
        Error::input(format!(
            "--speeds: \"{text}\" must be two speeds. Write the first and the last, such as \"0.1 m/s,10 m/s\"."
        ))
    })?;
    let (from, to) = (speed("--speeds", both.0.trim())?, speed("--speeds", both.1.trim())?);
    if from >= to {
        return Err(Error::input(format!("--speeds: the first speed of \"{text}\" is not below the last")));
    }
    Ok((from, to))
}
