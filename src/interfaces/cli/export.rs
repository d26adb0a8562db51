//! `plm-impact export`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::interfaces::export::{ExportRequest, TargetCode, export as lines};
use plm_impact::scenario::keys::quantity::SPEED;

use super::output::parse_choice;
use super::scenario::ScenarioArguments;

/// Print contact parameters for a DEM code, or a table e(v)
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact export impact.toml --to lammps --speed \"1 m/s\"
  plm-impact export impact.toml --to csv --speeds \"0.1 m/s,10 m/s\"")]
pub struct ExportArguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// Target code
    #[arg(long, value_name = "CODE", value_parser = parse_choice(TargetCode::ALL, TargetCode::name))]
    to: TargetCode,
    /// Impact speed [default: speed of the scenario]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    /// First and last speed of a table e(v), such as "0.1 m/s,10 m/s" [default: a tenth to ten times the speed]
    #[arg(long, value_name = "FROM,TO", conflicts_with = "speed", allow_hyphen_values = true)]
    speeds: Option<String>,
}

pub fn export(arguments: &ExportArguments) -> Result<(), Error> {
    let request = ExportRequest {
        target: arguments.to,
        speed: arguments.speed.as_deref().map(|text| speed("--speed", text)).transpose()?,
        speeds: arguments.speeds.as_deref().map(speeds).transpose()?,
    };
    let scenario = arguments.scenario.load()?;
    let text = lines(&scenario, &request, &super::output::command_line())?;
    super::terminal::print(&text)
}

/// A speed with its unit, or a number in m/s.
fn speed(option: &str, text: &str) -> Result<f64, Error> {
    let number = text.parse::<f64>().map(|number| format!("{number} m/s"));
    SPEED.parse(number.as_deref().unwrap_or(text)).map_err(|problem| Error::input(format!("{option}: {problem}")))
}

fn speeds(text: &str) -> Result<(f64, f64), Error> {
    let both = text.split_once(',').ok_or_else(|| {
        Error::input(format!(
            "--speeds: \"{text}\" is not two speeds. Write the first and the last, such as \"0.1 m/s,10 m/s\"."
        ))
    })?;
    let (from, to) = (speed("--speeds", both.0.trim())?, speed("--speeds", both.1.trim())?);
    if from >= to {
        return Err(Error::input(format!("--speeds: the first speed of \"{text}\" is not below the last")));
    }
    Ok((from, to))
}
