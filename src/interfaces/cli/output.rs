//! The options for the output of a run: files, directory, terminal.

use std::ffi::OsString;
use std::fmt::Display;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use plm_impact::error::Error;
use plm_impact::files::{OutputDirectory, OutputFile, ResultOrigin, SUMMARY_FILE, hex};
use plm_impact::report::chart::PictureFormat;
use plm_impact::report::run::refuse_warnings;
use plm_impact::report::text::Detail;
use plm_impact::scenario::{Scenario, ScenarioIdentity};
use sha2::{Digest as _, Sha256};

use super::watch::Signals;

/// The folder of the results of all scenarios, in the current directory.
pub const DEFAULT_FOLDER: &str = "plots";

/// The options that say which files are written, and where.
#[derive(Debug, Args)]
#[allow(clippy::struct_excessive_bools)] // each is an option
pub struct OutputArguments {
    /// Output directory [default: plots/<scenario name>, with the settings of the command line at its end]
    ///
    /// The default is in the current directory: plots/impact for impact.toml, and plots/impact,impact.speed=1m_s with --set
    /// impact.speed="1 m/s". So runs and calibrations with other settings do not replace each other. The same command, also
    /// after a change of the file, replaces its own results. Results of another file or of other settings, and files that this
    /// program did not write, are replaced only with --force.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Replace files that this program did not write, and results of another scenario or of other settings
    #[arg(long)]
    force: bool,
    /// Treat warnings as errors (no files, exit code 1)
    #[arg(long)]
    pub strict: bool,
    /// Also print numerical accuracy (closed form, steps, energy balance)
    #[arg(long, conflicts_with = "quiet")]
    pub verbose: bool,
    /// Print warnings and errors only
    #[arg(long)]
    pub quiet: bool,
    /// Print summary.json, and nothing else, to standard output
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub pictures: PictureArguments,
}

/// Prints the summary among these files.
pub fn print_summary(files: &[OutputFile]) -> Result<(), Error> {
    let summary = files.iter().find(|file| file.name == SUMMARY_FILE).map_or(&[][..], |file| &file.bytes);
    super::terminal::print_json(&String::from_utf8_lossy(summary))
}

/// Warnings to standard error.
pub fn print_warnings(warnings: &[String]) {
    for warning in warnings {
        super::terminal::warning(warning);
    }
}

impl OutputArguments {
    /// Prints warnings, which are errors under --strict.
    pub fn print_warnings(&self, scenario: &Scenario, warnings: &[String]) -> Result<(), Error> {
        print_warnings(warnings);
        refuse_warnings(scenario, warnings.len(), self.strict)
    }

    /// Prints the table of a run and notes where its files are, or prints the summary alone.
    pub fn report(&self, text: &str, files: &[OutputFile], where_to: impl Display) -> Result<(), Error> {
        if self.json {
            print_summary(files)?;
        } else if !self.quiet {
            super::terminal::print(text)?;
            super::terminal::note(where_to);
        }
        Ok(())
    }

    pub fn detail(&self) -> Detail {
        if self.verbose { Detail::Full } else { Detail::Normal }
    }

    /// Refuses one directory for the results of several files.
    pub fn refuse_shared_directory(&self) -> Result<(), Error> {
        let Some(one) = &self.out else { return Ok(()) };
        Err(Error::input(format!(
            "--out {}: --out cannot be used with several scenarios. Without --out, results go to plots/NAME; or run one file at a time.",
            one.display()
        )))
    }

    /// The output directory.
    pub fn directory(&self, file: &Path, overrides: &[String]) -> PathBuf {
        self.out.clone().unwrap_or_else(|| Path::new(DEFAULT_FOLDER).join(default_name(file, overrides)))
    }

    /// Prepares the output directory of a scenario. Signals are listened to from here on.
    pub fn open_directory(&self, file: &Path, identity: &ScenarioIdentity) -> Result<OutputDirectory, Error> {
        Signals::listen()?;
        let reads: Vec<&Path> = identity.reads.iter().map(PathBuf::as_path).collect();
        let origin = ResultOrigin::File {
            path: file,
            sha256: &identity.sha256,
            overrides_sha256: identity.overrides_sha256.as_deref(),
            reads: &reads,
            is_table: identity.kind.is_table(),
        };
        OutputDirectory::prepare(&self.directory(file, &identity.overrides), origin, self.force)
    }
}

/// The longest name of a default directory: a file system takes 255 bytes.
const MAX_NAME: usize = 120;

/// The name of the default directory: that of the scenario, and behind it the overrides, so that results with other overrides
/// have another directory.
fn default_name(file: &Path, overrides: &[String]) -> OsString {
    let mut name = file.file_stem().unwrap_or(file.as_os_str()).to_owned();
    if overrides.is_empty() {
        return name;
    }
    let settings: Vec<String> = overrides.iter().map(|setting| in_file_name(setting)).collect();
    let settings = format!(",{}", settings.join(","));
    if settings.len() <= MAX_NAME {
        name.push(settings);
        return name;
    }
    // settings with the same beginning
    let hash = hex(&Sha256::digest(overrides.join("\0")));
    name.push(format!("{}-{}", &settings[..MAX_NAME], &hash[..8]));
    name
}

/// `key=value` without what a shell or a file system takes for something else. Of a path the name of the file is left.
fn in_file_name(setting: &str) -> String {
    let (key, value) = setting.split_once('=').unwrap_or((setting, ""));
    let path = Some(value.trim_matches(['"', '\''])).filter(|_| key.trim() == "calibrate.data").map(Path::new);
    let file = path.and_then(Path::file_name).map(|name| name.to_string_lossy());
    let text = format!("{key}={}", file.as_deref().unwrap_or(value));
    let kept = text.chars().filter(|c| !c.is_whitespace() && !"\"'".contains(*c));
    kept.map(|c| if c.is_ascii_alphanumeric() || ".=+-".contains(c) { c } else { '_' }).collect()
}

/// Notes which older results are gone, once the new ones are there.
pub fn note_replaced(directory: &OutputDirectory, removed: &[String]) {
    let path = directory.path().display();
    if let Some(older) = directory.replaced_results() {
        super::terminal::note(format_args!("{path}: replaced {older}"));
    }
    if !removed.is_empty() {
        super::terminal::note(format_args!(
            "{path}: removed {} of an earlier run, which this run does not write",
            removed.join(", ")
        ));
    }
}

/// The command line as typed, without the directory of the program.
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1).map(|argument| shell_quote(&argument.to_string_lossy()));
    std::iter::once(env!("CARGO_PKG_NAME").to_owned()).chain(arguments).collect::<Vec<_>>().join(" ")
}

/// Quoted for a shell where it has to be.
pub fn shell_quote(argument: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+@%".contains(c);
    if !argument.is_empty() && argument.chars().all(is_plain) {
        argument.to_owned()
    } else {
        format!("'{}'", argument.replace('\'', r"'\''"))
    }
}

/// Takes the name of one of `all`.
pub fn parse_choice<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let find = move |given: String| all.into_iter().find(|one| name(*one) == given).ok_or("no such name");
    PossibleValuesParser::new(all.map(name)).try_map(find)
}

/// The option with the format of pictures.
#[derive(Debug, Clone, Copy, Args)]
pub struct PictureArguments {
    /// Format of the plots (narrow-svg: width of a journal column)
    #[arg(id = "pictures", long, value_name = "FORMAT", default_value = "png", value_parser = parse_choice(PictureFormat::ALL, PictureFormat::name))]
    pub format: PictureFormat,
}
