//! The results of a run for people, as blocks: terminal and Python print the text of the blocks, and the web page shows lists and tables.

use serde::Serialize;

use crate::strings::align_columns;

/// A part of what people read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Block {
    Sentence(String),
    /// Lines of a name, its value and perhaps remarks. A line of empty cells is between two groups of lines.
    List(Vec<Vec<String>>),
    Table {
        /// The first row has the names of the columns.
        rows: Vec<Vec<String>>,
        /// The number of columns, from the first on, that the text aligns at the left. The text aligns the others at the right.
        #[serde(skip)]
        left_columns: usize,
    },
    EmptyLine,
}

impl Block {
    pub fn list<L: Into<Vec<String>>>(lines: impl IntoIterator<Item = L>) -> Self {
        Self::List(lines.into_iter().map(Into::into).collect())
    }

    pub fn table<R: Into<Vec<String>>>(rows: impl IntoIterator<Item = R>, left_columns: usize) -> Self {
        Self::Table { rows: rows.into_iter().map(Into::into).collect(), left_columns }
    }

    fn to_text(&self) -> String {
        match self {
            Self::Sentence(sentence) => format!("{sentence}\n"),
            Self::List(lines) => align_columns(lines, |_| true),
            Self::Table { rows, left_columns } => align_columns(rows, |column| column < *left_columns),
            Self::EmptyLine => "\n".to_owned(),
        }
    }
}

pub fn to_text(blocks: &[Block]) -> String {
    blocks.iter().map(Block::to_text).collect()
}

/// Notes below the results, a paragraph each.
pub fn note_blocks(notes: &[String]) -> Vec<Block> {
    notes.iter().flat_map(|note| [Block::EmptyLine, Block::Sentence(note.clone())]).collect()
}
