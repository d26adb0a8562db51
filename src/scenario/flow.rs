//! `[half_space.flow_stress]`: how the half-space hardens, and which keys may stand beside it.

use super::{Scenario, ScenarioError};
use crate::law::LawChoice;
use crate::material::HalfSpace;
use crate::plan::{HARDNESS, YIELD_STRENGTH};
use crate::strength::flow::{FlowCurve, FlowPoint};
use crate::strength::hardness::strength_of_hardness;
use crate::units::csv_text::{CsvText, Refusal};

/// The table of the flow curve.
pub(super) const FLOW: &str = "half_space.flow_stress";

/// The key of a file with the points of a curve.
pub(super) const TABLE: &str = "half_space.flow_stress.table";

/// The forms of a curve, each with the numbers it needs.
const FORMS: [(&str, &[&str]); 5] = [
    ("power", &["exponent"]),
    ("voce", &["saturation", "rate"]),
    ("linear", &["slope"]),
    ("points", &[]),
    ("table", &[]),
];

/// How a curve may be written.
const EXAMPLE: &str = "power = { exponent = 0.1 }, voce = { saturation = 1.5, rate = 15 }, linear = { slope = \"4.2 GPa\" }, points = [[0.002, \"300 MPa\"], [0.01, \"340 MPa\"]] or table = \"flow.csv\"";

impl Scenario {
    /// The flow curve of the half-space, with the first value of a number that varies.
    pub(super) fn flow(&self) -> Result<Option<FlowCurve>, ScenarioError> {
        let path = |form: &str| format!("{FLOW}.{form}");
        let begins = |form: &str| {
            let inner = format!("{}.", path(form));
            self.entries.has(&path(form)) || self.entries.varied().any(|varied| varied.starts_with(&inner))
        };
        let mut given = FORMS.iter().filter(|(form, _)| begins(form));
        let Some((form, needed)) = given.next() else {
            return if self.entries.has(FLOW) {
                Err(self.document.refuse(FLOW, format!("has no curve; write one of {EXAMPLE}")))
            } else {
                Ok(None)
            };
        };
        if let Some((second, _)) = given.next() {
            return Err(self.document.one_key(&path(form), &path(second)));
        }
        let number = |name: &str| {
            let key = format!("{FLOW}.{form}.{name}");
            self.entries.number(&key).or_else(|| self.entries.first(&key))
        };
        if let Some(missing) = needed.iter().find(|name| number(name).is_none()) {
            return Err(self.document.missing(&path(form), missing));
        }
        let given = |name: &str| number(name).unwrap_or(f64::NAN);
        Ok(Some(match *form {
            "power" => FlowCurve::Power { exponent: given("exponent") },
            "voce" => FlowCurve::Voce { saturation: given("saturation"), rate: given("rate") },
            "linear" => FlowCurve::Linear { slope: given("slope") },
            form => {
                let points =
                    if form == "table" { self.flow_table()? } else { self.entries.pairs(&path(form)).to_vec() };
                let points = points.into_iter().map(|[strain, stress]| FlowPoint { strain, stress });
                let file =
                    self.entries.text(&path("table")).map(|name| format!("{}: ", self.directory.join(name).display()));
                let refuse = |error| self.document.refuse(&path(form), format!("{}{error}", file.unwrap_or_default()));
                FlowCurve::through(points.collect::<Vec<_>>()).map_err(refuse)?
            }
        }))
    }

    /// Refuses laws and keys that cannot stand beside a flow curve.
    pub(super) fn check_strength(&self, law: &LawChoice, half_space: Option<&HalfSpace>) -> Result<(), ScenarioError> {
        let varies = |key: &str| self.entries.varies(key);
        let has_hardness = self.entries.has(HARDNESS) || varies(HARDNESS);
        let Some(flow) = self.flow()? else { return Ok(()) };
        let refuse = |message: &str| Err(self.document.refuse(FLOW, message));
        if !matches!(law, LawChoice::Plm(_)) {
            let name = law.name();
            return refuse(&format!("the law {name} has no hardening: leave the table out, or take the law plm"));
        }
        if varies("law") {
            return refuse("only the law plm has hardening: leave the table out, or the axis \"law\"");
        }
        let Some((half_space, strength)) =
            half_space.and_then(|half_space| Some((half_space, half_space.yield_strength?)))
        else {
            return refuse(
                "a flow curve begins at a strength: give the half-space its yield_strength, the stress at plastic strain 0",
            );
        };
        if has_hardness && !matches!(flow, FlowCurve::Power { .. }) {
            return refuse(
                "a hardness gives the strength of a power curve only: with this curve give yield_strength in place of hardness",
            );
        }
        if flow.last_strain().is_some() && (varies(YIELD_STRENGTH) || varies(HARDNESS)) {
            return refuse(
                "a curve through points begins at one yield strength, which then cannot vary; take power or voce",
            );
        }
        let modulus = half_space.material.youngs_modulus;
        let sound = flow.starts_from(strength).and_then(|()| flow.is_flatter_than(modulus, strength));
        sound.or_else(|error| refuse(&error.to_string()))
    }

    /// The yield strength \[Pa\] of a half-space whose keys stand in this table, of a scene without an impact.
    pub(super) fn strength_in(&self, table: &str) -> Result<Option<f64>, ScenarioError> {
        let Some(mean_pressure) = self.entries.number(&format!("{table}.hardness")) else {
            return Ok(self.entries.number(&format!("{table}.yield_strength")));
        };
        let modulus = self.number(&format!("{table}.youngs_modulus"))?;
        Ok(Some(strength_of_hardness(mean_pressure, self.flow()?.as_ref(), modulus)))
    }

    /// The points of the file that the scenario names: `plastic_strain, stress_Pa`.
    fn flow_table(&self) -> Result<Vec<[f64; 2]>, ScenarioError> {
        let (Some(name), Some(text)) = (self.entries.text(TABLE), self.text_of_file(TABLE)) else {
            return Ok(Vec::new());
        };
        let path = self.directory.join(name);
        let refused = |(line, message): Refusal| {
            let line = line.map(|line| format!(":{line}")).unwrap_or_default();
            self.document.refuse(TABLE, format!("{}{line}: {message}", path.display()))
        };
        let table = CsvText::new(text).map_err(refused)?;
        if table.header.iter().collect::<Vec<_>>() != COLUMNS {
            return Err(refused((table.line, format!("its columns must be {}", COLUMNS.join(", ")))));
        }
        let mut points = Vec::new();
        for row in table.rows() {
            let (line, row) = row.map_err(refused)?;
            let number = |i: usize| {
                let no_number = |_| refused((Some(line), format!("{} is no number, but \"{}\"", COLUMNS[i], &row[i])));
                row[i].parse::<f64>().map_err(no_number)
            };
            points.push([number(0)?, number(1)?]);
        }
        Ok(points)
    }
}

const COLUMNS: [&str; 2] = ["plastic_strain", "stress_Pa"];
