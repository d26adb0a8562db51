//! `plm-impact peen`

mod arguments;
mod compute;
mod dents;
mod scenario_text;
mod shot;

use std::path::Path;

use plm_impact::error::{Error, ErrorKind};
use plm_impact::files::create;
use plm_impact::report::chart::PictureFormat;
use plm_impact::report::run::{Outcome, no_result_error, refuse_warnings};
use plm_impact::scenario::Scenario;
use plm_impact::units::format_four_digits;

pub use self::arguments::PeenArguments;
use self::compute::{compute, read, summary};
use self::scenario_text::{OPTIONS, scenario_text};
use super::scenario::write_new_scenario;

/// Behind the results of a dent.
const NOT_CLAIMED: &str = "Depths and compression belong to one dent. Overlapping dents give another residual stress, which is not computed; nor is the Almen
intensity.
";
/// A warning about a hardness or a strength of the shot that changes nothing. Every shot of steel needs one of the two.
const UNUSED_SHOT_STRENGTH: [&str; 2] = ["--shot-hardness has no effect", "--shot-strength has no effect"];

/// A picture in a vector format has files of this extension.
const SVG: &str = "svg";

pub fn peen(arguments: &PeenArguments) -> Result<(), Error> {
    let text = scenario_text(arguments)?;
    let scenario = read(&text)?;
    let outcome = compute(&scenario, picture_format(arguments))?;
    let mut warnings: Vec<String> = outcome.warnings.iter().map(|text| OPTIONS.with_options(text)).collect();
    warnings.retain(|warning| !UNUSED_SHOT_STRENGTH.iter().any(|begin| warning.starts_with(begin)));
    super::output::print_warnings(&warnings);
    refuse_warnings(&scenario, warnings.len(), arguments.strict)?;
    if arguments.json {
        super::output::print_summary(&outcome.files)?;
    } else {
        let mut printed = OPTIONS.with_options(&outcome.terminal_text());
        match (&arguments.dents, &arguments.window) {
            (Some(_), _) => printed.push_str(&dents::band_text(arguments, &text)?),
            (None, Some(_)) => {}
            (None, None) => printed.push_str(&limits_text(&scenario, &outcome)?),
        }
        super::terminal::print(&printed)?;
    }
    if let Some(path) = &arguments.window {
        write_window(path, &outcome)?;
    }
    arguments.save.as_ref().map_or(Ok(()), |path| write_new_scenario(path, &text, "--save"))?;
    outcome.contradiction.map_or(Ok(()), |reason| Err(Error::new(ErrorKind::Mismatch, format!("--dents: {reason}"))))
}

/// The limits of the results.
fn limits_text(scenario: &Scenario, outcome: &Outcome) -> Result<String, Error> {
    let ratio = summary(outcome).and_then(|summary| summary["contact_radius_over_R"].as_f64());
    let Some(ratio) = ratio else { return Ok(format!("\n{NOT_CLAIMED}")) };
    let contact = scenario.resolve_bodies()?.1.map_err(|reason| no_result_error(scenario, &reason))?;
    Ok(format!(
        "\nThe contact radius is {} of the radius of the shot; the law is valid up to {}.\n{NOT_CLAIMED}",
        format_four_digits(ratio),
        contact.max_radius_ratio()
    ))
}

fn picture_format(arguments: &PeenArguments) -> PictureFormat {
    let Some(path) = &arguments.window else { return PictureFormat::None };
    if path.extension().is_some_and(|extension| extension == SVG) { PictureFormat::Svg } else { PictureFormat::Png }
}

/// Writes the process window, never over a file that is there.
fn write_window(path: &Path, outcome: &Outcome) -> Result<(), Error> {
    let picture = outcome.files.iter().find(|file| file.name.starts_with("process_window"));
    let bytes = picture.map_or(&[][..], |file| &file.bytes);
    let name = path.display();
    let refuse =
        |reason| Error::input(format!("{name}: cannot be written: {reason}. Choose another file with --window."));
    create(path, bytes).map_err(refuse)?;
    super::terminal::note(format_args!("wrote {name}"));
    Ok(())
}
