//! The keys that vary in a scenario: `[sweep]`, `[monte_carlo]` and the keys that a calibration finds.

use toml::de::{DeTable, DeValue};

use super::read_axes;
use super::read_axes::RandomKeys;
use crate::scenario::input::reader::Reader;
use crate::scenario::plan::{FreeKey, SweepAxis};

/// The keys that vary. In most scenarios there are none.
#[derive(Debug, Clone, Default)]
pub(in crate::scenario) struct VariedKeys {
    pub(in crate::scenario) sweep: Option<Vec<SweepAxis>>,
    pub(in crate::scenario) monte_carlo: Option<RandomKeys>,
    pub(in crate::scenario) free: Option<Vec<FreeKey>>,
}

impl VariedKeys {
    /// Reads it from the tables of a scenario. What is refused stays with the reader.
    pub(in crate::scenario) fn read(tables: &DeTable, reader: &mut Reader) -> Self {
        let mut varied = Self::default();
        if let Some(node) = tables.get("sweep") {
            reader.in_table("sweep", |reader| read_axes::read_axes(node, reader).map(|axes| varied.sweep = Some(axes)));
        }
        if let Some(node) = tables.get("monte_carlo") {
            reader
                .in_table("monte_carlo", |reader| varied.monte_carlo.insert(RandomKeys::default()).read(node, reader));
        }
        if let Some(DeValue::Table(calibrate)) = tables.get("calibrate").map(toml::Spanned::get_ref)
            && let Some(node) = calibrate.get("free")
        {
            reader.in_table("calibrate.free", |reader| {
                read_axes::read_free_keys(node, reader).map(|free| varied.free = Some(free))
            });
        }
        varied
    }

    /// The keys that vary, or are to be found.
    pub(in crate::scenario) fn paths(&self) -> Vec<&'static str> {
        let axes = self.sweep.iter().flatten().map(SweepAxis::path);
        let variables =
            self.monte_carlo.iter().flat_map(|random| &random.variables).map(|variable| variable.key.path());
        let free = self.free.iter().flatten().map(|free| free.key.path());
        axes.chain(variables).chain(free).collect()
    }
}
