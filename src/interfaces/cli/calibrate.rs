//! `plm-impact calibrate`

use std::path::{PathBuf, absolute};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scenario::Override;
use plm_impact::scenario::keys::words::LAWS;

use super::output::OutputArguments;
use super::request::CommandLine;
use super::run::run_scenario;
use super::scenario::ScenarioArguments;
use super::terminal::failed_with;

/// Fit keys (default: yield strength) to measurements, with confidence intervals
///
/// [calibrate] defines fitted keys and noise. Default: the yield strength of the half-space.
/// DATA is a CSV file whose columns name the quantity, with the unit: speed_m_per_s or
/// drop_height_m; restitution, rebound_speed_m_per_s, rebound_height_m, bounce_interval_s, leeb, dent_diameter_m, dent_depth_m,
/// contact_time_s, peak_force_N, each with a column of standard deviations (restitution_sd) if known; other keys of the
/// scenario that change from line to line (sphere_radius_mm); or indentation_m and force_N of an indentation curve.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact calibrate impact.toml --drop-height \"1 m\" --rebound-height \"24 cm\"
  plm-impact calibrate impact.toml rebounds.csv --set law=thornton --out by-thornton")]
pub struct CalibrateArguments {
    #[command(flatten)]
    scenario: ScenarioArguments,
    /// Measurements (replaces calibrate.data)
    #[arg(value_name = "DATA.csv", conflicts_with_all = ["restitution", "rebound_speed", "rebound_height", "leeb", "dent_diameter"])]
    data: Option<PathBuf>,
    /// One measured restitution, instead of a file
    #[arg(long, value_name = "E")]
    restitution: Option<String>,
    /// One measured rebound: --rebound-speed "1.5 m/s"
    #[arg(long, value_name = "SPEED")]
    rebound_speed: Option<String>,
    /// One measured height of a rebound: --rebound-height "24 cm"
    #[arg(long, value_name = "HEIGHT")]
    rebound_height: Option<String>,
    /// One measured Leeb hardness
    #[arg(long, value_name = "HL")]
    leeb: Option<String>,
    /// One measured dent: --dent-diameter "1.2 mm"
    #[arg(long, value_name = "LENGTH")]
    dent_diameter: Option<String>,
    /// Impact speed of the measured impact: --speed "3 m/s"
    #[arg(long, value_name = "SPEED")]
    speed: Option<String>,
    /// Drop height of the measured impact: --drop-height "1 m"
    #[arg(long, value_name = "HEIGHT", conflicts_with = "speed")]
    drop_height: Option<String>,
    /// Also fit all other laws and rank them
    #[arg(long)]
    all_laws: bool,
    #[command(flatten)]
    output: OutputArguments,
}

pub fn calibrate(arguments: &CalibrateArguments) -> Result<(), Error> {
    let CalibrateArguments { scenario: file, output, .. } = arguments;
    let (overrides, table) = (arguments.overrides()?, &super::table::Options::default());
    run_scenario(&CommandLine { file, overrides, output, table, is_calibration: true })
}

impl CalibrateArguments {
    /// The options as keys of the scenario.
    fn overrides(&self) -> Result<Vec<Override>, Error> {
        let mut overrides = Vec::new();
        if let Some(data) = &self.data {
            // a path of the command line is not relative to the scenario
            let path = absolute(data).map_err(failed_with(data.display()))?;
            overrides.push(format!("calibrate.data={}", toml_quote(&path.to_string_lossy())).into());
        }
        let options = [
            ("--restitution", "calibrate.measured.restitution", &self.restitution),
            ("--rebound-speed", "calibrate.measured.rebound_speed", &self.rebound_speed),
            ("--rebound-height", "calibrate.measured.rebound_height", &self.rebound_height),
            ("--leeb", "calibrate.measured.leeb", &self.leeb),
            ("--dent-diameter", "calibrate.measured.dent_diameter", &self.dent_diameter),
            ("--speed", "impact.speed", &self.speed),
            ("--drop-height", "impact.drop_height", &self.drop_height),
        ];
        let given = options.into_iter().filter_map(|(option, key, value)| Some((option, key, value.as_ref()?)));
        overrides.extend(given.map(|(option, key, value)| Override::of_option(option, key, value)));
        if self.all_laws {
            // under the law of Hertz nothing yields
            let laws = (LAWS.values)().into_iter().filter(|law| law != "hertz");
            let laws: Vec<String> = laws.map(|law| toml_quote(&law)).collect();
            overrides.push(format!("calibrate.laws=[{}]", laws.join(",")).into());
        }
        Ok(overrides)
    }
}

/// As TOML.
fn toml_quote(text: &str) -> String {
    toml::Value::from(text).to_string()
}
