//! A number, or a number with two derivatives: what formulas of forces are written in.

use std::ops::{Add, Div, Mul, Neg};

use crate::math::functions::{asin, cos, exp, ln, pow, sin};

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
    /// g of it, from g, g' and g'' at a value.
    fn map(self, g: impl Fn(f64) -> [f64; 3]) -> Self;

    /// x^p, x > 0.
    fn powf(self, p: f64) -> Self {
        self.map(|x| {
            let (power, inverse) = (pow(x, p), 1.0 / x);
            [power, p * power * inverse, p * (p - 1.0) * power * inverse * inverse]
        })
    }
    fn exp(self) -> Self {
        self.map(|x| [exp(x); 3])
    }
    fn ln(self) -> Self {
        self.map(|x| [ln(x), 1.0 / x, -1.0 / (x * x)])
    }
    fn sin(self) -> Self {
        self.map(|x| [sin(x), cos(x), -sin(x)])
    }
    fn cos(self) -> Self {
        self.map(|x| [cos(x), -sin(x), -cos(x)])
    }
    fn asin(self) -> Self {
        self.map(|x| {
            let slope = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
            [asin(x), slope, x * slope * slope * slope]
        })
    }
}

impl Number for f64 {
    fn map(self, g: impl Fn(f64) -> [f64; 3]) -> Self {
        g(self)[0]
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
    pub fn variable(value: f64) -> Self {
        Self { value, slope: 1.0, curvature: 0.0 }
    }
}

impl Number for Jet {
    fn map(self, g: impl Fn(f64) -> [f64; 3]) -> Self {
        let [value, slope, curvature] = g(self.value);
        Self {
            value,
            slope: slope * self.slope,
            curvature: curvature * self.slope * self.slope + slope * self.curvature,
        }
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
        self * other.map(|x| [1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)])
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
