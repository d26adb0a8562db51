//! Friction force, slip speed and spin of an oblique impact against time, in boxes one above the other.

use super::force_indentation::title;
use crate::impact::Impact;
use crate::impact::oblique::FrictionState;
use crate::report::chart::{Axis, Chart, FOREGROUND, GREY, Panel, Series, Style, min_max};
use crate::units::{Dimension, format_result};

/// The picture of friction; `None` for an impact without an angle, a spin, or a trace.
pub fn friction(impact: &Impact) -> Option<Chart> {
    let rows: Vec<(f64, FrictionState)> =
        impact.trace.iter().filter_map(|row| Some((row.time, row.friction?))).collect();
    let (_, last) = rows.last()?;
    let panel = |name: &str, unit: &str, number: usize, value: fn(&FrictionState) -> f64, note: Option<String>| {
        let points: Vec<(f64, f64)> = rows.iter().map(|(time, row)| (*time, value(row))).collect();
        let (low, high) = min_max(points.iter().map(|at| at.1).chain([0.0]));
        let margin = 0.08 * (high - low);
        let mut series = Series::line(name, points).with_style(Style::new(number).with_solid_line());
        series.legend_texts.extend(note);
        let mut panel = Panel::new(Axis::linear(name, unit).with_range(low - margin, high + margin), vec![series]);
        panel.guides.push(Series::horizontal(0.0, "").with_style(Style::line(FOREGROUND, 1.5)));
        panel
    };
    let after = |value, dimension| Some(format!("{} at the end", format_result(value, dimension)));
    let mut panels = vec![
        panel("Friction", "N", 3, |row| row.friction_force, None),
        panel("Slip speed", "m/s", 1, |row| row.slip_speed, after(last.slip_speed, Dimension::Speed)),
        panel("Spin", "rad/s", 2, |row| row.tangential.spin, after(last.tangential.spin, Dimension::AngularSpeed)),
    ];
    if let Some(cross) = last.tangential.cross {
        let about_path = |row: &FrictionState| row.tangential.cross.map_or(0.0, |cross| cross.spin_about_path);
        let note = after(cross.spin_about_path, Dimension::AngularSpeed);
        panels.push(panel("Spin about path", "rad/s", 4, about_path, note));
    }
    let x = Axis::linear("Time", "s").with_range(0.0, 1.03 * impact.duration());
    let peak = Series::vertical(impact.loading_time, "deepest point").with_style(Style::line(GREY, 2.0));
    Some(Chart::with_panels(title(impact), x, panels).with_guides([peak]))
}
