//! `plm-impact drop`

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{ArgGroup, Args};
use plm_impact::error::Error;
use plm_impact::files::Progress;
use plm_impact::materials::{Property, find};
use plm_impact::report::chart::PictureFormat;
use plm_impact::report::run::{RunOptions, refuse_warnings};
use plm_impact::report::text::Detail;
use plm_impact::scenario::Scenario;

use super::options::{OptionKeys, push_key, push_recommended_exponent};
use super::scenario::write_new_scenario;

/// Simulate one impact of a ball on a library material (no scenario file needed)
///
/// Prints the coefficient of restitution with its interval, rebound height, dent, force and time. Uses unloading_exponent = "pressure-shape".
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("approach").required(true), after_help = "Examples:
  plm-impact drop --ball steel-52100-hardened --diameter \"10 mm\" --on aluminium-6061-t6 --from \"1 m\"
  plm-impact drop --ball alumina-99.5 --diameter \"5 mm\" --on steel-s235 --speed \"2 m/s\" --save drop.toml")]
pub struct DropArguments {
    /// Material of the ball; `plm-impact materials` lists all
    #[arg(long, value_name = "MATERIAL")]
    ball: String,
    /// Diameter of the ball, such as "10 mm"
    #[arg(long)]
    diameter: String,
    /// Material of the target
    #[arg(long, value_name = "MATERIAL")]
    on: String,
    /// Thickness of a plate target [default: half-space]
    #[arg(long)]
    thickness: Option<String>,
    /// Height of the fall, such as "1 m"
    #[arg(long, value_name = "HEIGHT", group = "approach")]
    from: Option<String>,
    /// Impact speed, such as "3 m/s"
    #[arg(long, group = "approach")]
    speed: Option<String>,
    /// Angle of impact from the normal, such as "30 deg"
    #[arg(long, requires = "friction")]
    angle: Option<String>,
    /// Coefficient of friction
    #[arg(long, requires = "angle")]
    friction: Option<f64>,
    /// Override the yield strength of the target
    #[arg(long, conflicts_with = "hardness")]
    strength: Option<String>,
    /// Which stress the strength is: "flow" in the impact, or the 0.2 % "proof" stress
    #[arg(long, value_name = "KIND")]
    strength_kind: Option<String>,
    /// Override the yield strength of the ball
    #[arg(long, value_name = "STRENGTH", conflicts_with = "ball_hardness")]
    ball_strength: Option<String>,
    /// Which stress the strength of the ball is: "flow" or "proof"
    #[arg(long, value_name = "KIND")]
    ball_strength_kind: Option<String>,
    /// Override the hardness of the ball, such as "63 HRC"
    #[arg(long, value_name = "HARDNESS")]
    ball_hardness: Option<String>,
    /// Override the hardness of the target, such as "300 HV"
    #[arg(long)]
    hardness: Option<String>,
    /// Write the scenario to this file, to go on with `plm-impact run`
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,
    /// Print all results as JSON
    #[arg(long)]
    json: bool,
    /// Treat warnings as errors (exit code 1)
    #[arg(long)]
    strict: bool,
}

pub fn drop(arguments: &DropArguments) -> Result<(), Error> {
    let text = arguments.scenario();
    let scenario =
        Scenario::from_text(&OPTIONS.scenario_name(), &text, &[]).map_err(|error| OPTIONS.error_at_options(error))?;
    let options = RunOptions {
        command: &super::output::command_line(),
        detail: Detail::Brief,
        pictures: PictureFormat::None,
        progress: &Progress::default(),
    };
    let outcome = super::request::run_whole(&scenario, &options).map_err(|error| OPTIONS.error_at_options(error))?;
    let warnings: Vec<String> = outcome.warnings.iter().map(|text| OPTIONS.with_options(text)).collect();
    super::output::print_warnings(&warnings);
    refuse_warnings(&scenario, outcome.warnings.len(), arguments.strict)?;
    if arguments.json {
        super::output::print_summary(&outcome.files)?;
    } else {
        super::terminal::print(&OPTIONS.with_options(&outcome.terminal_text()))?;
    }
    arguments.save.as_ref().map_or(Ok(()), |path| write_new_scenario(path, &text, "--save"))
}

/// The keys of the scenario that options give.
const OPTIONS: OptionKeys = OptionKeys {
    command: "drop",
    options: &[
        ("sphere.material", "--ball"),
        ("sphere.diameter", "--diameter"),
        ("sphere.yield_strength", "--ball-strength"),
        ("sphere.hardness", "--ball-hardness"),
        ("sphere.strength_kind", "--ball-strength-kind"),
        ("half_space.material", "--on"),
        ("half_space.thickness", "--thickness"),
        ("half_space.yield_strength", "--strength"),
        ("half_space.strength_kind", "--strength-kind"),
        ("half_space.hardness", "--hardness"),
        ("impact.drop_height", "--from"),
        ("impact.speed", "--speed"),
        ("impact.angle", "--angle"),
        ("friction.coefficient", "--friction"),
    ],
};

impl DropArguments {
    /// The scenario, as a person would write it.
    fn scenario(&self) -> String {
        let mut text = "# Written by `plm-impact drop`.\n\n[sphere]\n".to_owned();
        push_key(&mut text, "material", Some(&self.ball));
        push_key(&mut text, "diameter", Some(&self.diameter));
        push_key(&mut text, "yield_strength", self.ball_strength.as_deref());
        push_key(&mut text, "hardness", self.ball_hardness.as_deref());
        push_key(&mut text, "strength_kind", self.ball_strength_kind.as_deref());
        text.push_str("\n[half_space]\n");
        push_key(&mut text, "material", Some(&self.on));
        push_key(&mut text, "thickness", self.thickness.as_deref());
        push_key(&mut text, "yield_strength", self.strength.as_deref());
        push_key(&mut text, "hardness", self.hardness.as_deref());
        push_key(&mut text, "strength_kind", self.strength_kind.as_deref());
        text.push_str("\n[impact]\n");
        push_key(&mut text, "drop_height", self.from.as_deref());
        push_key(&mut text, "speed", self.speed.as_deref());
        push_key(&mut text, "angle", self.angle.as_deref());
        if let Some(friction) = self.friction {
            let _ = write!(text, "\n[friction]\ncoefficient = {}\n", toml::Value::from(friction));
        }
        // a key that has no effect would be warned of
        let strengths = [&self.ball_strength, &self.ball_hardness, &self.strength, &self.hardness];
        if !strengths.into_iter().any(Option::is_some)
            && ![&self.ball, &self.on].into_iter().any(|name| may_yield(name))
        {
            return text;
        }
        push_recommended_exponent(&mut text);
        text
    }
}

/// Whether a material has a strength, or is not known.
fn may_yield(name: &str) -> bool {
    find(name).is_none_or(|material| material.get(Property::Hardness).is_some())
}
