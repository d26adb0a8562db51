//! A material and its properties.

use serde::Deserialize;

use crate::contact::body::Material;
use crate::contact::law::plm::hardness_test;
use crate::contact::strength::flow_curve::FlowCurve;
use crate::strings::names::named_enum;
use crate::units::Dimension;

named_enum! {
    /// A property that a material may have, in the order of the file.
    #[derive(PartialOrd, Ord, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Property {
        Density = "density",
        /// Young's modulus E.
        YoungsModulus = "youngs_modulus",
        /// Poisson's ratio ν.
        PoissonsRatio = "poissons_ratio",
        /// Hardness, as the mean pressure of a hardness test.
        Hardness = "hardness",
        /// Exponent N of a power law of hardening.
        HardeningExponent = "hardening_exponent",
        /// c of Johnson and Cook's factor 1 + c ln(rate/(1 1/s)).
        RateSensitivity = "rate_sensitivity",
    }
}

named_enum! {
    /// How a material gives way.
    #[derive(Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum MaterialClass {
        /// It flows.
        Metal = "metal",
        /// It cracks.
        Glass = "glass",
        /// It cracks, but only where metals flow already; hardmetal too.
        Ceramic = "ceramic",
        /// It cracks and crushes; concrete too.
        Stone = "stone",
        /// It creeps.
        Polymer = "polymer",
    }
}

named_enum! {
    /// Metals whose strengths rise alike with the strain rate.
    #[derive(Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum RateClass {
        /// Quenched steel.
        QuenchedSteel = "quenched_steel",
        /// Mild steel and aluminium.
        MildSteelOrAluminium = "mild_steel_or_aluminium",
        /// Copper.
        Copper = "copper",
    }
}

impl RateClass {
    /// By how much the strain rate of an impact raises e above the e by a slow test: the smallest and the largest share, between 0.1
    /// and 30 m/s.
    pub fn rise(self) -> [f64; 2] {
        match self {
            // the smallest value is that of Leeb's conversion of hardness
            Self::QuenchedSteel => [0.012, 0.10],
            Self::MildSteelOrAluminium => [0.0, 0.10],
            Self::Copper => [0.0, 0.27],
        }
    }
}

impl Property {
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Density => Dimension::Density,
            Self::YoungsModulus | Self::Hardness => Dimension::Pressure,
            Self::PoissonsRatio | Self::HardeningExponent | Self::RateSensitivity => Dimension::Ratio,
        }
    }
}

/// A number as it is written in the file, and its value in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct QuotedValue {
    /// The number as text, such as "63 HRC".
    pub text: String,
    pub value: f64,
}

/// A property of a material, with its value and its sources.
#[derive(Debug, Clone, PartialEq)]
pub struct PropertyValue {
    pub property: Property,
    /// The value that is used.
    pub value: QuotedValue,
    /// The smallest and the largest value that the sources give or a standard allows.
    pub range: [QuotedValue; 2],
    /// The kind of number, such as a hardness of a named condition.
    pub basis: String,
    /// Every source and the value it gives.
    pub sources: Vec<[String; 2]>,
}

/// A material.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialEntry {
    /// The name in scenarios.
    pub name: String,
    /// The material and its condition, in words.
    pub title: String,
    /// Other names, as [`super::plain_name`] writes them.
    pub aliases: Vec<String>,
    pub class: MaterialClass,
    /// The metal hardens, but no two sources agree on the exponent.
    pub lacks_exponent: bool,
    /// The class of metals by which its strength rises with the strain rate, if it is known.
    pub rate_class: Option<RateClass>,
    /// At room temperature the metal is near half of its melting temperature, and creeps.
    pub creeps: bool,
    /// A remark for the user.
    pub note: Option<String>,
    /// The known properties, in the order of [`Property::ALL`].
    pub properties: Vec<PropertyValue>,
}

impl MaterialEntry {
    /// The property, if it is known.
    pub fn get(&self, property: Property) -> Option<&PropertyValue> {
        self.properties.iter().find(|known| known.property == property)
    }

    /// The value of a property; NaN where it is not known.
    fn value(&self, property: Property) -> f64 {
        self.get(property).map_or(f64::NAN, |known| known.value.value)
    }

    /// The flow curve, if the material hardens by a power law.
    fn flow(&self) -> Option<FlowCurve> {
        let power = |known: &PropertyValue| FlowCurve::Power { exponent: known.value.value };
        self.get(Property::HardeningExponent).map(power)
    }

    /// A material with an exponent hardens by a power law.
    pub fn has_hardening(&self) -> bool {
        self.flow().is_some()
    }

    /// The yield strength \[Pa\] of the material with a hardness given as mean pressure \[Pa\].
    pub fn strength(&self, mean_pressure: f64) -> f64 {
        hardness_test::strength_of_hardness(mean_pressure, self.flow().as_ref(), &self.elastic())
    }

    /// The flow stress \[Pa\] at a plastic strain of 0.08 of the material with that hardness.
    pub fn flow_stress(&self, mean_pressure: f64) -> f64 {
        hardness_test::flow_stress_of_hardness(mean_pressure, &self.elastic())
    }

    /// The flow stress \[Pa\] that the hardness would have at another Poisson's ratio.
    pub fn flow_stress_at_poissons_ratio(&self, mean_pressure: f64, poissons_ratio: f64) -> f64 {
        hardness_test::flow_stress_of_hardness(mean_pressure, &Material { poissons_ratio, ..self.elastic() })
    }

    fn elastic(&self) -> Material {
        Material {
            youngs_modulus: self.value(Property::YoungsModulus),
            poissons_ratio: self.value(Property::PoissonsRatio),
        }
    }

    /// By how much the strain rate of an impact raises e; `None` where it is not known.
    pub fn rate_rise(&self) -> Option<[f64; 2]> {
        self.rate_class.map(RateClass::rise)
    }

    /// True if the library has its strength: without one the contact is elastic.
    pub fn has_strength(&self) -> bool {
        self.get(Property::Hardness).is_some()
    }

    /// True if the material yields. Glass, ceramics, stones and polymers are computed as elastic.
    pub fn is_metal(&self) -> bool {
        self.class == MaterialClass::Metal
    }
}
