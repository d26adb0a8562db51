//! Measurements: a CSV file, read and checked line by line.
//!
//! Every line is one impact, or one point of an indentation curve. The name of a column says its quantity and ends in
//! its unit: `speed_m_per_s`, `drop_height_mm`, `restitution`, `dent_diameter_um`. A column may hold
//!
//! * a measured quantity (see [`MeasuredQuantity`]); if a field is empty, the quantity was not measured;
//! * the standard deviation of a measured quantity: the name of the quantity with `_sd` at the end;
//! * any numeric key of the scenario that changes from line to line, such as `sphere_radius_mm`; `speed` and
//!   `drop_height` are the keys of `[impact]`;
//! * `indentation` or `force` of an indentation curve, point after point. The order of the points shows loading and
//!   unloading;
//! * `bounce_interval`: the time from this first contact to the next. The speed or drop height of the next line may then be empty:
//!   it follows from the interval;
//! * `note`, which is ignored.
//!
//! Lines that begin with `#` are comments.

use crate::error::{Details, Error};
use crate::scenario::input::{MeasuredQuantity, NUMERIC_KEYS, NumericKey};
use crate::scenario::keys::Quantity;
use crate::scenario::keys::quantity::{INDENTATION, LOAD};
use crate::strings::csv::{CsvError, CsvReader};
use crate::strings::did_you_mean;
use crate::units::{Dimension, parse};

/// Makes errors of the file of measurements `name`, with the line.
pub(super) fn csv_file_error(name: &str) -> impl Fn(CsvError) -> Error + Copy {
    move |(line, message)| {
        let at = line.map(|line| format!(":{line}")).unwrap_or_default();
        let error = Error::input(format!("{name}{at}: {message}"));
        error.with_details(Details { message: Some(message), file: Some(name.to_owned()), line, ..Details::default() })
    }
}

/// A measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredValue {
    pub row: usize,
    /// The kind of measurement.
    pub quantity: MeasuredQuantity,
    /// The value in SI units.
    pub value: f64,
    /// Standard deviation, SI, if the data give it.
    pub deviation: Option<f64>,
}

/// One line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeasurementRow {
    /// Number of the line in the file, counted from 1.
    pub line: u64,
    /// Values of the keys that are columns, SI.
    pub keys: Vec<f64>,
    /// Indentation of a point of an indentation curve \[m\].
    pub indentation: Option<f64>,
    /// The interval before \[s\], which gives the speed of an impact whose own is empty: its key is not a number.
    pub preceding_interval: Option<f64>,
}

/// The measurements.
#[derive(Debug, Clone, Default)]
pub struct MeasurementData {
    pub name: String,
    pub keys: Vec<NumericKey>,
    /// The rows in the order of the file.
    pub rows: Vec<MeasurementRow>,
    /// The values, row after row.
    pub values: Vec<MeasuredValue>,
}

/// The use of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ColumnRole {
    Key(usize),
    Measured(MeasuredQuantity),
    Deviation(MeasuredQuantity),
    Indentation,
}

struct DataColumn {
    name: String,
    role: ColumnRole,
    quantity: Quantity,
    /// The unit as `units` spells it; empty for SI units.
    unit: String,
}

impl MeasurementData {
    /// The data of one impact, from names and values of the measured quantities.
    pub fn single_impact(name: &str, numbers: &[(String, f64)]) -> Self {
        let value = |(name, value): &(String, f64)| {
            Some(MeasuredValue { row: 0, quantity: MeasuredQuantity::from_name(name)?, value: *value, deviation: None })
        };
        let values = numbers.iter().filter_map(value).collect();
        Self { name: name.to_owned(), keys: Vec::new(), rows: vec![MeasurementRow::default()], values }
    }

    /// The rows are then points of an indentation curve, not impacts.
    pub fn is_curve(&self) -> bool {
        self.values.iter().any(|value| value.quantity == MeasuredQuantity::Force)
    }

    /// The quantities that were measured, in the order of [`Measured::ALL`].
    pub fn measured_quantities(&self) -> Vec<MeasuredQuantity> {
        MeasuredQuantity::ALL
            .into_iter()
            .filter(|quantity| self.values.iter().any(|value| value.quantity == *quantity))
            .collect()
    }

    /// For every value the number that its relative errors refer to: the value itself, or for a curve its largest force,
    /// because a force may be zero.
    pub fn error_scales(&self) -> Vec<f64> {
        let largest = self.values.iter().map(|value| value.value).fold(0.0, f64::max);
        self.values
            .iter()
            .map(|value| if value.quantity == MeasuredQuantity::Force { largest } else { value.value })
            .collect()
    }

    /// Reads measurements from a text. Messages use `name` for the file.
    pub fn parse(name: &str, text: &str) -> Result<Self, Error> {
        let refused = csv_file_error(name);
        let table = CsvReader::new(text).map_err(refused)?;
        let mut data = Self { name: name.to_owned(), ..Self::default() };
        let columns = data.columns(&table.header).map_err(|message| refused((table.line, message)))?;
        for row in table.rows() {
            let (line, record) = row.map_err(refused)?;
            data.row(line, &record, &columns).map_err(|message| refused((Some(line), message)))?;
        }
        if data.values.is_empty() {
            return Err(refused((None, "contains no data rows".to_owned())));
        }
        Ok(data)
    }

    /// The columns; `None` for a note.
    fn columns(&mut self, header: &csv::StringRecord) -> Result<Vec<Option<DataColumn>>, String> {
        let mut columns: Vec<Option<DataColumn>> = Vec::new();
        for name in header {
            let column = if name == "note" { None } else { Some(self.column(name)?) };
            let is_same = |other: &DataColumn| column.as_ref().is_some_and(|column| column.role == other.role);
            if columns.iter().flatten().any(is_same) {
                return Err(format!(
                    "duplicate column `{name}` (or a second column for the same quantity). Remove one."
                ));
            }
            columns.push(column);
        }
        let has = |role: ColumnRole| columns.iter().flatten().any(|column| column.role == role);
        for column in columns.iter().flatten() {
            if let ColumnRole::Deviation(quantity) = column.role
                && !has(ColumnRole::Measured(quantity))
            {
                return Err(format!("the column `{}` requires a column `{}`", column.name, quantity.name()));
            }
        }
        let is_impact = MeasuredQuantity::ALL
            .into_iter()
            .any(|quantity| quantity != MeasuredQuantity::Force && has(ColumnRole::Measured(quantity)));
        match (has(ColumnRole::Indentation), has(ColumnRole::Measured(MeasuredQuantity::Force))) {
            (true, true) | (false, false) if is_impact != has(ColumnRole::Indentation) => Ok(columns),
            (false, false) => Err(format!("no column is a measured quantity; {}", column_names())),
            (true, true) => {
                Err("a file contains impacts or an indentation curve, not both. Make two files.".to_owned())
            }
            _ => Err("an indentation curve has the columns indentation_m and force_N".to_owned()),
        }
    }

    fn column(&mut self, name: &str) -> Result<DataColumn, String> {
        let (base, is_deviation) = name.strip_suffix("_sd").map_or((name, false), |base| (base, true));
        let measured = MeasuredQuantity::ALL
            .into_iter()
            .map(|one| (one.name().to_owned(), ColumnRole::Measured(one), one.quantity()));
        let alias = |key: NumericKey| match key.path().split_once('.') {
            Some(("impact", short)) => short.to_owned(),
            _ => key.path().replace('.', "_"),
        };
        let keys = NUMERIC_KEYS.iter().enumerate().map(|(at, key)| (alias(*key), ColumnRole::Key(at), key.quantity()));
        let known = measured.chain([("indentation".to_owned(), ColumnRole::Indentation, &INDENTATION)]).chain(keys);
        let plain = base.replace('.', "_");
        let plain = plain.strip_prefix("impact_").unwrap_or(&plain);
        // the longest name that fits, because one name may be the beginning of another
        let fitting = known.filter_map(|(known, role, quantity)| {
            let unit = plain.strip_prefix(known.as_str()).filter(|unit| unit.is_empty() || unit.starts_with('_'))?;
            let unit = unit.trim_start_matches('_').replace("_per_", "/");
            Some((known, role, quantity, unit))
        });
        let Some((known, role, quantity, unit)) = fitting.max_by_key(|(known, ..)| known.len()) else {
            let plain = plain_column(name);
            if plain != name && self.column(&plain).is_ok() {
                return Err(format!("unknown column `{name}`, did you mean `{plain}`?"));
            }
            let names: Vec<&str> =
                MeasuredQuantity::ALL.iter().map(|one| one.name()).chain(["speed", "drop_height"]).collect();
            return Err(format!("unknown column `{name}`{}", did_you_mean(base, names, '`', &column_names())));
        };
        let dimension = quantity.dimension;
        let example = format!("{known}{}{}", dimension.suffix(), if is_deviation { "_sd" } else { "" });
        if unit.is_empty() && dimension != Dimension::Ratio {
            return Err(format!("the column `{name}` has no unit. Write {example}"));
        }
        if !unit.is_empty() && parse(&format!("1 {unit}"), dimension).is_err() {
            let message = format!("the column `{name}` ends in `{unit}`, which is not a unit of {}", dimension.name());
            return Err(format!("{message}. Write {example}, or another unit"));
        }
        let quantity = match role {
            _ if is_deviation => crate::scenario::keys::quantity::positive_quantity(dimension),
            // the force of a curve may be 0
            ColumnRole::Measured(MeasuredQuantity::Force) => LOAD,
            _ => *quantity,
        };
        let role = match role {
            ColumnRole::Measured(quantity) if is_deviation => ColumnRole::Deviation(quantity),
            _ if is_deviation => return Err(format!("the column `{name}`: only measured quantities have an sd")),
            ColumnRole::Key(at) => {
                self.keys.push(NUMERIC_KEYS[at]);
                ColumnRole::Key(at)
            }
            role => role,
        };
        let unit = if unit == dimension.si_unit() { String::new() } else { unit };
        Ok(DataColumn { name: name.to_owned(), role, quantity, unit })
    }

    fn row(&mut self, line: u64, record: &csv::StringRecord, columns: &[Option<DataColumn>]) -> Result<(), String> {
        // a spreadsheet writes lines of separators alone
        if record.iter().all(str::is_empty) {
            return Ok(());
        }
        let row = self.rows.len();
        let mut read = MeasurementRow { line, keys: Vec::with_capacity(self.keys.len()), ..MeasurementRow::default() };
        let first = self.values.len();
        let mut deviations = Vec::new();
        for (number, (field, column)) in (1..).zip(record.iter().zip(columns)) {
            let Some(column) = column else { continue };
            let refuse = |message: String| format!("column {number}, `{}`: {message}", column.name);
            if field.is_empty() {
                match column.role {
                    ColumnRole::Key(at) if NUMERIC_KEYS[at].path().starts_with("impact.") => {
                        // the line before may have other measured values too, left and right of its interval
                        let is_interval = |value: &&MeasuredValue| {
                            value.row + 1 == row && value.quantity == MeasuredQuantity::BounceInterval
                        };
                        let interval = self.values.iter().rev().find(is_interval);
                        read.preceding_interval = Some(interval.map(|value| value.value).ok_or_else(|| {
                            refuse("is empty. It can be empty only if the line before has a bounce_interval. Give a value.".to_owned())
                        })?);
                        read.keys.push(f64::NAN);
                        continue;
                    }
                    ColumnRole::Deviation(_) => continue,
                    ColumnRole::Measured(quantity) if quantity != MeasuredQuantity::Force => continue,
                    _ => return Err(refuse("is empty. Give a value, or remove the line.".to_owned())),
                }
            }
            let value = column.read(field).map_err(refuse)?;
            match column.role {
                ColumnRole::Key(_) => read.keys.push(value),
                ColumnRole::Indentation => read.indentation = Some(value),
                ColumnRole::Measured(quantity) => {
                    self.values.push(MeasuredValue { row, quantity, value, deviation: None });
                }
                ColumnRole::Deviation(quantity) => deviations.push((quantity, value)),
            }
        }
        // the column of a standard deviation may stand before that of its quantity
        for (quantity, deviation) in deviations {
            if let Some(value) = self.values[first..].iter_mut().find(|value| value.quantity == quantity) {
                value.deviation = Some(deviation);
            }
        }
        if self.values.len() == first {
            return Err("this line contains no measured value. Remove this line.".to_owned());
        }
        self.rows.push(read);
        Ok(())
    }
}

impl DataColumn {
    fn read(&self, field: &str) -> Result<f64, String> {
        let number: f64 = field.parse().map_err(|_| {
            let hint = match (field.contains(','), field.contains('.')) {
                (true, true) => ". Write no thousands separator, such as 1000.5 or 1000,5",
                (true, false) => ". Write a decimal point, not a comma",
                _ => "",
            };
            format!("\"{field}\" is not a number{hint}")
        })?;
        let value = if self.unit.is_empty() {
            number
        } else {
            parse(&format!("{field} {}", self.unit), self.quantity.dimension).map_err(|error| error.to_string())?
        };
        self.quantity.check(value)
    }
}

/// A name such as "Drop height (mm)" as a column of this program is called: "drop_height_mm".
fn plain_column(name: &str) -> String {
    let (words, unit) = name.split_once(['(', '[']).map_or((name, ""), |(words, unit)| (words, unit));
    let unit = unit.trim_end_matches([')', ']', ' ']).replace('/', "_per_");
    let words = words.trim().to_lowercase().replace([' ', '-'], "_");
    if unit.is_empty() { words } else { format!("{words}_{unit}") }
}

/// The names that columns may have, for messages.
fn column_names() -> String {
    let names = MeasuredQuantity::ALL.map(|one| format!("{}{}", one.name(), one.quantity().dimension.suffix()));
    format!(
        "columns are speed_m_per_s, drop_height_m, {}, indentation_m, each of the measured ones with _sd at the end, the numeric keys of a scenario such as sphere_radius_m, and note",
        names.join(", ")
    )
}
