//! `plm-impact laws`

use clap::Args;

/// List the contact laws: name, source, loading, unloading, validity, confidence; and those that are not public
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact laws
  plm-impact run impact.toml --set law=thornton")]
pub struct Arguments {}

pub fn laws(_: &Arguments) -> anyhow::Result<()> {
    super::terminal::print(&plm_impact::report::laws::list())
}
