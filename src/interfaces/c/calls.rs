//! Helpers of the functions of [`super`]: memories, texts, panics.

use std::ffi::{CStr, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::slice;

use sha2::{Digest as _, Sha256};

use crate::files::VERSION;
use crate::impact::{Contact, Memory};

pub const VERSION_TEXT: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
    Ok(text) => text,
    Err(_) => c"",
};

/// The first bytes of a hash of a new contact. Later its values that are computed once and kept would change the hash.
pub fn fingerprint_of(contact: &Contact) -> u64 {
    let digest = Sha256::digest(format!("{VERSION} {contact:?}"));
    digest.iter().take(8).fold(0, |sum, byte| sum << 8 | u64::from(*byte))
}

/// The force at an indentation; a new largest state is put into the memory.
pub fn force(contact: &Contact, indentation: f64, memory: &mut [f64; 3]) -> f64 {
    let mut after = from_doubles(memory);
    let force = contact.force(indentation, &mut after);
    *memory = [after.indentation, after.force, after.elastic_approach];
    force
}

pub fn from_doubles([indentation, force, elastic_approach]: &[f64; 3]) -> Memory {
    Memory { indentation: *indentation, force: *force, elastic_approach: *elastic_approach }
}

/// Runs `work`; if it panics, returns `otherwise`, so that no panic reaches the caller in C.
pub fn catch_panic<T>(otherwise: T, work: impl FnOnce() -> T) -> T {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or(otherwise)
}

/// Writes as many whole characters of a text as fit, and a final zero.
///
/// # Safety
/// `to` is NULL or has `length` bytes.
pub unsafe fn write_text(text: &str, to: *mut c_char, length: usize) {
    if to.is_null() || length == 0 {
        return;
    }
    let ends = text.char_indices().map(|(start, character)| start + character.len_utf8());
    let room = ends.take_while(|end| *end < length).last().unwrap_or(0);
    // SAFETY: `room` + 1 bytes are at most `length`
    let to = unsafe { slice::from_raw_parts_mut(to.cast::<u8>(), length) };
    to[..room].copy_from_slice(&text.as_bytes()[..room]);
    to[room] = 0;
}
