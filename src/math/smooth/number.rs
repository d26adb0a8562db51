//! A number, or a number with two derivatives: what formulas of forces are written in.

use std::ops::{Add, Div, Mul, Neg};

use crate::math::functions::{asin, cos, exp, ln, pow, sin, sin_cos};

/// What a formula needs of its argument.
#[allow(clippy::return_self_not_must_use)]
pub trait Number:
    Copy
    + Add<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// x^p, x > 0.
    fn powf(self, exponent: f64) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn asin(self) -> Self;
}

impl Number for f64 {
    fn powf(self, exponent: f64) -> Self {
        pow(self, exponent)
    }
    fn exp(self) -> Self {
        exp(self)
    }
    fn ln(self) -> Self {
        ln(self)
    }
    fn sin(self) -> Self {
        sin(self)
    }
    fn cos(self) -> Self {
        cos(self)
    }
    fn asin(self) -> Self {
        asin(self)
    }
}

/// A value with its first two derivatives: arithmetic on it differentiates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    pub value: f64,
    pub slope: f64,
    pub curvature: f64,
}

impl Jet {
    /// The variable itself.
    pub fn variable(value: f64) -> Self {
        Self { value, slope: 1.0, curvature: 0.0 }
    }

    /// g(f) by the chain rule, from g, g' and g'' at f.
    fn chain(self, value: f64, slope: f64, curvature: f64) -> Self {
        Self {
            value,
            slope: slope * self.slope,
            curvature: curvature * self.slope * self.slope + slope * self.curvature,
        }
    }
}

impl Number for Jet {
    fn powf(self, exponent: f64) -> Self {
        let power = pow(self.value, exponent);
        let slope = exponent * power / self.value;
        self.chain(power, slope, (exponent - 1.0) * slope / self.value)
    }
    fn exp(self) -> Self {
        let power = exp(self.value);
        self.chain(power, power, power)
    }
    fn ln(self) -> Self {
        let inverse = 1.0 / self.value;
        self.chain(ln(self.value), inverse, -inverse * inverse)
    }
    fn sin(self) -> Self {
        let (sin, cos) = sin_cos(self.value);
        self.chain(sin, cos, -sin)
    }
    fn cos(self) -> Self {
        let (sin, cos) = sin_cos(self.value);
        self.chain(cos, -sin, -cos)
    }
    fn asin(self) -> Self {
        let slope = 1.0 / ((1.0 - self.value) * (1.0 + self.value)).sqrt();
        self.chain(asin(self.value), slope, self.value * slope * slope * slope)
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
            curvature: self.curvature + other.curvature,
        }
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
            curvature: self.curvature * other.value + 2.0 * self.slope * other.slope + self.value * other.curvature,
        }
    }
}

impl Div for Jet {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // f/g = f × 1/g
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        self * other.chain(inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse)
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Add<f64> for Jet {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slope: self.slope * factor, curvature: self.curvature * factor }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jet_has_the_derivatives_of_central_differences() {
        fn formula<N: Number>(x: N) -> N {
            let root = x.powf(0.5);
            (-root).exp() * x.ln() + (x * 0.3).sin() / (x + 2.0) + -(x * 0.1).asin() * x.cos()
        }
        let (x, h) = (1.7, 1e-4);
        let jet = formula(Jet::variable(x));
        let (below, at, above) = (formula(x - h), formula(x), formula(x + h));
        approx::assert_relative_eq!(jet.value, at, max_relative = 1e-15);
        // the error of central differences is h²/6 f''' and rounding over h²
        approx::assert_relative_eq!(jet.slope, (above - below) / (2.0 * h), max_relative = 1e-7);
        approx::assert_relative_eq!(jet.curvature, (above - 2.0 * at + below) / (h * h), max_relative = 1e-5);
    }
}
