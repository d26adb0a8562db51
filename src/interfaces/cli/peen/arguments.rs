//! The options of `plm-impact peen`.

use std::path::PathBuf;

use clap::{ArgGroup, Args};

/// Shot peening: dent, coverage, mass of shot and time (no scenario file needed)
///
/// Prints the dent of one shot, and how many impacts, how much shot and how much time cover the surface.
/// Almen intensity and the residual stress of a peened surface are not computed.
#[derive(Debug, Args)]
#[command(
    group = ArgGroup::new("size").required(true),
    group = ArgGroup::new("approach").required(true),
    after_help = "Examples:
  plm-impact peen --shot S230 --shot-hardness \"46 HRC\" --speed \"60 m/s\" --on steel-4140-qt --mass-flow \"5 kg/min\" --area \"50 cm^2\"
  plm-impact peen --shot S230 --shot-hardness \"46 HRC\" --speed \"60 m/s\" --speed-sd \"6 m/s\" --on aluminium-7075-t6 --save peen.toml"
)]
pub struct PeenArguments {
    /// Shot by its trade name: S70 to S780, CW14 to CW62, GB10 to GB100, Z100 to Z850
    #[arg(long, value_name = "NAME", group = "size")]
    pub shot: Option<String>,
    /// Diameter of the shot, such as "0.6 mm"
    #[arg(long, group = "size")]
    pub diameter: Option<String>,
    /// Material of the shot [default: cast steel for S, bearing steel for CW, soda-lime glass for GB]
    #[arg(long, value_name = "MATERIAL")]
    pub shot_material: Option<String>,
    /// Hardness of the shot, such as "46 HRC"
    #[arg(long, conflicts_with = "shot_strength")]
    pub shot_hardness: Option<String>,
    /// Yield strength of the shot, instead of its hardness
    #[arg(long)]
    pub shot_strength: Option<String>,
    /// Material of the target; `plm-impact materials` lists all
    #[arg(long, value_name = "MATERIAL")]
    pub on: String,
    /// Override the hardness of the target, such as "300 HV"
    #[arg(long, value_name = "HARDNESS", conflicts_with = "strength")]
    pub hardness: Option<String>,
    /// Override the yield strength of the target
    #[arg(long, value_name = "STRENGTH")]
    pub strength: Option<String>,
    /// Which stress the strength of the target is: "flow" in the impact, or the 0.2 % "proof" stress
    #[arg(long, value_name = "KIND", requires = "strength")]
    pub strength_kind: Option<String>,
    /// Speed of the shot, such as "60 m/s"
    #[arg(long, group = "approach")]
    pub speed: Option<String>,
    /// Measured diameters of single dents (CSV, column dent_diameter_mm): find the speed
    #[arg(long, value_name = "FILE", group = "approach", conflicts_with_all = ["angle", "friction", "coverage", "mass_flow", "time", "speed_sd", "size_sd", "window"])]
    pub dents: Option<PathBuf>,
    /// Angle of the jet from the surface; "90 deg" is normal [default: 90 deg]
    #[arg(long)]
    pub angle: Option<String>,
    /// Coefficient of friction of an oblique impact [default: 0]
    #[arg(long, requires = "angle")]
    pub friction: Option<f64>,
    /// Coverage to reach, as a fraction [default: 0.98]
    #[arg(long)]
    pub coverage: Option<String>,
    /// Mass of shot per time, such as "5 kg/min"
    #[arg(long, requires = "area")]
    pub mass_flow: Option<String>,
    /// Area that the shot hits, such as "50 cm^2"
    #[arg(long, requires = "mass_flow")]
    pub area: Option<String>,
    /// Time of peening, for the coverage after this time
    #[arg(long, requires = "mass_flow")]
    pub time: Option<String>,
    /// Standard deviation of the speed
    #[arg(long, value_name = "SPEED")]
    pub speed_sd: Option<String>,
    /// Standard deviation of the diameter of the shot
    #[arg(long, value_name = "LENGTH")]
    pub size_sd: Option<String>,
    /// Random shots, if speed or size scatter
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    pub samples: u64,
    /// Draw the process window to this file (.png or .svg): dent diameter and impacts over half to twice the speed and size
    #[arg(long, value_name = "FILE", conflicts_with_all = ["speed_sd", "size_sd"])]
    pub window: Option<PathBuf>,
    /// Write the scenario to this file, to go on with `plm-impact run`
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// Print all results as JSON
    #[arg(long)]
    pub json: bool,
    /// Treat warnings as errors (exit code 1)
    #[arg(long)]
    pub strict: bool,
}
