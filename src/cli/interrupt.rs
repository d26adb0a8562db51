//! Ctrl-C and SIGTERM: the run is asked to stop, and if it has not within a second it is ended. Whatever it was at, its
//! files are whole: what is not complete has not taken its place.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use anyhow::Context as _;
use plm_impact::error::Error;
use plm_impact::sweep::SweepError;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

/// What a shell says of a process that this signal ended.
const ENDED_BY: usize = 128;
/// How often signals are looked for, and how long a run has to stop by itself.
const LOOK: Duration = Duration::from_millis(50);
const PATIENCE: Duration = Duration::from_millis(700);

/// Whether a signal came, and which.
pub struct Interrupt {
    /// Set by either signal.
    pub is_set: Arc<AtomicBool>,
    code: Arc<AtomicUsize>,
}

impl Interrupt {
    /// Listens from now on.
    pub fn listen() -> anyhow::Result<Self> {
        let interrupt = Self { is_set: Arc::default(), code: Arc::default() };
        for signal in [SIGINT, SIGTERM] {
            let code = ENDED_BY + usize::try_from(signal)?;
            let listened = flag::register_usize(signal, Arc::clone(&interrupt.code), code);
            listened.and_then(|_| flag::register(signal, Arc::clone(&interrupt.is_set))).context("signals")?;
        }
        let code = Arc::clone(&interrupt.code);
        std::thread::Builder::new().spawn(move || end_the_slow(&code)).context("signals")?;
        Ok(interrupt)
    }

    /// The error of a sweep, with the exit code of the signal.
    pub fn explain(&self, error: SweepError) -> Error {
        let is_stop = matches!(error, SweepError::Interrupted { .. } | SweepError::Dropped);
        let is_term = i32::try_from(self.code.load(Ordering::Relaxed)).is_ok_and(|code| code == 128 + SIGTERM);
        if is_stop && is_term { Error::Terminated(error) } else { Error::Sweep(error) }
    }
}

/// Ends the process where a single row, or a picture, takes longer than a second.
fn end_the_slow(code: &AtomicUsize) {
    while code.load(Ordering::Relaxed) == 0 {
        std::thread::sleep(LOOK);
    }
    std::thread::sleep(PATIENCE);
    super::terminal::note("error: interrupted; the same command goes on from the rows that are written");
    std::process::exit(i32::try_from(code.load(Ordering::Relaxed)).unwrap_or(1));
}
