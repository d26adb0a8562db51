//! `plm-impact bench`

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use plm_impact::bench::throughput::throughput;
use plm_impact::bench::{hard_cases, laws, measure, problems, report};
use plm_impact::error::Error;
use plm_impact::output::{Origin, OutputDirectory, OutputFile};
use plm_impact::run::table;
use plm_impact::scenario::Scenario;

use super::terminal::other;

/// Measure speed against error of every method: CSV, pictures, and tables on the terminal and as Markdown
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact bench --out bench
  plm-impact bench --quick --out quick-bench")]
pub struct Arguments {
    /// Output directory
    #[arg(long, value_name = "DIR", default_value = "plots/bench")]
    out: PathBuf,
    /// Replace files that this program did not write
    #[arg(long)]
    force: bool,
    /// A third of the settings and a tenth of the rounds
    #[arg(long)]
    quick: bool,
}

/// The report in Markdown.
const PAGE: &str = "README.md";

pub fn bench(arguments: &Arguments) -> Result<(), Error> {
    let directory = OutputDirectory::prepare(&arguments.out, Origin::Command("bench"), arguments.force)?;
    let (rounds, burst) =
        if arguments.quick { (3, Duration::from_micros(200)) } else { (60, Duration::from_micros(500)) };
    let mut all = Vec::new();
    for problem in problems::problems().map_err(other("problems"))? {
        super::terminal::note(format_args!("measuring {}: {}", problem.name, problem.about));
        let measurements = measure::measure(&problem, arguments.quick, rounds, burst);
        all.push((problem, measurements));
    }
    let cases = hard_cases::hard_cases().map_err(other("hard cases"))?;
    super::terminal::note(format_args!("measuring laws"));
    let laws = laws::rates(rounds).map_err(other("laws"))?;
    super::terminal::note(format_args!("measuring tables"));
    let rates = table_rates(&directory, arguments.quick)?;
    let text = report::page(&all, &cases, &laws, rates).map_err(other("hard cases"))?;
    let mut files = vec![report::csv(&all)?, OutputFile { name: PAGE.into(), bytes: text.clone().into_bytes() }];
    for measured in &all {
        files.push(report::picture(measured)?);
    }
    let path = directory.path().to_owned();
    directory.write(&files)?;
    super::terminal::print(&text)?;
    super::terminal::note(format_args!("wrote {} files to {}", files.len(), path.display()));
    Ok(())
}

/// Speed × strength, as in `scenarios/restitution-vs-speed.toml`, with enough rows to measure.
const TABLE: &str = r#"
sphere = { radius = "5 mm", youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = "7850 kg/m^3" }
half_space = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, yield_strength = "345 MPa" }
impact = { speed = "1 m/s" }
[sweep]
"half_space.yield_strength" = ["200 MPa", "345 MPa", "550 MPa", "900 MPa"]
"impact.speed" = { logspace = ["0.1 mm/s", "100 m/s"], points = 500_000 }
"#;

/// What leaves nine columns of the table.
const NINE: &str =
    r#"output.columns=["contact_time_s", "peak_force_N", "peak_indentation_m", "residual_indentation_m"]"#;

/// How fast tables are computed and written: a row of the report for each table.
fn table_rates(directory: &OutputDirectory, is_quick: bool) -> Result<Vec<Vec<String>>, Error> {
    let measure = |columns: Option<&str>| -> Result<Vec<String>, Error> {
        let quick = is_quick.then_some("sweep.\"impact.speed\".points=5000");
        let overrides: Vec<String> = quick.into_iter().chain(columns).map(str::to_owned).collect();
        let scenario = Scenario::from_text("bench table", TABLE, &overrides)?;
        let plan = table::plan(&scenario)?;
        let rounds = if is_quick { 1 } else { 7 };
        let rates = super::threads::with(None, || throughput(&plan, directory.path(), rounds))??;
        let written = |rate: f64| if rate > 0.0 { format!("{rate:.2e}") } else { "(built without the feature)".into() };
        Ok(std::iter::once(plan.column_names().len().to_string()).chain(rates.map(written)).collect())
    };
    Ok(vec![measure(Some(NINE))?, measure(None)?])
}
