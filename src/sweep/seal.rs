//! Length and checksum of a file, computed while the file is written or read.

use std::io::{self, Read, Write};

use serde::{Deserialize, Serialize};

/// Length and checksum of a finished file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seal {
    /// Length in bytes.
    pub bytes: u64,
    /// CRC-32 (IEEE) of all bytes. It finds every change within four neighbouring bytes; of other changes it misses one
    /// in 4·10⁹.
    pub crc32: u32,
}

/// Length and checksum of the bytes so far.
#[derive(Debug, Clone, Default)]
pub struct Sum {
    bytes: u64,
    crc32: crc32fast::Hasher,
}

impl Sum {
    /// Adds the next bytes.
    pub fn update(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.crc32.update(bytes);
    }

    /// The seal of a file that ends here.
    pub fn seal(&self) -> Seal {
        Seal { bytes: self.bytes, crc32: self.crc32.clone().finalize() }
    }
}

/// A writer or a reader that computes the seal of the bytes that pass through it.
#[derive(Debug)]
pub struct Sealed<T> {
    inner: T,
    sum: Sum,
}

impl<T> Sealed<T> {
    /// Continues from the bytes that `sum` has counted.
    pub fn new(inner: T, sum: Sum) -> Self {
        Self { inner, sum }
    }

    /// The inner writer or reader.
    pub fn into_inner(self) -> T {
        self.inner
    }

    /// The seal of all bytes that have passed.
    pub fn seal(&self) -> Seal {
        self.sum.seal()
    }
}

impl<T: Write> Write for Sealed<T> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.inner.write(bytes)?;
        self.sum.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

impl<T: Read> Read for Sealed<T> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let read = self.inner.read(bytes)?;
        self.sum.update(&bytes[..read]);
        Ok(read)
    }
}
