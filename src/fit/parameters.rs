//! Converts coefficients to the numbers that the fit varies, and back. The numbers are logarithms of quantities that
//! must stay positive, so every step of the fit gives a valid law.

use nalgebra::DVector;

use crate::law::PlmCoefficients;
use crate::math::functions;

/// Smallest coefficient, and smallest distance between two knots. Smaller ones are raised to it before the logarithm.
const LEAST: f64 = 1e-9;

fn ln(value: f64) -> f64 {
    functions::ln(value.max(LEAST))
}

/// Appends a slope as two numbers: its value at κ = 0 and at κ = 1. Between them the slope is linear in κ².
fn push_ends(into: &mut Vec<f64>, slope: f64, per_kappa_squared: f64) {
    into.extend([ln(slope), ln(slope + per_kappa_squared)]);
}

/// The numbers that the fit varies. With `has_knots` they include the knots of force and geometry.
pub fn encode(table: &PlmCoefficients, has_knots: bool) -> DVector<f64> {
    let (force, approach) = (&table.force, &table.elastic_approach);
    let mut numbers = Vec::new();
    for (slope, per_kappa_squared) in force.slope.iter().zip(&force.slope_kappa_squared) {
        push_ends(&mut numbers, *slope, *per_kappa_squared);
    }
    push_ends(&mut numbers, approach.first_slope, approach.first_slope_kappa_squared);
    push_ends(&mut numbers, approach.plastic_slope, approach.plastic_slope_kappa_squared);
    numbers.extend([ln(approach.first_slope_limit), ln(approach.plastic_from_rho)]);
    numbers.extend(approach.geometry_factor.iter().map(|factor| ln(*factor)));
    if has_knots {
        push_increments(&mut numbers, 1.0, &force.from);
        push_increments(&mut numbers, 0.0, &approach.geometry_from);
    }
    DVector::from_vec(numbers)
}

fn push_increments(into: &mut Vec<f64>, first: f64, knots: &[f64]) {
    let before = std::iter::once(&first).chain(knots);
    into.extend(knots.iter().zip(before).map(|(knot, before)| ln(knot - before)));
}

/// The table of coefficients with these numbers. All else in it is copied from `form`.
pub fn decode(numbers: &DVector<f64>, form: &PlmCoefficients, has_knots: bool) -> PlmCoefficients {
    let mut table = form.clone();
    let mut values = numbers.iter().map(|number| functions::exp(*number));
    let mut next = || values.next().unwrap_or(f64::NAN);
    let mut ends = || {
        let slope = next();
        (slope, next() - slope)
    };
    let force = &mut table.force;
    for (slope, per_kappa_squared) in force.slope.iter_mut().zip(&mut force.slope_kappa_squared) {
        (*slope, *per_kappa_squared) = ends();
    }
    let approach = &mut table.elastic_approach;
    (approach.first_slope, approach.first_slope_kappa_squared) = ends();
    (approach.plastic_slope, approach.plastic_slope_kappa_squared) = ends();
    approach.first_slope_limit = next();
    approach.plastic_from_rho = next();
    approach.geometry_factor.iter_mut().for_each(|factor| *factor = next());
    if has_knots {
        for (first, knots) in [(1.0, &mut force.from), (0.0, &mut approach.geometry_from)] {
            let mut at = first;
            for knot in knots.iter_mut() {
                at += next();
                *knot = at;
            }
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decoding_inverts_encoding() {
        let table = PlmCoefficients::built_in();
        for has_knots in [false, true] {
            let numbers = encode(table, has_knots);
            let again = encode(&decode(&numbers, table, has_knots), has_knots);
            approx::assert_relative_eq!(numbers, again, max_relative = 1e-12);
        }
    }
}
