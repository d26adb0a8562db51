//! The dimensions of quantities, and the words for each.

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Metres.
    Length,
    /// Seconds.
    Time,
    /// Metres per second.
    Speed,
    /// Metres per second squared.
    Acceleration,
    /// Seconds per metre.
    InverseSpeed,
    /// Kilograms.
    Mass,
    /// Kilograms per cubic metre.
    Density,
    /// Pascals.
    Pressure,
    /// Newtons.
    Force,
    /// Joules.
    Energy,
    /// Newtons per metre.
    Stiffness,
    /// Radians; an angle always carries its unit.
    Angle,
    /// Radians per second.
    AngularSpeed,
    /// Kilograms times square metres.
    MomentOfInertia,
    /// A plain number.
    Ratio,
}

impl Dimension {
    /// Name with its article, SI unit, end of names in this unit, example.
    const fn words(self) -> [&'static str; 4] {
        match self {
            Self::Length => ["a length", "m", "_m", "\"5 mm\""],
            Self::Time => ["a time", "s", "_s", "\"20 us\""],
            Self::Speed => ["a speed", "m/s", "_m_per_s", "\"3 m/s\""],
            Self::Acceleration => ["an acceleration", "m/s^2", "_m_per_s2", "\"9.81 m/s^2\""],
            Self::InverseSpeed => ["an inverse speed", "s/m", "_s_per_m", "\"0.1 s/m\""],
            Self::Mass => ["a mass", "kg", "_kg", "\"4 g\""],
            Self::Density => ["a density", "kg/m^3", "_kg_per_m3", "\"7850 kg/m^3\""],
            Self::Pressure => ["a pressure", "Pa", "_Pa", "\"210 GPa\""],
            Self::Force => ["a force", "N", "_N", "\"1 kN\""],
            Self::Energy => ["an energy", "J", "_J", "\"1 mJ\""],
            Self::Stiffness => ["a stiffness", "N/m", "_N_per_m", "\"1 kN/m\""],
            Self::Angle => ["an angle", "rad", "_rad", "\"30 deg\""],
            Self::AngularSpeed => ["an angular speed", "rad/s", "_rad_per_s", "\"100 rad/s\""],
            Self::MomentOfInertia => ["a moment of inertia", "kg m^2", "_kg_m2", "\"1e-6 kg m^2\""],
            Self::Ratio => ["a plain number", "", "", "0.3"],
        }
    }

    /// Its name with the article, for messages.
    pub fn name(self) -> &'static str {
        self.words()[0]
    }

    /// The SI unit, empty for a plain number.
    pub fn si_unit(self) -> &'static str {
        self.words()[1]
    }

    /// The end of the name of a column or a result in this unit: `_m_per_s`; empty for a plain number.
    pub fn suffix(self) -> &'static str {
        self.words()[2]
    }

    /// How such a quantity may be written.
    pub fn example(self) -> &'static str {
        self.words()[3]
    }
}
