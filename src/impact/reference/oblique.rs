//! Measured and computed oblique rebounds.

rows! {
    /// A measured rebound of Kharaz, Gorham and Salman (2001).
    pub struct Rebound read by rebounds from "kharaz.csv" {
        /// `tangential_restitution`, `spin_rad_per_s` or `rebound_angle_deg`.
        pub quantity: String,
        /// Angle of impact from the normal.
        pub angle as "angle_deg": f64,
        pub value: f64,
    }
}

rows! {
    /// Slip speed before and after an impact, in units of friction times normal speed.
    pub struct Slip read by slips from "fe_oblique.csv" {
        pub before as "slip_before": f64,
        pub after as "slip_after": f64,
    }
}
