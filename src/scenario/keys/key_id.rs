//! Keys that are named in the source: the compiler finds their paths, `key!("sphere.radius")`.

use super::{ALL_KEYS, Part, Quantity, ValueForm};

/// The index of a key in the list. The kind of its value is part of the type, so the compiler refuses a value of another kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KeyId<const KIND: u8>(usize);

/// The kinds of values: number, whole number or flag, word, and other values.
pub const NUMBER: u8 = 0;
pub const COUNT: u8 = 1;
pub const WORD: u8 = 2;
pub const OTHER: u8 = 3;

const fn kind_of(place: usize) -> u8 {
    match ALL_KEYS[place].form {
        ValueForm::Number(_) | ValueForm::NumberOr(..) => NUMBER,
        ValueForm::Count(_) | ValueForm::Flag => COUNT,
        ValueForm::Word(_) => WORD,
        _ => OTHER,
    }
}

impl<const KIND: u8> KeyId<KIND> {
    /// The key with this index, if its value is of this kind.
    pub const fn new(place: usize) -> Option<Self> {
        if kind_of(place) == KIND { Some(Self(place)) } else { None }
    }

    pub const fn path(self) -> &'static str {
        ALL_KEYS[self.0].path
    }

    #[inline]
    pub const fn index(self) -> usize {
        self.0
    }
}

impl KeyId<NUMBER> {
    pub const fn part(self) -> Part {
        ALL_KEYS[self.0].part
    }

    /// Dimension and allowed range.
    pub const fn quantity(self) -> &'static Quantity {
        match ALL_KEYS[self.0].form {
            ValueForm::Number(quantity) | ValueForm::NumberOr(quantity, _) => quantity,
            _ => panic!("a key of this kind is a number"),
        }
    }

    /// A word that may replace the number.
    pub const fn alternative_word(self) -> Option<&'static str> {
        if let ValueForm::NumberOr(_, word) = ALL_KEYS[self.0].form { Some(word) } else { None }
    }

    /// The name of its column in tables, with its unit: `impact_speed_m_per_s`.
    pub fn column_name(self) -> String {
        format!("{}{}", self.path().replace('.', "_"), self.quantity().dimension.suffix())
    }
}

/// The index of a key that is named in the source. It is used in constants only, so a path that is no key is a compile error.
pub const fn find_key<const KIND: u8>(path: &str) -> KeyId<KIND> {
    let (mut at, path) = (0, path.as_bytes());
    while at < ALL_KEYS.len() {
        let known = ALL_KEYS[at].path.as_bytes();
        let mut i = 0;
        while i < known.len() && i < path.len() && known[i] == path[i] {
            i += 1;
        }
        if i == known.len()
            && i == path.len()
            && let Some(found) = KeyId::new(at)
        {
            return found;
        }
        at += 1;
    }
    panic!("there is no key of this path, or its value is of another kind")
}

/// The index of the key with this path, found by the compiler.
macro_rules! key {
    ($path:literal) => {
        const { $crate::scenario::keys::key_id::find_key($path) }
    };
}
pub(crate) use key;

/// The index of a key that sphere and half-space both have, by its name without the body: `body_key!(body, "hardness")`.
macro_rules! body_key {
    ($body:expr, $name:literal) => {
        $body.select([
            const { $crate::scenario::keys::find_key(concat!("sphere.", $name)) },
            const { $crate::scenario::keys::find_key(concat!("half_space.", $name)) },
        ])
    };
}
pub(crate) use body_key;
