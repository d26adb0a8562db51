//! Reads the file of materials.

use std::collections::BTreeMap;

use super::{MaterialClass, MaterialEntry, Property, PropertyValue, QuotedValue, RateClass};
use crate::contact::strength::hardness;
use crate::error::Error;
use crate::units;
use serde::Deserialize;

/// The file as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialFile {
    /// Materials that are left out, and why.
    #[serde(default)]
    absent: BTreeMap<String, String>,
    basis: BTreeMap<String, String>,
    sources: BTreeMap<String, String>,
    material: Vec<RawMaterial>,
}

#[derive(Deserialize)]
struct RawMaterial {
    name: String,
    title: String,
    #[serde(default)]
    aliases: Vec<String>,
    class: MaterialClass,
    #[serde(default)]
    lacks_exponent: bool,
    rate_class: Option<RateClass>,
    #[serde(default)]
    creeps: bool,
    note: Option<String>,
    #[serde(flatten)]
    known: BTreeMap<Property, RawProperty>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawProperty {
    value: String,
    range: [String; 2],
    basis: Option<String>,
    says: BTreeMap<String, String>,
}

/// Reads a file of materials.
///
/// # Errors
/// [`Error`] for a text of another form, a value that is not allowed, and a source without an entry.
pub fn read(text: &str) -> Result<Vec<MaterialEntry>, Error> {
    let MaterialFile { basis, sources, material, .. } = parse(text)?;
    let entry = |raw: RawMaterial| {
        let RawMaterial { name, title, aliases, class, lacks_exponent, rate_class, creeps, note, known } = raw;
        let known = known.into_iter().map(|(property, raw)| raw.into_property(&name, property, &basis, &sources));
        let known = known.collect::<Result<_, Error>>()?;
        Ok(MaterialEntry { name, title, aliases, class, lacks_exponent, rate_class, creeps, note, properties: known })
    };
    material.into_iter().map(entry).collect()
}

/// The materials that a file leaves out, with the reasons.
///
/// # Errors
/// [`Error`] for a text of another form.
pub(super) fn read_absent(text: &str) -> Result<BTreeMap<String, String>, Error> {
    Ok(parse(text)?.absent)
}

fn parse(text: &str) -> Result<MaterialFile, Error> {
    toml::from_str(text).map_err(|error| Error::input(error.to_string()))
}

impl RawProperty {
    fn into_property(
        self,
        material: &str,
        property: Property,
        basis: &BTreeMap<String, String>,
        sources: &BTreeMap<String, String>,
    ) -> Result<PropertyValue, Error> {
        let refuse = |message: String| Error::input(format!("{material}.{}: {message}", property.name()));
        let written = |text: String| match number(&text, property) {
            Ok(value) => Ok(QuotedValue { text, value }),
            Err(message) => Err(refuse(message)),
        };
        let cited = |(name, says): (String, String)| match sources.get(&name) {
            Some(source) => Ok([source.clone(), says]),
            None => Err(refuse(format!("no source is called \"{name}\""))),
        };
        let [low, high] = self.range;
        Ok(PropertyValue {
            property,
            value: written(self.value)?,
            range: [written(low)?, written(high)?],
            basis: self.basis.or_else(|| basis.get(property.name()).cloned()).unwrap_or_default(),
            sources: self.says.into_iter().map(cited).collect::<Result<_, _>>()?,
        })
    }
}

/// The value in SI units of a number with a unit, or of a number on a scale of hardness.
fn number(text: &str, property: Property) -> Result<f64, String> {
    match hardness::parse(text).filter(|_| property == Property::Hardness) {
        Some((number, scale)) => scale.mean_pressure(number).map_err(|error| error.to_string()),
        None => units::parse(text, property.dimension()).map_err(|error| error.to_string()),
    }
}
