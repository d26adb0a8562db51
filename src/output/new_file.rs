//! One file: made under another name, written, synchronised to the disk, then renamed.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher as _, RandomState};
use std::io::{self, Seek as _, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The end of a temporary name, and of the name of an unfinished table.
pub const PART: &str = ".part";

/// A file that is not in its place yet. It is removed unless it is put there; only rows that a later run can continue stay.
#[derive(Debug)]
pub struct NewFile {
    file: File,
    temporary: PathBuf,
    place: PathBuf,
    is_kept: bool,
}

impl NewFile {
    /// Begins a file under a random name beside its place. Follows no link and overwrites nothing.
    pub fn create(place: &Path) -> io::Result<Self> {
        refuse_special(place)?;
        let temporary = temporary(place)?;
        let file = OpenOptions::new().write(true).create_new(true).open(&temporary)?;
        Ok(Self { file, temporary, place: place.to_owned(), is_kept: false })
    }

    /// Continues at `end` the rows that an earlier run left in `part`, or begins that file. The rows stay if this run
    /// fails. What follows `end` is cut off. The place has to be locked.
    pub fn resume(place: &Path, part: PathBuf, end: u64) -> io::Result<Self> {
        refuse_special(place)?;
        let mut options = OpenOptions::new();
        options.write(true);
        let mut file = match options.clone().create_new(true).open(&part) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                refuse_link(&part)?;
                options.open(&part)?
            }
            result => result?,
        };
        file.set_len(end)?;
        file.seek(SeekFrom::Start(end))?;
        Ok(Self { file, temporary: part, place: place.to_owned(), is_kept: true })
    }

    /// Where it will be.
    pub fn place(&self) -> &Path {
        &self.place
    }

    /// Where it is so far.
    pub fn temporary(&self) -> &Path {
        &self.temporary
    }

    /// Synchronises it to the disk. After that, closing the file cannot fail.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_all()
    }

    /// Puts it in its place, over an older file; to be followed by [`sync_folder`].
    pub fn rename(&mut self) -> io::Result<()> {
        refuse_special(&self.place)?;
        fs::rename(&self.temporary, &self.place)?;
        self.is_kept = true;
        Ok(())
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for NewFile {
    fn drop(&mut self) {
        if !self.is_kept {
            drop(fs::remove_file(&self.temporary));
        }
    }
}

/// Writes a single file: complete, on the disk and in its place, or not at all.
pub fn replace(place: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = NewFile::create(place)?;
    file.write_all(bytes)?;
    file.sync()?;
    file.rename()?;
    sync_folder(folder(place))
}

/// Removes a file of the program, also from the disk.
pub fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(error),
        Ok(()) => sync_folder(folder(path)),
    }
}

/// Synchronises the names in a folder to the disk.
pub fn sync_folder(path: &Path) -> io::Result<()> {
    // only Unix opens folders
    if cfg!(not(unix)) {
        return Ok(());
    }
    match File::open(path)?.sync_all() {
        // some network file systems have nothing to sync in a folder
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        result => result,
    }
}

/// The folder that a path is in.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A path with something behind its name.
pub fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}

/// Refuses a path at which there is something else than an ordinary file: a directory, a link, a device, a pipe.
pub fn refuse_special(path: &Path) -> io::Result<()> {
    let kind = match path.symlink_metadata() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(error),
        Ok(data) if data.is_file() => return Ok(()),
        Ok(data) => data.file_type(),
    };
    if kind.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory));
    }
    let what = if kind.is_symlink() { "a link" } else { "a device or a pipe" };
    Err(io::Error::new(io::ErrorKind::InvalidInput, format!("it is {what}, and only ordinary files are written")))
}

/// Refuses a file that has another name too, and anything that is not an ordinary file.
fn refuse_link(path: &Path) -> io::Result<()> {
    refuse_special(path)?;
    if links(path)? > 1 {
        let problem = "it is a hard link, and what it is linked to would change; remove it to start over";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, problem));
    }
    Ok(())
}

#[cfg(unix)]
fn links(path: &Path) -> io::Result<u64> {
    path.symlink_metadata().map(|data| std::os::unix::fs::MetadataExt::nlink(&data))
}

#[cfg(not(unix))]
fn links(_: &Path) -> io::Result<u64> {
    Ok(1)
}

/// Whether an open file is the one at this path.
#[cfg(unix)]
pub(super) fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt as _;
    let opened = file.metadata()?;
    match path.symlink_metadata() {
        Ok(there) => Ok(there.ino() == opened.ino() && there.dev() == opened.dev()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

/// Whether an open file is the one at this path: elsewhere than on Unix a locked file cannot be replaced.
#[cfg(not(unix))]
pub(super) fn is_at(_: &File, path: &Path) -> io::Result<bool> {
    path.try_exists()
}

/// 64 random bits from the operating system, so that processes on all machines have different ones.
fn random() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

fn name(place: &Path) -> io::Result<OsString> {
    let nameless = || io::Error::new(io::ErrorKind::InvalidInput, "it is not the name of a file");
    place.file_name().map(OsString::from).ok_or_else(nameless)
}

/// A name beside `place` that nobody else has.
pub(super) fn temporary(place: &Path) -> io::Result<PathBuf> {
    let mut hidden = OsString::from(".");
    hidden.push(name(place)?);
    hidden.push(format!(".{:016x}{PART}", random()));
    Ok(folder(place).join(hidden))
}

/// Removes what killed runs left of this output. The place has to be locked.
pub fn remove_stale(place: &Path) -> io::Result<()> {
    let mut before = OsString::from(".");
    before.push(name(place)?);
    before.push(".");
    for entry in fs::read_dir(folder(place))? {
        let entry = entry?;
        let name = entry.file_name();
        let number = name.as_encoded_bytes().strip_prefix(before.as_encoded_bytes());
        let number = number.and_then(|rest| rest.strip_suffix(PART.as_bytes()));
        if !number.is_some_and(|digits| !digits.is_empty() && digits.iter().all(u8::is_ascii_hexdigit)) {
            continue;
        }
        // `bench` measures in a directory
        let is_directory = entry.file_type()?.is_dir();
        let removed = if is_directory { fs::remove_dir_all(entry.path()) } else { fs::remove_file(entry.path()) };
        match removed {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            result => result?,
        }
    }
    Ok(())
}
