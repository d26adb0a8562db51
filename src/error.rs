//! Every error of a command, and its exit code.

mod details;

use std::path::PathBuf;

use thiserror::Error;

use crate::calibrate::CalibrateError;
use crate::fit::FitError;
use crate::impact::ImpactError;
use crate::output::OutputError;
use crate::plot::PlotError;
use crate::report::ReportError;
use crate::scenario::{Scenario, ScenarioError};
use crate::sweep::SweepError;
use crate::sweep::shard::ShardError;
use crate::validation::ValidationError;
pub use details::Details;

/// Why a command failed. The texts say what is wrong and where, the value, and the way out.
#[derive(Debug, Error)]
pub enum Error {
    /// The scenario is refused.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The scenario is well-formed, but its impact has no result.
    #[error("{scenario}: {reason}")]
    Impact { scenario: String, reason: ImpactError },
    /// The scenario is well-formed, but its indentation has no result.
    #[error("{scenario}: {reason}")]
    Indentation { scenario: String, reason: String },
    /// A report could not be made.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// A picture could not be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// Outputs cannot be written where they were asked for.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A sweep or a merge did not finish.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// A signal stopped the command.
    #[error("{what}")]
    Stopped {
        /// What was stopped, and what to do.
        what: String,
        /// The exit code that a shell gives a process which this signal ended.
        exit_code: u8,
    },
    /// A shard that does not exist.
    #[error("--shard: {0}")]
    Shard(ShardError),
    /// A table could not be written as CSV.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// A failure that has nothing to do with the input: of a thread, a signal, standard output.
    #[error("{0}")]
    Other(String),
    /// An option or an argument that is wrong.
    #[error("{0}")]
    Option(String),
    /// A table with rows that have no result.
    #[error("{failures} of {rows} cases have no result: see the column status of {}", .table.display())]
    FailedCases { failures: u64, rows: u64, table: PathBuf },
    /// A fit gave no coefficients.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A calibration found nothing.
    #[error(transparent)]
    Calibrate(#[from] CalibrateError),
    /// Measurements that contradict the law.
    #[error("{scenario}: {reason}")]
    Contradicted { scenario: String, reason: String },
    /// A validation could not be made.
    #[error(transparent)]
    Validation(#[from] ValidationError),
    /// A validation that missed tolerances.
    #[error("{missed} of {checks} checks missed their tolerance: see {}", .table.display())]
    Missed { missed: usize, checks: usize, table: PathBuf },
    /// Warnings under `--strict`.
    #[error("{scenario}: {count} warning(s), which --strict makes errors; nothing was written")]
    Strict { scenario: String, count: usize },
}

impl From<ShardError> for Error {
    // no source, as the text contains its text
    fn from(error: ShardError) -> Self {
        Self::Shard(error)
    }
}

impl Error {
    /// The error of a scenario without a result. If one key is the reason, the error points at it.
    pub fn impact(scenario: &Scenario, reason: ImpactError) -> Self {
        if let ImpactError::Range(range) = &reason
            && let Some(refusal) = scenario.too_extreme(range)
        {
            return refusal.into();
        }
        let key = match &reason {
            ImpactError::Law(_) => "law",
            ImpactError::NoClosedForm => "solver.method",
            ImpactError::Range(_) | ImpactError::Integration(_) => "",
        };
        if scenario.document.has(key) {
            return scenario.document.refuse(key, reason.to_string()).into();
        }
        Self::Impact { scenario: scenario.document.name().to_owned(), reason }
    }

    /// 2 where the input has to change, 1 where a run failed, 3 where a validation missed a tolerance or measurements
    /// contradict the law, 130 and 143 after a signal.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Sweep(SweepError::Interrupted { .. } | SweepError::Dropped) => 130,
            Self::Stopped { exit_code, .. } => *exit_code,
            Self::Missed { .. } | Self::Contradicted { .. } => 3,
            Self::Output(error) | Self::Sweep(SweepError::Output(error)) if is_full_disk(error) => 1,
            Self::Sweep(SweepError::File { .. })
            | Self::Fit(FitError::NotConverged(_) | FitError::Form(_))
            | Self::Impact { reason: ImpactError::Integration(_), .. }
            | Self::Report(_)
            | Self::Plot(_)
            | Self::Csv(_)
            | Self::Other(_)
            | Self::FailedCases { .. }
            | Self::Strict { .. } => 1,
            Self::Validation(error) => {
                use ValidationError::{Coefficients, Experiment, Unreadable};
                let is_input = matches!(error, Unreadable(_) | Coefficients { .. } | Experiment(_));
                if is_input { 2 } else { 1 }
            }
            Self::Sweep(_)
            | Self::Output(_)
            | Self::Fit(_)
            | Self::Calibrate(_)
            | Self::Shard(_)
            | Self::Option(_)
            | Self::Scenario(_)
            | Self::Indentation { .. }
            | Self::Impact { .. } => 2,
        }
    }
}

fn is_full_disk(error: &OutputError) -> bool {
    use std::io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    matches!(error, OutputError::Unwritable { reason, .. }
        if matches!(reason.kind(), FileTooLarge | QuotaExceeded | StorageFull))
}
