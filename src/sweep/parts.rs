//! How a table is divided into parts, and the file that says which table the parts of a folder are of.

use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::SweepError;
use super::form::Format;
use crate::output::create;
use crate::plan::{Plan, Source};
use crate::provenance::{FORMAT, NUMBERS, VERSION, hex};

/// A table of up to so many parts is written as one file: about a second's work.
pub const ONE_FILE: u64 = 16;
/// CSV is joined to one file up to so many rows.
pub const JOINED: u64 = 10_000_000;
/// The folder of the parts, beside the summary.
pub const PARTS: &str = "parts";
/// The file that says which table it is.
pub const IDENTITY: &str = "_table.json";

/// The most rows of a part.
const LONGEST: u64 = 1 << 18;
/// More parts than this make a slow folder.
const MOST_PARTS: u64 = 1 << 16;

/// How many rows a part has: those of about 65 ms on one core. It follows from the number of rows and from the method alone,
/// so that the parts of all runs fit together.
pub fn rows_per_part(plan: &Plan) -> u64 {
    let at_most = (65_536.0 / plan.microseconds()).max(1.0);
    // a power of two
    let mut rows = LONGEST;
    #[allow(clippy::cast_precision_loss)] // a small number
    while rows > 16 && rows as f64 > at_most {
        rows /= 2;
    }
    rows.max(plan.count().div_ceil(MOST_PARTS).next_multiple_of(16))
}

/// The parts of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Rows of the table.
    pub rows: u64,
    /// Rows of a part; the last part may have fewer.
    pub rows_per_part: u64,
}

impl Layout {
    /// How many parts there are.
    pub fn parts(&self) -> u64 {
        self.rows.div_ceil(self.rows_per_part)
    }

    /// The cases of a part.
    pub fn cases(&self, part: u64) -> Range<u64> {
        let first = part * self.rows_per_part;
        first..self.rows.min(first.saturating_add(self.rows_per_part))
    }
}

/// The file of a part in its folder. Its number has so many digits that the names are in the order of the parts.
pub fn name(part: u64, format: Format) -> String {
    format!("part-{part:05}.{}", format.name())
}

/// Whether a folder has parts.
pub fn are_in(folder: &Path) -> io::Result<bool> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
        entries => entries?,
    };
    for entry in entries {
        if entry?.file_name().as_encoded_bytes().starts_with(b"part-") {
            return Ok(true);
        }
    }
    Ok(false)
}

/// How this machine computes powers: a hash of many of them. The C library computes powers in one way on processors
/// with fused multiply-add and in another way on others, and some of the powers differ in their last digit.
fn powers_of_machine() -> String {
    let mut hasher = Sha256::new();
    for k in 0..4096 {
        let x = 0.5 + f64::from(k) / 4096.0;
        // the exponents of the first steps of dop853 and dopri5
        for exponent in [0.125, 0.2] {
            #[allow(clippy::disallowed_methods)] // has to be the power of the machine, not of the compiler
            let power = std::hint::black_box(x).powf(std::hint::black_box(exponent));
            hasher.update(power.to_bits().to_le_bytes());
        }
    }
    hex(&hasher.finalize()[..8])
}

/// Which table the parts of a folder are of. Two equal ones have the same bytes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Identity {
    format_version: u64,
    version: String,
    numbers: u64,
    format: Format,
    rows: u64,
    rows_per_part: u64,
    /// How the machine computes powers; `None` if the rows do not depend on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    powers_of_machine: Option<String>,
    scenario: Source,
}

impl Identity {
    /// That of the table of this plan, which was read from `scenario`.
    pub fn new(plan: &Plan, scenario: &Source, format: Format, layout: Layout) -> Self {
        Self {
            format_version: FORMAT,
            version: VERSION.to_owned(),
            numbers: NUMBERS,
            format,
            rows: layout.rows,
            rows_per_part: layout.rows_per_part,
            powers_of_machine: plan.depends_on_machine().then(powers_of_machine),
            scenario: scenario.clone(),
        }
    }

    fn bytes(&self) -> Result<Vec<u8>, io::Error> {
        let mut text = serde_json::to_vec_pretty(self)?;
        text.push(b'\n');
        Ok(text)
    }

    /// A hash of it, which the files of the table carry where their format has room for it.
    pub fn hash(&self) -> String {
        hex(&Sha256::digest(self.bytes().unwrap_or_default()))
    }

    /// Reads that of a folder; `None` if there is none.
    ///
    /// # Errors
    /// [`SweepError::Damaged`] for a file that is not one.
    pub fn read(folder: &Path) -> Result<Option<Self>, SweepError> {
        let path = folder.join(IDENTITY);
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            text => text.map_err(SweepError::file("cannot be read", &path))?,
        };
        let damaged = |error| SweepError::Damaged {
            path: path.clone(),
            problem: format!(
                "does not say which table this is ({error}); name another --out, or start over with --force"
            ),
        };
        serde_json::from_slice(&text).map(Some).map_err(damaged)
    }

    /// Writes it into a folder that has none.
    ///
    /// # Errors
    /// [`SweepError::Changed`] if another process has written that of another table in the meantime.
    pub fn create(&self, folder: &Path) -> Result<(), SweepError> {
        let path = folder.join(IDENTITY);
        match self.bytes().and_then(|bytes| create(&path, &bytes)) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => match Self::read(folder)? {
                Some(there) if there != *self => Err(self.refuse(&there, folder)),
                _ => Ok(()),
            },
            result => result.map_err(SweepError::file("cannot be written", &path)),
        }
    }

    /// The error where a folder has parts of another table.
    pub fn refuse(&self, there: &Self, folder: &Path) -> SweepError {
        SweepError::Changed { path: folder.join(PARTS), difference: self.difference(there) }
    }

    /// In what another table differs.
    fn difference(&self, there: &Self) -> String {
        let versions = |of: &Self| format!("version {} (table numbers {})", of.version, of.numbers);
        let (ours, theirs) = (&self.scenario, &there.scenario);
        if (there.format_version, there.numbers, &there.version) != (self.format_version, self.numbers, &self.version) {
            format!("of {}, and this program is {}", versions(there), versions(self))
        } else if there.format != self.format {
            format!("written as {}", there.format.name())
        } else if theirs.overrides != ours.overrides {
            let sets = |of: &Source| match &of.overrides[..] {
                [] => "none".to_owned(),
                all => format!("--set {}", all.join(" --set ")),
            };
            format!("of a run with other overrides: {} in place of {}", sets(theirs), sets(ours))
        } else if theirs.text != ours.text {
            let differs = |(_, (one, two)): &(usize, (&str, &str))| one != two;
            let mut lines = (1..).zip(theirs.text.lines().zip(ours.text.lines()));
            match lines.find(differs) {
                Some((line, (theirs, ours))) => {
                    format!("of another scenario: line {line} is `{theirs}` in place of `{ours}`")
                }
                None => "of another scenario, which is longer or shorter".to_owned(),
            }
        } else if theirs != ours {
            "of the same scenario with another table of coefficients or of flow stress".to_owned()
        } else if there.powers_of_machine != self.powers_of_machine {
            "of a machine that computes powers with other last digits, on which dopri5 and dop853 depend".to_owned()
        } else {
            format!("of {} rows in parts of {}", there.rows, there.rows_per_part)
        }
    }
}

/// The folder of the parts of a table in `folder`.
pub fn folder_in(folder: &Path) -> PathBuf {
    folder.join(PARTS)
}
