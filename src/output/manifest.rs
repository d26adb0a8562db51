//! The list of the files that the program wrote into a folder. It lies in that folder. By it the program knows its own
//! files, and their origin.

use std::fs::File;
use std::io::{self, Read, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::new_file;
use crate::provenance::{first_format, hex};

/// Its name in the folder.
pub const MANIFEST: &str = ".plm-impact.json";

/// So many bytes of both ends of a file go into its checksum. Only tables are longer than both.
const END: u64 = 64 << 10;

/// A file as it was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Record {
    pub name: String,
    /// Its length in bytes.
    pub length: u64,
    /// SHA-256 of its first and its last 64 KiB, or of all of it if there are no more.
    pub sha256: String,
    /// A table is never removed, only replaced by one of the same name.
    pub is_table: bool,
}

impl Record {
    /// The record of the file at `path`, which is or will be called `name`.
    pub fn of(path: &Path, name: &str, is_table: bool) -> io::Result<Self> {
        let mut file = File::open(path)?;
        let length = file.metadata()?.len();
        let mut bytes = Vec::new();
        file.by_ref().take(END).read_to_end(&mut bytes)?;
        file.seek(SeekFrom::Start(length.saturating_sub(END).max(bytes.len() as u64)))?;
        file.take(END).read_to_end(&mut bytes)?;
        let sha256 = hex(&Sha256::digest(&bytes));
        Ok(Self { name: name.to_owned(), length, sha256, is_table })
    }

    /// Whether the file in this folder is the one that was written.
    pub fn is_in(&self, folder: &Path) -> bool {
        let path = folder.join(&self.name);
        let is_file = path.symlink_metadata().is_ok_and(|data| data.is_file() && data.len() == self.length);
        is_file && Self::of(&path, &self.name, self.is_table).is_ok_and(|there| there == *self)
    }
}

/// The origin and the files of a folder of results.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Manifest {
    /// Version of the form of the outputs.
    #[serde(default = "first_format")]
    pub format_version: u64,
    /// Program and version.
    pub written_by: String,
    /// The scenario file or the shards, as seen from the folder; or the command.
    pub made_from: String,
    /// Hash of the scenario, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scenario_sha256: Option<String>,
    /// The files. While a file is being replaced, both the old and the new are listed: after a kill either may be there.
    pub files: Vec<Record>,
}

impl Manifest {
    /// The list in a folder; `None` where there is none.
    pub fn read(folder: &Path) -> io::Result<Option<Self>> {
        let path = folder.join(MANIFEST);
        match std::fs::read(&path) {
            Ok(text) => {
                let damaged = |error| {
                    let problem = format!("its list {MANIFEST} is damaged ({error}); delete that list");
                    io::Error::new(io::ErrorKind::InvalidData, problem)
                };
                serde_json::from_slice(&text).map(Some).map_err(damaged)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }

    pub fn write(&self, folder: &Path) -> io::Result<()> {
        let mut text = serde_json::to_vec_pretty(self)?;
        text.push(b'\n');
        new_file::replace(&folder.join(MANIFEST), &text)
    }

    /// Whether the file of this name in the folder is one that the program wrote.
    pub fn knows(&self, folder: &Path, name: &str) -> bool {
        self.files.iter().any(|record| record.name == name && record.is_in(folder))
    }

    /// Whether the program and the scenario are the same, and so all numbers.
    pub fn is_like(&self, other: &Self) -> bool {
        self.written_by == other.written_by && self.is_same_scenario(other)
    }

    /// Whether the scenario has the same text and overrides, or both come from one command that has no scenario.
    fn is_same_scenario(&self, other: &Self) -> bool {
        match (&self.scenario_sha256, &other.scenario_sha256) {
            (None, None) => self.made_from == other.made_from,
            (one, two) => one == two,
        }
    }

    /// Whether both are of one scenario, which may have been edited or moved.
    pub fn belongs_with(&self, other: &Self) -> bool {
        self.made_from == other.made_from || self.is_same_scenario(other)
    }
}

/// The path of a file as seen from a folder. It stays the same when a project is moved as a whole.
pub(super) fn relative(path: &Path, folder: &Path) -> String {
    let (Ok(path), Ok(folder)) = (path.canonicalize(), folder.canonicalize()) else {
        return path.display().to_string();
    };
    let shared = path.components().zip(folder.components()).take_while(|(one, two)| one == two).count();
    let up = folder.components().skip(shared).map(|_| "..");
    let relative: PathBuf =
        up.map(Path::new).chain(path.components().skip(shared).map(|part| Path::new(part.as_os_str()))).collect();
    relative.display().to_string()
}
