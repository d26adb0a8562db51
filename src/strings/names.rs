//! Words that users write: enums whose values have names, and "did you mean", the known word most like an unknown one.

use super::capitalise;

/// An enum whose values have names.
macro_rules! named_enum {
    ($(#[$meta:meta])* $vis:vis enum $type:ident { $($(#[$about:meta])* $value:ident = $name:expr,)+ }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        $vis enum $type { $($(#[$about])* $value,)+ }

        impl $type {
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$value),+];

            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$value => $name,)+
                }
            }

            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|one| one.name() == name)
            }
        }
    };
}
pub(crate) use named_enum;

/// The only candidate that begins with `word`, or else the one that takes the fewest typing errors to become `word`. The
/// case of letters does not count. `None` if more than a third of the candidate would have to change.
fn closest_match<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let mut longer = candidates.iter().filter(|candidate| candidate.to_lowercase().starts_with(&lower));
    if let (false, Some(only), None) = (word.is_empty(), longer.next(), longer.next()) {
        return Some(only);
    }
    let errors = |candidate: &str| {
        let (own, other) = without_shared_table(&lower, candidate);
        let distance = strsim::osa_distance(own, &other.to_lowercase());
        (3 * distance <= other.chars().count().max(3)).then_some(distance)
    };
    let near = candidates.into_iter().filter_map(|candidate| Some((errors(candidate)?, candidate)));
    near.min_by_key(|(distance, _)| *distance).map(|(_, candidate)| candidate)
}

/// A word and a candidate without the table that both begin with: "yild" and "mass" of "half_space.yild" and "half_space.mass".
fn without_shared_table<'a>(word: &'a str, candidate: &'a str) -> (&'a str, &'a str) {
    let split = |name: &'a str| name.rsplit_once('.').map_or(("", name), |(table, own)| (table, own));
    let ((table, own), (other_table, other)) = (split(word), split(candidate));
    if table == other_table { (own, other) } else { (word, candidate) }
}

/// The candidates of which `word` is a part, or that have all of its parts, or nearly so: "aluminum" and "6061-aluminium" of
/// "aluminium-6061-t6".
fn related_names<'a>(word: &str, candidates: &[&'a str]) -> Vec<&'a str> {
    const MARKS: [char; 4] = ['-', '_', '.', ' '];
    let lower = word.to_lowercase();
    let is_like = |candidate: &&&str| {
        let whole = candidate.to_lowercase();
        let has = |own: &str| whole.split(MARKS).any(|part| 4 * strsim::osa_distance(own, part) <= part.len());
        lower.chars().count() > 2 && (whole.contains(&lower) || lower.split(MARKS).all(has))
    };
    candidates.iter().filter(is_like).copied().collect()
}

/// Other words of the field for names of keys and tables: the word, and the name in a scenario.
const SYNONYMS: [(&str, &str); 23] = [
    ("velocity", "speed"),
    ("v", "speed"),
    ("height", "drop_height"),
    ("ball", "sphere"),
    ("particle", "sphere"),
    ("plate", "half_space"),
    ("rod", "half_space"),
    ("bar", "half_space"),
    ("wall", "half_space"),
    ("target", "half_space"),
    ("block", "half_space"),
    ("substrate", "half_space"),
    ("e", "youngs_modulus"),
    ("modulus", "youngs_modulus"),
    ("elastic_modulus", "youngs_modulus"),
    ("nu", "poissons_ratio"),
    ("poisson", "poissons_ratio"),
    ("rho", "density"),
    ("r", "radius"),
    ("d", "diameter"),
    ("strength", "yield_strength"),
    ("yield_stress", "yield_strength"),
    ("mu", "coefficient"),
];

/// The candidate for which the word is another name; [`SYNONYMS`].
fn synonym<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let (_, name) = SYNONYMS.into_iter().find(|(other, _)| *other == lower)?;
    candidates.iter().copied().find(|candidate| *candidate == name)
}

/// Longer lists of names are not printed whole in a message.
const LONGEST_LIST: usize = 16;
/// The names of a longer list that are printed.
const NEAREST: usize = 5;

/// Which names there are, for the end of a message about an unknown word: all of a short list, the nearest of a long one.
/// `kind` is the name of several of them.
pub fn known_names(word: &str, names: &[&str], kind: &str) -> String {
    if names.len() <= LONGEST_LIST {
        return format!("{kind} are {}", names.join(", "));
    }
    let lower = word.to_lowercase();
    let ends = |name: &str| name.rsplit('.').next().unwrap_or(name).to_lowercase();
    // a key without its table is near to the key with it
    let distance =
        |name: &str| strsim::osa_distance(&lower, &name.to_lowercase()).min(strsim::osa_distance(&lower, &ends(name)));
    let related = related_names(word, names);
    let mut sorted = names.to_vec();
    sorted.sort_by_key(|name| (!related.contains(name), distance(name)));
    format!("the nearest of {} {kind} are {}", names.len(), sorted[..NEAREST].join(", "))
}

/// The end of a message about an unknown word. If some known words are like it, it names them: ", did you mean `plm`? Laws are
/// plm, hertz", or ", did you mean one of `steel-s235`, `steel-s355`?". Else `rest` says what there is: "; laws are plm, hertz".
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>, mark: char, rest: &str) -> String {
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let some = related_names(word, &candidates);
    let near = synonym(word, &candidates).or_else(|| closest_match(word, candidates.iter().copied()));
    match (near, &some[..]) {
        (Some(near), _) | (None, &[near]) => format!(", did you mean {mark}{near}{mark}? {}", capitalise(rest)),
        (None, []) => format!("; {rest}"),
        (None, some) => {
            let some: Vec<String> = some.iter().map(|one| format!("{mark}{one}{mark}")).collect();
            format!(", did you mean one of {}?", some.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_table_does_not_make_keys_alike() {
        let keys = ["half_space.mass", "half_space.yield_strength", "half_space.radius"];
        let message = did_you_mean("half_space.yild", keys, '`', "keys are");
        assert_eq!(message, ", did you mean `half_space.yield_strength`? Keys are");
        let message = did_you_mean("half_space.radus", keys, '`', "keys are");
        assert_eq!(message, ", did you mean `half_space.radius`? Keys are");
    }

    #[test]
    fn five_nearest_of_many_names_are_listed() {
        let names: Vec<String> =
            (0..61).map(|i| format!("half_space.key_{i}")).chain(["half_space.yield_strength".to_owned()]).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let listed = known_names("half_space.yild", &names, "keys");
        assert!(listed.starts_with("the nearest of 62 keys are half_space.yield_strength, "), "{listed}");
        assert_eq!(listed.matches(", ").count(), 4, "{listed}");
    }
}
