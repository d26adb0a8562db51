//! How the program writes files. Every file goes through these steps:
//!
//! 1. It is made under a random name beside its place; no link is followed ([`NewFile`]).
//! 2. It is written and synchronised to the disk, so that all errors come before anything is replaced.
//! 3. It is renamed, and the folder is synchronised to the disk. The summary, which says of what the results are, comes last.
//!
//! Whenever the process is killed, each place holds either its old file or its new one, complete. Nothing is locked: of two
//! processes that write the same file the last to rename it wins.

mod new_file;

use std::fs::{self, File};
use std::io::{self, Read as _, Write as _};
use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::Value;

use crate::error::{Error, ErrorKind};
pub use new_file::{
    NewFile, create, folder, refuse_special, remove, remove_folder, remove_stale, replace, sync_folder,
};

/// The name of the summary of any run.
pub const SUMMARY: &str = "summary.json";

/// The other results of runs, by names and endings. Those of an older scenario do not stay beside newer ones.
const RESULTS: [(&[&str], &[&str]); 2] = [
    (&["table", "trace", "impacts", "comparison", "residuals", "posterior"], &["csv", "parquet"]),
    (
        &[
            "force_indentation",
            "history",
            "impacts",
            "unloading",
            "restitution",
            "restitution_map",
            "restitution_histogram",
        ],
        &["png", "svg"],
    ),
];

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
    /// A file that another program wrote.
    #[error("{}: exists, and is no result of this program; move it, name another --out, or replace it with --force", .path.display())]
    Foreign { path: PathBuf },
    /// The directory holds other results.
    #[error(
        "{}: holds results of {other}, and these are of {own}; name another --out, or replace them with --force",
        .path.display()
    )]
    Taken {
        path: PathBuf,
        /// Scenario of the results that are there.
        other: String,
        /// Scenario or command of the results to write.
        own: String,
    },
}

impl From<OutputError> for Error {
    fn from(error: OutputError) -> Self {
        use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
        let is_full = |reason: &io::Error| matches!(reason.kind(), FileTooLarge | QuotaExceeded | StorageFull);
        let (OutputError::Unwritable { path, .. } | OutputError::Foreign { path } | OutputError::Taken { path, .. }) =
            &error;
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
    /// A scenario: its file, and its hash.
    File(&'a Path, &'a str),
    /// A command that needs none.
    Command(&'static str),
}

/// What is in a directory before a run.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Before {
    /// No summary.
    Nothing,
    /// Results of the same scenario.
    Same,
    /// Results of the same file with another text or other overrides.
    Older(String),
}

/// A directory that was found writable. Unless something is written, those of its parents that had to be made are removed.
#[derive(Debug)]
pub struct OutputDirectory {
    path: PathBuf,
    /// Made for this run, the deepest first.
    made: Vec<PathBuf>,
    before: Before,
    /// Set once the older results are removed.
    is_cleared: AtomicBool,
    is_forced: bool,
}

impl OutputDirectory {
    /// Makes the directory and tests that it takes files, before anything is computed. All its results are of one scenario.
    /// With `is_forced`, results of another scenario and files that the program did not write are replaced.
    ///
    /// # Errors
    /// [`OutputError::Unwritable`] if it cannot be made, is a file, or takes no files; [`OutputError::Taken`];
    /// [`OutputError::Foreign`] for a summary of another program.
    pub fn prepare(path: &Path, origin: Origin, is_forced: bool) -> Result<Self, OutputError> {
        let refuse = OutputError::at(path);
        let is_missing = |parent: &&Path| !parent.as_os_str().is_empty() && parent.symlink_metadata().is_err();
        let made: Vec<PathBuf> = path.ancestors().take_while(is_missing).map(Path::to_owned).collect();
        let mut directory = Self {
            path: path.to_owned(),
            made,
            before: Before::Nothing,
            is_cleared: AtomicBool::new(false),
            is_forced,
        };
        fs::create_dir_all(path).map_err(&refuse)?;
        directory.made.iter().try_for_each(|made| sync_folder(folder(made))).map_err(&refuse)?;
        drop(NewFile::create(&path.join("trial")).map_err(&refuse)?);
        directory.before = match directory.find(origin) {
            Err(OutputError::Taken { other, .. }) if is_forced => Before::Older(other),
            Err(OutputError::Foreign { .. }) if is_forced => Before::Nothing,
            found => found?,
        };
        Ok(directory)
    }

    /// What the summary says of the results that are there.
    fn find(&self, origin: Origin) -> Result<Before, OutputError> {
        let path = self.path.join(SUMMARY);
        refuse_special(&path).map_err(OutputError::at(&path))?;
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Before::Nothing),
            text => text.map_err(OutputError::at(&path))?,
        };
        let summary: Value = serde_json::from_slice(&text).unwrap_or_default();
        let of = |key: &str| summary["provenance"][key].as_str();
        let (Some(hash), Some(other)) = (of("scenario_sha256"), of("scenario_file")) else {
            return Err(OutputError::Foreign { path });
        };
        match origin {
            Origin::File(_, own) if own == hash => Ok(Before::Same),
            Origin::File(file, _) if is_same_file(file, other) => Ok(Before::Older(other.to_owned())),
            Origin::File(file, _) => Err(self.taken(other, &file.display().to_string())),
            Origin::Command(name) => Err(self.taken(other, name)),
        }
    }

    fn taken(&self, other: &str, own: &str) -> OutputError {
        OutputError::Taken { path: self.path.clone(), other: other.to_owned(), own: own.to_owned() }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether files of others may be replaced.
    pub fn is_forced(&self) -> bool {
        self.is_forced
    }

    /// The scenario of older results, which will be replaced.
    pub fn replaces(&self) -> Option<&str> {
        if let Before::Older(name) = &self.before { Some(name) } else { None }
    }

    /// Whether a file of this name may be written. Where no summary says that the results there are of the same scenario, a file
    /// gives way only to one that begins with the same line, as a table does to another of the same columns.
    ///
    /// # Errors
    /// [`OutputError::Foreign`]; [`OutputError::Unwritable`] for what is no ordinary file.
    pub fn may_replace(&self, name: &str, new: &[u8]) -> Result<(), OutputError> {
        let place = self.path.join(name);
        refuse_special(&place).map_err(OutputError::at(&place))?;
        if self.is_forced || self.before != Before::Nothing || !place.exists() {
            return Ok(());
        }
        let line = new.split_inclusive(|byte| *byte == b'\n').next().unwrap_or_default();
        let line = &line[..line.len().min(4096)];
        let mut begins = Vec::new();
        let read = File::open(&place).and_then(|file| file.take(line.len() as u64).read_to_end(&mut begins));
        read.map_err(OutputError::at(&place))?;
        if begins == line { Ok(()) } else { Err(OutputError::Foreign { path: place }) }
    }

    /// Writes all files, then puts them in place, the summary last.
    ///
    /// # Errors
    /// [`OutputError`] naming the file; then no file was replaced unless a rename itself failed halfway.
    pub fn write(&self, files: &[OutputFile]) -> Result<(), OutputError> {
        let mut new = Vec::new();
        for file in files {
            self.may_replace(&file.name, &file.bytes)?;
            let place = self.path.join(&file.name);
            let begun = remove_stale(&place).and_then(|()| NewFile::create(&place));
            let written = begun.and_then(|mut begun| {
                begun.write_all(&file.bytes)?;
                begun.sync()?;
                Ok(begun)
            });
            new.push((file.name == SUMMARY, written.map_err(OutputError::at(&place))?));
        }
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        self.remove_older(&names)?;
        new.sort_by_key(|(is_summary, _)| *is_summary);
        new.into_iter().try_for_each(|(_, file)| file.put()).map_err(OutputError::at(&self.path))
    }

    /// Removes results of the same file with another text, apart from those of these names, and their summary first. Does
    /// nothing when it is called again.
    pub fn remove_older(&self, kept: &[&str]) -> Result<(), OutputError> {
        if self.replaces().is_none() || self.is_cleared.swap(true, Ordering::Relaxed) {
            return Ok(());
        }
        let results = RESULTS.iter().flat_map(|(names, endings)| {
            names.iter().flat_map(|name| endings.iter().map(move |ending| format!("{name}.{ending}")))
        });
        for name in std::iter::once(SUMMARY.to_owned()).chain(results).filter(|name| !kept.contains(&name.as_str())) {
            let place = self.path.join(name);
            if place.symlink_metadata().is_ok_and(|data| data.is_file()) {
                remove(&place).map_err(OutputError::at(&place))?;
            }
        }
        Ok(())
    }
}

impl Drop for OutputDirectory {
    fn drop(&mut self) {
        // only empty ones go
        self.made.iter().for_each(|directory| drop(fs::remove_dir(directory)));
    }
}

/// Whether a scenario file is the one that a summary names, perhaps as seen from another folder.
fn is_same_file(file: &Path, named: &str) -> bool {
    let named = Path::new(named);
    let is_plain = |part: &Component| !matches!(part, Component::CurDir | Component::ParentDir);
    let tail: PathBuf = named.components().filter(is_plain).collect();
    file == named || file.canonicalize().is_ok_and(|file| file.ends_with(tail))
}

/// A temporary directory beside the outputs, which is removed with all its files.
#[derive(Debug)]
pub struct Scratch(PathBuf);

impl Scratch {
    /// Makes one with this name and a random number; those that killed runs left are removed after an hour.
    pub fn new(directory: &OutputDirectory, name: &str) -> Result<Self, OutputError> {
        let place = directory.path.join(name);
        let made = remove_stale(&place).and_then(|()| new_file::temporary(&place));
        let made = made.and_then(|path| fs::create_dir(&path).map(|()| path));
        Ok(Self(made.map_err(OutputError::at(&place))?))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        drop(fs::remove_dir_all(&self.0));
    }
}
