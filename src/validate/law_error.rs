//! The errors of e by the law over all load cycles and whole impacts of finite elements, by class of bodies, exponent of unloading and contact
//! radius: the table behind the law's part of the interval of e.

use std::fmt::Write as _;

use super::cases::cases;
use super::comparison::{deviation, mean};
use super::load_cycle::LoadCycle;
use super::{dynamic, poisson, rate, yielding};
use crate::contact::law::{Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{DEEP_IMPACTS, DEEP_UNLOADINGS, HARDENING};
use crate::scenario::keys::interval::law_error::{BodyClass, EXPONENTS};

/// The largest contact radii over the radius of the sphere that bound the groups of each class.
const MAX_RADIUS_RATIOS: [(BodyClass, &[f64]); 5] = [
    (BodyClass::PerfectlyPlastic, &[0.3, 0.4, 0.58]),
    (BodyClass::Hardening, &[0.3, 0.4, 0.58]),
    (BodyClass::YieldingSphere, &[0.3]),
    (BodyClass::OtherPoissonsRatio, &[0.3]),
    (BodyClass::All, &[f64::INFINITY]),
];

/// A load cycle: its class, its contact radius over the radius of the sphere, and the error of e.
pub type CycleError = (BodyClass, f64, f64);

/// The errors of e over all load cycles of finite elements, by the law with this exponent of unloading.
pub fn cycle_errors(coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Result<Vec<CycleError>, Error> {
    let mut errors = Vec::new();
    for case in cases()? {
        let law = case.law(coefficients, exponent);
        errors.extend(case.cycles.iter().filter_map(|cycle| {
            let by_law = LoadCycle::to_depth(&law, cycle.peak.indentation);
            let error = deviation(cycle.row.optional_number("restitution")?, by_law.restitution);
            Some((BodyClass::PerfectlyPlastic, cycle.row.number("contact_radius_over_R"), error))
        }));
    }
    for row in [HARDENING.rows()?, DEEP_UNLOADINGS.rows()?].concat() {
        let Some(bodies) = row.bodies()? else { continue };
        let flow = row.curve();
        let class = if flow.is_some() { BodyClass::Hardening } else { BodyClass::PerfectlyPlastic };
        let plm = Plm { flow: [None, flow], ..Plm::new(coefficients, exponent) };
        let cycle = LoadCycle::with_work(&plm.law_for_yielding_pair(&bodies), row.number("spent"));
        let error = deviation(row.number("restitution"), cycle.restitution);
        errors.push((class, row.number("contact_radius_over_R"), error));
    }
    for cycle in poisson::cycles(coefficients, exponent)? {
        let [reference, law] = cycle.ratios();
        let radius_ratio = cycle.row.number("contact_radius_over_R");
        errors.push((BodyClass::OtherPoissonsRatio, radius_ratio, deviation(reference, law)));
    }
    for (row, impact) in rate::impacts_of(&DEEP_IMPACTS, coefficients, exponent)? {
        let is_hardening = row.optional_number("half_space.flow_stress.power.exponent").is_some();
        let class = if is_hardening { BodyClass::Hardening } else { BodyClass::PerfectlyPlastic };
        let error = deviation(row.number("restitution"), impact.row.measured_restitution());
        errors.push((class, row.number("contact_radius_over_R"), error));
    }
    for cycle in yielding::yielding_cycles(coefficients, exponent)? {
        let error = deviation(cycle.row.number("e"), cycle.at_work.restitution);
        errors.push((BodyClass::YieldingSphere, cycle.row.number("contact_radius_over_R"), error));
    }
    for case in dynamic::cases(coefficients)? {
        // in the order of the exponents of the comparison: 3/2 first
        let impact = &case.impacts[usize::from(exponent == UnloadingExponent::PressureShape)];
        let error = deviation(case.reference.number("restitution"), impact.row.measured_restitution());
        errors.push((BodyClass::PerfectlyPlastic, impact.row.radius_ratio, error));
    }
    Ok(errors)
}

/// The quantiles of 2.5 and 97.5 % of sorted values, each of which is one of them: of fewer than 40 the smallest and the largest.
fn quantiles(sorted: &[f64]) -> Option<[f64; 2]> {
    let outside = sorted.len() / 40;
    Some([*sorted.get(outside)?, *sorted.get(sorted.len().checked_sub(1 + outside)?)?])
}

/// The file of the table.
pub fn law_errors_csv(coefficients: &PlmCoefficients) -> Result<String, Error> {
    let mut text = "# Errors of e by the law plm: e of the law over e of the finite elements, less 1, over the load cycles and impacts that\n\
         # `plm-impact validate` compares. Mean, and quantiles of 2.5 and 97.5 %. A test computes this table anew.\n\
         class,exponent,max_radius_ratio,cycles,mean,low,high\n"
        .to_owned();
    for (exponent, name) in EXPONENTS {
        let errors = cycle_errors(coefficients, exponent)?;
        for (class, bounds) in MAX_RADIUS_RATIOS {
            let mut from = 0.0;
            for &to in bounds {
                let is_here = |(other, ratio, _): &&CycleError| {
                    let is_of_all = class == BodyClass::All && *other != BodyClass::OtherPoissonsRatio;
                    (is_of_all || *other == class) && *ratio > from && *ratio <= to
                };
                let mut here: Vec<f64> = errors.iter().filter(is_here).map(|(.., error)| *error).collect();
                here.sort_by(f64::total_cmp);
                if let Some([low, high]) = quantiles(&here) {
                    let (cycles, mean) = (here.len(), mean(&here));
                    let _ = writeln!(text, "{},{name},{to},{cycles},{mean:.5},{low:.5},{high:.5}", class.name());
                }
                from = to;
            }
        }
    }
    Ok(text)
}
