//! Unloading laws side by side, from one peak: the figure that Xie et al. (2024) draw for theirs (Fig. 10).
//!
//! The peak is a state of loading: indentation, force, contact radius, the sphere's own indentation. Every law unloads from
//! it by its own formulas; nothing here knows of motion.

use crate::impact::Warning;
use crate::law::published::PeakState;
use crate::law::{Bodies, LawChoice, OutsideLaw, Peak, Plm, Unloading};
use crate::reference::quasi_static::{self, UnloadingCurve};
use crate::reference::unloading::Unloaded;

/// Where a peak comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The PLM at that indentation.
    Plm,
    /// Numbers of the scenario.
    Given,
}

/// One peak and the laws that unload from it, in units of the yield point.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// The bodies.
    pub bodies: Bodies,
    /// E_s \[Pa\].
    pub sphere_modulus: f64,
    /// The peak.
    pub peak: PeakState,
    /// Where the peak comes from.
    pub origin: Origin,
    /// The laws, in the order of table and picture.
    pub laws: Vec<LawChoice>,
    /// Warnings about keys of the scenario that have no effect.
    pub warnings: Vec<Warning>,
}

/// The unloading of one law.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// The law.
    pub name: String,
    /// Its branch, or why the law has no answer.
    pub unloading: Result<Unloading, OutsideLaw>,
}

impl Comparison {
    /// The state of the PLM at x.
    pub fn of_plm(bodies: Bodies, sphere_modulus: f64, plm: &Plm, x: f64, laws: Vec<LawChoice>) -> Self {
        let law = plm.of_bodies(&bodies);
        let loaded = law.loaded_to(x);
        let Peak { indentation, force, elastic_approach } = loaded;
        let radius = law.contact_radius(&loaded);
        let (elastic_approach, spent) = (Some(elastic_approach), law.loading.work(x));
        let peak = PeakState { indentation, force, radius, elastic_approach, spent };
        Self { bodies, sphere_modulus, peak, origin: Origin::Plm, laws, warnings: Vec::new() }
    }

    /// Every law's branch.
    pub fn compared(&self) -> Vec<Compared> {
        let unload = |law: &LawChoice| self.peak.unload(&law.get().rules(&self.bodies).recovery);
        self.laws.iter().map(|law| Compared { name: law.name(), unloading: unload(law) }).collect()
    }

    /// The finite-element unloading of the same materials whose peak is nearest to this one, within 1 % in indentation.
    pub fn finite_elements(&self) -> Option<&'static Unloaded> {
        let x = self.peak.indentation;
        let off = |row: &Unloaded| (row.x / x - 1.0).abs() + (row.f / self.peak.force - 1.0).abs();
        quasi_static::unloadings(self.sphere_modulus, &self.bodies)
            .into_iter()
            .filter(|row| (row.x / x - 1.0).abs() < 0.01)
            .min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    /// The finite-element curve of that unloading, if the library has it.
    pub fn curve(&self) -> Option<&'static UnloadingCurve> {
        quasi_static::unloading_curve(self.sphere_modulus, &self.bodies, self.peak.indentation)
    }

    /// Quasi-static e of a branch: √(recovered/spent).
    pub fn restitution(&self, unloading: &Unloading) -> f64 {
        (unloading.stored(self.peak.indentation) / self.peak.spent).sqrt()
    }
}
