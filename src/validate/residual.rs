//! Plastic zone and residual stress below a dent: the fitted formulas, at the contact radius and the strength of the finite elements.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::impact::Subsurface;
use crate::reference::{RESIDUAL_STRESSES, ReferenceRow};

const SOURCE: &str = "finite elements of the residual stress below a dent, src/reference/fe_residual.csv";

/// A dent by finite elements, and the state below this dent. Lengths are in units of the contact radius, stresses in units of the yield
/// strength.
type Dent = (ReferenceRow, Subsurface);

const QUANTITIES: [ComparedQuantity<Dent>; 3] = [
    (Group::new("below a dent: depth of the compressive layer", SOURCE, ""), |(row, below)| {
        Some([row.number("layer_depth"), below.layer_depth()])
    }),
    (Group::new("below a dent: depth of the plastic zone", SOURCE, ""), |(row, below)| {
        Some([row.number("zone_depth"), below.zone_depth()])
    }),
    (
        Group::new_difference("below a dent: largest compression, deviation over the flow stress", SOURCE, ""),
        |(row, below)| Some([row.number("compression"), below.largest_compression() / below.representative_strength()]),
    ),
];

pub(super) fn dents(_: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let below = |row: &ReferenceRow| Subsurface {
        contact_radius: 1.0,
        radius_ratio: row.number("contact_radius_over_R"),
        yield_strength: 1.0,
        strength_ratio: row.number("strength_ratio"),
        effective_modulus: 1.0 / row.number("strength_over_modulus"),
    };
    let dents: Vec<Dent> = RESIDUAL_STRESSES
        .rows()?
        .into_iter()
        .map(|row| {
            let below = below(&row);
            (row, below)
        })
        .collect();
    let name = |(row, _): &Dent| format!("{}, unloading {}", row.cell_text("case"), row.cell_text("unloading"));
    Ok(compare_all(&QUANTITIES, &dents, name))
}
