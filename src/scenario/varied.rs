//! The keys that vary in a scenario: `[sweep]`, `[monte_carlo]` and the keys that a calibration finds.

use toml::de::{DeTable, DeValue};

use super::axes::{self, RandomKeys};
use crate::scenario::plan::{Axis, Free};
use crate::scenario::scene::read::Reader;

/// The keys that vary. In most scenarios there are none.
#[derive(Debug, Clone, Default)]
pub(super) struct Varied {
    pub(super) sweep: Option<Vec<Axis>>,
    pub(super) monte_carlo: Option<RandomKeys>,
    pub(super) free: Option<Vec<Free>>,
}

impl Varied {
    /// Reads it from the tables of a scenario. What is refused stays with the reader.
    pub(super) fn read(tables: &DeTable, reader: &mut Reader) -> Self {
        let mut varied = Self::default();
        if let Some(node) = tables.get("sweep") {
            reader.in_table("sweep", |reader| axes::axes(node, reader).map(|axes| varied.sweep = Some(axes)));
        }
        if let Some(node) = tables.get("monte_carlo") {
            reader
                .in_table("monte_carlo", |reader| varied.monte_carlo.insert(RandomKeys::default()).read(node, reader));
        }
        if let Some(DeValue::Table(calibrate)) = tables.get("calibrate").map(toml::Spanned::get_ref)
            && let Some(node) = calibrate.get("free")
        {
            reader.in_table("calibrate.free", |reader| {
                axes::free_keys(node, reader).map(|free| varied.free = Some(free))
            });
        }
        varied
    }

    /// The keys that vary, or are to be found.
    pub(super) fn paths(&self) -> Vec<&'static str> {
        let axes = self.sweep.iter().flatten().map(Axis::path);
        let variables = self.monte_carlo.iter().flat_map(|random| &random.variables).map(|variable| variable.key.path);
        let free = self.free.iter().flatten().map(|free| free.key.path);
        axes.chain(variables).chain(free).collect()
    }
}
