//! The report of `validate`: every comparison as CSV, and a summary for the terminal and for a page in Markdown.

use std::fmt::Write as _;

use super::comparison::{Comparison, max_magnitude, mean, rms};
use super::laws::LawDeviations;
use crate::strings::{align_columns, markdown_table};

/// The text of `validation.csv`. Deviations are shares, not per cent.
pub fn csv(compared: &[Comparison]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let has_built_in = compared.iter().any(|one| one.built_in_law.is_some());
    let mut columns = vec!["quantity", "case", "source", "unit", "reference", "law", "deviation"];
    columns.extend(has_built_in.then_some("deviation_of_built_in"));
    writer.write_record(columns)?;
    for Comparison { group, case, reference, law, deviation, built_in_law: of_built_in } in compared {
        let numbers = [Some(reference), Some(law), Some(deviation), of_built_in.as_ref()];
        let words = [group.quantity, case, group.source, group.unit].map(str::to_owned);
        writer.write_record(words.into_iter().chain(numbers.into_iter().flatten().map(f64::to_string)))?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

fn groups(compared: &[Comparison]) -> impl Iterator<Item = &[Comparison]> {
    compared.chunk_by(|a, b| a.group.quantity == b.group.quantity)
}

/// A share in per cent.
fn format_share(value: f64) -> String {
    format!("{:.2} %", 100.0 * value).replace('-', "−")
}

/// A share as [`format_share`] writes it, with a plus sign if it is positive.
fn format_signed(value: f64) -> String {
    if value > 0.0 { format!("+{}", format_share(value)) } else { format_share(value) }
}

/// The names of the columns, and a row for each quantity. If the law has other coefficients than the built-in ones, the
/// last columns are those of the built-in law.
fn summary(compared: &[Comparison]) -> Vec<Vec<String>> {
    let statistics = |deviations: &[f64]| {
        [
            format_signed(mean(deviations)),
            format_share(rms(deviations)),
            format_signed(max_magnitude(deviations.iter().copied())),
        ]
    };
    let row = |group: &[Comparison]| {
        let own: Vec<f64> = group.iter().map(|one| one.deviation).collect();
        let built_in: Vec<f64> = group.iter().filter_map(|one| one.built_in_law).collect();
        let mut row = vec![group[0].group.quantity.to_owned(), own.len().to_string()];
        row.extend(statistics(&own));
        row.extend((!built_in.is_empty()).then(|| statistics(&built_in)).into_iter().flatten());
        row
    };
    let mut names = vec!["quantity", "numbers", "mean", "rms", "largest"];
    if compared.iter().any(|one| one.built_in_law.is_some()) {
        names.extend(["built-in: mean", "rms", "largest"]);
    }
    let names = names.into_iter().map(str::to_owned).collect();
    std::iter::once(names).chain(groups(compared).map(row)).collect()
}

/// The summary for the terminal.
pub fn table(compared: &[Comparison]) -> String {
    align_columns(&summary(compared), |column| column == 0)
}

/// The names of the columns, and a row for every law.
fn law_rows(laws: &[LawDeviations]) -> Vec<[String; 6]> {
    let row = |LawDeviations { name, impacts, rms: [restitution, force, dent, time] }: &LawDeviations| {
        [
            name.clone(),
            impacts.to_string(),
            format_share(*restitution),
            format_share(*time),
            format_share(*force),
            format_share(*dent),
        ]
    };
    let names = ["law", "impacts", "restitution", "contact time", "peak force", "dent depth"].map(str::to_owned);
    std::iter::once(names).chain(laws.iter().map(row)).collect()
}

/// The page of the report: the table of laws, and a table of all comparisons with every source. For the built-in law it
/// also says where the law deviates, and shows the pictures.
pub fn page(compared: &[Comparison], laws: &[LawDeviations], law: &str, is_built_in: bool) -> String {
    let (mut tables, rows) = (String::new(), summary(compared));
    let mut next = 1;
    for of_source in groups(compared).collect::<Vec<_>>().chunk_by(|a, b| a[0].group.source == b[0].group.source) {
        let end = next + of_source.len();
        let table: Vec<_> = rows[..1].iter().chain(&rows[next..end]).cloned().collect();
        next = end;
        let _ =
            writeln!(tables, "\n### Against {}\n\n{}", of_source[0][0].group.source, markdown_table(&table).trim_end());
    }
    let about = if is_built_in { include_str!("built_in_law.md") } else { "" };
    let (numbers, laws) = (compared.len(), markdown_table(&law_rows(laws)));
    format!(include_str!("page.md"), law = law, numbers = numbers, laws = laws, tables = tables, about = about)
}
