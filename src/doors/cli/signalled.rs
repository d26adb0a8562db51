//! For tests: a signal that comes at a certain change of the disk, such as a kill at the twelfth.

use std::sync::atomic::{AtomicU64, Ordering};

use plm_impact::files::after_changes;
use signal_hook::low_level::raise;

/// The number of the signal, and at which change it comes: `9@12`.
const SIGNAL: &str = "PLM_IMPACT_SIGNAL";

/// The process sends itself the signal that the environment names.
pub fn when_signalled() {
    let Some((signal, change)) = std::env::var(SIGNAL).ok().and_then(|text| parse(&text)) else { return };
    let changes = AtomicU64::new(0);
    after_changes(move || {
        if changes.fetch_add(1, Ordering::Relaxed) + 1 == change {
            // a system without this signal goes on
            drop(raise(signal));
        }
    });
}

fn parse(text: &str) -> Option<(i32, u64)> {
    let (signal, change) = text.split_once('@')?;
    Some((signal.parse().ok()?, change.parse().ok()?))
}
