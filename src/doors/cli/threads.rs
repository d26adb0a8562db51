//! The threads of a command: as many as are asked for, or as the system gives.

use clap::builder::RangedI64ValueParser;
use clap::value_parser;
use plm_impact::error::Error;
use rayon::ThreadPoolBuilder;

/// More threads could stop a machine.
const MOST: u16 = 1024;
/// The variable with the number of threads, where no option gives it.
const VARIABLE: &str = "RAYON_NUM_THREADS";

/// Numbers that `--threads` takes.
pub fn allowed() -> RangedI64ValueParser<u16> {
    value_parser!(u16).range(1..=i64::from(MOST))
}

/// Does the work on as many threads as the option says, or the environment, or on one per core.
///
/// # Errors
/// [`Error`] for a number in the environment that is not allowed, and where the system does not start so many.
pub fn with<R: Send>(option: Option<u16>, work: impl FnOnce() -> R + Send) -> Result<R, Error> {
    let threads = option.map_or_else(from_environment, Ok)?;
    let pool = ThreadPoolBuilder::new().num_threads(threads.into()).build().map_err(|error| {
        Error::input(format!("the system does not start {threads} threads: {error}; give fewer with --threads"))
    })?;
    Ok(pool.install(work))
}

/// The number of threads by the environment; 0 is one per core.
fn from_environment() -> Result<u16, Error> {
    let Some(text) = std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) else { return Ok(0) };
    let threads = text.to_str().and_then(|text| text.parse().ok()).filter(|threads| *threads <= MOST);
    threads.ok_or_else(|| {
        let text = text.to_string_lossy();
        Error::input(format!("{VARIABLE}={}: a number of threads is 0 to {MOST}", text.escape_debug()))
    })
}
