//! Which parts of a table a shard computes: part k belongs to shard k mod n, so that all n shards take about the same time.

use crate::error::Error;

/// One of `count` shards of a table, which computes the parts `index`, `index` + `count`, `index` + 2 `count` and so on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Counted from 0.
    pub index: u64,
    /// At least 1.
    pub count: u64,
}

/// The largest number of shards, that of an indexed job of Kubernetes.
pub const MAX_SHARDS: u64 = 100_000;

impl Shard {
    /// Reads `i/n`.
    ///
    /// # Errors
    /// [`Error`] for a text of another form, for n = 0 or above [`MAX_SHARDS`], and unless i < n.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let numbers = text.split_once('/').map(|(index, count)| (index.trim().parse(), count.trim().parse()));
        let problem = match numbers {
            Some((Ok(_), Ok(0))) => "the number of shards must be at least 1. Write i/n, such as 0/16.".to_owned(),
            Some((Ok(_), Ok(count))) if count > MAX_SHARDS => {
                format!("{count} shards: at most {MAX_SHARDS} are allowed")
            }
            Some((Ok(index), Ok(count))) if index < count => return Ok(Self { index, count }),
            Some((Ok(index), Ok(count))) => format!(
                "shard {index}/{count}: shards are counted from 0, so the last of {count} is {}; with a one-based array index subtract 1",
                count - 1
            ),
            _ => format!("shard \"{text}\": write i/n, two whole numbers, such as 0/16"),
        };
        Err(Error::input(format!("--shard: {problem}")))
    }

    /// The shard of a task in a Slurm array job, from its environment: the task of the lowest index has shard 0.
    ///
    /// # Errors
    /// [`Error`] outside of an array job.
    pub fn from_slurm(variable: impl Fn(&str) -> Option<String>) -> Result<Self, Error> {
        let number = |name: &str| {
            let text = variable(name).unwrap_or_default();
            let reason = || {
                Error::input(format!(
                    "--shard auto: {name}=\"{text}\" is not a whole number. auto works only in a task of a Slurm array job. Elsewhere write i/n, such as 0/16."
                ))
            };
            text.trim().parse::<u64>().map_err(|_| reason())
        };
        let [id, count, first] = ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN"].map(number);
        // an array without a step has the step 1
        let step = number("SLURM_ARRAY_TASK_STEP").unwrap_or(1).max(1);
        Self::parse(&format!("{}/{}", id?.saturating_sub(first?) / step, count?))
    }

    /// True if a part belongs to this shard.
    pub fn contains(self, part: u64) -> bool {
        part % self.count == self.index
    }
}
