//! Reads the trace of a contact: CSV as measurements have it, or columns between spaces as LAMMPS and MercuryDPM write them, where the names
//! may stand in a comment.

use super::{ContactTrace, MAX_END_FORCE, MIN_STEPS, NO_FORCE, TraceStep};
use crate::strings::csv::{CsvError, CsvReader};
use crate::units::{Dimension, parse};

/// The line, counted from 1, and what is wrong there.
pub type TraceError = CsvError;

/// A column of a trace: its dimension, and the names that codes give it.
struct Column {
    name: &'static str,
    dimension: Dimension,
    aliases: &'static [&'static str],
}

const COLUMNS: [Column; 3] = [
    Column { name: "time", dimension: Dimension::Time, aliases: &["t"] },
    Column {
        name: "indentation",
        dimension: Dimension::Length,
        aliases: &["delta", "d", "overlap", "penetration", "depth", "approach", "deltan", "delta_n"],
    },
    Column {
        name: "force",
        dimension: Dimension::Force,
        aliases: &["f", "fn", "f_n", "fz", "normal_force", "force_normal", "contact_force"],
    },
];

impl Column {
    /// The unit in a name of this column, such as `mm` in "delta_mm" and "Overlap (mm)"; empty without one. `None` for another column.
    fn unit_of(&self, name: &str) -> Option<String> {
        let (words, unit) = name.split_once(['(', '[']).map_or((name, ""), |(words, unit)| (words, unit));
        let words = words.trim().replace([' ', '-'], "_");
        // LAMMPS writes v_ before variables and c_ before computes
        let words = ["v_", "c_"].iter().find_map(|prefix| words.strip_prefix(prefix)).unwrap_or(&words);
        let names = self.aliases.iter().chain([&self.name]);
        let rests =
            names.filter(|alias| words.get(..alias.len()).is_some_and(|start| start.eq_ignore_ascii_case(alias)));
        let mut rests =
            rests.map(|alias| &words[alias.len()..]).filter(|rest| rest.is_empty() || rest.starts_with('_'));
        let shortest = rests.clone().min_by_key(|rest| rest.len())?;
        let unit = if unit.is_empty() {
            shortest.trim_start_matches('_').replace("_per_", "/")
        } else {
            rests.any(str::is_empty).then(|| unit.trim_end_matches([')', ']', ' ']).to_owned())?
        };
        Some(unit)
    }
}

impl ContactTrace {
    /// Reads the trace of one contact.
    ///
    /// # Errors
    /// [`TraceError`] for a text that is no trace of one whole contact.
    pub fn parse(text: &str) -> Result<Self, TraceError> {
        let spaced = with_commas(text);
        let table = CsvReader::new(spaced.as_deref().unwrap_or(text))?;
        let line = table.line;
        let names: Vec<String> = table.header.iter().map(str::to_owned).collect();
        let mut notes = Vec::new();
        let columns = find_columns(&table.header, &mut notes).map_err(|message| (line, message))?;
        let mut steps: Vec<TraceStep> = Vec::new();
        for row in table.rows() {
            let (line, record) = row?;
            if record.iter().all(str::is_empty) {
                continue;
            }
            let mut values = [0.0; 3];
            for (value, (place, scale)) in values.iter_mut().zip(columns) {
                let field = record.get(place).unwrap_or_default();
                let number = field.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(|| {
                    let name = names.get(place).map(String::as_str).unwrap_or_default();
                    let message = format!(
                        "column {}, `{name}`: \"{field}\" is not a number. Give a value, or remove the line.",
                        place + 1
                    );
                    (Some(line), message)
                })?;
                *value = number * scale;
            }
            let [time, indentation, force] = values;
            if let Some(before) = steps.last().filter(|before| before.time >= time) {
                let message = format!(
                    "the time {time:e} s is not later than {:e} s in the line before. Sort the lines, and keep the lines of one contact only.",
                    before.time
                );
                return Err((Some(line), message));
            }
            steps.push(TraceStep { line, time, indentation, force });
        }
        Self::from_steps(steps, notes)
    }

    fn from_steps(mut steps: Vec<TraceStep>, mut notes: Vec<String>) -> Result<Self, TraceError> {
        let largest = steps.iter().map(|step| step.force.abs()).fold(0.0, f64::max);
        if steps.len() < 2 || largest == 0.0 {
            return Err((
                None,
                "contains no step with a force. Write time, indentation and force of every step of a contact."
                    .to_owned(),
            ));
        }
        let total: f64 = steps.iter().map(|step| step.force).sum();
        if total < 0.0 {
            notes.push(
                "the force is negative in contact: the program treats the column as the force on the target".to_owned(),
            );
            for step in &mut steps {
                step.force = -step.force;
            }
        }
        let has_force = |step: &TraceStep| step.force.abs() > NO_FORCE * largest;
        let mut contacts: Vec<[usize; 2]> = Vec::new();
        for (i, _) in steps.iter().enumerate().filter(|(_, step)| has_force(step)) {
            match contacts.last_mut() {
                Some([_, last]) if *last + 1 == i => *last = i,
                _ => contacts.push([i, i]),
            }
        }
        let lines = |[first, last]: [usize; 2]| format!("lines {} to {}", steps[first].line, steps[last].line);
        let contact = match contacts[..] {
            [contact] => contact,
            [first, second, ..] => {
                let message = format!(
                    "has {} contacts: {}, {} and so on. Keep one contact, with the steps without force before and after the contact.",
                    contacts.len(),
                    lines(first),
                    lines(second)
                );
                return Err((Some(steps[second[0]].line), message));
            }
            [] => return Err((None, "contains no step with a force.".to_owned())),
        };
        let [first, last] = contact;
        let n = last - first + 1;
        if n < MIN_STEPS {
            let message = format!(
                "the contact has {n} steps with a force, and at least {MIN_STEPS} are needed. Write every time step, or use a smaller time step."
            );
            return Err((Some(steps[first].line), message));
        }
        let is_cut = |i: usize| steps[i].force.abs() > MAX_END_FORCE * largest;
        for (index, is_end, words) in [(first, first == 0, "begins"), (last, last + 1 == steps.len(), "ends")] {
            if is_end && is_cut(index) {
                let message = format!(
                    "the file {words} inside of the contact. Add the steps without force before and after the contact."
                );
                return Err((Some(steps[index].line), message));
            }
        }
        if steps[..=first + 1].windows(2).next_back().is_none_or(|pair| pair[1].indentation <= pair[0].indentation) {
            let message =
                "the indentation does not rise at first contact. Write the overlap of the bodies, positive in contact.";
            return Err((Some(steps[first].line), message.to_owned()));
        }
        Ok(Self { steps, contact, notes })
    }
}

/// A table between spaces with commas, and with the names in its first line. `None` for a text that has commas, semicolons or tabs.
fn with_commas(text: &str) -> Option<String> {
    let is_data = |line: &str| line.split_whitespace().next().is_some_and(|word| word.parse::<f64>().is_ok());
    let head = text.lines().find(|line| is_data(line))?;
    if head.contains([',', ';', '\t']) {
        return None;
    }
    let n = head.split_whitespace().count();
    let first = text.lines().position(is_data)?;
    let words = |line: &str| line.trim_start_matches('#').split_whitespace().collect::<Vec<_>>().join(",");
    // the last line above the numbers with as many words; the line numbers stay
    let names = text.lines().take(first).collect::<Vec<_>>();
    let names = names.iter().rposition(|line| words(line).split(',').count() == n)?;
    let line = |(i, line): (usize, &str)| match i {
        _ if i == names || (i >= first && !line.starts_with('#')) => words(line),
        _ if i < first => "#".to_owned(),
        _ => line.to_owned(),
    };
    Some(text.lines().enumerate().map(line).collect::<Vec<_>>().join("\n"))
}

/// Where time, indentation and force are, with the factors of their units.
fn find_columns(header: &csv::StringRecord, notes: &mut Vec<String>) -> Result<[(usize, f64); 3], String> {
    let mut found = [(0, 1.0); 3];
    let mut without_unit = Vec::new();
    for (column, found) in COLUMNS.iter().zip(&mut found) {
        let fitting = header.iter().enumerate().filter_map(|(place, name)| Some((place, column.unit_of(name)?)));
        let fitting: Vec<(usize, String)> = fitting.collect();
        let (place, unit) = match &fitting[..] {
            [one] => one,
            [] => {
                let names = header.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                let Column { name, dimension, .. } = column;
                return Err(format!(
                    "no column is the {name}. Name one column {name}{}. The columns are {names}.",
                    dimension.suffix()
                ));
            }
            _ => return Err(format!("more than one column is the {}. Remove one.", column.name)),
        };
        let name = &header[*place];
        if unit.is_empty() {
            without_unit.push(format!("`{name}`"));
        }
        let Column { dimension, .. } = column;
        let scale = if unit.is_empty() { Ok(1.0) } else { parse(&format!("1 {unit}"), *dimension) };
        *found = (
            *place,
            scale.map_err(|_| {
                format!("the column `{name}` ends in `{unit}`, which is not a unit of {}.", dimension.name())
            })?,
        );
    }
    if !without_unit.is_empty() {
        notes.push(format!("the names of {} have no unit: SI is assumed", without_unit.join(", ")));
    }
    Ok(found)
}
