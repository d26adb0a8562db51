//! Keys that earlier versions had. The refusal of such a key says what to do instead, and so does the guide.

use super::written::pattern;

/// Paths, and what stands in their place.
const GONE: &[(&str, &str)] = &[
    (
        "compare",
        "compare laws for an impact of your own with an axis, such as law = [\"plm\", \"thornton\"] in [sweep]; `plm-impact validate` draws Figure 10 of the paper",
    ),
    ("law.jackson_green.jumps", PIECES_MEET),
    ("law.kogut_etsion.jumps", PIECES_MEET),
    ("law.kogut_komvopoulos.jumps", PIECES_MEET),
    ("indentation.half_space[].youngs_modulus_uncertainty", ENDS),
    ("indentation.half_space[].yield_strength_uncertainty", ENDS),
];

const PIECES_MEET: &str = "leave it out; every piece of the law goes on until it crosses the next one";

const ENDS: &str = "give the ends of the interval as half-spaces of their own, each with a name";

/// Says what to do instead of a key of this path, if there was one.
pub fn instead(path: &str) -> Option<&'static str> {
    let pattern = pattern(path);
    GONE.iter().find(|(gone, _)| *gone == pattern).map(|(_, instead)| *instead)
}
