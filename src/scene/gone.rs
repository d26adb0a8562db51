//! Keys that earlier versions had. The refusal of such a key says what to do instead, and so does the guide.

use super::written::pattern;

/// Paths, and what stands in their place.
const GONE: &[(&str, &str)] = &[
    (
        "compare",
        "compare laws for an impact of your own with an axis, such as law = [\"plm\", \"thornton\"] in [sweep]; `plm-impact validate` draws Figure 10 of the paper",
    ),
    ("indentation.half_space[].youngs_modulus_uncertainty", ENDS),
    ("indentation.half_space[].yield_strength_uncertainty", ENDS),
];

const ENDS: &str = "give the ends of the interval as half-spaces of their own, each with a name";

/// What to do instead of a key of this path, if there was one.
pub fn instead(path: &str) -> Option<&'static str> {
    let pattern = pattern(path);
    GONE.iter().find(|(gone, _)| *gone == pattern).map(|(_, instead)| *instead)
}
