//! Work that may take long: a terminal shows its progress, and a signal stops it.

use std::io::{self, IsTerminal as _};
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;

use indicatif::{ProgressBar, ProgressStyle};
use plm_impact::error::Error;
use plm_impact::progress::Counter;

use super::interrupt::{Interrupt, LOOK};
use super::terminal::other;

/// Bytes of the stack of a thread, as many as that of a program.
const STACK: usize = 8 << 20;
/// A bar is shown for work that is not done after so many looks.
const SOON: u32 = 10;

/// Does the work on a thread of its own, and abandons it when a signal comes.
///
/// # Errors
/// [`Error`] after a signal; and where the system gives neither thread nor signals.
pub fn watched<T: Send + 'static>(
    is_quiet: bool,
    work: impl FnOnce(&Counter) -> T + Send + 'static,
) -> Result<T, Error> {
    let interrupt = Interrupt::listen()?;
    let progress = Arc::new(Counter::default());
    let (sender, receiver) = channel();
    let counter = Arc::clone(&progress);
    let worker = thread::Builder::new().stack_size(STACK).spawn(move || drop(sender.send(work(&counter))));
    let worker = worker.map_err(other("thread"))?;
    let bar = bar(is_quiet, "{human_pos}/{human_len} done, {elapsed}");
    for look in 0_u32.. {
        match receiver.recv_timeout(LOOK) {
            Ok(done) => {
                bar.finish_and_clear();
                return Ok(done);
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
        if let Some(stopped) = interrupt.nothing_written() {
            bar.finish_and_clear();
            return Err(stopped);
        }
        let (done, total) = progress.read();
        if look > SOON && total > 1 {
            bar.set_length(total);
            bar.set_position(done);
        }
    }
    // it ended without a result: by a panic
    worker.join().unwrap_or_else(|panic| resume_unwind(panic));
    Err(Error::failed("the work ended without a result".to_owned()))
}

/// A bar on a terminal, with a text after it.
pub fn bar(is_quiet: bool, text: &str) -> ProgressBar {
    if is_quiet || super::terminal::is_json() || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {text}"));
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
