//! The record: the size of every column of every run, from which a moved number is seen.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::numbers::{Cell, Columns, Place};

/// Values may move by this share of the largest value of their column.
const TOLERANCE: f64 = 1e-12;

/// Where the last digit of a double moves a result further: whether one more evaluation of the force is needed, the
/// derivatives of a fit, and the remaining time of a sphere that loses no more energy.
const LOOSE: [(&str, f64); 3] =
    [("scenarios/calibrate", 1e-8), ("work.force_evaluations", 0.02), ("remaining_time_s", 1e-2)];

/// Columns of what would be zero without rounding, such as a balance of energies. They are shares of something, so 1 is
/// the size that counts, and not the largest of their own values.
const SHARES: [&str; 3] = ["error", "deviation", "error_at_end"];

/// The record keeps this of a column.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Summary {
    /// The value of a column with one row.
    One(Cell),
    Many {
        /// Number of values.
        rows: usize,
        /// Mean of the magnitudes of all numbers. It moves when all numbers move together.
        mean: f64,
        /// Sum of all values, each with a weight of its own: between 1 and 2, or between -1 and -2, by the row. It
        /// moves when one number moves, when two change places, or when a sign changes. It grows with the root of the
        /// number of rows only, so that the double holds it to 1e-13 of the largest value up to 100 000 rows.
        weighted: f64,
    },
}

/// A column of the program: its summary, and the sizes that differences are shares of.
#[derive(Debug, Clone)]
pub struct Column {
    pub summary: Summary,
    scale: f64,
    scale_of_mean: f64,
}

/// The columns of all runs of the program, by the name of the run.
pub type Runs = BTreeMap<String, BTreeMap<Place, Column>>;

/// The record: the columns of every run, by the name of the run.
pub type Record = BTreeMap<String, BTreeMap<Place, Summary>>;

/// The summaries of the columns of a run.
pub fn summaries(columns: &Columns) -> BTreeMap<Place, Column> {
    columns.iter().map(|(place, cells)| (place.clone(), Column::of(&place.1, cells))).collect()
}

impl Column {
    fn of(name: &str, cells: &[Cell]) -> Self {
        let magnitudes = || cells.iter().filter_map(Cell::number).map(f64::abs);
        let is_share = SHARES.iter().any(|share| name.ends_with(share));
        let least = if is_share { 1.0 } else { f64::MIN_POSITIVE };
        let largest = magnitudes().fold(least, f64::max);
        if let [cell] = cells {
            return Self { summary: Summary::One(cell.clone()), scale: largest, scale_of_mean: largest };
        }
        let scale = if largest > f64::MIN_POSITIVE { largest } else { 1.0 };
        let count = u32::try_from(magnitudes().count()).unwrap();
        let mean = accurate_sum(magnitudes()) / f64::from(count.max(1));
        let value = |cell: &Cell| cell.number().unwrap_or_else(|| scale * of_text(cell));
        let weighted = accurate_sum((0..).zip(cells).map(|(row, cell)| weight(row) * value(cell)));
        Self { summary: Summary::Many { rows: cells.len(), mean, weighted }, scale, scale_of_mean: mean.max(least) }
    }
}

/// Plus or minus a number from 1 to 2 that looks random: SplitMix64 of the row.
fn weight(row: u64) -> f64 {
    let mut bits = (row + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    let magnitude = f64::from_bits(1.0_f64.to_bits() | (bits >> 12));
    if bits & 1 == 0 { magnitude } else { -magnitude }
}

/// A number from 1 to 2 for a word or an empty cell.
fn of_text(cell: &Cell) -> f64 {
    let text = if let Cell::Word(word) = cell { word } else { "(empty)" };
    1.0 + f64::from(crc32fast::hash(text.as_bytes())) / f64::from(u32::MAX)
}

/// Neumaier's sum, whose error does not grow with the number of terms.
fn accurate_sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut lost) = (0.0_f64, 0.0);
    for term in terms {
        let next = sum + term;
        lost += if sum.abs() >= term.abs() { (sum - next) + term } else { (term - next) + sum };
        sum = next;
    }
    sum + lost
}

/// The differences from the record, with a line for each column. A column that is not in the record is ignored.
pub fn differences(record: &Record, now: &Runs) -> Vec<String> {
    let mut differences = Vec::new();
    for (run, recorded) in record {
        let Some(columns) = now.get(run) else {
            differences.push(format!("{run}: this run is in the record, but there is no such scenario or variant"));
            continue;
        };
        for ((file, name), before) in recorded {
            let what = match columns.get(&(file.clone(), name.clone())) {
                None => Some("is missing".to_owned()),
                Some(after) => {
                    let loose = LOOSE.iter().find(|(part, _)| *part == name || run.starts_with(part));
                    change(before, after, loose.map_or(TOLERANCE, |(_, tolerance)| *tolerance))
                }
            };
            differences.extend(what.map(|what| format!("{run} · {file} · {name}: {what}")));
        }
    }
    let unknown = now.iter().filter(|(run, columns)| !record.contains_key(*run) && !columns.is_empty());
    differences.extend(unknown.map(|(run, _)| format!("{run}: this run is not in the record; write the record anew")));
    differences
}

/// How much a column moved, if that is more than the tolerance.
fn change(before: &Summary, after: &Column, tolerance: f64) -> Option<String> {
    let apart = |was: f64, is: f64, scale: f64| {
        let share = (is - was).abs() / scale;
        (share > tolerance).then(|| format!("{is:?} instead of {was:?}: a difference of {share:.1e}"))
    };
    match (before, &after.summary) {
        (Summary::One(Cell::Number(was)), Summary::One(Cell::Number(is))) => apart(*was, *is, after.scale),
        (Summary::One(was), Summary::One(is)) => (was != is).then(|| format!("{is:?} instead of {was:?}")),
        (
            Summary::Many { rows, mean, weighted },
            Summary::Many { rows: rows_now, mean: mean_now, weighted: weighted_now },
        ) if rows == rows_now => {
            let all = apart(*mean, *mean_now, after.scale_of_mean).map(|what| format!("the mean magnitude is {what}"));
            all.or_else(|| {
                apart(*weighted, *weighted_now, after.scale).map(|what| format!("the weighted sum is {what}"))
            })
        }
        (was, is) => Some(format!("{} rows instead of {}", is.rows(), was.rows())),
    }
}

impl Summary {
    fn rows(&self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Many { rows, .. } => *rows,
        }
    }
}

/// Reads the record.
pub fn read(text: &str) -> Record {
    let mut record = Record::new();
    for (run, file, columns) in serde_json::from_str::<Vec<(String, String, BTreeMap<String, Summary>)>>(text).unwrap()
    {
        let places = columns.into_iter().map(|(name, summary)| ((file.clone(), name), summary));
        record.entry(run).or_default().extend(places);
    }
    record
}

/// The text of the record, with a line for each file of a run.
pub fn to_text(runs: &Runs) -> String {
    let mut files: BTreeMap<(&str, &str), BTreeMap<&str, &Summary>> = BTreeMap::new();
    for (run, columns) in runs {
        for ((file, name), column) in columns {
            files.entry((run, file)).or_default().insert(name, &column.summary);
        }
    }
    let line = |((run, file), columns): (&(&str, &str), _)| serde_json::to_string(&(run, file, columns)).unwrap();
    format!("[\n{}\n]\n", files.iter().map(line).collect::<Vec<_>>().join(",\n"))
}
