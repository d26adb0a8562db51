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

pub const TABLE: &str = "fe_dynamic.csv";
