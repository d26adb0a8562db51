//! The few results of an impact that most people ask for, from its summary.

use serde_json::Value;

use crate::units::aligned::aligned;
use crate::units::four_digits;
use crate::units::rounded::quantity;

/// The results that are shown, by their names in `summary.json`.
/// Each with its label and its unit.
const SHOWN: [(&str, &str, &str); 10] = [
    ("impact speed", "impact_speed_m_per_s", "m/s"),
    ("restitution", "restitution", ""),
    ("with waves", "restitution_with_waves", ""),
    ("rebound height", "rebound_height_m", "m"),
    ("rebound angle (deg)", "rebound_angle_deg", ""),
    ("flat diameter", "flat_diameter_m", "m"),
    ("dent diameter", "dent_diameter_m", "m"),
    ("dent depth", "residual_indentation_m", "m"),
    ("peak force", "peak_force_N", "N"),
    ("contact time", "contact_time_s", "s"),
];

/// The results that are there, one a line.
pub fn brief(summary: &Value) -> String {
    let row = |(label, name, unit): (&str, &str, &str)| {
        let value = summary[name].as_f64()?;
        let text = if unit.is_empty() { four_digits(value) } else { quantity(value, unit) };
        let band = summary["restitution_band"].as_str().filter(|_| name == "restitution");
        Some([label.to_owned(), text, band.map_or_else(String::new, |band| format!("({band})"))])
    };
    aligned(&SHOWN.into_iter().filter_map(row).collect::<Vec<_>>(), |_| true)
}
