//! Texts about repeated impacts: `summary.json`, `impacts.csv`, `trace.csv` and the blocks for people.

use serde_json::{Map, Value};

use super::blocks::Block;
use super::files::csv_bytes;
use super::terminal::{self, Detail, Imprint};
use crate::error::Error;
use crate::impact::flight::trajectory::Flight;
use crate::impact::series::{ImpactSeries, SeriesImpact, SeriesMode, SeriesResult};
use crate::results::series as results;
use crate::results::series::{SeriesReport, SeriesTraceRow};
use crate::results::to_fields;
use crate::results::trace::event_name;
use crate::units::{Dimension, format_result};

/// A summary lists the speeds of at most this number of shots; a longer list is in `impacts.csv` only.
const MAX_LISTED_SPEEDS: usize = 1000;

/// The results by their names.
pub fn summary_fields(series: &SeriesReport) -> Map<String, Value> {
    let mut results = to_fields(&results::series_results(), series);
    if let SeriesMode::Shots(speeds) = &series.repeat.mode
        && speeds.len() <= MAX_LISTED_SPEEDS
    {
        results.insert("shot_speeds_m_per_s".to_owned(), speeds.clone().into());
    }
    results
}

/// `impacts.csv`: one row per impact.
pub fn impacts_csv(sequence: &SeriesResult) -> Result<Vec<u8>, Error> {
    csv_bytes(&results::impact_columns(), (1..).zip(&sequence.impacts))
}

/// `trace.csv`: the impacts that were traced, and the flights between them.
pub fn trace_csv(sequence: &SeriesResult, samples: usize) -> Result<Vec<u8>, Error> {
    let mut rows = Vec::new();
    let is_any = |has: fn(&SeriesImpact) -> bool| sequence.impacts.iter().any(has);
    let hops = is_any(|hit| hit.tangential().is_some());
    let turns = is_any(|hit| hit.cross_motion().is_some());
    let reported = [hops, turns];
    if let Some(fall) = &sequence.fall {
        push_flight_rows(0, fall, reported, samples, &mut rows);
    }
    for (i, hit) in sequence.traced_impacts().iter().enumerate() {
        let mut at: Option<(f64, [f64; 2], [f64; 2])> = None;
        rows.extend(hit.impact.trace.iter().map(|row| {
            let position = row.friction.map(|friction| {
                // by the trapezoidal rule along the contact
                let (time, velocity) = (row.time, friction.tangential.velocity());
                let moved = at.map_or(hit.position, |(before, place, was)| {
                    [0, 1].map(|axis| place[axis] + 0.5 * (was[axis] + velocity[axis]) * (time - before))
                });
                at = Some((time, moved, velocity));
                moved
            });
            SeriesTraceRow {
                impact: i + 1,
                time: hit.time.unwrap_or(0.0) + row.time,
                position: position.map(|[along, _]| along),
                cross_position: position.filter(|_| turns).map(|[_, across]| across),
                height: -row.indentation,
                speed: row.speed,
                force: row.force,
                branch: row.branch.name(),
                event: event_name(row.event),
            }
        }));
        if let Some(flight) = &hit.flight {
            push_flight_rows(i + 1, flight, reported, samples, &mut rows);
        }
    }
    csv_bytes(&results::trace_columns(), rows.into_iter())
}

/// The rows of a flight without its ends, which are rows of the contacts before and after it. Only the release of the
/// sphere, where the first fall begins, is a row of the flight. `reported` states which of the two positions the trace has.
fn push_flight_rows(
    impact: usize,
    flight: &Flight,
    reported: [bool; 2],
    samples: usize,
    rows: &mut Vec<SeriesTraceRow>,
) {
    rows.extend((usize::from(impact > 0)..=samples).map(|i| {
        let time = flight.duration * i as f64 / (samples + 1) as f64;
        let place = flight.position_at(time);
        let [position, cross_position] = [0, 1].map(|axis| reported[axis].then_some(place[axis]));
        SeriesTraceRow {
            impact,
            time: flight.begin + time,
            position,
            cross_position,
            height: flight.height_at(time),
            speed: flight.speed_at(time),
            force: 0.0,
            branch: "flight",
            event: if i == 0 { "release" } else { "" },
        }
    }));
}

/// How many impacts at the beginning and at the end of a long series the table shows.
const SHOWN_IMPACTS: (usize, usize) = (12, 5);

/// A list about the series, and a table with a row for each impact.
pub fn result_blocks(series: &SeriesReport, detail: Detail) -> Vec<Block> {
    let hits = &series.sequence.impacts;
    let is_shown =
        |(number, _): &(usize, &SeriesImpact)| *number <= SHOWN_IMPACTS.0 || number + SHOWN_IMPACTS.1 > hits.len();
    let shown: Vec<(usize, &SeriesImpact)> = (1..).zip(hits).filter(is_shown).collect();
    let imprint = Imprint::new(series.contact.is_spring(), series.sequence.imprint_name());
    let mut rows = terminal::result_columns(&results::impact_columns(), &shown, imprint);
    if shown.len() < hits.len() {
        rows.insert(SHOWN_IMPACTS.0 + 1, vec!["...".to_owned()]);
    }
    let mut about = results::series_results();
    about.retain(|result| detail == Detail::Full || result.name != "energy.balance_error");
    let lines = terminal::result_lines(&about, series, imprint);
    vec![Block::list(lines), Block::EmptyLine, Block::table(rows, 0)]
}

/// The blocks of `check` about a series: its keys. The scene of the first impact follows.
pub fn check_blocks(repeat: &ImpactSeries) -> Vec<Block> {
    let speed = |speed: &f64| format_result(*speed, Dimension::Speed);
    let mut rows = vec![["repeat.spot", repeat.spot_mode.name()].map(str::to_owned)];
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value]);
    match &repeat.mode {
        SeriesMode::Bouncing { most, until, .. } => {
            row("repeat.impacts", most.to_string());
            if let Some(until) = until {
                row("repeat.until.speed", speed(until));
            }
        }
        SeriesMode::Shots(speeds) => {
            row("shots", speeds.len().to_string());
            let [low, high] = [f64::min, f64::max].map(|end| speeds.iter().copied().fold(f64::NAN, end));
            row("speed", if low == high { speed(&low) } else { format!("{} to {}", speed(&low), speed(&high)) });
        }
    }
    vec![Block::list(rows), Block::EmptyLine, Block::Sentence("values of the first impact:".to_owned())]
}
