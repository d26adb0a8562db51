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
    NewFile, after_changes, create, folder, refuse_special, remove, remove_folder, remove_stale, replace, sync_folder,
};

/// The name of the summary of any run.
pub const SUMMARY: &str = "summary.json";

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Makes the error of a place that cannot be written from that of the file system, for `map_err`. A full disk is a failure,
/// all else has to change.
pub fn unwritable(path: &Path) -> impl Fn(io::Error) -> Error {
    use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    move |reason| {
        let is_full = matches!(reason.kind(), FileTooLarge | QuotaExceeded | StorageFull);
        let kind = if is_full { ErrorKind::Failed } else { ErrorKind::Input };
        Error::of_file(kind, path, "cannot be written", "name another directory with --out")(reason)
    }
}

/// The error of a file that another program wrote.
pub fn foreign(path: &Path) -> Error {
    let reason = "exists, and is no result of this program; move it, name another --out, or replace it with --force";
    Error::in_file(ErrorKind::Input, &path.display().to_string(), reason)
}

/// The origin of results.
#[derive(Debug, Clone, Copy)]
pub enum Origin<'a> {
    /// A scenario: its file, its hash, and the names of all results that scenarios have, without their endings.
    File(&'a Path, &'a str, &'static [&'static str]),
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
    /// Names of results that do not stay beside newer ones.
    results: &'static [&'static str],
    /// Set once the older results are removed.
    is_cleared: AtomicBool,
    is_forced: bool,
}

impl OutputDirectory {
    /// Makes the directory and tests that it takes files, before anything is computed. All its results are of one scenario.
    /// With `is_forced`, results of another scenario and files that the program did not write are replaced.
    ///
    /// # Errors
    /// [`Error`] if it cannot be made, is a file, or takes no files; if it holds results of another scenario, or a summary of
    /// another program.
    pub fn prepare(path: &Path, origin: Origin, is_forced: bool) -> Result<Self, Error> {
        let refuse = unwritable(path);
        let is_missing = |parent: &&Path| !parent.as_os_str().is_empty() && parent.symlink_metadata().is_err();
        let made: Vec<PathBuf> = path.ancestors().take_while(is_missing).map(Path::to_owned).collect();
        let mut directory = Self {
            path: path.to_owned(),
            made,
            before: Before::Nothing,
            results: if let Origin::File(_, _, results) = origin { results } else { &[] },
            is_cleared: AtomicBool::new(false),
            is_forced,
        };
        fs::create_dir_all(path).map_err(&refuse)?;
        directory.made.iter().try_for_each(|made| sync_folder(folder(made))).map_err(&refuse)?;
        drop(NewFile::create(&path.join("trial")).map_err(&refuse)?);
        directory.before = directory.find(origin)?;
        Ok(directory)
    }

    /// What the summary says of the results that are there.
    fn find(&self, origin: Origin) -> Result<Before, Error> {
        let path = self.path.join(SUMMARY);
        refuse_special(&path).map_err(unwritable(&path))?;
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Before::Nothing),
            text => text.map_err(unwritable(&path))?,
        };
        let summary: Value = serde_json::from_slice(&text).unwrap_or_default();
        let of = |key: &str| summary["provenance"][key].as_str();
        let (Some(hash), Some(other)) = (of("scenario_sha256"), of("scenario_file")) else {
            return if self.is_forced { Ok(Before::Nothing) } else { Err(foreign(&path)) };
        };
        let own = match origin {
            Origin::File(_, own, _) if own == hash => return Ok(Before::Same),
            Origin::File(file, ..) if is_same_file(file, other) => return Ok(Before::Older(other.to_owned())),
            Origin::File(file, ..) => file.display().to_string(),
            Origin::Command(name) => name.to_owned(),
        };
        if self.is_forced {
            return Ok(Before::Older(other.to_owned()));
        }
        let reason = format!(
            "holds results of {other}, and these are of {own}; name another --out, or replace them with --force"
        );
        Err(Error::in_file(ErrorKind::Input, &self.path.display().to_string(), reason))
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
    /// [`Error`] if not, and for what is no ordinary file.
    pub fn may_replace(&self, name: &str, new: &[u8]) -> Result<(), Error> {
        let place = self.path.join(name);
        refuse_special(&place).map_err(unwritable(&place))?;
        if self.is_forced || self.before != Before::Nothing || !place.exists() {
            return Ok(());
        }
        let line = new.split_inclusive(|byte| *byte == b'\n').next().unwrap_or_default();
        let line = &line[..line.len().min(4096)];
        let mut begins = Vec::new();
        let read = File::open(&place).and_then(|file| file.take(line.len() as u64).read_to_end(&mut begins));
        read.map_err(unwritable(&place))?;
        if begins == line { Ok(()) } else { Err(foreign(&place)) }
    }

    /// Writes all files, then puts them in place, the summary last.
    ///
    /// # Errors
    /// [`Error`] naming the file; then no file was replaced unless a rename itself failed halfway.
    pub fn write(&self, files: &[OutputFile]) -> Result<(), Error> {
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
            new.push((file.name == SUMMARY, written.map_err(unwritable(&place))?));
        }
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        self.remove_older(&names)?;
        new.sort_by_key(|(is_summary, _)| *is_summary);
        new.into_iter().try_for_each(|(_, file)| file.put()).map_err(unwritable(&self.path))
    }

    /// Removes results of the same file with another text: first their summary, so that it never stands beside newer files,
    /// then all but those of these names. Does nothing when it is called again.
    pub fn remove_older(&self, kept: &[&str]) -> Result<(), Error> {
        if self.replaces().is_none() || self.is_cleared.swap(true, Ordering::Relaxed) {
            return Ok(());
        }
        let endings = ["csv", "parquet", "png", "svg", "toml"];
        let results = self.results.iter().flat_map(|name| endings.map(|ending| format!("{name}.{ending}")));
        let results = results.filter(|name| !kept.contains(&name.as_str()));
        for name in std::iter::once(SUMMARY.to_owned()).chain(results) {
            let place = self.path.join(name);
            if place.symlink_metadata().is_ok_and(|data| data.is_file()) {
                remove(&place).map_err(unwritable(&place))?;
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
