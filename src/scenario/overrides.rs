//! Overrides of the law on the command line, which replace the whole law of the file.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Prepares an override of the law. A scenario has one law, so the law of the override replaces that of the file.
/// A name alone stands for the law with its defaults, or with the keys that the file gives to that law.
pub(super) fn choose_law<'a>(root: &mut DeTable<'a>, changes: &mut DeTable<'a>) {
    let Some(law) = changes.get_mut("law") else { return };
    let span = law.span();
    if let DeValue::String(name) = law.get_ref() {
        let word = |text: &str| Spanned::new(span.clone(), text.trim().to_owned().into());
        let (mut table, mut keys) = (DeTable::new(), DeTable::new());
        let key = match name.split_once('+') {
            None => word(name),
            Some((loading, unloading)) => {
                for (half, law) in [("loading", loading), ("unloading", unloading)] {
                    let law = DeValue::String(law.trim().to_owned().into());
                    keys.insert(word(half), Spanned::new(span.clone(), law));
                }
                word("combined")
            }
        };
        table.insert(key, Spanned::new(span.clone(), DeValue::Table(keys)));
        *law.get_mut() = DeValue::Table(table);
    }
    let (DeValue::Table(chosen), Some(DeValue::Table(laws))) =
        (law.get_ref(), root.get_mut("law").map(Spanned::get_mut))
    else {
        return;
    };
    let names: Vec<String> = laws.keys().map(|name| name.get_ref().to_string()).collect();
    for name in names.iter().filter(|name| !chosen.contains_key(name.as_str())) {
        laws.remove(name.as_str());
    }
}
