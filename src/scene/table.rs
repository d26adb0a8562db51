//! How the tables of a scenario are described once: a table is a struct, and the doc comment of a field is the line of its
//! key on the reference page and in the schema. Reading, ranges, words and "did you mean" follow from the [`Form`] beside it.

use toml::de::DeValue;

use super::field::{Field, Held, Numeric};
use super::key::{AnyKey, Form};
use super::read::{Fault, Reader, items, word};
use super::written::{Name, Node, below};

/// A key of a table that is a `T`.
pub struct Entry<T: 'static> {
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
    /// The numeric keys that it is or has.
    pub numeric: fn(&'static Self) -> Vec<Numeric<T>>,
    /// Adds what it has, for reports.
    pub show: fn(&T, &Form, &str, &mut Vec<Held>),
}

/// A table of a scenario, as a type.
pub trait Table: Sized + 'static {
    /// Its keys, in the order of the reference page.
    const ENTRIES: &'static [Entry<Self>];

    /// Takes its keys, and gives back those that it has not.
    fn read_known<'n, 't>(
        &mut self,
        keys: impl IntoIterator<Item = (&'n Name<'t>, &'n Node<'t>)>,
        reader: &mut Reader,
    ) -> Vec<(&'n Name<'t>, &'n Node<'t>)> {
        let mut others = Vec::new();
        for (name, node) in keys {
            match Self::ENTRIES.iter().find(|entry| entry.name == name.get_ref()) {
                Some(entry) => reader.within(entry.name, |reader| (entry.read)(self, &entry.form, node, reader)),
                None => others.push((name, node)),
            }
        }
        others
    }

    /// The names of its keys.
    fn names() -> Vec<&'static str> {
        Self::ENTRIES.iter().map(|entry| entry.name).collect()
    }

    /// Adds what its keys have, for reports; the path is that of the table.
    fn show_keys(&self, path: &str, into: &mut Vec<Held>) {
        for entry in Self::ENTRIES {
            (entry.show)(self, &entry.form, &below(path, entry.name), into);
        }
    }

    /// Its keys, for a table of this path.
    fn keys(path: &str, into: &mut Vec<AnyKey>) {
        for &Entry { name, about, default, form, .. } in Self::ENTRIES {
            let path = below(path, name);
            if !matches!(form, Form::Table(_) | Form::Items(..)) {
                into.push(AnyKey { path: path.clone().leak(), form, about, default });
            }
            match form {
                Form::Table(inner) | Form::WordOrTable(_, inner) => inner(&path, into),
                Form::Items(.., inner) => inner(&format!("{path}[]"), into),
                _ => {}
            }
        }
    }
}

impl<T: Table> Field for T {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        if let (Form::WordOrTable(words, _), DeValue::String(_)) = (form, node.get_ref()) {
            return word(words, node).map(drop);
        }
        let others = self.read_known(items(node)?, reader);
        reader.unknown(others, &Self::names());
        Ok(())
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        self.show_keys(path, into);
    }
    fn numeric() -> Vec<Numeric<Self>> {
        Self::ENTRIES.iter().flat_map(|entry| (entry.numeric)(entry)).collect()
    }
}

/// The numeric keys of an entry, whose field is found so.
pub fn numeric<T: 'static, F: Field + 'static>(
    entry: &'static Entry<T>,
    of: impl Fn(&T) -> &F + Copy + Send + Sync + 'static,
    of_mut: impl Fn(&mut T) -> &mut F + Copy + Send + Sync + 'static,
) -> Vec<Numeric<T>> {
    let Some((quantity, word)) = entry.form.number() else {
        let inner = |key: Numeric<F>| key.within(entry.name, move |t| Some(of(t)), move |t| Some(of_mut(t)));
        return F::numeric().into_iter().map(inner).collect();
    };
    let get = Box::new(move |table: &T| of(table).given());
    let set = Box::new(move |table: &mut T, value| of_mut(table).put(value));
    vec![Numeric { path: entry.name, quantity, word, get, set }]
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
                numeric: |entry| $crate::scene::table::numeric(
                    entry,
                    |table| &$crate::scene::table::keys!(@ table, $name $($field)?),
                    |table| &mut $crate::scene::table::keys!(@ table, $name $($field)?),
                ),
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
