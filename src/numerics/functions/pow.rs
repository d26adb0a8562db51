//! x^y and e^x in plain multiplications and additions, at the speed of a C library.
//!
//! The method is that of the Arm Optimized Routines: the logarithm of x = 2^k z comes from a table of ln c and a short
//! series in r = z/c − 1, the exponential from a table of 2^(i/128) and a short series. For x^y the logarithm is a sum of
//! two doubles. No product is fused with a sum, so that every processor gives the same bits. Both tables are computed when
//! the program is compiled.

/// A number as a sum of two doubles, good to about 31 digits.
type DoubleDouble = (f64, f64);

const TABLE_SIZE: usize = 128;
/// 1/c are multiples of 1/PARTS, so that z/c − 1 has no rounding where z has few bits.
const INVERSE_DENOMINATOR: f64 = 256.0;
/// The bits of the smallest z, 0.70703125; an interval of the table begins at 1.
const MIN_MANTISSA_BITS: u64 = 0x3fe6_a000_0000_0000;
/// ln 2.
const LN_2: DoubleDouble = (std::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);
/// Beyond this an exponential comes near to the ends of the doubles.
const MAX_EXPONENT: f64 = 700.0;

/// ln x on a grid of 2^-42, and the rest: whole multiples of the first have no rounding.
const fn on_grid((high, low): DoubleDouble) -> DoubleDouble {
    /// Numbers beside it are 2^-42 apart.
    const GRID: f64 = 1536.0;
    let first = (high + GRID) - GRID;
    (first, (high - first) + low)
}

/// a + b as a sum.
const fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let total = a + b;
    let rest = total - a;
    (total, (a - (total - rest)) + (b - rest))
}

/// The first 26 bits of a number, and the rest.
const fn split(a: f64) -> DoubleDouble {
    let high = f64::from_bits(a.to_bits() & (u64::MAX << 27));
    (high, a - high)
}

/// a b as a sum.
const fn two_product(a: f64, b: f64) -> DoubleDouble {
    let (whole, (a, rest_of_a), (b, rest_of_b)) = (a * b, split(a), split(b));
    (whole, ((a * b - whole) + a * rest_of_b + rest_of_a * b) + rest_of_a * rest_of_b)
}

const fn add(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let (high, low) = two_sum(a.0, b.0);
    two_sum(high, low + a.1 + b.1)
}

const fn mul(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let (high, low) = two_product(a.0, b.0);
    two_sum(high, low + a.0 * b.1 + a.1 * b.0)
}

/// a/b for a whole number b.
const fn div(a: DoubleDouble, b: f64) -> DoubleDouble {
    let quotient = a.0 / b;
    let (whole, rest) = two_product(quotient, b);
    two_sum(quotient, ((a.0 - whole) - rest + a.1) / b)
}

/// ln((k + 1)/k) = 2 artanh(1/(2k + 1)).
const fn log_increment(k: f64) -> DoubleDouble {
    let odd = 2.0 * k + 1.0;
    let (mut total, mut term, mut j) = ((0.0, 0.0), div((2.0, 0.0), odd), 1.0);
    while j < 16.0 {
        total = add(total, div(term, j));
        term = div(div(term, odd), odd);
        j += 2.0;
    }
    total
}

/// The constants of an interval of z: 1/c for a number c in its middle (c = 1 near 1), and ln c as a number on the grid plus a
/// rest.
#[derive(Clone, Copy)]
struct LogTableEntry {
    inverse: f64,
    logarithm: f64,
    rest: f64,
}

const LOG_TABLE: [LogTableEntry; TABLE_SIZE] = {
    let mut table = [LogTableEntry { inverse: 1.0, logarithm: 0.0, rest: 0.0 }; TABLE_SIZE];
    let mut i = 0;
    while i < TABLE_SIZE {
        let begin = MIN_MANTISSA_BITS + ((i as u64) << 45);
        let ends_at_one = begin + (1 << 45) == 1.0_f64.to_bits();
        if begin != 1.0_f64.to_bits() && !ends_at_one {
            // 256/c to the nearest whole number, and from 256 there in steps of one
            #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            // 128 to 512
            let parts = (INVERSE_DENOMINATOR / f64::from_bits(begin + (1 << 44)) + 0.5) as u64 as f64;
            let (mut k, mut logarithm) = (INVERSE_DENOMINATOR, (0.0, 0.0));
            while k < parts {
                let (high, low) = log_increment(k);
                logarithm = add(logarithm, (-high, -low));
                k += 1.0;
            }
            while k > parts {
                k -= 1.0;
                logarithm = add(logarithm, log_increment(k));
            }
            let (logarithm, rest) = on_grid(logarithm);
            table[i] = LogTableEntry { inverse: parts / INVERSE_DENOMINATOR, logarithm, rest };
        }
        i += 1;
    }
    table
};

/// 2^(i/128): its bits less i 2^45, to which the whole exponent is added, and what is missing over the number.
const EXP2_TABLE: [(u64, f64); TABLE_SIZE] = {
    // 2^(1/128) by the series of the exponential, from its last term inwards
    let (step, mut root, mut j) = (div(LN_2, 128.0), (1.0, 0.0), 14.0);
    while j > 0.0 {
        root = add((1.0, 0.0), div(mul(root, step), j));
        j -= 1.0;
    }
    let (mut table, mut power, mut i): (_, DoubleDouble, _) = ([(0, 0.0); TABLE_SIZE], (1.0, 0.0), 0);
    while i < TABLE_SIZE {
        table[i] = (power.0.to_bits() - ((i as u64) << 45), power.1 / power.0);
        power = mul(power, root);
        i += 1;
    }
    table
};

/// ln x as a sum; x must be positive and normal.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, clippy::cast_precision_loss)] // k has eleven bits
fn logarithm(x: f64) -> DoubleDouble {
    const LN_2_PARTS: DoubleDouble = on_grid(LN_2);
    let bits = x.to_bits().wrapping_sub(MIN_MANTISSA_BITS);
    let near = &LOG_TABLE[(bits >> 45) as usize % TABLE_SIZE];
    let k = ((bits as i64) >> 52) as f64;
    let z = x.to_bits().wrapping_sub(bits & (0xfff << 52));
    // r in two parts of which the first and its square have no rounding
    let first = f64::from_bits((z + (1 << 31)) & (u64::MAX << 32));
    let r_high = first * near.inverse - 1.0;
    let r_low = (f64::from_bits(z) - first) * near.inverse;
    let r = r_high + r_low;
    let whole = k * LN_2_PARTS.0 + near.logarithm;
    let linear = whole + r;
    let of_linear = whole - linear + r;
    let (half, half_high) = (-0.5 * r, -0.5 * r_high);
    let square = r_high * half_high;
    let high = linear + square;
    let of_square = r_low * (half + half_high) + (linear - high + square);
    // −r²/2, and the terms from r³/3 on in powers of it
    let s = r * half;
    let last = -8.0 / 7.0 + r + s * (16.0 / 9.0);
    let series = r * s * (-2.0 / 3.0 + 0.5 * r + s * (0.8 - 2.0 / 3.0 * r + s * last));
    let low = k * LN_2_PARTS.1 + near.rest + of_linear + of_square + series;
    let total = high + low;
    (total, high - total + low)
}

/// e^(x + rest) for |x| ≤ [`MAX_EXPONENT`] and a small rest.
#[inline(always)]
fn exponential(x: f64, rest: f64) -> f64 {
    /// Whole numbers are apart by one here.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    const STEP: DoubleDouble = on_grid(div(LN_2, 128.0));
    let shifted = x * (128.0 / std::f64::consts::LN_2) + WHOLE;
    let count = shifted - WHOLE;
    let whole = shifted.to_bits();
    let r = x - count * STEP.0 - count * STEP.1 + rest;
    #[allow(clippy::cast_possible_truncation)] // only the lowest bits count
    let (bits, missing) = EXP2_TABLE[whole as usize % TABLE_SIZE];
    let power = f64::from_bits(bits.wrapping_add(whole << 45));
    let square = r * r;
    let series = missing + r + square * (0.5 + r * (1.0 / 6.0)) + square * square * (1.0 / 24.0 + r * (1.0 / 120.0));
    power + power * series
}

#[inline(always)]
fn is_normal_and_positive(x: f64) -> bool {
    (f64::MIN_POSITIVE..f64::INFINITY).contains(&x)
}

/// x^y.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    if is_normal_and_positive(x) {
        let (high, low) = logarithm(x);
        let (y_high, y_low) = split(y);
        let (log_high, log_low) = split(high);
        let product = y_high * log_high;
        if product.abs() < MAX_EXPONENT {
            return exponential(product, y_low * log_high + y * (log_low + low));
        }
    }
    special_cases(x, y)
}

/// x^y for the special cases: zeros, infinities, subnormal numbers and negative x.
#[cold]
#[inline(never)]
fn special_cases(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// e^x.
#[inline]
pub fn exp(x: f64) -> f64 {
    if x.abs() < MAX_EXPONENT { exponential(x, 0.0) } else { libm::exp(x) }
}
