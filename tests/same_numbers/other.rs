//! Differences between the numbers of two programs.

use super::numbers::{Cell, Columns};

/// The differences in a run, with a line for each column.
pub fn differences(run: &str, theirs: &Columns, ours: &Columns) -> Vec<String> {
    let line = |((file, name), theirs): (&(String, String), &Vec<Cell>)| {
        let what = match ours.get(&(file.clone(), name.clone())) {
            None => Some("is missing".to_owned()),
            Some(ours) if ours.len() != theirs.len() => {
                Some(format!("{} rows instead of {}", ours.len(), theirs.len()))
            }
            Some(ours) => moved(theirs, ours),
        };
        what.map(|what| format!("{run} · {file} · {name}: {what}"))
    };
    theirs.iter().filter_map(line).collect()
}

/// The number of values that differ, and the largest difference of two numbers: over the larger of both, and over the
/// largest number of the column, which is more useful if a number is nearly zero.
fn moved(theirs: &[Cell], ours: &[Cell]) -> Option<String> {
    let (mut count, mut words) = (0, 0);
    let (mut relative, mut absolute, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (their, our) in theirs.iter().zip(ours) {
        match (their, our) {
            (Cell::Number(their), Cell::Number(our)) => {
                let size = their.abs().max(our.abs());
                largest = largest.max(size);
                if their.to_bits() != our.to_bits() {
                    count += 1;
                    let apart = (their - our).abs();
                    absolute = absolute.max(apart);
                    relative = relative.max(if size > 0.0 { apart / size } else { 0.0 });
                }
            }
            (their, our) if their != our => words += 1,
            _ => {}
        }
    }
    let numbers = || {
        let of_column = absolute / largest;
        format!("{count} of {} values differ, relative {relative:.1e}, over the largest {of_column:.1e}", ours.len())
    };
    match (count, words) {
        (0, 0) => None,
        (0, _) => Some(format!("{words} words or empty cells differ")),
        (_, 0) => Some(numbers()),
        (..) => Some(format!("{}; {words} words or empty cells differ", numbers())),
    }
}
