//! All units that a scenario, a column of measurements and the command line may have, by quantity.

use crate::contact::strength::hardness::HardnessScale;
use crate::strings::align_columns;
use crate::units::{Dimension, format_number, parse};

/// Rows of quantity, SI unit and units; the first row has the names of the columns.
pub fn unit_rows() -> Vec<[String; 3]> {
    let head = ["quantity", "SI unit", "units"].map(str::to_owned);
    let row = |dimension: &Dimension| {
        let name = dimension.name().trim_start_matches("an ").trim_start_matches("a ").to_owned();
        let units = dimension.unit_names().map(|unit| with_size(unit, *dimension)).collect::<Vec<_>>().join(", ");
        [name, dimension.si_unit().to_owned(), units]
    };
    [head].into_iter().chain(Dimension::ALL.iter().map(row)).chain([hardness()]).collect()
}

/// A unit, with its size where that is no power of ten of the SI unit.
fn with_size(unit: &str, dimension: Dimension) -> String {
    let size = parse(&format!("1 {unit}"), dimension).unwrap_or(f64::NAN);
    let is_power_of_ten = format!("{size:e}").starts_with("1e");
    if is_power_of_ten || dimension == Dimension::Ratio {
        return unit.to_owned();
    }
    let rounded = format!("{size:.11e}").parse().unwrap_or(size);
    format!("{unit} ({} {})", format_number(rounded), dimension.si_unit())
}

fn hardness() -> [String; 3] {
    let with_range = |scale: HardnessScale| match scale.range() {
        Some((low, high)) => format!("{} ({} to {})", scale.name(), format_number(low), format_number(high)),
        None => scale.name().to_owned(),
    };
    let scales = HardnessScale::ALL.map(with_range).join(", ");
    ["hardness".to_owned(), "Pa".to_owned(), format!("{scales}; or a mean pressure")]
}

/// The units for the terminal.
pub fn list() -> String {
    format!("{}\n{SPELLINGS}\n", align_columns(&unit_rows(), |_| true))
}

const SPELLINGS: &str = "A size of a ball may be a fraction of an inch: \"1/2 in\", \"1-3/8 in\".
m/s^2 may be m/s² or m/s2; Pa s may be Pa·s; µm may be um. A number without a unit is in SI; an angle needs a unit.";
