//! Two balls with the bodies of a scenario, for codes that move many spheres.

use std::borrow::Cow;

use super::read_input::is_at_or_below;
use super::{Body, Input};
use crate::contact::body::sphere_volume;
use crate::impact::{Contact, ImpactError};
use crate::scenario::keys::{ALL_KEYS, key};

/// The keys of a body that describe when it yields: these and those below them.
const STRENGTH_KEYS: [&str; 4] = ["yield_strength", "hardness", "strength_kind", "rate"];

impl Input {
    /// The contact of two balls with the bodies of this scenario and with these radii \[m\], of sphere and half-space. Both are free
    /// to move, with their densities; a half-space of unknown density has the density of the sphere. A strength that depends on
    /// the strain rate is the strength at the speed of the scenario.
    ///
    /// # Errors
    /// [`ImpactError`] as of [`Input::contact_at_own_speed`].
    pub fn contact_between(&self, [sphere, half_space]: [f64; 2]) -> Result<Contact, ImpactError> {
        let given_radius = self.radius().unwrap_or(f64::NAN);
        let density = self.mass().map(|mass| mass / sphere_volume(given_radius));
        let mut balls = self.clone();
        for (key, number) in [
            (key!("sphere.diameter"), None),
            (key!("sphere.radius"), Some(sphere)),
            (key!("sphere.mass"), None),
            (key!("sphere.density"), density),
            (key!("sphere.moment_of_inertia"), None),
            (key!("half_space.radius"), Some(half_space)),
            (key!("half_space.density"), self.number(key!("half_space.density")).or(density)),
            // the mass of a ball of its radius and density
            (key!("half_space.mass"), Some(f64::INFINITY)),
        ] {
            balls.set(key, number);
        }
        balls.contact_at_own_speed()
    }

    /// The contact, with the strength at the speed of the scenario if it depends on the strain rate.
    ///
    /// # Errors
    /// [`ImpactError`] as of [`Input::contact`], and if there is no such speed.
    pub fn contact_at_own_speed(&self) -> Result<Contact, ImpactError> {
        let contact = self.contact()?;
        if contact.has_rate() { contact.at_speed(self.speed()).map(Cow::into_owned) } else { Ok(contact) }
    }

    /// These bodies as two of one material: where one of them has no strength, it has the strength of the other.
    ///
    /// # Errors
    /// A sentence, if the bodies have different elastic constants or strengths, or if one hardens.
    pub fn with_one_material(&self) -> Result<Self, &'static str> {
        let (sphere, half_space) = self.bodies(&self.law());
        if sphere.material != half_space.material {
            return Err(
                "sphere and half_space have different elastic constants, but both are the same material here. Use a scenario in which both bodies have this material.",
            );
        }
        let elastic = match [sphere.yield_strength, half_space.yield_strength] {
            [None, None] => return Ok(self.clone()),
            [None, Some(_)] => Body::Sphere,
            [Some(_), None] => Body::HalfSpace,
            [Some(one), Some(other)] if one == other => return Ok(self.clone()),
            _ => {
                return Err(
                    "sphere and half_space have different yield strengths, but both are the same material here. Give one yield strength, or the same for both.",
                );
            }
        };
        if self.law().flow_curves().iter().any(Option::is_some) {
            return Err(
                "the strength has a flow curve, but both bodies yield here, and the law has no flow curve for two yielding bodies. Give yield_strength without flow_stress.",
            );
        }
        let mut both = self.clone();
        let [to, from] = elastic.select([["sphere.", "half_space."], ["half_space.", "sphere."]]);
        let is_strength = |name: &str| STRENGTH_KEYS.iter().any(|key| is_at_or_below(name, key));
        for (place, key) in ALL_KEYS.iter().enumerate() {
            let Some(name) = key.path.strip_prefix(to).filter(|name| is_strength(name)) else { continue };
            let source = ALL_KEYS.iter().position(|key| key.path.strip_prefix(from) == Some(name));
            if let Some(number) = source.and_then(|source| self.number_at(source)) {
                both.set_number_at(place, number);
            }
        }
        Ok(both)
    }
}
