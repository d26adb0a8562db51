//! The shot that the options of `peen` name: its diameter, its material, and its strength.

use plm_impact::error::Error;
use plm_impact::materials::find;
use plm_impact::materials::shots::{Shot, find_shot};

use super::PeenArguments;

/// The keys of the shot in the scenario.
#[derive(Debug, PartialEq)]
pub struct ShotText {
    /// With its unit.
    pub diameter: String,
    /// The trade name, as a comment.
    pub comment: String,
    pub material: String,
}

/// # Errors
/// An unknown trade name, a shot without a material, and a shot of metal without a hardness.
pub fn shot_text(arguments: &PeenArguments) -> Result<ShotText, Error> {
    let named = arguments.shot.as_deref().map(find_shot).transpose();
    let named = named.map_err(|message| Error::input(format!("--shot: {message}")))?;
    let material = arguments.shot_material.as_deref().or_else(|| Some(named?.kind.material()?.name.as_str()));
    let Some(material) = material else {
        let shot = named.map_or("the shot", |shot| shot.name.as_str());
        return Err(Error::input(format!(
            "--shot-material: the material of {shot} is not known. Give --shot-material, such as --shot-material steel-52100-hardened; `plm-impact materials` lists all."
        )));
    };
    check_strength(arguments, named, material)?;
    let diameter = match named {
        Some(shot) => format!("{} mm", shot.diameter_mm),
        None => arguments.diameter.clone().unwrap_or_default(),
    };
    let comment = named.map_or_else(String::new, |shot| format!("   # {}", shot.name));
    Ok(ShotText { diameter, comment, material: material.to_owned() })
}

/// Refuses a shot of metal without a strength. The hardness of steel shot is ordered, so the hardness of a bearing ball is no default.
fn check_strength(arguments: &PeenArguments, named: Option<&Shot>, material: &str) -> Result<(), Error> {
    if arguments.shot_hardness.is_some() || arguments.shot_strength.is_some() {
        return Ok(());
    }
    let is_default = arguments.shot_material.is_none() && named.is_some_and(|shot| shot.kind.is_steel());
    let lacks_strength = || find(material).is_some_and(|entry| entry.is_metal() && !entry.has_strength());
    if is_default || lacks_strength() {
        return Err(Error::input(
            "--shot-hardness: the hardness of the shot is missing, and a soft shot becomes flat instead of denting the target. Give --shot-hardness (cast steel shot is sold with 40 to 51 HRC and harder, such as --shot-hardness \"46 HRC\") or --shot-strength.",
        ));
    }
    Ok(())
}
