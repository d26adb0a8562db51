//! Small mathematics that knows nothing of contacts: functions with the same bits on every machine, quadrature, roots,
//! least squares, polynomials, powers, and smooth forces given by a formula.

pub(crate) mod chebyshev;
pub mod functions;
pub mod power;
pub mod quadrature;
pub mod root;
pub mod smooth;
