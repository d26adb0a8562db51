//! A material and what is known of it.

use crate::strength::flow::FlowCurve;
use crate::strength::hardness::strength_of_hardness;
use crate::units::Dimension;

/// What is known of a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Property {
    /// ρ.
    Density,
    /// E.
    YoungsModulus,
    /// ν.
    PoissonsRatio,
    /// As the mean pressure of a hardness test.
    Hardness,
    /// N of a power law of hardening.
    HardeningExponent,
}

impl Property {
    /// All of them, in the order of the file.
    pub const ALL: [Self; 5] =
        [Self::Density, Self::YoungsModulus, Self::PoissonsRatio, Self::Hardness, Self::HardeningExponent];

    /// Its name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Density => "density",
            Self::YoungsModulus => "youngs_modulus",
            Self::PoissonsRatio => "poissons_ratio",
            Self::Hardness => "hardness",
            Self::HardeningExponent => "hardening_exponent",
        }
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Density => Dimension::Density,
            Self::YoungsModulus | Self::Hardness => Dimension::Pressure,
            Self::PoissonsRatio | Self::HardeningExponent => Dimension::Ratio,
        }
    }
}

/// A number as it is written, and in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// "63 HRC".
    pub text: String,
    /// In SI.
    pub value: f64,
}

/// A property of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// Which.
    pub property: Property,
    /// The value that is taken.
    pub taken: Written,
    /// Its range: what the sources say.
    pub range: [Written; 2],
    /// What kind of number it is.
    pub basis: String,
    /// Every source and what it says.
    pub sources: Vec<[String; 2]>,
}

/// A material.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// As scenarios name it.
    pub name: String,
    /// What it is, and in which condition.
    pub title: String,
    /// What to know besides.
    pub note: Option<String>,
    /// What is known of it, in the order of [`Property::ALL`].
    pub known: Vec<Known>,
}

impl Entry {
    /// A property, if it is known.
    pub fn of(&self, property: Property) -> Option<&Known> {
        self.known.iter().find(|known| known.property == property)
    }

    /// Exponent and Young's modulus of its power law, where it has one.
    fn power_law(&self) -> Option<(f64, f64)> {
        let of = |property| self.of(property).map(|known| known.taken.value);
        of(Property::HardeningExponent).zip(of(Property::YoungsModulus))
    }

    /// Whether it hardens by a power law.
    pub fn hardens(&self) -> bool {
        self.power_law().is_some()
    }

    /// The stress \[Pa\] at which it first flows, by a hardness given as mean pressure \[Pa\].
    pub fn strength(&self, mean_pressure: f64) -> f64 {
        let (flow, modulus) = self
            .power_law()
            .map_or((None, f64::NAN), |(exponent, modulus)| (Some(FlowCurve::Power { exponent }), modulus));
        strength_of_hardness(mean_pressure, flow.as_ref(), modulus)
    }

    /// Whether it flows: glass, ceramics and polymers are computed as elastic.
    pub fn is_metal(&self) -> bool {
        self.of(Property::Hardness).is_some()
    }
}
