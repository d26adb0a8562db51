//! The uncertainty interval of e: the range that holds the measured e of an impact with 95 % probability. It covers the sources of
//! error that the program knows.
//!
//! ```text
//! e_true/e ∈ Π [1 + low_i, 1 + high_i] × (1 ± √Σ width_j²)
//! ```
//!
//! A shift i is a known bias: both ends move. A width j is scatter. e is the restitution with waves if the density of the half-space
//! is known, because this is the measured restitution.

pub mod dent;
pub mod law_error;
mod strength;

use crate::contact::law::LawChoice;
use crate::impact::{Approach, Bias, Contact, Forces, ImpactRow, Plate, PlateTheory, Solver, Waveguide};
use crate::numerics::functions::powi;
pub use crate::results::restitution_interval::{IntervalPart, PartKind, RestitutionInterval, SMALL};
use crate::results::restitution_interval::{LAW_BIAS, LAW_SCATTER};
use crate::scenario::input::Input;
pub use dent::dent_interval;
use law_error::{has_law_error, law_error, poissons_ratio_part};
use strength::{HardnessRange, strength_parts};
pub use strength::{HardnessRanges, WHICH_STRENGTH, expected_notes, has_strength_parts, strength_notes};

/// A smaller relative change of e is rounding.
const ROUNDING: f64 = 1e-9;

/// The sources of error of e at a contact that do not depend on the speed.
#[derive(Debug)]
pub struct Uncertainty {
    law: LawChoice,
    /// The parts that depend only on the bodies: from the strengths and from Poisson's ratio.
    of_bodies: Vec<IntervalPart>,
    /// The ranges of hardness of named materials, each with the contacts at its lowest and its highest value.
    hardness: Vec<(HardnessRange, [Contact; 2])>,
    /// On a plate: the contact by the other plate theory, and the fraction of the difference that may be missing.
    other_plate: Option<(Contact, f64)>,
}

impl Uncertainty {
    /// `None` for a law or an exponent whose error is not known, for bodies for which the law was not made, for a negative Poisson's
    /// ratio, and where a contact at an end of a range of hardness does not exist.
    pub fn new(input: &Input, contact: &Contact, law: &LawChoice, ranges: &HardnessRanges) -> Option<Self> {
        if !has_law_error(law) {
            return None;
        }
        let mut of_bodies = strength_parts(input, contact, law)?;
        of_bodies.extend(poissons_ratio_part(input, contact, law)?);
        let mut hardness = Vec::new();
        for range in ranges.ranges() {
            let at = |strengths: [Option<f64>; 2]| {
                let (mut sphere, mut half_space) = (*contact.sphere(), *contact.half_space());
                sphere.yield_strength = strengths[0].or(sphere.yield_strength);
                half_space.yield_strength = strengths[1].or(half_space.yield_strength);
                input.contact_of(sphere, half_space, law).ok()
            };
            let [low, high] = range.strengths.map(at);
            hardness.push((range.clone(), [low?, high?]));
        }
        Some(Self { law: law.clone(), of_bodies, hardness, other_plate: contact_of_other_theory(contact) })
    }

    /// Visits the parts of the interval of an impact with this result: name, kind, and both ends relative to e, minus 1. `None` without
    /// a dent, without a rebound, and if a warning reports an error of e of unknown size.
    fn visit_parts(
        &self,
        contact: &Contact,
        approach: Approach,
        row: &ImpactRow,
        mut visit: impl FnMut(&str, PartKind, [f64; 2]),
    ) -> Option<()> {
        let restitution = row.measured_restitution();
        if !(row.has_dent() && restitution > 0.0 && row.restitution < 1.0) {
            return None;
        }
        let change = |other: &Contact| {
            let other = other.row(approach, &Solver::AUTO).ok()?;
            Some(other.measured_restitution() / restitution - 1.0)
        };
        let biases = contact.known_biases(approach.normal, row)?;
        let error = law_error(&self.law, contact, row.radius_ratio)?;
        for (range, contacts) in &self.hardness {
            let [low, high] = contacts.each_ref().map(change);
            let (low, high) = (low?, high?);
            // a body that does not yield does not change e
            if low.abs().max(high.abs()) > ROUNDING {
                visit(&range.name, PartKind::Width, [low.min(0.0), high.max(0.0)]);
            }
        }
        for IntervalPart { name, kind, low, high } in &self.of_bodies {
            visit(name, *kind, [*low, *high]);
        }
        for Bias { reason, is_shift, low, high } in biases {
            visit(reason, if is_shift { PartKind::Shift } else { PartKind::Width }, [low, high]);
        }
        if let Some((other, share)) = &self.other_plate {
            visit("theory of the plate", PartKind::Width, [-share * change(other)?.abs(), 0.0]);
        }
        let mean = 1.0 / (1.0 + error.mean) - 1.0;
        visit(LAW_BIAS, PartKind::Shift, [mean, mean]);
        let end = |quantile: f64| (1.0 + error.mean) / (1.0 + quantile) - 1.0;
        visit(LAW_SCATTER, PartKind::Width, [end(error.high), end(error.low)]);
        Some(())
    }

    /// Both ends of e in an impact with this result, for a table.
    pub fn interval_ends(&self, contact: &Contact, approach: Approach, row: &ImpactRow) -> Option<[f64; 2]> {
        let (mut shift, mut squares) = ([1.0; 2], [0.0; 2]);
        self.visit_parts(contact, approach, row, |_, kind, ends| match kind {
            PartKind::Shift => shift.iter_mut().zip(ends).for_each(|(shift, end)| *shift *= 1.0 + end),
            PartKind::Width => squares.iter_mut().zip(ends).for_each(|(sum, end)| *sum += powi(end, 2)),
            PartKind::NotIncluded => {}
        })?;
        let e = row.measured_restitution();
        let [low, high] = [shift[0] * (1.0 - squares[0].sqrt()), shift[1] * (1.0 + squares[1].sqrt())];
        Some([(e * low).max(0.0), (e * high).min(1.0)])
    }

    /// The interval of an impact with this result, in which the two parts of the law are combined.
    fn interval(&self, contact: &Contact, approach: Approach, row: &ImpactRow) -> Option<RestitutionInterval> {
        let [low, high] = self.interval_ends(contact, approach, row)?;
        let mut parts = Vec::new();
        self.visit_parts(contact, approach, row, |name, kind, [low, high]| {
            parts.push(IntervalPart { name: name.to_owned(), kind, low, high });
        })?;
        Some(RestitutionInterval { low, high, parts })
    }
}

/// The contact by the other theory of its plate, if there is one. The theory of a thin plate omits the additional term of a thick
/// plate, and the loss of a thick plate exceeds that theory by at most a quarter of this term.
fn contact_of_other_theory(contact: &Contact) -> Option<(Contact, f64)> {
    let forces = contact.forces();
    let plate = *forces.waveguide.as_ref()?.plate()?;
    let (theory, share) = match plate.theory {
        PlateTheory::Zener => (PlateTheory::Thick, 1.0),
        PlateTheory::Thick => (PlateTheory::Zener, 0.25),
    };
    Some((
        contact.clone().with_forces(Forces { waveguide: Some(Waveguide::Plate(Plate { theory, ..plate })), ..*forces }),
        share,
    ))
}

/// The interval of the restitution of an impact of this input and its contact; `None` where [`Uncertainty`] has none.
pub fn restitution_interval(
    input: &Input,
    contact: &Contact,
    speed: f64,
    row: &ImpactRow,
) -> Option<RestitutionInterval> {
    let law = input.law();
    let uncertainty = Uncertainty::new(input, contact, &law, &HardnessRanges::new(input, &law))?;
    uncertainty.interval(contact, input.approach_at(speed), row)
}
