//! `plm-impact bench`

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::evidence::bench::report::TableRate;
use plm_impact::evidence::bench::throughput::throughput;
use plm_impact::evidence::bench::{laws, measure, problems, report};
use plm_impact::files::{Origin, OutputDirectory, OutputFile};
use plm_impact::scenario::Scenario;

use super::terminal::other;

/// For maintainers: measure speed against error of every method (CSV, pictures, a page)
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
    super::terminal::note(format_args!("measuring laws"));
    let laws = laws::rates(rounds).map_err(other("laws"))?;
    super::terminal::note(format_args!("measuring tables"));
    let tables = table_rates(arguments.quick)?;
    let text = report::page(&all, &laws, &tables);
    let mut files = vec![report::laws(&laws)?, OutputFile { name: PAGE.into(), bytes: text.clone().into_bytes() }];
    for measured in &all {
        files.push(report::picture(measured)?);
    }
    files.push(report::settings(&all)?);
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

/// With this change of the scenario the table has nine columns.
const NINE: &str =
    r#"output.columns=["contact_time_s", "peak_force_N", "peak_indentation_m", "residual_indentation_m"]"#;

/// Measures how fast tables of nine columns, and of all, are made.
fn table_rates(is_quick: bool) -> Result<[TableRate; 2], Error> {
    let measure = |columns: Option<&str>| -> Result<TableRate, Error> {
        let quick = is_quick.then_some("sweep.\"impact.speed\".points=5000");
        let overrides: Vec<String> = quick.into_iter().chain(columns).map(str::to_owned).collect();
        let scenario = Scenario::from_text("bench table", TABLE, &overrides)?;
        let plan = scenario.plan()?;
        let rounds = if is_quick { 1 } else { 7 };
        let rows_per_second = super::sweep::with_threads(None, || throughput(&plan, rounds))??;
        Ok(TableRate { columns: plan.column_names().len(), rows_per_second })
    };
    Ok([measure(Some(NINE))?, measure(None)?])
}
