//! The kind of a scenario, which follows from its tables: one impact, unless there is the table of another kind.

use super::Scenario;
use crate::error::Error;

/// The kinds of scene, each with its own way to be run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// One impact: none of the tables below.
    Impact,
    /// `[sweep]`: a table of impacts on axes.
    Sweep,
    /// `[monte_carlo]`: a table of random impacts.
    MonteCarlo,
    /// `[repeat]`: impacts one after the other.
    Repeat,
    /// `[compare]`: unloading laws from one peak.
    Compare,
    /// `[calibrate]`: keys that are found from measurements.
    Calibrate,
    /// `[indentation]`: loads and indentations without any impact.
    Indentation,
}

impl Kind {
    /// All kinds with their names; every one but the first has a table of that name.
    pub const ALL: [(&'static str, Self); 7] = [
        ("impact", Self::Impact),
        ("sweep", Self::Sweep),
        ("monte_carlo", Self::MonteCarlo),
        ("repeat", Self::Repeat),
        ("compare", Self::Compare),
        ("indentation", Self::Indentation),
        ("calibrate", Self::Calibrate),
    ];
}

/// A scenario of this kind, with a comment for every key: a test compares them with those of the keys.
pub fn template(kind: Kind) -> &'static str {
    match kind {
        Kind::Impact => include_str!("template/impact.toml"),
        Kind::Sweep => include_str!("template/sweep.toml"),
        Kind::MonteCarlo => include_str!("template/monte_carlo.toml"),
        Kind::Repeat => include_str!("template/repeat.toml"),
        Kind::Compare => include_str!("template/compare.toml"),
        Kind::Indentation => include_str!("template/indentation.toml"),
        Kind::Calibrate => include_str!("template/calibrate.toml"),
    }
}

impl Scenario {
    /// What kind of scene the file is.
    ///
    /// # Errors
    /// [`Error`] for tables of two kinds.
    pub fn kind(&self) -> Result<Kind, Error> {
        let mut given = Kind::ALL[1..].iter().filter(|(table, _)| self.has(table));
        match (given.next(), given.next()) {
            (None, _) => Ok(Kind::Impact),
            (Some((_, kind)), None) => Ok(*kind),
            (Some((first, _)), Some((second, _))) => {
                Err(self.document.refuse(second, format!("[{first}] is given too; write only one of the two")))
            }
        }
    }
}
