//! How the tables of a scenario are described once: a table is a struct, and the doc comment of a field is the line of its
//! key on the reference page and in the schema. Reading, ranges, words and "did you mean" follow from the types.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use super::key::{AnyKey, Form, List, Words};
use super::quantity::{Kind, Quantity};
use super::written::{Node, Table as Written, Value};
use crate::units::nearest::did_you_mean;

/// A value that is refused: where it stands, and why.
#[derive(Debug, Clone)]
pub struct Fault {
    /// Where.
    pub span: Range<usize>,
    /// Value, allowed range, way out.
    pub message: String,
}

impl Fault {
    /// A refusal of what stands there.
    pub fn at(node: &Node, message: impl Into<String>) -> Self {
        Self { span: node.span.clone(), message: message.into() }
    }

    /// The refusal of a value of the wrong kind.
    pub fn unexpected(node: &Node, expected: &str) -> Self {
        Self::at(node, format!("found {}, expected {expected}", node.described()))
    }
}

/// Reads the file of this name, relative to the scenario, which the key of this path names: its path and its text.
pub type Files<'f> = &'f mut dyn FnMut(&str, &str) -> Result<[String; 2], String>;

/// Goes through the tables of a scenario and collects what is refused.
pub struct Reader<'f> {
    /// The table or key that is read, with dots.
    pub path: String,
    /// Keys whose value or name is refused.
    pub refused: Vec<(String, Fault)>,
    files: Files<'f>,
}

impl<'f> Reader<'f> {
    /// A reader at the top of a scenario.
    pub fn new(files: Files<'f>) -> Self {
        Self { path: String::new(), refused: Vec::new(), files }
    }

    /// Reads what stands below this name; a refusal is kept.
    pub fn within(&mut self, name: &str, read: impl FnOnce(&mut Self) -> Result<(), Fault>) {
        let outer = self.path.len();
        if !self.path.is_empty() && !name.starts_with('[') {
            self.path.push('.');
        }
        self.path.push_str(name);
        if let Err(fault) = read(self) {
            self.refused.push((self.path.clone(), fault));
        }
        self.path.truncate(outer);
    }

    /// Path and text of the file that this key names.
    pub fn file(&mut self, node: &Node, name: &str) -> Result<[String; 2], Fault> {
        (self.files)(&self.path, name).map_err(|message| Fault::at(node, message))
    }

    /// Refuses a key that the table has not; `known` are the names of those that it has.
    pub fn unknown(&mut self, name: &str, span: Range<usize>, known: &[&str]) {
        let (thing, things) = match self.path.as_str() {
            "" => ("table", "tables"),
            "law" => ("law", "laws"),
            _ => ("key", "keys here"),
        };
        let message = if known.is_empty() {
            format!("unknown {thing} `{name}`; this table takes none")
        } else {
            let all = format!("{things} are {}", known.join(", "));
            format!("unknown {thing} `{name}`{}", did_you_mean(name, known.iter().copied(), '`', &all))
        };
        self.within(name, |_| Err(Fault { span, message }));
    }
}

/// A number of a key, or the word in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// In SI.
    Number(f64),
    /// The word.
    Word,
}

/// A field of a table.
pub trait Field: Default {
    /// How its value is written.
    fn form() -> Form;
    /// Takes the value that stands there.
    fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault>;
    /// The number that it has, for a key that may vary.
    fn given(&self) -> Option<Given> {
        None
    }
    /// Puts a checked number there, SI, or nothing.
    fn put(&mut self, _: Option<f64>) {}
}

/// A value that a key may hold.
pub trait Scalar: Sized {
    /// How it is written.
    fn form() -> Form;
    /// The value that stands there.
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault>;
    /// As a number of a key that may vary.
    fn given(&self) -> Option<Given> {
        None
    }
    /// From such a number, SI.
    fn of(_: f64) -> Option<Self> {
        None
    }
}

impl<T: Scalar> Field for Option<T> {
    fn form() -> Form {
        T::form()
    }
    fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        *self = Some(T::read(node, reader)?);
        Ok(())
    }
    fn given(&self) -> Option<Given> {
        self.as_ref()?.given()
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.and_then(T::of);
    }
}

/// A number in SI, read as a quantity: plain, or as a text with a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number<K>(pub f64, PhantomData<K>);

impl<K: Kind> Scalar for Number<K> {
    fn form() -> Form {
        Form::Number(K::QUANTITY, None)
    }
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        number(K::QUANTITY, None, node).map(|value| Self(value, PhantomData))
    }
    fn given(&self) -> Option<Given> {
        Some(Given::Number(self.0))
    }
    fn of(value: f64) -> Option<Self> {
        Some(Self(value, PhantomData))
    }
}

impl<K> From<Number<K>> for f64 {
    fn from(number: Number<K>) -> Self {
        number.0
    }
}

impl<K> From<Number<K>> for Option<f64> {
    fn from(number: Number<K>) -> Self {
        Some(number.0)
    }
}

/// A word that may stand in place of a number.
pub trait Special: 'static {
    /// The word.
    const WORD: &'static str;
}

/// A number, or a word in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Or<K, W> {
    /// In SI.
    Number(Number<K>),
    /// The word.
    Word(PhantomData<W>),
}

impl<K: Kind, W: Special> Scalar for Or<K, W> {
    fn form() -> Form {
        Form::Number(K::QUANTITY, Some(W::WORD))
    }
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        match &node.value {
            Value::Text(text) if text.trim() == W::WORD => Ok(Self::Word(PhantomData)),
            _ => number(K::QUANTITY, Some(W::WORD), node).map(|value| Self::Number(Number(value, PhantomData))),
        }
    }
    fn given(&self) -> Option<Given> {
        Some(match self {
            Self::Number(number) => Given::Number(number.0),
            Self::Word(_) => Given::Word,
        })
    }
    fn of(value: f64) -> Option<Self> {
        Some(Self::Number(Number(value, PhantomData)))
    }
}

/// A whole number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count<K>(pub u64, PhantomData<K>);

impl<K> Count<K> {
    /// This count.
    pub fn new(count: u64) -> Self {
        Self(count, PhantomData)
    }
}

impl<K: Kind> Scalar for Count<K> {
    fn form() -> Form {
        Form::Count(K::QUANTITY)
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and below 2^64
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        const TOO_MANY: f64 = 18_446_744_073_709_551_616.0;
        let value = number(K::QUANTITY, None, node)?;
        let whole = match node.value {
            Value::Number { whole: Some(whole), .. } => whole,
            _ if value.fract() == 0.0 && value < TOO_MANY => value as u64,
            _ => {
                let message = format!("{value} is not allowed: {} must be a whole number below 2^64", K::QUANTITY.name);
                return Err(Fault::at(node, message));
            }
        };
        Ok(Self(whole, PhantomData))
    }
}

impl<K: Kind> Scalar for Vec<Number<K>> {
    fn form() -> Form {
        Form::Numbers(K::QUANTITY)
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        list(node, &format!("[{}]", K::QUANTITY.example))?.iter().map(|item| Number::read(item, reader)).collect()
    }
}

/// Pairs of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Pairs<A, B>(pub Vec<[f64; 2]>, PhantomData<(A, B)>);

impl<A: Kind, B: Kind> Scalar for Pairs<A, B> {
    fn form() -> Form {
        Form::Pairs(A::QUANTITY, B::QUANTITY)
    }
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        let example = format!("[{}, {}]", A::QUANTITY.example, B::QUANTITY.example);
        let pair = |item: &Node| match list(item, &example)? {
            [one, other] => Ok([number(A::QUANTITY, None, one)?, number(B::QUANTITY, None, other)?]),
            items => Err(Fault::at(item, format!("has {} numbers; write two, such as {example}", items.len()))),
        };
        let pairs = list(node, &format!("[{example}]"))?.iter().map(pair).collect::<Result<_, _>>()?;
        Ok(Self(pairs, PhantomData))
    }
}

/// Words as a type: what a [`Word`] is one of.
pub trait OneOf: 'static {
    /// All of them.
    const WORDS: &'static Words;
}

/// One of some words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word<W> {
    /// The word.
    pub name: String,
    of: PhantomData<W>,
}

impl<W: OneOf> Scalar for Word<W> {
    fn form() -> Form {
        Form::Word(W::WORDS)
    }
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        word(W::WORDS, node).map(|name| Self { name, of: PhantomData })
    }
}

impl<W: OneOf> Scalar for Vec<Word<W>> {
    fn form() -> Form {
        Form::WordList(W::WORDS)
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let example = (W::WORDS.known)().first().cloned().unwrap_or_default();
        list(node, &format!("[\"{example}\"]"))?.iter().map(|item| Word::read(item, reader)).collect()
    }
}

/// An example of a text.
pub trait Example: 'static {
    /// The text.
    const EXAMPLE: &'static str;
}

/// Any text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Text<E>(pub String, PhantomData<E>);

impl<E: Example> Scalar for Text<E> {
    fn form() -> Form {
        Form::Text(E::EXAMPLE)
    }
    fn read(node: &Node, _: &mut Reader) -> Result<Self, Fault> {
        text(node, E::EXAMPLE).map(|text| Self(text.to_owned(), PhantomData))
    }
}

/// A number in SI, or a text with a unit. `word` may stand in its place; it is read before.
pub fn number(quantity: &Quantity, word: Option<&str>, node: &Node) -> Result<f64, Fault> {
    let or_word = word.map_or_else(String::new, |word| format!(", or \"{word}\""));
    match &node.value {
        Value::Text(text) => {
            let or_write = word.map_or_else(String::new, |word| format!("; or write \"{word}\""));
            quantity.parse(text).map_err(|message| Fault::at(node, format!("{message}{or_write}")))
        }
        Value::Number { value: Some(value), .. } => quantity.plain(*value).map_err(|message| Fault::at(node, message)),
        _ => Err(Fault::unexpected(node, &format!("{} such as {}{or_word}", quantity.name, quantity.example))),
    }
}

/// The items of a list.
pub fn list<'n>(node: &'n Node, example: &str) -> Result<&'n [Node], Fault> {
    match &node.value {
        Value::List(items) => Ok(items),
        _ => Err(Fault::unexpected(node, &format!("a list in [ ] such as {example}"))),
    }
}

/// Any text.
pub fn text<'n>(node: &'n Node, example: &str) -> Result<&'n str, Fault> {
    match &node.value {
        Value::Text(text) => Ok(text),
        _ => Err(Fault::unexpected(node, &format!("a text in quotes such as \"{example}\""))),
    }
}

/// A word that is known.
pub fn word(words: &Words, node: &Node) -> Result<String, Fault> {
    let known = (words.known)();
    let given = text(node, known.first().map_or("", String::as_str))?;
    if known.iter().any(|word| word == given) {
        return Ok(given.to_owned());
    }
    let all: Vec<String> = known.iter().map(|word| format!("\"{word}\"")).collect();
    let all = format!("{} are {}", words.several, all.join(", "));
    let hint = did_you_mean(given, known.iter().map(String::as_str), '"', &all);
    Err(Fault::at(node, format!("unknown {} \"{given}\"{hint}", words.one)))
}

/// The items of a table.
pub fn items(node: &Node) -> Result<&Written, Fault> {
    match &node.value {
        Value::Table(table) => Ok(table),
        _ => Err(Fault::unexpected(node, "a table")),
    }
}

/// A key of a table that is a `T`.
pub struct Entry<T> {
    /// As in the file.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// How its value is written.
    pub form: fn() -> Form,
    /// Takes a value.
    pub read: fn(&mut T, &Node, &mut Reader) -> Result<(), Fault>,
    /// The number that it has, for a key that may vary.
    pub get: fn(&T) -> Option<Given>,
    /// Puts a checked number there, SI, or nothing.
    pub set: fn(&mut T, Option<f64>),
}

/// A table of a scenario, as a type.
pub trait Table: Sized + 'static {
    /// Its keys, in the order of the reference page.
    const ENTRIES: &'static [Entry<Self>];

    /// Takes the keys of a table of the file.
    fn take(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        for item in &items(node)?.0 {
            if let Some(entry) = Self::ENTRIES.iter().find(|entry| entry.name == item.name) {
                reader.within(entry.name, |reader| (entry.read)(self, &item.node, reader));
            } else {
                let known: Vec<&str> = Self::ENTRIES.iter().map(|entry| entry.name).collect();
                reader.unknown(&item.name, item.span.clone(), &known);
            }
        }
        Ok(())
    }

    /// Its keys, for a table of this path.
    fn keys(path: &str, into: &mut Vec<AnyKey>) {
        for entry in Self::ENTRIES {
            let path = if path.is_empty() { entry.name.to_owned() } else { format!("{path}.{}", entry.name) };
            let form = (entry.form)();
            if !matches!(form, Form::Table(_) | Form::Items(..)) {
                let &Entry { about, default, .. } = entry;
                into.push(AnyKey { path: path.clone().leak(), form, about, default });
            }
            match form {
                Form::Table(inner) | Form::WordOrTable(_, inner) => inner(&path, into),
                Form::Items(_, inner) => inner(&format!("{path}[]"), into),
                _ => {}
            }
        }
    }
}

/// Reads a number.
type Get<I> = Box<dyn Fn(&I) -> Option<Given> + Send + Sync>;
/// Sets a number, or takes it away.
type Set<I> = Box<dyn Fn(&mut I, Option<f64>) + Send + Sync>;

/// A numeric key of an `I`, which may vary: an axis, a random variable, or found from measurements.
pub struct Numeric<I> {
    /// As in the file, with dots: `impact.speed`.
    pub path: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// A word that may stand in place of the number.
    pub word: Option<&'static str>,
    /// Its number; `None` where it is not given.
    pub get: Get<I>,
    /// Puts a checked number there, SI, or takes it away. It changes nothing else.
    pub set: Set<I>,
}

impl<I> fmt::Debug for Numeric<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.path)
    }
}

/// The numeric keys of a table that an `I` may have.
pub fn numeric<I: 'static, T: Table>(
    path: &str,
    of: fn(&I) -> Option<&T>,
    of_mut: fn(&mut I) -> Option<&mut T>,
) -> Vec<Numeric<I>> {
    let key = |entry: &'static Entry<T>| {
        let Form::Number(quantity, word) = (entry.form)() else { return None };
        Some(Numeric {
            path: format!("{path}.{}", entry.name).leak(),
            quantity,
            word,
            get: Box::new(move |input: &I| (entry.get)(of(input)?)),
            set: Box::new(move |input: &mut I, value| {
                // a table is made for a number, but not to say that there is none
                if value.is_none() && of(input).is_none() {
                    return;
                }
                if let Some(table) = of_mut(input) {
                    (entry.set)(table, value);
                }
            }),
        })
    };
    T::ENTRIES.iter().filter_map(key).collect()
}

/// A table whose items stand in a list.
pub trait Listed: Table + Default {
    /// How the list is written.
    const LIST: &'static List;
}

/// A list of tables.
#[derive(Debug, Clone, Default)]
pub struct Items<T>(pub Option<Vec<T>>);

impl<T: Listed> Field for Items<T> {
    fn form() -> Form {
        Form::Items(T::LIST, T::keys)
    }
    fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let Value::List(items) = &node.value else {
            return Err(Fault::unexpected(node, &format!("a list of tables: {}", T::LIST.example)));
        };
        let mut all = Vec::new();
        for (i, item) in items.iter().enumerate() {
            let mut one = T::default();
            reader.within(&format!("[{i}]"), |reader| match item.value {
                Value::Table(_) => one.take(item, reader),
                _ => Err(Fault::unexpected(item, T::LIST.item)),
            });
            all.push(one);
        }
        self.0 = Some(all);
        Ok(())
    }
}

impl<T: Table + Default> Field for T {
    fn form() -> Form {
        Form::Table(T::keys)
    }
    fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        self.take(node, reader)
    }
}

impl<T: Table + Default> Scalar for T {
    fn form() -> Form {
        Form::Table(T::keys)
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let mut table = Self::default();
        table.take(node, reader)?;
        Ok(table)
    }
}

/// Tables of a scenario: structs with their keys.
macro_rules! tables {
    ($($(#[$meta:meta])* $vis:vis struct $table:ident {
        $($(#[doc = $about:literal])+ $name:ident: $type:ty $(= $default:literal)?,)*
    })*) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Default)]
        $vis struct $table { $($(#[doc = $about])+ pub $name: $type),* }

        impl $crate::scene::field::Table for $table {
            const ENTRIES: &'static [$crate::scene::field::Entry<Self>] = &[$($crate::scene::field::Entry {
                name: stringify!($name),
                about: concat!($($about),+).trim_ascii_start(),
                default: concat!($($default)?),
                form: <$type as $crate::scene::field::Field>::form,
                read: |table, node, reader| $crate::scene::field::Field::read(&mut table.$name, node, reader),
                get: |table| $crate::scene::field::Field::given(&table.$name),
                set: |table, value| $crate::scene::field::Field::put(&mut table.$name, value),
            }),*];
        }
    )*};
}
pub(crate) use tables;

/// The keys of types that are defined elsewhere: the name of a key, the field, and as what its value is read.
macro_rules! keys {
    ($($table:ident {
        $($(#[doc = $about:literal])+ $name:ident => $field:ident: $type:ty $(= $default:literal)?,)*
    })*) => {$(
        impl $crate::scene::field::Table for $table {
            const ENTRIES: &'static [$crate::scene::field::Entry<Self>] = &[$($crate::scene::field::Entry {
                name: stringify!($name),
                about: concat!($($about),+).trim_ascii_start(),
                default: concat!($($default)?),
                form: <$type as $crate::scene::field::Scalar>::form,
                read: |table, node, reader| {
                    table.$field = <$type as $crate::scene::field::Scalar>::read(node, reader)?.into();
                    Ok(())
                },
                get: |table| $crate::scene::field::Shown::shown(&table.$field),
                set: |table, value| {
                    if let Some(value) = value.and_then(<$type as $crate::scene::field::Scalar>::of) {
                        table.$field = value.into();
                    }
                },
            }),*];
        }
    )*};
}
pub(crate) use keys;

/// A field of a type that is defined elsewhere: the number that it has.
pub trait Shown {
    /// The number, for a key that may vary.
    fn shown(&self) -> Option<Given> {
        None
    }
}

impl Shown for f64 {
    fn shown(&self) -> Option<Given> {
        Some(Given::Number(*self))
    }
}

impl Shown for Option<f64> {
    fn shown(&self) -> Option<Given> {
        self.map(Given::Number)
    }
}
