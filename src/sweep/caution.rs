//! Warns where a table leaves the range of the model. Before the sweep starts, one impact is computed at each corner of
//! the grid, or in the tails of the distributions. The rows of a table carry no warnings.

use std::mem::discriminant;

use crate::impact::{Impact, Method, Solver, Warning};
use crate::plan::axis::{Axis, Setting, Values, Word};
use crate::plan::random::Variable;
use crate::plan::{Cases, Plan, put};
use crate::scene::Scene;

/// The largest number of corners that are computed: those of thirteen axes of numbers.
const MOST_CORNERS: usize = 1 << 13;
/// The tails of a distribution lie below the first of these shares and above the second.
const TAILS: [f64; 2] = [0.001, 0.999];

/// The worst warning of each kind with the corner where it was found, and the largest peak indentation over the radius
/// of the sphere.
pub fn at_corners(plan: &Plan) -> (Vec<String>, f64) {
    let tails: Vec<Axis> = match &plan.cases {
        Cases::Grid(_) => Vec::new(),
        Cases::MonteCarlo { variables, .. } => variables.iter().map(tails).collect(),
    };
    let axes = if plan.is_monte_carlo() { &tails } else { plan.axes() };
    let ends: Vec<Vec<u64>> = axes.iter().map(ends).collect();
    let corners = ends.iter().map(Vec::len).fold(1, usize::saturating_mul);
    let (mut worst, mut deepest): (Vec<(Warning, String)>, f64) = (Vec::new(), 0.0);
    for corner in 0..corners.min(MOST_CORNERS) {
        let mut rest = corner;
        let place_on = |ends: &Vec<u64>| {
            let place = ends[rest % ends.len()];
            rest /= ends.len();
            place
        };
        let places: Vec<u64> = ends.iter().map(place_on).collect();
        let mut scene = plan.scene.clone();
        put(axes, &places, &mut scene);
        let Some(impact) = impact(&scene) else { continue };
        deepest = deepest.max(impact.peak_indentation / scene.sphere.radius);
        for warning in impact.warnings {
            let text = |(axis, place): (&Axis, &u64)| format!("{} = {}", axis.path(), axis.label(*place));
            let place = || axes.iter().zip(&places).map(text).collect::<Vec<_>>().join(", ");
            match worst.iter_mut().find(|(known, _)| discriminant(known) == discriminant(&warning)) {
                None => worst.push((warning, place())),
                Some(known) if is_worse(doubt(&warning), doubt(&known.0)) => *known = (warning, place()),
                Some(_) => {}
            }
        }
    }
    (worst.into_iter().map(|(warning, place)| format!("at {place}: {warning}")).collect(), deepest)
}

/// The places of the smallest and the largest value of an axis, or of all its words.
fn ends(axis: &Axis) -> Vec<u64> {
    let mut places: Vec<u64> = match &axis.setting {
        // a list may be in any order
        Setting::Number { values: Values::List(values), .. } => {
            let all = || (0..).zip(values);
            let smallest = all().min_by(|a, b| a.1.total_cmp(b.1));
            let largest = all().max_by(|a, b| a.1.total_cmp(b.1));
            smallest.into_iter().chain(largest).map(|(place, _)| place).collect()
        }
        Setting::Number { .. } => vec![0, axis.len() - 1],
        // the method changes no warning
        Setting::Words { words, .. } if matches!(words[..], [Word::Method(_), ..]) => vec![0],
        Setting::Words { .. } => (0..axis.len()).collect(),
    };
    places.dedup();
    places
}

/// The values of a random key in the tails of its distribution, as an axis.
fn tails(variable: &Variable) -> Axis {
    Axis::of_number(variable.key, Values::List(TAILS.map(|share| variable.value(share)).to_vec()))
}

/// The impact of one corner; `None` if it has no result, which the status in the table says.
fn impact(scene: &Scene) -> Option<Impact> {
    let solver = Solver { method: Method::Auto, ..Solver::default() };
    scene.contact().ok()?.impact(scene.speed, &solver, None).ok()
}

/// Whether the new warning is worse than the known one; NaN counts as the worst.
fn is_worse(new: f64, known: f64) -> bool {
    new.is_nan() || new > known
}

/// How far beyond its limit a warning is, comparable within its kind.
fn doubt(warning: &Warning) -> f64 {
    match *warning {
        Warning::DeepDent { ratio, .. } | Warning::FlowStep { ratio, .. } => ratio,
        Warning::HighStrength { strength, modulus, .. } => strength / modulus,
        Warning::LightBody { density, .. } => -density,
        Warning::LargeSphere { radius } => radius,
        Warning::BeyondFlowCurve { strain, .. } => strain,
        Warning::UntestedExponent { exponent } => (exponent - 0.2).abs(),
        Warning::SphereYields { pressure, strength } => pressure / strength,
        Warning::ShortContact { transits } => -transits,
        Warning::StrongWaves { loss, recovered } => loss / recovered,
        Warning::EnergyGain { restitution, .. } | Warning::RoughRebound { restitution, .. } => restitution,
        Warning::OutsideStated { indentation, from, to } => (indentation / to).max(from / indentation),
        Warning::Inaccurate { error: off, .. } | Warning::OpenLedger { drift: off, .. } => off,
        Warning::PlasticGain { .. }
        | Warning::UnusedKey { .. }
        | Warning::UnusedLaw { .. }
        | Warning::WavesAtJump { .. } => 0.0,
    }
}
