//! The error of a scenario that has no result: it points at the key that is the reason.

use super::Scenario;
use super::input::{Body, Input, NUMERIC_KEYS, NumericKey};
use super::keys::Part;
use crate::contact::law::LawError;
use crate::error::{Error, ErrorKind};
use crate::impact::{Contact, ImpactError, WaveguideKind};
use crate::numerics::ode::IntegrationError;

impl Scenario {
    /// The input of the first impact, and its contact.
    pub fn resolve_contact(&self) -> Result<(Input, Contact), Error> {
        let (input, contact) = self.check_impact()?;
        contact.map_err(|reason| no_result_error(self, &reason)).map(|contact| (input, contact))
    }
}

/// The error of a scenario without a result. If one key is the reason, the error points at it.
pub fn no_result_error(scenario: &Scenario, reason: &ImpactError) -> Error {
    let speeds = ["impact.speed", "impact.drop_height", "repeat.speeds"];
    let curves = Body::ALL.map(Body::flow_stress);
    let key = match reason {
        ImpactError::Law(LawError::BothFlow { .. }) => {
            curves.into_iter().find(|key| scenario.document.contains(key)).unwrap_or("law")
        }
        ImpactError::Law(LawError::Exponent { .. }) => "law.plm.unloading_exponent",
        ImpactError::Law(_) => "law",
        ImpactError::Waveguide(error) => error.kind.size_key(),
        ImpactError::SmallInertia { least: None, .. } => {
            let sizes = [WaveguideKind::Plate, WaveguideKind::Rod].map(WaveguideKind::size_key);
            sizes.into_iter().find(|key| scenario.document.contains(key)).unwrap_or(sizes[0])
        }
        ImpactError::Hollow(_) => "half_space.radius",
        ImpactError::FreeUnderGravity | ImpactError::NoBall => "half_space.mass",
        ImpactError::NoClosedForm => "solver.method",
        ImpactError::ViscoelasticRate => "damping.viscoelastic_time",
        ImpactError::SmallInertia { .. } => "sphere.moment_of_inertia",
        ImpactError::TooDeep { .. } => {
            speeds.into_iter().find(|key| scenario.document.contains(key)).unwrap_or(speeds[0])
        }
        ImpactError::Range(_) | ImpactError::Invalid(_) | ImpactError::Integration(_) => "",
    };
    let document = &scenario.document;
    if document.contains(key) {
        return document.refusal(key, reason.to_string());
    }
    match reason {
        ImpactError::Integration(IntegrationError::StepUnderflow { .. } | IntegrationError::NotFinite { .. }) => {
            let is_of_motion = |key: &&NumericKey| {
                matches!(key.part(), Part::Motion | Part::Forces | Part::Approach | Part::Solver)
                    || ["sphere.radius", "sphere.diameter"].contains(&key.path())
            };
            let given =
                NUMERIC_KEYS.iter().filter(is_of_motion).map(|key| key.path()).filter(|path| document.contains(path));
            let given: Vec<&str> = given.collect();
            let text = format!("{reason} Probably one of these values has a wrong unit: {}.", given.join(", "));
            Error::for_file(ErrorKind::Input, document.name(), text)
        }
        ImpactError::Integration(_) => Error::for_file(ErrorKind::Failed, document.name(), reason),
        _ => Error::for_file(ErrorKind::Input, document.name(), reason),
    }
}
