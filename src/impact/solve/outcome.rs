//! The results of an impact in dimensionless form, the same for every method.

use super::recorder::TracePoint;
use crate::contact::law::Unloading;
use crate::numerics::ode::SolverStats;
use crate::strings::names::named_enum;

named_enum! {
    pub enum ImpactEnd {
        /// The total contact force vanishes.
        Separated = "separated",
        /// The total contact force never vanishes: the sphere stays.
        Captured = "captured",
    }
}

/// The times of peak and separation in a code with fixed steps, each at the end of a step. They are dimensionless here, and in
/// seconds in an [`Impact`](crate::impact::Impact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedSteps {
    pub step: f64,
    /// First contact to the deepest step.
    pub compression_time: f64,
    /// First contact to the first step without a pushing force; `None` for a captured sphere.
    pub separation_time: Option<f64>,
}

impl FixedSteps {
    /// Returns the times in seconds, for this unit of time.
    pub(in crate::impact) fn in_seconds(&self, time: f64) -> Self {
        Self {
            step: self.step * time,
            compression_time: self.compression_time * time,
            separation_time: self.separation_time.map(|separation| separation * time),
        }
    }
}

/// The outcome of an impact in dimensionless form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaledResult {
    /// The unloading branch: peak state and exponent.
    pub unloading: Unloading,
    /// e: rebound speed over impact speed; 0 for a captured sphere.
    pub restitution: f64,
    /// The peak contact force, damping included.
    pub largest_force: f64,
    pub loading_time: f64,
    /// Time from first contact to separation, or to the end of the run of a captured sphere.
    pub contact_time: f64,
    pub end: ImpactEnd,
    pub end_indentation: f64,
    /// u at that end; negative during the rebound.
    pub end_speed: f64,
    /// Energy that drag has absorbed until then, in units of Φ L.
    pub loss: f64,
}

/// One dimensionless impact as a method computes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    pub outcome: ScaledResult,
    pub stats: SolverStats,
    /// The times in fixed steps; `None` for other methods.
    pub fixed_steps: Option<FixedSteps>,
    /// The trace, in order of time; empty if no trace is requested.
    pub trace_points: Vec<TracePoint>,
}

impl Solution {
    /// An outcome without fixed steps and trace.
    pub(crate) fn new(outcome: ScaledResult, stats: SolverStats) -> Self {
        Self { outcome, stats, fixed_steps: None, trace_points: Vec::new() }
    }
}
