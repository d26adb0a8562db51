//! The columns of a Parquet table: their types, and how they are encoded.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::schema::types::{SchemaDescriptor, Type, TypePtr};

use crate::plan::Plan;
use crate::provenance::PROGRAM;
use crate::sweep::column::{Column, columns};

/// Rows computed and encoded at a time: few enough for the cache.
pub(super) const BATCH: usize = 4096;

/// Whether a column holds words.
pub(super) fn is_words(column: &Column) -> bool {
    matches!(column, Column::Name(..) | Column::Status)
}

/// The columns of a plan and their names, without the column of the axis at this place.
pub(super) fn named(plan: &Plan, without: Option<usize>) -> (Vec<String>, Vec<Column>) {
    let is_kept = |column: &Column| !matches!(column, Column::Name(place, _) if Some(*place) == without);
    plan.column_names().into_iter().zip(columns(plan)).filter(|(_, column)| is_kept(column)).unzip()
}

/// The types of the columns.
pub(super) fn schema(names: &[String], columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let fields = names.iter().zip(columns).map(|(name, column)| {
        let (physical, repetition, logical) = match column {
            Column::Case => (Physical::INT64, Repetition::REQUIRED, None),
            Column::Plain(_) | Column::Number(..) => (Physical::DOUBLE, Repetition::REQUIRED, None),
            Column::Result(_) => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Column::Name(..) | Column::Status => {
                (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String))
            }
        };
        let field = Type::primitive_type_builder(name, physical);
        field.with_repetition(repetition).with_logical_type(logical).build().map(Arc::new)
    });
    let fields = fields.collect::<Result<_, _>>()?;
    Type::group_type_builder("table").with_fields(fields).build().map(Arc::new)
}

/// How the columns are encoded. Numbers hardly repeat, so only words have dictionaries. A page holds the rows of one
/// batch, so that its values are still in the cache.
pub(super) fn properties(columns: &[Column], schema: &SchemaDescriptor) -> WriterPropertiesPtr {
    let mut builder = WriterProperties::builder()
        .set_created_by(PROGRAM.to_owned())
        .set_write_batch_size(BATCH)
        .set_data_page_row_count_limit(BATCH)
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for (column, description) in columns.iter().zip(schema.columns()) {
        if is_words(column) {
            builder = builder.set_column_dictionary_enabled(description.path().clone(), true);
        }
    }
    Arc::new(builder.build())
}
