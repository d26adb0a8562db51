//! How the program writes files. Every file goes through these steps:
//!
//! 1. It is created under a random name in the folder of its path; no link is followed ([`AtomicFile`]).
//! 2. It is written and synchronised to the disk, so that all errors come before anything is replaced.
//! 3. It is renamed, and the folder is synchronised to the disk. The summary, which names the scenario of the results, comes last.
//!
//! A run replaces and removes its own files alone: those that the summary in the folder lists, those that it knows by their content
//! ([`OutputDirectory::check_replaceable`]), and the parts of a table. It never touches a file of the scenario. `--force` allows it to
//! replace files of others that are in the way, and results of another scenario or of other options.
//!
//! If the process is killed, each path has either its complete old file or its complete new one. No file is locked: if two
//! processes write the same file, the file of the last rename stays.

mod atomic_file;
pub(crate) mod parts_folder;
pub mod progress;
pub mod provenance;
mod signature;
mod unfinished;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::Value;

use crate::error::{Error, ErrorKind};
pub use atomic_file::{
    AtomicFile, create, on_disk_change, parent_folder, refuse_special, remove, remove_folder, remove_stale, replace,
    sync_folder,
};
pub use progress::Progress;
pub use provenance::{
    FORMAT_VERSION, LawProvenance, MethodProvenance, PROGRAM, PROGRAM_NAME, Provenance, RESULTS_VERSION, VERSION, hex,
};
pub use signature::begins_like;
pub use unfinished::abandon;

/// The name of the summary of any run.
pub const SUMMARY_FILE: &str = "summary.json";

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// Makes the error of a path that cannot be written from the error of the file system, for `map_err`. A full disk is a failure of the
/// run; every other reason is an error of the input.
pub fn unwritable_error(path: &Path) -> impl Fn(io::Error) -> Error {
    use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    move |reason| {
        let is_full = matches!(reason.kind(), FileTooLarge | QuotaExceeded | StorageFull);
        let kind = if is_full { ErrorKind::Failed } else { ErrorKind::Input };
        Error::from_io(kind, path, "cannot be written", "choose another directory with --out")(reason)
    }
}

/// The ways out of a file of another program where results go.
pub const FOREIGN_FILE_ADVICE: &str = "Move the file, choose another --out, or use --force to replace it.";

/// The error of a file that another program wrote, and the ways out.
pub fn foreign_file_error(path: &Path, advice: &str) -> Error {
    Error::for_path(path, format!("already exists and was not written by this program. {advice}"))
}

/// The error of a result that would replace the file of the scenario, or a file that the scenario reads.
fn input_error(path: &Path) -> Error {
    let reason = "this file belongs to the scenario, and the results would replace it. Choose another --out.";
    Error::for_path(path, reason)
}

/// The origin of results.
#[derive(Debug, Clone, Copy)]
pub enum ResultOrigin<'a> {
    /// A scenario.
    File {
        path: &'a Path,
        /// The hash of all that the results depend on.
        sha256: &'a str,
        /// The hash of the overrides alone; `None` without overrides.
        overrides_sha256: Option<&'a str>,
        /// The files that the scenario names.
        reads: &'a [&'a Path],
        /// True for a table, which resumes from its parts in the directory.
        is_table: bool,
    },
    /// A command that needs no scenario.
    Command(&'static str),
}

/// The results that are in a directory before a run, as listed in their summary.
#[derive(Debug)]
struct EarlierResults {
    /// The files beside the summary.
    files: Vec<String>,
    /// The owner of the results that the new results replace. `None` if they belong to this scenario, with the same text and overrides.
    replaced: Option<String>,
    /// True if this version of the program made them, with these numbers.
    is_of_this_version: bool,
}

/// A writable directory. Parent folders that were made for it are removed again if nothing is written.
#[derive(Debug)]
pub struct OutputDirectory {
    path: PathBuf,
    /// Made for this run, the deepest first.
    created: Vec<PathBuf>,
    earlier_results: Option<EarlierResults>,
    /// The file of the scenario, and the files that it reads. They are never removed or replaced.
    inputs: Vec<PathBuf>,
    /// Set once the older results are removed.
    is_cleared: AtomicBool,
    is_forced: bool,
}

impl OutputDirectory {
    /// Makes the directory and tests that it takes files, before anything is computed. All its results are of one scenario.
    /// With `is_forced`, results of another scenario or with other overrides are replaced, and so are files that the program did
    /// not write.
    ///
    /// # Errors
    /// [`Error`] if it cannot be made, is a file, or takes no files; if it holds results of another scenario or with other
    /// overrides, a summary of another program, or parts of a table.
    pub fn prepare(path: &Path, origin: ResultOrigin, is_forced: bool) -> Result<Self, Error> {
        let refuse = unwritable_error(path);
        let is_missing = |parent: &&Path| !parent.as_os_str().is_empty() && parent.symlink_metadata().is_err();
        let made: Vec<PathBuf> = path.ancestors().take_while(is_missing).map(Path::to_owned).collect();
        let inputs = match origin {
            ResultOrigin::File { path, reads, .. } => {
                reads.iter().chain([&path]).filter_map(|file| file.canonicalize().ok()).collect()
            }
            ResultOrigin::Command(_) => Vec::new(),
        };
        let mut directory = Self {
            path: path.to_owned(),
            created: made,
            earlier_results: None,
            inputs,
            is_cleared: AtomicBool::new(false),
            is_forced,
        };
        unfinished::add_folders(&directory.created);
        fs::create_dir_all(path).map_err(&refuse)?;
        directory.created.iter().try_for_each(|made| sync_folder(parent_folder(made))).map_err(&refuse)?;
        drop(AtomicFile::create(&path.join("trial")).map_err(&refuse)?);
        directory.earlier_results = directory.read_earlier_results(origin)?;
        if matches!(origin, ResultOrigin::File { is_table: false, .. }) {
            directory.clear_parts()?;
        }
        Ok(directory)
    }

    /// Reads the summary of the results that are there.
    fn read_earlier_results(&self, origin: ResultOrigin) -> Result<Option<EarlierResults>, Error> {
        let path = self.path.join(SUMMARY_FILE);
        refuse_special(&path).map_err(unwritable_error(&path))?;
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            text => text.map_err(unwritable_error(&path))?,
        };
        let summary: Value = serde_json::from_slice(&text).unwrap_or_default();
        let noted = |key: &str| summary["provenance"][key].as_str();
        let (Some(hash), Some(other)) = (noted("scenario_sha256"), noted("scenario_file")) else {
            return if self.is_forced { Ok(None) } else { Err(foreign_file_error(&path, FOREIGN_FILE_ADVICE)) };
        };
        let numbers = summary["provenance"]["numbers_version"].as_u64();
        let is_of_this_version = noted("version") == Some(VERSION) && numbers == Some(RESULTS_VERSION);
        let before =
            |replaced| Ok(Some(EarlierResults { files: listed_files(&summary), replaced, is_of_this_version }));
        let (own, is_other_text) = match origin {
            ResultOrigin::File { sha256, .. } if sha256 == hash => return before(None),
            ResultOrigin::File { path, overrides_sha256, .. } => {
                let is_same_file = self.relative_path(path).is_some_and(|seen| Some(&*seen) == noted(SCENARIO_PATH));
                if is_same_file && noted(OVERRIDES) == overrides_sha256 {
                    return before(Some(format!("the results of {other} as it was")));
                }
                if is_same_file && !self.is_forced {
                    return Err(self.other_overrides(other, noted("command")));
                }
                (path.display().to_string(), other == path.display().to_string())
            }
            ResultOrigin::Command(name) => (name.to_owned(), false),
        };
        if self.is_forced {
            return before(Some(format!("the results of {other}")));
        }
        let whose = if is_other_text && noted(SCENARIO_PATH).is_none() {
            format!("contains results of another text from {other}")
        } else {
            format!("contains results of {other}; the current scenario is {own}")
        };
        Err(self.refusal_error(&format!("{whose}. Choose another --out, or use --force to replace them.")))
    }

    /// The error of results of the same file with other overrides.
    fn other_overrides(&self, scenario: &str, command: Option<&str>) -> Error {
        let made_by = command.map_or_else(String::new, |command| format!(", made by `{command}`"));
        self.refusal_error(&format!(
            "contains results of {scenario} with other --set or options{made_by}. Choose another --out, or use --force to replace them. Without --out, other settings have a separate folder."
        ))
    }

    fn refusal_error(&self, reason: &str) -> Error {
        Error::for_path(&self.path, reason)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// True if this run made this folder.
    pub fn has_made(&self, folder: &Path) -> bool {
        self.created.iter().any(|made| made == folder)
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
    pub fn replaced_results(&self) -> Option<&str> {
        self.earlier_results.as_ref()?.replaced.as_deref()
    }

    /// The files of the results that are there, if they are of the same scenario and overrides, and of this version of the
    /// program. They are still right.
    pub fn same_results(&self) -> &[String] {
        let same =
            self.earlier_results.as_ref().filter(|before| before.replaced.is_none() && before.is_of_this_version);
        same.map_or(&[], |before| &before.files)
    }

    /// Refuses to replace a file of this name that is not a result. A file is a result if the summary that is there lists it, or
    /// if `is_own` knows it by its content: a run that was killed leaves results without a summary.
    pub fn check_replaceable(&self, name: &str, is_own: impl FnOnce(&Path) -> io::Result<bool>) -> Result<(), Error> {
        let place = self.path.join(name);
        refuse_special(&place).map_err(unwritable_error(&place))?;
        if self.is_input(&place) {
            return Err(input_error(&place));
        }
        let is_listed = || self.earlier_results.iter().flat_map(|before| &before.files).any(|listed| listed == name);
        if self.is_forced || is_listed() || !place.exists() || name == SUMMARY_FILE {
            return Ok(());
        }
        if is_own(&place).map_err(unwritable_error(&place))? {
            Ok(())
        } else {
            Err(foreign_file_error(&place, FOREIGN_FILE_ADVICE))
        }
    }

    /// Refuses to remove a folder of results that holds a file of the scenario.
    ///
    /// # Errors
    /// [`Error`] naming that file.
    pub fn check_removable(&self, folder: &Path) -> Result<(), Error> {
        let Ok(folder) = folder.canonicalize() else { return Ok(()) };
        self.inputs.iter().find(|input| input.starts_with(&folder)).map_or(Ok(()), |input| Err(input_error(input)))
    }

    /// True if the scenario is this file, or reads it.
    fn is_input(&self, place: &Path) -> bool {
        place.canonicalize().is_ok_and(|place| self.inputs.contains(&place))
    }

    /// Writes all files under temporary names, then renames them, the summary last. Returns the names of earlier files of the same
    /// results that were removed because this run does not make them, such as pictures in another format.
    ///
    /// # Errors
    /// [`Error`] naming the file; then no file was replaced unless a rename itself failed halfway.
    pub fn write(&self, files: &[OutputFile]) -> Result<Vec<String>, Error> {
        for file in files {
            self.check_replaceable(&file.name, |place| begins_like(place, &file.bytes))?;
        }
        let mut new = Vec::new();
        for file in files {
            let place = self.path.join(&file.name);
            let written = remove_stale(&place).and_then(|()| AtomicFile::with_bytes(&place, &file.bytes));
            new.push((file.name == SUMMARY_FILE, written.map_err(unwritable_error(&place))?));
        }
        let summary = files.iter().find(|file| file.name == SUMMARY_FILE);
        let summary: Value = serde_json::from_slice(summary.map_or(&[][..], |file| &file.bytes)).unwrap_or_default();
        let listed = listed_files(&summary);
        let names: Vec<&str> = files.iter().map(|file| &file.name).chain(&listed).map(String::as_str).collect();
        self.remove_earlier_results(&names)?;
        let removed = self.remove_listed(&names)?;
        new.sort_by_key(|(is_summary, _)| *is_summary);
        new.into_iter().try_for_each(|(_, file)| file.persist()).map_err(unwritable_error(&self.path))?;
        Ok(if self.replaced_results().is_some() { Vec::new() } else { removed })
    }

    /// Removes the results of another text or other overrides: first their summary, so that it is never beside newer files, and then all
    /// files except `keep`. A second call does nothing.
    pub fn remove_earlier_results(&self, keep: &[&str]) -> Result<(), Error> {
        if self.replaced_results().is_none() || self.is_cleared.swap(true, Ordering::Relaxed) {
            return Ok(());
        }
        self.remove_file(SUMMARY_FILE)?;
        self.remove_listed(keep).map(drop)
    }

    /// Removes the files that the summary before this run lists, except `keep`. Returns the names of the removed files.
    fn remove_listed(&self, keep: &[&str]) -> Result<Vec<String>, Error> {
        let listed = self.earlier_results.iter().flat_map(|before| &before.files);
        let mut removed = Vec::new();
        for name in listed.filter(|name| !keep.contains(&name.as_str())) {
            if self.remove_file(name)? {
                removed.push(name.clone());
            }
        }
        Ok(removed)
    }

    /// Removes a file of this name. Files of the scenario, and directories, links and devices stay. Returns true if a file was removed.
    fn remove_file(&self, name: &str) -> Result<bool, Error> {
        let place = self.path.join(name);
        let is_removed = place.symlink_metadata().is_ok_and(|data| data.is_file()) && !self.is_input(&place);
        if is_removed {
            remove(&place).map_err(unwritable_error(&place))?;
        }
        Ok(is_removed)
    }
}

/// The key of a summary with the relative path to its scenario.
const SCENARIO_PATH: &str = "scenario_path";
/// The key of a summary with the hash of the overrides.
const OVERRIDES: &str = "overrides_sha256";

/// The files that a summary lists. This program never writes a name with a folder in it, so such a name is left out.
fn listed_files(summary: &Value) -> Vec<String> {
    let names = summary["provenance"]["files"].as_array().into_iter().flatten().filter_map(Value::as_str);
    names.filter(|name| Path::new(name).file_name().is_some_and(|own| own == *name)).map(str::to_owned).collect()
}

impl Drop for OutputDirectory {
    fn drop(&mut self) {
        // only empty ones go
        self.created.iter().for_each(|directory| drop(fs::remove_dir(directory)));
    }
}
