//! Warnings about keys without effect.

use super::effect::Facts;
use crate::impact::Warning;
use crate::scenario::input::{Input, REQUIRED_KEYS, alternatives_to};
use crate::scenario::keys::ALL_KEYS;
use crate::scenario::{Kind, Scenario};

impl Scenario {
    /// Warnings about given keys that have no effect on the results of these inputs. Such keys are allowed, as the file may also be run
    /// in another way. Needed keys get no warning.
    pub fn unused_key_warnings(&self, inputs: &[Input], kind: Kind) -> Vec<Warning> {
        let facts = Facts { inputs, kind, varied: &[] };
        let has_motion = matches!(kind, Kind::Impact | Kind::Repeat);
        let needed = &REQUIRED_KEYS[..REQUIRED_KEYS.len() - if has_motion { 0 } else { 2 }];
        let is_needed =
            |path: &str| needed.contains(&path) || alternatives_to(path).any(|other| needed.contains(&other));
        let keys = ALL_KEYS
            .iter()
            .map(|key| key.path)
            .filter(|path| !path.starts_with("law.") && self.document.contains(path));
        let given = keys.chain(self.document.keys_below("law.")).filter(|path| !is_needed(path));
        given.filter_map(|path| Some(Warning::unused_key(path, facts.why_unused(path)?))).collect()
    }
}
