//! The kind of a scenario, which follows from its tables: one impact, unless there is the table of another kind.

use super::Scenario;
use crate::error::Error;
use crate::units::names::named;

named! {
    /// The kinds of scene, each with its own way to be run. Every kind but the first has a table of its name.
    pub enum Kind {
        /// One impact: none of the tables below.
        Impact = "impact",
        /// A table of impacts on axes.
        Sweep = "sweep",
        /// A table of random impacts.
        MonteCarlo = "monte_carlo",
        /// Impacts one after the other.
        Repeat = "repeat",
        /// Loads and indentations without any impact.
        Indentation = "indentation",
        /// Keys that are found from measurements.
        Calibrate = "calibrate",
    }
}

/// A scenario of this kind, with a comment for every key: a test compares them with those of the keys.
pub fn template(kind: Kind) -> &'static str {
    match kind {
        Kind::Impact => include_str!("template/impact.toml"),
        Kind::Sweep => include_str!("template/sweep.toml"),
        Kind::MonteCarlo => include_str!("template/monte_carlo.toml"),
        Kind::Repeat => include_str!("template/repeat.toml"),
        Kind::Indentation => include_str!("template/indentation.toml"),
        Kind::Calibrate => include_str!("template/calibrate.toml"),
    }
}

impl Kind {
    /// Names a scenario of this kind in messages.
    pub fn what(self) -> &'static str {
        match self {
            Self::Impact => "one impact",
            Self::Sweep | Self::MonteCarlo => "a table",
            Self::Repeat => "impacts one after the other",
            Self::Indentation => "an indentation",
            Self::Calibrate => "a calibration",
        }
    }

    /// Whether it is a table, which is made row after row.
    pub fn is_table(self) -> bool {
        matches!(self, Self::Sweep | Self::MonteCarlo)
    }
}

impl Scenario {
    /// The kind follows from the tables.
    ///
    /// # Errors
    /// [`Error`] for tables of two kinds.
    pub fn kind(&self) -> Result<Kind, Error> {
        let mut given = Kind::ALL[1..].iter().filter(|kind| self.has(kind.name()));
        match (given.next(), given.next()) {
            (kind, None) => Ok(kind.copied().unwrap_or(Kind::Impact)),
            (first, Some(second)) => {
                let first = first.map_or("", |kind| kind.name());
                Err(self.document.refuse(second.name(), format!("[{first}] is given too; write only one of the two")))
            }
        }
    }
}
