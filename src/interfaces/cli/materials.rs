//! `plm-impact materials`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::materials::{MaterialEntry, all_materials, find};
use plm_impact::report::text::materials::{is_match, material_page, materials_json, materials_text};
use plm_impact::scenario::keys::words::unknown_material;

/// List the materials, or print values, ranges and sources of one
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact materials
  plm-impact materials aluminium-6061-t6")]
pub struct MaterialsArguments {
    /// Name of one material, or a part of the names or descriptions of several
    name: Option<String>,
    /// Print JSON: values, ranges and sources, in SI
    #[arg(long)]
    json: bool,
}

pub fn materials(MaterialsArguments { name, json }: &MaterialsArguments) -> Result<(), Error> {
    let name = name.as_deref().unwrap_or_default();
    let exact = find(name);
    let found: Vec<&MaterialEntry> =
        exact.map_or_else(|| all_materials().iter().filter(|entry| is_match(entry, name)).collect(), |one| vec![one]);
    if found.is_empty() {
        let text = format!("unknown material \"{name}\"{}", unknown_material(name));
        return Err(Error::input(text));
    }
    if *json {
        return super::terminal::print_json(&format!("{:#}\n", materials_json(&found)));
    }
    super::terminal::print(&exact.map_or_else(|| materials_text(name), material_page))
}
