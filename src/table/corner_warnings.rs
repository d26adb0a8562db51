//! Warns where a table leaves the range of the model. Before the sweep starts, one impact is computed at each corner of
//! the grid, or in the tails of the distributions. If there are very many corners, this is done at a sample of them. The rows of
//! a table carry no warnings.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

use crate::impact::{Contact, Impact, Method, Solver, Warning};
use crate::scenario::input::Input;
use crate::scenario::plan::{AxisSetting, AxisValues, AxisWord, Cases, Plan, SweepAxis, Variable, apply_axes};

/// Up to this number, which thirteen axes of numbers have, all corners are computed. If there are more, a sample of this size is.
const MAX_CORNERS: u64 = 1 << 13;
/// The tails of a distribution lie below the first of these shares and above the second.
const TAILS: [f64; 2] = [0.001, 0.999];

/// The warnings at the corners of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerWarnings {
    /// The worst warning of each kind with the corner where it was found, and a warning about corners that were not looked at.
    pub warnings: Vec<String>,
    /// True if an impact at a corner leaves a dent.
    pub has_dent: bool,
}

/// Computes the impacts at the corners. `known` is the contact of the plan, if it is made already.
pub fn corner_warnings(plan: &Plan, known: Option<&Contact>) -> CornerWarnings {
    let tails: Vec<SweepAxis> = match &plan.cases {
        Cases::Grid(_) => Vec::new(),
        Cases::MonteCarlo { variables, .. } => variables.iter().map(tail_axis).collect(),
    };
    let axes = if plan.is_monte_carlo() { &tails } else { plan.axes() };
    let ends: Vec<Vec<u64>> = axes.iter().map(extreme_indices).collect();
    let all = ends.iter().map(|ends| ends.len() as u64).fold(1, u64::saturating_mul);
    // where no axis changes the contact, one serves all corners
    let is_one = axes.iter().all(SweepAxis::is_contact_constant);
    let shared = if is_one { known.cloned().or_else(|| plan.input.contact().ok()) } else { None };
    let mut worst: Vec<(Warning, String)> = Vec::new();
    let mut has_dent = false;
    for places in chosen_corners(&ends, all) {
        let mut input = plan.input.clone();
        apply_axes(axes, &places, &mut input);
        let own = if shared.is_none() { input.contact().ok() } else { None };
        let impact = shared.as_ref().or(own.as_ref()).and_then(|contact| impact(contact, &input));
        has_dent |= impact.as_ref().is_some_and(|impact| impact.row.has_dent());
        let of_impact = impact.map_or_else(Vec::new, |impact| impact.warnings);
        for warning in of_impact.into_iter().chain(input.flight_warnings()) {
            let text = |(axis, place): (&SweepAxis, &u64)| format!("{} = {}", axis.path(), axis.label(*place));
            warning.keep_worst(&mut worst, || axes.iter().zip(&places).map(text).collect::<Vec<_>>().join(", "));
        }
    }
    worst.sort_by_key(|(warning, _)| !warning.is_fatal());
    let mut warnings: Vec<String> =
        worst.into_iter().map(|(warning, place)| format!("at {place}: {warning}")).collect();
    if all > MAX_CORNERS {
        warnings.push(format!(
            "Other rows may be outside the range of validity: only {MAX_CORNERS} of the {all} corners of this table were checked."
        ));
    }
    CornerWarnings { warnings, has_dent }
}

/// All corners, or a sample of them that is the same in every run; an end of an axis is in so large a sample many times.
fn chosen_corners(ends: &[Vec<u64>], all: u64) -> Vec<Vec<u64>> {
    if all <= MAX_CORNERS {
        return (0..all).map(|number| corner_indices(ends, number)).collect();
    }
    let mut random = ChaCha8Rng::seed_from_u64(0);
    (0..MAX_CORNERS).map(|_| corner_indices(ends, random.next_u64())).collect()
}

/// The corner of this number; beyond the last corner they begin again.
#[allow(clippy::cast_possible_truncation)] // less than the length of a list
fn corner_indices(ends: &[Vec<u64>], mut number: u64) -> Vec<u64> {
    let place = |ends: &Vec<u64>| {
        let count = ends.len() as u64;
        let place = ends[(number % count) as usize];
        number /= count;
        place
    };
    ends.iter().map(place).collect()
}

/// The places of the smallest and the largest value of an axis, or of all its words.
fn extreme_indices(axis: &SweepAxis) -> Vec<u64> {
    let mut places: Vec<u64> = match &axis.setting {
        AxisSetting::Number { .. } => axis.extreme_places().to_vec(),
        // of the methods only fixed steps have warnings of their own
        AxisSetting::Words { words, .. } if matches!(words[..], [AxisWord::Method(_), ..]) => {
            let verlet = words.iter().position(|word| matches!(word, AxisWord::Method(Method::Verlet)));
            vec![0, verlet.unwrap_or(0) as u64]
        }
        AxisSetting::Words { .. } => (0..axis.len()).collect(),
    };
    places.dedup();
    places
}

/// The values of a random key in the tails of its distribution, as an axis.
fn tail_axis(variable: &Variable) -> SweepAxis {
    SweepAxis::from_numbers(variable.key, AxisValues::List(TAILS.map(|share| variable.value(share)).to_vec()))
}

/// The impact of one corner; `None` if it has no result, which the status in the table says.
fn impact(contact: &Contact, input: &Input) -> Option<Impact> {
    let of_input = input.solver();
    let solver = if of_input.method == Method::Verlet { of_input } else { Solver::AUTO };
    contact.impact(input.approach(), &solver, None).ok()
}
