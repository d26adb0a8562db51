//! `plm-impact bench`

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use plm_impact::bench::throughput::throughput;
use plm_impact::bench::{laws, measure, problems, report};
use plm_impact::error::Error;
use plm_impact::files::{OutputDirectory, OutputFile, ResultOrigin};
use plm_impact::scenario::Scenario;

use super::output::note_replaced;
use super::terminal::failed_with;
use super::watch::{Signals, Watch};

/// For maintainers: measure speed against error of every method (CSV, pictures, a page)
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact bench --out bench
  plm-impact bench --quick --out quick-bench")]
pub struct BenchArguments {
    /// Output directory
    #[arg(long, value_name = "DIR", default_value = "plots/bench")]
    out: PathBuf,
    /// Replace files that this program did not write
    #[arg(long)]
    force: bool,
    /// Faster, less accurate benchmark
    #[arg(long)]
    quick: bool,
}

/// The report in Markdown.
const REPORT_PAGE: &str = "README.md";

pub fn bench(arguments: &BenchArguments) -> Result<(), Error> {
    Signals::listen()?;
    let directory = OutputDirectory::prepare(&arguments.out, ResultOrigin::Command("bench"), arguments.force)?;
    let is_quick = arguments.quick;
    // a bar would disturb the measurement
    let (text, files) = Watch::without_files(true).watch(move |_| measure_all(is_quick))?;
    let path = directory.path().to_owned();
    let removed = directory.write(&files)?;
    note_replaced(&directory, &removed);
    super::terminal::print(&text)?;
    super::terminal::note(format_args!("wrote {} files to {}", files.len(), path.display()));
    Ok(())
}

/// Measures everything. Returns the page, and all files.
fn measure_all(is_quick: bool) -> Result<(String, Vec<OutputFile>), Error> {
    let (rounds, burst) = if is_quick { (3, Duration::from_micros(200)) } else { (60, Duration::from_micros(500)) };
    let mut all = Vec::new();
    for problem in problems::problems().map_err(failed_with("problems"))? {
        super::terminal::note(format_args!("measuring {}: {}", problem.name, problem.description));
        let measurements = measure::measure(&problem, is_quick, rounds, burst);
        all.push((problem, measurements));
    }
    super::terminal::note(format_args!("measuring laws"));
    let laws = laws::law_timings(rounds).map_err(failed_with("laws"))?;
    super::terminal::note(format_args!("measuring tables"));
    let table = table_throughput(is_quick)?;
    let text = report::page(&all, &laws, table);
    let mut files =
        vec![report::laws_csv(&laws)?, OutputFile { name: REPORT_PAGE.into(), bytes: text.clone().into_bytes() }];
    for measured in &all {
        files.push(report::picture(measured)?);
    }
    files.push(report::settings_csv(&all)?);
    Ok((text, files))
}

/// Measures how fast a table is made: speed × strength, with enough rows. Gives its number of columns, and rows a second.
fn table_throughput(is_quick: bool) -> Result<(usize, [f64; 2]), Error> {
    let (points, rounds) = if is_quick { (5000, 1) } else { (500_000, 7) };
    let points = format!("sweep.\"impact.speed\".points={points}");
    let plan = Scenario::from_text("bench table", TABLE_SCENARIO, &[points.into()])?.plan()?;
    let rates = super::table::with_threads(None, || throughput(&plan, rounds))??;
    Ok((plan.column_names().len(), rates))
}

/// The scenario of that table.
const TABLE_SCENARIO: &str = include_str!("../../../scenarios/restitution-vs-speed.toml");
