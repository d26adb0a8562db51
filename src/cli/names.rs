//! Names among the arguments, which clap lists and completes.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use plm_impact::plot::Pictures;

/// Takes the name of one of `all`.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let find = move |given: String| all.into_iter().find(|one| name(*one) == given).ok_or("no such name");
    PossibleValuesParser::new(all.map(name)).try_map(find)
}

/// What pictures are written as.
#[derive(Debug, Clone, Copy, Args)]
pub struct PictureArguments {
    /// What pictures are written as: svg stays sharp in any size, and its text can be searched
    #[arg(id = "pictures", long, value_name = "FORMAT", default_value = "png", value_parser = one_of(Pictures::ALL, Pictures::name))]
    pub format: Pictures,
}
