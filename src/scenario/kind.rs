//! What a scenario is about, told by its tables: one impact, unless a table says otherwise.

use super::file::{OutputTable, ScenarioFile, SolverTable};
use super::{Scenario, ScenarioError};
use crate::impact::Warning;

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
/// Why a density has no use.
const NO_MASS: &str = "nothing moves here, so that no mass counts; leave the key out";
/// Why the sphere's strength has no use.
const NO_SPHERE: &str =
    "a comparison has one peak for all laws and does not ask whether the sphere yields; leave the key out";

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
        let has_solver = file.solver != SolverTable::default();
        match self {
            Self::Indentation if file.impact.is_some() => Some(("impact", "an indentation is slow")),
            Self::Indentation if has_solver => Some(("solver", "an indentation is computed in closed form")),
            Self::Compare if has_solver => Some(("solver", "unloading is computed in closed form")),
            Self::Compare if file.output != OutputTable::default() => Some(("output", "a comparison has no trace")),
            Self::Indentation | Self::Compare if file.gravity.is_some() => Some(("gravity", NO_MOTION)),
            Self::Indentation | Self::Compare if file.damping.is_some() => Some(("damping", NO_MOTION)),
            _ => None,
        }
    }

    /// Keys of the bodies that this kind has no use for: they may stand in a file that is also run as another kind.
    pub(super) fn idle_keys(self, file: &ScenarioFile) -> Vec<Warning> {
        if !matches!(self, Self::Indentation | Self::Compare) {
            return Vec::new();
        }
        let strength = self == Self::Compare && file.sphere.yield_strength.is_some();
        let density = file.half_space.as_ref().is_some_and(|table| table.density.is_some());
        let keys = [
            ("sphere.density", file.sphere.density.is_some(), NO_MASS),
            ("sphere.yield_strength", strength, NO_SPHERE),
            ("half_space.density", density, NO_MASS),
        ];
        let idle = keys.into_iter().filter(|(_, is_given, _)| *is_given);
        idle.map(|(key, _, reason)| Warning::UnusedKey { key, reason }).collect()
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
