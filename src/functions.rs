//! Powers, exponentials, logarithms and the functions of angles, with the same bits on every processor and system.
//!
//! The methods of `f64` ask the C library of the machine, which picks other variants on processors without fused
//! multiply-add: the last digit differs. These come from the crate libm and from [`pow`](mod@pow); all of them are made of
//! additions, multiplications, divisions and square roots, which IEEE 754 fixes to the last bit. `clippy.toml` refuses the
//! methods of `f64` everywhere in the library.

mod pow;

pub use libm::{
    acos, asin, atan, atan2, cbrt, cos, cosh, expm1 as exp_m1, hypot, log as ln, log1p as ln_1p, log2, log10, sin,
    sincos as sin_cos, sinh, tanh,
};
pub use pow::{exp, pow};

/// x^n by repeated squaring, always in the same order.
#[inline(always)]
#[must_use]
pub fn powi(x: f64, n: i32) -> f64 {
    let (mut left, mut square, mut total) = (n.unsigned_abs(), x, 1.0);
    loop {
        if left % 2 == 1 {
            total *= square;
        }
        left /= 2;
        if left == 0 {
            return if n < 0 { 1.0 / total } else { total };
        }
        square *= square;
    }
}
