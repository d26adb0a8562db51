//! The option that says what pictures are written as.

use clap::Args;
use plm_impact::plot::Pictures;

use super::names::one_of;

/// What pictures are written as.
#[derive(Debug, Clone, Copy, Args)]
pub struct PictureArguments {
    /// What pictures are written as: svg stays sharp in any size, and its text can be searched
    #[arg(id = "pictures", long, value_name = "FORMAT", default_value = "png", value_parser = one_of(Pictures::ALL, Pictures::name))]
    pub format: Pictures,
}
