//! The warning for two balls of one material of which only one has a strength.

use crate::contact::body::Support;
use crate::impact::problem::contact::Contact;
use crate::impact::result::impact::Impact;
use crate::impact::result::warning::{Warning, WarningKind};

/// The warning for a ball on a ball of the same elastic constants, where one strength is missing and the other ball yields.
pub(super) fn missing_strength_warning(contact: &Contact, impact: &Impact) -> Option<Warning> {
    let (sphere, target) = (contact.sphere(), contact.half_space());
    let is_of_two_balls = target.support == Support::Ball && sphere.material == target.material;
    let [elastic, yielding] = match [sphere.yield_strength, target.yield_strength] {
        [None, Some(_)] => ["sphere", "half_space"],
        [Some(_), None] => ["half_space", "sphere"],
        _ => return None,
    };
    Warning::new_if(is_of_two_balls && impact.row.has_dent(), WarningKind::OneBallYields, 0.0, || {
        format!(
            "e has an error of up to 7 % (mostly too high) if both balls are of one material. The balls have the same elastic constants, but only {yielding} has a strength; {elastic} stays elastic. Set {elastic}.yield_strength too, unless that ball is much harder."
        )
    })
}
