//! The limits of the model. Beyond each of them a warning states the consequence for the result. `scenarios/trust.md` lists them, and
//! a test compares the list with these numbers. The limit of the contact radius belongs to each law
//! ([`Validity`](crate::contact::law::published::Validity)).

/// Wave transits of the sphere (2 R / c) in the contact time, below which a contact is not quasi-static.
pub const MIN_TRANSITS: f64 = 5.0;
/// Γ \[J/m²\], the work of adhesion in the sticking speed.
pub const WORK_OF_ADHESION: f64 = 0.2;
/// Multiple of the sticking speed from which on the error of e is below 1 %.
pub const ADHESION_RANGE: f64 = 7.0;
/// The smallest σ_Y/E* of a yielding ball in the finite elements.
pub const MIN_FITTED_YIELD_STRAIN: f64 = 5e-4;
/// a/R from which on two unequal balls that both yield have an additional error.
pub const MAX_UNEQUAL_BALLS_RATIO: f64 = 0.1;
/// a/R from which on the metal under a stiff sphere must not be perfectly plastic: it forms a lip, which the law does not have.
pub const MAX_SOFT_RADIUS_RATIO: f64 = 0.4;
/// The smallest Poisson's ratio of a yielding body that is near enough to those of the finite elements, 0.03 to 0.42.
pub const MIN_POISSONS_RATIO: f64 = -0.1;
/// The share of the peak force up to which the inertia of the half-space is negligible.
pub const MAX_INERTIA_SHARE: f64 = 0.02;
/// a/R from which on a sphere ploughs if it hits at more than 45° from the normal.
pub const MAX_PLOUGHING_RATIO: f64 = 0.1;
/// Dundurs' β from which on finite elements show that it is neglected.
pub const MAX_DUNDURS_BETA: f64 = 0.25;
/// Radiated energy over recovered energy, up to which the first-order estimate of the waves holds.
pub const MAX_WAVE_LOSS: f64 = 0.2;
/// Plate thicknesses that a wave travels during the contact, from which on Zener's theory of thin plates holds.
pub const MIN_THIN_PLATE_TRANSITS: f64 = 10.0;
/// Plate thicknesses that a wave travels during the contact, from which on the theory of thick plates holds.
pub const MIN_THICK_PLATE_TRANSITS: f64 = 5.0;
/// Plate thicknesses that a wave travels during the contact, below which a plate acts as a half-space.
pub const MIN_WAVE_TRANSITS: f64 = 2.0;
/// Contact radius over plate thickness, from which on a plate is not as stiff under the sphere as a half-space.
pub const MAX_CONTACT_OVER_THICKNESS: f64 = 0.15;
/// Deflection over plate thickness, from which on a plate also stretches.
pub const MAX_DEFLECTION_OVER_THICKNESS: f64 = 0.3;
/// Rod diameters that a wave travels during the contact, from which on the wave in a rod is one-dimensional.
pub const MIN_ROD_TRANSITS: f64 = 4.0;
/// Contact radius over the radius of the rod, from which on the end of a rod is not as stiff under the sphere as a half-space.
pub const MAX_CONTACT_OVER_ROD_RADIUS: f64 = 0.25;
/// The largest Zener's number up to which contact times on plates were measured, and agree with his theory.
pub const MAX_MEASURED_ZENER_NUMBER: f64 = 1.5;
