//! Ctrl-C and SIGTERM: a sweep is asked to stop, and is ended if it has not stopped within a second. Its files stay
//! complete, as an unfinished file has not replaced any other.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use plm_impact::error::{Error, ErrorKind};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::terminal::other;

/// A shell adds the number of the signal to this for the exit code.
const ENDED_BY: usize = 128;
/// Time between two looks for a signal.
pub const LOOK: Duration = Duration::from_millis(50);
/// Time that a run has to stop by itself.
const PATIENCE: Duration = Duration::from_millis(700);

/// Whether a signal came, and which. Once this is dropped, signals end the process as they do by default.
pub struct Interrupt {
    /// Set by either signal.
    pub is_set: Arc<AtomicBool>,
    code: Arc<AtomicUsize>,
    is_over: Arc<AtomicBool>,
    /// What a run that is ended now leaves.
    leaves: Arc<Mutex<&'static str>>,
}

impl Interrupt {
    /// Listens from now on.
    pub fn listen() -> Result<Self, Error> {
        let interrupt =
            Self { is_set: Arc::default(), code: Arc::default(), is_over: Arc::default(), leaves: Arc::default() };
        for signal in [SIGINT, SIGTERM] {
            let code = ENDED_BY + signal.unsigned_abs() as usize;
            let listened = flag::register_conditional_default(signal, Arc::clone(&interrupt.is_over));
            let listened = listened.and_then(|_| flag::register_usize(signal, Arc::clone(&interrupt.code), code));
            listened.and_then(|_| flag::register(signal, Arc::clone(&interrupt.is_set))).map_err(other("signals"))?;
        }
        Ok(interrupt)
    }

    /// Says what a run that is ended from now on leaves, and what to do then.
    pub fn leave(&self, what: &'static str) {
        *self.leaves.lock().unwrap_or_else(PoisonError::into_inner) = what;
    }

    /// From now on the process ends a second after a signal, even if a single row or a picture takes longer.
    pub fn end_the_slow(&self) -> Result<(), Error> {
        let (code, leaves) = (Arc::clone(&self.code), Arc::clone(&self.leaves));
        let end = move || {
            while code.load(Ordering::Relaxed) == 0 {
                std::thread::sleep(LOOK);
            }
            std::thread::sleep(PATIENCE);
            let leaves = *leaves.lock().unwrap_or_else(PoisonError::into_inner);
            let exit_code = super::terminal::error(&stopped(format!("interrupted; {leaves}"), &code));
            std::process::exit(exit_code.into());
        };
        std::thread::Builder::new().spawn(end).map(drop).map_err(other("signals"))
    }

    /// The error of a sweep, with the exit code of the signal.
    pub fn explain(&self, error: Error) -> Error {
        if let ErrorKind::Stopped(_) = error.kind { stopped(error.to_string(), &self.code) } else { error }
    }

    /// The error where a signal stopped work that leaves no files.
    pub fn nothing_written(&self) -> Option<Error> {
        let is_set = self.is_set.load(Ordering::Relaxed);
        is_set.then(|| stopped("interrupted; nothing was written".to_owned(), &self.code))
    }
}

impl Drop for Interrupt {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
    }
}

fn stopped(what: String, code: &AtomicUsize) -> Error {
    let exit_code = u8::try_from(code.load(Ordering::Relaxed)).ok().filter(|code| *code > 0);
    Error::new(ErrorKind::Stopped(exit_code.unwrap_or(130)), what)
}
