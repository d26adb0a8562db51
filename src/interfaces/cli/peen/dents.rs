//! The speed of the shot from measured dents: what the hardness of the target changes in it.

use plm_impact::error::Error;
use plm_impact::materials::{Property, find};
use plm_impact::report::chart::PictureFormat;
use plm_impact::units::{Dimension, format_result};

use super::PeenArguments;
use super::compute::{compute, read, summary};

/// A line with the speeds at both ends of the range of hardness of the target; empty for a hardness or a strength that is given.
///
/// # Errors
/// A fit that fails.
pub fn band_text(arguments: &PeenArguments, text: &str) -> Result<String, Error> {
    let is_given = arguments.hardness.is_some() || arguments.strength.is_some();
    let hardness = find(&arguments.on).and_then(|material| material.get(Property::Hardness));
    let Some(hardness) = hardness.filter(|_| !is_given) else { return Ok(String::new()) };
    let mut speeds = Vec::new();
    for end in &hardness.range {
        let value = toml::Value::from(end.text.as_str());
        let at_end = text.replacen("[half_space]\n", &format!("[half_space]\nhardness = {value}\n"), 1);
        let outcome = compute(&read(&at_end)?, PictureFormat::None)?;
        let speed = summary(&outcome).and_then(|summary| summary["keys"][0]["estimate"].as_f64());
        let speed = speed.ok_or_else(|| Error::failed("the fitted speed is missing"))?;
        speeds.push(format!("{} at {}", format_result(speed, Dimension::Speed), end.text));
    }
    Ok(format!(
        "\nThe hardness of {} varies: the speed is {}. Give the measured --hardness.\n",
        arguments.on,
        speeds.join(", and ")
    ))
}
