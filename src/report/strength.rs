//! A note on the yield strength, for scenarios that may give the wrong one.

use crate::material::HalfSpace;

/// Hardening matters above this plastic strain.
const DEEP: f64 = 0.01;

/// A paragraph on the yield strength of a metal that is dented up to δ/R = `depth`; `None` for a shallow contact, for a
/// body that is not a metal, and where the scenario describes the flow stress more precisely (`is_precise`).
pub fn which(half_space: &HalfSpace, is_precise: bool, depth: f64) -> Option<String> {
    let modulus = half_space.material.youngs_modulus;
    let is_metal = modulus >= 1e10 && half_space.yield_strength.is_some_and(|strength| modulus >= 50.0 * strength);
    // Tabor's 0.2 a/R, with a = √(2 R δ) of a plastic contact
    let strain = 0.2 * (2.0 * depth).sqrt();
    (is_metal && !is_precise && strain > DEEP).then(|| {
        format!(
            r#"
Which strength? The law takes half_space.yield_strength for the stress at which the metal flows under the sphere,
here at plastic strains of about {:.0} %. Only for a metal that does not harden is this the 0.2 % proof stress. For any
other metal the proof stress is too low, and so is e: by 15 % (rms) and up to 37 % in finite elements of ten metals, by
about 30 % for a structural steel. Better: give yield_strength with [half_space.flow_stress] under the law plm; or give
half_space.hardness such as "300 HV", with flow_stress.power if the metal hardens. For a metal that does not harden, give
its hardness, or flow_stress.power.exponent = 0; then this note is not shown.
"#,
            100.0 * strain
        )
    })
}
