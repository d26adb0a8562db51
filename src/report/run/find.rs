//! The values of a key that give a wanted result, each with its impact.

use serde_json::{Map, Value, json};

use super::impact;
use super::outcome::warning_texts;
use crate::calibrate::inverse::{InverseProblem, InverseSolution, result_text};
use crate::error::Error;
use crate::files::Progress;
use crate::report::text::{Block, Detail, impact_blocks, note_blocks, to_text};
use crate::results::impact::{SingleImpact, impact_results};
use crate::results::to_fields;
use crate::scenario::Scenario;
use crate::scenario::keys::{restitution_interval, strength_notes};
use crate::scenario::plan::FreeKey;

/// The question.
#[derive(Debug, Clone, Copy)]
pub struct Question<'a> {
    /// The path of the key.
    pub key: &'a str,
    /// The ends of the range of the key, as texts; an end that is not given follows from the scenario.
    pub range: [Option<&'a str>; 2],
    /// The name of the result, with its unit.
    pub result: &'a str,
    /// The wanted value, in the unit of the name.
    pub wanted: f64,
}

/// The answer: all solutions.
#[derive(Debug, Clone)]
pub struct Answer {
    pub warnings: Vec<String>,
    pub text: String,
    /// The key, the result, the wanted value, the range of the key, and the list `solutions`.
    pub json: Value,
    /// For each solution the key and its value, as a scenario has them.
    pub settings: Vec<[String; 2]>,
}

/// The digits of a solution on the terminal.
const DIGITS: usize = 6;

/// Finds all values of a key that give a wanted result.
///
/// # Errors
/// [`Error`] for a bad question, if there is no solution, or if the progress is stopped.
pub fn find(scenario: &Scenario, question: &Question, progress: &Progress) -> Result<Answer, Error> {
    let Question { key, range, wanted, .. } = *question;
    let result = scenario.result_of_scene(question.result, key);
    let request = scenario.inverse_request(key, range, result)?;
    let free = request.free;
    let solutions = InverseProblem::new(request, result, wanted, progress)?.solve()?;
    let (mut warnings, mut blocks, mut found, mut settings) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut all_notes: Vec<String> = Vec::new();
    for solution in &solutions {
        let setting = free.to_rounded_text(solution.value, DIGITS);
        let Impact { results, blocks: of_impact, warnings: of_solution, notes } =
            impact_at(&scenario.with_value(&free, solution.value)?)?;
        // several solutions may have other warnings
        let place = if solutions.len() > 1 { format!("at {key} = {setting}: ") } else { String::new() };
        warnings.extend(of_solution.into_iter().map(|warning| format!("{place}{warning}")));
        if !blocks.is_empty() {
            blocks.push(Block::EmptyLine);
        }
        blocks.extend([Block::Sentence(solution_line(&free, solution, result)), Block::EmptyLine]);
        blocks.extend(of_impact);
        found.push(solution_json(&free, solution, result, results));
        // solutions have the same notes as a rule
        all_notes.extend(notes.into_iter().filter(|note| !all_notes.contains(note)).collect::<Vec<_>>());
        settings.push([key.to_owned(), setting]);
    }
    blocks.extend(note_blocks(&all_notes));
    let json = json!({
        "key": key,
        "result": result,
        "wanted": { result: wanted },
        "range": { free.key.column_name(): [free.from, free.to] },
        "solutions": found,
        "warnings": warnings,
    });
    Ok(Answer { warnings, text: to_text(&blocks), json, settings })
}

/// The key, its value, and the result that it gives.
fn solution_line(free: &FreeKey, solution: &InverseSolution, result: &str) -> String {
    let path = free.key.path();
    let gives = format!("gives {result} = {}", result_text(result, solution.result));
    match solution.part {
        Some([low, high]) => {
            let [low, high] = [low, high].map(|end| free.format_value(end, DIGITS));
            format!("{path}   every value from {low} to {high} {gives}")
        }
        None => format!("{path}   {}   {gives}", free.format_value(solution.value, DIGITS)),
    }
}

/// A solution as data: key and result under the names that tables have, and all results of the impact.
fn solution_json(free: &FreeKey, solution: &InverseSolution, result: &str, results: Map<String, Value>) -> Value {
    let column = free.key.column_name();
    let mut json = Map::new();
    json.insert(column.clone(), solution.value.into());
    if let Some(part) = solution.part {
        json.insert(format!("{column}_interval"), part.to_vec().into());
    }
    json.insert(result.to_owned(), solution.result.into());
    json.insert("results".to_owned(), results.into());
    json.into()
}

/// An impact with one value of the key.
struct Impact {
    results: Map<String, Value>,
    blocks: Vec<Block>,
    warnings: Vec<String>,
    notes: Vec<String>,
}

fn impact_at(scenario: &Scenario) -> Result<Impact, Error> {
    let (input, contact, impact) = impact::compute(scenario, None)?;
    let notes = strength_notes(&input, &contact, impact.row.has_dent(), &[]);
    let interval = restitution_interval(&input, &contact, impact.speed, &impact.row);
    let single =
        SingleImpact { interval: interval.as_ref(), ..SingleImpact::new(&contact, &impact, input.drop_height()) };
    Ok(Impact {
        results: to_fields(&impact_results(), &SingleImpact { notes: &notes, ..single }),
        blocks: impact_blocks(&single, Detail::Brief),
        warnings: warning_texts(&impact.warnings),
        notes,
    })
}
