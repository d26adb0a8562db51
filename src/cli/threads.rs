//! The threads of a command: as many as are asked for, or as the system gives.

use clap::builder::RangedI64ValueParser;
use clap::value_parser;
use plm_impact::error::Error;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// More threads could stop a machine.
const MOST: u16 = 1024;
/// The variable with the number of threads, where no option gives it.
const VARIABLE: &str = "RAYON_NUM_THREADS";

/// Numbers that `--threads` takes.
pub fn allowed() -> RangedI64ValueParser<u16> {
    value_parser!(u16).range(1..=i64::from(MOST))
}

/// Does the work on as many threads as the option says, or the environment, or on one per core. If the system starts fewer,
/// the work is done on fewer.
///
/// # Errors
/// [`Error`] for a number in the environment that is not allowed, or where there is not one thread.
pub fn with<R: Send>(option: Option<u16>, work: impl FnOnce() -> R + Send) -> Result<R, Error> {
    let cores = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let wanted = match option.map_or_else(from_environment, Ok)? {
        0 => cores(),
        threads => usize::from(threads),
    };
    Ok(start(wanted)?.install(work))
}

fn from_environment() -> Result<u16, Error> {
    let Some(text) = std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) else { return Ok(0) };
    let threads = text.to_str().and_then(|text| text.parse().ok()).filter(|threads| *threads <= MOST);
    threads.ok_or_else(|| {
        let text = text.to_string_lossy();
        Error::input(format!("{VARIABLE}={}: a number of threads is 0 to {MOST}", text.escape_debug()))
    })
}

/// Starts the threads. If the system refuses, half as many are tried, and so on. A single thread is the current one.
fn start(wanted: usize) -> Result<ThreadPool, Error> {
    let mut threads = wanted;
    loop {
        let builder = || ThreadPoolBuilder::new().num_threads(threads);
        // the current thread may belong to a pool already
        let one = || builder().use_current_thread().build().or_else(|_| builder().build());
        match if threads == 1 { one() } else { builder().build() } {
            Ok(pool) => {
                if threads < wanted {
                    super::terminal::warning(format_args!(
                        "the system did not start {wanted} threads; going on with {threads} of {wanted} threads"
                    ));
                }
                return Ok(pool);
            }
            Err(_) if threads > 1 => threads /= 2,
            Err(error) => return Err(Error::input(format!("no thread to work on: {error}"))),
        }
    }
}
