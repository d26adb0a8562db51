//! How the strength of a metal rises with the rate of strain.
//!
//! ```text
//! Johnson-Cook      h(w) = 1 + c ln(w/w0)        also below the reference rate w0
//! Cowper-Symonds    h(w) = 1 + (w/D)^(1/q)
//! factor            g(w) = max(1, h(w)/h(w_t))   w_t: the rate of the test that gave the strength
//! ```
//!
//! Every flow stress of the metal is multiplied by g. A test that was faster than the impact leaves g = 1.

use crate::numerics::functions::{ln, pow};

/// The form of the rise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RateForm {
    JohnsonCook {
        /// c \[1\], ≥ 0.
        c: f64,
        /// w0 \[1/s\].
        reference: f64,
    },
    CowperSymonds {
        /// D \[1/s\].
        rate: f64,
        /// q \[1\].
        exponent: f64,
    },
}

/// How the strength of a body rises with the rate of strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrainRateHardening {
    pub form: RateForm,
    /// w_t \[1/s\].
    pub test_rate: f64,
}

impl StrainRateHardening {
    /// Rate \[1/s\] of a usual test, of tension or of hardness: the load of a hardness test is held for 10 to 15 s.
    pub const DEFAULT_TEST_RATE: f64 = 1e-3;

    /// w0 \[1/s\] of most published constants.
    pub const DEFAULT_REFERENCE_RATE: f64 = 1.0;

    /// h at a rate \[1/s\]; for Johnson and Cook's form it falls without end towards the rate 0.
    pub fn raw_factor(&self, rate: f64) -> f64 {
        match self.form {
            RateForm::JohnsonCook { c: 0.0, .. } => 1.0,
            RateForm::JohnsonCook { c, reference } => 1.0 + c * ln(rate / reference),
            RateForm::CowperSymonds { rate: unit, exponent } => 1.0 + pow(rate / unit, 1.0 / exponent),
        }
    }

    /// g at a rate \[1/s\] ≥ 0; NaN where h of the test is not positive.
    pub fn factor(&self, rate: f64) -> f64 {
        let of_test = self.raw_factor(self.test_rate);
        if rate <= self.test_rate {
            return if of_test > 0.0 { 1.0 } else { f64::NAN };
        }
        let factor = self.raw_factor(rate) / of_test;
        if of_test > 0.0 { factor } else { f64::NAN }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn factors_are_those_of_the_formulas() {
        let cook = |c, tested_at| StrainRateHardening {
            form: RateForm::JohnsonCook { c, reference: 1.0 },
            test_rate: tested_at,
        };
        // (1 + 0.014 ln 1000)/(1 − 0.014 ln 1000) by hand
        assert_relative_eq!(cook(0.014, 1e-3).factor(1e3), 1.214_124_857_409_328, max_relative = 1e-12);
        // at a reference rate of 100 1/s: (1 + 0.014 ln 10)/(1 − 0.014 ln 100000)
        let form = RateForm::JohnsonCook { c: 0.014, reference: 100.0 };
        let factor = StrainRateHardening { form, test_rate: 1e-3 }.factor(1e3);
        assert_relative_eq!(factor, 1.230_582_685_637_024, max_relative = 1e-12);
        let cowper =
            StrainRateHardening { form: RateForm::CowperSymonds { rate: 6844.0, exponent: 2.0 }, test_rate: 6844.0 };
        assert_relative_eq!(cowper.factor(4.0 * 6844.0), 1.5, max_relative = 1e-15);
        // slower than the test, and without any rise
        for slow in [0.0, 1e-9, 1e-3] {
            assert_eq!((cook(0.014, 1e-3).factor(slow), cowper.factor(slow)), (1.0, 1.0));
        }
        assert_eq!(cook(0.0, 1e-3).factor(1e5), 1.0);
        // 1 + 0.2 ln 0.001 is negative
        assert!(cook(0.2, 1e-3).factor(1e3).is_nan() && cook(0.2, 1e-3).factor(0.0).is_nan());
    }
}
