//! Reads the file of materials.

use std::collections::BTreeMap;

use super::{Class, Known, MaterialEntry, Property, RateClass, Written};
use crate::contact::strength::hardness;
use crate::error::Error;
use crate::units;
use serde::Deserialize;

/// The file as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    basis: BTreeMap<String, String>,
    sources: BTreeMap<String, String>,
    material: Vec<Raw>,
}

#[derive(Deserialize)]
struct Raw {
    name: String,
    title: String,
    class: Class,
    #[serde(default)]
    lacks_exponent: bool,
    rate_class: Option<RateClass>,
    #[serde(default)]
    creeps: bool,
    note: Option<String>,
    #[serde(flatten)]
    known: BTreeMap<Property, RawKnown>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawKnown {
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
    let File { basis, sources, material } = toml::from_str(text).map_err(|error| Error::input(error.to_string()))?;
    let entry = |raw: Raw| {
        let Raw { name, title, class, lacks_exponent, rate_class, creeps, note, known } = raw;
        let known = known.into_iter().map(|(property, raw)| raw.known(&name, property, &basis, &sources));
        let known = known.collect::<Result<_, Error>>()?;
        Ok(MaterialEntry { name, title, class, lacks_exponent, rate_class, creeps, note, known })
    };
    material.into_iter().map(entry).collect()
}

impl RawKnown {
    fn known(
        self,
        material: &str,
        property: Property,
        basis: &BTreeMap<String, String>,
        sources: &BTreeMap<String, String>,
    ) -> Result<Known, Error> {
        let refuse = |message: String| Error::input(format!("{material}.{}: {message}", property.name()));
        let written = |text: String| match number(&text, property) {
            Ok(value) => Ok(Written { text, value }),
            Err(message) => Err(refuse(message)),
        };
        let cited = |(name, says): (String, String)| match sources.get(&name) {
            Some(source) => Ok([source.clone(), says]),
            None => Err(refuse(format!("no source is called \"{name}\""))),
        };
        let [low, high] = self.range;
        Ok(Known {
            property,
            used: written(self.value)?,
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
