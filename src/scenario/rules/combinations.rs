//! Which keys may be given together: keys that need another key, keys that exclude each other, and keys that are not computed
//! together. These rules only check whether a key or a table is given or varies, not its value.

use crate::error::Error;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::{Contact, ImpactError, WaveguideError, WaveguideFault};
use crate::scenario::Scenario;
use crate::scenario::input::{Input, NUMERIC_KEYS, OBLIQUE_KEYS, alternative_pairs};
use crate::scenario::keys::key;
use crate::units::format_four_digits;

/// A rule that refuses keys because of other keys.
struct KeyRule {
    keys: &'static [&'static str],
    /// The keys are refused if any of these is given too. An empty list refuses them always.
    other_keys: &'static [&'static str],
    /// The keys are allowed if one of these is given.
    unless: &'static [&'static str],
    /// The reason and the remedy, for the message; `{}` stands for the other key.
    reason: &'static str,
}

const fn needs(keys: &'static [&'static str], needed: &'static [&'static str], why: &'static str) -> KeyRule {
    KeyRule { keys, other_keys: &[], unless: needed, reason: why }
}

/// The keys are refused together with any of the others.
const fn excludes(keys: &'static [&'static str], others: &'static [&'static str], why: &'static str) -> KeyRule {
    KeyRule { keys, other_keys: others, unless: &[], reason: why }
}

const OBLIQUE_PATHS: &[&str] =
    &[OBLIQUE_KEYS[0].path(), OBLIQUE_KEYS[1].path(), OBLIQUE_KEYS[2].path(), OBLIQUE_KEYS[3].path()];
const ONE_OF_TWO_TEXT: &str = "cannot be combined with [{}]. Remove one of the two.";

const RULES: &[KeyRule] = &[
    KeyRule {
        keys: &["impact.drop_height"],
        other_keys: &["repeat"],
        unless: &["gravity.acceleration"],
        reason: "requires [gravity] together with [{}], because a sphere bounces only under gravity. Add [gravity] with acceleration = \"9.80665 m/s^2\" (command line: --set gravity.acceleration=\"9.80665 m/s^2\"), or give impact.speed for impacts at a given speed.",
    },
    needs(
        OBLIQUE_PATHS,
        &["friction.coefficient"],
        "requires [friction]. Add [friction] with coefficient = 0.1, or 0 for a frictionless contact.",
    ),
    KeyRule {
        keys: OBLIQUE_PATHS,
        other_keys: &["sphere.mass"],
        unless: &["sphere.moment_of_inertia"],
        reason: "requires sphere.moment_of_inertia, because {} describes a body that is not a solid sphere.",
    },
    needs(
        &["air"],
        &["gravity.acceleration", "impact.drop_height", "calibrate"],
        "has no effect, because the sphere neither falls nor bounces. Add [gravity] with acceleration = \"9.81 m/s^2\", or set impact.drop_height, or remove [air].",
    ),
    excludes(
        OBLIQUE_PATHS,
        &["air"],
        "cannot be combined with [{}], because air drag along an oblique path is not modelled. Remove one of the two.",
    ),
    KeyRule {
        keys: OBLIQUE_PATHS,
        other_keys: &["repeat"],
        unless: &["gravity.acceleration"],
        reason: "requires [gravity] together with [{}]: impacts at given speeds are normal impacts. Add [gravity] with acceleration = \"9.81 m/s^2\", or remove this key.",
    },
    excludes(
        OBLIQUE_PATHS,
        &["calibrate"],
        "cannot be combined with [{}], which supports normal impacts only. Remove this key, and give the normal component of the speed.",
    ),
    // a plate or rod radiates no waves into a half-space: the density serves the plate or rod
    KeyRule {
        keys: &["half_space.density"],
        other_keys: &["damping"],
        unless: &["half_space.thickness", "half_space.rod_diameter", "half_space.mass"],
        reason: "elastic waves cannot be combined with [{}], because the wave loss is computed for a contact without damping. Remove this key or [{}].",
    },
    excludes(
        &["damping.viscoelastic_time"],
        &["half_space.thickness"],
        "cannot be combined with {}, because both are a drag in proportion to the stiffness of the contact, and the plate would also move with the viscoelastic force. Remove one of the two.",
    ),
    excludes(
        &["damping.viscoelastic_time"],
        &["sphere.rate", "half_space.rate"],
        "cannot be combined with {}, because the metal relaxes at maximum compression, and this drop of the force has no finite stiffness. Remove one of the two.",
    ),
    excludes(
        &["adhesion"],
        &["damping.viscoelastic_time", "half_space.thickness", "half_space.rod_diameter"],
        "cannot be combined with {}, because the loss by adhesion is known for an elastic contact on a half-space only. Remove one of the two.",
    ),
    excludes(
        &["adhesion"],
        &["calibrate"],
        "cannot be combined with [{}], which compares the restitution without adhesion. Remove one of the two.",
    ),
    excludes(
        &["half_space.mass"],
        &["gravity", "repeat"],
        "a free target cannot be combined with [{}]. Remove one of the two. (A fall can be given by impact.drop_height without [gravity].)",
    ),
    excludes(
        &["half_space.thickness"],
        &["half_space.radius", "half_space.mass"],
        "a plate cannot be combined with {}, because a plate is flat and gives way by bending. Remove one of the two.",
    ),
    excludes(
        &["half_space.rod_diameter"],
        &["half_space.radius", "half_space.mass"],
        "a rod cannot be combined with {}, because the end of the rod is flat, and the rod gives way by a wave. Remove one of the two.",
    ),
    excludes(
        &["half_space.thickness"],
        &["half_space.rod_diameter"],
        "a target is a plate or a rod, and {} makes it a rod. Remove one of the two.",
    ),
    // a column of measurements may give the diameter
    needs(
        &["half_space.rod_length"],
        &["half_space.rod_diameter", "calibrate"],
        "applies to rods only. Add half_space.rod_diameter, or remove this key.",
    ),
    // a column of measurements may give the thickness
    needs(
        &["half_space.edge_distance", "half_space.plate"],
        &["half_space.thickness", "calibrate"],
        "applies to plates only. Add half_space.thickness, or remove this key.",
    ),
    excludes(
        &["impact"],
        &["repeat.speeds"],
        "cannot be combined with {}, which gives the speed of every impact. Remove one of the two.",
    ),
    excludes(
        &["repeat.speeds"],
        &["gravity"],
        "cannot be combined with [{}]: the impacts have given speeds, but under gravity the sphere bounces. Remove one of the two.",
    ),
    excludes(
        &["repeat.impacts"],
        &["repeat.speeds"],
        "cannot be combined with {}, which already determines the number of impacts. Remove repeat.impacts.",
    ),
    needs(
        &["repeat.until"],
        &["gravity"],
        "applies only if the sphere bounces under [gravity]. Add [gravity], or remove this key.",
    ),
    excludes(
        &["impact", "gravity", "damping", "adhesion", "air"],
        &["indentation"],
        "does not apply to a quasi-static [{}]. Remove one of the two.",
    ),
    excludes(
        &["sphere.rate", "half_space.rate"],
        &["indentation"],
        "does not apply to a quasi-static [{}], which has the strength of a slow test. Remove this table.",
    ),
    excludes(
        &["friction"],
        &["indentation"],
        "does not apply to [{}], because the contact does not slide. Remove one of the two.",
    ),
    excludes(
        &["solver"],
        &["indentation"],
        "does not apply to [{}], which is computed in closed form. Remove one of the two.",
    ),
    needs(
        &["peening.mass_flow", "peening.area", "peening.time"],
        &["peening.coverage"],
        "requires peening.coverage. Add coverage = 0.98, which is full coverage in shot peening.",
    ),
    needs(
        &["peening.mass_flow", "peening.time"],
        &["peening.area"],
        "requires peening.area, the area that the shot hits. Add area = \"50 cm^2\", or remove this key.",
    ),
    needs(
        &["peening.area", "peening.time"],
        &["peening.mass_flow"],
        "requires peening.mass_flow, the mass of shot per time. Add mass_flow = \"5 kg/min\", or remove this key.",
    ),
    excludes(
        &["peening"],
        &["repeat", "indentation", "calibrate"],
        "does not apply to [{}], because a coverage belongs to many equal impacts at random places. Remove one of the two.",
    ),
    excludes(
        &["peening"],
        &["half_space.mass", "half_space.radius"],
        "cannot be combined with {}, because a coverage is known for a fixed, flat surface only. Remove one of the two.",
    ),
    needs(
        &["output.pulse"],
        &["output.pulse.step"],
        "requires output.pulse.step, the time from sample to sample. Add pulse = { step = \"10 ns\" }, or remove this key.",
    ),
    excludes(
        &["output.pulse"],
        &["sweep", "monte_carlo", "repeat", "indentation", "calibrate"],
        "applies to single impacts only, and [{}] is another kind of scenario. Remove one of the two.",
    ),
    excludes(&["calibrate.data"], &["calibrate.measured"], ONE_OF_TWO_TEXT),
    excludes(&["indentation.half_space"], &["half_space"], ONE_OF_TWO_TEXT),
];

impl Scenario {
    /// The refusals of tables of two kinds, of keys that exclude each other, of keys that need another key, and of empty tables.
    pub(in crate::scenario) fn check_combinations(&self) -> Vec<Error> {
        let mut refused: Vec<Error> = self.kind().err().into_iter().collect();
        for [one, other] in alternative_pairs() {
            if self.is_given(one) && self.is_given(other) {
                refused.push(self.document.refuse_both(one, other));
            }
        }
        for table in ["friction", "gravity", "damping", "adhesion"] {
            let keys: Vec<&str> =
                NUMERIC_KEYS.iter().map(|key| key.path()).filter(|path| path.starts_with(table)).collect();
            if self.document.contains(table) && !keys.iter().any(|path| self.document.contains(path)) {
                refused.push(self.document.missing_any_key(table, &keys, "; or remove the table"));
            }
        }
        // the keys that a calibration varies are checked with the data
        let swept = if self.is_given("calibrate") { Vec::new() } else { self.variation.paths() };
        if let Some((path, problem)) = self.conflicting_axis(&swept) {
            refused.push(self.refusal_where_varied(path, problem));
        }
        let given = |paths: &[&'static str]| paths.iter().copied().find(|path| self.origin(path).is_given_or_varies());
        for KeyRule { keys, other_keys: others, unless, reason: why } in RULES {
            let (Some(key), None) = (given(keys), given(unless)) else { continue };
            if let Some(other) = if others.is_empty() { Some("") } else { given(others) } {
                // together with another key there are other remedies
                let needed = unless.first().copied().filter(|_| others.is_empty());
                refused.push(self.refusal_where_varied(key, why.replace("{}", other)).with_missing_key(needed));
            }
        }
        refused
    }

    /// A refusal of a key at its position, or at the position of its axis.
    pub(in crate::scenario) fn refusal_where_varied(&self, path: &str, message: impl AsRef<str>) -> Error {
        let places = ["sweep.", "monte_carlo.", "calibrate.free.", ""].map(|table| format!("{table}{path}"));
        let place = places.iter().find(|place| self.document.contains(place)).map_or(path, String::as_str);
        self.document.refusal(place, message)
    }

    /// Refuses a plate or a rod together with parts of the scene that are not computed on it.
    pub(in crate::scenario) fn check_waveguide(&self, contact: &Result<Contact, ImpactError>) -> Result<(), Error> {
        let refuse = |error: WaveguideError| {
            let needed = (error.reason == WaveguideFault::NoDensity).then_some("half_space.density");
            self.refusal_where_varied(error.kind.size_key(), error.to_string()).with_missing_key(needed)
        };
        contact.as_ref().map_or(Ok(()), |contact| contact.check_waveguide().map_err(refuse))
    }

    /// Refuses a hollow that is too narrow for a point contact, and a free target with missing values.
    pub(in crate::scenario) fn check_target(
        &self,
        input: &Input,
        contact: &Result<Contact, ImpactError>,
    ) -> Result<(), Error> {
        let refuse = |key: &str, message: &str| Err(self.refusal_where_varied(key, message));
        let radius = input.number(key!("half_space.radius"));
        if radius == Some(0.0) {
            return refuse("half_space.radius", "must not be 0. Remove the key for a flat target.");
        }
        if let Err(error @ ImpactError::Hollow(_)) = contact {
            return refuse("half_space.radius", &error.to_string());
        }
        let Some(mass) = input.number(key!("half_space.mass")) else { return Ok(()) };
        if mass.is_finite() {
            let message = "an oblique impact on a free target requires a ball. Write half_space.mass = \"ball\", or remove impact.angle and the spin of the sphere.";
            return if input.is_oblique() { refuse("half_space.mass", message) } else { Ok(()) };
        }
        match radius {
            None => Err(self.document.missing_key("half_space", "radius")),
            Some(hollow) if hollow < 0.0 => refuse(
                "half_space.mass",
                "mass = \"ball\" requires a positive half_space.radius. Give the mass as a number, or a positive radius.",
            ),
            Some(_) if input.number(key!("half_space.density")).is_none() => {
                Err(self.document.missing_key("half_space", "density"))
            }
            Some(_) => Ok(()),
        }
    }

    /// Refuses air with missing values, and a ball that floats in the air.
    pub(in crate::scenario) fn check_air(&self, input: &Input) -> Result<(), Error> {
        if !self.is_given("air") {
            return Ok(());
        }
        for (key, is_missing) in [
            ("density", input.number(key!("air.density")).is_none()),
            ("drag", input.number(key!("air.drag")).is_none()),
            ("viscosity", input.air().is_some_and(|air| air.drag.is_none() && air.viscosity.is_nan())),
        ] {
            if is_missing {
                return Err(self.document.missing_key("air", key));
            }
        }
        let (Some(air), Some(radius), Some(mass)) = (input.air(), input.radius(), input.mass()) else { return Ok(()) };
        let lift = FreeFlight::buoyancy_ratio(air.density, radius, mass);
        if lift >= 1.0 {
            let message = format!(
                "the sphere floats, because its buoyancy is {} times its weight. Check air.density and the sphere; for a hollow ball set sphere.mass.",
                format_four_digits(lift)
            );
            return Err(self.refusal_where_varied("air.density", message));
        }
        Ok(())
    }

    /// A key that cannot vary, because its alternative is given or varies too.
    pub(in crate::scenario) fn conflicting_axis(&self, varied: &[&'static str]) -> Option<(&'static str, String)> {
        let varies = |path: &str| varied.contains(&path);
        // a swept diameter replaces a radius in the file
        let pairs = alternative_pairs().skip(1).flat_map(|[one, other]| [(one, other), (other, one)]);
        let given = pairs.into_iter().find(|(key, other)| varies(key) && self.is_given(other));
        let refusal =
            |(key, other, is_given)| (key, format!("replaces {other}, which {is_given}. Remove one of the two."));
        let both = || alternative_pairs().find(|pair| pair.iter().all(|path| varies(path)));
        let given = given.map(|(key, other)| (key, other, "is also given"));
        given.or_else(|| both().map(|[other, key]| (key, other, "varies too"))).map(refusal)
    }
}
