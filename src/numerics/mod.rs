//! Mathematics that knows nothing of contacts: functions with the same bits on every machine, powers, comparisons, roots, quadrature, a
//! force as a curve of smooth pieces, Fourier transforms, and the integration of a motion along them.

pub mod comparison;
pub mod curve;
pub mod fft;
pub mod functions;
pub mod ode;
pub mod piecewise_fit;
pub mod power;
pub mod quadrature;
pub mod root;
