//! `plm-impact schema`

use clap::Args;

/// Print the JSON Schema of a scenario, for editors and for programs that write scenarios
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact schema > scenario.schema.json
  plm-impact schema | grep drop_height")]
pub struct Arguments {}

pub fn schema(_: &Arguments) -> anyhow::Result<()> {
    let text = serde_json::to_string_pretty(&plm_impact::scene::schema::schema())?;
    super::terminal::print(&(text + "\n"))
}
