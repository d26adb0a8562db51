//! The band of e: how far the hardness of a material by name, the error of the law, the theory of a plate, and errors that a
//! warning names in figures leave it open.

use super::results::impact::Band;
use super::{At, Body, Input, NUMBER, key_of};
use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::contact::materials::Known;
use crate::impact::{Approach, Bias, Contact, Essentials, Forces, Plate, PlateTheory, Solver};
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
/// with its lowest and its highest value. And the law itself has an error, and so has the theory of a plate.
#[derive(Debug)]
pub struct Uncertainty {
    error: f64,
    /// At most one a body.
    hardness: Vec<(Body, &'static Known, [Contact; 2])>,
    /// On a plate: the contact with the other theory, and the share of its distance that may be missing.
    other_plate: Option<(Contact, f64)>,
}

impl Uncertainty {
    /// `None` for a law or an exponent without a stated error, and where a contact at an end of a range does not exist.
    pub fn new(input: &Input, contact: &Contact) -> Option<Self> {
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
        Some(Self { error, hardness, other_plate: of_other_theory(contact) })
    }

    /// Both ends of e in an impact of this contact with this result, and the reasons. `None` without a dent, without a rebound, and
    /// where a warning says that nobody knows how far e is off.
    ///
    /// At both ends of the range of the material's hardness e is computed anew; its distance and the other errors are added
    /// as squares, because they are independent.
    fn ends(&self, contact: &Contact, approach: Approach, row: &Essentials) -> Option<([f64; 2], Reasons)> {
        let restitution = row.restitution;
        if !(row.has_dent() && restitution > 0.0 && restitution < 1.0) {
            return None;
        }
        let biases = contact.known_biases(approach.components()[0], row)?;
        let of_plate = self.of_plate(approach, restitution)?;
        let mut squares = [powi(self.error * restitution, 2); 2];
        let mut add = |distances: [f64; 2]| {
            squares.iter_mut().zip(distances).for_each(|(sum, distance)| *sum += powi(distance, 2));
        };
        for Bias { too_high, too_low, .. } in &biases {
            add([too_high * restitution, too_low * restitution]);
        }
        add(of_plate);
        let mut is_part = [false; 2];
        for ((.., contacts), is_part) in self.hardness.iter().zip(&mut is_part) {
            let [low, high] = contacts.each_ref().map(|contact| contact.row(approach, &Solver::AUTO));
            let ends = [low.ok()?.restitution, high.ok()?.restitution];
            // a body that does not flow leaves e as it is
            *is_part = ends.iter().any(|end| (end - restitution).abs() > LEAST * restitution);
            if *is_part {
                add(ends.map(|end| end - restitution));
            }
        }
        let [below, above] = squares.map(f64::sqrt);
        let reasons = Reasons { hardness: is_part, is_plate: of_plate != [0.0; 2], biases };
        Some(([(restitution - below).max(0.0), (restitution + above).min(1.0)], reasons))
    }

    /// How far e may be below and above on a plate; 0 without one.
    fn of_plate(&self, approach: Approach, restitution: f64) -> Option<[f64; 2]> {
        let Some((other, share)) = &self.other_plate else { return Some([0.0; 2]) };
        let gap = other.row(approach, &Solver::AUTO).ok()?.restitution - restitution;
        Some([share * gap.abs(), 0.0])
    }

    /// Both ends of e in an impact with this result, for a table.
    pub fn range(&self, contact: &Contact, approach: Approach, row: &Essentials) -> Option<[f64; 2]> {
        self.ends(contact, approach, row).map(|(ends, _)| ends)
    }
}

/// The causes that widen the band of an impact, beside the error of the law.
struct Reasons {
    /// True for each of [`Uncertainty::hardness`] that changes e.
    hardness: [bool; 2],
    is_plate: bool,
    biases: Vec<Bias>,
}

/// The contact with the other theory of its plate, if it has one. The theory of a thin plate leaves out what that of a thick one
/// adds, and a thick plate takes at most a quarter of this more again.
fn of_other_theory(contact: &Contact) -> Option<(Contact, f64)> {
    let forces = contact.forces();
    let plate = forces.plate?;
    let (theory, share) = match plate.theory {
        PlateTheory::Zener => (PlateTheory::Thick, 1.0),
        PlateTheory::Thick => (PlateTheory::Zener, 0.25),
    };
    Some((contact.clone().with_forces(Forces { plate: Some(Plate { theory, ..plate }), ..*forces }), share))
}

/// The band of the restitution of an impact of this input and its contact. `None` where [`Uncertainty`] has none.
pub fn band(input: &Input, contact: &Contact, speed: f64, row: &Essentials) -> Option<Band> {
    let uncertainty = Uncertainty::new(input, contact)?;
    let ([low, high], reasons) = uncertainty.ends(contact, input.approach_at(speed), row)?;
    let parts = uncertainty.hardness.iter().zip(reasons.hardness).filter(|(_, is_part)| *is_part);
    let mut because: Vec<_> = parts
        .map(|((body, Known { range: [soft, hard], .. }, _), _)| {
            format!("{} {} to {}", body.pick(["hardness of the sphere", "hardness"]), soft.text, hard.text)
        })
        .collect();
    because.extend(reasons.biases.iter().map(|bias| bias.reason.to_owned()));
    because.extend(reasons.is_plate.then(|| "theory of the plate".to_owned()));
    because.push(format!("law {}", percent(uncertainty.error)));
    Some(Band { low, high, because: because.join(", ") })
}
