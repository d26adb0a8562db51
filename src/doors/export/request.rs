//! The request: for which code, and at which speeds.

use crate::units::names::named;

named! {
    /// Which code the lines are for.
    pub enum Target {
        /// LAMMPS, `fix wall/gran`; for two spheres `pair_style granular`.
        Lammps = "lammps",
        /// LIGGGHTS, `fix wall/gran model hooke`; for two spheres `pair_style gran`.
        Liggghts = "liggghts",
        /// Yade, `ViscElMat`.
        Yade = "yade",
        /// MercuryDPM, a species with e and contact time.
        Mercury = "mercury",
        /// A table e(v) as CSV.
        Csv = "csv",
    }
}

impl Target {
    /// Whether the code reads a table e(v).
    pub(super) fn takes_table(self) -> bool {
        self == Self::Csv
    }
}

/// The request of a user.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    pub target: Target,
    /// Impact speed \[m/s\]; `None` for the speed of the scenario.
    pub speed: Option<f64>,
    /// First and last speed of a table \[m/s\]; `None` for a tenth to ten times the impact speed.
    pub speeds: Option<(f64, f64)>,
}
