//! A table divided into files, one for every value of an axis. Each file is in a folder that is named after the value,
//! in the form of Hive (`law=thornton`). DuckDB, polars, DataFusion, Arrow and Spark read the whole folder as one
//! table, and skip files by the value.

use super::SweepError;
use super::shard::{Layout, Shard};
use crate::plan::Plan;
use crate::plan::axis::Axis;

/// How a table is divided into files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Partition {
    /// Place of the axis among the axes of the plan.
    pub(super) place: usize,
    /// The column of the axis. Its values are in the names of the folders and not in the files.
    column: String,
    /// The values of the axis, as they are written in the names of the folders.
    values: Vec<String>,
    /// How many consecutive cases have the same value.
    stride: u64,
}

impl Partition {
    /// The division by the axis of this key. The values of the axis have to be words: laws, methods or materials.
    pub fn of(plan: &Plan, key: &str) -> Result<Self, SweepError> {
        let axes = plan.axes();
        let of_words = axes.iter().enumerate().filter(|(_, axis)| !axis.words().is_empty());
        let Some((place, axis)) = of_words.clone().find(|(_, axis)| axis.path() == key) else {
            let of_words = of_words.map(|(_, axis)| axis.path()).collect();
            return Err(SweepError::PartitionBy { key: key.to_owned(), of_words });
        };
        let stride = axes[place + 1..].iter().map(Axis::len).product();
        let values = axis.words().iter().map(|word| encoded(&word.name())).collect();
        Ok(Self { place, column: axis.column(), values, stride })
    }

    /// The name of the folder that holds the table.
    pub fn folder(&self) -> String {
        format!("table-by-{}", self.column)
    }

    /// The files of the table in the order of the axis, as paths that begin with the name of the folder.
    pub fn files(&self) -> Vec<String> {
        let (folder, column) = (self.folder(), &self.column);
        self.values.iter().map(|value| format!("{folder}/{column}={value}/part-0.parquet")).collect()
    }

    /// Which of the `total` cases are in file `index`: blocks of consecutive cases with the same value.
    pub fn layout(&self, total: u64, index: usize) -> Layout {
        let shard = Shard { index: index as u64, count: self.values.len() as u64 };
        Layout { total, block: self.stride, shard }
    }
}

/// A value as part of a path. Every byte other than a letter, a digit, `-`, `_` or `.` becomes %XX, which readers
/// decode.
fn encoded(word: &str) -> String {
    let sign = |byte: u8| match byte {
        b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_' | b'.' => char::from(byte).to_string(),
        other => format!("%{other:02X}"),
    };
    word.bytes().map(sign).collect()
}
