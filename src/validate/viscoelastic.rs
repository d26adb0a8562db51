//! Viscoelastic impacts: the restitution against a published formula of the same model, and the one public test of the transfer of A from
//! one pair of bodies to another.

use super::comparison::{Comparison, Group};
use crate::contact::body::{HalfSpace, Material, Sphere, Support};
use crate::contact::law::PlmCoefficients;
use crate::contact::law::catalogue::hertz::Hertz;
use crate::error::Error;
use crate::impact::{Contact, Damping, Forces, ImpactError, Solver};
use crate::numerics::functions::pow;
use crate::numerics::root::illinois;
use crate::reference::damaged_table;
use crate::reference::measured::measured_sets;

const PADE: Group = Group::new(
    "viscoelastic: restitution up to a loss parameter w of 0.5",
    "the formula of Müller and Pöschel (2011), Phys. Rev. E 84, 021302",
    "",
);
const WIDE_PADE: Group = Group { quantity: "viscoelastic: restitution, w from 0.6 to 1", ..PADE };
const TRANSFER: Group = Group::new(
    "measured: restitution of two viscoelastic balls, by the rebound of one from a wall",
    "Louge, Fall 1999 Impact Parameter Chart: cellulose acetate, src/reference/measured/impact_chart_1999.csv",
    "",
);

/// e of Müller and Pöschel, a quotient of polynomials, with w² = a = (3/2) A v/L.
fn restitution_by_formula(w: f64) -> f64 {
    let numerator = 1.0 + 0.501_086 * w;
    numerator / (numerator + w * w * (1.153_45 + w * (0.577_977 + w * 0.532_178)))
}

const CHART: &str = "impact_chart_1999.csv";
/// The rows of the chart: the fit of A, and its test.
const PAIRS: [&str; 2] = ["cellulose acetate on smooth aluminium", "two balls of cellulose acetate"];
/// Usual constants of cellulose acetate and aluminium, which the chart does not have; radius and density are those of the chart.
const ACETATE: Material = Material { youngs_modulus: 3.2e9, poissons_ratio: 0.28 };
const ALUMINIUM: Material = Material { youngs_modulus: 70e9, poissons_ratio: 0.33 };
const RADIUS: f64 = 2.995e-3;
const DENSITY: f64 = 1319.0;
/// The chart has no speed. The ratio of both losses does not depend on it.
const SPEED: f64 = 1.0;

/// e of a pair of the chart.
fn measured_restitution(pair: &str) -> Result<f64, Error> {
    let sets = measured_sets()?;
    let mut rows = sets.iter().filter(|set| set.file == CHART).flat_map(|set| &set.rows);
    let row = rows.find(|row| row.cell_text("case") == pair);
    Ok(row.ok_or_else(|| damaged_table(CHART, &format!("no row \"{pair}\"")))?.number("restitution"))
}

fn contact(half_space: HalfSpace) -> Result<Contact, ImpactError> {
    Contact::try_new(Sphere::elastic(RADIUS, ACETATE, DENSITY), half_space, &Hertz)
}

/// e of a contact with this A \[s\].
fn restitution(contact: &Contact, time: f64) -> Result<f64, ImpactError> {
    let damping = Some(Damping::Viscoelastic(time));
    let damped = contact.clone().with_forces(Forces { damping, ..Forces::default() });
    Ok(damped.row(SPEED, &Solver::AUTO)?.restitution)
}

/// A \[s\] with a = (3/2) A v/L.
fn time_of(contact: &Contact, a: f64) -> f64 {
    let length = pow(contact.reduced_mass() * SPEED * SPEED / contact.pair().hertz_stiffness(), 0.4);
    a * length / (1.5 * SPEED)
}

/// The coefficients of the PLM have no part in it.
pub(super) fn restitutions(_: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let wall = contact(HalfSpace::flat(ALUMINIUM, None))?;
    let mut compared = Vec::new();
    for tenth in 1..=10 {
        let w = 0.1 * f64::from(tenth);
        let group = if tenth <= 5 { PADE } else { WIDE_PADE };
        let own = restitution(&wall, time_of(&wall, w * w))?;
        compared.push(group.compare(format!("w = {w:.1}"), [restitution_by_formula(w), own]));
    }
    let [on_wall, on_ball] = [measured_restitution(PAIRS[0])?, measured_restitution(PAIRS[1])?];
    let beside = |time: f64| restitution(&wall, time).unwrap_or(f64::NAN) - on_wall;
    let time = illinois((0.0, time_of(&wall, 1.0)), beside);
    let ball = HalfSpace {
        radius: Some(RADIUS),
        density: Some(DENSITY),
        support: Support::Ball,
        ..HalfSpace::flat(ACETATE, None)
    };
    let predicted = restitution(&contact(ball)?, time)?;
    compared.push(TRANSFER.compare(PAIRS[1].to_owned(), [on_ball, predicted]));
    Ok(compared)
}
