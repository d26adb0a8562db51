//! The request: for which code, and at which speeds.

/// Which code the lines are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// LAMMPS, `fix wall/gran`.
    Lammps,
    /// LIGGGHTS, `fix wall/gran model hooke`.
    Liggghts,
    /// Yade, `ViscElMat`.
    Yade,
    /// MercuryDPM, a species with e and contact time.
    Mercury,
    /// Altair AcuSolve, walls of particles.
    Acusolve,
    /// Ansys Fluent, the normal coefficient of a wall.
    Fluent,
    /// A table e(v) as CSV.
    Csv,
}

impl Target {
    /// Every target, and its name on the command line.
    pub const ALL: [(&'static str, Self); 7] = [
        ("lammps", Self::Lammps),
        ("liggghts", Self::Liggghts),
        ("yade", Self::Yade),
        ("mercury", Self::Mercury),
        ("acusolve", Self::Acusolve),
        ("fluent", Self::Fluent),
        ("csv", Self::Csv),
    ];

    /// Whether its lines have a coefficient of friction.
    pub(super) fn takes_friction(self) -> bool {
        matches!(self, Self::Lammps | Self::Liggghts | Self::Yade | Self::Mercury)
    }

    /// Whether the code reads a table e(v).
    pub(super) fn takes_table(self) -> bool {
        matches!(self, Self::Acusolve | Self::Csv)
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
