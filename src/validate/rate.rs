//! Whole impacts against explicit finite elements with the strain rate in every point: on a half-space whose strength rises with the
//! strain rate, and of shots that leave deep dents.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::impact::Impact;
use crate::reference::{DEEP_IMPACTS, RATE_IMPACTS, ReferenceRow, ReferenceTable};
use crate::scenario::input::Input;
use crate::scenario::{Override, Scenario};

/// An impact by finite elements, and by the law.
type RateCase = (ReferenceRow, Impact);

/// Names of the quantities of an impact: restitution, contact time, peak force, peak indentation, residual indentation.
type QuantityNames = [&'static str; 5];

const RATE_SOURCE: &str = "explicit finite elements, src/reference/fe_rate.csv";
const RATE_NAMES: QuantityNames = [
    "impact with strain rate: restitution, pressure-shape with waves",
    "impact with strain rate: contact time",
    "impact with strain rate: peak force",
    "impact with strain rate: peak indentation",
    "impact with strain rate: residual indentation over peak indentation",
];

const DEEP_SOURCE: &str = "explicit finite elements of shots (20 to 80 m/s), src/reference/fe_deep_impacts.csv";
const DEEP_NAMES: QuantityNames = [
    "deep impact: restitution, pressure-shape with waves",
    "deep impact: contact time",
    "deep impact: peak force",
    "deep impact: peak indentation",
    "deep impact: residual indentation over peak indentation",
];

/// The quantities of an impact.
const fn quantities(names: QuantityNames, source: &'static str) -> [ComparedQuantity<RateCase>; 5] {
    let [restitution, time, force, indentation, residual] = names;
    [
        (Group::new(restitution, source, ""), |(row, impact)| {
            Some([row.number("restitution"), impact.row.measured_restitution()])
        }),
        (Group::new(time, source, "s"), |(row, impact)| Some([row.number("contact_time_s"), impact.row.contact_time])),
        (Group::new(force, source, "N"), |(row, impact)| Some([row.number("peak_force_N"), impact.row.peak_force])),
        (Group::new(indentation, source, "m"), |(row, impact)| {
            Some([row.number("peak_indentation_m"), impact.row.peak_indentation])
        }),
        (Group::new_difference(residual, source, ""), |(row, impact)| {
            let residuals = [row.number("residual_indentation_m"), impact.row.residual_indentation];
            Some(residuals.map(|depth| depth / row.number("peak_indentation_m")))
        }),
    ]
}

/// The input of a row, which has the keys of a scenario.
pub(super) fn input_of(row: &ReferenceRow) -> Result<Input, Error> {
    Scenario::from_text(row.cell_text("case"), "", &Override::list(&row.keys()))?.resolve()
}

fn impact(row: &ReferenceRow, coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Result<Impact, Error> {
    let input = input_of(row)?;
    let flow = input.law().flow_curves().map(Option::<&_>::cloned);
    let law = LawChoice::Plm(Plm { flow, ..Plm::new(coefficients, exponent) });
    let (sphere, half_space) = input.bodies(&law);
    Ok(input.contact_of(sphere, half_space, &law)?.closed_form(input.speed())?)
}

/// The impacts of a table by the law.
pub(super) fn impacts_of(
    table: &ReferenceTable,
    coefficients: &PlmCoefficients,
    exponent: UnloadingExponent,
) -> Result<Vec<RateCase>, Error> {
    let case = |row: ReferenceRow| impact(&row, coefficients, exponent).map(|impact| (row, impact));
    table.rows()?.into_iter().map(case).collect()
}

fn compare(
    table: &ReferenceTable,
    quantities: &[ComparedQuantity<RateCase>],
    coefficients: &PlmCoefficients,
) -> Result<Vec<Comparison>, Error> {
    let cases = impacts_of(table, coefficients, UnloadingExponent::PressureShape)?;
    Ok(compare_all(quantities, &cases, |(row, _)| row.cell_text("case").to_owned()))
}

pub(super) fn impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    compare(&RATE_IMPACTS, &quantities(RATE_NAMES, RATE_SOURCE), coefficients)
}

pub(super) fn deep_impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    compare(&DEEP_IMPACTS, &quantities(DEEP_NAMES, DEEP_SOURCE), coefficients)
}
