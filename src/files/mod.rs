//! How the program writes files. Every file goes through these steps:
//!
//! 1. It is made under a random name beside its place; no link is followed ([`NewFile`]).
//! 2. It is written and synchronised to the disk, so that all errors come before anything is replaced.
//! 3. It is renamed, and the folder is synchronised to the disk. The summary, which names the scenario of the results, comes last.
//!
//! Whenever the process is killed, each place holds either its old file or its new one, complete. Nothing is locked: of two
//! processes that write the same file the last to rename it wins.

mod new_file;
pub mod progress;
pub mod provenance;

use std::fs::{self, File};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::Value;

use crate::error::{Error, ErrorKind};
pub use new_file::{
    NewFile, after_changes, create, folder, refuse_special, remove, remove_folder, remove_stale, replace, sync_folder,
};
pub use progress::Counter;
pub use provenance::{FORMAT, LawOf, MethodOf, NUMBERS, PROGRAM, Provenance, VERSION, hex};

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
    /// A scenario: its file, and its hash.
    File(&'a Path, &'a str),
    /// A command that needs no scenario.
    Command(&'static str),
}

/// The results that are in a directory before a run, as their summary tells of them.
#[derive(Debug)]
struct EarlierResults {
    /// The files beside the summary.
    files: Vec<String>,
    /// Says whose results the new ones replace. It is `None` if they are of this scenario, with the same text and overrides.
    replaced: Option<String>,
}

/// A directory that was found writable. Unless something is written, those of its parents that had to be made are removed.
#[derive(Debug)]
pub struct OutputDirectory {
    path: PathBuf,
    /// Made for this run, the deepest first.
    made: Vec<PathBuf>,
    before: Option<EarlierResults>,
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
        let mut directory =
            Self { path: path.to_owned(), made, before: None, is_cleared: AtomicBool::new(false), is_forced };
        fs::create_dir_all(path).map_err(&refuse)?;
        directory.made.iter().try_for_each(|made| sync_folder(folder(made))).map_err(&refuse)?;
        drop(NewFile::create(&path.join("trial")).map_err(&refuse)?);
        directory.before = directory.find(origin)?;
        Ok(directory)
    }

    /// Reads the summary of the results that are there.
    fn find(&self, origin: Origin) -> Result<Option<EarlierResults>, Error> {
        let path = self.path.join(SUMMARY);
        refuse_special(&path).map_err(unwritable(&path))?;
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            text => text.map_err(unwritable(&path))?,
        };
        let summary: Value = serde_json::from_slice(&text).unwrap_or_default();
        let noted = |key: &str| summary["provenance"][key].as_str();
        let (Some(hash), Some(other)) = (noted("scenario_sha256"), noted("scenario_file")) else {
            return if self.is_forced { Ok(None) } else { Err(foreign(&path)) };
        };
        let before = |replaced| Ok(Some(EarlierResults { files: listed(&summary), replaced }));
        let own = match origin {
            Origin::File(_, own) if own == hash => return before(None),
            Origin::File(file, _)
                if self.relative_path(file).is_some_and(|seen| Some(&*seen) == noted(RELATIVE_SCENARIO)) =>
            {
                return before(Some(format!("the results of {other} as it was, or with other --set")));
            }
            Origin::File(file, _) => file.display().to_string(),
            Origin::Command(name) => name.to_owned(),
        };
        if self.is_forced {
            return before(Some(format!("the results of {other}")));
        }
        let reason = format!(
            "holds results of {other}, and these are of {own}; name another --out, or replace them with --force"
        );
        Err(Error::in_file(ErrorKind::Input, &self.path.display().to_string(), reason))
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// True if files of others may be replaced.
    pub fn is_forced(&self) -> bool {
        self.is_forced
    }

    /// The relative path from this directory to a file, which stays right if both are moved together; `None` if there is no such
    /// file.
    pub fn relative_path(&self, file: &Path) -> Option<String> {
        let (folder, file) = (self.path.canonicalize().ok()?, file.canonicalize().ok()?);
        let shared = folder.components().zip(file.components()).take_while(|(one, other)| one == other).count();
        let up = folder.components().skip(shared).map(|_| "..".into());
        let down = file.components().skip(shared).map(|part| part.as_os_str().to_string_lossy());
        Some(up.chain(down).collect::<Vec<_>>().join("/"))
    }

    /// The older results that give way to the new ones, in words.
    pub fn replaces(&self) -> Option<&str> {
        self.before.as_ref()?.replaced.as_deref()
    }

    /// True if a file of this name may be written. Where no summary says that the results there are of the same scenario, a file
    /// gives way only to one that begins with the same line, as a table does to another of the same columns.
    pub fn may_replace(&self, name: &str, new: &[u8]) -> Result<(), Error> {
        let place = self.path.join(name);
        refuse_special(&place).map_err(unwritable(&place))?;
        if self.is_forced || self.before.is_some() || !place.exists() {
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
        let summary = files.iter().find(|file| file.name == SUMMARY);
        let summary: Value = serde_json::from_slice(summary.map_or(&[][..], |file| &file.bytes)).unwrap_or_default();
        let listed = listed(&summary);
        let names: Vec<&str> = files.iter().map(|file| &file.name).chain(&listed).map(String::as_str).collect();
        self.remove_older(&names)?;
        // results of the same scenario that this run does not make, such as pictures in another format
        self.remove_listed(&names)?;
        new.sort_by_key(|(is_summary, _)| *is_summary);
        new.into_iter().try_for_each(|(_, file)| file.put()).map_err(unwritable(&self.path))
    }

    /// Removes the results of another text or other overrides: first their summary, so that it never stands beside newer files,
    /// then all but those of these names. Does nothing when it is called again.
    pub fn remove_older(&self, keep: &[&str]) -> Result<(), Error> {
        if self.replaces().is_none() || self.is_cleared.swap(true, Ordering::Relaxed) {
            return Ok(());
        }
        self.remove_file(SUMMARY)?;
        self.remove_listed(keep)
    }

    /// Removes the files that the summary before this run lists, apart from those of these names.
    fn remove_listed(&self, keep: &[&str]) -> Result<(), Error> {
        let listed = self.before.iter().flat_map(|before| &before.files);
        listed.filter(|name| !keep.contains(&name.as_str())).try_for_each(|name| self.remove_file(name))
    }

    /// Removes a file of this name; what is no ordinary file stays.
    fn remove_file(&self, name: &str) -> Result<(), Error> {
        let place = self.path.join(name);
        if place.symlink_metadata().is_ok_and(|data| data.is_file()) {
            remove(&place).map_err(unwritable(&place))?;
        }
        Ok(())
    }
}

/// The key of a summary with the relative path to its scenario.
const RELATIVE_SCENARIO: &str = "scenario_from_here";

/// The files that a summary lists. This program never writes a name with a folder in it, so such a name is left out.
fn listed(summary: &Value) -> Vec<String> {
    let names = summary["provenance"]["files"].as_array().into_iter().flatten().filter_map(Value::as_str);
    names.filter(|name| Path::new(name).file_name().is_some_and(|own| own == *name)).map(str::to_owned).collect()
}

impl Drop for OutputDirectory {
    fn drop(&mut self) {
        // only empty ones go
        self.made.iter().for_each(|directory| drop(fs::remove_dir(directory)));
    }
}
