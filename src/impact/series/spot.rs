//! A spot on the half-space and its memory, for repeated impacts.

use crate::contact::law::{ContactState, LoadingHistory};
use crate::impact::oblique::Approach;
use crate::impact::problem::contact::Contact;
use crate::impact::problem::error::ImpactError;
use crate::impact::result::impact::Impact;
use crate::impact::solve::Solver;

/// A spot on the half-space. The indentations of all its impacts are measured from the original surface, so first contact is at the
/// depth of the dent.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Spot {
    /// `None` on fresh surface.
    dent: Option<LoadingHistory>,
}

impl Spot {
    /// A spot without an impact.
    pub fn new() -> Self {
        Self::default()
    }

    /// The largest state so far, in units of the yield point; `None` if the spot never yielded.
    pub fn memory(&self) -> Option<ContactState> {
        Some(self.dent.as_ref()?.unloading.peak)
    }
}

impl Contact {
    /// Depth of the dent of a spot \[m\], at which the next contact begins.
    pub fn dent_depth(&self, spot: &Spot) -> f64 {
        spot.memory().map_or(0.0, |memory| memory.residual() * self.scales.units.length)
    }

    /// Like [`Contact::impact`], on a spot, which then remembers the impact.
    ///
    /// # Errors
    /// The errors of [`Contact::impact`]; the spot does not change then.
    pub fn impact_on(
        &self,
        spot: &mut Spot,
        approach: impl Into<Approach>,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        let approach = approach.into();
        if self.has_rate() {
            let rated = self.at_speed(approach.normal)?;
            return self.rate_dependent_impact_on(spot, &rated, approach, solver, samples);
        }
        let (impact, ground, unloading) = self.impact_on_surface(spot.dent.as_ref(), approach, solver, samples)?;
        if ground.keeps_mark_of(&unloading.peak) {
            spot.dent = Some(self.law.history_after(unloading.peak));
        }
        Ok(impact)
    }

    /// An impact of a contact with a strain rate: reloading follows the old branch to its end, and then its continuation until it meets
    /// the loading curve at the new rate. The memory of the spot is in the units of this contact.
    fn rate_dependent_impact_on(
        &self,
        spot: &mut Spot,
        rated: &Self,
        approach: Approach,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        let (length, force) =
            (rated.scales.units.length / self.scales.units.length, rated.scales.units.force / self.scales.units.force);
        let met = spot
            .dent
            .as_ref()
            .map(|dent| rated.law.dent_of_other_rate(&dent.unloading.in_units(1.0 / length, 1.0 / force)));
        let (impact, ground, unloading) = rated.impact_on_surface(met.as_ref(), approach, solver, samples)?;
        if ground.keeps_mark_of(&unloading.peak) {
            spot.dent = Some(self.law.history_after_unloading(unloading.in_units(length, force)));
        }
        Ok(impact)
    }
}
