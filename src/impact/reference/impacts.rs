//! Whole impacts by explicit finite elements.

rows! {
    /// The result of the finite elements for an impact.
    pub struct ImpactRow read by impacts from "fe_dynamic.csv" {
        /// "D1".
        pub case: String,
        /// e.
        pub restitution: f64,
        pub contact_time as "contact_time_s": f64,
        pub peak_force as "peak_force_N": f64,
        pub residual_indentation as "residual_indentation_m": f64,
        /// Radiated as elastic waves, of the kinetic energy.
        pub radiated_share: f64,
    }
}

rows! {
    pub struct Sample read by samples from "fe_dynamic_curves.csv" {
        pub case: String,
        pub time as "time_s": f64,
        pub force as "force_N": f64,
        /// Approach of the centre of mass \[m\].
        pub indentation as "indentation_m": f64,
        pub sphere_indentation as "sphere_indentation_m": f64,
        pub half_space_indentation as "half_space_indentation_m": f64,
    }
}

rows! {
    /// An impact on a half-space whose strength rises with the strain rate, and the result of the finite elements.
    pub struct RatedRow read by rated from "fe_rate.csv" {
        pub case: String,
        pub radius as "sphere.radius": f64,
        pub sphere_modulus as "sphere.youngs_modulus": f64,
        pub sphere_poissons_ratio as "sphere.poissons_ratio": f64,
        pub sphere_density as "sphere.density": f64,
        pub half_space_modulus as "half_space.youngs_modulus": f64,
        pub half_space_poissons_ratio as "half_space.poissons_ratio": f64,
        pub half_space_density as "half_space.density": f64,
        pub yield_strength as "half_space.yield_strength": f64,
        /// c of Johnson and Cook's form; `None` in a row of the other form.
        pub c as "half_space.rate.johnson_cook.c": Option<f64>,
        pub reference as "half_space.rate.johnson_cook.reference": Option<f64>,
        /// D \[1/s\] of Cowper and Symonds' form; `None` in a row of the other form.
        pub rate as "half_space.rate.cowper_symonds.rate": Option<f64>,
        pub exponent as "half_space.rate.cowper_symonds.exponent": Option<f64>,
        /// The rate at which the factor is 1.
        pub tested_at as "half_space.rate.tested_at": f64,
        pub speed as "impact.speed": f64,
        pub restitution: f64,
        pub peak_force as "peak_force_N": f64,
        pub contact_time as "contact_time_s": f64,
        pub peak_indentation as "peak_indentation_m": f64,
        pub residual_indentation as "residual_indentation_m": f64,
    }
}

pub const TABLE: &str = "fe_dynamic.csv";
