//! Locks on outputs: one process at a time writes a table, or changes what lies in a folder.

use std::fmt::Write as _;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use super::new_file::{is_at, refuse_special, with_suffix};

/// Why a lock was not taken.
#[derive(Debug)]
pub enum LockError {
    /// Another process holds it; the text says which, and since when.
    Held(String),
    /// The file system refuses.
    File(io::Error),
}

impl From<io::Error> for LockError {
    fn from(error: io::Error) -> Self {
        Self::File(error)
    }
}

/// An exclusive lock, held until it is dropped.
///
/// It is the kernel's lock on the file `<name>.lock`, which ends with the process in any case. The file only says who holds
/// the lock; a file that a killed process left behind is used again. A process removes the file before it releases the
/// lock. A process that gets a lock checks that its file still has that name. So two processes never hold locks on two
/// files of one name.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Locks `path`, which need not exist.
    pub fn take(path: &Path) -> Result<Self, LockError> {
        let path = with_suffix(path, ".lock");
        loop {
            let mut file = match open(&path) {
                Ok(file) => file,
                // the holder removed it, or another process made it, just now
                Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::AlreadyExists) => {
                    continue;
                }
                Err(error) => return Err(LockError::File(error)),
            };
            match file.try_lock() {
                Ok(()) if !is_at(&file, &path)? => continue,
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(LockError::Held(holder(&mut file))),
                Err(TryLockError::Error(error)) => return Err(LockError::File(error)),
            }
            file.set_len(0)?;
            file.write_all(own_name().as_bytes())?;
            return Ok(Self { path, file });
        }
    }

    /// The same, but waits for a lock that is held for moments only.
    pub fn wait(path: &Path) -> Result<Self, LockError> {
        const PAUSE: Duration = Duration::from_millis(20);
        const PAUSES: u32 = 500;
        for _ in 0..PAUSES {
            match Self::take(path) {
                Err(LockError::Held(_)) => std::thread::sleep(PAUSE),
                result => return result,
            }
        }
        Self::take(path)
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if is_at(&self.file, &self.path).unwrap_or(false) {
            drop(fs::remove_file(&self.path));
        }
    }
}

/// Opens the file of a lock and follows no link.
fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true);
    match options.clone().create_new(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            refuse_special(path)?;
            options.open(path)
        }
        result => result,
    }
}

fn seconds() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

/// Process, machine and time, as the file of a lock holds them.
fn own_name() -> String {
    // in containers all processes have the same number
    let machine = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    format!("{}\n{}\n{}\n", std::process::id(), seconds(), machine.trim())
}

fn holder(file: &mut File) -> String {
    let mut text = String::new();
    drop(file.take(1000).read_to_string(&mut text));
    let mut lines = text.lines();
    let Some(process) = lines.next().and_then(|line| line.parse::<u32>().ok()) else {
        return "another process".to_owned();
    };
    let mut holder = format!("process {process}");
    let since = lines.next().and_then(|line| line.parse::<u64>().ok());
    if let Some(machine) = lines.next().filter(|name| !name.is_empty()) {
        let _ = write!(holder, " on {}", machine.escape_debug());
    }
    if let Some(since) = since {
        let _ = write!(holder, ", since {}", date(since));
    }
    holder
}

/// Seconds since 1970 as a date, as ISO 8601 has it; the days are counted as in Hinnant, "chrono-compatible low-level date
/// algorithms", from 1 March of the year 0.
fn date(seconds: u64) -> String {
    let (days, time) = (seconds / 86_400 + 719_468, seconds % 86_400);
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    let year = year + era * 400 + next;
    format!("{year}-{month:02}-{day:02} {:02}:{:02}:{:02} UTC", time / 3600, time / 60 % 60, time % 60)
}

#[cfg(test)]
mod tests {
    /// As `date -u -d @<seconds>` prints them.
    #[test]
    fn seconds_are_dates() {
        assert_eq!(super::date(0), "1970-01-01 00:00:00 UTC");
        assert_eq!(super::date(951_782_399), "2000-02-28 23:59:59 UTC");
        assert_eq!(super::date(951_782_400), "2000-02-29 00:00:00 UTC");
        assert_eq!(super::date(1_704_067_199), "2023-12-31 23:59:59 UTC");
        assert_eq!(super::date(1_795_323_123), "2026-11-22 04:52:03 UTC");
    }
}
