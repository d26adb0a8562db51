//! `trace.csv`: the impact against time, shortest digits that read back to the same number.

use serde::Serialize;

use super::ReportError;
use crate::impact::{Event, Impact};

/// The column `event`; empty on an ordinary sample.
#[must_use]
pub fn event_name(event: Option<Event>) -> &'static str {
    match event {
        None => "",
        Some(Event::Touch) => "touch",
        Some(Event::Yield) => "yield",
        Some(Event::Knot) => "knot",
        Some(Event::Peak) => "peak",
        Some(Event::Separation) => "separation",
        Some(Event::Captured) => "captured",
    }
}

#[derive(Serialize)]
struct Row {
    time_s: f64,
    indentation_m: f64,
    sphere_indentation_m: f64,
    half_space_indentation_m: f64,
    speed_m_per_s: f64,
    #[serde(rename = "force_N")]
    force: f64,
    #[serde(rename = "elastic_force_N", skip_serializing_if = "Option::is_none")]
    elastic_force: Option<f64>,
    branch: &'static str,
    event: &'static str,
}

/// The columns; `elastic_force_N`, the force without what damping adds to it, only where there is damping.
const COLUMNS: [&str; 9] = [
    "time_s",
    "indentation_m",
    "sphere_indentation_m",
    "half_space_indentation_m",
    "speed_m_per_s",
    "force_N",
    "elastic_force_N",
    "branch",
    "event",
];

/// The trace of an impact as CSV with a header line; only the header for an impact that recorded none.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn trace(impact: &Impact) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let is_damped = impact.under_forces.is_some_and(|under| under.damping_loss.is_some());
    writer.write_record(COLUMNS.iter().filter(|name| is_damped || **name != "elastic_force_N"))?;
    for row in &impact.trace {
        writer.serialize(Row {
            time_s: row.time,
            indentation_m: row.indentation,
            sphere_indentation_m: row.sphere_indentation,
            half_space_indentation_m: row.half_space_indentation,
            speed_m_per_s: row.speed,
            force: row.force,
            elastic_force: row.elastic_force,
            branch: row.branch.name(),
            event: event_name(row.event),
        })?;
    }
    writer.into_inner().map_err(|error| ReportError::Csv(error.into_error().into()))
}
