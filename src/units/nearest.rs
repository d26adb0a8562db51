//! "Did you mean": the known word most like an unknown one.

use super::capital;

/// The only candidate that begins with `word`, or else the one that takes the fewest typing errors to become `word`. The
/// case of letters does not count. `None` if more than a third of the candidate would have to change.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let mut longer = candidates.iter().filter(|candidate| candidate.to_lowercase().starts_with(&lower));
    if let (false, Some(only), None) = (word.is_empty(), longer.next(), longer.next()) {
        return Some(only);
    }
    candidates
        .into_iter()
        .map(|candidate| (strsim::osa_distance(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| 3 * distance <= candidate.chars().count().max(3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// The end of a message about an unknown word: the known word most like it, if there is one, and then `rest`, which says
/// what there is: ", did you mean `plm`? Laws are plm, hertz", or "; laws are plm, hertz".
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>, mark: char, rest: &str) -> String {
    let Some(near) = nearest(word, candidates) else { return format!("; {rest}") };
    format!(", did you mean {mark}{near}{mark}? {}", capital(rest))
}

#[cfg(test)]
mod tests {
    use super::{did_you_mean, nearest};

    #[test]
    fn what_there_is_follows_a_question_as_a_sentence_of_its_own() {
        let of = |word| {
            format!("unknown law \"{word}\"{}", did_you_mean(word, ["plm", "hertz"], '"', "laws are plm, hertz"))
        };
        assert_eq!(of("pml"), "unknown law \"pml\", did you mean \"plm\"? Laws are plm, hertz");
        assert_eq!(of("water"), "unknown law \"water\"; laws are plm, hertz");
    }

    #[test]
    fn a_slip_is_recognised_and_another_word_is_not() {
        let known = ["radius", "density", "poissons_ratio"];
        assert_eq!(nearest("raduis", known), Some("radius"));
        assert_eq!(nearest("poisson_ratio", known), Some("poissons_ratio"));
        assert_eq!(nearest("Density", known), Some("density"));
        assert_eq!(nearest("temperature", known), None);
        assert_eq!(nearest("mPa", ["Pa", "kPa", "MPa"]), Some("MPa"));
        // the beginning of one name alone
        assert_eq!(nearest("steel-316", ["steel-s355", "steel-316l-annealed"]), Some("steel-316l-annealed"));
        assert_eq!(nearest("steel", ["steel-s355", "steel-316l-annealed"]), None);
    }
}
