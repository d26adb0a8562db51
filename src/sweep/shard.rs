//! Which rows a shard has: cases are dealt out in blocks, block b to shard b mod n, so that all shards cost the same.

use std::ops::Range;

use thiserror::Error;

/// Part `index` of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// From 0 on.
    pub index: u64,
    /// At least 1.
    pub count: u64,
}

/// Merging takes a buffer for every shard, and no job scheduler is asked for larger arrays: an indexed job of Kubernetes has
/// at most so many parts.
pub const MOST_SHARDS: u64 = 100_000;

/// A shard that does not exist.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ShardError {
    /// Not of the form.
    #[error("shard \"{0}\": write i/n, two whole numbers, such as 0/16")]
    Form(String),
    /// None at all.
    #[error("there are no shards of 0: write i/n with n of 1 or more, such as 0/16")]
    None,
    /// Too many.
    #[error("{0} shards: at most {MOST_SHARDS} are allowed; give each more cases")]
    Many(u64),
    /// No such shard.
    #[error("shard {index}/{count}: shards are counted from 0, so the last of {count} is {}; with a one-based array index subtract 1", .count.saturating_sub(1))]
    Range {
        /// Asked for.
        index: u64,
        /// Of so many.
        count: u64,
    },
    /// Not set.
    #[error(
        "the environment variable {0} is not set; it holds the shard's number, counted from 0, under the job scheduler"
    )]
    Unset(String),
}

impl Shard {
    /// All of it, as an undivided table has it.
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
    ///
    /// # Errors
    /// [`ShardError`].
    pub fn parse(text: &str) -> Result<Self, ShardError> {
        let form = || ShardError::Form(text.to_owned());
        let (index, count) = text.split_once('/').ok_or_else(form)?;
        let number = |text: &str| text.trim().parse().map_err(|_| form());
        Self::new(number(index)?, number(count)?)
    }

    /// Reads `VARIABLE/n`, with the variable looked up by `environment`.
    ///
    /// # Errors
    /// [`ShardError`].
    pub fn parse_with_variable(text: &str, environment: impl Fn(&str) -> Option<String>) -> Result<Self, ShardError> {
        let (variable, count) = text.split_once('/').ok_or_else(|| ShardError::Form(text.to_owned()))?;
        let index = environment(variable).ok_or_else(|| ShardError::Unset(variable.to_owned()))?;
        Self::parse(&format!("{}/{count}", index.trim()))
    }
}

/// The cases of one shard, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Cases of all shards together.
    pub total: u64,
    /// Cases a block.
    pub block: u64,
    /// Which shard.
    pub shard: Shard,
}

impl Layout {
    /// Blocks of at most 1024 cases, and at least 16 blocks a shard where there are cases enough.
    pub fn new(total: u64, shard: Shard) -> Self {
        let block = (total / shard.count.saturating_mul(16)).clamp(1, 1024);
        Self { total, block, shard }
    }

    /// Rows of this shard.
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

    /// The cases of a range of rows, as few ranges as possible.
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
