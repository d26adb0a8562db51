//! A waveguide in place of the half-space, a large plate or a long rod: it gives way under the impact and absorbs energy as waves.
//!
//! Under a force F an infinite plate moves with w' = Y F at every instant (Zener 1941, Phys. Rev. 59, 669-673), and so does the end of
//! a long rod (Sears 1908, Trans. Camb. Phil. Soc. 21, 49-106). [`plate`](super::plate) and [`rod`](super::rod) have the mobility Y.
//! So for the centre of the sphere, p, and for the approach δ
//!
//! ```text
//! m p' = −F + m g,   δ' = p − Y F    <=>    m δ'' = −F + m g − m Y F' δ'
//! ```
//!
//! So the waveguide acts as a drag on the motion, and not in the contact force. In the units of an impact y = Y Φ/V, and
//!
//! ```text
//! sphere      0.4 p²,  p = u + y f      waveguide   E_p = 0.8 ∫ drag u dτ − 0.8 y f u − 0.4 y² f² + w w_p
//! displacement of the waveguide   w_p = y (w τ + 0.8 (q − p))             w = m g/Φ
//! ```
//!
//! Zener's number λ = Y m/T, T = (m/(K √v))^(2/5) with Hertz's K, measures the loss. For an elastic contact e = 1 − 1.73 λ for small
//! λ, and 0.679 λ^−5 for large λ.

use std::fmt;

use super::plate::Plate;
use super::rod::Rod;
use super::scales::Scales;
use crate::contact::body::HalfSpace;
use crate::contact::law::Law;
use crate::numerics::functions::{pow, powi};

/// A target that carries energy away as waves, at rest before the impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Waveguide {
    Plate(Plate),
    Rod(Rod),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WaveguideKind {
    Plate,
    Rod,
}

impl WaveguideKind {
    /// Its name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plate => "plate",
            Self::Rod => "rod",
        }
    }

    /// The key with its size.
    pub const fn size_key(self) -> &'static str {
        match self {
            Self::Plate => "half_space.thickness",
            Self::Rod => "half_space.rod_diameter",
        }
    }
}

impl Waveguide {
    pub fn kind(&self) -> WaveguideKind {
        match self {
            Self::Plate(_) => WaveguideKind::Plate,
            Self::Rod(_) => WaveguideKind::Rod,
        }
    }

    /// The plate, if it is one.
    pub fn plate(&self) -> Option<&Plate> {
        match self {
            Self::Plate(plate) => Some(plate),
            Self::Rod(_) => None,
        }
    }

    /// The rod, if it is one.
    pub fn rod(&self) -> Option<&Rod> {
        match self {
            Self::Rod(rod) => Some(rod),
            Self::Plate(_) => None,
        }
    }

    /// Thickness of the plate, or diameter of the rod \[m\]. Y goes with the inverse square of both.
    pub fn size(&self) -> f64 {
        match self {
            Self::Plate(plate) => plate.thickness,
            Self::Rod(rod) => rod.diameter,
        }
    }
}

/// The largest λ with a result: e is below 3e-7 there.
pub const MAX_ZENER_NUMBER: f64 = 20.0;

/// Why an impact on a waveguide is not possible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveguideError {
    pub kind: WaveguideKind,
    pub reason: WaveguideFault,
}

/// The reason why an impact on a waveguide is impossible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WaveguideFault {
    /// The density of the waveguide is not given.
    NoDensity,
    /// A target that is not flat, or that moves as a whole.
    Curved,
    /// Damping too, where the drag of one would act on the other.
    Damped,
    /// A straight unloading branch that the waveguide damps beyond critical.
    NeverEnds {
        /// Least size \[m\].
        least: f64,
    },
    /// Zener's number above [`MAX_ZENER_NUMBER`].
    TooThin {
        /// λ.
        zener_number: f64,
        /// e of an elastic contact.
        restitution: f64,
        /// Least size \[m\].
        least: f64,
    },
}

impl fmt::Display for WaveguideError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, key) = (self.kind.name(), self.kind.size_key());
        match self.reason {
            WaveguideFault::NoDensity => {
                write!(f, "a {name} requires half_space.density. Add the density of the {name}.")
            }
            WaveguideFault::Curved => {
                let why = match self.kind {
                    WaveguideKind::Plate => "a plate is flat and gives way by bending",
                    WaveguideKind::Rod => "the end of the rod is flat, and the rod gives way by a wave",
                };
                write!(
                    f,
                    "a {name} cannot have half_space.radius or half_space.mass, because {why}. Remove {key}, or the other keys."
                )
            }
            WaveguideFault::Damped => {
                write!(f, "a {name} cannot be combined with [damping]. Remove {key} or [damping].")
            }
            WaveguideFault::NeverEnds { least } => write!(
                f,
                "the {name} is too thin for this law: the sphere would not separate. {key} must be above {least:.3e} m."
            ),
            WaveguideFault::TooThin { zener_number, restitution, least } => write!(
                f,
                "e is practically 0: Zener's number {zener_number:.4} exceeds {MAX_ZENER_NUMBER}, and an elastic contact has e = {restitution:.1e}. {key} must be above {least:.3e} m."
            ),
        }
    }
}

impl std::error::Error for WaveguideError {}

/// A waveguide under a sphere: everything that does not depend on the speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::impact) struct ContactWaveguide {
    pub(in crate::impact) guide: Waveguide,
    /// Mass of the sphere \[kg\].
    mass: f64,
    /// c_p of a plate, c_0 of a rod \[m/s\].
    wave_speed: f64,
    /// Y \[s/kg\], of a thin plate.
    mobility: f64,
}

/// A waveguide in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::impact) struct ScaledWaveguide {
    pub(in crate::impact) target: ContactWaveguide,
    /// y = Y Φ/V.
    pub(in crate::impact) mobility: f64,
    /// λ.
    pub(in crate::impact) zener_number: f64,
    /// X: how many times its own size a wave travels in the contact time on a half-space.
    pub(in crate::impact) wave_transits: f64,
}

impl ContactWaveguide {
    /// `law` is the law of the contact, in these scales.
    pub(in crate::impact) fn new(
        guide: Waveguide,
        half_space: &HalfSpace,
        mass: f64,
        scales: &Scales,
        law: &Law,
    ) -> Result<Self, WaveguideError> {
        let refuse = |reason| WaveguideError { kind: guide.kind(), reason };
        let density = half_space.density.ok_or(refuse(WaveguideFault::NoDensity))?;
        let material = &half_space.material;
        let (mobility, wave_speed) = match &guide {
            Waveguide::Plate(plate) => (plate.mobility(material, density), Plate::wave_speed(material, density)),
            Waveguide::Rod(rod) => (rod.mobility(material, density), Rod::wave_speed(material, density)),
        };
        // straight unloading is an oscillation of stiffness s that Y damps: critically where Y² s m = 4
        let unloading = law.unload(law.loaded_state(1.0));
        let square =
            mobility * mobility * (unloading.power_stiffness() * scales.units.force / scales.units.length) * mass;
        if unloading.exponent == 1.0 && square >= 4.0 {
            return Err(refuse(WaveguideFault::NeverEnds { least: guide.size() * (0.25 * square).sqrt().sqrt() }));
        }
        Ok(Self { guide, mass, wave_speed, mobility })
    }

    /// The distance \[m\] of an edge or of the far end, from beyond which no wave returns within this time.
    pub(in crate::impact) fn wave_reach(&self, time: f64) -> f64 {
        match &self.guide {
            Waveguide::Plate(plate) => plate.wave_reach(self.wave_speed, time),
            Waveguide::Rod(_) => Rod::wave_reach(self.wave_speed, time),
        }
    }

    /// The waveguide in the units of an impact at `speed` \[m/s\] with Hertz's stiffness K. `free_time` is the contact time \[s\] on a
    /// half-space.
    pub(in crate::impact) fn to_scaled(
        self,
        speed: f64,
        hertz_stiffness: f64,
        scales: &Scales,
        free_time: f64,
    ) -> Result<ScaledWaveguide, WaveguideError> {
        let Self { guide, mass, wave_speed, mobility } = self;
        let wave_transits = wave_speed * free_time / guide.size();
        let zener_number = mobility * mass * pow(hertz_stiffness * speed.sqrt() / mass, 0.4);
        if zener_number > MAX_ZENER_NUMBER {
            let restitution = 0.679 * powi(zener_number, -5);
            let least = guide.size() * (zener_number / MAX_ZENER_NUMBER).sqrt();
            let reason = WaveguideFault::TooThin { zener_number, restitution, least };
            return Err(WaveguideError { kind: guide.kind(), reason });
        }
        let mobility = mobility * guide.plate().map_or(1.0, |plate| plate.correction(wave_transits));
        Ok(ScaledWaveguide {
            target: self,
            mobility: mobility * scales.units.force / scales.speed,
            zener_number,
            wave_transits,
        })
    }
}
