//! The units, each dimension in rising order.

use super::Dimension;

/// The size of a unit in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum UnitScale {
    PowerOfTen(i32),
    /// A factor in decimal digits: a value is multiplied in decimal, and rounded once.
    Decimal(&'static str),
    Factor(f64),
    /// A divisor, which is exact where the factor is not.
    Divisor(f64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    pub(super) dimension: Dimension,
    pub(super) scale: UnitScale,
    pub(super) is_displayed: bool,
}

const fn display_unit(name: &'static str, dimension: Dimension, power: i32) -> Unit {
    Unit { name, dimension, scale: UnitScale::PowerOfTen(power), is_displayed: true }
}

const fn input_unit(name: &'static str, dimension: Dimension, scale: UnitScale) -> Unit {
    Unit { name, dimension, scale, is_displayed: false }
}

use Dimension::{
    Acceleration, Angle, AngularSpeed, Area, ArealMass, ArealNumber, Density, Energy, Force, Frequency, Impulse,
    InverseSpeed, Length, Mass, MassFlow, MomentOfInertia, Pressure, Ratio, Speed, Stiffness, StrainRate,
    SurfaceEnergy, Time, Viscosity,
};

pub(super) const UNITS: &[Unit] = &[
    display_unit("nm", Length, -9),
    display_unit("µm", Length, -6),
    input_unit("micron", Length, UnitScale::PowerOfTen(-6)),
    input_unit("mil", Length, UnitScale::Decimal("2.54e-5")), // a thousandth of an inch
    display_unit("mm", Length, -3),
    input_unit("cm", Length, UnitScale::PowerOfTen(-2)),
    input_unit("in", Length, UnitScale::Decimal("0.0254")), // international inch and foot, exact
    input_unit("inch", Length, UnitScale::Decimal("0.0254")),
    input_unit("ft", Length, UnitScale::Decimal("0.3048")),
    display_unit("m", Length, 0),
    display_unit("km", Length, 3),
    display_unit("µm^2", Area, -12),
    display_unit("mm^2", Area, -6),
    input_unit("cm^2", Area, UnitScale::PowerOfTen(-4)),
    input_unit("in^2", Area, UnitScale::Decimal("6.4516e-4")), // exact
    input_unit("dm^2", Area, UnitScale::PowerOfTen(-2)),
    display_unit("m^2", Area, 0),
    display_unit("1/m^2", ArealNumber, 0),
    input_unit("1/cm^2", ArealNumber, UnitScale::PowerOfTen(4)),
    display_unit("1/mm^2", ArealNumber, 6),
    display_unit("ns", Time, -9),
    display_unit("µs", Time, -6),
    display_unit("ms", Time, -3),
    display_unit("s", Time, 0),
    input_unit("min", Time, UnitScale::Factor(60.0)),
    display_unit("nm/s", Speed, -9),
    display_unit("µm/s", Speed, -6),
    display_unit("mm/s", Speed, -3),
    input_unit("cm/s", Speed, UnitScale::PowerOfTen(-2)),
    input_unit("km/h", Speed, UnitScale::Divisor(3.6)),
    input_unit("kph", Speed, UnitScale::Divisor(3.6)),
    input_unit("in/s", Speed, UnitScale::Decimal("0.0254")),
    input_unit("ft/s", Speed, UnitScale::Decimal("0.3048")),
    input_unit("mph", Speed, UnitScale::Decimal("0.44704")), // 5280 ft an hour, exact
    display_unit("m/s", Speed, 0),
    display_unit("km/s", Speed, 3),
    input_unit("mm/s^2", Acceleration, UnitScale::PowerOfTen(-3)),
    input_unit("cm/s^2", Acceleration, UnitScale::PowerOfTen(-2)),
    display_unit("m/s^2", Acceleration, 0),
    input_unit("ms/m", InverseSpeed, UnitScale::PowerOfTen(-3)),
    display_unit("s/m", InverseSpeed, 0),
    input_unit("s/cm", InverseSpeed, UnitScale::PowerOfTen(2)),
    display_unit("s/mm", InverseSpeed, 3),
    display_unit("ng", Mass, -12),
    display_unit("µg", Mass, -9),
    display_unit("mg", Mass, -6),
    display_unit("g", Mass, -3),
    input_unit("oz", Mass, UnitScale::Decimal("0.028349523125")), // a sixteenth of a pound, exact
    input_unit("lb", Mass, UnitScale::Decimal("0.45359237")),     // international pound, exact
    display_unit("kg", Mass, 0),
    display_unit("t", Mass, 3),
    input_unit("kg/h", MassFlow, UnitScale::Divisor(3600.0)),
    display_unit("g/s", MassFlow, -3),
    input_unit("lb/min", MassFlow, UnitScale::Factor(0.453_592_37 / 60.0)),
    input_unit("kg/min", MassFlow, UnitScale::Divisor(60.0)),
    display_unit("kg/s", MassFlow, 0),
    display_unit("g/m^2", ArealMass, -3),
    input_unit("lb/ft^2", ArealMass, UnitScale::Factor(0.453_592_37 / (0.3048 * 0.3048))),
    display_unit("kg/m^2", ArealMass, 0),
    display_unit("µPa s", Viscosity, -6),
    display_unit("mPa s", Viscosity, -3),
    input_unit("cP", Viscosity, UnitScale::PowerOfTen(-3)),
    display_unit("Pa s", Viscosity, 0),
    display_unit("kg/m^3", Density, 0),
    input_unit("lb/ft^3", Density, UnitScale::Decimal("16.01846337396013957966")), // 0.45359237 kg / (0.3048 m)^3
    display_unit("g/cm^3", Density, 3),
    input_unit("g/cc", Density, UnitScale::PowerOfTen(3)),
    input_unit("kg/dm^3", Density, UnitScale::PowerOfTen(3)),
    input_unit("kg/l", Density, UnitScale::PowerOfTen(3)),
    input_unit("t/m^3", Density, UnitScale::PowerOfTen(3)),
    input_unit("lb/in^3", Density, UnitScale::Decimal("27679.90471020312119364")), // 0.45359237 kg / (0.0254 m)^3
    display_unit("Pa", Pressure, 0),
    input_unit("N/m^2", Pressure, UnitScale::PowerOfTen(0)),
    display_unit("kPa", Pressure, 3),
    input_unit("bar", Pressure, UnitScale::PowerOfTen(5)),
    display_unit("MPa", Pressure, 6),
    input_unit("N/mm^2", Pressure, UnitScale::PowerOfTen(6)),
    input_unit("kgf/mm^2", Pressure, UnitScale::Decimal("9.80665e6")),
    input_unit("ksi", Pressure, UnitScale::Decimal("6894757.293168361336723")), // 1000 psi
    display_unit("GPa", Pressure, 9),
    input_unit("Mpsi", Pressure, UnitScale::Decimal("6894757293.168361336723")), // 10^6 psi
    input_unit("Msi", Pressure, UnitScale::Decimal("6894757293.168361336723")),
    display_unit("TPa", Pressure, 12),
    input_unit("psi", Pressure, UnitScale::Decimal("6894.757293168361336723")), // lbf/in^2: 0.45359237 kg x 9.80665 m/s^2 / (0.0254 m)^2
    display_unit("nN", Force, -9),
    display_unit("µN", Force, -6),
    display_unit("mN", Force, -3),
    display_unit("N", Force, 0),
    input_unit("lbf", Force, UnitScale::Decimal("4.4482216152605")), // 0.45359237 kg x 9.80665 m/s^2, exact
    input_unit("kgf", Force, UnitScale::Decimal("9.80665")),
    display_unit("kN", Force, 3),
    display_unit("MN", Force, 6),
    display_unit("fJ", Energy, -15),
    display_unit("pJ", Energy, -12),
    display_unit("nJ", Energy, -9),
    display_unit("µJ", Energy, -6),
    display_unit("mJ", Energy, -3),
    display_unit("J", Energy, 0),
    display_unit("kJ", Energy, 3),
    display_unit("N/m", Stiffness, 0),
    display_unit("kN/m", Stiffness, 3),
    input_unit("N/mm", Stiffness, UnitScale::PowerOfTen(3)),
    display_unit("MN/m", Stiffness, 6),
    display_unit("mJ/m^2", SurfaceEnergy, -3),
    input_unit("mN/m", SurfaceEnergy, UnitScale::PowerOfTen(-3)), // as surface tensions are written
    input_unit("dyn/cm", SurfaceEnergy, UnitScale::PowerOfTen(-3)),
    input_unit("erg/cm^2", SurfaceEnergy, UnitScale::PowerOfTen(-3)),
    display_unit("J/m^2", SurfaceEnergy, 0),
    input_unit("deg", Angle, UnitScale::Factor(std::f64::consts::PI / 180.0)),
    input_unit("°", Angle, UnitScale::Factor(std::f64::consts::PI / 180.0)),
    display_unit("rad", Angle, 0),
    input_unit("deg/s", AngularSpeed, UnitScale::Factor(std::f64::consts::PI / 180.0)),
    input_unit("rpm", AngularSpeed, UnitScale::Factor(std::f64::consts::PI / 30.0)),
    display_unit("rad/s", AngularSpeed, 0),
    display_unit("1/s", StrainRate, 0),
    input_unit("/s", StrainRate, UnitScale::PowerOfTen(0)),
    input_unit("s^-1", StrainRate, UnitScale::PowerOfTen(0)),
    input_unit("1/ms", StrainRate, UnitScale::PowerOfTen(3)),
    display_unit("Hz", Frequency, 0),
    display_unit("kHz", Frequency, 3),
    display_unit("MHz", Frequency, 6),
    display_unit("GHz", Frequency, 9),
    display_unit("nN s", Impulse, -9),
    display_unit("µN s", Impulse, -6),
    display_unit("mN s", Impulse, -3),
    display_unit("N s", Impulse, 0),
    input_unit("g mm^2", MomentOfInertia, UnitScale::PowerOfTen(-9)),
    input_unit("oz in^2", MomentOfInertia, UnitScale::Decimal("1.8289978339325e-5")), // 0.028349523125 kg x (0.0254 m)^2
    input_unit("lb in^2", MomentOfInertia, UnitScale::Decimal("2.926396534292e-4")),  // 0.45359237 kg x (0.0254 m)^2
    input_unit("g cm^2", MomentOfInertia, UnitScale::PowerOfTen(-7)),
    input_unit("kg mm^2", MomentOfInertia, UnitScale::PowerOfTen(-6)),
    display_unit("kg m^2", MomentOfInertia, 0),
    input_unit("%", Ratio, UnitScale::PowerOfTen(-2)),
];

impl Dimension {
    /// The names of the units of this dimension, in rising order.
    pub fn unit_names(self) -> impl Iterator<Item = &'static str> {
        self.units().map(|unit| unit.name)
    }

    /// The names of the units of all other dimensions.
    pub fn units_of_other_dimensions(self) -> impl Iterator<Item = &'static str> {
        UNITS.iter().filter(move |unit| unit.dimension != self).map(|unit| unit.name)
    }

    /// The units of this dimension, in rising order.
    pub(super) fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }
}
