//! `plm-impact materials`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::materials::{all, find};
use plm_impact::report::materials::{list, one};

/// List the materials that scenarios may name, or print values, ranges and sources of one
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact materials
  plm-impact materials aluminium-6061-t6")]
pub struct Arguments {
    /// Name of one material
    name: Option<String>,
}

pub fn materials(Arguments { name }: &Arguments) -> Result<(), Error> {
    let text = match name {
        None => list(),
        Some(name) => one(find(name).ok_or_else(|| unknown(name))?),
    };
    super::terminal::print(&text)
}

fn unknown(name: &str) -> Error {
    let names: Vec<&str> = all().iter().map(|entry| entry.name.as_str()).collect();
    super::names::unknown("material", "materials", name, &names)
}
