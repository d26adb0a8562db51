//! The message about a missing key.

use super::file::{every_key, list_of};
use crate::scene::key::Form;

/// The message that `name` is missing in `table`; where `table` is empty, that the table `name` is missing.
pub(super) fn missing(name: &str, table: &str) -> String {
    if table.is_empty() {
        let way_out = match name {
            "sphere" => "; give its radius, youngs_modulus, poissons_ratio and density",
            "half_space" => "; give its youngs_modulus, poissons_ratio and, unless it is elastic, yield_strength",
            "impact" => "; give it with a speed such as speed = \"3 m/s\"",
            _ => "",
        };
        return format!("the table [{name}] is missing{way_out}");
    }
    // an item of a list has the keys of all its items
    let pattern = match table.split_once('[') {
        Some((list, _)) => format!("{list}[].{name}"),
        None => format!("{table}.{name}"),
    };
    let example = match every_key().find(|key| key.path == pattern).map(|key| key.form) {
        _ if pattern == "law.combined.loading" => "the law that loads, such as loading = \"plm\"".to_owned(),
        _ if pattern == "law.combined.unloading" => "the law that unloads, such as unloading = \"thornton\"".to_owned(),
        Some(Form::Number(quantity) | Form::NumberOr(quantity, _) | Form::Count(quantity)) => {
            format!("{} such as {name} = {}", quantity.name, quantity.example)
        }
        Some(Form::Text(example)) => format!("a text such as {name} = \"{example}\""),
        _ => match list_of(&pattern) {
            Some(list) => format!("a list such as {}", list.example),
            None => return format!("the key `{name}` is missing"),
        },
    };
    format!("the key `{name}` is missing: {example}")
}
