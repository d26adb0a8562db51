//! The registry of results. (The columns of tables; the rest of the results joins them here.)

/// Names of the results that a table may have.
pub const TABLE_COLUMNS: &[&str] = &[
    "restitution",
    "contact_time_s",
    "peak_force_N",
    "peak_indentation_m",
    "residual_indentation_m",
    "dent_radius_m",
    "recovered_fraction",
    "plastic_fraction",
    "wave_loss_fraction",
    "restitution_with_waves",
];
