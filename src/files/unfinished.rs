//! The files in progress and the folders that were made for them. A process that abandons its work removes them.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

#[derive(Debug)]
struct Unfinished {
    files: BTreeSet<PathBuf>,
    /// The deepest first.
    folders: Vec<PathBuf>,
    is_abandoned: bool,
}

static UNFINISHED: Mutex<Unfinished> =
    Mutex::new(Unfinished { files: BTreeSet::new(), folders: Vec::new(), is_abandoned: false });

fn lock_unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Creates a new file and notes it as unfinished.
pub(super) fn begin(path: &Path) -> io::Result<File> {
    let mut unfinished = lock_unfinished();
    if unfinished.is_abandoned {
        return Err(io::ErrorKind::Interrupted.into());
    }
    let file = OpenOptions::new().write(true).create_new(true).open(path)?;
    unfinished.files.insert(path.to_owned());
    Ok(file)
}

/// Notes that the file is renamed to its final path, or removed.
pub(super) fn end(path: &Path) {
    lock_unfinished().files.remove(path);
}

/// Notes folders that were made for the files; the deepest is first.
pub(super) fn add_folders(folders: &[PathBuf]) {
    lock_unfinished().folders.extend_from_slice(folders);
}

/// Removes the unfinished files of a process that is about to end, and the folders that are empty then. No other file is begun
/// from now on.
pub fn abandon() {
    let mut unfinished = lock_unfinished();
    unfinished.is_abandoned = true;
    for file in std::mem::take(&mut unfinished.files) {
        drop(fs::remove_file(file));
    }
    for folder in std::mem::take(&mut unfinished.folders) {
        drop(fs::remove_dir(folder));
    }
}
