//! An entry of the registry of results, and its value as JSON.

use serde_json::{Map, Value};

use super::hardness_scales::ImpactBody;
use crate::impact::{Contact, ImpactRow, WaveguideKind};
use crate::units::Dimension;

/// A result that is computed from a `T`.
#[derive(Debug, Clone, Copy)]
pub struct ResultSpec<T> {
    /// With the unit.
    pub name: &'static str,
    /// The meaning, in one sentence.
    pub description: &'static str,
    pub format: NumberFormat,
    /// The condition of the result; empty if the result always exists.
    pub condition: &'static str,
    /// The name on the terminal, or a remark that the terminal appends to the line above. In a remark `{}` is replaced by the value,
    /// and `{%}` by the value in percent of the value of that line. Empty: the terminal does not show the result.
    pub label: &'static str,
    /// True if a brief answer shows it.
    pub is_brief: bool,
    /// `None` if the result is omitted.
    pub value: fn(&T) -> Option<Value>,
    /// The column of a table with this result.
    pub column: Option<ResultColumn>,
}

/// How the terminal shows a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberFormat {
    Plain,
    /// In this unit, with a prefix. The name of the result ends in the unit.
    Unit(Dimension),
    /// As a fraction in percent.
    Percent,
    /// As a deviation in percent, with its sign.
    Deviation,
    /// As an error, in powers of ten.
    Error,
}

/// The requirement of a column: a table has the column only if its scene has this part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Requirement {
    /// No requirement: the column is in every table.
    Nothing,
    /// A yield strength: without one nothing is plastic.
    Strength,
    /// A strength with a known uncertainty, under a law with a known error.
    Interval,
    /// A strength that rises with the rate of strain.
    Rate,
    /// The yield strength of the sphere: without it there is no flat.
    Flat,
    /// The density of a half-space that is not a plate or a rod: without it elastic waves are not computed.
    Density,
    Thickness,
    /// The diameter of a rod.
    Rod,
    /// A plate or a rod.
    Waveguide,
    /// An angle or a spin: without them nothing slides.
    Incidence,
    /// A spin about the path or the normal: without them the sphere stays in its plane of incidence.
    Cross,
    /// The mass of a free target: without it the target is fixed.
    Target,
    /// The mass of a free target, and an angle or a spin.
    Struck,
    /// The mass of a free target, and a spin about the path or the normal.
    StruckCross,
    /// Gravity or a drop height: without them the flight is not determined.
    Flight,
    /// The work of adhesion.
    Adhesion,
    /// The table of shot peening.
    Peening,
    /// The mass flow and the area of shot peening.
    MassFlow,
    /// The time of shot peening.
    PeeningTime,
    /// A column that exists only if the scenario names it, or has the table of shot peening.
    Subsurface,
    /// The body of a Leeb tester.
    LeebTester,
    /// The hammer of Shore's scleroscope.
    Scleroscope,
}

/// A column of a table.
#[derive(Debug, Clone, Copy)]
pub struct ResultColumn {
    /// With the unit.
    pub name: &'static str,
    pub needs: Requirement,
    /// The value of a row; `None` is an empty field.
    pub value: fn(&ImpactRow) -> Option<f64>,
}

impl Requirement {
    /// The condition under which an impact has the result, in words and as a function.
    const fn condition_and_test(self) -> (&'static str, fn(&Contact, &ImpactRow) -> bool) {
        match self {
            Self::Nothing => ("", |_, _| true),
            Self::Strength => (YIELDS, |contact, _| contact.pair().yield_point.is_some()),
            Self::Interval => (INTERVAL, |_, row| row.restitution_interval.is_some()),
            Self::Rate => (RATES, |contact, _| contact.strain_rate_result().is_some()),
            Self::Flat => (FLATTENS, |contact, _| contact.sphere().yield_strength.is_some()),
            Self::Density => (WAVES, |_, row| row.wave_loss_fraction.is_some()),
            Self::Thickness => (PLATE, |_, row| row.waveguide_of(WaveguideKind::Plate).is_some()),
            Self::Rod => (ROD, |_, row| row.waveguide_of(WaveguideKind::Rod).is_some()),
            Self::Waveguide => (WAVEGUIDE, |_, row| row.waveguide.is_some()),
            Self::Incidence => (OBLIQUE, |_, row| row.rebound.is_some()),
            Self::Cross => (CROSS, |_, row| row.rebound.is_some_and(|after| after.tangential.cross.is_some())),
            Self::Target => (FREE, |_, row| row.target_speed.is_some()),
            Self::Struck => (STRUCK, |_, row| row.rebound.is_some_and(|after| after.target.is_some())),
            Self::StruckCross => (STRUCK_CROSS, |_, row| {
                row.rebound.is_some_and(|after| after.target.is_some_and(|ball| ball.cross.is_some()))
            }),
            Self::Flight => (FLIES, |_, row| row.rebound_height.is_some()),
            Self::Adhesion => (ADHERES, |_, row| row.adhesion.is_some()),
            Self::Peening => (PEENS, |_, row| row.peened.is_some()),
            Self::MassFlow => {
                (PEENS_WITH_FLOW, |_, row| row.peened.is_some_and(|peened| peened.request.mass_flux.is_some()))
            }
            Self::PeeningTime => {
                (PEENS_FOR_TIME, |_, row| row.peened.is_some_and(|peened| peened.request.time.is_some()))
            }
            Self::Subsurface => (SUBSURFACE, |_, row| row.subsurface.is_some()),
            Self::LeebTester => (LEEB, |contact, row| leeb_scale(contact, row).is_some()),
            Self::Scleroscope => {
                (SCLEROSCOPE, |contact, row| ImpactBody::new(contact, row).is_some_and(|body| body.is_of_scleroscope()))
            }
        }
    }

    /// The condition under which an impact has the result, in words.
    pub const fn condition(self) -> &'static str {
        self.condition_and_test().0
    }

    /// True if an impact on this contact has the result.
    pub fn is_met_by(self, contact: &Contact, row: &ImpactRow) -> bool {
        self.condition_and_test().1(contact, row)
    }
}

/// The scale of the Leeb tester with the body of this impact.
pub(super) fn leeb_scale(contact: &Contact, row: &ImpactRow) -> Option<&'static str> {
    ImpactBody::new(contact, row).and_then(|body| body.leeb_scale())
}

/// The values of all existing results, by name. A name with a dot belongs to a group: `energy.balance_error` is `balance_error` in `energy`.
pub fn to_fields<T>(results: &[ResultSpec<T>], subject: &T) -> Map<String, Value> {
    let mut all = Map::new();
    for ResultSpec { name, value, .. } in results {
        let Some(value) = value(subject) else { continue };
        match name.split_once('.') {
            None => drop(all.insert((*name).to_owned(), value)),
            Some((group, name)) => all.entry(group).or_insert_with(|| Map::new().into())[name] = value,
        }
    }
    all
}

/// The results of several things as a list.
pub fn to_field_list<'a, T: 'a>(results: &[ResultSpec<T>], all: impl IntoIterator<Item = &'a T>) -> Value {
    all.into_iter().map(|one| to_fields(results, one)).collect()
}

pub(crate) const YIELDS: &str = "a body has a yield strength";
pub(crate) const REACHES: &str =
    "a body has a yield strength, and first yield occurs before the contact is as wide as the sphere";
pub(crate) const RATES: &str = "a strength depends on the strain rate";
pub(crate) const FLATTENS: &str = "the sphere has a yield strength";
pub(crate) const INTERVAL: &str = "the interval is known: a body yields under the law `plm` with the exponent 3/2 or \
     `\"pressure-shape\"`, and no warning reports an error of e of unknown size; in a table also a material by name, a hardness \
     or `strength_kind = \"proof\"`";
pub(crate) const NOTES: &str =
    "a body yields, and the scenario does not define the kind of the strength or the exponent of the law";
pub(crate) const WAVES: &str = "the half-space has a density and no mass, the target is not a plate or a rod, the contact is not damped, and the sphere rebounds";
pub(crate) const OBLIQUE: &str = "the impact is oblique, or the sphere spins";
pub(crate) const CROSS: &str = "the sphere has a spin about its path or about the normal";
pub(crate) const FREE: &str = "the target has a mass and is free to move";
pub(crate) const STRUCK: &str = "the target is a second ball, and the impact is oblique or the sphere spins";
pub(crate) const STRUCK_CROSS: &str =
    "the target is a second ball, and the sphere has a spin about its path or about the normal";
pub(crate) const FLIES: &str = "the scenario has gravity or a drop height";
pub(crate) const ADHERES: &str = "the scenario has `[adhesion]`, and the sphere arrives with a speed";
pub(crate) const PEENS: &str = "the scenario has `[peening]`";
pub(crate) const PEENED_INTERVAL: &str = "the scenario has `[peening]`, and the interval of e is known";
pub(crate) const PEENS_WITH_FLOW: &str = "`[peening]` gives mass flow and area";
pub(crate) const PEENS_FOR_TIME: &str = "`[peening]` gives mass flow, area and time";
pub(crate) const SUBSURFACE: &str =
    "only the half-space yields, and the scenario has `[peening]`, or names the column in a table";
pub(crate) const LEEB: &str = "mass, tip and energy of the sphere are those of a Leeb tester, and the sphere hits a fixed target along the normal ([table](README.md#hardness-scales-of-testers))";
pub(crate) const SCLEROSCOPE: &str = "mass, tip and energy of the sphere are those of the hammer of a scleroscope, and the hammer hits a fixed target along the normal ([table](README.md#hardness-scales-of-testers))";
pub(crate) const AIR: &str = "the scenario has air";
pub(crate) const FORCES: &str = "the scenario has gravity, damping, a plate or a rod";
pub(crate) const PLATE: &str = "the target is a plate";
pub(crate) const ROD: &str = "the target is a rod";
pub(crate) const WAVEGUIDE: &str = "the target is a plate or a rod";
pub(crate) const GRAVITY: &str = "the scenario has gravity";
pub(crate) const DAMPING: &str = "the scenario has damping";
pub(crate) const VISCOUS: &str = "the scenario has viscous damping or a viscoelastic time";
pub const TABLES: &str = "in tables only";
pub(crate) const OUTSIDE: &str = "the table has such rows";
pub(crate) const RANDOM: &str = "the cases are random";
pub(crate) const RANDOM_PEENING: &str = "the cases are random, and the scenario has `[peening]`";
pub(crate) const NAMED_COLUMNS: &str = "the cases are random, and output names other columns";
pub(crate) const PULSE: &str = "the scenario has `output.pulse`, and the sphere separates";
pub(crate) const VERLET: &str = "the method is verlet";
pub(crate) const BOUNCES: &str = "the sphere bounces under gravity";
pub(crate) const CAPTURED: &str = "the sphere is captured";
pub(crate) const NAMED: &str = "the half-space has a name";
pub(crate) const DENTS: &str = "the half-space yields and the sphere does not; `null` before first yield";
pub(crate) const BRINELL: &str = "the half-space yields and the sphere does not, the half-space is flat, and the diameter of the ball is 1 to 10 mm; `null` if the \
     diameter of the dent is below 0.24 or above 0.6 of the diameter of the ball (ISO 6506-1)";
pub(crate) const GIVEN: &str = "the scenario gives it for this step";

/// A list of results from its entries.
macro_rules! result_specs {
    (|$subject:ident: $type:ty| $($(#[doc = $about:literal])+ $name:literal
        $(in $shown:ident)? $(as $label:literal)? $(briefly $brief:literal)? $(if $condition:ident)? $([$needs:ident: $column:expr])? $(: $value:expr)?;)+) => {
        vec![$($crate::results::entry::ResultSpec::<$type> {
            name: $name,
            description: concat!($($about),+).trim_ascii_start(),
            format: result_specs!(@shown $($shown)?),
            condition: result_specs!(@condition [$($condition)?] [$($needs)?]),
            label: concat!($($label)? $($brief)?),
            is_brief: !concat!($($brief)?).is_empty(),
            #[allow(unused_variables)] // a result of tables alone has no value here
            value: |$subject| result_specs!(@value $subject [$($condition)?] [$($needs, $column)?] [$($value)?]),
            column: result_specs!(@column $($name, $needs, $column)?),
        }),+]
    };
    (@shown) => { $crate::results::entry::NumberFormat::Plain };
    (@shown Percent) => { $crate::results::entry::NumberFormat::Percent };
    (@shown Deviation) => { $crate::results::entry::NumberFormat::Deviation };
    (@shown Error) => { $crate::results::entry::NumberFormat::Error };
    (@shown $dimension:ident) => {
        $crate::results::entry::NumberFormat::Unit($crate::units::Dimension::$dimension)
    };
    (@condition [] []) => { "" };
    (@condition [] [$needs:ident]) => { $crate::results::entry::Requirement::$needs.condition() };
    (@condition [$condition:ident] [$($needs:ident)?]) => { $crate::results::entry::$condition };
    (@value $subject:ident [] [] [$value:expr]) => { Some($value.into()) };
    (@value $subject:ident [$condition:ident] [] [$value:expr]) => { $value.map(Into::into) };
    (@value $subject:ident [] [$needs:ident, $column:expr] []) => {
        $subject.column_value($crate::results::entry::Requirement::$needs, $column)
    };
    (@value $subject:ident [$condition:ident] [$needs:ident, $column:expr] []) => { None };
    (@value $subject:ident [$condition:ident] [$needs:ident, $column:expr] [$value:expr]) => { $value.map(Into::into) };
    (@column) => { None };
    (@column $name:literal, $needs:ident, $value:expr) => {{
        use $crate::results::entry::{ResultColumn, Requirement};
        Some(ResultColumn { name: $name, needs: Requirement::$needs, value: $value })
    }};
}
pub(crate) use result_specs;
