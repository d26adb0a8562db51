//! One file: made under another name, written, synchronised to the disk, then renamed.

use std::ffi::OsString;
use std::fs::{self, File};
use std::hash::{BuildHasher as _, RandomState};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::Duration;

use super::unfinished;

/// The end of a temporary name.
const TEMPORARY_SUFFIX: &str = ".part";
/// A temporary file that has not been written to for this time is left from a killed run.
const STALE_AGE: Duration = Duration::from_secs(3600);

/// A function that is called after every change of the disk.
static ON_DISK_CHANGE: OnceLock<Box<dyn Fn() + Send + Sync>> = OnceLock::new();

/// Sets the function that is called after every step of writing: a file created, some of its bytes written, synchronised, renamed or
/// removed. Tests send signals there. Only the first call counts.
pub fn on_disk_change(then: impl Fn() + Send + Sync + 'static) {
    ON_DISK_CHANGE.get_or_init(|| Box::new(then));
}

/// Notes that the disk has changed.
fn notify_disk_change<T>(done: T) -> T {
    if let Some(then) = ON_DISK_CHANGE.get() {
        then();
    }
    done
}

/// A file under a temporary name. It is removed unless [`AtomicFile::persist`] renames it.
#[derive(Debug)]
pub struct AtomicFile {
    file: File,
    temporary: PathBuf,
    target: PathBuf,
    is_persisted: bool,
}

impl AtomicFile {
    /// A new file with these bytes, written to the disk, and not yet at its final path.
    pub(super) fn with_bytes(place: &Path, bytes: &[u8]) -> io::Result<Self> {
        let mut file = Self::create(place)?;
        file.write_all(bytes)?;
        file.sync()?;
        Ok(file)
    }

    /// Creates a file under a random name beside its final path. Follows no link and overwrites nothing.
    pub fn create(place: &Path) -> io::Result<Self> {
        refuse_special(place)?;
        let temporary = temporary_path(place)?;
        let file = unfinished::begin(&temporary).map(notify_disk_change)?;
        Ok(Self { file, temporary, target: place.to_owned(), is_persisted: false })
    }

    /// Appends the rest of another file, copied inside the system.
    pub fn append(&mut self, other: &mut File) -> io::Result<()> {
        io::copy(other, &mut self.file).map(notify_disk_change).map(drop)
    }

    /// Synchronises it to the disk. After that, closing the file cannot fail.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_all().map(notify_disk_change)
    }

    /// Renames the file to its final path, and replaces an older file.
    pub fn persist(mut self) -> io::Result<()> {
        refuse_special(&self.target)?;
        fs::rename(&self.temporary, &self.target).map(notify_disk_change)?;
        self.is_persisted = true;
        unfinished::end(&self.temporary);
        sync_folder(parent_folder(&self.target))
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map(notify_disk_change)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        if !self.is_persisted {
            drop(fs::remove_file(&self.temporary));
            unfinished::end(&self.temporary);
        }
    }
}

/// Writes a single file, complete and on the disk, or not at all. Replaces an older file and makes the folder.
pub fn replace(place: &Path, bytes: &[u8]) -> io::Result<()> {
    fs::create_dir_all(parent_folder(place))?;
    AtomicFile::with_bytes(place, bytes)?.persist()
}

/// Writes a single file that does not exist yet: complete and on the disk, or not at all.
///
/// # Errors
/// [`io::ErrorKind::AlreadyExists`] if there is one, even if another process has made it just now.
pub fn create(place: &Path, bytes: &[u8]) -> io::Result<()> {
    let file = AtomicFile::with_bytes(place, bytes)?;
    match fs::hard_link(&file.temporary, place) {
        // some file systems have no links
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists && !place.exists() => file.persist(),
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
            Err(io::Error::from(io::ErrorKind::AlreadyExists))
        }
        linked => linked.map(notify_disk_change).and_then(|()| sync_folder(parent_folder(place))),
    }
}

/// Removes a file of the program, also from the disk.
pub fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path).map(notify_disk_change) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(error),
        Ok(()) => sync_folder(parent_folder(path)),
    }
}

/// Removes a folder of the program with all its files. It is renamed first, so that other processes see all of it or nothing.
pub fn remove_folder(path: &Path) -> io::Result<()> {
    let away = temporary_path(path)?;
    match fs::rename(path, &away).map(notify_disk_change) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(error),
        Ok(()) => fs::remove_dir_all(&away).map(notify_disk_change),
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
        result => result.map(notify_disk_change),
    }
}

pub fn parent_folder(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
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
    let described = if kind.is_symlink() { "a symbolic link" } else { "a device or a pipe" };
    Err(io::Error::new(io::ErrorKind::InvalidInput, format!("it is {described}; only regular files can be written")))
}

/// 64 random bits from the operating system, so that processes on all machines have different ones.
fn random_u64() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

fn file_name(place: &Path) -> io::Result<OsString> {
    let nameless = || io::Error::new(io::ErrorKind::InvalidInput, "it is not the name of a file");
    place.file_name().map(OsString::from).ok_or_else(nameless)
}

/// A unique name beside `place`.
pub(super) fn temporary_path(place: &Path) -> io::Result<PathBuf> {
    let mut hidden = OsString::from(".");
    hidden.push(file_name(place)?);
    hidden.push(format!(".{:016x}{TEMPORARY_SUFFIX}", random_u64()));
    Ok(parent_folder(place).join(hidden))
}

/// Removes temporary files of this output that killed runs left an hour ago or more. Younger files may belong to a run in progress.
pub fn remove_stale(place: &Path) -> io::Result<()> {
    let mut before = OsString::from(".");
    before.push(file_name(place)?);
    before.push(".");
    for entry in fs::read_dir(parent_folder(place))? {
        let entry = entry?;
        let name = entry.file_name();
        let number = name.as_encoded_bytes().strip_prefix(before.as_encoded_bytes());
        let number = number.and_then(|rest| rest.strip_suffix(TEMPORARY_SUFFIX.as_bytes()));
        let is_temporary = number.is_some_and(|digits| !digits.is_empty() && digits.iter().all(u8::is_ascii_hexdigit));
        let age = || entry.metadata().and_then(|data| data.modified()).map(|time| time.elapsed().unwrap_or_default());
        if !is_temporary || age().is_ok_and(|age| age < STALE_AGE) {
            continue;
        }
        let is_directory = entry.file_type()?.is_dir();
        let removed = if is_directory { fs::remove_dir_all(entry.path()) } else { fs::remove_file(entry.path()) };
        match removed {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            result => result?,
        }
    }
    Ok(())
}
