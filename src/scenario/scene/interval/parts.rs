//! The interval of e as a result: its ends, its parts, and their text.

use serde::Serialize;

use crate::numerics::functions::log10;

/// Below this e hardly any energy is recovered, and the digits of e are not significant.
pub const SMALL: f64 = 0.02;

/// The name of a part for a range of hardness begins with this.
pub(super) const HARDNESS: &str = "hardness";
/// Names of the two parts of the law. The text of an interval shows them as one.
pub(super) const LAW_BIAS: &str = "law, mean error";
pub(super) const LAW_SCATTER: &str = "law, scatter";

/// The effect of a part on the interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PartKind {
    /// A known bias: both ends move.
    Shift,
    /// Scatter, added as squares.
    Width,
    /// An error of unknown size, which the interval does not include.
    NotIncluded,
}

/// A source of error of e.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct IntervalPart {
    pub name: String,
    pub kind: PartKind,
    /// The lowest e by this part, relative to e, minus 1.
    pub low: f64,
    /// The highest e by this part, relative to e, minus 1.
    pub high: f64,
}

/// The uncertainty interval of e, and its parts.
#[derive(Debug, Clone, PartialEq)]
pub struct RestitutionInterval {
    pub low: f64,
    pub high: f64,
    pub parts: Vec<IntervalPart>,
}

impl RestitutionInterval {
    /// Both ends, with enough digits to differ, and the sources of error.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 2 and 17
    pub fn to_text(&self) -> String {
        let Self { low, high, parts } = self;
        let digits = (-log10(high - low)).ceil().clamp(2.0, 17.0) as usize;
        let (mut law, mut sources) = ([1.0; 2], Vec::new());
        for IntervalPart { name, kind, low, high } in parts {
            match kind {
                _ if [LAW_BIAS, LAW_SCATTER].contains(&name.as_str()) => {
                    law = [law[0] * (1.0 + low), law[1] * (1.0 + high)];
                }
                PartKind::NotIncluded => sources.push(format!("without {name}")),
                // the name holds the range of the hardness
                PartKind::Width if name.starts_with(HARDNESS) => sources.push(name.clone()),
                _ => sources.push(format!("{name} {}", percent_range([*low, *high]))),
            }
        }
        sources.push(format!("law {}", percent_range(law.map(|factor| factor - 1.0))));
        let range = if *high < SMALL { format!("below {SMALL}") } else { format!("{low:.digits$} to {high:.digits$}") };
        format!("{range}: {}", sources.join(", "))
    }
}

/// Two relative errors in per cent with their signs, to a tenth of a per cent below 10 %.
fn percent_range(shares: [f64; 2]) -> String {
    let [low, high] = shares.map(|share| match 100.0 * share {
        percent if percent.abs() < 0.05 => "0".to_owned(),
        percent if percent.abs() < 9.95 => format!("{percent:+.1}"),
        percent => format!("{percent:+.0}"),
    });
    if low == high { format!("{low} %") } else { format!("{low} to {high} %") }
}

#[cfg(test)]
mod tests {
    use super::{IntervalPart, LAW_BIAS, LAW_SCATTER, PartKind, RestitutionInterval};

    /// However narrow an interval is, its ends differ where they are shown.
    #[test]
    fn ends_of_an_interval_differ_in_their_digits() {
        for (low, high, want) in [
            (0.471, 0.509, "0.47 to 0.51"),
            (0.62, 0.632, "0.62 to 0.63"),
            (0.0251, 0.0312, "0.025 to 0.031"),
            (0.0407, 0.0415, "0.0407 to 0.0415"),
            (4.07e-4, 4.15e-4, "below 0.02"),
        ] {
            let part = |name: &str, kind, low, high| IntervalPart { name: name.to_owned(), kind, low, high };
            let parts = vec![
                part("strain rate", PartKind::Shift, 0.0, 0.1),
                part("wear", PartKind::NotIncluded, 0.0, 0.0),
                part(LAW_BIAS, PartKind::Shift, 0.01, 0.01),
                part(LAW_SCATTER, PartKind::Width, -0.02, 0.0),
            ];
            let text = RestitutionInterval { low, high, parts }.to_text();
            assert_eq!(text, format!("{want}: strain rate 0 to +10 %, without wear, law -1.0 to +1.0 %"));
        }
    }
}
