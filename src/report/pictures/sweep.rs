//! Pictures of a sweep: e, or other results, along an axis of numbers, in columns by words, and as a map over two long axes;
//! or a histogram of e, and of other columns, of random cases.

use crate::report::chart;

use super::process_window::{process_window, window_axes};
use super::{caption, key_axis, law_title, path_title, path_words, with_captions};
use crate::contact::law::YieldingPair;
use crate::impact::{ImpactRow, Peening};
use crate::reference::quasi_static;
use crate::report::chart::{Chart, Series, SeriesKind, heatmap, histogram};
use crate::report::chart::{Style, min_max};
use crate::results::{RESTITUTION, ResultColumn, dimension_of, result_columns};
use crate::scenario::plan::{AxisSetting, AxisWord, Cases, Plan, SweepAxis};
use crate::strings::capitalise;
use crate::table::statistics::RunningStatistics;
use crate::table::{Evaluator, RowFailure, Rows, Tally};
use crate::units::format_result;

/// Largest number of points of a curve: more than the pixels of a picture.
const MAX_POINTS: u64 = 2000;
/// A curve with up to this number of points has a marker on each.
const MAX_MARKED_POINTS: usize = 12;
/// Largest number of curves in one picture that a reader can distinguish.
const MAX_CURVES: u64 = 8;
/// A step from curve to curve is chosen so that the last value has a curve, if at least this number of curves remains.
const FEWEST_CURVES: u64 = 5;
/// Pictures with more curves than this have markers on each.
const PLAIN_CURVES: usize = 6;
/// Results over a logarithmic axis are on a logarithmic axis if the largest is more than this multiple of the smallest.
const WIDE: f64 = 30.0;
/// Largest number of curves if the second axis has words: as many names as the key has room for.
const MAX_WORD_CURVES: u64 = 13;
/// Largest number of cells on a side of a map.
const MAX_CELLS: u64 = 200;
/// Largest number of values of an axis between which contour lines are interpolated.
const MAX_CONTOUR_VALUES: u64 = 60;
/// A map is drawn if both axes have at least this number of values.
const MIN_MAP_AXIS: u64 = 8;
const HISTOGRAM_BARS: usize = 60;

/// The pictures of a plan with their names.
pub fn pictures(plan: &Plan, tally: &Tally) -> Vec<(String, Chart)> {
    with_captions(charts(plan, tally), &caption(&plan.input, &plan.varied_paths()))
}

fn charts(plan: &Plan, tally: &Tally) -> Vec<(String, Chart)> {
    let Cases::Grid(axes) = &plan.cases else {
        let is_drawn = |name| plan.pictures.as_ref().is_none_or(|names| names.contains(&name));
        let drawn = tally.statistics.iter().filter(|(column, _)| is_drawn(column.name));
        let drawn = drawn.filter_map(|(column, all)| {
            Some((format!("{}_histogram", column.name), restitution_histogram(column, all)?))
        });
        return drawn.collect();
    };
    let is_drawable = |axis: &SweepAxis| matches!(axis.setting, AxisSetting::Number { .. }) && axis.len() > 1;
    // the axis along which curves run: the first, unless only the second has numbers
    let along = (0..axes.len().min(2)).find(|at| is_drawable(&axes[*at]));
    let has_map = axes.len() > 1 && axes[..2].iter().all(|axis| is_drawable(axis) && axis.len() >= MIN_MAP_AXIS);
    let evaluator = &Evaluator::new(plan);
    let is_drawn = |name| plan.pictures.as_deref().unwrap_or(&[RESTITUTION]).contains(&name);
    let drawn = result_columns().into_iter().filter(|column| is_drawn(column.name)).flat_map(|result| {
        let picture = ResultChart { plan, evaluator, axes, along, result };
        let lines = if along.is_some() { picture.curve_chart() } else { picture.column_chart() };
        let map = has_map.then(|| (format!("{}_map", result.name), picture.heat_map()));
        [(result.name.to_owned(), lines)].into_iter().chain(map)
    });
    let window = plan.input.peening().zip(window_axes(plan));
    drawn.chain(window.map(|(request, places)| window_picture(evaluator, axes, &request, places))).collect()
}

/// The process window of shot peening, whose axes of speed and size have these places.
fn window_picture(
    evaluator: &Evaluator,
    axes: &[SweepAxis],
    request: &Peening,
    [speed, size]: [usize; 2],
) -> (String, Chart) {
    let places = [speed, size].map(|at| spaced_indices(&axes[at], MAX_CONTOUR_VALUES));
    let position = |at: usize, places: &[u64]| -> Vec<f64> {
        places.iter().map(|place| axis_position(&axes[at], *place)).collect()
    };
    let values = [position(speed, &places[0]), position(size, &places[1])];
    let surface = |column: usize, row: usize| {
        let mut of_case = [0; 2];
        (of_case[speed], of_case[size]) = (places[0][column], places[1][row]);
        compute_row(evaluator, axes, &of_case).and_then(Result::ok)?.peened
    };
    let drawn = process_window([&axes[speed], &axes[size]], values.each_ref().map(Vec::as_slice), request, surface);
    ("process_window".to_owned(), drawn.with_notes(fixed_axis_notes(axes)))
}

/// At most `most` of the places of an axis, at even steps, including both ends.
fn spaced_indices(axis: &SweepAxis, most: u64) -> Vec<u64> {
    let (last, count) = (axis.len() - 1, axis.len().min(most));
    #[allow(clippy::cast_possible_truncation)] // at most `last`
    (0..count).map(|i| (u128::from(i) * u128::from(last) / u128::from(count.max(2) - 1)) as u64).collect()
}

fn compute_row(evaluator: &Evaluator, axes: &[SweepAxis], places: &[u64]) -> Option<Result<ImpactRow, RowFailure>> {
    let case = axes
        .iter()
        .zip(places.iter().copied().chain(std::iter::repeat(0)))
        .fold(0, |case, (axis, place)| case * axis.len() + place);
    let mut rows = Rows::default();
    evaluator.append_rows(case..case + 1, &mut rows);
    rows.results.pop()
}

/// The name of an axis in words, such as "half-space yield strength".
pub(super) fn axis_words(axis: &SweepAxis) -> String {
    path_words(axis.path())
}

fn plot_axis(axis: &SweepAxis) -> chart::Axis {
    match &axis.setting {
        AxisSetting::Number { key, .. } => key_axis(*key, axis.is_logarithmic),
        AxisSetting::Words { path, .. } => chart::Axis::linear(&path_title(path), ""),
    }
}

/// The values at these places of an axis, with at most four digits and in one unit, as the key has them.
fn labels(axis: &SweepAxis, places: &[u64]) -> Vec<String> {
    match &axis.setting {
        AxisSetting::Number { key, .. } => {
            key.quantity().picture_labels(&places.iter().map(|place| axis.value_at(*place)).collect::<Vec<_>>())
        }
        AxisSetting::Words { .. } => {
            let name = |place: &u64| match axis.word_values().get(usize::try_from(*place).unwrap_or(0)) {
                Some(AxisWord::Law(law)) => law_title(&law.name()),
                _ => axis.label(*place),
            };
            places.iter().map(name).collect()
        }
    }
}

/// The value at a place of an axis, with at most four digits.
pub(super) fn value_label(axis: &SweepAxis, place: u64) -> String {
    labels(axis, &[place]).concat()
}

/// The value at a place of an axis, in the unit of the picture.
fn axis_position(axis: &SweepAxis, place: u64) -> f64 {
    match &axis.setting {
        AxisSetting::Number { key, .. } => key.quantity().picture_unit().1(axis.value_at(place)),
        AxisSetting::Words { .. } => axis.value_at(place),
    }
}

/// The places of the curves of an axis: all of them, or at most `most` at even steps, from the first to the last where a
/// step fits.
fn curve_places(axis: &SweepAxis, most: u64) -> Vec<u64> {
    let last = axis.len() - 1;
    if last < most || !axis.word_values().is_empty() {
        return spaced_indices(axis, most);
    }
    let least = last.div_ceil(most - 1);
    let fitting = (least..=last / (FEWEST_CURVES - 1)).find(|step| last.is_multiple_of(*step));
    let step = fitting.unwrap_or(least);
    (0..=last / step).map(|i| i * step).collect()
}

/// A note that not all values of an axis have a curve or a column.
fn note_of_others(axis: &SweepAxis, shown: usize) -> Option<String> {
    let is_some = (shown as u64) < axis.len();
    is_some.then(|| format!("{shown} of {} values are shown", axis.len()))
}

/// A curve, with a marker on each of few points.
fn marked_curve(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
    let look = if points.len() <= MAX_MARKED_POINTS { SeriesKind::MarkedLine } else { SeriesKind::Line };
    Series { kind: look, ..Series::line(name, points) }
}

/// A picture of one result over one or two axes of a grid.
struct ResultChart<'a> {
    plan: &'a Plan,
    evaluator: &'a Evaluator<'a>,
    axes: &'a [SweepAxis],
    /// The place of the axis along which curves run: 0 or 1.
    along: Option<usize>,
    result: ResultColumn,
}

impl ResultChart<'_> {
    /// The result of the case at these places of the first axes; not a number if the case has none.
    fn value(&self, places: &[u64]) -> f64 {
        let row = compute_row(self.evaluator, self.axes, places).and_then(Result::ok);
        row.as_ref().and_then(self.result.value).unwrap_or(f64::NAN)
    }

    fn is_restitution(&self) -> bool {
        self.result.name == RESTITUTION
    }

    fn axis(&self) -> (String, chart::Axis) {
        result_axis(self.result.name)
    }

    /// Curves along one axis, one for each value of the other.
    fn curve_chart(&self) -> Chart {
        let (axes, along) = (self.axes, self.along.unwrap_or(0));
        let first = &axes[along];
        let other = if along == 0 { axes.get(1) } else { axes.first() };
        let at = spaced_indices(first, MAX_POINTS);
        let most = |axis: &SweepAxis| if axis.word_values().is_empty() { MAX_CURVES } else { MAX_WORD_CURVES };
        let curves = other.map_or_else(|| vec![0], |other| curve_places(other, most(other)));
        let names = other.map_or_else(|| vec![String::new()], |other| labels(other, &curves));
        let is_by_law = other.is_some_and(|other| matches!(other.word_values(), [AxisWord::Law(_), ..]));
        let is_by_speed = first.path() == "impact.speed";
        let mut series = Vec::new();
        for (number, curve) in curves.iter().enumerate() {
            let places = |place: u64| if along == 0 { [place, *curve] } else { [*curve, place] };
            let points = at.iter().map(|place| (axis_position(first, *place), self.value(&places(*place)))).collect();
            let mut drawn = marked_curve(names[number].clone(), points);
            if curves.len() > PLAIN_CURVES && drawn.kind == SeriesKind::Line {
                drawn.kind = SeriesKind::LabelledLine;
            }
            // the law of this program is the widest line among laws
            let is_first = is_by_law && number == 0;
            series.push(if is_first { drawn.with_style(Style::new(number).with_width(7.0)) } else { drawn });
        }
        let shown = if is_by_law { &curves[..1] } else { &curves[..] };
        let guides = if is_by_speed { self.yield_guides(other, shown) } else { Vec::new() };
        if is_by_speed && is_by_law && self.is_restitution() {
            series.extend(finite_element_points(self.plan, &series));
        }
        let (name, y) = self.axis();
        let y = if first.is_logarithmic && !self.is_restitution() && is_wide(&series) {
            y.logarithmic()
        } else {
            self.with_data_range(y, &series)
        };
        let title = match other {
            Some(other) => format!("{name} by {}", axis_words(other)),
            None => format!("{name} against {}", axis_words(first)),
        };
        Chart::new(title, [plot_axis(first), y], series)
            .with_guides(guides)
            .with_notes(other.and_then(|other| note_of_others(other, curves.len())))
            .with_notes(fixed_axis_notes(axes))
    }

    /// The yield speeds of these curves: one guide in grey where all are the same, else one in the colour of each curve. All laws
    /// yield at about the same speed, so one is enough for them.
    fn yield_guides(&self, other: Option<&SweepAxis>, curves: &[u64]) -> Vec<Series> {
        let speeds = curves
            .iter()
            .enumerate()
            .filter_map(|(number, curve)| yield_speed(self.plan, other, *curve).map(|speed| (number, speed)));
        let speeds: Vec<(usize, f64)> = speeds.collect();
        let guide = |speed: f64| Series::vertical(speed, "yield speed");
        if let [(_, first), ..] = speeds[..]
            && speeds.iter().all(|(_, speed)| (speed / first - 1.0).abs() < 1e-9)
        {
            return vec![guide(first)];
        }
        speeds.into_iter().map(|(number, speed)| guide(speed).with_color(number)).collect()
    }

    /// A column for each word of the first axis, such as a law or a material, with its value in the key. A word without
    /// a value has an empty place.
    fn column_chart(&self) -> Chart {
        let (name, y) = self.axis();
        let places = curve_places(&self.axes[0], MAX_WORD_CURVES);
        let names = labels(&self.axes[0], &places);
        let column = |(number, place): (usize, &u64)| {
            let value = self.value(&[*place]);
            let name = format!("{} {}", number + 1, names[number]);
            let sides = [number as f64 + 0.6, number as f64 + 1.4];
            let text = if value.is_finite() {
                format_result(value, dimension_of(self.result.name))
            } else {
                "none".to_owned()
            };
            Series::column(name, sides, value).with_note(text).with_style(number)
        };
        let series: Vec<Series> = places.iter().enumerate().map(column).collect();
        let x = chart::Axis::ordinal(&capitalise(&axis_words(&self.axes[0])), series.len());
        let y = self.with_data_range(y.clone(), &series);
        Chart::new(format!("{name} by {}", axis_words(&self.axes[0])), [x, y], series)
            .with_notes(note_of_others(&self.axes[0], places.len()))
            .with_notes(fixed_axis_notes(self.axes))
    }

    /// Colours over the first two axes.
    fn heat_map(&self) -> Chart {
        let axes = self.axes;
        let (columns, rows) = (spaced_indices(&axes[0], MAX_CELLS), spaced_indices(&axes[1], MAX_CELLS));
        let (name, color) = self.axis();
        let title = std::iter::once(name).chain(fixed_axis_notes(axes)).collect::<Vec<_>>().join(", ");
        let on = |axis: &SweepAxis, places: &[u64]| -> Vec<f64> {
            places.iter().map(|place| axis_position(axis, *place)).collect()
        };
        let places = [on(&axes[0], &columns), on(&axes[1], &rows)];
        let value = |column: usize, row: usize| self.value(&[columns[column], rows[row]]);
        heatmap(&title, [plot_axis(&axes[0]), plot_axis(&axes[1])], [&places[0], &places[1]], value, color)
    }

    /// The axis with the range of the data, so that guides do not extend it.
    fn with_data_range(&self, axis: chart::Axis, series: &[Series]) -> chart::Axis {
        let values = series.iter().flat_map(|series| &series.points).map(|(_, value)| *value);
        let (low, high) = min_max(values.filter(|value| value.is_finite()));
        let high = if self.is_restitution() { high.max(1.0) } else { high };
        if low < high && low >= 0.0 { axis.with_range(0.0, 1.05 * high) } else { axis }
    }
}

/// True if all values of curves are positive, and the largest is far above the smallest.
fn is_wide(curves: &[Series]) -> bool {
    let values = curves.iter().flat_map(|curve| &curve.points).map(|(_, value)| *value);
    let (low, high) = min_max(values.filter(|value| value.is_finite()));
    low > 0.0 && high > WIDE * low
}

/// e of the finite-element unloadings for the materials of this scene, within the speeds of the curves. The speed of a
/// point is the impact speed with the same energy as the loading.
fn finite_element_points(plan: &Plan, curves: &[Series]) -> Option<Series> {
    let contact = plan.input.contact().ok()?;
    let bodies = YieldingPair::new(contact.pair())?;
    let energy = bodies.yield_point.force * bodies.yield_point.indentation;
    let (low, high) = min_max(curves.iter().flat_map(|curve| &curve.points).map(|(speed, _)| *speed));
    let points: Vec<_> = quasi_static::unloadings(contact.sphere().material.youngs_modulus, &bodies)
        .into_iter()
        .map(|row| ((2.0 * row.number("spent") * energy / contact.reduced_mass()).sqrt(), row.number("restitution")))
        .filter(|(speed, _)| (low..=high).contains(speed))
        .collect();
    (!points.is_empty()).then(|| Series::points("finite elements, quasi-static", points).with_style(Style::BLACK))
}

/// Notes on the axes after the second one, which stay at their first value.
fn fixed_axis_notes(axes: &[SweepAxis]) -> Vec<String> {
    axes.iter().skip(2).map(|axis| format!("{} = {}", axis_words(axis), value_label(axis, 0))).collect()
}

/// The yield speed v_Y at a place of an axis; `None` where the strength depends on the speed.
fn yield_speed(plan: &Plan, axis: Option<&SweepAxis>, place: u64) -> Option<f64> {
    let mut input = plan.input.clone();
    if let Some(axis) = axis {
        axis.apply(place, &mut input);
    }
    input.contact().ok().filter(|contact| !contact.has_rate())?.yield_speed()
}

/// The name of a result, and its axis.
fn result_axis(name: &str) -> (String, chart::Axis) {
    if name == RESTITUTION {
        return ("Restitution".to_owned(), chart::Axis::linear("Restitution e", ""));
    }
    if let Some(angle) = name.strip_suffix("_deg") {
        let title = path_title(angle);
        return (title.clone(), chart::Axis::linear(&title, "°"));
    }
    let dimension = dimension_of(name);
    let title = path_title(name.trim_end_matches(dimension.suffix()));
    let axis = chart::Axis::linear(&title, dimension.si_unit());
    (title, axis)
}

/// The histogram of a column of random cases; `None` where all values are equal.
fn restitution_histogram(column: &ResultColumn, statistics: &RunningStatistics) -> Option<Chart> {
    let (low, high, counts) = statistics.histogram(HISTOGRAM_BARS)?;
    let all = statistics.distribution()?;
    let dimension = dimension_of(column.name);
    let text = |value: f64| {
        if column.name == RESTITUTION { format!("{value:.4}") } else { format_result(value, dimension) }
    };
    let lines = [("mean", all.mean), ("5 %", all.quantile_05), ("50 %", all.quantile_50), ("95 %", all.quantile_95)];
    let lines = lines.into_iter().map(|(name, value)| (value, format!("{name}: {}", text(value))));
    let (title, x) = result_axis(column.name);
    let notes = [format!("standard deviation: {}", text(all.standard_deviation)), format!("samples: {}", all.samples)];
    Some(histogram(&format!("{title} of random cases"), x, (low, high), &counts, lines).with_notes(notes))
}
