//! The registry of results: what a table says of an impact, column by column.

use super::Scene;
use crate::impact::Essentials;

/// What a scene has to name for a result to exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// Every impact has the result.
    Nothing,
    /// The yield strength of the half-space: without it nothing is plastic.
    Strength,
    /// The density of the half-space: without it nothing is known of elastic waves.
    Density,
}

/// A column of results.
#[derive(Debug, Clone, Copy)]
pub struct ResultColumn {
    /// Its name, which ends in the unit.
    pub name: &'static str,
    /// What it needs of the scene.
    pub needs: Needs,
    /// Its value; `None` is an empty field.
    pub value: fn(&Essentials) -> Option<f64>,
}

impl ResultColumn {
    /// Why impacts of this scene do not have it; `None` where they do.
    #[must_use]
    pub fn missing(&self, scene: &Scene) -> Option<&'static str> {
        match self.needs {
            Needs::Strength if scene.half_space.yield_strength.is_none() => {
                Some("without half_space.yield_strength there is no dent")
            }
            Needs::Density if scene.half_space.density.is_none() => {
                Some("without half_space.density nothing is known of elastic waves")
            }
            _ => None,
        }
    }
}

const fn column(name: &'static str, needs: Needs, value: fn(&Essentials) -> Option<f64>) -> ResultColumn {
    ResultColumn { name, needs, value }
}

/// The columns between the swept values and the status.
pub const RESULT_COLUMNS: &[ResultColumn] = &[
    column("restitution", Needs::Nothing, |row| row.has_speed().then_some(row.restitution)),
    column("contact_time_s", Needs::Nothing, |row| row.contact_time.is_finite().then_some(row.contact_time)),
    column("peak_force_N", Needs::Nothing, |row| Some(row.peak_force)),
    column("peak_indentation_m", Needs::Nothing, |row| Some(row.peak_indentation)),
    column("residual_indentation_m", Needs::Strength, |row| Some(row.residual_indentation)),
    column("dent_radius_m", Needs::Strength, |row| row.has_dent().then_some(row.peak_contact_radius)),
    column("recovered_fraction", Needs::Nothing, |row| row.has_speed().then(|| row.recovered_fraction())),
    column("plastic_fraction", Needs::Strength, |row| row.has_speed().then_some(row.plastic_fraction)),
    column("wave_loss_fraction", Needs::Density, |row| row.wave_loss_fraction),
    column("restitution_with_waves", Needs::Density, Essentials::restitution_with_waves),
];
