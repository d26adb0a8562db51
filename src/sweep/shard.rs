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

/// The value of a variable of the environment.
pub type Lookup = dyn Fn(&str) -> Option<String>;

impl Shard {
    /// Shard `index` of `count`.
    ///
    /// # Errors
    /// [`Error`] for a count of 0 or above [`MOST_SHARDS`], and unless index < count.
    pub fn new(index: u64, count: u64) -> Result<Self, Error> {
        let problem = match count {
            0 => "there are no shards of 0: write i/n with n of 1 or more, such as 0/16".to_owned(),
            _ if count > MOST_SHARDS => format!("{count} shards: at most {MOST_SHARDS} are allowed"),
            _ if index < count => return Ok(Self { index, count }),
            _ => format!(
                "shard {index}/{count}: shards are counted from 0, so the last of {count} is {}; with a one-based array index subtract 1",
                count - 1
            ),
        };
        Err(Error::input(format!("--shard: {problem}")))
    }

    /// Reads `i/n`, or `VARIABLE/n` with a variable that `environment` looks up.
    ///
    /// # Errors
    /// As for [`Shard::new`]; and for a text of another form, and a variable that is not set.
    pub fn parse(text: &str, environment: Option<&Lookup>) -> Result<Self, Error> {
        let form =
            |text: &str| Error::input(format!("--shard: shard \"{text}\": write i/n, two whole numbers, such as 0/16"));
        let (index, count) = text.split_once('/').ok_or_else(|| form(text))?;
        let unset = || {
            Error::input(format!(
                "--shard: the environment variable {index} is not set; it holds the shard's number, counted from 0, under the job scheduler"
            ))
        };
        let index = match environment {
            Some(look_up) => look_up(index).ok_or_else(unset)?,
            None => index.to_owned(),
        };
        let number = |part: &str| part.trim().parse().map_err(|_| form(&format!("{}/{count}", index.trim())));
        Self::new(number(&index)?, number(count)?)
    }

    /// Whether a part belongs to this shard.
    pub fn has(self, part: u64) -> bool {
        part % self.count == self.index
    }
}
