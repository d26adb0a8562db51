//! `plm-impact bench`

use std::path::PathBuf;
use std::time::Duration;

use anyhow::Context as _;
use clap::Args;
use plm_impact::bench::{hard_cases, measure, problems, report};
use plm_impact::output::{OutputDirectory, OutputFile};

/// Measure speed against error of every method: CSV, pictures, and tables on the terminal and as Markdown
#[derive(Debug, Args)]
pub struct Arguments {
    /// Output directory
    #[arg(long, value_name = "DIR", default_value = "plots/bench")]
    out: PathBuf,
    /// A third of the settings and a tenth of the rounds
    #[arg(long)]
    quick: bool,
}

pub fn bench(arguments: &Arguments) -> anyhow::Result<()> {
    let directory = OutputDirectory::prepare(&arguments.out)?;
    let (rounds, burst) =
        if arguments.quick { (3, Duration::from_micros(200)) } else { (60, Duration::from_micros(500)) };
    let mut all = Vec::new();
    for problem in problems::problems().context("problems")? {
        eprintln!("measuring {}: {}", problem.name, problem.about);
        let measurements = measure::measure(&problem, arguments.quick, rounds, burst);
        all.push((problem, measurements));
    }
    let cases = hard_cases::hard_cases().context("hard cases")?;
    let text = format!(
        "# Speed against error\n\n## Time of one impact in µs to reach an error (and how many times slower ode_solvers' Dop853 is)\n\n{}\n\
         ## Ratios\n\n{}\n## Steps per contact that velocity Verlet needs\n\n{}\n\
         ## Hard cases: larger relative error of e and contact time at the default tolerance\n\n{}",
        report::time_table(&all),
        report::ratio_table(&all),
        report::verlet_table(&all),
        report::hard_case_table(&cases).context("hard cases")?,
    );
    let mut files = vec![report::csv(&all)?, OutputFile { name: "report.md".into(), bytes: text.clone().into_bytes() }];
    for measured in &all {
        files.push(report::picture(measured)?);
    }
    let path = directory.path().to_owned();
    directory.write(&files)?;
    super::print(&text).context("standard output")?;
    eprintln!("wrote {} files to {}", files.len(), path.display());
    Ok(())
}
