//! The kind of a scenario, which follows from its tables: one impact, unless there is the table of another kind.

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
    /// `[calibrate]`: keys that are found from measurements.
    Calibrate,
    /// `[indentation]`: loads and indentations without any impact.
    Indentation,
}

/// Why forces have no effect.
const NO_MOTION: &str = "there is no motion that it could act on";
/// Why a density has no effect.
const NO_MASS: &str = "nothing moves here, so a mass has no effect; leave the key out";
/// Why the thickness has no effect.
const NO_STIFFNESS: &str = "a large plate gives way only to what moves; leave the key out";
/// Why the sphere's strength has no effect.
const NO_SPHERE: &str =
    "a comparison has one peak for all laws and does not ask whether the sphere yields; leave the key out";

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

    /// The tables that have no effect on this kind, and why.
    fn idle_tables(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Indentation => &[
                ("impact", "an indentation is slow"),
                ("gravity", NO_MOTION),
                ("damping", NO_MOTION),
                ("solver", "an indentation is computed in closed form"),
            ],
            Self::Compare => &[
                ("solver", "unloading is computed in closed form"),
                ("output", "a comparison has no trace"),
                ("gravity", NO_MOTION),
                ("damping", NO_MOTION),
            ],
            _ => &[],
        }
    }
}

impl Scenario {
    /// What kind of scene the file is.
    ///
    /// # Errors
    /// [`ScenarioError::Refused`] for tables of two kinds.
    pub fn kind(&self) -> Result<Kind, ScenarioError> {
        let mut given = Kind::ALL[1..].iter().filter(|(table, _)| self.has(table));
        match (given.next(), given.next()) {
            (None, _) => Ok(Kind::Impact),
            (Some((table, kind)), None) => match kind.idle_tables().iter().find(|(idle, _)| self.has(idle)) {
                None => Ok(*kind),
                Some((idle, reason)) => {
                    let message = format!("[{table}] is given too, and {reason}; write only one of the two");
                    Err(self.document.refuse(idle, message))
                }
            },
            (Some((first, _)), Some((second, _))) => Err(self.document.one_table(first, second)),
        }
    }

    /// Warnings about keys of the bodies without effect. They are allowed, as the file may also be run as another kind.
    pub(super) fn idle_keys(&self, kind: Kind) -> Vec<Warning> {
        if !matches!(kind, Kind::Indentation | Kind::Compare) {
            return Vec::new();
        }
        let keys = [
            ("sphere.density", true, NO_MASS),
            ("sphere.mass", true, NO_MASS),
            ("sphere.yield_strength", kind == Kind::Compare, NO_SPHERE),
            ("half_space.density", true, NO_MASS),
            ("half_space.thickness", true, NO_STIFFNESS),
        ];
        let idle = keys.into_iter().filter(|(key, is_idle, _)| *is_idle && self.has(key));
        idle.map(|(key, _, reason)| Warning::UnusedKey { key, reason }).collect()
    }
}
