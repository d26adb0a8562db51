//! How the tables of a scenario are described once: a table is a struct, and the doc comment of a field is the line of its
//! key on the reference page and in the schema. Reading, ranges, words and "did you mean" follow from the [`Form`] beside it.

use toml::de::DeValue;

use super::field::{Field, Held};
use super::key::{AnyKey, Form};
use super::read::{Fault, Reader, items, word};
use super::written::{Name, Node, below};

/// A key of a table.
pub struct Entry {
    /// As in the file.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// How its value is written.
    pub form: Form,
}

/// A table of a scenario, as a type.
pub trait Table: Sized + 'static {
    /// Its keys, in the order of the reference page.
    const ENTRIES: &'static [Entry];

    /// Their fields, in the same order.
    fn fields(&self) -> Vec<&dyn Field>;

    /// One of these fields, to be changed.
    fn field_mut(&mut self, at: usize) -> Option<&mut dyn Field>;

    /// Takes its keys, and gives back those that it has not.
    fn read_known<'n, 't>(
        &mut self,
        keys: impl IntoIterator<Item = (&'n Name<'t>, &'n Node<'t>)>,
        reader: &mut Reader,
    ) -> Vec<(&'n Name<'t>, &'n Node<'t>)> {
        let mut others = Vec::new();
        for (name, node) in keys {
            let at = Self::ENTRIES.iter().position(|entry| entry.name == name.get_ref());
            match at.and_then(|at| Some((&Self::ENTRIES[at], self.field_mut(at)?))) {
                Some((entry, field)) => reader.within(entry.name, |reader| field.read(&entry.form, node, reader)),
                None => others.push((name, node)),
            }
        }
        others
    }

    /// The names of its keys.
    fn names() -> Vec<&'static str> {
        Self::ENTRIES.iter().map(|entry| entry.name).collect()
    }
}

impl<T: Table> Field for T {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        if let (Form::WordOrTable(words), DeValue::String(_)) = (form, node.get_ref()) {
            return word(words, node).map(drop);
        }
        let others = self.read_known(items(node)?, reader);
        reader.unknown(others, &Self::names());
        Ok(())
    }
    fn at(&self, at: usize) -> Option<&dyn Field> {
        self.fields().get(at).copied()
    }
    fn at_mut(&mut self, at: usize) -> Option<&mut dyn Field> {
        self.field_mut(at)
    }
    fn keys(&self, path: &str, way: &[usize], into: &mut Vec<AnyKey>) {
        for (at, (&Entry { name, about, default, form }, field)) in Self::ENTRIES.iter().zip(self.fields()).enumerate()
        {
            let (path, way) = (below(path, name), [way, &[at]].concat());
            if !matches!(form, Form::Table | Form::Items(..)) {
                into.push(AnyKey { path: path.clone().leak(), form, about, default, way: way.clone().leak() });
            }
            field.keys(&path, &way, into);
        }
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        for (entry, field) in Self::ENTRIES.iter().zip(self.fields()) {
            field.show(&entry.form, &below(path, entry.name), into);
        }
    }
}

/// The keys of structs: name of the key (and of the field, where that is another), the form of its value, and its default in
/// words.
macro_rules! keys {
    ($($table:ident { $($(#[doc = $about:literal])+ $name:ident $(in $field:ident)?: $form:expr $(=> $default:literal)?,)* })*) => {$(
        impl $crate::scene::table::Table for $table {
            const ENTRIES: &'static [$crate::scene::table::Entry] = &[$($crate::scene::table::Entry {
                name: stringify!($name),
                about: concat!($($about),+).trim_ascii_start(),
                default: concat!($($default)?),
                form: $form,
            }),*];
            fn fields(&self) -> Vec<&dyn $crate::scene::field::Field> {
                vec![$(&$crate::scene::table::keys!(@ self, $name $($field)?)),*]
            }
            #[allow(unused)] // a table without keys
            fn field_mut(&mut self, at: usize) -> Option<&mut dyn $crate::scene::field::Field> {
                let mut numbers = 0..;
                $(if numbers.next() == Some(at) {
                    return Some(&mut $crate::scene::table::keys!(@ self, $name $($field)?));
                })*
                None
            }
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
        #[derive(Debug, Clone, Default, PartialEq)]
        $vis struct $table { $($(#[doc = $about])+ pub $name: $type),* })*

        $crate::scene::table::keys! { $($table { $($(#[doc = $about])+ $name: $form $(=> $default)?,)* })* }
    };
}
pub(crate) use tables;
