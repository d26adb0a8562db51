//! The error of e by the law plm against the finite elements of this project: the part of the law in the interval of e.
//! `law_errors.csv` has the quantiles, which a test computes from the load cycles of `validate`.

use std::sync::LazyLock;

use serde::Deserialize;

use crate::contact::law::{LawChoice, PlmCoefficients, UnloadingExponent};
use crate::impact::Contact;
use crate::results::restitution_interval::{IntervalPart, PartKind};
use crate::scenario::input::{Body, Input};
use crate::scenario::keys::body_key;
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
        /// All load cycles, for bodies of no other class.
        All = "all",
    }
}

/// The unloading exponents with known errors, with their names in the table.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::PressureShape, "pressure_shape"), (UnloadingExponent::Paper, "paper")];

/// The range of Poisson's ratios of the yielding body that the load cycles represent; their own ratio is 0.3.
const POISSONS_RATIOS: [f64; 2] = [0.25, 0.35];

/// How far e of finite elements is above e of the law at other Poisson's ratios: the ratio, and r = (p_FE/p)^(5/8), as e goes with the
/// mean pressure to the power of 5/8 (Johnson 1985, ch. 11.5).
///
/// Load cycles by CalculiX 2.20 of a rigid sphere and of two equal spheres with σ_Y/E* = 0.003, to 664 times the yield indentation. The
/// law has the pressure C_ν σ_Y at all depths, but the pressure of a fully plastic dent hardly depends on ν: at equal indentation it is
/// 0.966, 0.968 and 1.018 times the pressure at ν = 0.3. The r are the farthest from 1 of all load cycles. In e at equal work the law was
/// 8.7 % low at 0.03, 5.7 % low at 0.10 and 2.7 % high at 0.42, and right up to 30 times the yield indentation.
const PRESSURE_RATIOS: [(f64, f64); 4] = [(0.03, 1.105), (0.10, 1.073), (0.30, 1.0), (0.42, 0.956)];

/// A strength by a hardness has the pressure of the hardness test at every Poisson's ratio: then e is within this share.
const BY_HARDNESS: f64 = 0.03;

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

/// r of a Poisson's ratio: straight between the ratios of the load cycles, and on beyond the first and the last of them.
fn pressure_ratio(poissons_ratio: f64) -> f64 {
    let [first, second, third, last] = PRESSURE_RATIOS;
    let [from, to] = match poissons_ratio {
        ratio if ratio < second.0 => [first, second],
        ratio if ratio < third.0 => [second, third],
        _ => [third, last],
    };
    from.1 + (to.1 - from.1) * (poissons_ratio - from.0) / (to.0 - from.0)
}

/// The part of the interval of e for the Poisson's ratio of the body that yields: none where it is like that of the load cycles. `None`
/// for a negative one, of which there are no finite elements, and for bodies that stay elastic.
pub(super) fn poissons_ratio_part(input: &Input, contact: &Contact) -> Option<Vec<IntervalPart>> {
    let body = contact.pair().yield_point?.yield_partition.for_softer(Body::ALL);
    let poissons_ratio = input.material(body).poissons_ratio;
    let [least, most] = POISSONS_RATIOS;
    if poissons_ratio < 0.0 {
        return None;
    }
    if (least..=most).contains(&poissons_ratio) {
        return Some(Vec::new());
    }
    let share = pressure_ratio(poissons_ratio) - 1.0;
    let (kind, low, high) = if input.number(body_key!(body, "hardness")).is_some() {
        let width = share.abs().min(BY_HARDNESS);
        (PartKind::Width, -width, width)
    } else {
        // at small depths the law is right
        (PartKind::Shift, share.min(0.0), share.max(0.0))
    };
    Some(vec![IntervalPart { name: "Poisson's ratio".to_owned(), kind, low, high }])
}

/// The mean error of e with the exponent of the paper on a half-space that does not harden, and its quantiles: the bias of the
/// default.
pub fn paper_exponent_error() -> Option<&'static LawErrorRow> {
    law_error_table().iter().find(|row| row.class == BodyClass::PerfectlyPlastic && row.exponent == EXPONENTS[1].1)
}
