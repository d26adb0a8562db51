//! The quantities of a scenario: dimension, allowed range, and a hint about values outside of it.

use std::f64::consts::FRAC_PI_2;
use std::ops::Bound::{self, Excluded, Included};
use std::ops::RangeBounds as _;

use crate::contact::strength::hardness;
use crate::units::{self, Dimension, format_four_digits};

/// The values that a key may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// With its article, as messages need it.
    pub name: &'static str,
    pub dimension: Dimension,
    pub low: Bound<f64>,
    pub high: Bound<f64>,
    pub example: &'static str,
    /// The remedy for a value at or below the lower end; may be empty.
    pub too_low: &'static str,
    /// The remedy for a value at or above the upper end; may be empty.
    pub too_high: &'static str,
    /// True if it may be given on a scale of hardness too.
    pub is_hardness: bool,
}

const fn positive(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity {
        name,
        dimension,
        low: Excluded(0.0),
        high: Excluded(f64::INFINITY),
        example,
        too_low: "",
        too_high: "",
        is_hardness: false,
    }
}

const fn non_negative(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity { low: Included(0.0), ..positive(name, dimension, example) }
}

const fn bounded_ratio(name: &'static str, low: Bound<f64>, high: Bound<f64>, example: &'static str) -> Quantity {
    bounded_quantity(name, Dimension::Ratio, low, high, example)
}

const fn bounded_quantity(
    name: &'static str,
    dimension: Dimension,
    low: Bound<f64>,
    high: Bound<f64>,
    example: &'static str,
) -> Quantity {
    Quantity { low, high, ..positive(name, dimension, example) }
}

/// A radius or diameter.
pub const LENGTH: Quantity = positive("a length", Dimension::Length, "\"5 mm\"");
/// A radius of curvature: of a hollow where it is negative.
pub const CURVATURE: Quantity = Quantity {
    too_high: "for a flat half-space remove the key",
    ..bounded_quantity("a radius", Dimension::Length, Excluded(f64::NEG_INFINITY), Excluded(f64::INFINITY), "\"10 mm\"")
};
pub const MODULUS: Quantity = positive("a Young's modulus", Dimension::Pressure, "\"210 GPa\"");
/// The sphere's modulus, which is infinite for a rigid sphere.
pub const SPHERE_MODULUS: Quantity = Quantity { too_high: "for a rigid sphere write \"rigid\"", ..MODULUS };
pub const STRENGTH: Quantity = Quantity {
    too_high: "for an elastic body remove the key",
    ..positive("a yield strength", Dimension::Pressure, "\"345 MPa\"")
};
/// A hardness, as the mean pressure of a hardness test. No material that keeps a dent is softer than the lower end, which
/// refuses a Vickers hardness that is written without HV.
pub const HARDNESS: Quantity = Quantity {
    is_hardness: true,
    low: Included(1e5),
    too_low: "a number alone is in Pa; for a Vickers hardness write \"300 HV\"",
    ..positive("a hardness", Dimension::Pressure, "\"300 HV\"")
};
pub const MASS: Quantity = positive("a mass", Dimension::Mass, "\"5.5 g\"");
/// N of a power law of hardening: above 0.5 the law is not validated.
pub const HARDENING_EXPONENT: Quantity = bounded_ratio("a hardening exponent", Included(0.0), Included(0.5), "0.1");
/// By how many yield strengths a flow stress rises.
pub const SATURATION: Quantity = bounded_ratio("a saturation", Included(0.0), Included(100.0), "1.5");
/// How fast a flow stress rises over plastic strain.
pub const HARDENING_RATE: Quantity = bounded_ratio("a rate of hardening", Excluded(0.0), Included(1e4), "15");
/// Slope of a flow stress over plastic strain.
pub const HARDENING_SLOPE: Quantity = non_negative("a slope of hardening", Dimension::Pressure, "\"4.2 GPa\"");
/// c of Johnson and Cook's rate factor: metals have 0.001 to 0.06.
pub const RATE_SENSITIVITY: Quantity = bounded_ratio("a rate sensitivity", Included(0.0), Included(0.5), "0.014");
pub const STRAIN_RATE: Quantity = positive("a strain rate", Dimension::StrainRate, "\"1 1/s\"");
/// q of Cowper and Symonds' rate factor.
pub const RATE_EXPONENT: Quantity = bounded_ratio("a rate exponent", Included(1.0), Included(100.0), "3.91");
pub const STRAIN: Quantity = bounded_ratio("a plastic strain", Included(0.0), Included(10.0), "0.002");
pub const DENSITY: Quantity = positive("a density", Dimension::Density, "\"7850 kg/m^3\"");
pub const SPEED: Quantity = positive("a speed", Dimension::Speed, "\"3 m/s\"");
/// A load of an indentation.
pub const LOAD: Quantity = non_negative("a load", Dimension::Force, "\"200 N\"");
pub const INDENTATION: Quantity = non_negative("an indentation", Dimension::Length, "\"12 um\"");
/// Poisson's ratio of a stable isotropic material.
pub const POISSONS_RATIO: Quantity = Quantity {
    too_high: "for an incompressible material write 0.4999",
    ..bounded_ratio("a Poisson's ratio", Excluded(-1.0), Excluded(0.5), "0.3")
};
/// The exponent n of the unloading branch.
pub const EXPONENT: Quantity = bounded_ratio("an unloading exponent", Excluded(1.0), Included(2.0), "1.5");
/// A factor of a published law, such as a pressure over the yield strength.
pub const FACTOR: Quantity = bounded_ratio("a factor", Excluded(0.0), Included(100.0), "1.6");
/// True contact area over the area in which the sphere cuts the original surface: from sink-in to pile-up.
pub const AREA_FACTOR: Quantity = bounded_ratio("an area factor", Included(0.5), Included(2.0), "1.43");
/// Indentation at full plasticity over that at yield.
pub const TRANSITION_RATIO: Quantity = bounded_ratio("a transition ratio", Excluded(1.0), Included(1e6), "110");
pub const FORCE: Quantity = positive("a force", Dimension::Force, "\"43.5 kN\"");
/// A ratio of at most 1.
pub const SHARE: Quantity = bounded_ratio("a ratio", Excluded(0.0), Included(1.0), "0.5");

/// The relative tolerance of an integration: from 45 times the spacing of doubles at 1 to where steps have no meaning.
pub const TOLERANCE: Quantity = bounded_ratio("a tolerance", Included(1e-14), Included(1e-2), "1e-10");
/// Rows of a trace: at least its two ends, at most what some hundred megabytes of memory hold.
pub const SAMPLES: Quantity = Quantity {
    too_high: "a trace is held in memory; for a finer look at a part of it, interpolate between its rows",
    ..bounded_ratio("a number of samples", Included(2.0), Included(1e6), "400")
};
/// Length of a pulse with zeros over the contact time.
pub const PADDING: Quantity = bounded_ratio("a padding", Included(1.0), Included(1024.0), "8");
/// Steps of the fixed-step method: at least one, at most what takes seconds to compute.
pub const STEPS: Quantity = bounded_ratio("a number of steps", Included(1.0), Included(1e8), "50");

pub const ACCELERATION: Quantity = Quantity {
    too_low: "for no gravity remove the table",
    ..positive("an acceleration", Dimension::Acceleration, "\"9.81 m/s^2\"")
};
/// A height that the sphere falls from.
pub const DROP_HEIGHT: Quantity = non_negative("a drop height", Dimension::Length, "\"0.5 m\"");
pub const HUNT_CROSSLEY: Quantity = non_negative("a Hunt-Crossley coefficient", Dimension::InverseSpeed, "\"0.1 s/m\"");
/// Fraction of critical damping.
///
/// A contact usually has a few hundredths to a few tenths of critical damping. Above a thousand times critical it only creeps, and the
/// number of steps, which grows with the square of this fraction, exceeds the limit of a run.
pub const VISCOUS: Quantity = Quantity {
    too_high: "with more damping the sphere does not separate",
    ..bounded_ratio("a fraction of critical damping", Included(0.0), Included(1000.0), "0.05")
};

/// A of a viscoelastic contact: polymers have 0.1 us to 1 ms.
pub const VISCOELASTIC_TIME: Quantity = non_negative("a viscoelastic time", Dimension::Time, "\"1.2 us\"");

/// The work of adhesion: solids have 0.01 to 2 J/m².
pub const WORK_OF_ADHESION: Quantity = Quantity {
    too_high: "solids have 0.01 to 2 J/m^2; check the unit",
    ..bounded_quantity("a work of adhesion", Dimension::SurfaceEnergy, Included(0.0), Included(100.0), "\"0.05 J/m^2\"")
};

pub const SHOT_SPEED: Quantity = Quantity { too_low: "an impact needs a speed. Remove this value", ..SPEED };
/// Repeated impacts: as many as a table of some hundred megabytes has rows.
pub const IMPACTS: Quantity = bounded_ratio("a number of impacts", Included(1.0), Included(1e6), "20");

pub const RESTITUTION: Quantity = Quantity {
    too_high: "a restitution is a ratio: for 60 % write 0.6",
    ..bounded_ratio("a restitution", Excluded(0.0), Included(1.0), "0.49")
};
/// A measured rebound hardness: 1000 times the restitution.
pub const LEEB: Quantity = bounded_ratio("a Leeb hardness", Excluded(0.0), Included(1000.0), "760");
/// An angle of impact, from the normal.
pub const ANGLE: Quantity = Quantity {
    too_high: "angles are measured from the surface normal",
    ..bounded_quantity("an angle", Dimension::Angle, Included(0.0), Excluded(FRAC_PI_2), "\"30 deg\"")
};
/// A spin, forward or backward.
pub const SPIN: Quantity =
    bounded_quantity("a spin", Dimension::AngularSpeed, Included(-1e12), Included(1e12), "\"100 rad/s\"");
pub const MOMENT_OF_INERTIA: Quantity = positive("a moment of inertia", Dimension::MomentOfInertia, "\"1e-6 kg m^2\"");
pub const FRICTION: Quantity = non_negative("a coefficient of friction", Dimension::Ratio, "0.1");
pub const DRAG: Quantity = Quantity {
    too_high: "a sphere has about 0.5",
    ..bounded_ratio("a drag coefficient", Included(0.0), Included(100.0), "0.5")
};
/// The viscosity of air.
pub const VISCOSITY: Quantity = positive("a viscosity", Dimension::Viscosity, "\"1.8e-5 Pa s\"");
pub const TIME: Quantity = positive("a time", Dimension::Time, "\"20 us\"");
pub const DEVIATION: Quantity = positive("a standard deviation", Dimension::Ratio, "0.01");
/// The error of the law as a fraction of its prediction.
pub const MODEL_ERROR: Quantity = bounded_ratio("a share", Included(0.0), Excluded(1.0), "0.02");

/// The covered fraction of a peened surface. Impacts at random places never cover all of the surface.
pub const COVERAGE: Quantity = Quantity {
    too_high: "a coverage is a fraction of the surface, and random impacts never reach 1. Full coverage (\"100 %\") is 0.98; \"200 %\" is twice the time for 0.98",
    ..bounded_ratio("a coverage", Excluded(0.0), Excluded(1.0), "0.98")
};
pub const MASS_FLOW: Quantity = positive("a mass flow", Dimension::MassFlow, "\"5 kg/min\"");
pub const AREA: Quantity = positive("an area", Dimension::Area, "\"50 cm^2\"");

/// Random cases of a table.
pub const N_SAMPLES: Quantity = bounded_ratio("a number of samples", Included(1.0), Excluded(f64::INFINITY), "100000");
pub const SEED: Quantity = bounded_ratio("a seed", Included(0.0), Excluded(f64::INFINITY), "7");
/// Values of an axis.
pub const POINTS: Quantity = Quantity {
    too_low: "an axis needs at least one value",
    ..bounded_ratio("a number of values", Included(1.0), Excluded(f64::INFINITY), "11")
};

/// Any positive number of this dimension.
pub const fn positive_quantity(dimension: Dimension) -> Quantity {
    positive("a number", dimension, "")
}

impl Quantity {
    /// The value in SI, if it is allowed.
    ///
    /// # Errors
    /// The value, the allowed range, and what to do.
    pub fn check(&self, value: f64) -> Result<f64, String> {
        self.check_with_text(value, || units::format_si_and_short(value, self.dimension))
    }

    fn check_with_text(&self, value: f64, written: impl FnOnce() -> String) -> Result<f64, String> {
        if (self.low, self.high).contains(&value) {
            return Ok(value);
        }
        let low = self.range().0;
        let hint = if value <= low { self.too_low } else { self.too_high };
        let way_out = if hint.is_empty() || value.is_nan() { String::new() } else { format!("; {hint}") };
        Err(format!("{} is not allowed: {} must be {}{way_out}", written(), self.name, self.allowed_range()))
    }

    /// Checks a number without quotes, in SI. An angle needs a unit, because degrees and radians are easily confused.
    pub fn check_si_number(&self, value: f64) -> Result<f64, String> {
        if self.dimension == Dimension::Angle {
            return Err(format!(
                "{} has no unit; write {} such as {}",
                units::format_number(value),
                self.name,
                self.example
            ));
        }
        self.check(value)
    }

    /// Parses a text such as "5 mm", and checks the value.
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        let value = match hardness::parse(text).filter(|_| self.is_hardness) {
            Some((number, scale)) => scale.mean_pressure(number).map_err(|error| error.to_string())?,
            None => units::parse_named(text, self.dimension, self.name, self.example).map_err(|error| {
                if self.is_hardness { format!("{error}; or a hardness in HV, HB, HRB or HRC") } else { error }
            })?,
        };
        self.check_with_text(value, || format!("\"{text}\" = {}", units::format_si(value, self.dimension)))
    }

    /// A value as text: a hardness in HV, an angle in degrees, other values in a suitable unit.
    pub fn display(&self, value: f64) -> String {
        if self.is_hardness {
            format!("{} HV", format_four_digits(hardness::vickers_number(value)))
        } else if self.dimension == Dimension::Angle {
            format!("{} deg", format_four_digits(value.to_degrees()))
        } else {
            units::format_input(value, self.dimension)
        }
    }

    /// The unit of the quantity in pictures, and the function that converts a value in SI to this unit: HV for a hardness,
    /// degrees for an angle, the SI unit for any other.
    pub fn picture_unit(&self) -> (&'static str, fn(f64) -> f64) {
        if self.is_hardness {
            ("HV", hardness::vickers_number)
        } else if self.dimension == Dimension::Angle {
            ("°", f64::to_degrees)
        } else {
            (self.dimension.si_unit(), |value| value)
        }
    }

    /// Values in the key of a picture: in the unit of [`Self::picture_unit`], or all in one suitable unit.
    pub fn picture_labels(&self, values: &[f64]) -> Vec<String> {
        match self.picture_unit() {
            (unit, _) if unit == self.dimension.si_unit() => units::quantities(values, self.dimension),
            (unit, convert) => {
                let space = if unit == "°" { "" } else { " " };
                values.iter().map(|value| format!("{}{space}{unit}", format_four_digits(convert(*value)))).collect()
            }
        }
    }

    /// The ends of the allowed range.
    pub fn range(&self) -> (f64, f64) {
        let end = |bound| match bound {
            Excluded(end) | Included(end) => end,
            Bound::Unbounded => f64::INFINITY,
        };
        (end(self.low), end(self.high))
    }

    /// The allowed range in words: "> 0 m and finite".
    pub fn allowed_range(&self) -> String {
        let is_angle = self.dimension == Dimension::Angle;
        let value = |value| if is_angle { self.display(value) } else { units::format_si(value, self.dimension) };
        let (low, high) = self.range();
        if low == f64::NEG_INFINITY && high == f64::INFINITY {
            return "that is finite".to_owned();
        }
        let or_equal = |bound| if matches!(bound, Included(_)) { "=" } else { "" };
        let low = format!(">{} {}", or_equal(self.low), value(low));
        if high == f64::INFINITY {
            return format!("{low} and finite");
        }
        format!("{low} and <{} {}", or_equal(self.high), value(high))
    }
}
