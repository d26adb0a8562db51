//! Force, indentation and speed against time, in three boxes one above the other.

use super::force_indentation::{force_at_peak, is_damped, peak_name, title};
use super::loops;
use crate::error::Error;
use crate::impact::{Impact, TraceRow};
use crate::report::chart::{Axis, Chart, DASHED, FOREGROUND, GREY, Panel, Series, Style, min_max};
use crate::units::{Dimension, format_result};

/// The history of an impact. A trace of some hundred samples gives smooth curves.
pub fn history(impact: &Impact) -> Result<Chart, Error> {
    if impact.trace.is_empty() {
        return Err(Error::failed("a history needs a trace: run the impact with samples"));
    }
    let points = |quantity: fn(&TraceRow) -> f64| impact.trace.iter().map(|row| (row.time, quantity(row))).collect();
    let thin = |number| loops::loop_style(number, 3.5);
    let mut force = Series::line("Force F", points(|row| row.force)).with_style(thin(3));
    if !is_damped(impact) {
        force = force.with_note(force_at_peak(impact));
    }
    let mut drawn: Vec<Series> = loops::INDENTATIONS
        .iter()
        .enumerate()
        .map(|(i, (name, width))| {
            let points = impact.trace.iter().map(|row| (row.time, loops::indentations(row)[i]));
            Series::line(*name, points.collect()).with_style(loops::loop_style(i, *width))
        })
        .collect();
    drawn[0].legend_texts.push(format!("δₘ = {}", format_result(impact.row.peak_indentation, Dimension::Length)));
    let speed = Series::line("Speed δ′", points(|row| row.speed)).with_style(thin(4));
    let speed = speed.with_note(format!("impact at {}", format_result(impact.speed, Dimension::Speed)));
    let (slowest, fastest) = min_max(impact.trace.iter().map(|row| row.speed));
    let y = |title, unit, low: f64, high: f64| Axis::linear(title, unit).with_range(1.1 * low, 1.1 * high);
    let mut panels = vec![
        Panel::new(y("Force", "N", 0.0, impact.row.peak_force), vec![force]),
        Panel::new(y("Indentation", "m", 0.0, impact.row.peak_indentation), drawn),
        Panel::new(y("Speed", "m/s", slowest.min(0.0), fastest.max(0.0)), vec![speed]),
    ];
    panels[2].guides.push(Series::horizontal(0.0, "").with_style(Style::line(FOREGROUND, 1.5)));
    let x = Axis::linear("Time", "s").with_range(0.0, 1.03 * impact.duration());
    Ok(Chart::with_panels(title(impact), x, panels).with_guides(event_guides(impact)))
}

/// Vertical lines at the peak and at the end.
fn event_guides(impact: &Impact) -> Vec<Series> {
    let line = Style::line(GREY, 2.5);
    let peak = Series::vertical(impact.loading_time, peak_name(impact))
        .with_note(format_result(impact.loading_time, Dimension::Time));
    let peak = if is_damped(impact) { peak.with_note(force_at_peak(impact)) } else { peak };
    let end = |name: &str| {
        Series::vertical(impact.duration(), name)
            .with_note(format_result(impact.duration(), Dimension::Time))
            .with_style(line)
    };
    let mut end = match impact.captured_result() {
        None => {
            end("Separation").with_note(format!("rebound at {}", format_result(impact.rebound_speed, Dimension::Speed)))
        }
        Some(under) => {
            let rest =
                under.static_indentation.map_or_else(String::new, |depth| format_result(depth, Dimension::Length));
            end("Captured").with_note(format!("rest at δ = {rest}"))
        }
    };
    if impact.row.has_dent() {
        end = end.with_note(format!(
            "{} δᵣ = {}",
            impact.row.imprint_name(),
            format_result(impact.row.residual_indentation, Dimension::Length)
        ));
    }
    // a sphere that comes to rest at its deepest point has one line there
    let is_apart = impact.duration() - impact.loading_time > 1e-3 * impact.duration();
    [peak.with_style(line.with_dash(DASHED))].into_iter().filter(|_| is_apart).chain([end]).collect()
}
