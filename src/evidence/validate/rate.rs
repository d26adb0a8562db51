//! Whole impacts on a half-space whose strength rises with the strain rate, against explicit finite elements with the rate in
//! every point.

use super::comparison::{Comparison, Group, Quantity, compared};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients, UnloadingExponent};
use crate::contact::material::{HalfSpace, Material, Sphere};
use crate::contact::strength::rate::{Form, Rate};
use crate::error::Error;
use crate::impact::reference::impacts::{self, RatedRow};
use crate::impact::{Contact, Impact};

const SOURCE: &str = "explicit finite elements, src/impact/reference/fe_rate.csv";

/// An impact by finite elements, and by the law.
type Case = (RatedRow, Impact);

const QUANTITIES: [Quantity<Case>; 5] = [
    (Group::new("impact with strain rate: restitution, pressure-shape with waves", SOURCE, ""), |(row, impact)| {
        Some([row.restitution, impact.restitution_with_waves()?])
    }),
    (Group::new("impact with strain rate: contact time", SOURCE, "s"), |(row, impact)| {
        Some([row.contact_time, impact.contact_time])
    }),
    (Group::new("impact with strain rate: peak force", SOURCE, "N"), |(row, impact)| {
        Some([row.peak_force, impact.peak_force])
    }),
    (Group::new("impact with strain rate: peak indentation", SOURCE, "m"), |(row, impact)| {
        Some([row.peak_indentation, impact.peak_indentation])
    }),
    (
        Group::of_differences("impact with strain rate: residual indentation over peak indentation", SOURCE, ""),
        |(row, impact)| {
            Some([row.residual_indentation, impact.residual_indentation].map(|depth| depth / row.peak_indentation))
        },
    ),
];

/// The rise of the strength of a row; `None` without its numbers.
fn rate(row: &RatedRow) -> Option<Rate> {
    let form = match (row.c, row.reference, row.rate, row.exponent) {
        (Some(c), Some(reference), ..) => Form::JohnsonCook { c, reference },
        (.., Some(rate), Some(exponent)) => Form::CowperSymonds { rate, exponent },
        _ => return None,
    };
    Some(Rate { form, tested_at: row.tested_at })
}

fn impact(row: &RatedRow, coefficients: &PlmCoefficients) -> Result<Impact, Error> {
    let material = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
    let of_sphere = material(row.sphere_modulus, row.sphere_poissons_ratio);
    let sphere = Sphere::elastic(row.radius, of_sphere, row.sphere_density);
    let half_space = HalfSpace {
        density: Some(row.half_space_density),
        ..HalfSpace::flat(material(row.half_space_modulus, row.half_space_poissons_ratio), Some(row.yield_strength))
    };
    let plm = Plm::new(coefficients, UnloadingExponent::PressureShape);
    let contact = Contact::try_new(sphere, half_space, &plm)?.with_rates([None, rate(row)], &LawChoice::Plm(plm));
    Ok(contact.closed_form(row.speed)?)
}

pub(super) fn impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let case = |row: RatedRow| impact(&row, coefficients).map(|impact| (row, impact));
    let cases: Vec<Case> = impacts::rated()?.into_iter().map(case).collect::<Result<_, Error>>()?;
    Ok(compared(&QUANTITIES, &cases, |(row, _)| row.case.clone()))
}
