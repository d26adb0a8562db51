//! The scenario of the options of `peen`, as a person would write it.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;
use std::path::absolute;

use plm_impact::error::Error;
use plm_impact::scenario::input::NumericKey;
use plm_impact::units::{Dimension, format_number, parse};

use super::super::options::{OptionKeys, push_key, push_recommended_exponent};
use super::super::terminal::failed_with;
use super::PeenArguments;
use super::shot::{ShotText, shot_text};

/// The keys of the scenario that options give.
pub const OPTIONS: OptionKeys = OptionKeys {
    command: "peen",
    options: &[
        ("sphere.material", "--shot-material"),
        ("sphere.diameter", "--diameter"),
        ("sphere.yield_strength", "--shot-strength"),
        ("sphere.hardness", "--shot-hardness"),
        ("half_space.material", "--on"),
        ("half_space.yield_strength", "--strength"),
        ("half_space.strength_kind", "--strength-kind"),
        ("half_space.hardness", "--hardness"),
        ("impact.speed", "--speed"),
        ("impact.angle", "--angle"),
        ("friction.coefficient", "--friction"),
        ("peening.coverage", "--coverage"),
        ("peening.mass_flow", "--mass-flow"),
        ("peening.area", "--area"),
        ("peening.time", "--time"),
        ("calibrate.data", "--dents"),
    ],
};

/// Results of random shots with a distribution.
const SCATTERED: &str = "[\"dent_diameter_m\", \"residual_indentation_m\", \"compressive_layer_depth_m\"]";
/// The speeds between which dents are searched.
const SPEED_RANGE: &str = "{ from = \"1 m/s\", to = \"300 m/s\" }";
/// Values of an axis of the process window.
const WINDOW_POINTS: u32 = 31;

/// # Errors
/// An unknown shot, and an option without a number that a default needs.
pub fn scenario_text(arguments: &PeenArguments) -> Result<String, Error> {
    let ShotText { diameter, comment, material } = shot_text(arguments)?;
    let varies_size = arguments.size_sd.is_some() || arguments.window.is_some();
    let mut text = "# Written by `plm-impact peen`.\n\n[sphere]\n".to_owned();
    push_key(&mut text, "material", Some(&material));
    if !varies_size {
        push_key(&mut text, "diameter", Some(&diameter));
        text = text.trim_end().to_owned() + &comment + "\n";
    }
    push_key(&mut text, "yield_strength", arguments.shot_strength.as_deref());
    push_key(&mut text, "hardness", arguments.shot_hardness.as_deref());
    text.push_str("\n[half_space]\n");
    push_key(&mut text, "material", Some(&arguments.on));
    push_key(&mut text, "yield_strength", arguments.strength.as_deref());
    push_key(&mut text, "strength_kind", arguments.strength_kind.as_deref());
    push_key(&mut text, "hardness", arguments.hardness.as_deref());
    push_recommended_exponent(&mut text);
    if let Some(dents) = &arguments.dents {
        let path = absolute(dents).map_err(failed_with(dents.display()))?;
        text.push_str("\n[calibrate]\n");
        push_key(&mut text, "data", Some(&path.to_string_lossy()));
        let _ = writeln!(text, "free = {{ \"impact.speed\" = {SPEED_RANGE} }}");
        return Ok(text);
    }
    let speed = arguments.speed.as_deref().unwrap_or_default();
    let varies_speed = arguments.speed_sd.is_some() || arguments.window.is_some();
    if !varies_speed || arguments.angle.is_some() {
        text.push_str("\n[impact]\n");
        push_key(&mut text, "speed", Some(speed).filter(|_| !varies_speed));
    }
    if let Some(angle) = &arguments.angle {
        push_angle(&mut text, angle, arguments.friction.unwrap_or(0.0))?;
    }
    text.push_str("\n[peening]\n");
    let _ = writeln!(text, "coverage = {}", arguments.coverage.as_deref().map_or_else(|| "0.98".to_owned(), number));
    push_key(&mut text, "mass_flow", arguments.mass_flow.as_deref());
    push_key(&mut text, "area", arguments.area.as_deref());
    push_key(&mut text, "time", arguments.time.as_deref());
    if arguments.window.is_some() {
        push_window(&mut text, speed, &diameter)?;
    } else if arguments.speed_sd.is_some() || arguments.size_sd.is_some() {
        let _ = writeln!(text, "\n[monte_carlo]\nsamples = {}\nseed = 0", arguments.samples);
        push_scatter(&mut text, "impact.speed", speed, arguments.speed_sd.as_deref());
        push_scatter(&mut text, "sphere.diameter", &diameter, arguments.size_sd.as_deref());
        let _ = writeln!(text, "\n[output]\ncolumns = {SCATTERED}");
    }
    Ok(text)
}

/// A number without quotes, other text in quotes.
fn number(given: &str) -> String {
    given.trim().parse::<f64>().map_or_else(|_| toml::Value::from(given).to_string(), |_| given.trim().to_owned())
}

/// The angle from the normal. A peener counts the angle from the surface.
fn push_angle(text: &mut String, angle: &str, friction: f64) -> Result<(), Error> {
    let refuse = |reason: String| Error::input(format!("--angle: {reason}"));
    let from_surface = parse(angle, Dimension::Angle).map_err(|error| refuse(error.to_string()))?;
    if !(from_surface > 0.0 && from_surface <= FRAC_PI_2) {
        let message = "is not allowed. The angle of the jet is counted from the surface, and must be > 0 deg and <= 90 deg, which is normal to the surface.";
        return Err(refuse(format!("\"{angle}\" {message}")));
    }
    let from_normal = format_number(90.0 - from_surface.to_degrees());
    let _ = writeln!(text, "angle = \"{from_normal} deg\"   # from the normal; {angle} from the surface");
    let _ = write!(text, "\n[friction]\ncoefficient = {}\n", toml::Value::from(friction));
    Ok(())
}

/// A normal distribution.
fn push_scatter(text: &mut String, key: &str, mean: &str, sd: Option<&str>) {
    if let Some(sd) = sd {
        let [mean, sd] = [mean, sd].map(toml::Value::from);
        let _ = writeln!(text, "\"{key}\" = {{ normal = {{ mean = {mean}, sd = {sd} }} }}");
    }
}

/// Speeds and sizes from half to twice the given ones.
fn push_window(text: &mut String, speed: &str, diameter: &str) -> Result<(), Error> {
    text.push_str("\n[sweep]\n");
    for (key, given) in [("impact.speed", speed), ("sphere.diameter", diameter)] {
        let option = OPTIONS.options.iter().find(|(known, _)| *known == key).map_or(key, |(_, option)| option);
        let refuse = |reason: String| Error::input(format!("{option}: {reason}"));
        let quantity = NumericKey::find(key).map(NumericKey::quantity);
        let value = quantity.map_or(Ok(f64::NAN), |quantity| quantity.parse(given)).map_err(refuse)?;
        let [low, high] = [0.5, 2.0].map(|factor| format_number(factor * value));
        let _ = writeln!(text, "\"{key}\" = {{ logspace = [{low}, {high}], points = {WINDOW_POINTS} }}");
    }
    text.push_str("\n[output]\npicture = [\"dent_diameter_m\"]\n");
    Ok(())
}
