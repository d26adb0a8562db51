//! The list of laws for the terminal.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::contact::law::catalogue::unimplemented_laws;
use crate::contact::law::{LawChoice, LawInfo};

pub fn laws_json() -> Value {
    let laws: Vec<&LawInfo> = LawChoice::all().iter().map(LawChoice::info).collect();
    let missing = unimplemented_laws().map(|(title, reason)| json!({ "title": title, "reason": reason }));
    json!({ "laws": laws, "not_here": missing.collect::<Vec<_>>() })
}

/// A paragraph for every law, then the laws that are missing, each with the reason.
pub fn laws_text() -> String {
    let mut text =
        "Laws for [law.<name>], for the axis \"law\" of a sweep, and for the halves of [law.combined]:\n\n".to_owned();
    for law in LawChoice::all() {
        let about = law.info();
        let _ = writeln!(text, "{}\n  {}", about.name, about.title);
        let lines = [
            ("source", about.source),
            ("loading", about.loading),
            ("unloading", about.unloading),
            ("validity", about.validity),
            ("confidence", about.confidence),
        ];
        for (name, line) in lines {
            let _ = writeln!(text, "  {name:<10}  {line}");
        }
        text.push('\n');
    }
    text.push_str("Not included:\n\n");
    for (title, reason) in unimplemented_laws() {
        let _ = writeln!(text, "{title}\n  {reason}");
    }
    text
}
