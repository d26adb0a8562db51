//! The blocks of `check`: every value with its unit, and the numbers that follow from them before anything is run.

use super::blocks::{Block, note_blocks};
use super::inputs::Inputs;
use super::terminal::label_value_rows;
use super::{calibrate, check};
use crate::calibrate::{Calibration, CalibrationTask};
use crate::contact::law::LawChoice;
use crate::contact::pair::Pair;
use crate::impact::Contact;
use crate::materials::Property;
use crate::scenario::input::{Body, Input, KeyValue};
use crate::scenario::keys::{KeyId, OTHER, body_key, key};
use crate::units::{Dimension, format_four_digits, format_input, format_percent, format_si_and_short};

/// A name and a value.
type Row = [String; 2];

/// Inputs and contact, and the notes.
pub fn overview(input: &Input, contact: &Contact, notes: &[String]) -> Vec<Block> {
    let mut rows = Vec::new();
    let speed = input.approach().normal;
    let contact = &check::contact_at_own_speed(input, contact);
    let law = input.law();
    for [key, text] in input_rows(&Inputs::new(input)) {
        match key.as_str() {
            // the keys of the PLM name the law
            "law" if matches!(law, LawChoice::Plm(_)) => {}
            "law" => {
                let about = law.info();
                rows.push([key, format!("{text} ({})", law.source())]);
                rows.push(["law.validity".to_owned(), about.validity.to_owned()]);
                rows.push(["law.confidence".to_owned(), about.confidence.to_owned()]);
            }
            _ => rows.push([key, text]),
        }
    }
    rows.push([String::new(), String::new()]);
    rows.extend(label_value_rows(&check::contact_results(), contact));
    rows.push(yielding_row(contact.pair(), contact.reaches_first_yield()));
    if let Some(rated) = contact.strain_rate_result() {
        rows.push(["strain rate".to_owned(), format_si_and_short(rated.strain_rate, Dimension::StrainRate)]);
        rows.push(["strain-rate factor".to_owned(), format_four_digits(rated.factor)]);
        rows.push(["strain-rate factor at maximum compression".to_owned(), format_four_digits(rated.factor_at_peak)]);
    }
    let softer = contact.pair().reachable_yield_point().map(|point| point.yield_partition.for_softer(Body::ALL));
    let hint = rate_hint(input, contact, softer, speed);
    [vec![Block::list(rows)], note_blocks(notes), note_blocks(hint.as_slice())].concat()
}

/// Bodies and measurements of a calibration as they were understood, and what it finds.
pub fn calibration_overview(measured: &CalibrationTask, calibration: &Calibration) -> Vec<Block> {
    let mut rows = input_rows(&calibrate::inputs(measured, calibration));
    rows.push([String::new(), String::new()]);
    let CalibrationTask { data, .. } = measured;
    let mut range = |name: &str, dimension: Dimension, values: Vec<f64>| {
        let [low, high] = [f64::min, f64::max].map(|end| values.iter().copied().fold(f64::NAN, end));
        let count = values.iter().filter(|value| !value.is_nan()).count();
        let [low, high] = [low, high].map(|end| format_input(end, dimension));
        let values = match count {
            1 => format!("1 value, {low}"),
            _ => format!("{count} values, {low} to {high}"),
        };
        rows.push([name.to_owned(), format!("{values}, in {}", data.name)]);
    };
    for (column, key) in data.keys.iter().enumerate() {
        range(key.path(), key.quantity().dimension, data.rows.iter().map(|row| row.keys[column]).collect());
    }
    for quantity in data.measured_quantities() {
        let of_it = data.values.iter().filter(|value| value.quantity == quantity);
        range(quantity.name(), quantity.quantity().dimension, of_it.map(|value| value.value).collect());
    }
    [vec![Block::list(rows), Block::EmptyLine], calibrate::result_blocks(calibration)].concat()
}

/// How much higher e is with the rate of strain of the metal that yields, where that is known and not asked for.
fn rate_hint(input: &Input, contact: &Contact, softer: Option<Body>, speed: f64) -> Option<String> {
    let body = softer?;
    let choice = input.materials().iter().find(|choice| choice.body == body)?;
    let c = choice.material.get(Property::RateSensitivity)?.value.value;
    if input.has_rate() || !matches!(input.law(), LawChoice::Plm(_)) {
        return None;
    }
    let mut raised = input.clone();
    raised.set(body_key!(body, "rate.johnson_cook.c"), Some(c));
    let e = |contact: &Contact| Some(contact.row(speed, &input.solver()).ok()?.restitution);
    let higher = e(&raised.contact().ok()?)? / e(contact)? - 1.0;
    (higher > 0.0).then(|| {
        format!(
            "Hint: with the strain-rate dependence of {} (c = {c}), e is {} higher. Set {} = \"material\".",
            choice.material.name,
            format_percent(higher),
            body.rate_table()
        )
    })
}

/// Keys and values. Of a set of coefficients the terminal shows the name; a summary has the source too.
pub(super) fn input_rows(inputs: &Inputs) -> Vec<Row> {
    let coefficients: KeyId<OTHER> = key!("law.plm.coefficients");
    let text = |entry: &KeyValue| {
        let text = entry.terminal_text();
        let name = text.split_once(" (").filter(|_| entry.path == coefficients.path()).map(|(name, _)| name.to_owned());
        name.unwrap_or(text)
    };
    inputs.0.iter().map(|entry| [entry.path.clone(), text(entry)]).collect()
}

/// Which body flows, with the ratio of the strengths, if the contact is narrower than the sphere at first yield.
pub(super) fn yielding_row(pair: &Pair, is_reached: bool) -> Row {
    let Some(point) = pair.yield_point else { return ["yielding body", ELASTIC_TEXT].map(str::to_owned) };
    if !is_reached {
        return ["yielding body", TOO_WIDE].map(str::to_owned);
    }
    let flow = point.yield_partition;
    let ratio = flow.ratio;
    let [softer, harder] = if flow.is_sphere { ["sphere", "half-space"] } else { ["half-space", "sphere"] };
    let times = format_four_digits(ratio);
    let who = if pair.has_equal_balls() {
        "both (equal balls)".to_owned()
    } else if ratio.is_infinite() {
        format!("{softer} (the {harder} has no yield strength)")
    } else if flow.is_shared() {
        let is_sum = pair.has_unequal_balls();
        let sum = if is_sum { "; their indentations are superposed, with an error of up to 1 % of e" } else { "" };
        format!("both (the {harder} is {times} times stronger, so the {softer} yields more{sum})")
    } else {
        format!("{softer} (the {harder} is {times} times stronger)")
    };
    ["yielding body".to_owned(), who]
}

const TOO_WIDE: &str = "none (at first yield the contact would be wider than the sphere)";
const ELASTIC_TEXT: &str = "none (elastic contact, because no body has a yield strength)";
