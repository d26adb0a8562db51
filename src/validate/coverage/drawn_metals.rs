//! Samples of every named metal with a random hardness, hardening exponent and strain rate, and the error of the law in a load cycle.

use std::fmt::Write as _;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};
use rayon::prelude::*;

use super::share::{Coverage, PRESSURE_SHAPE};
use crate::contact::law::{PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::impact::Solver;
use crate::materials::{MaterialEntry, Property, RateClass, all_materials};
use crate::results::restitution_interval::RestitutionInterval;
use crate::scenario::Scenario;
use crate::scenario::input::Input;
use crate::scenario::keys::interval::law_error::BodyClass;
use crate::scenario::keys::interval::restitution_interval;
use crate::validate::law_error::cycle_errors;

const SPEEDS: [f64; 4] = [0.3, 1.0, 3.0, 5.0];
/// Samples at each speed.
const SAMPLES: usize = 120;

/// Constants c of Johnson and Cook that metals of a class have: of hard steels and of 4340; of 6061-T6 to 2024-T3 and mild steel at
/// most as 4340; of copper (Johnson and Cook 1983).
const fn rate_constants(class: RateClass) -> [f64; 2] {
    match class {
        RateClass::QuenchedSteel => [0.006, 0.014],
        RateClass::MildSteelOrAluminium => [0.0, 0.015],
        RateClass::Copper => [0.015, 0.025],
    }
}

/// Hardness, exponent of hardening and constant of the strain rate of one sample of this metal, each drawn from what is known of it.
fn drawn_keys(entry: &MaterialEntry, uniform: &mut impl FnMut([f64; 2]) -> f64) -> Option<String> {
    let range = |property: Property| Some(entry.get(property)?.range.each_ref().map(|end| end.value));
    let mut text = format!("hardness = {}\n", uniform(range(Property::Hardness)?));
    // by the finite elements behind the warning, metals that harden have exponents of 0.1 to 0.3
    let exponents = range(Property::HardeningExponent).or(entry.lacks_exponent.then_some([0.1, 0.3]));
    if let Some(exponents) = exponents {
        let _ = writeln!(text, "flow_stress.power.exponent = {}", uniform(exponents));
    }
    if let Some(class) = entry.rate_class {
        let _ = writeln!(text, "rate.johnson_cook.c = {}", uniform(rate_constants(class)));
    }
    Some(text)
}

fn input_of(text: &str) -> Result<Input, Error> {
    Scenario::from_text("sample", text, &[])?.resolve()
}

fn interval_by_name(text: &str) -> Option<RestitutionInterval> {
    let input = input_of(text).ok()?;
    let contact = input.contact().ok()?;
    let row = contact.row(input.approach(), &Solver::AUTO).ok()?;
    restitution_interval(&input, &contact, input.speed(), &row)
}

/// The restitution of a sample that is known completely; `None` for a sample that the program rejects.
fn restitution(text: &str) -> Option<f64> {
    let input = input_of(text).ok()?;
    Some(input.contact().ok()?.row(input.approach(), &Solver::AUTO).ok()?.measured_restitution())
}

/// The samples of each metal in the interval that follows from its name, the least share first. The samples are the same on every machine.
pub fn drawn_metals() -> Result<Vec<Coverage>, Error> {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut uniform = |[low, high]: [f64; 2]| low + (high - low) * f64::from(random.next_u32()) / f64::from(u32::MAX);
    let errors = cycle_errors(PlmCoefficients::built_in(), UnloadingExponent::PressureShape)?;
    // the half-space yields alone, as in the load cycles of this class
    let of_law: Vec<f64> =
        errors.iter().filter(|(class, ..)| *class == BodyClass::PerfectlyPlastic).map(|(.., error)| *error).collect();
    let mut metals = Vec::new();
    for entry in all_materials().iter().filter(|entry| entry.is_metal() && !entry.creeps) {
        let mut drawn = Vec::new();
        for speed in SPEEDS {
            let text = format!(
                "[sphere]\nmaterial = \"steel-52100-hardened\"\ndiameter = \"10 mm\"\n[impact]\nspeed = {speed}\n{PRESSURE_SHAPE}[half_space]\nmaterial = \"{}\"\n",
                entry.name
            );
            let Some(interval) = interval_by_name(&text) else { continue };
            let samples = (0..SAMPLES).filter_map(|_| drawn_keys(entry, &mut uniform));
            drawn.extend(samples.map(|keys| (text.clone() + &keys, [interval.low, interval.high])));
        }
        let computed: Vec<(f64, [f64; 2])> =
            drawn.par_iter().filter_map(|(text, ends)| Some((restitution(text)?, *ends))).collect();
        let is_inside = |(&(e, [low, high]), error): (&(f64, [f64; 2]), &f64)| {
            let e = (e / (1.0 + error)).min(1.0);
            low <= e && e <= high
        };
        let inside = computed.iter().zip(of_law.iter().cycle()).map(is_inside);
        metals.push(Coverage::count(entry.name.clone(), inside));
    }
    metals.retain(|metal| metal.values > 0);
    metals.sort_by(|one, other| one.share().total_cmp(&other.share()));
    Ok(metals)
}
