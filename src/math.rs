//! Small mathematics that knows nothing of contacts: functions with the same bits on every machine, quadrature, roots,
//! and powers.

pub mod functions;
pub mod power;
pub mod quadrature;
pub mod root;
