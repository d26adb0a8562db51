//! Where a key gets its value from, or a table its keys.

use super::Scenario;
use super::input::BodyMaterial;
use super::input::read_input::is_at_or_below;

/// The origin of a key, or of the keys of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Origin {
    /// True if the file, the command line or a named material gives a value or a table.
    pub is_given: bool,
    /// The key itself varies over the cases of a table, or is a free key of a calibration.
    pub varies: bool,
    /// The key, or a key of the table, varies or stands among the keys that vary, even with a refused value.
    pub has_axis: bool,
}

impl Origin {
    pub fn is_given_or_varies(self) -> bool {
        self.is_given || self.has_axis
    }
}

impl Scenario {
    /// True if the file, an override or a material gives a key, or a key of a table.
    pub fn is_given(&self, path: &str) -> bool {
        let mut of_materials = self.input.materials().iter().flat_map(BodyMaterial::known_values);
        self.document.contains(path) || of_materials.any(|(given, _)| given == path)
    }

    /// The origin of a key, or of the keys of a table.
    pub fn origin(&self, path: &str) -> Origin {
        let varied = self.variation.paths();
        let is_in = |table: &str| self.document.contains(&format!("{table}.{path}"));
        Origin {
            is_given: self.is_given(path),
            varies: varied.contains(&path),
            has_axis: varied.iter().any(|varied| is_at_or_below(varied, path))
                || ["sweep", "monte_carlo", "calibrate.free"].into_iter().any(is_in),
        }
    }
}
