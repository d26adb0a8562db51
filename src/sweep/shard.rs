//! Which parts of a table a shard computes: part k belongs to shard k mod n, so that all n shards take about the same time.

use crate::error::Error;

/// Part `index` of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Counted from 0.
    pub index: u64,
    /// At least 1.
    pub count: u64,
}

/// The largest number of shards, that of an indexed job of Kubernetes.
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
    #[error("{0} shards: at most {MOST_SHARDS} are allowed")]
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

    /// Whether a part belongs to this shard.
    pub fn has(self, part: u64) -> bool {
        part % self.count == self.index
    }

    /// Reads `VARIABLE/n`, with the variable looked up by `environment`.
    pub fn parse_with_variable(text: &str, environment: impl Fn(&str) -> Option<String>) -> Result<Self, ShardError> {
        let (variable, count) = text.split_once('/').ok_or_else(|| ShardError::Form(text.to_owned()))?;
        let index = environment(variable).ok_or_else(|| ShardError::Unset(variable.to_owned()))?;
        Self::parse(&format!("{}/{count}", index.trim()))
    }
}
