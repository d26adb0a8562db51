//! The interval of e: the law's own part, and what is known of the strengths of materials.

use std::path::Path;

use plm_impact::contact::law::PlmCoefficients;
use plm_impact::evidence::validate::law_error::{cycle_errors, law_errors_csv};
use plm_impact::scenario::scene::interval::law_error::{EXPONENTS, table};

use crate::common::golden::assert_golden;

/// The table that the program uses is the one that follows from the rows of `validate`.
#[test]
fn law_error_table_is_that_of_the_finite_elements() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/scenario/scene/interval/law_errors.csv");
    assert_golden(&path, law_errors_csv(PlmCoefficients::built_in()).unwrap());
}

/// Over all load cycles and impacts of the finite elements the law's part holds at least 90 %, in each class too.
#[test]
fn law_error_holds_the_finite_elements() {
    for (exponent, name) in EXPONENTS {
        let errors = cycle_errors(PlmCoefficients::built_in(), exponent).unwrap();
        assert!(errors.len() > 100, "{}", errors.len());
        let held = |(class, ratio, error): &(_, f64, f64)| {
            let row = table()
                .iter()
                .find(|row| row.class == *class && row.exponent == name && *ratio <= row.max_radius_ratio);
            row.is_none_or(|row| {
                (row.low..=row.high).contains(&(error - 1e-5)) || (row.low..=row.high).contains(&(error + 1e-5))
            })
        };
        let n = errors.iter().filter(|error| held(error)).count();
        assert!(10 * n >= 9 * errors.len(), "{name}: {n} of {}", errors.len());
        // narrow enough to say something
        for row in table().iter().filter(|row| row.exponent == name) {
            assert!(row.high - row.low < 0.12 && row.low <= row.mean && row.mean <= row.high, "{row:?}");
        }
    }
}
