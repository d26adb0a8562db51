//! Axes, linear or logarithmic: range, ticks and labels.

use crate::numerics::functions::{exp, ln, log10};
use crate::units::Dimension;
use crate::units::prefix::{Prefix, power_of_ten, power_of_ten_text};

/// Values larger than this are not drawn; on a logarithmic axis, nor are values smaller than its inverse. So the ends
/// and the length of an axis do not overflow.
const MAX_DRAWN: f64 = 1e200;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisScale {
    /// Equal steps have equal lengths.
    Linear,
    /// Equal ratios have equal lengths; values ≤ 0 are not drawn.
    Log,
    /// Whole numbers, each with a label, such as the positions of columns.
    Count,
}

impl AxisScale {
    /// A value on the scale on which equal steps have equal lengths.
    pub(in crate::report) fn transform(self, value: f64) -> f64 {
        if self == Self::Log { ln(value) } else { value }
    }

    /// The inverse of [`Self::transform`].
    pub(in crate::report) fn inverse(self, scaled: f64) -> f64 {
        if self == Self::Log { exp(scaled) } else { scaled }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The title without the unit, such as "Impact speed".
    pub title: String,
    /// The unit, such as "m/s"; empty for a plain number.
    pub unit: String,
    pub scale: AxisScale,
    /// Lower and upper end, in the unit of the values; `None` to fit them to the data.
    pub range: Option<(f64, f64)>,
    /// The value whose prefix the unit has; `None` for the prefix that fits the range.
    pub prefix_of: Option<f64>,
}

impl Axis {
    /// A linear axis of values in a unit. Labels in an SI unit have a fitting prefix, such as µm for small lengths.
    pub fn linear(title: &str, unit: &str) -> Self {
        Self { title: title.into(), unit: unit.into(), scale: AxisScale::Linear, range: None, prefix_of: None }
    }

    /// An axis of the positions 1 to `count`.
    #[allow(clippy::cast_precision_loss)] // a handful
    pub fn ordinal(title: &str, count: usize) -> Self {
        Self { scale: AxisScale::Count, ..Self::linear(title, "").with_range(0.0, count as f64 + 1.0) }
    }

    pub fn log(title: &str, unit: &str) -> Self {
        Self::linear(title, unit).logarithmic()
    }

    /// Returns the axis with a logarithmic scale.
    pub fn logarithmic(self) -> Self {
        Self { scale: AxisScale::Log, ..self }
    }

    /// Returns the axis from `low` to `high`.
    pub fn with_range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Returns the axis with the prefix of this value, such as that of another axis of the same unit.
    pub fn with_prefix_of(self, value: f64) -> Self {
        Self { prefix_of: Some(value), ..self }
    }

    /// The axis with range and prefix fitted to these values.
    pub(in crate::report) fn fit(&self, values: impl IntoIterator<Item = f64>) -> FittedAxis {
        let is_log = self.scale == AxisScale::Log;
        let drawable = |v: &f64| v.abs() < MAX_DRAWN && (!is_log || *v > 1.0 / MAX_DRAWN);
        let is_range = |(low, high): &(f64, f64)| drawable(low) && drawable(high) && !is_degenerate(*low, *high);
        let (low, high) = self.range.filter(is_range).unwrap_or_else(|| {
            let (low, high) = min_max(values.into_iter().filter(drawable));
            padded_range(low, high, is_log)
        });
        let prefix = match self.scale {
            _ if !Dimension::is_prefixed(&self.unit) => Prefix::for_value(1.0),
            _ if self.prefix_of.is_some() => Prefix::for_value(self.prefix_of.unwrap_or(1.0)),
            AxisScale::Linear | AxisScale::Count => Prefix::for_value(low.abs().max(high.abs())),
            // a range around 1 needs no prefix: speeds from 0.01 to 10 m/s stay in m/s
            AxisScale::Log if low <= 1.0 && high >= 1.0 => Prefix::for_value(1.0),
            AxisScale::Log => Prefix::for_value(low.sqrt() * high.sqrt()),
        };
        let unit = format!("{}{}", prefix.symbol, self.unit);
        let title = match unit.trim() {
            "" => self.title.clone(),
            unit => format!("{} [{unit}]", self.title),
        };
        FittedAxis {
            title,
            scale: self.scale,
            low: low / prefix.factor,
            high: high / prefix.factor,
            factor: prefix.factor,
        }
    }
}

/// The smallest and the largest of these values; infinite if there are none.
pub fn min_max(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

/// True if a range is empty or too short to differ from one value.
fn is_degenerate(low: f64, high: f64) -> bool {
    high - low <= 1e-9 * high.abs().max(low.abs())
}

/// The range of an axis: a little more than the range of the data, and with zero if the data are near to it.
fn padded_range(low: f64, high: f64, is_log: bool) -> (f64, f64) {
    if low > high {
        return if is_log { (0.1, 10.0) } else { (0.0, 1.0) };
    }
    if is_log {
        let room = if is_degenerate(low, high) { 3.0 } else { exp(0.04 * (ln(high) - ln(low))) };
        return (low / room, high * room);
    }
    let room = match high - low {
        _ if low == 0.0 && high == 0.0 => 1.0,
        _ if is_degenerate(low, high) => 0.1 * high.abs(),
        length => 0.06 * length,
    };
    if low >= 0.0 && low < 0.5 * high { (0.0, high + room) } else { (low - room, high + room) }
}

/// A tick; a major tick has a label.
pub(in crate::report) struct Tick {
    /// Place along the axis, 0 … 1.
    pub at: f64,
    pub label: Option<String>,
}

/// An axis with a fixed range.
#[derive(Clone)]
pub(in crate::report) struct FittedAxis {
    pub title: String,
    scale: AxisScale,
    low: f64,
    high: f64,
    factor: f64,
}

impl FittedAxis {
    /// The place of a value along the axis; 0 … 1 within its range.
    pub(in crate::report) fn position(&self, value: f64) -> f64 {
        self.fraction(value / self.factor)
    }

    /// The value at a place along the axis: the inverse of [`FittedAxis::position`].
    pub(in crate::report) fn value_at(&self, share: f64) -> f64 {
        let (low, high) = (self.scale.transform(self.low), self.scale.transform(self.high));
        self.factor * self.scale.inverse(low + share * (high - low))
    }

    pub(in crate::report) fn is_logarithmic(&self) -> bool {
        self.scale == AxisScale::Log
    }

    fn fraction(&self, value: f64) -> f64 {
        let (low, high) = (self.scale.transform(self.low), self.scale.transform(self.high));
        (self.scale.transform(value) - low) / (high - low)
    }

    /// Ticks from low to high on an axis of this length \[px\], with labels about `distance` apart, at least four if
    /// they have room. `extent` is the length that a label takes along the axis: labels do not overlap.
    ///
    /// The labels of a logarithmic axis are whole digits times powers of ten, and powers of ten come first. Only an axis
    /// whose ends differ by less than [`SHORT`] has the even steps of a linear axis.
    pub(in crate::report) fn ticks(&self, length: f64, distance: f64, extent: impl Fn(&str) -> f64) -> Vec<Tick> {
        if self.scale == AxisScale::Count {
            return self.visible_ticks(integer_ticks(self.low, self.high));
        }
        let wanted = (length / distance).max(MIN_LABELS);
        let (mut best, mut most) = (Vec::new(), 0.0);
        for values in self.candidates(wanted) {
            let ticks = self.visible_ticks(values);
            let labels: Vec<(f64, f64)> =
                ticks.iter().filter_map(|tick| Some((length * tick.at, extent(tick.label.as_deref()?)))).collect();
            let overlap = labels.windows(2).any(|pair| pair[1].0 - pair[0].0 < 0.5 * (pair[0].1 + pair[1].1));
            let count = labels.len() as f64;
            if count > most && (!overlap || count < 2.0) {
                (best, most) = (ticks, count);
            }
            if most >= MIN_LABELS {
                break;
            }
        }
        best
    }

    /// Sets of ticks, the preferred one first.
    fn candidates(&self, wanted: f64) -> impl Iterator<Item = Vec<(f64, Option<String>)>> {
        let (low, high) = (self.low, self.high);
        let is_short = self.scale != AxisScale::Log || high / low < SHORT;
        let every = if is_short { 0 } else { decades_between_labels(low, high, wanted) };
        // labels closer together, up to one in every decade, and then more labels in each decade
        let of_decades = (1..=every).rev().map(move |every| log_ticks(low, high, every, &[1]));
        let digits = LOG_LABEL_DIGITS.into_iter().filter(move |_| !is_short);
        let of_digits = digits.map(move |digits| log_ticks(low, high, 1, digits));
        let shares = LINEAR_COUNTS.into_iter().filter(move |_| is_short);
        let of_linear = shares.map(move |share| linear_ticks(low, high, share * wanted));
        of_decades.chain(of_digits).chain(of_linear)
    }

    /// The ticks that lie on the axis.
    fn visible_ticks(&self, values: Vec<(f64, Option<String>)>) -> Vec<Tick> {
        let tick = |(value, label): (f64, Option<String>)| {
            let at = self.fraction(value);
            // a tick at the end of the axis must not be lost by rounding
            (-1e-9..=1.0 + 1e-9).contains(&at).then(|| Tick { at: at.clamp(0.0, 1.0), label })
        };
        values.into_iter().filter_map(tick).collect()
    }
}

/// Smallest number of labels of an axis.
const MIN_LABELS: f64 = 4.0;
/// Digits that have a label on a logarithmic axis of few decades, from long axes to short ones. The last two are for long labels
/// on less than a decade.
const LOG_LABEL_DIGITS: [&[i32]; 7] =
    [&[1, 3], &[1, 2, 5], &[1, 2, 3, 5], &[1, 2, 4, 6, 8], &[1, 2, 3, 4, 5, 6, 7, 8, 9], &[1, 3, 6], &[1, 4, 7]];
/// A logarithmic axis looks like a linear one if its upper end is less than this multiple of its lower end.
const SHORT: f64 = 3.0;
/// Numbers of steps of a linear axis over the wanted number of labels, in the order in which they are tried. Long labels
/// have room for fewer steps.
const LINEAR_COUNTS: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 0.6, 0.3];

/// Decades from label to label, so that about this number of labels is on the axis.
#[allow(clippy::cast_possible_truncation)] // a few hundred decades
fn decades_between_labels(low: f64, high: f64, wanted: f64) -> i32 {
    ((log10(high) - log10(low)) / wanted).ceil().max(1.0) as i32
}

/// A tick for every whole number between these, and for both ends if there are fewer than three: two labels are no scale.
#[allow(clippy::cast_possible_truncation)] // a handful
fn integer_ticks(low: f64, high: f64) -> Vec<(f64, Option<String>)> {
    let inside = low.floor() as i32 + 1..high.ceil() as i32;
    let places = if inside.len() < 3 { inside.start - 1..inside.end + 1 } else { inside };
    places.map(|place| (f64::from(place), Some(place.to_string()))).collect()
}

#[allow(clippy::cast_possible_truncation)] // exponents and counts of ticks
fn linear_ticks(low: f64, high: f64, wanted: f64) -> Vec<(f64, Option<String>)> {
    let raw = (high - low) / wanted;
    let exponent = log10(raw).floor() as i32;
    let (digit, exponent): (i32, i32) = match raw / power_of_ten(exponent) {
        r if r <= 1.0 => (1, exponent),
        r if r <= 2.0 => (2, exponent),
        r if r <= 5.0 => (5, exponent),
        _ => (1, exponent + 1),
    };
    let step = f64::from(digit) * power_of_ten(exponent);
    // a narrow range of numbers that are not small needs more decimals
    let largest = low.abs().max(high.abs());
    let is_plain = (-4..=5).contains(&exponent) && largest < 1e6 || (-9..-4).contains(&exponent) && largest > 0.1;
    let decimals = usize::try_from(-exponent).unwrap_or(0);
    ((low / step - 1e-6).ceil() as i64..=(high / step + 1e-6).floor() as i64)
        .map(|i| {
            // i × digit × 10^exponent as text is exact: no 0.7000000000000001
            let value: f64 = format!("{}e{exponent}", i * i64::from(digit)).parse().unwrap_or(f64::NAN);
            let label = if is_plain { format!("{value:.decimals$}") } else { format!("{value:e}") };
            (value, Some(label.replace('-', "−")))
        })
        .collect()
}

#[allow(clippy::cast_possible_truncation)] // exponents
fn log_ticks(low: f64, high: f64, every: i32, labelled: &[i32]) -> Vec<(f64, Option<String>)> {
    let (first, last) = (log10(low).floor() as i32, log10(high).ceil() as i32);
    let is_plain = low > 5e-4 && high < 5e4;
    let label = |digit: i32, exponent: i32| match digit {
        _ if is_plain => crate::units::format_four_digits(f64::from(digit) * power_of_ten(exponent)),
        1 => power_of_ten_text(exponent),
        _ => format!("{digit}·{}", power_of_ten_text(exponent)),
    };
    let digits = if every == 1 { 1..=9 } else { 1..=1 };
    (first..=last)
        .flat_map(|exponent| digits.clone().map(move |digit| (digit, exponent)))
        .map(|(digit, exponent)| {
            let has_label = labelled.contains(&digit) && exponent.rem_euclid(every) == 0;
            (f64::from(digit) * power_of_ten(exponent), has_label.then(|| label(digit, exponent)))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::pow;

    fn labels(axis: &Axis, values: [f64; 2]) -> Vec<String> {
        axis.fit(values).ticks(900.0, 150.0, |_| 100.0).into_iter().filter_map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_short_round_numbers() {
        let axis = Axis::linear("Force", "N");
        assert_eq!(labels(&axis, [0.0, 0.7]), ["0", "200", "400", "600"]); // mN
        assert_eq!(labels(&Axis::linear("e", ""), [0.0, 1.0]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&Axis::log("v", "m/s"), [0.01, 100.0]), ["0.01", "0.1", "1", "10", "100"]);
        assert_eq!(labels(&Axis::log("error", ""), [1e-12, 1e-2])[..2], ["10⁻¹²", "10⁻¹⁰"]);
    }

    /// Logarithmic axes of half a decade to 12 decades, in steps of a tenth of a decade, with the lengths of the boxes of
    /// wide and of narrow pictures. Labels are digits times powers of ten. Up to 4 decades each power of ten has a label.
    /// There are at least three labels, or two on less than a decade or on a narrow map, and no two overlap.
    #[test]
    fn a_log_axis_has_powers_of_ten() {
        use super::super::frame::LABEL_GAP;
        use super::super::style::LABEL_SIZE;
        use super::super::text::text_width;
        // wide and narrow boxes, those of maps and of three boxes, and the distance of their labels
        let across = [(1395.0, 150.0), (1075.0, 150.0), (595.0, 150.0), (385.0, 150.0)];
        let upward = [(753.0, 90.0), (583.0, 90.0), (232.0, 90.0), (175.0, 90.0)];
        let is_upward = [false; 4].into_iter().chain([true; 4]);
        for ((length, distance), is_upward) in across.into_iter().chain(upward).zip(is_upward) {
            let extent = |label: &str| if is_upward { LABEL_SIZE } else { text_width(label, LABEL_SIZE) + LABEL_GAP };
            for (begin, tenths) in
                (-90_i32..30).step_by(7).flat_map(|begin| (5..=120).map(move |tenths| (begin, tenths)))
            {
                let low = pow(10.0, 0.1 * f64::from(begin));
                let high = low * pow(10.0, 0.1 * f64::from(tenths));
                let axis = Axis::log("x", "").with_range(low, high).fit([]);
                let ticks = axis.ticks(length, distance, extent);
                let labels: Vec<(f64, &str)> =
                    ticks.iter().filter_map(|tick| Some((tick.at, tick.label.as_deref()?))).collect();
                let context = format!("{low} to {high} on {length} px: {labels:?}");
                let least = if tenths < 10 || length == 385.0 { 2 } else { 3 };
                assert!(labels.len() >= least, "{context}");
                for pair in labels.windows(2) {
                    let room = 0.5 * (extent(pair[0].1) + extent(pair[1].1));
                    assert!(length * (pair[1].0 - pair[0].0) >= room, "{context}");
                }
                let digit = |at: f64| {
                    let logarithm = log10(axis.value_at(at));
                    pow(10.0, logarithm - (logarithm + 1e-9).floor())
                };
                let digits: &[i32] = match tenths {
                    ..=12 => &[1, 2, 3, 4, 5, 6, 7, 8, 9],
                    13..=40 => &[1, 2, 3, 5],
                    _ => &[1],
                };
                for (at, label) in &labels {
                    let is_allowed = digits.iter().any(|known| (digit(*at) - f64::from(*known)).abs() < 1e-6);
                    assert!(is_allowed, "{label} of {context}");
                }
                // the powers of ten from the lower end to the upper end: no more than the labels that are one
                let inside = (begin + tenths).div_euclid(10) - (begin - 1).div_euclid(10);
                let powers = labels.iter().filter(|(at, _)| (digit(*at) - 1.0).abs() < 1e-6).count();
                assert!(tenths > 40 || i32::try_from(powers) == Ok(inside), "{inside} powers of ten in {context}");
            }
        }
    }

    #[test]
    fn prefix_precedes_unit_without_prefix() {
        let title = |unit, value| Axis::linear("x", unit).fit([0.0, value]).title;
        assert_eq!(title("m", 1e-6), "x [µm]");
        // 0.4 is not 400 "m", and 7850 kg/m^3 are not 7.85 kkg/m^3
        assert_eq!(title("", 0.4), "x");
        assert_eq!(title("kg/m^3", 7850.0), "x [kg/m^3]");
    }

    #[test]
    fn a_narrow_range_of_ordinary_numbers_has_decimals() {
        assert_eq!(labels(&Axis::linear("e", ""), [0.546_53, 0.546_56])[..2], ["0.54653", "0.54654"]);
        assert_eq!(labels(&Axis::linear("drift", ""), [0.0, 3e-5])[1], "1e−5");
    }

    #[test]
    fn value_at_inverts_at() {
        for axis in [Axis::linear("x", "m"), Axis::log("x", "m")] {
            let axis = axis.fit([1.0, 50.0]);
            approx::assert_relative_eq!(axis.position(axis.value_at(0.3)), 0.3, max_relative = 1e-14);
        }
    }
}
