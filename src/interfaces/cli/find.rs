//! `plm-impact find`

use std::sync::LazyLock;

use clap::{Arg, ArgGroup, ArgMatches, Args, Command, FromArgMatches};
use plm_impact::error::Error;
use plm_impact::report::run::find::{Question, find as find_values};
use plm_impact::report::run::refuse_warnings;
use plm_impact::results::impact::impact_results;
use plm_impact::scenario::kinds::inverse::{name_without_unit, read_result};

use super::output::shell_quote;
use super::scenario::ScenarioArguments;
use super::watch::Watch;

/// Find the values of a key that give a wanted result (which drop height makes a dent of 1 mm?)
///
/// Prints every solution in the range of KEY, with its impact. Writes no files. --restitution is the measured one: with elastic waves
/// if the half-space has a density. The name of an option is the name of a result without its unit.
#[derive(Debug, Args)]
#[command(
    override_usage = "plm-impact find [OPTIONS] <KEY> <FILE> --RESULT <VALUE>",
    after_help = "Examples:
  plm-impact find impact.drop_height impact.toml --dent-diameter \"1 mm\"
  plm-impact find impact.speed impact.toml --restitution 0.5 --from \"1 mm/s\" --to \"50 m/s\""
)]
pub struct FindArguments {
    /// Numeric key, such as impact.drop_height; `plm-impact keys` lists all
    #[arg(value_name = "KEY")]
    key: String,
    #[command(flatten)]
    scenario: ScenarioArguments,
    #[command(flatten)]
    wanted: WantedResult,
    /// Lower end of the range of KEY [default: the value of the scenario over 100; of a strength, all metals]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<String>,
    /// Upper end of the range of KEY [default: 100 times the value of the scenario]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<String>,
    /// Print JSON, with all results of every solution
    #[arg(long)]
    json: bool,
    /// Treat warnings as errors (exit code 1)
    #[arg(long)]
    strict: bool,
}

pub fn find(arguments: &FindArguments) -> Result<(), Error> {
    let FindArguments { key, wanted, from, to, .. } = arguments;
    let WantedResult(Some(WantedValue { option, name, text })) = wanted.clone() else {
        return Err(Error::input(
            "no result is given. Name one result and its wanted value, such as --dent-diameter \"1 mm\". `plm-impact find --help` lists results.",
        ));
    };
    let wanted = read_result(name, &text).map_err(|reason| Error::input(format!("--{option} {text}: {reason}")))?;
    let scenario = arguments.scenario.load()?;
    let (key, range) = (key.clone(), [from.clone(), to.clone()]);
    let (scenario, answer) = Watch::without_files(true).watch(move |progress| {
        let range = [0, 1].map(|end| range[end].as_deref());
        let answer = find_values(&scenario, &Question { key: &key, range, result: name, wanted }, progress)?;
        Ok((scenario, answer))
    })?;
    super::output::print_warnings(&answer.warnings);
    refuse_warnings(&scenario, answer.warnings.len(), arguments.strict)?;
    if arguments.json {
        return super::terminal::print_json(&format!("{:#}\n", answer.json));
    }
    super::terminal::print(&answer.text)?;
    if let ([[key, value]], Some(file)) = (&answer.settings[..], arguments.scenario.file()) {
        let settings = arguments.scenario.settings().iter().map(String::as_str);
        let settings: Vec<String> = settings
            .chain([format!("{key}={value}").as_str()])
            .map(|setting| format!("--set {}", shell_quote(setting)))
            .collect();
        let file = shell_quote(&file.to_string_lossy());
        super::terminal::note(format_args!("Next: `plm-impact run {file} {}`", settings.join(" ")));
    }
    Ok(())
}

/// The wanted result, if it is given. There is one option for every result of an impact.
#[derive(Debug, Clone)]
struct WantedResult(Option<WantedValue>);

/// The option that names the result, and its value.
#[derive(Debug, Clone)]
struct WantedValue {
    /// The name of the option, without hyphens before it.
    option: &'static str,
    /// The name of the result.
    name: &'static str,
    /// The value, as it is written.
    text: String,
}

/// An option that names a result.
struct ResultOption {
    /// Without hyphens before it.
    option: String,
    /// The name of the result.
    name: &'static str,
    description: &'static str,
    /// True if the help shows the option.
    is_shown: bool,
}

static OPTIONS: LazyLock<Vec<ResultOption>> = LazyLock::new(|| {
    let option = |name: &str| name_without_unit(name).to_lowercase().replace(['_', '.'], "-");
    // texts, lists, and numbers about the computation are not what an experiment wants; a search computes no pulse
    let text_ends = ["_text", "_scale", "_interval", "_parts", "_interval_m"];
    let is_text = |name: &str| text_ends.iter().any(|end| name.ends_with(end));
    let other_begins = ["warnings", "notes", "work.", "accuracy.", "pulse."];
    let is_other = |name: &str| other_begins.iter().any(|begin| name.starts_with(begin));
    let results = impact_results();
    let wanted = results.iter().filter(|result| !is_text(result.name) && !is_other(result.name));
    wanted
        .map(|result| ResultOption {
            option: option(result.name),
            name: result.name,
            description: result.description,
            is_shown: result.is_brief,
        })
        .collect()
});

const GROUP: &str = "result";

impl WantedResult {
    fn add_options(command: Command) -> Command {
        let options = OPTIONS.iter().map(|ResultOption { option, name, description, is_shown }| {
            // the full name of a result is right too
            let alias = Some(*name).filter(|name| name != option);
            Arg::new(option.as_str())
                .long(option.as_str())
                .aliases(alias)
                .value_name("VALUE")
                .help(*description)
                .help_heading("Results (one of them; results.md lists more)")
                .allow_hyphen_values(true)
                .hide(!is_shown)
        });
        let ids = OPTIONS.iter().map(|result| result.option.as_str());
        command.args(options).group(ArgGroup::new(GROUP).args(ids).multiple(false))
    }
}

impl Args for WantedResult {
    /// Other commands start without these options.
    fn augment_args(command: Command) -> Command {
        command.defer(Self::add_options)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for WantedResult {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = OPTIONS.iter().find_map(|ResultOption { option, name, .. }| {
            Some(WantedValue { option, name, text: matches.get_one::<String>(option)?.clone() })
        });
        Ok(Self(given))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
