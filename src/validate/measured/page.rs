//! The section on measured sets of the page of `validate`.

use std::fmt::Write as _;

use super::friction_models::friction_models;
use super::impacts::{contact_of, impacts_of, loses_by_dent, sets_of_two_balls};
use super::sticking::sticking_restitution;
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::reference::measured::{MeasuredSet, measured_sets};
use crate::strings::markdown_table;
use crate::validate::comparison::mean;

fn row<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_owned).to_vec()
}

/// The table of all sets.
fn set_table(sets: &[MeasuredSet]) -> String {
    let mut rows = vec![row(["set", "rows", "compared", "file"])];
    rows.extend(sets.iter().map(|set| {
        let compared = if set.compared_columns().is_empty() { "no, shown only" } else { "yes" };
        let (title, count) = (set.short_field("title"), set.rows.len().to_string());
        row([title, &count, compared, &format!("[{0}](../../src/reference/measured/{0})", set.file)])
    }));
    markdown_table(&rows)
}

/// The models of friction beside the sets of two balls, and the scatter of their restitution.
fn friction_table(sets: &[MeasuredSet], coefficients: &PlmCoefficients) -> Result<String, Error> {
    let mut text = String::new();
    for set in sets_of_two_balls(sets) {
        let impacts = impacts_of(set, coefficients)?;
        let (models, partial) = friction_models(&impacts)?;
        let all = format!("all {}", impacts.len());
        let mut rows =
            vec![row(["rms deviation of the tangential speed, m/s", &all, &format!("{partial} with partial slip")])];
        rows.extend(
            models
                .iter()
                .map(|model| row([model.name, &format!("{:.4}", model.all), &format!("{:.4}", model.partial_slip)])),
        );
        let restitutions: Vec<f64> = impacts.iter().map(|impact| impact.row.number("restitution")).collect();
        let average = mean(&restitutions);
        let squares: f64 = restitutions.iter().map(|e| (e - average) * (e - average)).sum();
        let sd = (squares / (restitutions.len() as f64 - 1.0)).sqrt();
        text += &markdown_table(&rows);
        let _ = writeln!(
            text,
            "\nScatter of the experiment: the measured e is {average:.3} with a standard deviation of {sd:.3}."
        );
    }
    Ok(text)
}

/// β_0 of each pair, measured and by the program.
fn sticking_table(sets: &[MeasuredSet], coefficients: &PlmCoefficients) -> Result<String, Error> {
    let mut rows = vec![row(["pair", "computed loss", "β₀ measured", "slope", "largest", "overlap"])];
    for set in sets {
        for one in set.rows.iter().filter(|one| one.optional_number("sticking_restitution").is_some()) {
            // a pair with a dent is computed without one too
            let losses: &[bool] = if loses_by_dent(one) { &[true, false] } else { &[false] };
            for has_dent in losses {
                let Some((contact, approach)) = contact_of(set, one, coefficients, *has_dent)? else { continue };
                let Some(found) = sticking_restitution(&contact, approach)? else { continue };
                let [measured, spread] =
                    ["sticking_restitution", "sticking_restitution_pm"].map(|name| one.number(name));
                let overlaps = measured - spread <= found.largest && found.slope <= measured + spread;
                rows.push(row([
                    one.cell_text("case"),
                    if *has_dent { "dent" } else { "none" },
                    &format!("{measured:.2} ± {spread:.2}"),
                    &format!("{:.3}", found.slope),
                    &format!("{:.3}", found.largest),
                    if overlaps { "yes" } else { "no" },
                ]));
            }
        }
    }
    Ok(markdown_table(&rows))
}

/// The section.
pub fn section(coefficients: &PlmCoefficients) -> Result<String, Error> {
    let sets = measured_sets()?;
    let (friction, sticking) = (friction_table(&sets, coefficients)?, sticking_table(&sets, coefficients)?);
    Ok(format!(
        include_str!("page.md"),
        sets = set_table(&sets).trim_end(),
        friction = friction.trim_end(),
        sticking = sticking.trim_end()
    ))
}
