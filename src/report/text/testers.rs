//! The table of rebound testers that a scenario is recognised as.

use crate::results::hardness_scales::{LEEB_TESTERS, ReboundTester, SCLEROSCOPE};
use crate::units::{Dimension, format_result};

/// A head, and a row for every tester.
pub fn tester_rows() -> Vec<[String; 5]> {
    let heads = ["scale", "tester", "mass", "radius and material of the tip", "energy"];
    let row = |tester: &ReboundTester| {
        let material = if tester.has_diamond_tip { "diamond" } else { "tungsten carbide" };
        let radius = tester.tip_radius.map_or("any".to_owned(), |radius| format_result(radius, Dimension::Length));
        let mass = format_result(tester.mass, Dimension::Mass);
        let energy = format_result(tester.energy, Dimension::Energy);
        [tester.scale.to_owned(), tester.title.to_owned(), mass, format!("{radius}, {material}"), energy]
    };
    let mut rows = vec![heads.map(ToOwned::to_owned)];
    rows.extend(LEEB_TESTERS.iter().chain([&SCLEROSCOPE]).map(row));
    rows
}
