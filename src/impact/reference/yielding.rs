//! Load cycles by finite elements in which the sphere yields, alone or with the half-space. Numbers without a unit in their column
//! are in SI units.

use crate::contact::material::{HalfSpace, Material, Pair, PairError, Sphere};

rows! {
    /// A load cycle of two bodies that are elastic-perfectly plastic, or elastic without a strength.
    pub struct Cycle read by cycles from "fe_yielding.csv" {
        /// The pair of bodies, such as "S1".
        pub case: String,
        radius as "sphere.radius": f64,
        sphere_modulus as "sphere.youngs_modulus": f64,
        sphere_poissons_ratio as "sphere.poissons_ratio": f64,
        sphere_strength as "sphere.yield_strength": Option<f64>,
        half_space_modulus as "half_space.youngs_modulus": f64,
        half_space_poissons_ratio as "half_space.poissons_ratio": f64,
        half_space_strength as "half_space.yield_strength": Option<f64>,
        pub peak_indentation as "delta_m": f64,
        pub peak_force as "F_N": f64,
        /// Work of loading \[J\].
        pub spent as "W_J": f64,
        /// a_m/R.
        pub contact_radius as "contact_radius_over_R": f64,
        pub residual_indentation as "residual_m": f64,
        /// √(recovered/spent work).
        pub restitution as "e": f64,
        /// Elements over the contact radius at the peak.
        pub elements as "elements_in_contact": f64,
    }
}

impl Cycle {
    /// The two bodies. A load cycle is slow, so they have no density.
    pub fn pair(&self) -> Result<Pair, PairError> {
        let material = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
        let of_sphere = material(self.sphere_modulus, self.sphere_poissons_ratio);
        let sphere =
            Sphere { yield_strength: self.sphere_strength, ..Sphere::elastic(self.radius, of_sphere, f64::NAN) };
        let of_half_space = material(self.half_space_modulus, self.half_space_poissons_ratio);
        Pair::try_new(&sphere, &HalfSpace::flat(of_half_space, self.half_space_strength))
    }
}
