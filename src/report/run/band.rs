//! The band of e: how far the hardness of a material by name, and the error of the law, leave it open.

use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::impact::{Impact, Solver};
use crate::numerics::functions::powi;
use crate::scenario::scene::Input;
use crate::scenario::scene::results::impact::Band;
use crate::units::percent;

/// A smaller change of e, as a share of it, is rounding.
const LEAST: f64 = 1e-9;

/// Root mean square deviation of e from the finite elements of this project, as `validate` prints it.
const PRESSURE_SHAPE: f64 = 0.01;
const PAPER: f64 = 0.032;

/// The band of the restitution of an impact of this input. `None` without a dent, for an exponent or a law without a stated error,
/// and without a rebound.
///
/// At both ends of the range of the material's hardness e is computed anew; its distance and the error of the law are added
/// as squares, because they are independent.
pub fn band(input: &Input, impact: &Impact) -> Option<Band> {
    let (speed, restitution) = (impact.speed, impact.restitution);
    let LawChoice::Plm(law) = input.law() else { return None };
    let error = match law.exponent {
        UnloadingExponent::PressureShape => PRESSURE_SHAPE,
        UnloadingExponent::Paper => PAPER,
        UnloadingExponent::Fixed(_) => return None,
    };
    if !(impact.has_dent() && restitution > 0.0 && restitution < 1.0) {
        return None;
    }
    let (mut squares, mut because) = ([powi(error * restitution, 2); 2], Vec::new());
    let hardness =
        input.materials().iter().flat_map(|taken| taken.values().map(move |(key, known)| (taken, key, known)));
    for (taken, key, known) in hardness {
        let at = taken.body.strength_keys().hardness;
        if at.path() != key {
            continue;
        }
        let body = taken.body.of(["hardness of the sphere", "hardness"]);
        let mut ends = [restitution; 2];
        for (end, written) in ends.iter_mut().zip(&known.range) {
            let mut input = input.clone();
            input.set(at, Some(written.value));
            *end = input.contact().ok()?.row(input.approach_at(speed), &Solver::AUTO).ok()?.restitution;
        }
        // a body that does not flow leaves e as it is
        if ends.iter().any(|end| (end - restitution).abs() > LEAST * restitution) {
            squares.iter_mut().zip(ends).for_each(|(sum, end)| *sum += powi(end - restitution, 2));
            because.push(format!("{body} {} to {}", known.range[0].text, known.range[1].text));
        }
    }
    because.push(format!("law {}", percent(error)));
    let [below, above] = squares.map(f64::sqrt);
    let (low, high) = ((restitution - below).max(0.0), (restitution + above).min(1.0));
    Some(Band { low, high, because: because.join(", ") })
}
