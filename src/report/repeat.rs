//! What is written about repeated impacts: `impacts.csv`, `trace.csv` and the table on the terminal.

use std::fmt::Write as _;

use serde::Serialize;

use super::ReportError;
use super::trace::event_name;
use crate::repeat::flight::Flight;
use crate::repeat::{Drive, End, Hit, Place, Repeat, Sequence};
use crate::units::rounded::{number, quantity};

/// Why the series ended, for a person.
#[must_use]
pub fn end_text(repeat: &Repeat, sequence: &Sequence) -> String {
    let until = match repeat.drive {
        Drive::Bouncing { until: Some(until), .. } => quantity(until, "m/s"),
        _ => String::new(),
    };
    match sequence.end {
        End::Shots => "all shots are fired".to_owned(),
        End::Impacts => "as many impacts as were asked for".to_owned(),
        End::Until => format!("the next impact would be slower than {until}"),
        End::Captured => "captured: the sphere does not leave the half-space".to_owned(),
        End::InDent => "the rebound does not lift the sphere out of its dent onto fresh surface".to_owned(),
    }
}

type Column = (&'static str, fn(&Hit) -> Option<f64>);

/// `impacts.csv`: one row per impact. `time_s` is there for a bouncing sphere, `plastic_J` for a half-space that can
/// yield, `damping_J` with damping, `stored_at_separation_J` with viscous damping; the contact of a captured sphere has no time.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn impacts(sequence: &Sequence) -> Result<Vec<u8>, ReportError> {
    let first = sequence.hits.first();
    let (is_timed, can_yield) =
        (first.is_some_and(|hit| hit.time.is_some()), first.is_some_and(|hit| hit.plastic.is_some()));
    let columns: [Column; 15] = [
        ("time_s", |hit| hit.time),
        ("impact_speed_m_per_s", |hit| Some(hit.speed)),
        ("restitution", |hit| Some(hit.restitution)),
        ("rebound_speed_m_per_s", |hit| Some(hit.rebound_speed)),
        ("peak_force_N", |hit| Some(hit.peak_force)),
        ("peak_indentation_m", |hit| Some(hit.peak_indentation)),
        ("residual_indentation_m", |hit| Some(hit.residual_indentation)),
        ("dent_growth_m", |hit| Some(hit.dent_growth)),
        ("contact_time_s", |hit| Some(hit.contact_time).filter(|time| time.is_finite())),
        ("kinetic_in_J", |hit| Some(hit.kinetic_in)),
        ("recovered_J", |hit| Some(hit.recovered)),
        ("plastic_J", |hit| hit.plastic),
        ("damping_J", |hit| hit.damping),
        ("stored_at_separation_J", |hit| hit.stored_at_separation),
        ("energy_drift", |hit| Some(hit.drift)),
    ];
    let is_written = |name: &str| match name {
        "time_s" => is_timed,
        "residual_indentation_m" | "dent_growth_m" | "plastic_J" => can_yield,
        "damping_J" => first.is_some_and(|hit| hit.damping.is_some()),
        "stored_at_separation_J" => sequence.hits.iter().any(|hit| hit.stored_at_separation.is_some()),
        _ => true,
    };
    let columns: Vec<Column> = columns.into_iter().filter(|(name, _)| is_written(name)).collect();
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(std::iter::once("impact").chain(columns.iter().map(|(name, _)| *name)))?;
    for (i, hit) in sequence.hits.iter().enumerate() {
        let values: Vec<Option<f64>> = columns.iter().map(|(_, value)| value(hit)).collect();
        writer.serialize((i + 1, values))?;
    }
    writer.into_inner().map_err(|error| ReportError::Csv(error.into_error().into()))
}

#[derive(Serialize)]
struct Row {
    impact: usize,
    time_s: f64,
    height_m: f64,
    speed_m_per_s: f64,
    #[serde(rename = "force_N")]
    force: f64,
    branch: &'static str,
    event: &'static str,
}

const COLUMNS: [&str; 7] = ["impact", "time_s", "height_m", "speed_m_per_s", "force_N", "branch", "event"];

/// `trace.csv`: height of the sphere's lowest point over the original surface (−δ in contact), speed towards it and
/// force, for the impacts that were traced and the flights between them. `impact` is 0 during the fall before the first.
/// Time is that of the series for a bouncing sphere, and counts from each first touch for shots.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn trace(sequence: &Sequence, samples: usize) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    let fly = |impact: usize, flight: &Flight, writer: &mut csv::Writer<Vec<u8>>| -> Result<(), ReportError> {
        // touch and separation are rows of the contacts; only a release is none
        let first = usize::from(impact > 0);
        for i in first..=samples {
            #[allow(clippy::cast_precision_loss)]
            let time = flight.duration * i as f64 / (samples + 1) as f64;
            writer.serialize(Row {
                impact,
                time_s: flight.begin + time,
                height_m: flight.height_at(time),
                speed_m_per_s: flight.speed_at(time),
                force: 0.0,
                branch: "flight",
                event: if i == 0 { "release" } else { "" },
            })?;
        }
        Ok(())
    };
    if let Some(fall) = &sequence.fall {
        fly(0, fall, &mut writer)?;
    }
    for (i, (hit, impact)) in sequence.hits.iter().zip(&sequence.traced).enumerate() {
        for row in &impact.trace {
            writer.serialize(Row {
                impact: i + 1,
                time_s: hit.time.unwrap_or(0.0) + row.time,
                height_m: -row.indentation,
                speed_m_per_s: row.speed,
                force: row.force,
                branch: row.branch.name(),
                event: event_name(row.event),
            })?;
        }
        if let Some(flight) = &hit.flight {
            fly(i + 1, flight, &mut writer)?;
        }
    }
    writer.into_inner().map_err(|error| ReportError::Csv(error.into_error().into()))
}

/// Impacts at the beginning and at the end of a long series that the terminal shows.
const SHOWN: (usize, usize) = (12, 5);

/// A few lines about the series, and one for each impact.
#[must_use]
pub fn table(repeat: &Repeat, sequence: &Sequence) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "{name:<15}  {value}");
    };
    let place = match repeat.place {
        Place::Same => "all on the same spot",
        Place::Fresh => "each on fresh surface",
    };
    line("impacts", format!("{}, {place}", sequence.hits.len()));
    line("ended", end_text(repeat, sequence));
    if let Some(last) = sequence.hits.last() {
        if let Some(time) = last.separation_time() {
            line("time", format!("{} to the last separation", quantity(time, "s")));
            let rest = match (sequence.remaining_time, sequence.end) {
                (Some(rest), _) => {
                    format!(
                        "{} of bouncing left if the last e held, 2 v/(g (1 - e)); more if e rises",
                        quantity(rest, "s")
                    )
                }
                (None, End::Impacts | End::Until) => {
                    format!("bounces without end: the last impact had e = {}", number(last.restitution))
                }
                (None, _) => "none".to_owned(),
            };
            line("remaining", rest);
        }
        if let Some(static_indentation) = last.static_indentation {
            line("rests at", format!("{} below the original surface", quantity(static_indentation, "m")));
        }
        if last.plastic.is_some() {
            line("deepest dent", quantity(sequence.deepest_dent(), "m"));
        }
        line("energy drift", format!("{:.1e}, the largest of all impacts", sequence.drift()));
    }
    text.push('\n');
    text.push_str(&rows(sequence));
    text
}

fn rows(sequence: &Sequence) -> String {
    let hits = &sequence.hits;
    let (is_timed, can_yield) =
        (hits.iter().any(|hit| hit.time.is_some()), hits.iter().any(|hit| hit.plastic.is_some()));
    let mut lines: Vec<Vec<String>> = Vec::new();
    let mut head = vec!["impact"];
    head.extend(is_timed.then_some("time"));
    head.extend(["speed", "e", "rebound", "peak force", "peak depth"]);
    head.extend(can_yield.then_some(["dent", "growth"]).into_iter().flatten());
    head.push("contact");
    lines.push(head.into_iter().map(str::to_owned).collect());
    for (i, hit) in hits.iter().enumerate() {
        if i >= SHOWN.0 && i + SHOWN.1 < hits.len() && hits.len() > SHOWN.0 + SHOWN.1 + 1 {
            if i == SHOWN.0 {
                lines.push(vec!["...".to_owned()]);
            }
            continue;
        }
        let mut cells = vec![(i + 1).to_string()];
        cells.extend(hit.time.map(|time| quantity(time, "s")));
        cells.push(quantity(hit.speed, "m/s"));
        cells.push(number(hit.restitution));
        cells.push(quantity(hit.rebound_speed, "m/s"));
        cells.push(quantity(hit.peak_force, "N"));
        cells.push(quantity(hit.peak_indentation, "m"));
        if can_yield {
            cells.push(quantity(hit.residual_indentation, "m"));
            cells.push(quantity(hit.dent_growth, "m"));
        }
        cells.push(if hit.is_captured { "captured".to_owned() } else { quantity(hit.contact_time, "s") });
        lines.push(cells);
    }
    let columns = lines[0].len();
    let widths: Vec<usize> = (0..columns)
        .map(|c| lines.iter().filter_map(|line| line.get(c)).map(|cell| cell.chars().count()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for line in &lines {
        let cells: Vec<String> = line.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect();
        let _ = writeln!(text, "{}", cells.join("  ").trim_end());
    }
    text
}

/// Speeds of a list that are shown one by one.
const MOST_LISTED: usize = 8;

/// What `check` says of a series before anything is run; the last line leads over to the scene.
#[must_use]
pub fn repeat_lines(repeat: &Repeat) -> String {
    let place = match repeat.place {
        Place::Same => "all on the same spot",
        Place::Fresh => "each on fresh surface",
    };
    let mut text = String::new();
    match &repeat.drive {
        Drive::Bouncing { most, until, .. } => {
            let _ = writeln!(text, "bouncing under gravity, {place}, until");
            let _ = writeln!(text, "  there were {most} impacts");
            if let Some(until) = until {
                let _ = writeln!(text, "  or the next one would be slower than {}", quantity(*until, "m/s"));
            }
            if repeat.place == Place::Fresh {
                let _ = writeln!(text, "  or the rebound does not lift the sphere out of its dent");
            }
            let _ = writeln!(text, "  or the sphere is captured");
        }
        Drive::Shots(speeds) => {
            let _ = writeln!(text, "{} shots, {place}, at", speeds.len());
            let say = |speed: &f64| quantity(*speed, "m/s");
            let is_one = speeds.iter().all(|speed| *speed == speeds[0]);
            let list = if is_one {
                say(&speeds[0])
            } else if speeds.len() <= MOST_LISTED {
                speeds.iter().map(say).collect::<Vec<_>>().join(", ")
            } else {
                format!("{}, {} ... {}", say(&speeds[0]), say(&speeds[1]), say(&speeds[speeds.len() - 1]))
            };
            let _ = writeln!(text, "  {list}");
        }
    }
    text.push_str("\nthe scene of the first impact:\n");
    text
}
