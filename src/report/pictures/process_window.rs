//! The process window of shot peening: contour lines of dent diameter and of the mass of shot for the coverage, over speed and size.

use std::f64::consts::PI;

use super::contour::{contour, round_levels};
use super::key_axis;
use crate::impact::{PeenedSurface, Peening};
use crate::report::chart::{Axis, Chart, Series, Style, min_max};
use crate::scenario::plan::{AxisSetting, Plan, SweepAxis};
use crate::units::{Dimension, format_result};

/// Contour lines of one quantity.
const MAX_LEVELS: usize = 6;

/// A quantity of the window: its value, the name of a line at a level, and whether its lines are solid (0) or dashed (1).
type WindowQuantity = (fn(&PeenedSurface) -> f64, fn(f64, &Peening) -> String, usize);

const QUANTITIES: [WindowQuantity; 2] = [
    // the impacts for the coverage follow from the dent alone, so that both have the same lines
    (|peened| 2.0 * (peened.dent_area / PI).sqrt(), dent_text, 0),
    (|peened| peened.mass_per_area().unwrap_or(f64::NAN), |level, _| format_result(level, Dimension::ArealMass), 1),
];

/// A dent diameter with the impacts for the coverage.
fn dent_text(diameter: f64, request: &Peening) -> String {
    let surface = PeenedSurface { request: *request, dent_area: PI * diameter * diameter / 4.0, shot_mass: f64::NAN };
    let impacts = surface.impacts_per_area().unwrap_or(f64::NAN);
    format!("{}, {}", format_result(diameter, Dimension::Length), format_result(impacts, Dimension::ArealNumber))
}

/// The places of the axes of speed and of size, if a plan of shot peening has these two axes of numbers first.
pub fn window_axes(plan: &Plan) -> Option<[usize; 2]> {
    plan.input.peening()?;
    let axes = plan.axes().get(..2)?;
    let place = |paths: &[&str]| {
        axes.iter().position(|axis| {
            paths.contains(&axis.path()) && axis.len() > 2 && matches!(axis.setting, AxisSetting::Number { .. })
        })
    };
    Some([place(&["impact.speed"])?, place(&["sphere.diameter", "sphere.radius"])?])
}

/// The picture; `surface` gives dent and shot of the case at a speed and a size, by their places among `speeds` and `sizes`.
pub fn process_window(
    axes: [&SweepAxis; 2],
    [speeds, sizes]: [&[f64]; 2],
    request: &Peening,
    surface: impl Fn(usize, usize) -> Option<PeenedSurface>,
) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for (value, text, branch) in QUANTITIES {
        let values: Vec<Vec<f64>> = (0..sizes.len())
            .map(|row| {
                let value = |column| surface(column, row).as_ref().map_or(f64::NAN, value);
                (0..speeds.len()).map(value).collect()
            })
            .collect();
        let (low, high) = min_max(values.iter().flatten().copied().filter(|value| *value > 0.0));
        for (number, level) in round_levels(low, high, MAX_LEVELS).into_iter().enumerate() {
            let lines = contour([speeds, sizes], |column, row| values[row][column], level);
            let style = Style::new(number).with_line_of_branch(branch);
            series.push(Series::line(text(level, request), lines).with_style(style));
        }
    }
    let axis = |axis: &SweepAxis, values: &[f64]| {
        let (low, high) = min_max(values.iter().copied());
        let drawn = match axis.setting {
            AxisSetting::Number { key, .. } => key_axis(key, axis.is_logarithmic),
            AxisSetting::Words { .. } => Axis::linear("", ""),
        };
        drawn.with_range(low, high)
    };
    let title = "Process window: dent diameter with impacts for the coverage (solid), mass of shot (dashed)";
    Chart::new(title.to_owned(), [axis(axes[0], speeds), axis(axes[1], sizes)], series)
}
