//! A half-space with another Poisson's ratio than 0.3, at the work of the finite elements.
//!
//! The finite elements have a control with ν = 0.3, the same mesh and the same depths. The errors that both have in common drop out of
//! the ratio of their restitutions.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use super::load_cycle::LoadCycle;
use crate::contact::body::{HalfSpace, Material};
use crate::contact::law::{Plm, PlmCoefficients, UnloadingExponent, YieldingPair};
use crate::contact::pair::{Pair, PairError};
use crate::error::Error;
use crate::reference::{POISSONS_RATIOS, ReferenceRow};

const SOURCE: &str =
    "finite elements with Poisson's ratios from 0.03 to 0.42, CalculiX 2.20, src/reference/fe_poisson.csv";

/// ν of the control.
const CONTROL: f64 = 0.3;

/// A load cycle by finite elements, and by the law; and the control by the law.
pub(super) struct PoissonCycle {
    pub(super) row: ReferenceRow,
    cycle: LoadCycle,
    control: LoadCycle,
}

impl PoissonCycle {
    /// Restitution over the restitution of the control, by finite elements and by the law.
    pub(super) fn ratios(&self) -> [f64; 2] {
        let of_row = self.row.number("restitution") / self.row.number("restitution_of_control");
        [of_row, self.cycle.restitution / self.control.restitution]
    }
}

/// The bodies of the control.
fn control(row: &ReferenceRow) -> Result<Option<YieldingPair>, PairError> {
    let material = Material { youngs_modulus: row.number("control_youngs_modulus_Pa"), poissons_ratio: CONTROL };
    let half_space = HalfSpace { material, ..row.half_space() };
    Ok(YieldingPair::new(&Pair::try_new(&row.ball(), &half_space)?))
}

/// The load cycles of the table by the law with this exponent of unloading.
pub(super) fn cycles(coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Result<Vec<PoissonCycle>, Error> {
    let plm = Plm::new(coefficients, exponent);
    let cycle = |bodies: &YieldingPair, spent: f64| LoadCycle::with_work(&plm.law_for_yielding_pair(bodies), spent);
    let mut cycles = Vec::new();
    for row in POISSONS_RATIOS.rows()? {
        if let (Some(bodies), Some(control)) = (row.bodies()?, control(&row)?) {
            let [own, of_control] =
                [(&bodies, "spent"), (&control, "spent_of_control")].map(|(of, spent)| cycle(of, row.number(spent)));
            cycles.push(PoissonCycle { row, cycle: own, control: of_control });
        }
    }
    Ok(cycles)
}

const QUANTITIES: [ComparedQuantity<PoissonCycle>; 3] = [
    (Group::new("Poisson's ratio: restitution over that at 0.3, pressure-shape", SOURCE, ""), |cycle| {
        Some(cycle.ratios())
    }),
    (Group::new("Poisson's ratio: restitution, pressure-shape", SOURCE, ""), |PoissonCycle { row, cycle, .. }| {
        Some([row.number("restitution"), cycle.restitution])
    }),
    (Group::new("Poisson's ratio: peak force", SOURCE, ""), |PoissonCycle { row, cycle, .. }| {
        Some([row.number("f"), cycle.peak.force])
    }),
];

pub(super) fn unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let name = |PoissonCycle { row, .. }: &PoissonCycle| {
        let [poissons_ratio, x] = ["half_space_poissons_ratio", "x"].map(|column| row.number(column));
        format!("{}, ν = {poissons_ratio}, x = {x}", row.cell_text("case"))
    };
    Ok(compare_all(&QUANTITIES, &cycles(coefficients, UnloadingExponent::PressureShape)?, name))
}
