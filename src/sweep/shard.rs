//! Which rows a shard has. The cases are divided into blocks; block b belongs to shard b mod n, so that all n shards
//! take about the same time.

use std::ops::Range;

use crate::error::Error;

/// Part `index` of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Counted from 0.
    pub index: u64,
    /// At least 1.
    pub count: u64,
}

/// The largest number of shards: merging needs a buffer for every shard, and an indexed job of Kubernetes has the same
/// limit.
pub const MOST_SHARDS: u64 = 100_000;

/// Why a text or a number names no shard.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ShardError {
    /// The text is not of the form `i/n`.
    #[error("shard \"{0}\": write i/n, two whole numbers, such as 0/16")]
    Form(String),
    /// The number of shards is 0.
    #[error("there are no shards of 0: write i/n with n of 1 or more, such as 0/16")]
    None,
    /// There are more than [`MOST_SHARDS`] shards.
    #[error("{0} shards: at most {MOST_SHARDS} are allowed; give each more cases")]
    Many(u64),
    /// The index is not below the number of shards.
    #[error("shard {index}/{count}: shards are counted from 0, so the last of {count} is {}; with a one-based array index subtract 1", .count.saturating_sub(1))]
    Range {
        /// The index that was asked for.
        index: u64,
        /// The number of shards.
        count: u64,
    },
    /// The environment variable is not set.
    #[error(
        "the environment variable {0} is not set; it holds the shard's number, counted from 0, under the job scheduler"
    )]
    Unset(String),
}

impl From<ShardError> for Error {
    fn from(error: ShardError) -> Self {
        Self::input(format!("--shard: {error}"))
    }
}

impl Shard {
    /// The whole table as one shard.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Shard `index` of `count`.
    ///
    /// # Errors
    /// [`ShardError::None`] for a count of 0, [`ShardError::Many`] above [`MOST_SHARDS`], [`ShardError::Range`] unless
    /// index < count.
    pub fn new(index: u64, count: u64) -> Result<Self, ShardError> {
        match count {
            0 => Err(ShardError::None),
            _ if count > MOST_SHARDS => Err(ShardError::Many(count)),
            _ if index < count => Ok(Self { index, count }),
            _ => Err(ShardError::Range { index, count }),
        }
    }

    /// Reads `i/n`.
    pub fn parse(text: &str) -> Result<Self, ShardError> {
        let form = || ShardError::Form(text.to_owned());
        let (index, count) = text.split_once('/').ok_or_else(form)?;
        let number = |text: &str| text.trim().parse().map_err(|_| form());
        Self::new(number(index)?, number(count)?)
    }

    /// Reads `VARIABLE/n`, with the variable looked up by `environment`.
    pub fn parse_with_variable(text: &str, environment: impl Fn(&str) -> Option<String>) -> Result<Self, ShardError> {
        let (variable, count) = text.split_once('/').ok_or_else(|| ShardError::Form(text.to_owned()))?;
        let index = environment(variable).ok_or_else(|| ShardError::Unset(variable.to_owned()))?;
        Self::parse(&format!("{}/{count}", index.trim()))
    }
}

/// The cases of one shard, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Number of cases of all shards together.
    pub total: u64,
    /// Number of cases in a block.
    pub block: u64,
    /// The shard.
    pub shard: Shard,
}

impl Layout {
    /// Divides the cases into blocks of at most 1024. If there are enough cases, each shard has at least 16 blocks.
    pub fn new(total: u64, shard: Shard) -> Self {
        let block = (total / shard.count.saturating_mul(16)).clamp(1, 1024);
        Self { total, block, shard }
    }

    /// Number of rows of this shard.
    pub fn rows(&self) -> u64 {
        let Shard { index, count } = self.shard;
        let (full, rest) = (self.total / self.block, self.total % self.block);
        let blocks = full / count + u64::from(full % count > index);
        blocks * self.block + if full % count == index { rest } else { 0 }
    }

    /// The case of row `row` of this shard.
    pub fn case(&self, row: u64) -> u64 {
        (row / self.block * self.shard.count + self.shard.index) * self.block + row % self.block
    }

    /// The cases of a range of rows, in as few ranges as possible.
    pub fn cases(&self, rows: Range<u64>) -> Vec<Range<u64>> {
        if self.shard.count == 1 {
            return vec![rows];
        }
        let mut ranges = Vec::new();
        let mut row = rows.start;
        while row < rows.end {
            let length = (self.block - row % self.block).min(rows.end - row);
            let first = self.case(row);
            ranges.push(first..first + length);
            row += length;
        }
        ranges
    }
}
