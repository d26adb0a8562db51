//! The measured sets of `src/reference/measured`: each row is computed, and each compared column becomes a quantity.

mod friction_models;
mod impacts;
pub mod page;
mod sticking;

pub(super) use friction_models::glass_balls;

use super::comparison::{Comparison, Group};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::numerics::functions::sin_cos;
use crate::reference::damaged_table;
use crate::reference::measured::{MeasuredSet, measured_sets};
use crate::results::result_columns;
use impacts::{MeasuredImpact, RELATIVE_SPEED, impacts_of, relative_tangential_speed};

/// A quantity that is no column of a table of the program.
type OwnQuantity = (&'static str, fn(&MeasuredImpact) -> Result<Option<f64>, Error>);

const OWN_QUANTITIES: [OwnQuantity; 4] = [
    ("restitution", |impact| Ok(Some(impact.by_law.measured_restitution()))),
    (RELATIVE_SPEED, |impact| Ok(relative_tangential_speed(&impact.by_law))),
    ("sticking_restitution", |impact| {
        Ok(sticking::sticking_restitution(&impact.contact, impact.approach)?.map(|s| s.slope))
    }),
    ("spin_of_restitution_rad_per_m", |impact| Ok(Some(spin_of_restitution(impact)))),
];

/// Spin after over speed before \[rad/m\] of a sphere without spin before, from the measured restitution of the contact point: with
/// s_0 = v_t and s_1 = −e_t s_0,
///
/// ```text
/// ω_1 = (1 − 1/j) (1 + e_t) v_t/R
/// ```
fn spin_of_restitution(MeasuredImpact { row, contact, approach, .. }: &MeasuredImpact) -> f64 {
    let (sin, _) = sin_cos(approach.angle());
    let released = 1.0 + row.number("contact_point_restitution");
    (1.0 - 1.0 / contact.slip_factor()) * released * sin / contact.sphere().radius
}

/// The value of the program for a column.
fn value_of(set: &MeasuredSet, column: &str, impact: &MeasuredImpact) -> Result<Option<f64>, Error> {
    if let Some((_, value)) = OWN_QUANTITIES.iter().find(|(name, _)| *name == column) {
        return value(impact);
    }
    match result_columns().iter().find(|result| result.name == column) {
        Some(result) => Ok((result.value)(&impact.by_law)),
        None => Err(damaged_table(set.file, &format!("the program computes no \"{column}\""))),
    }
}

/// The comparisons of one set.
fn comparisons_of(set: &MeasuredSet, coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let (impacts, mut compared) = (impacts_of(set, coefficients)?, Vec::new());
    for column in set.compared_columns() {
        let unit = if column.column.ends_with("_m_per_s") { "m/s" } else { "" };
        let source = set.short_field("source");
        let group = Group { quantity: column.quantity, source, unit, is_difference: column.is_difference };
        for impact in &impacts {
            let Some(measured) = impact.row.optional_number(column.column) else { continue };
            let Some(by_law) = value_of(set, column.column, impact)? else { continue };
            compared.push(group.compare(impact.row.cell_text("case").to_owned(), [measured, by_law]));
        }
    }
    Ok(compared)
}

pub(super) fn comparisons(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let of_sets =
        measured_sets()?.iter().map(|set| comparisons_of(set, coefficients)).collect::<Result<Vec<_>, _>>()?;
    Ok(of_sets.into_iter().flatten().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "# title: a\n# source: b\n# measured: c\n# units: e\n# spread: f\n# body: g\n# doubts: h\n";

    fn compared(more: &str) -> Result<Vec<Comparison>, Error> {
        let text: &'static str = Box::leak(format!("{HEAD}{more}").into_boxed_str());
        comparisons_of(&MeasuredSet::from_text("new.csv", text)?, PlmCoefficients::built_in())
    }

    /// A new set is a file: an elastic impact has e = 1, and its contact time by Hertz, 2.87 (m²/(R E*² v))^(1/5).
    #[test]
    fn new_file_is_compared_without_code() {
        let keys = "# keys: sphere.radius=5e-3; sphere.youngs_modulus=2e11; sphere.poissons_ratio=0.3; sphere.mass=4e-3;\n#   half_space.youngs_modulus=2e11; half_space.poissons_ratio=0.3\n";
        let rows = "# compare restitution: q\n# compare contact_time_s: t\ncase,impact.speed,restitution,contact_time_s\nx,1,0.5,\ny,2,,3e-5\n";
        let all = compared(&format!("{keys}{rows}")).unwrap();
        let [e, time] = &all[..] else { panic!("{all:?}") };
        assert!(e.case == "x" && (e.deviation - 1.0).abs() < 1e-12, "{e:?}");
        let modulus = 2e11 / (2.0 * (1.0 - 0.09));
        let hertz = 2.868 * crate::numerics::functions::pow(1.6e-5 / (5e-3 * modulus * modulus * 2.0), 0.2);
        assert!(time.case == "y" && (time.law / hertz - 1.0).abs() < 1e-3, "{} {hertz}", time.law);
        let unknown = compared(&format!("{keys}# compare colour: q\ncase,impact.speed,colour\nx,1,2\n")).unwrap_err();
        assert!(unknown.to_string().contains("computes no \"colour\""), "{unknown}");
    }
}
