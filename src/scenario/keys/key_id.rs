//! Keys that are named in the source: the compiler finds their paths, `at!("sphere.radius")`.

use super::{EVERY_KEY, Form};

/// The index of a key in the list. The kind of its value is part of the type, so the compiler refuses a value of another kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct At<const KIND: u8>(usize);

/// The kinds of values: number, whole number, word, and other values.
pub const NUMBER: u8 = 0;
pub const COUNT: u8 = 1;
pub const WORD: u8 = 2;
pub const OTHER: u8 = 3;

const fn kind(place: usize) -> u8 {
    match EVERY_KEY[place].form {
        Form::Number(_) | Form::NumberOr(..) => NUMBER,
        Form::Count(_) => COUNT,
        Form::Word(_) => WORD,
        _ => OTHER,
    }
}

impl<const KIND: u8> At<KIND> {
    /// The key with this index, if its value is of this kind.
    pub const fn new(place: usize) -> Option<Self> {
        if kind(place) == KIND { Some(Self(place)) } else { None }
    }

    pub const fn path(self) -> &'static str {
        EVERY_KEY[self.0].path
    }

    #[inline]
    pub const fn place(self) -> usize {
        self.0
    }
}

/// The index of a key that is named in the source. It is used in constants only, so a path that is no key is a compile error.
pub const fn known<const KIND: u8>(path: &str) -> At<KIND> {
    let (mut at, path) = (0, path.as_bytes());
    while at < EVERY_KEY.len() {
        let known = EVERY_KEY[at].path.as_bytes();
        let mut i = 0;
        while i < known.len() && i < path.len() && known[i] == path[i] {
            i += 1;
        }
        if i == known.len()
            && i == path.len()
            && let Some(found) = At::new(at)
        {
            return found;
        }
        at += 1;
    }
    panic!("there is no key of this path, or its value is of another kind")
}

/// The index of the key with this path, found by the compiler.
macro_rules! at {
    ($path:literal) => {
        const { $crate::scenario::keys::key_id::known($path) }
    };
}
pub(crate) use at;

/// The index of a key that sphere and half-space both have, by its name without the body: `key_of!(body, "hardness")`.
macro_rules! key_of {
    ($body:expr, $name:literal) => {
        $body.pick([
            const { $crate::scenario::keys::known(concat!("sphere.", $name)) },
            const { $crate::scenario::keys::known(concat!("half_space.", $name)) },
        ])
    };
}
pub(crate) use key_of;
