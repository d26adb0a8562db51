//! What is written about repeated impacts: `impacts.csv`, `trace.csv` and the table on the terminal.

use std::fmt::Write as _;

use super::ReportError;
use super::rows::csv;
use crate::repeat::flight::Flight;
use crate::repeat::{Drive, End, Place, Repeat, Sequence};
use crate::scene::results::impact::event_name;
use crate::scene::results::series::{self as results, TraceRow, end_text};
use crate::units::aligned::aligned;
use crate::units::rounded::{number, quantity};

/// `impacts.csv`: one row per impact.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn impacts(sequence: &Sequence) -> Result<Vec<u8>, ReportError> {
    csv(&results::impacts(), (1..).zip(sequence.hits.iter().copied()))
}

/// `trace.csv`: the impacts that were traced, and the flights between them.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn trace(sequence: &Sequence, samples: usize) -> Result<Vec<u8>, ReportError> {
    let mut rows = Vec::new();
    if let Some(fall) = &sequence.fall {
        fly(0, fall, samples, &mut rows);
    }
    for (i, (hit, impact)) in sequence.hits.iter().zip(&sequence.traced).enumerate() {
        rows.extend(impact.trace.iter().map(|row| TraceRow {
            impact: i + 1,
            time: hit.time.unwrap_or(0.0) + row.time,
            height: -row.indentation,
            speed: row.speed,
            force: row.force,
            branch: row.branch.name(),
            event: event_name(row.event),
        }));
        if let Some(flight) = &hit.flight {
            fly(i + 1, flight, samples, &mut rows);
        }
    }
    csv(&results::trace(), rows.into_iter())
}

/// Rows of a flight. Its first touch and its separation are rows of the contacts; only the release of the sphere is not.
#[allow(clippy::cast_precision_loss)]
fn fly(impact: usize, flight: &Flight, samples: usize, rows: &mut Vec<TraceRow>) {
    rows.extend((usize::from(impact > 0)..=samples).map(|i| {
        let time = flight.duration * i as f64 / (samples + 1) as f64;
        TraceRow {
            impact,
            time: flight.begin + time,
            height: flight.height_at(time),
            speed: flight.speed_at(time),
            force: 0.0,
            branch: "flight",
            event: if i == 0 { "release" } else { "" },
        }
    }));
}

/// Impacts at the beginning and at the end of a long series that the terminal shows.
const SHOWN: (usize, usize) = (12, 5);

/// A few lines about the series, and one for each impact.
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
        if let Some(static_indentation) = last.forced(|forces| forces.static_indentation) {
            line("rests at", format!("{} below the original surface", quantity(static_indentation, "m")));
        }
        if last.energy.plastic.is_some() {
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
        (hits.iter().any(|hit| hit.time.is_some()), hits.iter().any(|hit| hit.energy.plastic.is_some()));
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
        cells.push(if hit.is_captured() { "captured".to_owned() } else { quantity(hit.contact_time, "s") });
        lines.push(cells);
    }
    aligned(&lines, |_| false)
}

/// Speeds of a list that are shown one by one.
const MOST_LISTED: usize = 8;

/// What `check` says of a series before anything is run; the last line leads over to the scene.
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
