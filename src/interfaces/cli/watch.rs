//! Work that may take long: a terminal shows its progress, and Ctrl-C or SIGTERM stops it. Files stay complete, as an
//! unfinished file has not replaced any other.

use std::io::{self, IsTerminal as _};
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use plm_impact::error::{Error, ErrorKind};
use plm_impact::files::{Progress, abandon, on_disk_change};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use signal_hook::low_level::raise;

use super::pace::Pace;
use super::terminal::failed_with;

/// Bytes of the stack of a thread, as many as that of a program.
const STACK_BYTES: usize = 8 << 20;
/// Time between two looks for a signal.
const POLL_INTERVAL: Duration = Duration::from_millis(50);
/// A bar is shown for work that takes longer than this.
const BAR_DELAY: Duration = Duration::from_millis(500);
/// Another delay in milliseconds, for tests.
const BAR_DELAY_VARIABLE: &str = "PLM_IMPACT_TEST_BAR_AFTER_MS";
/// Time between two lines on the progress where standard error is no terminal, such as the log of a batch job.
const LOG_INTERVAL: Duration = Duration::from_secs(60);
/// Another interval in milliseconds, for tests.
const LOG_INTERVAL_VARIABLE: &str = "PLM_IMPACT_TEST_LOG_EVERY_MS";
/// Another patience in milliseconds, for tests.
const PATIENCE_VARIABLE: &str = "PLM_IMPACT_TEST_PATIENCE_MS";
/// A signal for tests, and the change of the disk at which it comes: `9@12` kills at the twelfth.
const SIGNAL_VARIABLE: &str = "PLM_IMPACT_TEST_SIGNAL";
/// A shell adds the number of the signal to this for the exit code.
const SIGNAL_EXIT_BASE: usize = 128;

/// Ctrl-C and SIGTERM. Once they are listened to they do not end the process but stop the work that is watched.
pub struct Signals {
    is_set: Arc<AtomicBool>,
    /// The exit code after the signal that was received.
    code: Arc<AtomicUsize>,
    /// True if signals end the process, as they do by default.
    is_off: Arc<AtomicBool>,
}

impl Signals {
    /// Listens from now on. This comes before anything is written, so that a signal never leaves an empty folder. A process
    /// registers its handlers once, however often it listens.
    pub fn listen() -> Result<&'static Self, Error> {
        static SIGNALS: OnceLock<Signals> = OnceLock::new();
        let signals = if let Some(signals) = SIGNALS.get() {
            signals
        } else {
            let registered = Self::register().map_err(failed_with("signals"))?;
            SIGNALS.get_or_init(|| registered)
        };
        signals.is_off.store(false, Ordering::Relaxed);
        Ok(signals)
    }

    fn register() -> io::Result<Self> {
        let (is_set, code, is_off) = (Arc::default(), Arc::default(), Arc::new(AtomicBool::new(true)));
        for signal in [SIGINT, SIGTERM] {
            let exit_code = SIGNAL_EXIT_BASE + signal.unsigned_abs() as usize;
            flag::register_conditional_default(signal, Arc::clone(&is_off))?;
            flag::register_usize(signal, Arc::clone(&code), exit_code)?;
            flag::register(signal, Arc::clone(&is_set))?;
        }
        Ok(Self { is_set, code, is_off })
    }
}

pub struct Watch {
    pub is_quiet: bool,
    /// The things that are counted, such as rows.
    pub counted: &'static str,
    /// Time that the work has to stop by itself after a signal; then it is abandoned.
    pub grace_period: Duration,
    /// States what abandoned work leaves, and what to do then.
    pub on_abandon: &'static str,
}

impl Watch {
    /// The watch of work that writes no files.
    pub fn without_files(is_quiet: bool) -> Self {
        Self { is_quiet, counted: "done", grace_period: Duration::ZERO, on_abandon: "no files were written" }
    }

    /// Does the work on a thread of its own. A signal asks it to stop.
    ///
    /// # Errors
    /// Returns the error of the work. After a signal the error has the exit code of that signal. It is an error too if the system
    /// gives no thread.
    pub fn watch<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Progress) -> Result<T, Error> + Send + 'static,
    ) -> Result<T, Error> {
        let signals = Signals::listen()?;
        let progress = Arc::new(Progress::with_stop_flag(Arc::clone(&signals.is_set)));
        let (sender, receiver) = channel();
        let counter = Arc::clone(&progress);
        let worker = thread::Builder::new().stack_size(STACK_BYTES).spawn(move || drop(sender.send(work(&counter))));
        let worker = worker.map_err(failed_with("thread"))?;
        let done = self.wait(&receiver, &progress);
        // signals end the process from now on, as they do by default
        signals.is_off.store(true, Ordering::Relaxed);
        let done = done.unwrap_or_else(|| {
            // the worker panicked, or ended without a result
            worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            Err(Error::failed("the work ended without a result"))
        });
        done.map_err(|error| match (error.kind, u8::try_from(signals.code.load(Ordering::Relaxed))) {
            (ErrorKind::Stopped(_), Ok(code @ 1..)) => {
                // abandoned work may see the signal first; its message is then the same
                let message = if self.grace_period.is_zero() { self.interruption_message() } else { error.to_string() };
                Error::new(ErrorKind::Stopped(code), message)
            }
            _ => error,
        })
    }

    fn interruption_message(&self) -> String {
        format!("interrupted; {}", self.on_abandon)
    }

    /// The result of the work; `None` if the worker ended without a result (it panicked).
    fn wait<T>(&self, receiver: &Receiver<Result<T, Error>>, progress: &Progress) -> Option<Result<T, Error>> {
        let (begun, mut signalled) = (Instant::now(), None);
        let bar = self.progress_bar();
        let (bar_delay, log_interval) =
            (duration(BAR_DELAY_VARIABLE, BAR_DELAY), duration(LOG_INTERVAL_VARIABLE, LOG_INTERVAL));
        let patience = duration(PATIENCE_VARIABLE, self.grace_period).min(self.grace_period);
        let (mut pace, mut logged) = (Pace::default(), begun);
        let done = loop {
            if progress.is_stopped() && signalled.get_or_insert_with(Instant::now).elapsed() >= patience {
                // the files of the work are on its thread, which ends with the process
                abandon();
                break Some(Err(Error::new(ErrorKind::Stopped(0), self.interruption_message())));
            }
            let received = receiver.recv_timeout(POLL_INTERVAL);
            let (done, total) = progress.counts();
            if total > 1 {
                pace.add(begun.elapsed(), done);
                if begun.elapsed() >= bar_delay {
                    bar.set_length(total);
                    bar.set_message(pace.describe(total, self.counted));
                    bar.set_position(done);
                }
                if self.is_logged() && logged.elapsed() >= log_interval {
                    super::terminal::note(pace.describe(total, self.counted));
                    logged = Instant::now();
                }
            }
            match received {
                Ok(done) => break Some(done),
                Err(RecvTimeoutError::Disconnected) => break None,
                Err(RecvTimeoutError::Timeout) => {}
            }
        };
        bar.finish_and_clear();
        done
    }

    /// True if the progress is printed as lines, because no terminal shows a bar.
    fn is_logged(&self) -> bool {
        !self.is_quiet && !io::stderr().is_terminal()
    }

    /// A bar, which a terminal shows as soon as it moves.
    fn progress_bar(&self) -> ProgressBar {
        if self.is_quiet || super::terminal::is_json() || !io::stderr().is_terminal() {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template("{bar:40} {msg}");
        ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    }
}

/// The milliseconds of a variable of the environment, if it gives any.
fn duration(variable: &str, default: Duration) -> Duration {
    let given = std::env::var(variable).ok().and_then(|time| time.parse().ok());
    given.map_or(default, Duration::from_millis)
}

/// For tests: the process sends itself the signal that the environment names.
pub fn install_test_signal() {
    let Some((signal, change)) = std::env::var(SIGNAL_VARIABLE).ok().and_then(|text| parse(&text)) else { return };
    let changes = AtomicU64::new(0);
    on_disk_change(move || {
        if changes.fetch_add(1, Ordering::Relaxed) + 1 == change {
            // a system without this signal continues
            drop(raise(signal));
        }
    });
}

fn parse(text: &str) -> Option<(i32, u64)> {
    let (signal, change) = text.split_once('@')?;
    Some((signal.parse().ok()?, change.parse().ok()?))
}
