//! What is known of one impact beyond its motion: the band of e.

use crate::impact::{Contact, Impact, Solver};
use crate::law::{LawChoice, UnloadingExponent};
use crate::math::functions::hypot;
use crate::scene::Input;
use crate::scene::at::at;
use crate::scene::results::impact::{Band, Single};
use crate::units::rounded::percent;

/// An impact of this input with all that is reported of it.
pub fn single<'a>(input: &Input, contact: &'a Contact, impact: &'a Impact) -> Single<'a> {
    let band = band(input, impact.speed, impact.restitution).filter(|_| impact.has_dent());
    Single { contact, impact, band }
}

/// The key whose value a material leaves open by its range.
const HARDNESS: &str = "half_space.hardness";

/// Root mean square deviation of e from the finite elements of this project, as `validate` prints it.
const PRESSURE_SHAPE: f64 = 0.01;
const PAPER: f64 = 0.032;

/// The band of the restitution of this input at a speed. `None` for elastic bodies, for an exponent or a law without a stated error, and
/// without a rebound.
///
/// At both ends of the range of the material's hardness e is computed anew; its distance and the error of the law are added
/// as squares, because they are independent.
fn band(input: &Input, speed: f64, restitution: f64) -> Option<Band> {
    let LawChoice::Plm(law) = input.law() else { return None };
    let error = match law.exponent {
        UnloadingExponent::PressureShape => PRESSURE_SHAPE,
        UnloadingExponent::Paper => PAPER,
        UnloadingExponent::Fixed(_) => return None,
    };
    if !(input.can_yield() && restitution > 0.0 && restitution < 1.0) {
        return None;
    }
    let (mut ends, mut because) = ([restitution; 2], Vec::new());
    let hardness = input.taken().iter().flat_map(|taken| taken.values().map(move |(key, known)| (taken, key, known)));
    for (taken, key, known) in hardness.filter(|(_, key, _)| *key == HARDNESS) {
        for (end, written) in ends.iter_mut().zip(&known.range) {
            let mut input = input.clone();
            input.set(at!("half_space.hardness"), Some(taken.in_key(key, written.value)));
            let row = input.contact().ok()?.row(input.approach_at(speed), &Solver::AUTO).ok()?;
            *end = row.restitution;
        }
        because.push(format!("hardness {} to {}", known.range[0].text, known.range[1].text));
    }
    because.push(format!("law {}", percent(error)));
    let reach = |end: f64| hypot(end - restitution, error * restitution);
    let (low, high) = ((restitution - reach(ends[0])).max(0.0), (restitution + reach(ends[1])).min(1.0));
    Some(Band { low, high, because: because.join(", ") })
}
