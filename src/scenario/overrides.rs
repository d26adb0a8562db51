//! Overrides of the law on the command line, which replace the whole law of the file.

use crate::scene::laws::COMBINED;
use crate::scene::written::{Item, Node, Table, Value};

/// Prepares an override of the law. A scenario has one law, so the law of the override replaces that of the file.
/// A name alone stands for the law with its defaults, or with the keys that the file gives to that law.
pub(super) fn choose_law(root: &mut Table, changes: &mut Table) {
    let Some(law) = changes.get_mut("law") else { return };
    if let Value::Text(name) = &law.value {
        let item = |name: &str, value| Item {
            name: name.trim().to_owned(),
            span: law.span.clone(),
            node: Node { span: law.span.clone(), value },
        };
        let half = |half: &str, law: &str| item(half, Value::Text(law.trim().to_owned()));
        let table = match name.split_once('+') {
            None => item(name, Value::Table(Table::default())),
            Some((loading, unloading)) => {
                item(COMBINED, Value::Table(Table(vec![half("loading", loading), half("unloading", unloading)])))
            }
        };
        law.value = Value::Table(Table(vec![table]));
    }
    if let (Value::Table(chosen), Some(Node { value: Value::Table(laws), .. })) = (&law.value, root.get_mut("law")) {
        laws.0.retain(|law| chosen.get(&law.name).is_some());
    }
}
