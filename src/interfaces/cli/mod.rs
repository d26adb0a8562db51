//! The command line: its types, and one file for each subcommand.

mod bench;
mod calibrate;
mod check_trace;
mod completions;
mod drop;
mod export;
mod find;
mod init;
mod keys;
mod materials;
mod options;
mod output;
mod pace;
mod peen;
mod request;
mod results;
mod run;
mod scenario;
mod table;
pub mod terminal;
mod units;
mod validate;
mod watch;

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory as _, Parser, Subcommand};
use plm_impact::error::Error;
use plm_impact::report::text::laws::{laws_json, laws_text};
use plm_impact::scenario::keys::ALL_KEYS;
use plm_impact::scenario::schema::schema;
use terminal::ErrorFormat;

/// Low-velocity impact of an elastic sphere on an elastic-plastic half-space.
///
/// Exit codes: 0 success; 1 failure, or warnings with --strict; 2 invalid input;
/// 3 the law does not fit the data; 130 and 143 interrupted by Ctrl-C and SIGTERM
/// (run the command again to resume a sweep). For several files, the largest code.
#[derive(Debug, Parser)]
#[command(
    version,
    arg_required_else_help = true,
    after_help = "Examples:\n  plm-impact init\n  plm-impact run impact.toml --set impact.speed=\"1 m/s\""
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Print all licences (program, fonts, crates)
    #[arg(long)]
    licenses: bool,
    /// Format of errors and warnings on standard error (json: one object per line, with file, line, column, key, value)
    #[arg(long, global = true, value_enum, value_name = "FORMAT", default_value = "text")]
    error_format: ErrorFormat,
}

#[derive(Debug, Subcommand)]
enum Command {
    Drop(drop::DropArguments),
    Peen(peen::PeenArguments),
    Init(init::InitArguments),
    Run(run::RunArguments),
    Check(run::CheckArguments),
    Calibrate(calibrate::CalibrateArguments),
    Find(find::FindArguments),
    Export(export::ExportArguments),
    CheckTrace(check_trace::CheckTraceArguments),
    /// List the contact laws with sources, formulas, validity and confidence
    #[command(after_help = "Examples:
  plm-impact laws
  plm-impact run impact.toml --set law=thornton")]
    Laws {
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    Materials(materials::MaterialsArguments),
    Keys(keys::KeysArguments),
    Units(units::UnitsArguments),
    /// Print the JSON Schema of a scenario, for editors and for programs that write scenarios
    #[command(after_help = "Examples:
  plm-impact schema > scenario.schema.json
  plm-impact schema | grep drop_height")]
    Schema,
    Validate(validate::ValidateArguments),
    Bench(bench::BenchArguments),
    Completions(completions::Completions),
}

/// Runs the command that the command line names.
pub fn run() -> Result<(), Error> {
    let Cli { command, licenses, error_format } = parse()?;
    error_format.install();
    watch::install_test_signal();
    if licenses {
        return terminal::print(concat!(include_str!("../../../LICENSE"), "\n", include_str!("../licenses.txt")));
    }
    match command.ok_or_else(|| Error::input("no command is given; `plm-impact --help` lists them"))? {
        Command::Drop(arguments) => drop::drop(&arguments),
        Command::Peen(arguments) => peen::peen(&arguments),
        Command::Init(arguments) => init::init(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => run::check(&arguments),
        Command::Calibrate(arguments) => calibrate::calibrate(&arguments),
        Command::Find(arguments) => find::find(&arguments),
        Command::Export(arguments) => export::export(&arguments),
        Command::CheckTrace(arguments) => check_trace::check_trace(&arguments),
        Command::Laws { json: true } => terminal::print_json(&format!("{:#}\n", laws_json())),
        Command::Laws { json: false } => terminal::print(&laws_text()),
        Command::Keys(arguments) => keys::keys(&arguments),
        Command::Units(arguments) => units::units(&arguments),
        Command::Materials(arguments) => materials::materials(&arguments),
        Command::Schema => terminal::print(&format!("{:#}\n", schema())),
        Command::Validate(arguments) => validate::validate(&arguments),
        Command::Bench(arguments) => bench::bench(&arguments),
        Command::Completions(arguments) => completions::completions(&arguments, Cli::command()),
    }
}

/// Reads the command line. A wrong one ends the program at once, unless errors are written as JSON.
fn parse() -> Result<Cli, Error> {
    Cli::try_parse().map_err(|error| {
        let words: Vec<_> = std::env::args_os().take_while(|word| word != "--").collect();
        let asks = words.windows(2).any(|pair| pair[0] == "--error-format" && pair[1] == "json");
        let is_json = asks || words.iter().any(|word| word == "--error-format=json");
        if is_json && error.use_stderr() {
            ErrorFormat::Json.install();
            return Error::input(error.to_string().trim_start_matches("error: ").trim_end().to_owned());
        }
        if error.kind() == ErrorKind::InvalidSubcommand
            && let Some(file) = words.get(1).filter(|word| Path::new(word).extension().is_some_and(|end| end == "toml"))
        {
            let file = file.to_string_lossy();
            return Error::input(format!("no command is given. Did you mean `plm-impact run {file}`?"));
        }
        match option_of_key(&error) {
            Some(text) => Error::input(text),
            None => error.exit(),
        }
    })
}

/// The message about an option that is unknown, but has the name of a key of a scenario; only for commands with `--set`.
fn option_of_key(error: &clap::Error) -> Option<String> {
    let Some(ContextValue::String(option)) = error.get(ContextKind::InvalidArg) else { return None };
    if error.kind() != ErrorKind::UnknownArgument || error.get(ContextKind::SuggestedArg).is_some() {
        return None;
    }
    let has_set = |command: &clap::Command| command.get_arguments().any(|one| one.get_long() == Some("set"));
    let cli = Cli::command();
    std::env::args().skip(1).find_map(|word| cli.find_subcommand(word)).filter(|command| has_set(command))?;
    let name = option.strip_prefix("--")?.split('=').next()?.replace('-', "_");
    let ends = |path: &str| path == name || path.rsplit_once('.').is_some_and(|(_, last)| last == name);
    let keys = || ALL_KEYS.iter().map(|key| key.path).chain(["law"]).filter(|path| ends(path));
    let settings: Vec<String> = keys().map(|path| format!("--set {path}=VALUE")).collect();
    (!settings.is_empty()).then(|| format!("the option {option} is not known. Write {}", settings.join(" or ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The words of a line as a shell makes them, up to a pipe.
    fn split_words(line: &str) -> Vec<String> {
        let (mut words, mut is_quoted) = (vec![String::new()], false);
        for c in line.chars().take_while(|c| *c != '|' && *c != '>') {
            match c {
                '"' => is_quoted = !is_quoted,
                ' ' if !is_quoted => words.push(String::new()),
                c => words.last_mut().into_iter().for_each(|word| word.push(c)),
            }
        }
        words.retain(|word| !word.is_empty());
        words
    }

    #[test]
    fn help_of_every_command_ends_with_parsable_examples() {
        let program = Cli::command();
        for command in program.get_subcommands().chain([&program]).filter(|command| command.get_name() != "help") {
            let text = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let examples: Vec<&str> = text.strip_prefix("Examples:\n").unwrap_or_default().lines().collect();
            assert_eq!(examples.len(), 2, "{}", command.get_name());
            for example in examples {
                let parsed = Cli::try_parse_from(split_words(example.trim()));
                assert!(parsed.is_ok(), "{example}: {:?}", parsed.err());
            }
        }
    }
}
