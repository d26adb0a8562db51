//! Whole impacts on a half-space whose strength rises with the strain rate, against explicit finite elements with the rate in
//! every point.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::impact::Impact;
use crate::reference::{RATE_IMPACTS, ReferenceRow};
use crate::scenario::input::Input;
use crate::scenario::{Override, Scenario};

const SOURCE: &str = "explicit finite elements, src/reference/fe_rate.csv";

/// An impact by finite elements, and by the law.
type RateCase = (ReferenceRow, Impact);

const QUANTITIES: [ComparedQuantity<RateCase>; 5] = [
    (Group::new("impact with strain rate: restitution, pressure-shape with waves", SOURCE, ""), |(row, impact)| {
        Some([row.number("restitution"), impact.row.restitution_with_waves()?])
    }),
    (Group::new("impact with strain rate: contact time", SOURCE, "s"), |(row, impact)| {
        Some([row.number("contact_time_s"), impact.row.contact_time])
    }),
    (Group::new("impact with strain rate: peak force", SOURCE, "N"), |(row, impact)| {
        Some([row.number("peak_force_N"), impact.row.peak_force])
    }),
    (Group::new("impact with strain rate: peak indentation", SOURCE, "m"), |(row, impact)| {
        Some([row.number("peak_indentation_m"), impact.row.peak_indentation])
    }),
    (
        Group::new_difference("impact with strain rate: residual indentation over peak indentation", SOURCE, ""),
        |(row, impact)| {
            Some(
                [row.number("residual_indentation_m"), impact.row.residual_indentation]
                    .map(|depth| depth / row.number("peak_indentation_m")),
            )
        },
    ),
];

/// A row has the keys of a scenario.
pub(super) fn input_of(row: &ReferenceRow) -> Result<Input, Error> {
    Scenario::from_text(row.cell_text("case"), "", &Override::list(&row.keys()))?.resolve()
}

fn impact(row: &ReferenceRow, coefficients: &PlmCoefficients) -> Result<Impact, Error> {
    let input = input_of(row)?;
    let law = LawChoice::Plm(Plm::new(coefficients, UnloadingExponent::PressureShape));
    let (sphere, half_space) = input.bodies(&law);
    Ok(input.contact_of(sphere, half_space, &law)?.closed_form(input.speed())?)
}

pub(super) fn impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let case = |row: ReferenceRow| impact(&row, coefficients).map(|impact| (row, impact));
    let cases: Vec<RateCase> = RATE_IMPACTS.rows()?.into_iter().map(case).collect::<Result<_, Error>>()?;
    Ok(compare_all(&QUANTITIES, &cases, |(row, _)| row.cell_text("case").to_owned()))
}
