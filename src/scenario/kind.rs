//! The kind of a scenario, which follows from its tables: one impact, unless the scenario has the table of another kind.

use super::Scenario;
use crate::error::Error;
use crate::strings::named_enum;

named_enum! {
    /// The kinds of scenarios. Every kind except the first has a table of its name.
    pub enum Kind {
        /// One impact: none of the tables below.
        Impact = "impact",
        /// A table of impacts on axes.
        Sweep = "sweep",
        /// A table of random impacts.
        MonteCarlo = "monte_carlo",
        /// A series of impacts.
        Repeat = "repeat",
        /// Loads and indentations without impact.
        Indentation = "indentation",
        /// Keys that are fitted to measurements.
        Calibrate = "calibrate",
    }
}

/// Templates of scenarios, by name: one of each kind, and then common tasks. A comment explains every key, and a test compares the
/// comments with the list of keys.
pub const TEMPLATES: [(&str, &str); 13] = [
    ("impact", include_str!("template/impact.toml")),
    ("sweep", include_str!("template/sweep.toml")),
    ("monte_carlo", include_str!("template/monte_carlo.toml")),
    ("repeat", include_str!("template/repeat.toml")),
    ("indentation", include_str!("template/indentation.toml")),
    ("calibrate", include_str!("template/calibrate.toml")),
    ("drop", include_str!("template/drop.toml")),
    ("plate", include_str!("template/plate.toml")),
    ("peening", include_str!("template/peening.toml")),
    ("leeb", include_str!("template/leeb.toml")),
    ("scleroscope", include_str!("template/scleroscope.toml")),
    ("brinell", include_str!("template/brinell.toml")),
    ("oblique", include_str!("template/oblique.toml")),
];

impl Kind {
    /// The name of a scenario of this kind in messages.
    pub fn description(self) -> &'static str {
        match self {
            Self::Impact => "a single impact",
            Self::Sweep | Self::MonteCarlo => "a table",
            Self::Repeat => "a series of impacts",
            Self::Indentation => "an indentation",
            Self::Calibrate => "a calibration",
        }
    }

    /// True if the result is a table, which is computed row by row.
    pub fn is_table(self) -> bool {
        matches!(self, Self::Sweep | Self::MonteCarlo)
    }
}

impl Scenario {
    /// The kind follows from the tables.
    pub fn kind(&self) -> Result<Kind, Error> {
        let mut given = Kind::ALL[1..].iter().filter(|kind| self.is_given(kind.name()));
        match (given.next(), given.next()) {
            (kind, None) => Ok(kind.copied().unwrap_or(Kind::Impact)),
            (first, Some(second)) => {
                let first = first.map_or("", |kind| kind.name());
                Err(self
                    .document
                    .refusal(second.name(), format!("cannot be combined with [{first}]. Remove one of the two.")))
            }
        }
    }
}
