//! What an entry of the registry of results is, and how values are written as JSON.

use std::fmt::Write as _;

use serde_json::{Map, Value};

use crate::impact::Essentials;
use crate::units::Dimension;

/// A result that is found from a `T`.
#[derive(Debug, Clone, Copy)]
pub struct Reported<T> {
    /// Its name, with the unit.
    pub name: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// How the terminal shows it.
    pub shown: Shown,
    /// The condition under which it is there; empty if it is always there.
    pub condition: &'static str,
    /// Its name on the terminal, or a remark on the line above. In a remark `{}` stands for the value, and `{%}` for
    /// its share of the value of that line. Empty: the terminal does not show the result.
    pub label: &'static str,
    /// Its value; `None` where it is left out.
    pub value: fn(&T) -> Option<Value>,
    /// The column of a table with this result.
    pub column: Option<Column>,
}

/// How the terminal shows a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// As it is.
    Plain,
    /// In this unit, with a prefix. The name of the result ends in the unit.
    In(Dimension),
    /// As a share in percent.
    Percent,
    /// As a deviation in percent, with its sign.
    Deviation,
    /// As an error, in powers of ten.
    Error,
}

/// The results of a file, or of a part of one, as Markdown for the reference page.
pub(crate) fn file<T>(title: &str, results: &[Reported<T>]) -> String {
    let mut text = format!("### {title}\n\n| name | meaning | when it is there |\n|---|---|---|\n");
    for Reported { name, about, condition, column, .. } in results {
        let mark = if column.is_some() { " \u{25a6}" } else { "" };
        let condition = if condition.is_empty() { "always" } else { condition };
        let _ = writeln!(text, "| `{name}`{mark} | {about} | {condition} |");
    }
    text + "\n"
}

/// What a scene must have for a column to be there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// Nothing: the column is in every table.
    Nothing,
    /// A yield strength: without one nothing is plastic.
    Strength,
    /// The yield strength of the sphere: without it there is no flat.
    Flat,
    /// The density of a half-space that is no plate: without it nothing is known of elastic waves.
    Density,
    /// The thickness of a plate.
    Thickness,
    /// An angle or a spin: without them nothing slides.
    Incidence,
    /// Air: without it heights follow from speeds.
    Air,
}

/// A column of a table.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its name, with the unit.
    pub name: &'static str,
    /// What the scene must have.
    pub needs: Needs,
    /// The value of a row; `None` is an empty field.
    pub value: fn(&Essentials) -> Option<f64>,
}

impl Needs {
    /// When an impact has the result, in words.
    pub const fn condition(self) -> &'static str {
        match self {
            Self::Nothing => "",
            Self::Strength => YIELDS,
            Self::Flat => FLATTENS,
            Self::Density => WAVES,
            Self::Thickness => PLATE,
            Self::Incidence => OBLIQUE,
            Self::Air => FLIES,
        }
    }
}

/// The values of all results that are there, by name. A name with a dot stands in a group: `energy.drift` is `drift` in `energy`.
pub fn fields<T>(results: &[Reported<T>], of: &T) -> Map<String, Value> {
    let mut all = Map::new();
    for Reported { name, value, .. } in results {
        let Some(value) = value(of) else { continue };
        match name.split_once('.') {
            None => drop(all.insert((*name).to_owned(), value)),
            Some((group, name)) => all.entry(group).or_insert_with(|| Map::new().into())[name] = value,
        }
    }
    all
}

/// The same of several things.
pub fn lists<'a, T: 'a>(results: &[Reported<T>], all: impl IntoIterator<Item = &'a T>) -> Value {
    all.into_iter().map(|one| fields(results, one)).collect()
}

pub(super) const YIELDS: &str = "a body has a yield strength";
pub(super) const FLATTENS: &str = "the sphere has a yield strength";
pub(super) const BAND: &str =
    "the half-space yields under the law `plm`, with an exponent whose error against finite elements is known";
pub(super) const WAVES: &str = "the half-space has a density; not under damping, on a plate, nor without a rebound";
pub(super) const OBLIQUE: &str = "the sphere comes in at an angle, or spins";
pub(super) const FLIES: &str = "there is gravity or a drop height; in tables only with air";
pub(super) const AIR: &str = "there is air";
pub(super) const FORCES: &str = "there is gravity, damping or a plate";
pub(super) const PLATE: &str = "a plate is hit";
pub(super) const GRAVITY: &str = "there is gravity";
pub(super) const DAMPING: &str = "there is damping";
pub(super) const VISCOUS: &str = "there is viscous damping";
pub(super) const TABLES: &str = "in tables only";
pub(crate) const OUTSIDE: &str = "there are such rows";
pub(crate) const RANDOM: &str = "the cases are random";
pub(super) const VERLET: &str = "the method is verlet";
pub(super) const BOUNCES: &str = "the sphere bounces under gravity";
pub(super) const CAPTURED: &str = "the sphere stays in its dent";
pub(super) const NAMED: &str = "the half-space has a name";
pub(super) const GIVEN: &str = "the step is given by it";

/// A list of results from its entries.
macro_rules! results {
    (|$of:ident: $type:ty| $($(#[doc = $about:literal])+ $name:literal
        $(in $shown:ident)? $(as $label:literal)? $(if $condition:ident)? $([$needs:ident: $column:expr])? $(: $value:expr)?;)+) => {
        vec![$($crate::scene::results::entry::Reported::<$type> {
            name: $name,
            about: concat!($($about),+).trim_ascii_start(),
            shown: results!(@shown $($shown)?),
            condition: results!(@condition [$($condition)?] [$($needs)?]),
            label: concat!($($label)?),
            #[allow(unused_variables)] // a result of tables alone has no value here
            value: |$of| results!(@value $of [$($condition)?] [$($needs, $column)?] [$($value)?]),
            column: results!(@column $($name, $needs, $column)?),
        }),+]
    };
    (@shown) => { $crate::scene::results::entry::Shown::Plain };
    (@shown Percent) => { $crate::scene::results::entry::Shown::Percent };
    (@shown Deviation) => { $crate::scene::results::entry::Shown::Deviation };
    (@shown Error) => { $crate::scene::results::entry::Shown::Error };
    (@shown $dimension:ident) => {
        $crate::scene::results::entry::Shown::In($crate::units::Dimension::$dimension)
    };
    (@condition [] []) => { "" };
    (@condition [] [$needs:ident]) => { $crate::scene::results::entry::Needs::$needs.condition() };
    (@condition [$condition:ident] [$($needs:ident)?]) => { $crate::scene::results::entry::$condition };
    (@value $of:ident [] [] [$value:expr]) => { Some($value.into()) };
    (@value $of:ident [$condition:ident] [] [$value:expr]) => { $value.map(Into::into) };
    (@value $of:ident [] [$needs:ident, $column:expr] []) => {
        $of.of_row($crate::scene::results::entry::Needs::$needs, $column)
    };
    (@value $of:ident [$condition:ident] [$needs:ident, $column:expr] []) => { None };
    (@column) => { None };
    (@column $name:literal, $needs:ident, $value:expr) => {{
        use $crate::scene::results::entry::{Column, Needs};
        Some(Column { name: $name, needs: Needs::$needs, value: $value })
    }};
}
pub(crate) use results;
