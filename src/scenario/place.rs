//! Where a refused value stands, shown with its line and a mark under it.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

/// Characters of a long line that are shown.
const WIDTH: usize = 120;

/// Longer keys and messages quote a value that nobody wrote by hand; the middle of it is left out.
const LONGEST_KEY: usize = 200;
const LONGEST_MESSAGE: usize = 1800;

/// At most about `longest` characters of a text: its beginning and its end, where the way out stands.
fn shortened(text: &str, longest: usize) -> Cow<'_, str> {
    let count = text.chars().count();
    if count <= longest {
        return Cow::Borrowed(text);
    }
    let head: String = text.chars().take(longest / 10).collect();
    let tail: String = text.chars().skip(count - longest / 2).collect();
    Cow::Owned(format!("{head} [...] {tail}"))
}

/// Where something is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File {
        /// As given on the command line.
        name: String,
    },
    /// A place in the file.
    Text {
        /// As given on the command line.
        name: String,
        /// From 1.
        line: usize,
        /// From 1, in characters.
        column: usize,
        /// The line, or the part of it around the column.
        excerpt: String,
        /// Characters of the excerpt before the mark.
        indent: usize,
        /// Characters marked.
        width: usize,
    },
    /// A `--set` of the command line.
    Override {
        /// As given.
        text: String,
    },
}

impl Place {
    /// The place of `span` (bytes) in a text.
    pub(super) fn in_text(name: &str, text: &str, span: &Range<usize>) -> Self {
        let mut start = span.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let column = before[line_start..].chars().count();
        let content = text[line_start..].split(['\n', '\r']).next().unwrap_or_default();
        let skipped = if column < WIDTH / 2 { 0 } else { column - WIDTH / 4 };
        // control characters would move the mark, or the terminal
        let visible = |c: char| if c.is_control() { ' ' } else { c };
        let excerpt: String = content.chars().skip(skipped).take(WIDTH).map(visible).collect();
        let indent = column - skipped;
        let marked =
            text.get(start..span.end).map_or(1, |marked| marked.lines().next().unwrap_or_default().chars().count());
        let room = excerpt.chars().count().saturating_sub(indent);
        Self::Text {
            name: name.to_owned(),
            line: 1 + before.matches('\n').count(),
            column: column + 1,
            excerpt,
            indent,
            width: marked.min(room).max(1),
        }
    }
}

/// A value that is refused, where it stands, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// Where.
    pub place: Place,
    /// The dotted key; empty for the whole file.
    pub key: String,
    /// Value, allowed range, way out.
    pub message: String,
    /// Others that were found with it.
    pub others: Vec<Refusal>,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::File { name } => write!(f, "{name}: ")?,
            Place::Text { name, line, column, .. } => write!(f, "{name}:{line}:{column}: ")?,
            Place::Override { text } => write!(f, "--set {text}: ")?,
        }
        if !self.key.is_empty() {
            write!(f, "{}: ", shortened(&self.key, LONGEST_KEY))?;
        }
        f.write_str(&shortened(&self.message, LONGEST_MESSAGE))?;
        if let Place::Text { line, excerpt, indent, width, .. } = &self.place {
            let gutter = line.to_string().len();
            write!(f, "\n{:gutter$} |\n{line} | {excerpt}\n{:gutter$} | {:indent$}{}", "", "", "", "^".repeat(*width))?;
        }
        self.others.iter().try_for_each(|other| write!(f, "\n{other}"))
    }
}
