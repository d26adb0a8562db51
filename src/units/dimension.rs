//! The dimensions of quantities, and the words for each.

/// Dimensions, each with its name and article, SI unit, end of names in this unit, and an example.
macro_rules! dimensions {
    ($($dimension:ident: $name:literal, $unit:literal, $suffix:literal, $example:literal;)+) => {
        /// A dimension with its units. An angle always carries its unit.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Dimension {
            $(#[doc = $name] $dimension,)+
        }

        impl Dimension {
            pub const ALL: &'static [Self] = &[$(Self::$dimension),+];

            const fn spec(self) -> [&'static str; 4] {
                match self {
                    $(Self::$dimension => [$name, $unit, $suffix, $example],)+
                }
            }
        }
    };
}

dimensions! {
    Length: "a length", "m", "_m", "\"5 mm\"";
    Time: "a time", "s", "_s", "\"20 us\"";
    Speed: "a speed", "m/s", "_m_per_s", "\"3 m/s\"";
    Acceleration: "an acceleration", "m/s^2", "_m_per_s2", "\"9.81 m/s^2\"";
    InverseSpeed: "an inverse speed", "s/m", "_s_per_m", "\"0.1 s/m\"";
    Area: "an area", "m^2", "_m2", "\"50 cm^2\"";
    ArealNumber: "a number per area", "1/m^2", "_per_m2", "\"100 1/mm^2\"";
    Mass: "a mass", "kg", "_kg", "\"4 g\"";
    MassFlow: "a mass flow", "kg/s", "_kg_per_s", "\"5 kg/min\"";
    ArealMass: "a mass per area", "kg/m^2", "_kg_per_m2", "\"2 kg/m^2\"";
    Density: "a density", "kg/m^3", "_kg_per_m3", "\"7850 kg/m^3\"";
    Pressure: "a pressure", "Pa", "_Pa", "\"210 GPa\"";
    Force: "a force", "N", "_N", "\"1 kN\"";
    Energy: "an energy", "J", "_J", "\"1 mJ\"";
    Stiffness: "a stiffness", "N/m", "_N_per_m", "\"1 kN/m\"";
    SurfaceEnergy: "an energy per area", "J/m^2", "_J_per_m2", "\"0.05 J/m^2\"";
    Angle: "an angle", "rad", "_rad", "\"30 deg\"";
    AngularSpeed: "an angular speed", "rad/s", "_rad_per_s", "\"100 rad/s\"";
    StrainRate: "a rate", "1/s", "_per_s", "\"1 1/s\"";
    MomentOfInertia: "a moment of inertia", "kg m^2", "_kg_m2", "\"1e-6 kg m^2\"";
    Viscosity: "a viscosity", "Pa s", "_Pa_s", "\"1.8e-5 Pa s\"";
    Frequency: "a frequency", "Hz", "_Hz", "\"20 kHz\"";
    Impulse: "an impulse", "N s", "_N_s", "\"5 mN s\"";
    Ratio: "a plain number", "", "", "0.3";
}

impl Dimension {
    /// With the article, for messages.
    pub fn name(self) -> &'static str {
        self.spec()[0]
    }

    /// True if units of the other dimension measure this dimension too: N/m is J/m².
    pub(super) fn has_units_of(self, other: Self) -> bool {
        self == other || self == Self::SurfaceEnergy && other == Self::Stiffness
    }

    /// The SI unit, empty for a plain number.
    pub fn si_unit(self) -> &'static str {
        self.spec()[1]
    }

    /// True if SI prefixes stand before this unit: the SI unit of a dimension, which has no prefix yet and is no power of a unit.
    pub fn is_prefixed(unit: &str) -> bool {
        let is_plain = |dimension: &&Self| {
            let unit = dimension.si_unit();
            !unit.is_empty() && !unit.starts_with("kg") && !matches!(dimension, Self::Area | Self::ArealNumber)
        };
        Self::ALL.iter().filter(is_plain).any(|dimension| dimension.si_unit() == unit)
    }

    /// The end of the name of a column or a result in this unit: `_m_per_s`; empty for a plain number.
    pub fn suffix(self) -> &'static str {
        self.spec()[2]
    }

    /// Shows how such a quantity may be written.
    pub fn example(self) -> &'static str {
        self.spec()[3]
    }
}
