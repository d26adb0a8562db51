//! The full unloadings of the quasi-static runs: results, points of the curves, and shapes of the dents.

rows! {
    /// A full unloading. Lengths are in units of the yield indentation, forces of the yield force.
    pub struct UnloadingRow read by unloadings from "fe_unloading.csv" {
        /// "case3".
        pub case: String,
        /// The run.
        pub run: String,
        /// Number of the unloading in it, from 1.
        pub cycle: u32,
        /// Elements over the contact radius at the peak.
        pub elements as "elements_in_contact": f64,
        /// x_m.
        pub x: f64,
        /// f_m.
        pub f: f64,
        /// δ_s/δ at the peak.
        pub sphere_share: f64,
        /// a_m/R.
        pub contact_radius as "contact_radius_over_R": f64,
        /// δ_r/δ_m.
        pub residual_share: f64,
        /// W/(F_Y δ_Y) of loading, where the loading curve reaches back to first yield.
        pub spent: Option<f64>,
        /// √(recovered/spent work), if the spent work is known.
        pub restitution: Option<f64>,
        /// R_res/R fitted within the contact radius.
        pub residual_radius as "residual_radius_over_R": f64,
        /// R_res/R fitted within 0.7 of the contact radius.
        pub inner_residual_radius as "inner_residual_radius_over_R": f64,
    }
}

rows! {
    /// A full unloading whose loading is known back to first yield, in units of the yield point.
    pub struct Unloaded {
        /// Name of the material, or of the case.
        pub material: String,
        /// x_m.
        pub x: f64,
        /// f_m.
        pub f: f64,
        /// W/(F_Y δ_Y) of loading.
        pub spent: f64,
        /// a_m/R.
        pub contact_radius as "contact_radius_over_R": f64,
        /// δ_r/δ_m.
        pub residual_share: f64,
        /// √(recovered/spent work).
        pub restitution: f64,
    }
}

rows! {
    /// An increment in contact on the way back, behind the peak.
    pub struct UnloadingPoint read by points from "fe_unloading_curves.csv" {
        pub run: String,
        pub cycle: u32,
        /// x.
        pub x: f64,
        /// f.
        pub f: f64,
    }
}
