//! The units, each dimension in rising order.

use super::Dimension;

/// The size of a unit in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scale {
    Ten(i32),
    /// A factor in decimal digits: a value is multiplied in decimal, and rounded once.
    Decimal(&'static str),
    Times(f64),
    /// A divisor, which is exact where the factor is not.
    Over(f64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    pub(super) dimension: Dimension,
    pub(super) scale: Scale,
    pub(super) is_shown: bool,
}

const fn shown(name: &'static str, dimension: Dimension, power: i32) -> Unit {
    Unit { name, dimension, scale: Scale::Ten(power), is_shown: true }
}

const fn read(name: &'static str, dimension: Dimension, scale: Scale) -> Unit {
    Unit { name, dimension, scale, is_shown: false }
}

use Dimension::{
    Acceleration, Angle, AngularSpeed, Density, Energy, Force, InverseSpeed, Length, Mass, MomentOfInertia, Pressure,
    Ratio, Speed, Stiffness, StrainRate, Time, Viscosity,
};

pub(super) const UNITS: &[Unit] = &[
    shown("nm", Length, -9),
    shown("µm", Length, -6),
    read("micron", Length, Scale::Ten(-6)),
    read("mil", Length, Scale::Decimal("2.54e-5")), // a thousandth of an inch
    shown("mm", Length, -3),
    read("cm", Length, Scale::Ten(-2)),
    read("in", Length, Scale::Decimal("0.0254")), // international inch and foot, exact
    read("inch", Length, Scale::Decimal("0.0254")),
    read("ft", Length, Scale::Decimal("0.3048")),
    shown("m", Length, 0),
    shown("km", Length, 3),
    shown("ns", Time, -9),
    shown("µs", Time, -6),
    shown("ms", Time, -3),
    shown("s", Time, 0),
    shown("nm/s", Speed, -9),
    shown("µm/s", Speed, -6),
    shown("mm/s", Speed, -3),
    read("cm/s", Speed, Scale::Ten(-2)),
    read("km/h", Speed, Scale::Over(3.6)),
    read("kph", Speed, Scale::Over(3.6)),
    read("in/s", Speed, Scale::Decimal("0.0254")),
    read("ft/s", Speed, Scale::Decimal("0.3048")),
    read("mph", Speed, Scale::Decimal("0.44704")), // 5280 ft an hour, exact
    shown("m/s", Speed, 0),
    shown("km/s", Speed, 3),
    read("mm/s^2", Acceleration, Scale::Ten(-3)),
    read("cm/s^2", Acceleration, Scale::Ten(-2)),
    shown("m/s^2", Acceleration, 0),
    read("ms/m", InverseSpeed, Scale::Ten(-3)),
    shown("s/m", InverseSpeed, 0),
    read("s/cm", InverseSpeed, Scale::Ten(2)),
    shown("s/mm", InverseSpeed, 3),
    shown("ng", Mass, -12),
    shown("µg", Mass, -9),
    shown("mg", Mass, -6),
    shown("g", Mass, -3),
    read("oz", Mass, Scale::Decimal("0.028349523125")), // a sixteenth of a pound, exact
    read("lb", Mass, Scale::Decimal("0.45359237")),     // international pound, exact
    shown("kg", Mass, 0),
    shown("t", Mass, 3),
    shown("µPa s", Viscosity, -6),
    shown("mPa s", Viscosity, -3),
    read("cP", Viscosity, Scale::Ten(-3)),
    shown("Pa s", Viscosity, 0),
    shown("kg/m^3", Density, 0),
    read("lb/ft^3", Density, Scale::Decimal("16.01846337396013957966")), // 0.45359237 kg / (0.3048 m)^3
    shown("g/cm^3", Density, 3),
    read("g/cc", Density, Scale::Ten(3)),
    read("kg/dm^3", Density, Scale::Ten(3)),
    read("kg/l", Density, Scale::Ten(3)),
    read("t/m^3", Density, Scale::Ten(3)),
    read("lb/in^3", Density, Scale::Decimal("27679.90471020312119364")), // 0.45359237 kg / (0.0254 m)^3
    shown("Pa", Pressure, 0),
    read("N/m^2", Pressure, Scale::Ten(0)),
    shown("kPa", Pressure, 3),
    read("bar", Pressure, Scale::Ten(5)),
    shown("MPa", Pressure, 6),
    read("N/mm^2", Pressure, Scale::Ten(6)),
    read("kgf/mm^2", Pressure, Scale::Decimal("9.80665e6")),
    read("ksi", Pressure, Scale::Decimal("6894757.293168361336723")), // 1000 psi
    shown("GPa", Pressure, 9),
    read("Mpsi", Pressure, Scale::Decimal("6894757293.168361336723")), // 10^6 psi
    read("Msi", Pressure, Scale::Decimal("6894757293.168361336723")),
    shown("TPa", Pressure, 12),
    read("psi", Pressure, Scale::Decimal("6894.757293168361336723")), // lbf/in^2: 0.45359237 kg x 9.80665 m/s^2 / (0.0254 m)^2
    shown("nN", Force, -9),
    shown("µN", Force, -6),
    shown("mN", Force, -3),
    shown("N", Force, 0),
    read("lbf", Force, Scale::Decimal("4.4482216152605")), // 0.45359237 kg x 9.80665 m/s^2, exact
    read("kgf", Force, Scale::Decimal("9.80665")),
    shown("kN", Force, 3),
    shown("MN", Force, 6),
    shown("fJ", Energy, -15),
    shown("pJ", Energy, -12),
    shown("nJ", Energy, -9),
    shown("µJ", Energy, -6),
    shown("mJ", Energy, -3),
    shown("J", Energy, 0),
    shown("kJ", Energy, 3),
    shown("N/m", Stiffness, 0),
    shown("kN/m", Stiffness, 3),
    read("N/mm", Stiffness, Scale::Ten(3)),
    shown("MN/m", Stiffness, 6),
    read("deg", Angle, Scale::Times(std::f64::consts::PI / 180.0)),
    read("°", Angle, Scale::Times(std::f64::consts::PI / 180.0)),
    shown("rad", Angle, 0),
    read("deg/s", AngularSpeed, Scale::Times(std::f64::consts::PI / 180.0)),
    read("rpm", AngularSpeed, Scale::Times(std::f64::consts::PI / 30.0)),
    shown("rad/s", AngularSpeed, 0),
    shown("1/s", StrainRate, 0),
    read("/s", StrainRate, Scale::Ten(0)),
    read("s^-1", StrainRate, Scale::Ten(0)),
    read("1/ms", StrainRate, Scale::Ten(3)),
    read("g mm^2", MomentOfInertia, Scale::Ten(-9)),
    read("oz in^2", MomentOfInertia, Scale::Decimal("1.8289978339325e-5")), // 0.028349523125 kg x (0.0254 m)^2
    read("lb in^2", MomentOfInertia, Scale::Decimal("2.926396534292e-4")),  // 0.45359237 kg x (0.0254 m)^2
    read("g cm^2", MomentOfInertia, Scale::Ten(-7)),
    read("kg mm^2", MomentOfInertia, Scale::Ten(-6)),
    shown("kg m^2", MomentOfInertia, 0),
    read("%", Ratio, Scale::Ten(-2)),
];

impl Dimension {
    /// The names of the units of this dimension, in rising order.
    pub fn unit_names(self) -> impl Iterator<Item = &'static str> {
        self.units().map(|unit| unit.name)
    }

    /// The names of the units of all other dimensions.
    pub fn units_of_others(self) -> impl Iterator<Item = &'static str> {
        UNITS.iter().filter(move |unit| unit.dimension != self).map(|unit| unit.name)
    }

    /// The units of this dimension, in rising order.
    pub(super) fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }
}
