//! The option that says what pictures are written as.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use plm_impact::plot::Pictures;

/// What pictures are written as.
#[derive(Debug, Clone, Copy, Args)]
pub struct PictureArguments {
    /// What pictures are written as: svg stays sharp in any size, and its text can be searched
    #[arg(id = "pictures", long, value_name = "FORMAT", default_value = "png", value_parser = formats())]
    pub format: Pictures,
}

fn formats() -> impl TypedValueParser<Value = Pictures> {
    let of = |name: String| Pictures::ALL.into_iter().find(|format| format.name() == name).unwrap_or(Pictures::Png);
    PossibleValuesParser::new(Pictures::ALL.map(Pictures::name)).map(of)
}
