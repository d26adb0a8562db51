//! A key that is swept or random need not stand in its own table too: the first value of its axis stands in for it.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::explain::span_of;

/// What an impact cannot do without, any key of a group in place of the others.
const NEEDED: [&[&str]; 7] = [
    &["sphere.radius", "sphere.diameter"],
    &["sphere.youngs_modulus"],
    &["sphere.poissons_ratio"],
    &["sphere.density"],
    &["half_space.youngs_modulus"],
    &["half_space.poissons_ratio"],
    &["impact.speed", "impact.drop_height"],
];

/// Fills in what is missing from the axes of `[sweep]` or the distributions of `[monte_carlo]`.
pub(super) fn fill(root: &mut DeTable<'_>) {
    for group in NEEDED {
        fill_one(root, group);
    }
    if span_of(root, "impact.drop_height").is_some() {
        fill_one(root, &["gravity.acceleration"]);
    }
}

fn fill_one(root: &mut DeTable<'_>, group: &[&str]) {
    if group.iter().any(|path| span_of(root, path).is_some()) {
        return;
    }
    let found = group.iter().find_map(|path| Some((path.split_once('.')?, first_of_axis(root, path)?)));
    let Some(((table, key), value)) = found else { return };
    let span = value.span();
    // bodies have more keys than the one that varies, so that a body without a table is an oversight
    if matches!(table, "impact" | "gravity") && !root.contains_key(table) {
        root.insert(
            Spanned::new(span.clone(), table.to_owned().into()),
            Spanned::new(span.clone(), DeValue::Table(DeTable::new())),
        );
    }
    if let Some(DeValue::Table(inner)) = root.get_mut(table).map(Spanned::get_mut) {
        inner.insert(Spanned::new(span, key.to_owned().into()), value);
    }
}

fn first_of_axis<'a>(root: &DeTable<'a>, path: &str) -> Option<Spanned<DeValue<'a>>> {
    ["sweep", "monte_carlo"].iter().find_map(|table| match root.get(*table)?.get_ref() {
        DeValue::Table(axes) => first(axes.get(path)?),
        _ => None,
    })
}

/// The first value of a list, of a range, or the middle of a distribution.
fn first<'a>(axis: &Spanned<DeValue<'a>>) -> Option<Spanned<DeValue<'a>>> {
    match axis.get_ref() {
        DeValue::Array(list) => list.first().cloned(),
        DeValue::Table(table) => {
            let range = ["linspace", "logspace", "uniform"].iter().find_map(|name| first(table.get(*name)?));
            let moments = || ["normal", "lognormal"].iter().find_map(|name| table.get(*name));
            range.or_else(|| match moments()?.get_ref() {
                DeValue::Table(moments) => moments.get("mean").cloned(),
                _ => None,
            })
        }
        _ => None,
    }
}
