//! A refused value as a person sees it: its line with a marker below; and long texts without their middle.

use std::borrow::Cow;
use std::ops::Range;

/// Maximum number of characters of a line that are shown.
const MAX_LINE_WIDTH: usize = 120;

/// A marked part of a text.
pub(in crate::scenario) struct Excerpt {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters.
    pub column: usize,
    /// The marked text, shortened for display.
    pub value: String,
    /// The line, and the marker below the part.
    pub marked_line: String,
}

impl Excerpt {
    /// The part of `span` (bytes).
    pub fn new(text: &str, span: &Range<usize>) -> Self {
        let start = (0..=span.start.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let (line, column) = (1 + before.matches('\n').count(), before[line_start..].chars().count());
        let content = text[line_start..].split(['\n', '\r']).next().unwrap_or_default();
        let skipped = if column < MAX_LINE_WIDTH / 2 { 0 } else { column - MAX_LINE_WIDTH / 4 };
        // control characters would move the marker, or disturb the terminal
        let visible = |c: char| if c.is_control() { ' ' } else { c };
        let shown: String = content.chars().skip(skipped).take(MAX_LINE_WIDTH).map(visible).collect();
        let indent = column - skipped;
        let marked =
            text.get(start..span.end).map_or(1, |marked| marked.lines().next().unwrap_or_default().chars().count());
        let width = marked.min(shown.chars().count().saturating_sub(indent)).max(1);
        let (gutter, mark) = (line.to_string().len(), "^".repeat(width));
        let value = shown.chars().skip(indent).take(width).collect();
        let marked_line = format!("\n{:gutter$} |\n{line} | {shown}\n{:gutter$} | {:indent$}{mark}", "", "", "");
        Self { line, column: column + 1, value, marked_line }
    }
}

/// At most about `longest` characters of a text: its beginning, and its end, which holds the remedy.
pub(in crate::scenario) fn elide_middle(text: &str, longest: usize) -> Cow<'_, str> {
    let count = text.chars().count();
    if count <= longest {
        return Cow::Borrowed(text);
    }
    let head: String = text.chars().take(longest / 10).collect();
    let tail: String = text.chars().skip(count - longest / 2).collect();
    Cow::Owned(format!("{head} [...] {tail}"))
}
