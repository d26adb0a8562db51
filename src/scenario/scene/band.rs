//! The band of e: how far the hardness of a material by name, and the error of the law, leave it open.

use super::results::impact::Band;
use super::{At, Body, Input, NUMBER, key_of};
use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::contact::materials::Known;
use crate::impact::{Approach, Contact, Essentials, Solver};
use crate::numerics::functions::powi;
use crate::units::percent;

/// A smaller change of e, as a share of it, is rounding.
const LEAST: f64 = 1e-9;

/// Root mean square deviation of e from the finite elements of this project, as `validate` prints it.
const PRESSURE_SHAPE: f64 = 0.01;
const PAPER: f64 = 0.032;

/// The error of e by a law, as a share of it; `None` where it is not known.
pub fn stated_error(law: &LawChoice) -> Option<f64> {
    let LawChoice::Plm(law) = law else { return None };
    match law.exponent {
        UnloadingExponent::PressureShape => Some(PRESSURE_SHAPE),
        UnloadingExponent::Paper => Some(PAPER),
        UnloadingExponent::Fixed(_) => None,
    }
}

/// The hardnesses that the bodies take from materials by name.
pub fn ranges(input: &Input) -> impl Iterator<Item = (Body, At<NUMBER>, &'static Known)> {
    input.materials().iter().filter_map(|material| {
        let at = key_of!(material.body, "hardness");
        let (_, known) = material.values().find(|(key, _)| *key == at.path())?;
        (input.number(at) == Some(known.used.value)).then_some((material.body, at, known))
    })
}

/// The two causes of the uncertainty of e at a contact. Each hardness that a material gives has a range: this holds the contacts
/// with its lowest and its highest value. And the law itself has an error.
#[derive(Debug)]
pub struct Uncertainty {
    error: f64,
    /// At most one a body.
    hardness: Vec<(Body, &'static Known, [Contact; 2])>,
}

impl Uncertainty {
    /// `None` for a law or an exponent without a stated error, and where a contact at an end of a range does not exist.
    pub fn new(input: &Input) -> Option<Self> {
        let error = stated_error(&input.law())?;
        let mut hardness = Vec::new();
        for (body, at, known) in ranges(input) {
            let contact = |value: f64| {
                let mut input = input.clone();
                input.set(at, Some(value));
                input.contact().ok()
            };
            let [low, high] = known.range.each_ref().map(|end| contact(end.value));
            hardness.push((body, known, [low?, high?]));
        }
        Some(Self { error, hardness })
    }

    /// Both ends of e in an impact with this result, and whether each hardness changes it. `None` without a dent and without a
    /// rebound.
    ///
    /// At both ends of the range of the material's hardness e is computed anew; its distance and the error of the law are added
    /// as squares, because they are independent.
    fn ends(&self, approach: Approach, row: &Essentials) -> Option<([f64; 2], [bool; 2])> {
        let restitution = row.restitution;
        if !(row.has_dent() && restitution > 0.0 && restitution < 1.0) {
            return None;
        }
        let (mut squares, mut counts) = ([powi(self.error * restitution, 2); 2], [false; 2]);
        for ((.., contacts), is_part) in self.hardness.iter().zip(&mut counts) {
            let [low, high] = contacts.each_ref().map(|contact| contact.row(approach, &Solver::AUTO));
            let ends = [low.ok()?.restitution, high.ok()?.restitution];
            // a body that does not flow leaves e as it is
            *is_part = ends.iter().any(|end| (end - restitution).abs() > LEAST * restitution);
            if *is_part {
                squares.iter_mut().zip(ends).for_each(|(sum, end)| *sum += powi(end - restitution, 2));
            }
        }
        let [below, above] = squares.map(f64::sqrt);
        Some(([(restitution - below).max(0.0), (restitution + above).min(1.0)], counts))
    }

    /// Both ends of e in an impact with this result, for a table.
    pub fn range(&self, approach: Approach, row: &Essentials) -> Option<[f64; 2]> {
        self.ends(approach, row).map(|(ends, _)| ends)
    }
}

/// The band of the restitution of an impact of this input. `None` without a dent, for an exponent or a law without a stated error,
/// and without a rebound.
pub fn band(input: &Input, speed: f64, row: &Essentials) -> Option<Band> {
    let uncertainty = Uncertainty::new(input)?;
    let ([low, high], counts) = uncertainty.ends(input.approach_at(speed), row)?;
    let parts = uncertainty.hardness.iter().zip(counts).filter(|(_, is_part)| *is_part);
    let mut because: Vec<_> = parts
        .map(|((body, Known { range: [soft, hard], .. }, _), _)| {
            format!("{} {} to {}", body.pick(["hardness of the sphere", "hardness"]), soft.text, hard.text)
        })
        .collect();
    because.push(format!("law {}", percent(uncertainty.error)));
    Some(Band { low, high, because: because.join(", ") })
}
