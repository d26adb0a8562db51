//! Bodies of which the sphere yields, or both: load cycles of finite elements, and two equal balls against a ball on a wall.

use super::comparison::{self, ComparedQuantity, Comparison, Group};
use super::load_cycle::LoadCycle;
use crate::contact::body::{HalfSpace, Material, STEEL_DENSITY, Sphere, Support};
use crate::contact::law::{Law, Plm, PlmCoefficients, UnloadingExponent, YieldingPair};
use crate::contact::pair::{Pair, PairError};
use crate::error::Error;
use crate::impact::Contact;
use crate::reference::{ReferenceRow, YIELDING};

const SOURCE: &str = "finite elements, CalculiX 2.20, src/reference/fe_yielding.csv";

/// Fewer elements in contact leave an error of 2 % in the work.
const MIN_ELEMENTS: f64 = 9.0;

/// A load cycle by the finite elements and by the law.
pub(super) struct YieldingCycle {
    pub(super) row: ReferenceRow,
    pub(super) law: Law,
    pub(super) bodies: YieldingPair,
    /// x of the finite elements.
    pub(super) at_depth: f64,
    pub(super) at_work: LoadCycle,
}

impl YieldingCycle {
    fn new(
        row: ReferenceRow,
        coefficients: &PlmCoefficients,
        exponent: UnloadingExponent,
    ) -> Result<Option<Self>, Error> {
        let Some(bodies) = YieldingPair::new(&pair(&row)?) else { return Ok(None) };
        let law = Plm::new(coefficients, exponent).law_for_yielding_pair(&bodies);
        let point = bodies.yield_point;
        let at_work = LoadCycle::with_work(&law, row.number("W_J") / (point.force * point.indentation));
        let at_depth = row.number("delta_m") / point.indentation;
        Ok(Some(Self { row, law, bodies, at_depth, at_work }))
    }
}

/// The two bodies of a row. A load cycle is slow, so they have no density.
fn pair(row: &ReferenceRow) -> Result<Pair, PairError> {
    let body = |name: &str| {
        let [youngs_modulus, poissons_ratio] =
            ["youngs_modulus", "poissons_ratio"].map(|key| row.number(&format!("{name}.{key}")));
        (Material { youngs_modulus, poissons_ratio }, row.optional_number(&format!("{name}.yield_strength")))
    };
    let ((material, yield_strength), (half_space, strength)) = (body("sphere"), body("half_space"));
    let sphere = Sphere::elastic(row.number("sphere.radius"), material, f64::NAN);
    Pair::try_new(&Sphere { yield_strength, ..sphere }, &HalfSpace::flat(half_space, strength))
}

/// The cycles with enough elements in contact.
pub(super) fn yielding_cycles(
    coefficients: &PlmCoefficients,
    exponent: UnloadingExponent,
) -> Result<Vec<YieldingCycle>, Error> {
    let rows = YIELDING.rows()?.into_iter().filter(|row| row.number("elements_in_contact") >= MIN_ELEMENTS);
    rows.filter_map(|row| YieldingCycle::new(row, coefficients, exponent).transpose()).collect()
}

const QUANTITIES: [ComparedQuantity<YieldingCycle>; 4] = [
    (Group::new("sphere or both yield: restitution, pressure-shape", SOURCE, ""), |cycle| {
        Some([cycle.row.number("e"), cycle.at_work.restitution])
    }),
    (Group::new("sphere or both yield: force at the same depth", SOURCE, "N"), |cycle| {
        Some([cycle.row.number("F_N"), cycle.law.loading.force(cycle.at_depth) * cycle.bodies.yield_point.force])
    }),
    (Group::new("sphere or both yield: contact radius at the same depth", SOURCE, "R"), |cycle| {
        let radius = cycle.law.contact_radius(&cycle.law.loaded_state(cycle.at_depth));
        Some([cycle.row.number("contact_radius_over_R"), radius * cycle.bodies.yield_radius_ratio()])
    }),
    (
        Group::new_difference(
            "sphere or both yield: residual indentation, deviation over peak indentation",
            SOURCE,
            "",
        ),
        |cycle| {
            let of_law = cycle.law.loaded_state(cycle.at_depth).residual() / cycle.at_depth;
            Some([cycle.row.number("residual_m") / cycle.row.number("delta_m"), of_law])
        },
    ),
];

pub(super) fn load_cycles(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let name = |cycle: &YieldingCycle| {
        format!("{}, a/R = {}", cycle.row.cell_text("case"), cycle.row.number("contact_radius_over_R"))
    };
    Ok(comparison::compare_all(&QUANTITIES, &yielding_cycles(coefficients, UnloadingExponent::PressureShape)?, name))
}

const WEIR_TALLON: Group = Group::new(
    "measured: restitution of two equal balls over that of one on a flat wall",
    "Weir and Tallon (2005), Chem. Eng. Sci. 60, 3637, abstract: about 19 % smaller, predicted and confirmed by experiments",
    "",
);

/// Closing speeds \[m/s\] of steel balls of 5 mm with 345 MPa, and walls: their strengths over that of the balls. The abstract
/// names neither.
const SPEEDS: [f64; 3] = [0.3, 1.0, 3.0];
const WALLS: [(&str, f64); 2] = [("equally strong wall", 1.0), ("much harder wall", 10.0)];

/// Two equal balls, and one of them on a flat wall of its modulus at the same closing speed. Waves, which only the wall has, are
/// left out.
pub(super) fn equal_balls(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let (radius, density, strength) = (5e-3, STEEL_DENSITY, 345e6);
    let ball = Sphere { yield_strength: Some(strength), ..Sphere::elastic(radius, Material::STEEL, density) };
    let wall = |strength| HalfSpace { density: Some(density), ..HalfSpace::flat(Material::STEEL, Some(strength)) };
    let law = Plm::new(coefficients, UnloadingExponent::PressureShape);
    let on_ball =
        Contact::try_new(ball, HalfSpace { radius: Some(radius), support: Support::Ball, ..wall(strength) }, &law)?;
    let mut compared = Vec::new();
    for (name, harder) in WALLS {
        let on_wall = Contact::try_new(ball, wall(harder * strength), &law)?;
        for speed in SPEEDS {
            let of_law = on_ball.closed_form(speed)?.row.restitution / on_wall.closed_form(speed)?.row.restitution;
            compared.push(WEIR_TALLON.compare(format!("{name}, {speed} m/s"), [0.81, of_law]));
        }
    }
    Ok(compared)
}
