//! The uncertainty interval of a dent: diameter and depth, by the range of hardness of a named material and by the error of the law.

use super::{HardnessRanges, ROUNDING, Uncertainty};
use crate::impact::{Contact, ImpactRow, Solver};
use crate::numerics::functions::powi;
use crate::results::dent_interval::DentInterval;
use crate::scenario::input::Input;

/// Twice the rms error of the contact radius against finite elements, relative.
const DIAMETER_ERROR: f64 = 0.038;
/// Twice the rms error of the residual indentation against finite elements, over the peak indentation.
const DEPTH_ERROR: f64 = 0.018;

/// The interval (95 %) of the dent of an impact of this input and its contact; `None` without a dent, and where the interval of e is not
/// known.
pub fn dent_interval(input: &Input, contact: &Contact, speed: f64, row: &ImpactRow) -> Option<DentInterval> {
    let (law, approach) = (input.law(), input.approach_at(speed));
    let uncertainty = Uncertainty::new(input, contact, &law, &HardnessRanges::new(input, &law))?;
    let dent = |row: &ImpactRow| [2.0 * row.peak_contact_radius, row.residual_indentation];
    let values = Some(dent(row)).filter(|_| row.dent_depth() > 0.0)?;
    let depth_error = DEPTH_ERROR * row.peak_indentation / row.residual_indentation;
    // squares of the relative widths below and above, of diameter and depth
    let mut squares = [DIAMETER_ERROR, depth_error].map(|error| [powi(error, 2); 2]);
    for (_, contacts) in &uncertainty.hardness {
        for other in contacts {
            let other = dent(&other.row(approach, &Solver::AUTO).ok()?);
            for ((value, other), squares) in values.iter().zip(other).zip(&mut squares) {
                let change = other / value - 1.0;
                if change.abs() > ROUNDING {
                    squares[usize::from(change > 0.0)] += powi(change, 2);
                }
            }
        }
    }
    let [diameter, depth] = [0, 1].map(|at| {
        let [low, high] = squares[at];
        [values[at] * (1.0 - low.sqrt()).max(0.0), values[at] * (1.0 + high.sqrt())]
    });
    Some(DentInterval { diameter, depth })
}
