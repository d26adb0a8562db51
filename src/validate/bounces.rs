//! A ball that bounces has one restitution at these low speeds, from whatever height it is dropped. The times between its bounces
//! give that restitution only if the flight is right: this compares the formulas of the flight, and no contact law.

use super::comparison::{Comparison, Group, mean};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::impact::STANDARD_GRAVITY;
use crate::impact::flight::free_flight::{FreeFlight, Medium};
use crate::reference::{BOUNCE_INTERVALS, ReferenceRow};

const SOURCE: &str = "bounce intervals of a table-tennis ball, student measurements (Ali, Broggi, Cantarini), not independently confirmed, scenarios/clicks.csv";
const IN_AIR: Group = Group::new("measured: restitution at a drop height over that at 8 cm, with air", SOURCE, "");
const IN_VACUUM: Group =
    Group::new("measured: restitution at a drop height over that at 8 cm, without air", SOURCE, "");

/// The ball and the air of `scenarios/bouncing-clicks.toml`.
const RADIUS: f64 = 0.02;
const MASS: f64 = 2.7e-3;
const AIR: Medium = Medium { density: 1.2, drag: Some(0.5), viscosity: f64::NAN };

/// The restitution of the bounces between these intervals: the speed of each take-off over that of the landing before it. A contact
/// lasts about a millisecond, which changes a restitution by 0.02 %, and is left in the intervals.
fn restitution(drop: &[ReferenceRow], flying: &FreeFlight) -> f64 {
    let take_offs: Vec<f64> =
        drop.iter().map(|click| flying.take_off_speed(click.number("bounce_interval_s"))).collect();
    let ratio = |pair: &[f64]| pair[1] / flying.landing_speed(flying.rise_height(pair[0]));
    mean(&take_offs.windows(2).map(ratio).collect::<Vec<_>>())
}

/// The higher drops against the lowest, on which air has the least effect. The contact law has no part in it, so its coefficients
/// change nothing.
pub(super) fn bounce_heights(_: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let clicks = BOUNCE_INTERVALS.rows()?;
    let drops: Vec<&[ReferenceRow]> =
        clicks.chunk_by(|_, next| next.optional_number("drop_height_cm").is_none()).collect();
    let Some((lowest, higher)) = drops.split_first() else { return Ok(Vec::new()) };
    let mut compared = Vec::new();
    for (group, flying) in [
        (IN_AIR, FreeFlight::in_air(STANDARD_GRAVITY, &AIR, RADIUS, MASS)),
        (IN_VACUUM, FreeFlight::in_vacuum(STANDARD_GRAVITY)),
    ] {
        let reference = restitution(lowest, &flying);
        for drop in higher {
            let height = drop.first().map_or(f64::NAN, |click| click.number("drop_height_cm"));
            compared.push(group.compare(format!("{height} cm"), [reference, restitution(drop, &flying)]));
        }
    }
    Ok(compared)
}
