//! Which stress of a metal a number is.

use crate::strings::names::named_enum;

/// The plastic strains of an impact, from a/R = 0.02 to 0.3: 0.37 (√(δ/R) − √(δ_Y/R)).
pub const IMPACT_STRAINS: &str = "0.5 to 8 %";

named_enum! {
    /// The kind of a strength.
    pub enum StrengthKind {
        /// The stress at which the metal yields in the impact: at its strain, 0.5 to 8 %, and at its strain rate.
        Flow = "flow",
        /// The 0.2 % proof stress of a slow tensile test.
        Proof = "proof",
    }
}
