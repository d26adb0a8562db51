//! `plm-impact fit-plm`

use std::path::{Path, PathBuf};

use clap::Args;
use plm_impact::error::Error;
use plm_impact::fit::{self, LoadingCurve, Plan, report, solve};
use plm_impact::law::PlmCoefficients;
use plm_impact::output::{foreign, refuse_special, replace, unwritable};
use plm_impact::scenario::{LARGEST_SCENARIO, read_text};

/// Determine PLM coefficients from loading curves: a file for `[law.plm] coefficients`, deviations to the terminal
///
/// A curve is a CSV file. Comment lines name its bodies, as keys of a scenario:
/// `# sphere.youngs_modulus = 208 GPa`, `# sphere.poissons_ratio = 0.3`, `# half_space.youngs_modulus = 210 GPa`,
/// `# half_space.poissons_ratio = 0.3`, `# half_space.yield_strength = 345 MPa` and, for columns in SI units,
/// `# sphere.radius = 35 mm`. Columns: indentation_m, force_N, sphere_indentation_m (or elastic_approach_m), and
/// contact_radius_m if known; or, without units, delta_over_deltaY, F_over_FY, delta_s_over_delta, a_over_R.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact fit-plm curve-1.csv curve-2.csv -o fitted.toml
  plm-impact fit-plm curve-1.csv curve-2.csv --fit-knots --name \"my alloys\" -o free.toml")]
pub struct Arguments {
    /// Loading curves, best of several ratios of the moduli
    #[arg(value_name = "CURVES.csv", required = true)]
    curves: Vec<PathBuf>,
    /// File of coefficients to write
    #[arg(short, long = "out", value_name = "FILE")]
    out: PathBuf,
    /// Replace FILE whatever it is; without, only if this command wrote it
    #[arg(long)]
    force: bool,
    /// What results will call the coefficients [default: PLM, name of the file]
    #[arg(long)]
    name: Option<String>,
    /// Knots of the force, delta/delta_Y of each [default: those of the built-in table]
    #[arg(long, value_name = "X1,X2,…", value_delimiter = ',')]
    knots: Vec<f64>,
    /// Fit the knots too, from those given or built in
    #[arg(long)]
    fit_knots: bool,
}

pub fn fit_plm(arguments: &Arguments) -> Result<(), Error> {
    let nameless = || Error::input(format!("--out {}: is not the name of a file", arguments.out.display()));
    let file_name = arguments.out.file_name().and_then(|name| name.to_str()).ok_or_else(nameless)?;
    let curves = arguments.curves.iter().map(|path| LoadingCurve::load(path)).collect::<Result<Vec<_>, _>>()?;
    let is_out = |path: &PathBuf| {
        path.canonicalize().ok().is_some_and(|path| arguments.out.canonicalize().is_ok_and(|out| out == path))
    };
    if arguments.curves.iter().any(is_out) {
        return Err(Error::input(format!(
            "--out {}: is one of the curves; name another file",
            arguments.out.display()
        )));
    }
    let built_in = PlmCoefficients::built_in();
    let start = match &arguments.knots[..] {
        [] => built_in.clone(),
        knots => fit::knots::with_knots(built_in, knots)?,
    };
    may_replace(&arguments.out, arguments.force)?;
    let plan = Plan { start, has_knots: arguments.fit_knots };
    let fitted = fit::fit(&curves, &plan)?;
    let default_name = || format!("PLM, {}", Path::new(file_name).with_extension("").display());
    let name = arguments.name.clone().unwrap_or_else(default_name);
    let coefficients = report::coefficients(&fitted, &name, &super::output::command_line());
    let text = report::toml(&coefficients)?;
    replace(&arguments.out, text.as_bytes()).map_err(unwritable(&arguments.out))?;
    let of_built_in: Vec<_> = curves.iter().map(|curve| solve::case_fit(curve, built_in)).collect();
    super::terminal::print(&report::table(&fitted, &of_built_in))?;
    super::terminal::note(format_args!("wrote {}", arguments.out.display()));
    Ok(())
}

/// A file of coefficients names the command that wrote it.
fn may_replace(out: &Path, is_forced: bool) -> Result<(), Error> {
    refuse_special(out).map_err(unwritable(out))?;
    let is_own = || read_text(out, LARGEST_SCENARIO).is_ok_and(|text| text.contains("plm-impact fit-plm "));
    if is_forced || !out.exists() || is_own() { Ok(()) } else { Err(foreign(out)) }
}
