//! Output files that appear whole or not at all: written beside their place under another name, then renamed.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::error::Error;

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    /// Its name in the directory.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// A directory that was found writable. Unless something is written, those of its parents that had to be made are removed.
#[derive(Debug)]
pub struct OutputDirectory {
    path: PathBuf,
    /// Made for this run, the deepest first.
    made: Vec<PathBuf>,
}

impl OutputDirectory {
    /// Makes the directory and tries it, before anything is computed.
    ///
    /// # Errors
    /// [`Error::Unwritable`] if it cannot be made, is a file, or takes no files.
    pub fn prepare(path: &Path) -> Result<Self, Error> {
        let refuse = |reason| Error::Unwritable { path: path.to_owned(), reason };
        let is_missing = |parent: &&Path| !parent.as_os_str().is_empty() && parent.symlink_metadata().is_err();
        let made = path.ancestors().take_while(is_missing).map(Path::to_owned).collect();
        let directory = Self { path: path.to_owned(), made };
        fs::create_dir_all(path).map_err(refuse)?;
        let trial = directory.temporary("trial");
        File::create(&trial).and_then(|_| fs::remove_file(&trial)).map_err(refuse)?;
        Ok(directory)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes all files, then puts them in place.
    ///
    /// # Errors
    /// [`Error::Unwritable`] naming the file; then no file was replaced unless a rename itself failed halfway.
    pub fn write(mut self, files: &[OutputFile]) -> Result<(), Error> {
        let result = self.write_beside(files).and_then(|()| self.rename(files));
        match result {
            Ok(()) => self.made.clear(),
            Err(_) => files.iter().for_each(|file| drop(fs::remove_file(self.temporary(&file.name)))),
        }
        result
    }

    fn write_beside(&self, files: &[OutputFile]) -> Result<(), Error> {
        files.iter().try_for_each(|file| {
            let place = self.path.join(&file.name);
            let write = || {
                if place.is_dir() {
                    return Err(io::Error::from(io::ErrorKind::IsADirectory));
                }
                let mut output = File::create(self.temporary(&file.name))?;
                output.write_all(&file.bytes)?;
                // on the disk before it takes the place of an older one
                output.sync_all()
            };
            write().map_err(|reason| Error::Unwritable { path: place.clone(), reason })
        })
    }

    fn rename(&self, files: &[OutputFile]) -> Result<(), Error> {
        files.iter().try_for_each(|file| {
            let place = self.path.join(&file.name);
            fs::rename(self.temporary(&file.name), &place).map_err(|reason| Error::Unwritable { path: place, reason })
        })
    }

    fn temporary(&self, name: &str) -> PathBuf {
        self.path.join(format!(".{name}.{}.part", std::process::id()))
    }
}

impl Drop for OutputDirectory {
    fn drop(&mut self) {
        // only empty ones go
        self.made.iter().for_each(|directory| drop(fs::remove_dir(directory)));
    }
}
