//! The parts of a table in an output directory, which other results must not overwrite.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::{fs, io};

use super::{OutputDirectory, remove, remove_folder};
use crate::error::{Error, ErrorKind};

/// The folder of the parts, beside the summary.
pub const PARTS_FOLDER: &str = "parts";
/// The file that identifies the table.
pub const IDENTITY_FILE: &str = "_table.json";

/// Makes an error from that of the file system, for `map_err`. The parts written so far stay.
pub(crate) fn file_error(problem: &'static str, path: &Path) -> impl Fn(io::Error) -> Error {
    Error::from_io(ErrorKind::Failed, path, problem, "")
}

/// The names in a folder; none if there is no such folder.
fn names_in(folder: &Path) -> Result<Vec<OsString>, Error> {
    let names = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.and_then(|entries| entries.map(|entry| entry.map(|entry| entry.file_name())).collect()),
    };
    names.map_err(file_error("cannot be read", folder))
}

fn is_part(name: impl AsRef<OsStr>) -> bool {
    name.as_ref().as_encoded_bytes().starts_with(b"part-")
}

impl OutputDirectory {
    /// True if there are parts of a table.
    pub fn has_parts(&self) -> Result<bool, Error> {
        Ok(names_in(&self.path().join(PARTS_FOLDER))?.iter().any(is_part))
    }

    /// Clears the folder for other results if a table was begun in parts there: an error, or the parts are removed by force.
    pub fn clear_parts(&self) -> Result<(), Error> {
        let (folder, identity) = (self.path().join(PARTS_FOLDER), self.path().join(IDENTITY_FILE));
        let names = names_in(&folder)?;
        if !self.is_forced() && names.iter().any(is_part) {
            return Err(Error::for_path(
                &folder,
                "contains parts of a table. Choose another --out, or use --force to delete them.",
            ));
        }
        if identity.exists() || !names.is_empty() {
            self.remove_parts()?;
        }
        remove(&identity).map_err(file_error("cannot be removed", &identity))
    }

    /// Removes the parts of a table, and their folder. Files of others in that folder stay, and then the folder stays too.
    pub fn remove_parts(&self) -> Result<(), Error> {
        let folder = self.path().join(PARTS_FOLDER);
        self.check_removable(&folder)?;
        let names = names_in(&folder)?;
        let is_own = |name: &&OsString| is_part(name) || name.as_encoded_bytes().starts_with(b".part-");
        if names.iter().all(|name| is_own(&name)) {
            return remove_folder(&folder).map_err(file_error("cannot be removed", &folder));
        }
        let mut parts = names.iter().filter(is_own).map(|name| folder.join(name));
        parts.try_for_each(|part| remove(&part).map_err(file_error("cannot be removed", &part)))
    }
}
