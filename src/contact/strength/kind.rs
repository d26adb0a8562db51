//! Which stress of a metal a number is.

use crate::strings::names::named_enum;

named_enum! {
    /// The kind of a strength.
    pub enum StrengthKind {
        /// The stress at which the metal yields in the impact: at its strain, 1 to 8 %, and at its strain rate.
        Flow = "flow",
        /// The 0.2 % proof stress of a slow tensile test.
        Proof = "proof",
    }
}
