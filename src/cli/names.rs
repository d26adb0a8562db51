//! Names among the arguments, which clap lists and completes.

use clap::builder::{PossibleValuesParser, TypedValueParser};

/// Takes the name of one of `all`.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let find = move |given: String| all.into_iter().find(|one| name(*one) == given).ok_or("no such name");
    PossibleValuesParser::new(all.map(name)).try_map(find)
}
