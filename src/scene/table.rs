//! How the tables of a scenario are described once: a table is a struct, and the doc comment of a field is the line of its
//! key on the reference page and in the schema. Reading, ranges, words and "did you mean" follow from the [`Form`] beside it.

use std::fmt;

use super::field::{Field, Given, Held};
use super::key::{AnyKey, Form};
use super::quantity::Quantity;
use super::read::{Fault, Reader, items};
use super::written::Node;

/// A key of a table that is a `T`.
pub struct Entry<T> {
    /// As in the file.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// How its value is written.
    pub form: Form,
    /// Takes a value.
    pub read: fn(&mut T, &Form, &Node, &mut Reader) -> Result<(), Fault>,
    /// The number that it has, for a key that may vary.
    pub get: fn(&T) -> Option<Given>,
    /// Puts a checked number there, SI, or nothing.
    pub set: fn(&mut T, Option<f64>),
    /// Adds what it has, for reports.
    pub show: fn(&T, &Form, &str, &mut Vec<Held>),
}

/// A table of a scenario, as a type.
pub trait Table: Sized + 'static {
    /// Its keys, in the order of the reference page.
    const ENTRIES: &'static [Entry<Self>];

    /// Takes the keys of a table of the file.
    fn take(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        for item in &items(node)?.0 {
            if let Some(entry) = Self::ENTRIES.iter().find(|entry| entry.name == item.name) {
                reader.within(entry.name, |reader| (entry.read)(self, &entry.form, &item.node, reader));
            } else {
                let known: Vec<&str> = Self::ENTRIES.iter().map(|entry| entry.name).collect();
                reader.unknown(&item.name, item.span.clone(), &known);
            }
        }
        Ok(())
    }

    /// Adds what its keys have, for reports; the path is that of the table.
    fn show_keys(&self, path: &str, into: &mut Vec<Held>) {
        for entry in Self::ENTRIES {
            (entry.show)(self, &entry.form, &format!("{path}.{}", entry.name), into);
        }
    }

    /// Its keys, for a table of this path.
    fn keys(path: &str, into: &mut Vec<AnyKey>) {
        for &Entry { name, about, default, form, .. } in Self::ENTRIES {
            let path = if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
            if !matches!(form, Form::Table(_) | Form::Items(..)) {
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

impl<T: Table> Field for T {
    fn read(&mut self, _: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        self.take(node, reader)
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        self.show_keys(path, into);
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
        let (quantity, word) = match entry.form {
            Form::Number(quantity) => (quantity, None),
            Form::NumberOr(quantity, word) => (quantity, Some(word)),
            _ => return None,
        };
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

/// The keys of structs: name of the key (and of the field, where that is another), the form of its value, and its default in
/// words.
macro_rules! keys {
    ($($table:ident { $($(#[doc = $about:literal])+ $name:ident $(in $field:ident)?: $form:expr $(=> $default:literal)?,)* })*) => {$(
        impl $crate::scene::table::Table for $table {
            const ENTRIES: &'static [$crate::scene::table::Entry<Self>] = &[$($crate::scene::table::Entry {
                name: stringify!($name),
                about: concat!($($about),+).trim_ascii_start(),
                default: concat!($($default)?),
                form: $form,
                read: |table, form, node, reader| {
                    $crate::scene::field::Field::read(&mut $crate::scene::table::keys!(@ table, $name $($field)?), form, node, reader)
                },
                get: |table| $crate::scene::field::Field::given(&$crate::scene::table::keys!(@ table, $name $($field)?)),
                set: |table, value| {
                    $crate::scene::field::Field::put(&mut $crate::scene::table::keys!(@ table, $name $($field)?), value);
                },
                show: |table, form, path, into| {
                    $crate::scene::field::Field::show(&$crate::scene::table::keys!(@ table, $name $($field)?), form, path, into);
                },
            }),*];
        }
    )*};
    (@ $table:ident, $name:ident) => { $table.$name };
    (@ $table:ident, $name:ident $field:ident) => { $table.$field };
}
pub(crate) use keys;

/// Tables of a scenario: structs with their keys.
macro_rules! tables {
    ($($(#[$meta:meta])* $vis:vis struct $table:ident {
        $($(#[doc = $about:literal])+ $name:ident: $type:ty as $form:expr $(=> $default:literal)?,)*
    })*) => {
        $($(#[$meta])*
        #[derive(Debug, Clone, Default)]
        $vis struct $table { $($(#[doc = $about])+ pub $name: $type),* })*

        $crate::scene::table::keys! { $($table { $($(#[doc = $about])+ $name: $form $(=> $default)?,)* })* }
    };
}
pub(crate) use tables;
