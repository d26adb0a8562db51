//! Scenarios to start from, for `plm-impact init`. A test compares their comments with those of the keys.

use super::Kind;

/// A scenario of this kind, with a comment for every key.
pub fn template(kind: Kind) -> &'static str {
    match kind {
        Kind::Impact => include_str!("template/impact.toml"),
        Kind::Sweep => include_str!("template/sweep.toml"),
        Kind::MonteCarlo => include_str!("template/monte_carlo.toml"),
        Kind::Repeat => include_str!("template/repeat.toml"),
        Kind::Compare => include_str!("template/compare.toml"),
        Kind::Indentation => include_str!("template/indentation.toml"),
        Kind::Calibrate => include_str!("template/calibrate.toml"),
    }
}
