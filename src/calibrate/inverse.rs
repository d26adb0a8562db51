//! The inverse question: which values of a key give a wanted result?
//!
//! The search is that of a calibration: the square of the relative difference between the result and the wanted value is minimised in
//! every basin along the range of the key. A minimum is a solution if its difference is zero but for rounding. A result may also
//! be constant over a part of the range, such as e = 1 of elastic impacts; every value of this part is then a solution.

use rayon::prelude::*;
use serde_json::Value;

use super::minimise::{Objective, ShareRange, find_minima};
use crate::error::{Error, ErrorKind};
use crate::files::Progress;
use crate::impact::ImpactError;
use crate::numerics::root::bisect;
use crate::results::impact::{SingleImpact, impact_results};
use crate::results::{RESTITUTION, Requirement, dimension_of};
use crate::scenario::input::Input;
use crate::scenario::keys::restitution_interval;
use crate::scenario::kinds::inverse::{InverseRequest, RANGE_OPTIONS};
use crate::scenario::plan::FreeKey;
use crate::units::{Dimension, format_four_digits, format_input};

/// Cells along the range of the key. Two solutions in one cell count as one.
const CELLS: u32 = 512;
/// Tolerance of the share of the range.
const TOLERANCE: f64 = 1e-13;
/// The largest relative difference between the result of a solution and the wanted value.
const MAX_DIFFERENCE: f64 = 1e-7;
/// If the results at nodes of the range differ by less from the wanted value, every value of the key there is a solution.
const LEVEL_DIFFERENCE: f64 = 1e-10;

/// Why a value of the key gives no number.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
enum NoResult {
    #[error(transparent)]
    Impact(#[from] ImpactError),
    #[error("it exists only if {0}")]
    Condition(&'static str),
    #[error("it is not a number")]
    Word,
    #[error("it has no value, because the sphere does not separate")]
    Null,
    #[error("the search was stopped")]
    Stopped,
}

/// The key, and the result that is wanted.
#[derive(Debug, Clone)]
pub struct InverseProblem<'a> {
    input: Input,
    pub free: FreeKey,
    /// The name of the result, with its unit.
    pub result: &'static str,
    /// The index of the result in the list of results.
    index: usize,
    /// The wanted value, in the unit of the name.
    pub wanted: f64,
    /// Differences are relative to this number.
    scale: f64,
    progress: &'a Progress,
}

/// A value of the key that gives the wanted result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverseSolution {
    /// The value of the key, SI; the middle of `part`.
    pub value: f64,
    /// The result at this value.
    pub result: f64,
    /// Both ends of the part of the range in which every value gives this result; `None` for a single value.
    pub part: Option<[f64; 2]>,
}

/// The results along the range of the key: key and result where there is a result.
type Scan = Vec<(f64, f64)>;

impl<'a> InverseProblem<'a> {
    /// The question which value of a key gives this value of a result. `result` is the full name of a result of one impact.
    ///
    /// # Errors
    /// [`Error`] if there is no such result.
    pub fn new(request: InverseRequest, result: &str, wanted: f64, progress: &'a Progress) -> Result<Self, Error> {
        let InverseRequest { free, input } = request;
        let found = impact_results()
            .iter()
            .enumerate()
            .find(|(_, known)| known.name == result)
            .map(|(at, known)| (at, known.name));
        let (index, result) = found.ok_or_else(|| Error::input(format!("`{result}` is not a result of an impact")))?;
        let scale = if wanted == 0.0 { 1.0 } else { wanted.abs() };
        Ok(Self { input, free, result, index, wanted, scale, progress })
    }

    /// All solutions, in the order of rising values of the key.
    ///
    /// # Errors
    /// [`Error`] if there is no solution: it names the range of the result that was found. [`Error`] of the kind `Stopped` if the
    /// progress is stopped.
    pub fn solve(mut self) -> Result<Vec<InverseSolution>, Error> {
        let range = ShareRange::with_cells(CELLS);
        let nodes = range.nodes();
        let at_nodes: Vec<Result<f64, NoResult>> =
            nodes.par_iter().map(|share| self.result_at(self.free.value_at_share(*share))).collect();
        let scan: Scan = nodes
            .iter()
            .zip(&at_nodes)
            .filter_map(|(share, result)| Some((self.free.value_at_share(*share), *result.as_ref().ok()?)))
            .collect();
        if scan.is_empty() {
            return Err(self.no_result_error(at_nodes.into_iter().find_map(Result::err)));
        }
        if self.wanted == 0.0 {
            // the size of the result, because a difference cannot be relative to 0
            let largest = scan.iter().map(|(_, result)| result.abs()).fold(0.0, f64::max);
            self.scale = if largest > 0.0 { largest } else { 1.0 };
        }
        let minima = find_minima(&self, &self, &[range], TOLERANCE);
        if self.progress.is_stopped() {
            return Err(self.no_result_error(Some(NoResult::Stopped)));
        }
        let mut solutions: Vec<InverseSolution> =
            minima.iter().filter_map(|point| self.solution_at(point.shares[0], &nodes, &at_nodes)).collect();
        solutions.sort_by(|a, b| a.value.total_cmp(&b.value));
        if solutions.is_empty() { Err(self.no_solution_error(&scan)) } else { Ok(solutions) }
    }

    /// The solution at a minimum; `None` if the result there is another one.
    fn solution_at(&self, share: f64, nodes: &[f64], at_nodes: &[Result<f64, NoResult>]) -> Option<InverseSolution> {
        let result = self.result_at(self.free.value_at_share(share)).ok()?;
        if self.difference(result).abs() > MAX_DIFFERENCE {
            return None;
        }
        let is_level = |at: &usize| at_nodes[*at].as_ref().is_ok_and(|result| self.is_level(*result));
        let behind = nodes.partition_point(|node| *node <= share);
        let below = (0..behind).rev().take_while(is_level).last();
        let above = (behind..nodes.len()).take_while(is_level).last();
        let ends = below.or(above.map(|_| behind)).zip(above.or(below.map(|_| behind - 1)));
        // one node alone may lie on the solution by chance
        let Some((first, last)) = ends.filter(|(first, last)| first < last) else {
            return Some(InverseSolution { value: self.free.value_at_share(share), result, part: None });
        };
        let is_solution =
            |share: f64| self.result_at(self.free.value_at_share(share)).is_ok_and(|result| self.is_level(result));
        let low = first
            .checked_sub(1)
            .map_or(nodes[first], |before| bisect(nodes[before], nodes[first], |share| !is_solution(share)).1);
        let high = nodes.get(last + 1).map_or(nodes[last], |after| bisect(nodes[last], *after, is_solution).0);
        let value = self.free.value_at_share(0.5 * (low + high));
        let result = self.result_at(value).unwrap_or(result);
        Some(InverseSolution { value, result, part: Some([low, high].map(|share| self.free.value_at_share(share))) })
    }

    /// True if a result is the wanted value but for rounding.
    fn is_level(&self, result: f64) -> bool {
        self.difference(result).abs() <= LEVEL_DIFFERENCE
    }

    fn difference(&self, result: f64) -> f64 {
        (result - self.wanted) / self.scale
    }

    /// The result at a value of the key.
    fn result_at(&self, value: f64) -> Result<f64, NoResult> {
        if self.progress.is_stopped() {
            return Err(NoResult::Stopped);
        }
        let mut input = self.input.clone();
        input.set(self.free.key, Some(value));
        let approach = input.approach();
        let contact = input.contact()?;
        let contact = contact.at_speed(approach.normal)?;
        let mut impact = contact.impact(approach, &input.solver(), None)?;
        let spec = &impact_results()[self.index];
        if spec.column.is_some_and(|column| column.needs == Requirement::Interval) {
            let interval = restitution_interval(&input, &contact, impact.speed, &impact.row);
            impact.row.restitution_interval = interval.map(|interval| [interval.low, interval.high]);
        }
        let single = SingleImpact::new(&contact, &impact, input.drop_height());
        let column = spec.column.filter(|column| column.needs.is_met_by(&contact, &impact.row));
        let of_table = || column.and_then(|column| (column.value)(&impact.row)).map(Value::from);
        match (spec.value)(&single).or_else(of_table) {
            // the measured restitution, as a calibration and the terminal have it
            Some(Value::Number(_)) if self.result == RESTITUTION => Ok(impact.row.measured_restitution()),
            Some(Value::Number(number)) => number.as_f64().ok_or(NoResult::Word),
            Some(Value::Null) => Err(NoResult::Null),
            Some(_) => Err(NoResult::Word),
            None if column.is_some() => Err(NoResult::Null),
            // the condition of a result of tables alone is that of its column
            None => Err(NoResult::Condition(spec.column.map_or(spec.condition, |column| column.needs.condition()))),
        }
    }

    /// A value of the result, for messages.
    fn result_text(&self, value: f64) -> String {
        result_text(self.result, value)
    }

    fn key_text(&self, value: f64) -> String {
        self.free.format_value(value, 4)
    }

    fn no_result_error(&self, reason: Option<NoResult>) -> Error {
        let (path, result) = (self.free.key.path(), self.result);
        match reason {
            Some(NoResult::Stopped) => Error::new(ErrorKind::Stopped(130), NoResult::Stopped.to_string()),
            Some(reason @ (NoResult::Condition(_) | NoResult::Word)) => Error::input(format!("{result}: {reason}.")),
            reason => {
                let [from, to] = [self.free.from, self.free.to].map(|end| self.key_text(end));
                // the reason of an impact is a sentence with a full stop
                let reason = reason.map(|reason| format!(": {}", reason.to_string().trim_end_matches('.')));
                let reason = reason.unwrap_or_default();
                Error::input(format!(
                    "{path} from {from} to {to} gives no {result}{reason}. Change the range with {RANGE_OPTIONS}."
                ))
            }
        }
    }

    /// The error if no value of the key gives the wanted result.
    fn no_solution_error(&self, scan: &Scan) -> Error {
        let (path, result) = (self.free.key.path(), self.result);
        let [from, to] = [self.free.from, self.free.to].map(|end| self.key_text(end));
        let begin = format!("no {path} from {from} to {to} gives {result} = {}.", self.result_text(self.wanted));
        let jump = scan.windows(2).find(|pair| (pair[0].1 < self.wanted) != (pair[1].1 < self.wanted));
        let text = if let Some([(low, before), (high, after)]) = jump {
            let [low, high] = [*low, *high].map(|value| self.key_text(value));
            let [before, after] = [*before, *after].map(|value| self.result_text(value));
            format!(
                "{begin} The result jumps from {before} at {low} to {after} at {high}. Choose another value of the result."
            )
        } else {
            let by_result = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
            let ends = scan.iter().min_by(by_result).zip(scan.iter().max_by(by_result));
            let text =
                |&(value, result): &(f64, f64)| format!("{} (at {})", self.result_text(result), self.key_text(value));
            let seen = ends
                .map(|(least, largest)| format!(" In this range {result} is {} to {}.", text(least), text(largest)));
            let seen = seen.unwrap_or_default();
            format!("{begin}{seen} Change the range with {RANGE_OPTIONS}, or the value of the result.")
        };
        Error::input(text)
    }
}

/// A value of a result as text with its unit.
pub fn result_text(name: &str, value: f64) -> String {
    let dimension = dimension_of(name);
    if dimension == Dimension::Ratio { format_four_digits(value) } else { format_input(value, dimension) }
}

impl Objective for InverseProblem<'_> {
    fn objective(&self, shares: &[f64]) -> f64 {
        let result = self.result_at(self.free.value_at_share(shares[0]));
        let square = result.map_or(f64::INFINITY, |result| self.difference(result) * self.difference(result));
        if square.is_nan() { f64::INFINITY } else { square }
    }

    fn n_values(&self) -> usize {
        1
    }
}
