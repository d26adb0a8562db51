//! Zeros inside a bracket.

/// The next guess of a zero between two bounds: Newton's where it lies between them, else their middle.
#[inline(always)]
#[must_use]
pub fn next_guess(newton: f64, low: f64, high: f64) -> f64 {
    if newton > low && newton < high { newton } else { 0.5 * (low + high) }
}
