//! What a scenario is about, told by its tables: one impact, unless a table says otherwise.

use super::file::{ScenarioFile, SolverTable};
use super::{Scenario, ScenarioError};

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
    /// `[indentation]`: loads and indentations without any impact.
    Indentation,
}

/// Why forces have no use.
const NO_MOTION: &str = "there is no motion that it could act on";

impl Kind {
    /// The kinds that have a table of their own, with its name.
    const TABLES: &[(&'static str, Self)] = &[
        ("sweep", Self::Sweep),
        ("monte_carlo", Self::MonteCarlo),
        ("repeat", Self::Repeat),
        ("compare", Self::Compare),
        ("indentation", Self::Indentation),
    ];

    fn is_given(self, file: &ScenarioFile) -> bool {
        match self {
            Self::Impact => file.impact.is_some(),
            Self::Sweep => file.sweep.is_some(),
            Self::MonteCarlo => file.monte_carlo.is_some(),
            Self::Repeat => file.repeat.is_some(),
            Self::Compare => file.compare.is_some(),
            Self::Indentation => file.indentation.is_some(),
        }
    }

    /// A table of the file that this kind has no use for, if there is one, and why.
    fn idle_table(self, file: &ScenarioFile) -> Option<(&'static str, &'static str)> {
        match self {
            Self::Indentation if file.impact.is_some() => Some(("impact", "an indentation is slow")),
            Self::Indentation | Self::Compare if file.gravity.is_some() => Some(("gravity", NO_MOTION)),
            Self::Indentation | Self::Compare if file.damping.is_some() => Some(("damping", NO_MOTION)),
            Self::Indentation if file.solver != SolverTable::default() => {
                Some(("solver", "an indentation is computed in closed form"))
            }
            _ => None,
        }
    }
}

impl Scenario {
    /// What kind of scene the file is.
    ///
    /// # Errors
    /// [`ScenarioError::Refused`] for tables of two kinds.
    pub fn kind(&self) -> Result<Kind, ScenarioError> {
        let mut given = Kind::TABLES.iter().filter(|(_, kind)| kind.is_given(&self.file));
        match (given.next(), given.next()) {
            (None, _) => Ok(Kind::Impact),
            (Some((table, kind)), None) => match kind.idle_table(&self.file) {
                None => Ok(*kind),
                Some((idle, reason)) => {
                    let message = format!("[{table}] is given too, and {reason}; write only one of the two");
                    Err(self.document.refuse(idle, message))
                }
            },
            (Some((first, _)), Some((second, _))) => {
                let message = format!("[{first}] is given too; write only one of the two");
                Err(self.document.refuse(second, message))
            }
        }
    }
}
