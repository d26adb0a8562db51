//! Tables as text, for the terminal and for pages.

use std::fmt::Write as _;

/// Lines of cells, each column as wide as its widest cell. Columns whose number `is_left` accepts are
/// aligned at the left, others at the right.
pub fn align_columns<R: AsRef<[String]>>(rows: &[R], is_left: impl Fn(usize) -> bool) -> String {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows {
        for (i, cell) in row.as_ref().iter().enumerate() {
            let width = cell.chars().count();
            match widths.get_mut(i) {
                Some(widest) => *widest = width.max(*widest),
                None => widths.push(width),
            }
        }
    }
    let mut text = String::new();
    for row in rows {
        let cells = row.as_ref().iter().zip(&widths).enumerate();
        let cells = cells.map(
            |(i, (cell, width))| {
                if is_left(i) { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            },
        );
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text
}

/// The rows as a table in Markdown. The first row has the names of the columns.
pub fn markdown_table<R: AsRef<[String]>>(rows: &[R]) -> String {
    let mut text = String::new();
    for (i, row) in rows.iter().enumerate() {
        let cells: Vec<String> = row.as_ref().iter().map(|cell| cell.replace('|', "\\|")).collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
        if i == 0 {
            let _ = writeln!(text, "{}|", "|---".repeat(cells.len()));
        }
    }
    text
}
