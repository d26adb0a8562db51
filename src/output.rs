//! How the program writes files. Every file goes through these steps:
//!
//! 1. It is locked, so that one process at a time writes it ([`Lock`]).
//! 2. It is made under a random name beside its place; no link is followed ([`NewFile`]).
//! 3. It is written and synchronised to the disk, so that all errors come before anything is replaced.
//! 4. It is entered into the folder's list of files of this program ([`MANIFEST`]), which may be replaced later.
//! 5. It is renamed, and the folder is synchronised to the disk. The sidecar or summary, which shows that a table is
//!    complete,
//!    comes last.
//!
//! Whenever the process is killed, each place holds either its old file or its new one, complete.

mod lock;
mod manifest;
mod new_file;

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::error::{Error, ErrorKind};
use crate::provenance::{FORMAT, PROGRAM};
pub use lock::{Lock, LockError};
pub use manifest::MANIFEST;
use manifest::{Manifest, Record, relative};
pub use new_file::{NewFile, PART, folder, refuse_special, remove, remove_stale, replace, sync_folder, with_suffix};

/// The name of the summary of any run.
pub const SUMMARY: &str = "summary.json";

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Why nothing was written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The file system refuses.
    #[error("{}: cannot be written: {reason}; name another directory with --out", .path.display())]
    Unwritable { path: PathBuf, reason: io::Error },
    /// Another process is writing it.
    #[error("{}: {holder} is writing it; wait for its end, or name another --out", .path.display())]
    Busy {
        path: PathBuf,
        /// The other process, and since when it writes.
        holder: String,
    },
    /// A file that another program wrote or changed.
    #[error(
        "{}: exists, but not as this program wrote it; move it, name another --out, or replace it with --force",
        .path.display()
    )]
    Foreign { path: PathBuf },
    /// The directory holds other results.
    #[error(
        "{}: holds results of {other}, and these are of {own}; name another --out, or replace them with --force",
        .path.display()
    )]
    Taken {
        path: PathBuf,
        /// Scenario, shards or command of the results that are there; a path as seen from the directory.
        other: String,
        /// Scenario, shards or command of the results to write.
        own: String,
    },
}

impl From<OutputError> for Error {
    fn from(error: OutputError) -> Self {
        use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
        let is_full = |reason: &io::Error| matches!(reason.kind(), FileTooLarge | QuotaExceeded | StorageFull);
        let (OutputError::Unwritable { path, .. }
        | OutputError::Busy { path, .. }
        | OutputError::Foreign { path }
        | OutputError::Taken { path, .. }) = &error;
        let is_failure = matches!(&error, OutputError::Unwritable { reason, .. } if is_full(reason));
        Self::of(if is_failure { ErrorKind::Failed } else { ErrorKind::Input }, &error).about(path.display())
    }
}

impl OutputError {
    /// Makes the error from that of the file system, for `map_err`.
    pub fn at(path: &Path) -> impl Fn(io::Error) -> Self {
        move |reason| Self::Unwritable { path: path.to_owned(), reason }
    }
}

/// The origin of results.
#[derive(Debug, Clone, Copy)]
pub enum Origin<'a> {
    /// A scenario or shards: where they are, and the hash of the scenario.
    File(&'a Path, &'a str),
    /// A command that needs none.
    Command(&'static str),
}

/// A directory that was found writable. Unless something is written, those of its parents that had to be made are removed.
#[derive(Debug)]
pub struct OutputDirectory {
    path: PathBuf,
    /// Made for this run, the deepest first.
    made: Vec<PathBuf>,
    /// The origin of its results; `None` for a shared directory, into which several processes write.
    own: Option<Manifest>,
    is_forced: bool,
    is_of_earlier_version: bool,
}

impl OutputDirectory {
    /// Makes the directory and tests that it takes files, before anything is computed. All its results are of one
    /// origin. With `is_forced`, results of another origin and files that the program did not write are replaced.
    ///
    /// # Errors
    /// [`OutputError::Unwritable`] if it cannot be made, is a file, or takes no files; [`OutputError::Taken`].
    pub fn prepare(path: &Path, origin: Origin, is_forced: bool) -> Result<Self, OutputError> {
        let mut directory = Self::shared(path)?;
        directory.claim(origin, is_forced)?;
        Ok(directory)
    }

    /// Sets the origin of the results to write.
    ///
    /// # Errors
    /// [`OutputError::Taken`] where there are those of something else, unless `is_forced`.
    pub fn claim(&mut self, origin: Origin, is_forced: bool) -> Result<(), OutputError> {
        let (made_from, scenario_sha256) = match origin {
            Origin::File(file, hash) => (relative(file, &self.path), Some(hash.to_owned())),
            Origin::Command(name) => (name.to_owned(), None),
        };
        let written_by = PROGRAM.to_owned();
        let own = Manifest { format_version: FORMAT, written_by, made_from, scenario_sha256, files: Vec::new() };
        match self.manifest()? {
            Some(there) => {
                let is_empty = !there.files.iter().any(|record| self.path.join(&record.name).exists());
                if !is_forced && !is_empty && !there.belongs_with(&own) {
                    let (other, own) = (there.made_from, own.made_from);
                    return Err(OutputError::Taken { path: self.path.clone(), other, own });
                }
            }
            None => self.is_of_earlier_version = has_marks(&self.path),
        }
        self.is_forced = is_forced;
        self.own = Some(own);
        Ok(())
    }

    /// Prepares a shared directory, into which several processes write. Each file is checked by itself.
    pub fn shared(path: &Path) -> Result<Self, OutputError> {
        let refuse = OutputError::at(path);
        let is_missing = |parent: &&Path| !parent.as_os_str().is_empty() && parent.symlink_metadata().is_err();
        let made: Vec<PathBuf> = path.ancestors().take_while(is_missing).map(Path::to_owned).collect();
        let directory = Self { path: path.to_owned(), made, own: None, is_forced: false, is_of_earlier_version: false };
        fs::create_dir_all(path).map_err(&refuse)?;
        directory.made.iter().try_for_each(|made| sync_folder(folder(made))).map_err(&refuse)?;
        drop(NewFile::create(&path.join("trial")).map_err(&refuse)?);
        Ok(directory)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether it holds results of an earlier version, which kept no list of them. Those with the names and kinds of new
    /// files are replaced.
    pub fn is_of_earlier_version(&self) -> bool {
        self.is_of_earlier_version
    }

    /// Locks a file of the directory for a run.
    pub fn lock(&self, name: &Path) -> Result<Lock, OutputError> {
        let path = self.path.join(name);
        Lock::take(&path).map_err(|error| refuse_lock(&path, error))
    }

    /// Whether the file is unchanged since the same version of the program wrote it for the same scenario.
    pub fn has_own(&self, name: &str) -> bool {
        let there = self.manifest().ok().flatten();
        self.own.as_ref().zip(there).is_some_and(|(own, there)| there.is_like(own) && there.knows(&self.path, name))
    }

    /// Whether files of these names may be written.
    ///
    /// # Errors
    /// [`OutputError::Foreign`]; [`OutputError::Unwritable`] for what is no file.
    pub fn check<'n>(&self, names: impl IntoIterator<Item = &'n str>) -> Result<(), OutputError> {
        let there = self.manifest()?;
        names.into_iter().try_for_each(|name| self.may_replace(there.as_ref(), name, None))
    }

    /// Writes all files, then puts them in place.
    ///
    /// # Errors
    /// [`OutputError`] naming the file; then no file was replaced unless a rename itself failed halfway.
    pub fn write(&self, files: &[OutputFile]) -> Result<(), OutputError> {
        let _lock = self.lock_list()?;
        let mut new = Vec::new();
        for file in files {
            let place = self.path.join(&file.name);
            let refuse = OutputError::at(&place);
            let begun = remove_stale(&place).and_then(|()| NewFile::create(&place));
            let mut begun = begun.map_err(&refuse)?;
            begun.write_all(&file.bytes).and_then(|()| begun.sync()).map_err(&refuse)?;
            new.push(begun);
        }
        self.put_all(new, false)
    }

    /// Puts the files of a complete table in place. Removes the summary and the pictures of another table first.
    ///
    /// # Errors
    /// [`OutputError`]; then it is not in place.
    pub fn put_table(&self, files: Vec<NewFile>) -> Result<(), OutputError> {
        files.iter().try_for_each(|file| file.sync().map_err(OutputError::at(file.temporary())))?;
        let _lock = self.own.is_some().then(|| self.lock_list()).transpose()?;
        self.put_all(files, true)
    }

    fn put_all(&self, mut files: Vec<NewFile>, is_table: bool) -> Result<(), OutputError> {
        self.enter(&files, is_table)?;
        for file in &mut files {
            let place = file.place().to_owned();
            file.rename().map_err(OutputError::at(&place))?;
        }
        let folders: BTreeSet<&Path> = files.iter().map(|file| folder(file.place())).collect();
        folders.into_iter().try_for_each(|folder| sync_folder(folder).map_err(OutputError::at(folder)))
    }

    /// Enters files into the list of the directory, before they take the place of others.
    fn enter(&self, files: &[NewFile], is_table: bool) -> Result<(), OutputError> {
        let Some(own) = &self.own else { return Ok(()) };
        let there = self.manifest()?;
        let refuse = OutputError::at(&self.path);
        let mut records = Vec::new();
        for file in files {
            let name = file.place().strip_prefix(&self.path).unwrap_or(file.place()).to_string_lossy();
            self.may_replace(there.as_ref(), &name, Some(file.temporary()))?;
            records.push(Record::of(file.temporary(), &name, is_table).map_err(OutputError::at(file.place()))?);
        }
        let is_new = |old: &Record| records.iter().any(|new| new.name == old.name);
        let mut list = Manifest { files: Vec::new(), ..own.clone() };
        if let Some(there) = there {
            let is_like = there.is_like(own);
            for old in there.files {
                let is_there = old.is_in(&self.path);
                if is_there && !is_like && !is_new(&old) && !old.is_table {
                    remove(&self.path.join(&old.name)).map_err(&refuse)?;
                } else if is_there && !records.contains(&old) {
                    list.files.push(old);
                }
            }
        }
        list.files.extend(records);
        list.write(&self.path).map_err(&refuse)
    }

    fn may_replace(&self, there: Option<&Manifest>, name: &str, new: Option<&Path>) -> Result<(), OutputError> {
        let place = self.path.join(name);
        refuse_special(&place).map_err(OutputError::at(&place))?;
        let is_allowed = self.is_forced
            || self.own.is_none()
            || !place.exists()
            || there.is_some_and(|there| there.knows(&self.path, name))
            || self.is_of_earlier_version && new.is_none_or(|new| is_alike(&place, new))
            || new.is_some_and(|new| is_same(&place, new));
        if is_allowed { Ok(()) } else { Err(OutputError::Foreign { path: place }) }
    }

    fn manifest(&self) -> Result<Option<Manifest>, OutputError> {
        Manifest::read(&self.path).map_err(OutputError::at(&self.path))
    }

    fn lock_list(&self) -> Result<Lock, OutputError> {
        Lock::wait(&self.path.join(MANIFEST)).map_err(|error| refuse_lock(&self.path, error))
    }
}

impl Drop for OutputDirectory {
    fn drop(&mut self) {
        // only empty ones go
        self.made.iter().for_each(|directory| drop(fs::remove_dir(directory)));
    }
}

/// A temporary directory beside the outputs, which is removed with all its files.
#[derive(Debug)]
pub struct Scratch {
    path: PathBuf,
    _lock: Lock,
}

impl Scratch {
    /// Makes one with this name and a random number; those that killed runs left are removed.
    pub fn new(directory: &OutputDirectory, name: &str) -> Result<Self, OutputError> {
        let lock = directory.lock(Path::new(name))?;
        let place = directory.path.join(name);
        let made = remove_stale(&place).and_then(|()| new_file::temporary(&place));
        let made = made.and_then(|path| fs::create_dir(&path).map(|()| path));
        Ok(Self { path: made.map_err(OutputError::at(&place))?, _lock: lock })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.path));
    }
}

fn refuse_lock(path: &Path, error: LockError) -> OutputError {
    match error {
        LockError::Held(holder) => OutputError::Busy { path: path.to_owned(), holder },
        LockError::File(reason) => OutputError::Unwritable { path: path.to_owned(), reason },
    }
}

/// Whether a directory without a list holds results of this program: its summary or report says so.
fn has_marks(directory: &Path) -> bool {
    let has = |name: &str, mark: &str| fs::read_to_string(directory.join(name)).is_ok_and(|text| text.contains(mark));
    has(SUMMARY, "\"command\": \"plm-impact ")
        || has("validation.md", "# Validation\n")
        || has("report.md", "# Speed against error\n")
}

/// Whether two files have the same bytes. Then nothing is lost where one takes the place of the other.
fn is_same(one: &Path, two: &Path) -> bool {
    fs::read(one).ok().zip(fs::read(two).ok()).is_some_and(|(one, two)| one == two)
}

/// Whether two files begin with the same line: the header of a table, the heading of a report, the mark of a picture.
fn is_alike(one: &Path, two: &Path) -> bool {
    let line = |path: &Path| -> io::Result<Vec<u8>> {
        let mut line = Vec::new();
        io::BufRead::read_until(&mut io::BufReader::new(fs::File::open(path)?), b'\n', &mut line)?;
        Ok(line)
    };
    line(one).ok().zip(line(two).ok()).is_some_and(|(one, two)| one == two)
}
