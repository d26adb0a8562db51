//! `plm-impact check-trace`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::contact_trace::ContactTrace;
use plm_impact::error::{Details, Error};
use plm_impact::files::{begins_like, foreign_file_error, refuse_special, replace, unwritable_error};
use plm_impact::impact::Impact;
use plm_impact::interfaces::export::impact_without_surroundings;
use plm_impact::report::pictures::contact_trace;
use plm_impact::report::text::contact_trace::{contact_trace_json, contact_trace_text};
use plm_impact::scenario::keys::quantity::MASS;
use plm_impact::scenario::{MAX_DATA_MIB, Override, Scenario, read_text};

use super::output::{PictureArguments, print_warnings};

/// Check one contact of another code: its restitution and energy, compared with the law
///
/// The trace is a table with time, indentation (positive in contact) and force of every step of one contact, with steps before and after
/// the contact. Names of columns have units: `time_s,indentation_m,force_N`, `t,delta,F` (SI), `Time (ms) Overlap (um) Force (N)`. Columns
/// are separated by commas, semicolons, tabs or spaces. The exit code is 1 if the contact creates energy.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact check-trace contact.csv impact.toml --out pictures
  plm-impact check-trace contact.csv --mass \"4 g\" --json")]
pub struct CheckTraceArguments {
    /// Trace of one contact
    #[arg(value_name = "TRACE.csv")]
    trace: PathBuf,
    /// Scenario: the trace is compared with the law of this scenario at the same speed
    #[arg(value_name = "FILE")]
    scenario: Option<PathBuf>,
    /// Override a key of the scenario; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "scenario")]
    overrides: Vec<String>,
    /// Mass of the relative motion, for the restitution by work: m of a sphere on a wall, m1 m2/(m1 + m2) of two spheres [default: mass in
    /// the scenario]
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    mass: Option<String>,
    /// Folder for the picture contact_trace [default: plots/<name of the trace>]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    pictures: PictureArguments,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Rows of the loop of the law.
const N_SAMPLES: usize = 400;

pub fn check_trace(arguments: &CheckTraceArguments) -> Result<(), Error> {
    let CheckTraceArguments { trace: path, scenario, overrides, mass, out, pictures, json } = arguments;
    let name = path.display().to_string();
    let trace = ContactTrace::parse(&read_text(path, MAX_DATA_MIB)?).map_err(|(line, message)| {
        let at = line.map_or_else(String::new, |line| format!(":{line}"));
        let error = Error::input(format!("{name}{at}: {message}"));
        error.with_details(Details { message: Some(message), file: Some(name.clone()), line, ..Details::default() })
    })?;
    let given_mass =
        mass.as_deref().map(|text| MASS.parse(text).map_err(|problem| Error::input(format!("--mass: {problem}"))));
    let given_mass = given_mass.transpose()?;
    let speed = trace.measures(None).speed;
    let law: Option<(f64, Impact)> = scenario
        .as_deref()
        .map(|file| {
            let scenario = Scenario::load(file, &Override::list(overrides))?;
            impact_without_surroundings(&scenario, speed, N_SAMPLES)
        })
        .transpose()?;
    let measures = trace.measures(given_mass.or(law.as_ref().map(|(mass, _)| *mass)));
    let impact = law.as_ref().map(|(_, impact)| impact);
    let mut warnings = measures.warnings();
    warnings.extend(impact.iter().flat_map(|impact| &impact.warnings).map(|warning| format!("law: {warning}")));
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let folder = out.clone().unwrap_or_else(|| Path::new("plots").join(stem));
    let chart = || contact_trace(&stem.to_string_lossy(), &trace, &measures, impact);
    let mut written = None;
    for file in pictures.format.to_files(|| Ok(vec![("contact_trace", chart())]))? {
        let place = folder.join(&file.name);
        refuse_special(&place).map_err(unwritable_error(&place))?;
        if place.exists() && !begins_like(&place, &file.bytes).map_err(unwritable_error(&place))? {
            return Err(foreign_file_error(&place, "Move the file, or choose another --out."));
        }
        replace(&place, &file.bytes).map_err(unwritable_error(&place))?;
        written = Some(place);
    }
    for note in &trace.notes {
        super::terminal::note(format_args!("{name}: {note}"));
    }
    print_warnings(&warnings);
    if *json {
        super::terminal::print_json(&format!("{:#}\n", contact_trace_json(&measures, impact, &warnings)))?;
    } else {
        super::terminal::print(&contact_trace_text(&measures, impact))?;
        if !measures.are_free_speeds {
            super::terminal::note(
                "the speeds are those of the first and the last step in contact. Add two steps before and after the contact.",
            );
        }
        if let Some(place) = written {
            super::terminal::note(format_args!("wrote {}", place.display()));
        }
    }
    if measures.made_energy() {
        return Err(Error::failed(format!("{name}: the contact creates energy")));
    }
    Ok(())
}
