//! Impacts of independent programs (`tests/reference`): a row has the keys of a scenario and the results of it.

use std::collections::BTreeMap;

use plm_impact::impact::Contact;
use plm_impact::scenario::input::Input;
use serde::de::DeserializeOwned;

/// The cells of a row that are not empty, by the names of their columns.
#[derive(Debug)]
pub struct Row(BTreeMap<String, String>);

/// The rows of a CSV text with comments.
pub fn records<T: DeserializeOwned>(text: &str) -> Vec<T> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}

pub fn rows(text: &str) -> Vec<Row> {
    let filled = |mut row: BTreeMap<String, String>| {
        row.retain(|_, cell| !cell.is_empty());
        Row(row)
    };
    records(text).into_iter().map(filled).collect()
}

impl Row {
    pub fn name(&self) -> &str {
        &self.0["case"]
    }

    pub fn cell_text(&self, column: &str) -> &str {
        &self.0[column]
    }

    /// A number; none where the cell is empty.
    pub fn optional_number(&self, column: &str) -> Option<f64> {
        self.0.get(column).map(|cell| cell.parse().unwrap_or_else(|_| panic!("{column} of {self:?}")))
    }

    #[track_caller]
    pub fn number(&self, column: &str) -> f64 {
        self.optional_number(column).unwrap_or_else(|| panic!("{column} of {self:?}"))
    }

    /// The keys that the row sets, but for those that begin with one of these words.
    pub fn keys(&self, without: &[&str]) -> Vec<String> {
        let is_kept = |name: &str| name.contains('.') && !without.iter().any(|begin| name.starts_with(begin));
        self.0.iter().filter(|(name, _)| is_kept(name)).map(|(name, cell)| format!("{name}={cell}")).collect()
    }

    pub fn scene(&self) -> Input {
        super::scene("", &self.keys(&[]))
    }

    pub fn contact(&self) -> Contact {
        self.scene().contact().unwrap()
    }
}
