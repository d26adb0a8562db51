//! `[compare]`: one peak, many unloading laws.

use super::Scenario;
use super::file::CompareInput;
use crate::compare::{Comparison, Origin};
use crate::error::Error;
use crate::impact::{of_half_space, of_sphere};
use crate::law::published::PeakState;
use crate::law::{Bodies, LawChoice, Plm};
use crate::material::{HalfSpace, Pair};
use crate::scene::{Scene, Use};
use crate::units::{Dimension, human};

/// A law whose parameter is a restitution, so that there is nothing to compare.
const LEFT_OUT: &str = "walton_braun";
/// Why another law than PLM is refused.
const OTHER_LAW: &str = "only [law.plm] has an effect here; name other laws in compare.laws";

impl Scenario {
    /// The comparison that the scenario asks for.
    ///
    /// # Errors
    /// [`Error`] where a key is missing, contradicts another, or names no law.
    pub fn comparison(&self) -> Result<Comparison, Error> {
        let refuse = |key: &str, message: &str| self.document.refuse(key, message);
        let Some(given) = &self.tables.compare else {
            return Err(refuse("compare", "the table [compare] is missing"));
        };
        let Scene { sphere, half_space, law, .. } = self.at_rest()?;
        let pair = Pair::try_new(sphere.radius, &sphere.material, &half_space)
            .map_err(|error| refuse("sphere", &error.to_string()))?;
        let bodies =
            Bodies::new(&pair, &half_space).ok_or_else(|| self.document.missing("half_space", "yield_strength"))?;
        let point = bodies.yield_point;
        let LawChoice::Plm(plm) = law else { return Err(refuse("law", OTHER_LAW)) };
        let ratio = given.peak_indentation_ratio;
        let of_length = || given.peak_indentation.map(|length| length / point.indentation);
        let x = ratio.or_else(of_length).ok_or_else(|| {
            refuse(
                "compare",
                "the key `peak_indentation_ratio` is missing: peak over yield indentation such as 105.1; or `peak_indentation`",
            )
        })?;
        if !(x > 1.0 && x < 1e6) {
            return Err(refuse(
                "compare.peak_indentation",
                &format!("is {x:.4} x the yield indentation; a plastic peak is above 1 x, and below 10^6 x"),
            ));
        }
        let laws = self.compared_laws(given, &plm)?;
        let mut comparison = Comparison::of_plm(bodies, sphere.material.youngs_modulus, &plm, x, laws);
        match (given.peak_force, given.peak_contact_radius, given.peak_sphere_indentation) {
            (None, None, None) => {}
            (Some(force), Some(radius), Some(sphere)) => {
                if pair.sphere_compliance == 0.0 {
                    return Err(refuse(
                        "compare.peak_sphere_indentation",
                        "a rigid sphere has no indentation of its own; leave the numbers of the peak out to take the PLM's",
                    ));
                }
                let elastic_approach = sphere / pair.sphere_compliance / point.indentation;
                if elastic_approach > x {
                    return Err(refuse(
                        "compare.peak_sphere_indentation",
                        "is larger than that of an elastic contact of this indentation",
                    ));
                }
                let (force, radius) = (force / point.force, radius / point.contact_radius);
                let spent = comparison.peak.spent * (force / comparison.peak.force);
                comparison.peak =
                    PeakState { indentation: x, force, radius, elastic_approach: Some(elastic_approach), spent };
                comparison.origin = Origin::Given;
            }
            _ => {
                return Err(refuse(
                    "compare",
                    "a given peak needs peak_force, peak_contact_radius and peak_sphere_indentation; leave all three out to take the PLM's",
                ));
            }
        }
        if let Some(work) = given.spent_work {
            let unit = point.force * point.indentation;
            let of_plm = human(comparison.peak.spent * unit, Dimension::Energy);
            comparison.peak.spent = work / unit;
            if comparison.compared().iter().all(|law| law.unloading.is_err()) {
                let message = format!(
                    "{} is less than any of these laws gives back from the peak; the PLM spends {of_plm}",
                    human(work, Dimension::Energy)
                );
                return Err(refuse("compare.spent_work", &message));
            }
        }
        let of_sphere = of_sphere(sphere.radius, &sphere.material, None, None);
        comparison.warnings = of_sphere.chain(of_half_space(&HalfSpace { density: None, ..half_space })).collect();
        comparison.warnings.extend(self.without_effect(std::slice::from_ref(&self.input), Use::Comparison));
        Ok(comparison)
    }

    fn compared_laws(&self, given: &CompareInput, plm: &Plm) -> Result<Vec<LawChoice>, Error> {
        let unload = || LawChoice::all().into_iter().filter(LawChoice::has_own_unloading);
        let own = |law: LawChoice| if matches!(law, LawChoice::Plm(_)) { LawChoice::Plm(plm.clone()) } else { law };
        match given.laws.as_deref() {
            None => Ok(unload().filter(|law| law.about().name != LEFT_OUT).map(own).collect()),
            Some([]) => {
                let message = "names no law; leave it out for all";
                Err(self.document.refuse("compare.laws", message))
            }
            Some(names) => Ok(names.iter().filter_map(|word| LawChoice::from_name(word)).map(own).collect()),
        }
    }
}
