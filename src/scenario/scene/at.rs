//! Keys that the source names: the compiler looks their paths up, `at!("sphere.radius")`.

use super::{EVERY_KEY, Form};

/// The place of a key in the list, with the kind of its value as a type, so that it is not asked for a value of another kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct At<const KIND: u8>(usize);

/// The kinds of values: a number, a whole number, a word, and all else.
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
    /// The key at this place, if its value is of this kind.
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

/// The place of a key that is written in the source. Only constants are made of it: a path that is no key is an error of
/// the compiler.
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

/// The place of the key of this path, which the compiler looks up.
macro_rules! at {
    ($path:literal) => {
        const { $crate::scenario::scene::at::known($path) }
    };
}
pub(crate) use at;

/// The place of a key that sphere and half-space have, by the name behind that of the body: `key_of!(body, "hardness")`.
macro_rules! key_of {
    ($body:expr, $name:literal) => {
        $body.pick([
            const { $crate::scenario::scene::known(concat!("sphere.", $name)) },
            const { $crate::scenario::scene::known(concat!("half_space.", $name)) },
        ])
    };
}
pub(crate) use key_of;
