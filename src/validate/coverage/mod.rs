//! The share of values that lie in the interval of e: of finite elements, of measurements, and of metals that are known completely.

pub mod drawn_metals;
mod share;

use super::dynamic::SCENARIOS;
use super::law_error::cycle_errors;
use super::leeb::{leeb_numbers, vickers};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::impact::Solver;
use crate::reference::{IMPACTS, RATE_IMPACTS};
use crate::scenario::input::Input;
use crate::scenario::keys::interval::law_error::{BodyClass, EXPONENTS, LawErrorRow, law_error_table};
use crate::scenario::keys::interval::restitution_interval;
use crate::scenario::{Override, Scenario};
use crate::strings::markdown_table;
use drawn_metals::drawn_metals;
pub use share::Coverage;
use share::PRESSURE_SHAPE;

/// The exponent that is closest to finite elements, as a key.
const EXPONENT: &str = "law.plm.unloading_exponent=pressure-shape";

/// The row of the table of errors for a load cycle: of its class and contact radius, otherwise of all classes.
pub fn law_error_of(exponent: &str, class: BodyClass, radius_ratio: f64) -> Option<&'static LawErrorRow> {
    let find = |class: BodyClass| {
        let mut rows = law_error_table().iter().filter(move |row| row.class == class && row.exponent == exponent);
        rows.find(|row| radius_ratio <= row.max_radius_ratio)
    };
    find(class).or_else(|| find(BodyClass::All))
}

/// The load cycles and impacts of finite elements in the part of the law, for each exponent and class.
pub fn load_cycles() -> Result<Vec<Coverage>, Error> {
    // the table has five decimals
    const ROUNDING: f64 = 1e-5;
    let mut all = Vec::new();
    for (exponent, name) in EXPONENTS {
        let errors = cycle_errors(PlmCoefficients::built_in(), exponent)?;
        for class in BodyClass::ALL {
            let of_class = errors.iter().filter(|(other, ..)| class == BodyClass::All || *other == class);
            let is_inside = |&(class, ratio, error): &(BodyClass, f64, f64)| {
                law_error_of(name, class, ratio)
                    .is_some_and(|row| row.low - ROUNDING <= error && error <= row.high + ROUNDING)
            };
            let set = format!("FE, part of the law, {}, {}", name.replace('_', " "), class.name().replace('_', " "));
            all.push(Coverage::count(set, of_class.map(is_inside)));
        }
    }
    Ok(all)
}

/// The interval of an input at its own speed holds this restitution; `None` without an interval.
fn holds(input: &Input, restitution: f64) -> Result<Option<bool>, Error> {
    let contact = input.contact()?;
    let row = contact.row(input.approach(), &Solver::AUTO)?;
    let interval = restitution_interval(input, &contact, input.speed(), &row);
    Ok(interval.map(|interval| (interval.low..=interval.high).contains(&restitution)))
}

/// Whole impacts of finite elements in the whole interval.
fn impacts() -> Result<Vec<Coverage>, Error> {
    let references = IMPACTS.rows()?;
    let (mut with_waves, mut with_rate) = (Vec::new(), Vec::new());
    for (name, text) in SCENARIOS {
        let input = Scenario::from_text(name, text, &Override::list(&[EXPONENT]))?.resolve()?;
        for row in references.iter().filter(|row| row.cell_text("case") == name) {
            with_waves.extend(holds(&input, row.number("restitution"))?);
        }
    }
    for row in RATE_IMPACTS.rows()? {
        let keys: Vec<String> = row.keys().into_iter().chain([EXPONENT.to_owned()]).collect();
        let input = Scenario::from_text(row.cell_text("case"), "", &Override::list(&keys))?.resolve()?;
        with_rate.extend(holds(&input, row.number("restitution"))?);
    }
    Ok(vec![
        Coverage::count("FE, whole interval, impacts with waves", with_waves),
        Coverage::count("FE, whole interval, impacts with strain rate", with_rate),
    ])
}

/// Quenched steels of known hardness: rebound hardness, measured.
fn quenched_steels() -> Result<Coverage, Error> {
    let mut held = Vec::new();
    for number in leeb_numbers() {
        let text = format!(
            "{PRESSURE_SHAPE}[sphere]\ndiameter = \"3 mm\"\nyoungs_modulus = \"600 GPa\"\npoissons_ratio = 0.23\nmass = \"5.5 g\"\n\
             [half_space]\nmaterial = \"steel-52100-hardened\"\nhardness = \"{} HV\"\n[impact]\nspeed = 2\n",
            vickers(number)
        );
        held.extend(holds(&Scenario::from_text("leeb", &text, &[])?.resolve()?, number / 1000.0)?);
    }
    Ok(Coverage::count("measured, whole interval, quenched steels by their hardness (Leeb)", held))
}

/// The table of `validate`.
pub fn section() -> Result<String, Error> {
    let mut all = load_cycles()?;
    all.extend(impacts()?);
    all.push(quenched_steels()?);
    let metals = drawn_metals()?;
    let sum = |of: fn(&Coverage) -> usize| metals.iter().map(of).sum();
    all.push(Coverage {
        set: "random samples of all metals, whole interval".to_owned(),
        values: sum(|metal| metal.values),
        inside: sum(|metal| metal.inside),
    });
    all.extend(
        metals
            .into_iter()
            .filter(|metal| metal.share() < 0.95)
            .map(|metal| Coverage { set: format!("{} alone", metal.set), ..metal }),
    );
    let mut rows = vec![["set", "values", "inside", "share"].map(str::to_owned)];
    rows.extend(all.iter().map(|one| {
        let share = format!("{:.1} %", 100.0 * one.share());
        [one.set.clone(), one.values.to_string(), one.inside.to_string(), share]
    }));
    Ok(format!(include_str!("page.md"), table = markdown_table(&rows).trim_end()))
}
