//! What a scenario is about, told by its tables: one impact, unless a table says otherwise.

use super::file::ScenarioFile;
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
}

impl Kind {
    /// The kinds that have a table of their own, with its name.
    const TABLES: &[(&'static str, Self)] = &[("sweep", Self::Sweep), ("monte_carlo", Self::MonteCarlo)];

    fn is_given(self, file: &ScenarioFile) -> bool {
        match self {
            Self::Impact => file.impact.is_some(),
            Self::Sweep => file.sweep.is_some(),
            Self::MonteCarlo => file.monte_carlo.is_some(),
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
            (Some((_, kind)), None) => Ok(*kind),
            (Some((first, _)), Some((second, _))) => {
                let message = format!("[{first}] is given too; write only one of the two");
                Err(self.document.refuse(second, message))
            }
        }
    }
}
