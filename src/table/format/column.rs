//! The columns of a table in any format: where the values of each column come from.

use crate::results::ResultColumn;
use crate::scenario::plan::{AxisSetting, AxisValues, AxisWord, Cases, Plan};

/// Where the values of a column come from.
#[derive(Debug, Clone)]
pub(crate) enum TableColumn {
    Case,
    /// A random or derived number, written as it is: its place among the swept values of a row.
    Value(usize),
    /// A number of an axis: the place of the axis, and its values.
    AxisValue(usize, AxisValues),
    /// A name of an axis of methods, laws or materials: the place of the axis, and its names.
    AxisWord(usize, Vec<String>),
    Result(ResultColumn),
    /// The status of the case: `ok`, or the name of its failure.
    Status,
}

/// The columns of a plan, in the order of their names ([`Plan::column_names`]).
pub(crate) fn table_columns(plan: &Plan) -> Vec<TableColumn> {
    let mut swept: Vec<TableColumn> = match &plan.cases {
        Cases::MonteCarlo { variables, .. } => (0..variables.len()).map(TableColumn::Value).collect(),
        Cases::Grid(axes) => (0..)
            .zip(axes)
            .map(|(place, axis)| match &axis.setting {
                AxisSetting::Number { values, .. } => TableColumn::AxisValue(place, values.clone()),
                AxisSetting::Words { words, .. } => {
                    TableColumn::AxisWord(place, words.iter().map(AxisWord::name).collect())
                }
            })
            .collect(),
    };
    for _ in plan.derived_bodies() {
        swept.push(TableColumn::Value(swept.len()));
    }
    let results = plan.result_columns().into_iter().map(TableColumn::Result);
    std::iter::once(TableColumn::Case).chain(swept).chain(results).chain([TableColumn::Status]).collect()
}
