//! The columns of a table in any format: where the values of each column come from.

use crate::results::ResultColumn;
use crate::scenario::plan::{AxisSetting, AxisValues, AxisWord, Cases, Plan};

/// Where the values of a column come from.
#[derive(Debug, Clone)]
pub(crate) enum Column {
    Case,
    /// A random or derived number, written as it is: its place among the swept values of a row.
    Plain(usize),
    /// A number of an axis: the place of the axis, and its values.
    Number(usize, AxisValues),
    /// A name of an axis of methods, laws or materials: the place of the axis, and its names.
    Name(usize, Vec<String>),
    Result(ResultColumn),
    /// The status of the case: `ok`, or the name of its failure.
    Status,
}

/// The columns of a plan, in the order of their names ([`Plan::column_names`]).
pub(crate) fn columns(plan: &Plan) -> Vec<Column> {
    let mut swept: Vec<Column> = match &plan.cases {
        Cases::MonteCarlo { variables, .. } => (0..variables.len()).map(Column::Plain).collect(),
        Cases::Grid(axes) => (0..)
            .zip(axes)
            .map(|(place, axis)| match &axis.setting {
                AxisSetting::Number { values, .. } => Column::Number(place, values.clone()),
                AxisSetting::Words { words, .. } => Column::Name(place, words.iter().map(AxisWord::name).collect()),
            })
            .collect(),
    };
    for _ in plan.derived_bodies() {
        swept.push(Column::Plain(swept.len()));
    }
    let results = plan.result_columns().into_iter().map(Column::Result);
    std::iter::once(Column::Case).chain(swept).chain(results).chain([Column::Status]).collect()
}
