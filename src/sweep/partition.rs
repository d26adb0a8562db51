//! A table as a data set: a file for every value of an axis, in a folder that says the value, as Hive names them
//! (`law=thornton`). DuckDB, polars, DataFusion, Arrow and Spark read the folder as one table and skip files by the value.

use super::SweepError;
use super::shard::{Layout, Shard};
use crate::plan::axis::Axis;
use crate::plan::{Cases, Plan};

/// How a table is divided into files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Partition {
    /// Place of the axis among those of the plan.
    pub(super) place: usize,
    /// The column whose values the folders have in place of the files.
    column: String,
    /// Its values, as the names of folders have them.
    values: Vec<String>,
    /// Cases from one value to the next.
    stride: u64,
}

impl Partition {
    /// The division by the axis of this key, which has to be one of words: a law, a method, or a material.
    ///
    /// # Errors
    /// [`SweepError::PartitionBy`].
    pub fn of(plan: &Plan, key: &str) -> Result<Self, SweepError> {
        let axes = if let Cases::Grid(axes) = &plan.cases { axes.as_slice() } else { &[] };
        let found = axes.iter().enumerate().find(|(_, axis)| axis.path() == key);
        let Some((place, axis, words)) = found.and_then(|(place, axis)| Some((place, axis, axis.words()?))) else {
            let of_words = axes.iter().filter(|axis| axis.words().is_some()).map(Axis::path).collect();
            return Err(SweepError::PartitionBy { key: key.to_owned(), of_words });
        };
        let stride = axes[place + 1..].iter().map(Axis::len).product();
        Ok(Self { place, column: axis.column(), values: words.iter().map(|word| encoded(word)).collect(), stride })
    }

    /// The name of the folder that is the table.
    pub fn folder(&self) -> String {
        format!("table-by-{}", self.column)
    }

    /// The files in it, in the order of the axis, as seen from beside that folder.
    pub fn files(&self) -> Vec<String> {
        let (folder, column) = (self.folder(), &self.column);
        self.values.iter().map(|value| format!("{folder}/{column}={value}/part-0.parquet")).collect()
    }

    /// Which cases file `index` has, out of `total`: blocks of as many cases as the axis keeps its value.
    pub fn layout(&self, total: u64, index: usize) -> Layout {
        let shard = Shard { index: index as u64, count: self.values.len() as u64 };
        Layout { total, block: self.stride, shard }
    }
}

/// A value in a path: bytes of signs with a meaning in some shell, system or address as %XX, which readers turn back.
fn encoded(word: &str) -> String {
    let sign = |byte: u8| match byte {
        b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_' | b'.' => char::from(byte).to_string(),
        other => format!("%{other:02X}"),
    };
    word.bytes().map(sign).collect()
}
