//! A number, or several in lock step: the arithmetic that rk8 and its batch form share, so that both give the same bits.

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::Simd;

/// The operations of numbers that the formulas of a step need. Choices are made by [`Lane::if_less`], without branches.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
{
    /// `value` in every lane.
    fn all(self, value: f64) -> Self;
    fn abs(self) -> Self;
    fn sqrt(self) -> Self;
    fn max(self, other: Self) -> Self;
    fn min(self, other: Self) -> Self;
    /// `then` where self < other, else `otherwise` (also where one is not a number).
    fn if_less(self, other: Self, then: Self, otherwise: Self) -> Self;
    /// x^(−1/8) to 4 %, see [`inverse_eighth_root`].
    fn inverse_eighth_root(self) -> Self;
}

/// x^(−1/8) to 4 %, x ≥ 0. The exponent bits of a double are its logarithm to base 2 and the rest of the bits interpolates
/// it, so the power is a shift and a subtraction. The next step has to wait for it, and `powf` takes as long as three stages.
#[inline(always)]
fn inverse_eighth_root(x: f64) -> f64 {
    /// (1 + 1/8) (1023 − 0.04) 2⁵²; 0.04 centres the interpolation error.
    const OFFSET: u64 = 0x47ed_47ae_147a_e000;
    f64::from_bits(OFFSET - (x.to_bits() >> 3))
}

impl Lane for f64 {
    #[inline(always)]
    fn all(self, value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.max(other)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.min(other)
    }
    #[inline(always)]
    fn if_less(self, other: Self, then: Self, otherwise: Self) -> Self {
        if self < other { then } else { otherwise }
    }
    #[inline(always)]
    fn inverse_eighth_root(self) -> Self {
        inverse_eighth_root(self)
    }
}

/// K registers of the instruction set that was found at run time.
#[derive(Clone, Copy)]
pub struct Wide<S: Simd, const K: usize> {
    simd: S,
    registers: [S::f64s; K],
}

impl<S: Simd, const K: usize> Wide<S, K> {
    #[inline(always)]
    pub fn load(simd: S, row: &[S::f64s]) -> Self {
        let mut registers = [simd.splat_f64s(0.0); K];
        registers.copy_from_slice(&row[..K]);
        Self { simd, registers }
    }

    #[inline(always)]
    pub fn store(self, row: &mut [S::f64s]) {
        row[..K].copy_from_slice(&self.registers);
    }
}

// Plain loops and no closures: a function that is not inlined into the dispatched one would lose its instruction set.
macro_rules! unary {
    ($method:ident, $simd:ident) => {
        #[inline(always)]
        fn $method(mut self) -> Self {
            for register in &mut self.registers {
                *register = self.simd.$simd(*register);
            }
            self
        }
    };
}
macro_rules! binary {
    ($method:ident, $simd:ident) => {
        #[inline(always)]
        fn $method(mut self, other: Self) -> Self {
            for i in 0..K {
                self.registers[i] = self.simd.$simd(self.registers[i], other.registers[i]);
            }
            self
        }
    };
}
macro_rules! operator {
    ($trait:ident, $method:ident, $simd:ident) => {
        impl<S: Simd, const K: usize> $trait for Wide<S, K> {
            type Output = Self;
            binary!($method, $simd);
        }
    };
}
operator!(Add, add, add_f64s);
operator!(Sub, sub, sub_f64s);
operator!(Mul, mul, mul_f64s);
operator!(Div, div, div_f64s);

impl<S: Simd, const K: usize> Neg for Wide<S, K> {
    type Output = Self;
    unary!(neg, neg_f64s);
}

impl<S: Simd, const K: usize> Mul<f64> for Wide<S, K> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * self.all(factor)
    }
}

impl<S: Simd, const K: usize> Lane for Wide<S, K> {
    unary!(abs, abs_f64s);
    unary!(sqrt, sqrt_f64s);
    binary!(max, max_f64s);
    binary!(min, min_f64s);
    #[inline(always)]
    fn all(self, value: f64) -> Self {
        Self { simd: self.simd, registers: [self.simd.splat_f64s(value); K] }
    }
    #[inline(always)]
    fn if_less(mut self, other: Self, then: Self, otherwise: Self) -> Self {
        for i in 0..K {
            let mask = self.simd.less_than_f64s(self.registers[i], other.registers[i]);
            self.registers[i] = self.simd.select_f64s(mask, then.registers[i], otherwise.registers[i]);
        }
        self
    }
    #[inline(always)]
    fn inverse_eighth_root(mut self) -> Self {
        for lane in pulp::bytemuck::cast_slice_mut::<S::f64s, f64>(&mut self.registers) {
            *lane = inverse_eighth_root(*lane);
        }
        self
    }
}
