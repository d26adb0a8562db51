//! `plm-impact units`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::report::text::units::list;

/// List the units of every quantity, and the scales of hardness
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact units
  plm-impact run impact.toml --set sphere.radius=\"1/4 in\"")]
pub struct UnitsArguments {}

pub fn units(UnitsArguments {}: &UnitsArguments) -> Result<(), Error> {
    super::terminal::print(&list())
}
