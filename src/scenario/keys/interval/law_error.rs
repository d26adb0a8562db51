//! The error of e by the law plm against the finite elements of this project: the part of the law in the interval of e.
//! `law_errors.csv` has the quantiles, which a test computes from the load cycles of `validate`.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::contact::law::{LawChoice, PlmCoefficients, UnloadingExponent};
use crate::impact::Contact;
use crate::numerics::comparison::{is_above, is_below};
use crate::results::restitution_interval::{IntervalPart, PartKind};
use crate::scenario::input::{Body, Input};
use crate::strings::names::named_enum;

named_enum! {
    /// The bodies of an impact in classes on which the error of the law depends.
    #[derive(Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum BodyClass {
        /// The half-space yields alone, without hardening.
        PerfectlyPlastic = "perfectly_plastic",
        /// The half-space yields alone, with a flow curve.
        Hardening = "hardening",
        /// The sphere yields, alone or with the half-space.
        YieldingSphere = "yielding_sphere",
        /// The half-space has another Poisson's ratio than 0.3: the errors of e over e at 0.3.
        OtherPoissonsRatio = "other_poissons_ratio",
        /// All load cycles, for bodies of no other class.
        All = "all",
    }
}

/// The unloading exponents with known errors, with their names in the table.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::PressureShape, "pressure_shape"), (UnloadingExponent::Paper, "paper")];

/// The range of Poisson's ratios of the yielding body that the other load cycles represent; their own ratio is 0.3.
const POISSONS_RATIOS: [f64; 2] = [0.25, 0.35];

/// The errors of e over the load cycles of one class of bodies. An error is e of the law over e of the finite elements, minus 1.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawErrorRow {
    pub class: BodyClass,
    /// The name of the exponent of unloading.
    pub exponent: String,
    /// The largest contact radius over the radius of the sphere.
    pub max_radius_ratio: f64,
    /// The number of load cycles.
    pub cycles: usize,
    pub mean: f64,
    /// The quantile of 2.5 %.
    pub low: f64,
    /// The quantile of 97.5 %.
    pub high: f64,
}

/// The table, in the order of the file.
pub fn law_error_table() -> &'static [LawErrorRow] {
    static TABLE: LazyLock<Vec<LawErrorRow>> = LazyLock::new(|| {
        let mut reader =
            csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(include_str!("law_errors.csv").as_bytes());
        reader.deserialize().filter_map(Result::ok).collect()
    });
    &TABLE
}

/// The name of the exponent of a law; `None` for a law or an exponent whose error is not known.
fn exponent_name(law: &LawChoice) -> Option<&'static str> {
    let LawChoice::Plm(law) = law else { return None };
    EXPONENTS.iter().find(|(exponent, _)| *exponent == law.exponent).map(|(_, name)| *name)
}

/// True if the error of e by this law is known: the law has the built-in coefficients.
pub fn has_law_error(law: &LawChoice) -> bool {
    let is_built_in = matches!(law, LawChoice::Plm(law) if *law.coefficients == *PlmCoefficients::built_in());
    is_built_in && exponent_name(law).is_some()
}

/// The errors of e by a law on these bodies at this contact radius over the radius of the sphere; `None` where they are not known.
pub fn law_error(law: &LawChoice, contact: &Contact, radius_ratio: f64) -> Option<&'static LawErrorRow> {
    let exponent = exponent_name(law)?;
    let flow = contact.pair().yield_point?.yield_partition;
    let yields = flow.sphere_share > 0.0;
    let class = match (contact.has_hardening(), yields) {
        // no load cycle has a ball that hardens
        (true, true) => BodyClass::All,
        (true, false) => BodyClass::Hardening,
        (false, true) => BodyClass::YieldingSphere,
        (false, false) => BodyClass::PerfectlyPlastic,
    };
    let find = |class: BodyClass| {
        let mut rows = law_error_table().iter().filter(move |row| row.class == class && row.exponent == exponent);
        rows.find(|row| radius_ratio <= row.max_radius_ratio)
    };
    find(class).or_else(|| find(BodyClass::All))
}

/// The part of the interval of e for the Poisson's ratio of the body that yields: none where it is like that of the load cycles. `None`
/// for a negative one, of which there are no finite elements, and for bodies that stay elastic.
pub(super) fn poissons_ratio_part(input: &Input, contact: &Contact, law: &LawChoice) -> Option<Vec<IntervalPart>> {
    let body = contact.pair().yield_point?.yield_partition.for_softer(Body::ALL);
    let poissons_ratio = input.material(body).poissons_ratio;
    let [least, most] = POISSONS_RATIOS;
    if poissons_ratio < 0.0 {
        return None;
    }
    if !is_below(poissons_ratio, least) && !is_above(poissons_ratio, most) {
        return Some(Vec::new());
    }
    let exponent = exponent_name(law)?;
    let is_here = |row: &&LawErrorRow| row.class == BodyClass::OtherPoissonsRatio && row.exponent == exponent;
    let row = law_error_table().iter().find(is_here)?;
    let width = row.low.abs().max(row.high.abs());
    let part = IntervalPart { name: "Poisson's ratio".to_owned(), kind: PartKind::Width, low: -width, high: width };
    Some(vec![part])
}

/// The mean error of e with the exponent of the paper on a half-space that does not harden, and its quantiles: the bias of the
/// default.
pub fn paper_exponent_error() -> Option<&'static LawErrorRow> {
    law_error_table().iter().find(|row| row.class == BodyClass::PerfectlyPlastic && row.exponent == EXPONENTS[1].1)
}
