//! The force of an impact as a source: its samples over time, and its spectrum.

use std::f64::consts::PI;

use super::force_indentation::title;
use crate::impact::{Impact, Pulse};
use crate::numerics::functions::{pow, sin};
use crate::report::chart::{Axis, Chart, DASHED, GREY, Series, Style};
use crate::units::{Dimension, format_result};

/// The lowest drawn magnitude over the impulse.
const LEAST_SHARE: f64 = 1e-6;
/// How many times the first minimum, or the corner frequency without a minimum, the drawn frequencies reach.
const LAST_FREQUENCY: f64 = 30.0;

/// The picture of the samples, and sin^(3/2) of the same peak and contact time, which is near the pulse of an elastic impact.
pub fn pulse(impact: &Impact, pulse: &Pulse) -> Chart {
    let during = || pulse.samples().take_while(|(time, _)| *time <= pulse.contact_time + pulse.step);
    let share = |time: f64| sin(PI * (time / pulse.contact_time).min(1.0)).max(0.0);
    let approximate = during().map(|(time, _)| (time, pulse.peak_force * pow(share(time), 1.5))).collect();
    let series = vec![
        Series::line("Force F", during().collect())
            .with_style(Style::new(3).with_solid_line().with_width(3.5))
            .with_note(format!("impulse {}", format_result(pulse.impulse, Dimension::Impulse))),
        Series::line("sin^(3/2)", approximate)
            .with_style(Style::line(GREY, 2.5).with_dash(DASHED))
            .with_note("of the same peak and contact time"),
    ];
    let x = Axis::linear("Time", "s").with_range(0.0, 1.03 * pulse.contact_time);
    let y = Axis::linear("Force", "N").with_range(0.0, 1.1 * pulse.peak_force);
    Chart::new(title(impact), [x, y], series)
}

/// The picture of the spectrum, with the corner frequency and the first minimum.
pub fn spectrum(impact: &Impact, pulse: &Pulse) -> Chart {
    let corner = pulse.corner_frequency.unwrap_or(pulse.frequency_step);
    let last = LAST_FREQUENCY * pulse.first_minimum.unwrap_or(corner);
    // a logarithmic axis has no frequency 0
    let lines = pulse.lines().skip(1).take_while(|(frequency, _)| *frequency <= last).collect();
    let series = Series::line("Spectrum |F|", lines).with_style(Style::new(3).with_solid_line());
    let guide = |frequency: Option<f64>, name: &str| {
        frequency.map(|at| Series::vertical(at, name).with_note(format_result(at, Dimension::Frequency)))
    };
    let guides: Vec<Series> =
        [guide(pulse.corner_frequency, "Corner frequency"), guide(pulse.first_minimum, "First minimum")]
            .into_iter()
            .flatten()
            .collect();
    let x = Axis::log("Frequency", "Hz");
    let y = Axis::log("Magnitude", "N s")
        .with_range(LEAST_SHARE * pulse.impulse, 2.0 * pulse.impulse)
        .with_prefix_of(pulse.impulse);
    Chart::new(title(impact), [x, y], vec![series]).with_guides(guides)
}
