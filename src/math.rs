//! Small mathematics that knows nothing of contacts: functions with the same bits on every machine, quadrature, roots,
//! powers, and smooth forces as polynomials or in closed form.

pub mod branch;
pub mod functions;
pub mod poly;
pub mod power;
pub mod quadrature;
pub mod root;
