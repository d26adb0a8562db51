//! "Did you mean": the known word most like an unknown one.

/// The candidate that takes the fewest typing errors to become `word`, whatever the case of its letters; `None` if more
/// than a third of it would have to change.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    candidates
        .into_iter()
        .map(|candidate| (strsim::osa_distance(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| 3 * distance <= candidate.chars().count().max(3))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// ", did you mean `word`?" with this quotation mark, or nothing where no candidate is near.
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>, mark: char) -> String {
    nearest(word, candidates).map_or_else(String::new, |near| format!(", did you mean {mark}{near}{mark}?"))
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_is_recognised_and_another_word_is_not() {
        let known = ["radius", "density", "poissons_ratio"];
        assert_eq!(nearest("raduis", known), Some("radius"));
        assert_eq!(nearest("poisson_ratio", known), Some("poissons_ratio"));
        assert_eq!(nearest("Density", known), Some("density"));
        assert_eq!(nearest("temperature", known), None);
        assert_eq!(nearest("mPa", ["Pa", "kPa", "MPa"]), Some("MPa"));
    }
}
