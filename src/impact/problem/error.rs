//! Why an impact has no result.

use thiserror::Error;

use super::waveguide::WaveguideError;
use crate::contact::body::{InvalidInput, OutOfFloatRange};
use crate::contact::law::LawError;
use crate::contact::pair::{HollowTooSmall, PairError};
use crate::error::{Error as Failure, ErrorKind};
use crate::numerics::ode::IntegrationError;
use crate::units::{Dimension, format_input};

#[derive(Debug, Clone, PartialEq, Error)]
pub enum ImpactError {
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    #[error(transparent)]
    Hollow(#[from] HollowTooSmall),
    /// A number that is not possible for a body, gravity or damping.
    #[error(transparent)]
    Invalid(#[from] InvalidInput),
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The law has no answer for this impact.
    #[error(transparent)]
    Law(#[from] LawError),
    /// An indentation deeper or wider than the sphere.
    #[error(
        "the indentation would be {} and the contact radius {}, and the radius of the sphere is {}. No contact law applies there. Check the units{}, or reduce the speed.",
        format_input(*.indentation, Dimension::Length), format_input(*.contact_radius, Dimension::Length), format_input(*.radius, Dimension::Length),
        match (.wrong_modulus, .yield_strength) {
            (Some((table, modulus)), _) => {
                let modulus = format_input(*modulus, Dimension::Pressure);
                format!(" ({table}.youngs_modulus = {modulus}?)")
            }
            (None, Some(strength)) => {
                format!(" (half_space.yield_strength = {}?)", format_input(*strength, Dimension::Pressure))
            }
            (None, None) => String::new(),
        }
    )]
    TooDeep {
        /// δ_m \[m\].
        indentation: f64,
        /// a_m \[m\].
        contact_radius: f64,
        /// R \[m\].
        radius: f64,
        /// σ_Y \[Pa\].
        yield_strength: Option<f64>,
        /// Table and Young's modulus \[Pa\] of a body whose modulus cannot be right.
        wrong_modulus: Option<(&'static str, f64)>,
    },
    /// A moment of inertia that is too small for the steps of friction.
    #[error(
        "the moment of inertia is too small for the steps of friction: {}",
        match least {
            Some(least) => format!("at least {least:.3e} kg m^2 is needed, and a solid sphere has {solid:.3e} kg m^2."),
            None => "no value is large enough, because the contact lasts too long. Remove angle and spin, or use a thicker plate or rod.".to_owned(),
        }
    )]
    SmallInertia {
        /// The smallest possible moment of inertia \[kg m²\]; `None` if every value is too small.
        least: Option<f64>,
        /// The moment of inertia of a solid sphere \[kg m²\].
        solid: f64,
    },
    /// The fall of two bodies is not modelled.
    #[error("gravity and a free target cannot be combined. Remove [gravity] or half_space.mass.")]
    FreeUnderGravity,
    /// A body whose moment of inertia is not known.
    #[error(
        "an oblique impact on a free target requires a ball. Write half_space.mass = \"ball\", or remove impact.angle and the spin of the sphere."
    )]
    NoBall,
    /// The metal relaxes at maximum compression, and its force drops at once.
    #[error(
        "damping.viscoelastic_time cannot be combined with a strain-rate dependence, because the metal relaxes at maximum compression, and this drop of the force has no finite stiffness. Remove one of the two."
    )]
    ViscoelasticRate,
    /// An impact on this plate or rod is not possible.
    #[error(transparent)]
    Waveguide(#[from] WaveguideError),
    /// No closed form for this scene.
    #[error("method \"closed_form\" is not available with damping, on a plate or on a rod. Use \"auto\" or \"rk8\".")]
    NoClosedForm,
}

impl From<PairError> for ImpactError {
    fn from(error: PairError) -> Self {
        match error {
            PairError::Range(error) => error.into(),
            PairError::Hollow(error) => error.into(),
            PairError::Invalid(error) => error.into(),
        }
    }
}

impl From<ImpactError> for Failure {
    fn from(error: ImpactError) -> Self {
        Self::caused_by(ErrorKind::Failed, &error)
    }
}
