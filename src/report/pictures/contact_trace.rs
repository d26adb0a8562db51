//! Force against indentation of a contact that another code computed, with the loop of the law.

use super::loops;
use crate::contact_trace::{ContactTrace, TraceMeasures};
use crate::impact::Impact;
use crate::report::chart::{Axis, Chart, Series, Style};
use crate::units::format_four_digits;

/// The loop of the trace, and that of an impact with a trace.
pub fn contact_trace(name: &str, trace: &ContactTrace, measures: &TraceMeasures, law: Option<&Impact>) -> Chart {
    let points: Vec<(f64, f64)> = trace.contact_steps().iter().map(|step| (step.indentation, step.force)).collect();
    let e = |value: f64| format!("e = {}", format_four_digits(value));
    let mut series = Vec::new();
    let mut depth = measures.peak_indentation;
    let mut force = measures.peak_force;
    if let Some(law) = law {
        let branches = loops::impact_loop(law).unwrap_or_default();
        let mut of_law = loops::loop_series("Law", loops::loop_style(0, 5.0), &branches, 0);
        if let Some(first) = of_law.first_mut() {
            *first = first.clone().with_note(e(law.row.measured_restitution()));
        }
        series.extend(of_law);
        (depth, force) = (depth.max(law.row.peak_indentation), force.max(law.row.peak_force));
    }
    let of_trace = Series::line(name, points.clone()).with_style(Style::new(1).with_solid_line().with_width(2.0));
    series.push(of_trace.with_note(e(measures.restitution())));
    let lowest = points.iter().map(|(_, force)| *force).fold(0.0, f64::min);
    let first = points.iter().map(|(indentation, _)| *indentation).fold(0.0, f64::min);
    let x = Axis::linear("Indentation", "m").with_range(first, 1.06 * depth);
    let y = Axis::linear("Force", "N").with_range(1.08 * lowest, 1.08 * force);
    Chart::new(format!("One contact of {name}"), [x, y], series)
}
