//! Measured impacts: every CSV file of this folder is one set. `validate` has the section "Add a measured set" on its page.
//!
//! The head of a file has lines `# FIELD: text`, which continue on lines that begin with `#` and three spaces. [`FIELDS`] are required.
//! Two more fields make comparisons of a set:
//!
//! ```text
//! # keys: sphere.radius=1e-3; friction.coefficient=0.1            keys of a scenario that all rows have
//! # compare COLUMN: name of the quantity                          relative deviation
//! # compare difference COLUMN: name of the quantity               deviation as a difference
//! ```
//!
//! Columns whose names have a dot are keys of a scenario too. A row without a Young's modulus is not computed.

use super::{ReferenceRow, ReferenceTable, damaged_table};
use crate::error::Error;

/// The required fields of the head.
pub const FIELDS: [&str; 7] = ["title", "source", "measured", "units", "spread", "body", "doubts"];

/// The files of this folder with their texts.
const FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/measured_sets.rs"));

/// A set of measured impacts.
#[derive(Debug, Clone)]
pub struct MeasuredSet {
    pub file: &'static str,
    /// Fields of the head with the lines of their texts.
    fields: Vec<(&'static str, Vec<&'static str>)>,
    pub rows: Vec<ReferenceRow>,
}

/// A column of a set that is compared.
#[derive(Debug, Clone, Copy)]
pub struct ComparedColumn {
    pub column: &'static str,
    /// The name of the quantity in tables.
    pub quantity: &'static str,
    /// True if the deviation is a difference.
    pub is_difference: bool,
}

/// All sets, in the order of their files.
///
/// # Errors
/// [`Error`] if a file is damaged, or if its head lacks a field.
pub fn measured_sets() -> Result<Vec<MeasuredSet>, Error> {
    FILES.iter().map(|(file, text)| MeasuredSet::from_text(file, text)).collect()
}

impl MeasuredSet {
    /// # Errors
    /// [`Error`] if the table is damaged, or if the head lacks a field.
    pub fn from_text(file: &'static str, text: &'static str) -> Result<Self, Error> {
        let mut fields: Vec<(&str, Vec<&str>)> = Vec::new();
        for line in text.lines().map_while(|line| line.strip_prefix('#')) {
            match (line.strip_prefix("   "), fields.last_mut(), line.split_once(": ")) {
                (Some(more), Some((_, texts)), _) => texts.push(more.trim()),
                (None, _, Some((name, text))) => fields.push((name.trim(), vec![text.trim()])),
                _ => return Err(damaged_table(file, &format!("the line \"#{line}\" is not a field of the header"))),
            }
        }
        let set = Self { file, fields, rows: ReferenceTable(file, text).rows()? };
        match FIELDS.iter().find(|field| set.field(field).is_empty()) {
            Some(field) => Err(damaged_table(file, &format!("the head lacks \"# {field}: ...\""))),
            None => Ok(set),
        }
    }

    /// The text of a field; empty if the head does not have the field.
    pub fn field(&self, name: &str) -> String {
        let found = self.fields.iter().find(|(field, _)| *field == name);
        found.map_or_else(String::new, |(_, texts)| texts.join(" "))
    }

    /// The first line of a field.
    pub fn short_field(&self, name: &str) -> &'static str {
        let found = self.fields.iter().find(|(field, _)| *field == name);
        found.and_then(|(_, texts)| texts.first()).copied().unwrap_or_default()
    }

    /// The columns that are compared, in the order of the head.
    pub fn compared_columns(&self) -> Vec<ComparedColumn> {
        let compared = self.fields.iter().filter_map(|(name, texts)| {
            let column = name.strip_prefix("compare ")?;
            let difference = column.strip_prefix("difference ");
            let (column, is_difference) = (difference.unwrap_or(column), difference.is_some());
            Some(ComparedColumn { column, quantity: texts.first()?, is_difference })
        });
        compared.collect()
    }

    /// The keys of the scenario of a row.
    pub fn keys(&self, row: &ReferenceRow) -> Vec<String> {
        let common = self.field("keys");
        let common = common.split(';').map(str::trim).filter(|key| !key.is_empty()).map(str::to_owned);
        common.chain(row.keys()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "# title: a\n# source: b\n# measured: c\n#   d\n# units: e\n# spread: f\n# body: g\n";

    #[test]
    fn every_file_of_the_folder_is_a_set() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/reference/measured");
        let mut names: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "csv"))
            .map(|path| path.file_name().unwrap().to_string_lossy().into_owned())
            .collect();
        names.sort();
        let sets = measured_sets().unwrap();
        assert!(sets.iter().all(|set| !set.rows.is_empty()));
        assert_eq!(names, sets.iter().map(|set| set.file).collect::<Vec<_>>());
    }

    #[test]
    fn incomplete_head_is_an_error() {
        let text = |head: String| -> &'static str { Box::leak((head + "case,restitution\n1,0.5\n").into_boxed_str()) };
        let whole = MeasuredSet::from_text("x.csv", text(format!("{HEAD}# doubts: h\n"))).unwrap();
        assert_eq!((whole.field("measured").as_str(), whole.short_field("measured")), ("c d", "c"));
        let lacks = MeasuredSet::from_text("x.csv", text(HEAD.to_owned())).unwrap_err().to_string();
        assert!(lacks.contains("x.csv") && lacks.contains("# doubts: "), "{lacks}");
        let loose = MeasuredSet::from_text("x.csv", text(format!("{HEAD}# doubts: h\n# no field\n"))).unwrap_err();
        assert!(loose.to_string().contains("no field"), "{loose}");
    }
}
