//! Names among the arguments: one of a few that clap lists, or one of many that a message helps to find.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use plm_impact::error::Error;
use plm_impact::units::nearest::did_you_mean;

/// Takes the name of one of `all`.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let find = move |given: String| all.into_iter().find(|one| name(*one) == given).ok_or("no such name");
    PossibleValuesParser::new(all.map(name)).try_map(find)
}

/// Refuses a name that is none of `all`; `several` is what these are.
pub fn unknown(one: &str, several: &str, name: &str, all: &[&str]) -> Error {
    let begin: Vec<&str> = all.iter().filter(|known| known.starts_with(name)).copied().collect();
    if begin.len() > 1 && !name.is_empty() {
        return Error::input(format!("no {one} is called \"{name}\"; those that begin so are {}", begin.join(", ")));
    }
    let known = format!("{several} are {}", all.join(", "));
    Error::input(format!("unknown {one} \"{name}\"{}", did_you_mean(name, all.iter().copied(), '"', &known)))
}
