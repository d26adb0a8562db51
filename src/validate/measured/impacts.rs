//! The rows of a measured set as impacts of the program.

use crate::contact::body::HalfSpace;
use crate::contact::law::{LawChoice, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::impact::{Approach, Contact, ImpactRow, Solver};
use crate::numerics::functions::{exp, ln};
use crate::numerics::root;
use crate::reference::ReferenceRow;
use crate::reference::measured::MeasuredSet;
use crate::scenario::{Override, Scenario};

/// Tangential speed of the centre of the sphere relative to that of a second ball.
pub(super) const RELATIVE_SPEED: &str = "relative_tangential_speed_m_per_s";

/// A measured impact, by the program.
pub(super) struct MeasuredImpact<'a> {
    pub(super) row: &'a ReferenceRow,
    pub(super) contact: Contact,
    pub(super) approach: Approach,
    pub(super) by_law: ImpactRow,
}

/// Tangential speed \[m/s\] of the centre of the sphere relative to that of the other body.
pub(super) fn relative_tangential_speed(by_law: &ImpactRow) -> Option<f64> {
    let after = by_law.rebound?;
    Some(after.tangential.speed - after.target.map_or(0.0, |target| target.speed))
}

/// The strength \[Pa\] with this restitution, by bisection: e rises with the strength.
fn strength_with_restitution(wanted: f64, restitution: impl Fn(f64) -> Option<f64>) -> f64 {
    let is_low = |strength: f64| restitution(exp(strength)).is_some_and(|e| e < wanted);
    let (low, high) = root::bisect(ln(1e6), ln(1e11), is_low);
    exp(0.5 * (low + high))
}

/// The contact of a row and its approach; `None` for a row whose bodies are not known. With a dent the
/// half-space has the strength that gives the measured restitution.
pub(super) fn contact_of(
    set: &MeasuredSet,
    row: &ReferenceRow,
    coefficients: &PlmCoefficients,
    has_dent: bool,
) -> Result<Option<(Contact, Approach)>, Error> {
    let keys = set.keys(row);
    if !keys.iter().any(|key| key.starts_with("sphere.youngs_modulus")) {
        return Ok(None);
    }
    let input = Scenario::from_text(set.file, "", &Override::list(&keys))?.resolve()?;
    let law = LawChoice::Plm(Plm::new(coefficients, UnloadingExponent::PressureShape));
    let (sphere, mut half_space) = input.bodies(&law);
    if has_dent {
        let wanted = row.number("restitution");
        half_space.yield_strength = Some(strength_with_restitution(wanted, |strength| {
            let half_space = HalfSpace { yield_strength: Some(strength), ..half_space };
            let contact = input.contact_of(sphere, half_space, &law).ok()?;
            Some(contact.closed_form(input.speed()).ok()?.row.measured_restitution())
        }));
    }
    Ok(Some((input.contact_of(sphere, half_space, &law)?, input.approach())))
}

/// True if the energy that the row loses is that of a dent.
pub(super) fn loses_by_dent(row: &ReferenceRow) -> bool {
    row.cell_text("loss") == "dent"
}

/// The impacts of a set by the law; a row whose bodies are not known has none.
pub(super) fn impacts_of<'a>(
    set: &'a MeasuredSet,
    coefficients: &PlmCoefficients,
) -> Result<Vec<MeasuredImpact<'a>>, Error> {
    let mut impacts = Vec::new();
    for row in &set.rows {
        let Some((contact, approach)) = contact_of(set, row, coefficients, loses_by_dent(row))? else { continue };
        let by_law = contact.impact(approach, &Solver::AUTO, None)?.row;
        impacts.push(MeasuredImpact { row, contact, approach, by_law });
    }
    Ok(impacts)
}

/// The sets with the tangential speeds of two balls.
pub(super) fn sets_of_two_balls(sets: &[MeasuredSet]) -> impl Iterator<Item = &MeasuredSet> {
    let is_compared = |set: &&MeasuredSet| set.compared_columns().iter().any(|column| column.column == RELATIVE_SPEED);
    sets.iter().filter(is_compared)
}
