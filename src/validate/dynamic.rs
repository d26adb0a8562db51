//! Whole impacts against explicit finite elements: restitution, contact time, peak force, dent depth.

use super::comparison::{ComparedQuantity, Comparison, EXPONENTS, Group, compare_all};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients};
use crate::error::Error;
use crate::impact::Impact;
use crate::reference;
use crate::reference::{CURVES_OF_IMPACTS, DYNAMIC_SOURCE, IMPACTS, ReferenceRow};
use crate::scenario::Scenario;
use crate::scenario::input::Input;

const QUANTITIES: [ComparedQuantity<DynamicCase>; 8] = [
    (Group::new("impact: restitution, exponent 3/2", DYNAMIC_SOURCE, ""), |case| {
        Some([case.reference.number("restitution"), case.impacts[0].row.restitution])
    }),
    (Group::new("impact: restitution, pressure-shape", DYNAMIC_SOURCE, ""), |case| {
        Some([case.reference.number("restitution"), case.impacts[1].row.restitution])
    }),
    (Group::new("impact: restitution, pressure-shape with waves", DYNAMIC_SOURCE, ""), |case| {
        Some([case.reference.number("restitution"), case.impacts[1].row.restitution_with_waves()?])
    }),
    (Group::new("impact: energy radiated as waves", DYNAMIC_SOURCE, ""), |case| {
        Some([case.reference.number("radiated_share"), case.impacts[1].row.wave_loss_fraction?])
    }),
    (Group::new("impact: contact time, exponent 3/2", DYNAMIC_SOURCE, "s"), |case| {
        Some([case.reference.number("contact_time_s"), case.impacts[0].row.contact_time])
    }),
    (Group::new("impact: contact time, pressure-shape", DYNAMIC_SOURCE, "s"), |case| {
        Some([case.reference.number("contact_time_s"), case.impacts[1].row.contact_time])
    }),
    (Group::new("impact: peak force", DYNAMIC_SOURCE, "N"), |case| {
        Some([case.reference.number("peak_force_N"), case.impacts[0].row.peak_force])
    }),
    (Group::new("impact: residual indentation", DYNAMIC_SOURCE, "m"), |case| {
        Some([case.reference.number("residual_indentation_m"), case.impacts[0].row.residual_indentation])
    }),
];

/// Number of samples in the traces that pictures are drawn from.
const SAMPLES: usize = 300;

pub(super) const SCENARIOS: [(&str, &str); 3] = [
    ("D1", include_str!("../../scenarios/dynamic-fe-d1.toml")),
    ("D2", include_str!("../../scenarios/dynamic-fe-d2.toml")),
    ("D5", include_str!("../../scenarios/dynamic-fe-d5.toml")),
];

/// One impact, by finite elements and by the law.
#[derive(Debug, Clone)]
pub struct DynamicCase {
    /// The results of the finite elements, with the name, such as "D1".
    pub reference: ReferenceRow,
    /// Samples of the finite elements, in the order of time.
    pub samples: Vec<ReferenceRow>,
    /// The impact by the law with each of [`EXPONENTS`], with a trace.
    pub impacts: [Impact; 2],
}

/// The inputs of the three impacts, and what the finite elements gave: results, and samples in the order of time.
pub(super) fn dynamic_scenarios() -> Result<Vec<(Input, ReferenceRow, Vec<ReferenceRow>)>, Error> {
    let (references, samples) = (IMPACTS.rows()?, CURVES_OF_IMPACTS.rows()?);
    let scene = |&(name, text): &(&'static str, &str)| {
        let reference = references.iter().find(|row| row.cell_text("case") == name).cloned();
        let reference =
            reference.ok_or_else(|| reference::damaged_table(DYNAMIC_SOURCE, &format!("has no row {name}")))?;
        let input = Scenario::from_text(name, text, &[])?.resolve()?;
        Ok((input, reference, samples.iter().filter(|sample| sample.cell_text("case") == name).cloned().collect()))
    };
    SCENARIOS.iter().map(scene).collect()
}

/// The three impacts.
pub(super) fn cases(coefficients: &PlmCoefficients) -> Result<Vec<DynamicCase>, Error> {
    let case = |(input, reference, samples): (Input, ReferenceRow, Vec<ReferenceRow>)| {
        let impact = |exponent| -> Result<Impact, Error> {
            let law = LawChoice::Plm(Plm::new(coefficients, exponent));
            let (sphere, half_space) = input.bodies(&law);
            let contact = input.contact_of(sphere, half_space, &law)?;
            Ok(contact.impact(input.speed(), &input.solver(), Some(SAMPLES))?)
        };
        let [paper, shape] = EXPONENTS.map(|(exponent, _)| impact(exponent));
        Ok(DynamicCase { reference, samples, impacts: [paper?, shape?] })
    };
    dynamic_scenarios()?.into_iter().map(case).collect()
}

pub(super) fn impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    Ok(compare_all(&QUANTITIES, &cases(coefficients)?, |case| case.reference.cell_text("case").to_owned()))
}
