//! Whole impacts against explicit finite elements: restitution, contact time, peak force, dent depth.

use super::comparison::{Comparison, EXPONENTS, Group, Quantity, compared};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients};
use crate::error::Error;
use crate::impact::Impact;
use crate::impact::reference::impacts::{self, ImpactRow, Sample};
use crate::impact::reference::{self, DYNAMIC};
use crate::scenario::Scenario;
use crate::scenario::scene::Input;

const QUANTITIES: [Quantity<Case>; 8] = [
    (Group::new("impact: restitution, exponent 3/2", DYNAMIC, ""), |case| {
        Some([case.reference.restitution, case.impacts[0].restitution])
    }),
    (Group::new("impact: restitution, pressure-shape", DYNAMIC, ""), |case| {
        Some([case.reference.restitution, case.impacts[1].restitution])
    }),
    (Group::new("impact: restitution, pressure-shape with waves", DYNAMIC, ""), |case| {
        Some([case.reference.restitution, case.impacts[1].restitution_with_waves()?])
    }),
    (Group::new("impact: energy radiated as waves", DYNAMIC, ""), |case| {
        Some([case.reference.radiated_share, case.impacts[1].wave_loss_fraction?])
    }),
    (Group::new("impact: contact time, exponent 3/2", DYNAMIC, "s"), |case| {
        Some([case.reference.contact_time, case.impacts[0].contact_time])
    }),
    (Group::new("impact: contact time, pressure-shape", DYNAMIC, "s"), |case| {
        Some([case.reference.contact_time, case.impacts[1].contact_time])
    }),
    (Group::new("impact: peak force", DYNAMIC, "N"), |case| {
        Some([case.reference.peak_force, case.impacts[0].peak_force])
    }),
    (Group::new("impact: residual indentation", DYNAMIC, "m"), |case| {
        Some([case.reference.residual_indentation, case.impacts[0].residual_indentation])
    }),
];

/// Number of samples in the traces that pictures are drawn from.
const SAMPLES: usize = 300;

const SCENARIOS: [(&str, &str); 3] = [
    ("D1", include_str!("../../../scenarios/dynamic-fe-d1.toml")),
    ("D2", include_str!("../../../scenarios/dynamic-fe-d2.toml")),
    ("D5", include_str!("../../../scenarios/dynamic-fe-d5.toml")),
];

/// One impact, by finite elements and by the law.
#[derive(Debug, Clone)]
pub struct Case {
    /// The results of the finite elements, with the name, such as "D1".
    pub reference: ImpactRow,
    /// Samples of the finite elements, in the order of time.
    pub samples: Vec<Sample>,
    /// The impact by the law with each of [`EXPONENTS`], with a trace.
    pub impacts: [Impact; 2],
}

/// The inputs of the three impacts, and what the finite elements gave: results, and samples in the order of time.
pub(super) fn scenes() -> Result<Vec<(Input, ImpactRow, Vec<Sample>)>, Error> {
    let (references, samples) = (impacts::impacts()?, impacts::samples()?);
    let scene = |&(name, text): &(&'static str, &str)| {
        let reference = references.iter().find(|row| row.case == name).cloned();
        let reference = reference.ok_or_else(|| reference::damaged(impacts::TABLE, &format!("has no row {name}")))?;
        let input = Scenario::from_text(name, text, &[])?.resolve()?;
        Ok((input, reference, samples.iter().filter(|sample| sample.case == name).cloned().collect()))
    };
    SCENARIOS.iter().map(scene).collect()
}

/// The three impacts.
pub(super) fn cases(coefficients: &PlmCoefficients) -> Result<Vec<Case>, Error> {
    let case = |(input, reference, samples): (Input, ImpactRow, Vec<Sample>)| {
        let impact = |exponent| -> Result<Impact, Error> {
            let law = LawChoice::Plm(Plm::new(coefficients, exponent));
            let (sphere, half_space) = input.bodies(&law);
            let contact = input.pair(sphere, half_space, &law)?;
            Ok(contact.impact(input.speed(), &input.solver(), Some(SAMPLES))?)
        };
        let [paper, shape] = EXPONENTS.map(|(exponent, _)| impact(exponent));
        Ok(Case { reference, samples, impacts: [paper?, shape?] })
    };
    scenes()?.into_iter().map(case).collect()
}

pub(super) fn impacts(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    Ok(compared(&QUANTITIES, &cases(coefficients)?, |case| case.reference.case.clone()))
}
