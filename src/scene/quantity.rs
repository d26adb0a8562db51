//! The quantities of a scenario: dimension, allowed range, and a hint about values outside of it.

use std::f64::consts::FRAC_PI_2;

use thiserror::Error;

use crate::strength::hardness;
use crate::units::{self, Dimension, UnitError, four_digits};

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Not itself allowed.
    Open(f64),
    /// Allowed.
    Closed(f64),
}

/// What a key holds: dimension, allowed range, and what to do outside of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// With its article, for messages.
    pub name: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Lower end.
    pub low: Bound,
    /// Upper end.
    pub high: Bound,
    /// How it may be written.
    pub example: &'static str,
    /// What to do about a value at or beyond one end of the range; may be empty.
    pub hint: &'static str,
    /// Whether the hint is about the lower end.
    pub is_hint_low: bool,
    /// On which scales it may be written.
    pub notation: Notation,
}

const fn positive(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity {
        name,
        dimension,
        low: Bound::Open(0.0),
        high: Bound::Open(f64::INFINITY),
        example,
        hint: "",
        is_hint_low: false,
        notation: Notation::Units,
    }
}

const fn not_negative(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity { low: Bound::Closed(0.0), ..positive(name, dimension, example) }
}

const fn number(name: &'static str, low: Bound, high: Bound, example: &'static str) -> Quantity {
    number_in(name, Dimension::Ratio, low, high, example)
}

const fn number_in(
    name: &'static str,
    dimension: Dimension,
    low: Bound,
    high: Bound,
    example: &'static str,
) -> Quantity {
    Quantity { low, high, ..positive(name, dimension, example) }
}

/// How a value may be written, besides as a plain number in SI.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// With a unit.
    Units,
    /// With a unit of pressure, or on a scale of hardness.
    Hardness,
    /// With a unit, and not as a plain number: degrees and radians are mistaken for each other.
    UnitAlways,
}

/// A quantity as a type: what a `Number` is a value of.
pub trait Kind: 'static {
    /// Its dimension and range.
    const QUANTITY: &'static Quantity;
}

/// Quantities, each as a value and as a type.
macro_rules! quantities {
    ($($(#[doc = $about:literal])+ $name:ident $kind:ident = $quantity:expr;)+) => {$(
        $(#[doc = $about])+
        pub const $name: Quantity = $quantity;
        $(#[doc = $about])+
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $kind;
        impl Kind for $kind {
            const QUANTITY: &'static Quantity = &$name;
        }
    )+};
}

quantities! {
    /// A radius or diameter.
    LENGTH Length = positive("a length", Dimension::Length, "\"5 mm\"");
    /// An elastic modulus.
    MODULUS Modulus = positive("a Young's modulus", Dimension::Pressure, "\"210 GPa\"");
    /// The sphere's modulus, which is infinite for a rigid sphere.
    SPHERE_MODULUS SphereModulus = Quantity { hint: "for a rigid sphere write \"rigid\"", ..MODULUS };
    /// A yield strength.
    STRENGTH Strength = Quantity {
        hint: "for an elastic body leave the key out",
        ..positive("a yield strength", Dimension::Pressure, "\"345 MPa\"")
    };
    /// A hardness, as the mean pressure of a hardness test. No material that keeps a dent is softer than the lower end, which
    /// refuses a Vickers hardness that is written without HV.
    HARDNESS Hardness = Quantity {
        notation: Notation::Hardness,
        low: Bound::Closed(1e5),
        hint: "a number alone is in Pa; for a Vickers hardness write \"300 HV\"",
        is_hint_low: true,
        ..positive("a hardness", Dimension::Pressure, "\"300 HV\"")
    };
    /// A mass.
    MASS Mass = positive("a mass", Dimension::Mass, "\"5.5 g\"");
    /// N of a power law of hardening: beyond 0.5 the law has not been compared with anything.
    HARDENING_EXPONENT HardeningExponent = number("a hardening exponent", Bound::Closed(0.0), Bound::Closed(0.5), "0.1");
    /// By how many yield strengths a flow stress rises.
    SATURATION Saturation = number("a saturation", Bound::Closed(0.0), Bound::Closed(100.0), "1.5");
    /// How fast a flow stress rises over plastic strain.
    HARDENING_RATE HardeningRate = number("a rate of hardening", Bound::Open(0.0), Bound::Closed(1e4), "15");
    /// Slope of a flow stress over plastic strain.
    HARDENING_SLOPE HardeningSlope = not_negative("a slope of hardening", Dimension::Pressure, "\"4.2 GPa\"");
    /// A plastic strain.
    STRAIN Strain = number("a plastic strain", Bound::Closed(0.0), Bound::Closed(10.0), "0.002");
    /// A density.
    DENSITY Density = positive("a density", Dimension::Density, "\"7850 kg/m^3\"");
    /// An impact speed.
    SPEED Speed = positive("a speed", Dimension::Speed, "\"3 m/s\"");
    /// A load that an indentation goes to.
    LOAD Load = not_negative("a load", Dimension::Force, "\"200 N\"");
    /// An indentation that it goes to.
    INDENTATION Indentation = not_negative("an indentation", Dimension::Length, "\"12 um\"");
    /// Poisson's ratio of a stable isotropic material.
    POISSONS_RATIO PoissonsRatio = Quantity {
        hint: "for an incompressible material write 0.4999",
        ..number("a Poisson's ratio", Bound::Open(-1.0), Bound::Open(0.5), "0.3")
    };
    /// The exponent n of the unloading branch.
    EXPONENT Exponent = number("an unloading exponent", Bound::Open(1.0), Bound::Closed(2.0), "1.5");
    /// A factor of a published law, such as a pressure over the yield strength.
    FACTOR Factor = number("a factor", Bound::Open(0.0), Bound::Closed(100.0), "1.6");
    /// True contact area over the area in which the sphere cuts the original surface: from sink-in to pile-up.
    AREA_FACTOR AreaFactor = number("an area factor", Bound::Closed(0.5), Bound::Closed(2.0), "1.43");
    /// Indentation at full plasticity over that at yield.
    TRANSITION_RATIO TransitionRatio = number("a transition ratio", Bound::Open(1.0), Bound::Closed(1e6), "110");
    /// Indentation over that at first yield, for an indentation that leaves a dent.
    DEPTH_RATIO DepthRatio = number("a depth over that at yield", Bound::Open(1.0), Bound::Closed(1e6), "105.1");
    /// A force.
    FORCE Force = positive("a force", Dimension::Force, "\"43.5 kN\"");
    /// An energy.
    ENERGY Energy = positive("an energy", Dimension::Energy, "\"4.2 J\"");
    /// A ratio of at most 1.
    SHARE Share = number("a ratio", Bound::Open(0.0), Bound::Closed(1.0), "0.5");

    /// The relative tolerance of an integration: from 45 times the spacing of doubles at 1 to where steps have no meaning.
    TOLERANCE Tolerance = number("a tolerance", Bound::Closed(1e-14), Bound::Closed(1e-2), "1e-10");
    /// Rows of a trace: at least its two ends, at most what some hundred megabytes of memory hold.
    SAMPLES Samples = Quantity {
        hint: "a trace is held in memory; for a finer look at a part of it, interpolate between its rows",
        ..number("a number of samples", Bound::Closed(2.0), Bound::Closed(1e6), "400")
    };
    /// Steps of the fixed-step method: at least one, at most what takes seconds to compute.
    STEPS Steps = number("a number of steps", Bound::Closed(1.0), Bound::Closed(1e8), "50");

    /// Gravity.
    ACCELERATION Acceleration = Quantity {
        hint: "to do without gravity leave the table out",
        is_hint_low: true,
        ..positive("an acceleration", Dimension::Acceleration, "\"9.81 m/s^2\"")
    };
    /// A height that the sphere falls from.
    DROP_HEIGHT DropHeight = not_negative("a drop height", Dimension::Length, "\"0.5 m\"");
    /// χ of Hunt and Crossley.
    HUNT_CROSSLEY HuntCrossley = not_negative("a Hunt-Crossley coefficient", Dimension::InverseSpeed, "\"0.1 s/m\"");
    /// Fraction of critical damping.
    ///
    /// A contact is damped by a few hundredths to a few tenths of critical. Beyond a thousand times critical it only
    /// creeps. The number of steps of a creep grows with the square of this fraction, to more than a run can take.
    VISCOUS Viscous = Quantity {
        hint: "beyond that a contact only creeps",
        ..number("a fraction of critical damping", Bound::Closed(0.0), Bound::Closed(1000.0), "0.05")
    };

    /// The speed of one shot of a list.
    SHOT_SPEED ShotSpeed = Quantity { hint: "a shot without speed does not touch: leave it out", is_hint_low: true, ..SPEED };
    /// Repeated impacts: as many as a table of some hundred megabytes has rows.
    IMPACTS Impacts = number("a number of impacts", Bound::Closed(1.0), Bound::Closed(1e6), "20");

    /// A measured restitution.
    RESTITUTION Restitution = number("a restitution", Bound::Open(0.0), Bound::Closed(1.0), "0.49");
    /// A measured rebound hardness: 1000 times the restitution.
    LEEB Leeb = number("a Leeb hardness", Bound::Open(0.0), Bound::Closed(1000.0), "760");
    /// An angle.
    ANGLE Angle = Quantity {
        notation: Notation::UnitAlways,
        ..number_in("an angle", Dimension::Angle, Bound::Closed(0.0), Bound::Closed(FRAC_PI_2), "\"30 deg\"")
    };
    /// A measured time.
    TIME Time = positive("a time", Dimension::Time, "\"20 us\"");
    /// The standard deviation of a plain number.
    DEVIATION Deviation = positive("a standard deviation", Dimension::Ratio, "0.01");
    /// The error of the law as a share of what it predicts.
    MODEL_ERROR ModelError = number("a share", Bound::Closed(0.0), Bound::Open(1.0), "0.02");

    /// Random cases of a table.
    SAMPLED Sampled = number("a number of samples", Bound::Closed(1.0), Bound::Open(f64::INFINITY), "100000");
    /// The seed of random numbers.
    SEED Seed = number("a seed", Bound::Closed(0.0), Bound::Open(f64::INFINITY), "7");
    /// Values of an axis.
    POINTS Points = Quantity {
        hint: "an axis needs at least one value",
        is_hint_low: true,
        ..number("a number of values", Bound::Closed(1.0), Bound::Open(f64::INFINITY), "11")
    };
}

/// Any positive number of this dimension.
pub const fn positive_of(dimension: Dimension) -> Quantity {
    positive("a number", dimension, "")
}

/// A value outside its range.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{written} is not allowed: {} must be {}{}", .quantity.name, .quantity.allowed(), .quantity.way_out(*.value))]
pub struct RangeError {
    /// The value as it was written.
    pub written: String,
    /// The value in SI.
    pub value: f64,
    /// The quantity, with the allowed range.
    pub quantity: Quantity,
}

impl Quantity {
    /// The value in SI, if it is allowed.
    pub fn check(&self, value: f64) -> Result<f64, RangeError> {
        let above = match self.low {
            Bound::Open(low) => value > low,
            Bound::Closed(low) => value >= low,
        };
        let below = match self.high {
            Bound::Open(high) => value < high,
            Bound::Closed(high) => value <= high,
        };
        let written = || units::describe(value, self.dimension);
        if above && below { Ok(value) } else { Err(RangeError { written: written(), value, quantity: *self }) }
    }

    /// Checks a number that stands without quotes, in SI.
    ///
    /// # Errors
    /// The message of a [`RangeError`], or that this quantity needs a unit.
    pub fn plain(&self, value: f64) -> Result<f64, String> {
        if self.notation == Notation::UnitAlways {
            return Err(format!("{} has no unit; write {} such as {}", units::number(value), self.name, self.example));
        }
        self.check(value).map_err(|error| error.to_string())
    }

    /// Reads a text such as "5 mm", and checks the value.
    ///
    /// # Errors
    /// The message of a [`units::UnitError`] or [`RangeError`].
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        let scale = hardness::written(text).filter(|_| self.notation == Notation::Hardness);
        let value = match scale {
            Some((number, scale)) => scale.mean_pressure(number).map_err(|error| error.to_string()),
            None => self.with_unit(text),
        }?;
        self.check(value).map_err(|error| {
            let written = format!("\"{text}\" = {}", units::si(value, self.dimension));
            RangeError { written, ..error }.to_string()
        })
    }

    /// A value as text: a hardness in HV, any other in a suitable unit.
    pub fn human(&self, value: f64) -> String {
        match self.notation {
            Notation::Units | Notation::UnitAlways => units::human(value, self.dimension),
            Notation::Hardness => format!("{} HV", four_digits(hardness::vickers(value))),
        }
    }

    /// A number with a unit, in SI.
    fn with_unit(&self, text: &str) -> Result<f64, String> {
        units::parse(text, self.dimension).map_err(|error| match error {
            UnitError::NoNumber { text, .. } => {
                format!("\"{text}\" does not begin with a number; write {} such as {}", self.name, self.example)
            }
            UnitError::NoUnit { text, .. } if self.notation == Notation::UnitAlways => {
                format!("\"{text}\" has no unit; write {} such as {}", self.name, self.example)
            }
            error if self.notation == Notation::Hardness => format!("{error}; or a hardness in HV, HB or HRC"),
            error => error.to_string(),
        })
    }

    /// The ends of the allowed range.
    pub fn range(&self) -> (f64, f64) {
        let (Bound::Open(low) | Bound::Closed(low)) = self.low;
        let (Bound::Open(high) | Bound::Closed(high)) = self.high;
        (low, high)
    }

    /// The allowed range in words: "> 0 m and finite".
    pub fn allowed(&self) -> String {
        let value = |value| units::si(value, self.dimension);
        let low = match self.low {
            Bound::Open(low) => format!("> {}", value(low)),
            Bound::Closed(low) => format!(">= {}", value(low)),
        };
        match self.high {
            Bound::Open(f64::INFINITY) => format!("{low} and finite"),
            Bound::Open(high) => format!("{low} and < {}", value(high)),
            Bound::Closed(high) => format!("{low} and <= {}", value(high)),
        }
    }

    fn way_out(&self, value: f64) -> String {
        let (low, high) = self.range();
        let is_beyond = if self.is_hint_low { value <= low } else { value >= high };
        if is_beyond && !self.hint.is_empty() { format!("; {}", self.hint) } else { String::new() }
    }
}
