//! The blocks of `check` about a table: how many cases there are, what varies, and which columns the table will have.

use super::blocks::Block;
use crate::scenario::plan::{Cases, Distribution, Plan, SweepAxis, Variable};
use crate::units::format_percent;

/// An axis with at most this number of values is listed value by value.
const MAX_LISTED: u64 = 8;

/// The cases and the columns. The scene of the first case follows.
pub fn plan_blocks(plan: &Plan) -> Vec<Block> {
    let count = plan.n_cases();
    let row = |path: &str, values: String| [format!("  {path}"), values];
    let (from, rows): (_, Vec<_>) = match &plan.cases {
        Cases::Grid(axes) => {
            ("all combinations of".to_owned(), axes.iter().map(|axis| row(axis.path(), values_text(axis))).collect())
        }
        Cases::MonteCarlo { seed, variables, .. } => {
            let rows = variables.iter().map(|variable| row(variable.key.path(), distribution_text(variable)));
            (format!("drawn with seed {seed} from"), rows.collect())
        }
    };
    let scene = if plan.is_monte_carlo() { "values at the medians" } else { "values of the first case" };
    vec![
        Block::Sentence(format!("{count} cases, {from}")),
        Block::list(rows),
        Block::Sentence(format!("columns {}", plan.column_names().join(","))),
        Block::EmptyLine,
        Block::Sentence(format!("{scene}:")),
    ]
}

fn values_text(axis: &SweepAxis) -> String {
    let count = axis.len();
    if count <= MAX_LISTED {
        return (0..count).map(|place| axis.label(place)).collect::<Vec<_>>().join(", ");
    }
    let (first, last) = (axis.label(0), axis.label(count - 1));
    if axis.is_logarithmic {
        return format!("{count} values from {first} to {last}, evenly in the logarithm");
    }
    if axis.is_even {
        return format!("{count} values from {first} to {last}, evenly");
    }
    let [low, high] = axis.extreme_places();
    let is_rising = (1..count).all(|place| axis.value_at(place - 1) < axis.value_at(place));
    if is_rising || !axis.word_values().is_empty() {
        return format!("{count} values from {first} to {last}");
    }
    format!("{count} values between {} and {}, in the order of the list", axis.label(low), axis.label(high))
}

fn distribution_text(variable: &Variable) -> String {
    let (name, parameters) = variable.distribution.name_and_parameters();
    let [first, second] = parameters.map(|value| variable.key.quantity().display(value));
    if let Distribution::Uniform { .. } = variable.distribution {
        return format!("{name} from {first} to {second}");
    }
    let share = format_percent(variable.probability_in_range());
    format!(
        "{name}, mean {first}, sd {second}, truncated to {} (probability {share})",
        variable.key.quantity().allowed_range()
    )
}
