//! The columns of a Parquet table: where their values come from, their types, how they are encoded.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::schema::types::{SchemaDescriptor, Type, TypePtr};

use super::BATCH;
use crate::plan::axis::{Setting, Values};
use crate::plan::{Cases, Plan};
use crate::provenance::PROGRAM;
use crate::scene::results::Column as ResultColumn;

/// Where the values of a column come from.
pub(super) enum Column {
    Case,
    /// Random numbers, by their place in a row.
    Random(usize),
    /// Numbers of an axis.
    Number(usize, Values),
    Result(ResultColumn),
    /// Names of an axis of methods or laws.
    Name(usize, Vec<String>),
    Status,
}

impl Column {
    /// Whether it holds words.
    pub(super) fn is_words(&self) -> bool {
        matches!(self, Self::Name(..) | Self::Status)
    }
}

pub(super) fn columns(plan: &Plan) -> Vec<Column> {
    let swept: Vec<Column> = match &plan.cases {
        Cases::MonteCarlo { variables, .. } => (0..variables.len()).map(Column::Random).collect(),
        Cases::Grid(axes) => (0..)
            .zip(axes)
            .map(|(place, axis)| match &axis.setting {
                Setting::Number { values, .. } => Column::Number(place, values.clone()),
                Setting::Method(_) | Setting::Law(_) => Column::Name(place, axis.words().unwrap_or_default()),
            })
            .collect(),
    };
    let results = plan.results().into_iter().map(Column::Result);
    std::iter::once(Column::Case).chain(swept).chain(results).chain([Column::Status]).collect()
}

pub(super) fn schema(plan: &Plan, columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let fields = plan.column_names().into_iter().zip(columns).map(|(name, column)| {
        let (physical, repetition, logical) = match column {
            Column::Case => (Physical::INT64, Repetition::REQUIRED, None),
            Column::Random(_) | Column::Number(..) => (Physical::DOUBLE, Repetition::REQUIRED, None),
            Column::Result(_) => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Column::Name(..) | Column::Status => {
                (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String))
            }
        };
        let field = Type::primitive_type_builder(&name, physical);
        field.with_repetition(repetition).with_logical_type(logical).build().map(Arc::new)
    });
    let fields = fields.collect::<Result<_, _>>()?;
    Type::group_type_builder("table").with_fields(fields).build().map(Arc::new)
}

/// Digits of results hardly repeat: plain numbers, and dictionaries for words alone. A page holds the rows that are
/// computed together, so that all of it happens in the cache.
pub(super) fn properties(columns: &[Column], schema: &SchemaDescriptor) -> WriterPropertiesPtr {
    let mut builder = WriterProperties::builder()
        .set_created_by(PROGRAM.to_owned())
        .set_write_batch_size(BATCH)
        .set_data_page_row_count_limit(BATCH)
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for (column, description) in columns.iter().zip(schema.columns()) {
        if column.is_words() {
            builder = builder.set_column_dictionary_enabled(description.path().clone(), true);
        }
    }
    Arc::new(builder.build())
}
