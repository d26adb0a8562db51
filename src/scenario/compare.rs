//! `[compare]`: one peak, many unloading laws.

use serde::Deserialize;

use super::file::PlmTable;
use super::law::LawTable;
use super::values::{DepthRatio, Energy, Force, Length};
use super::{Kind, Scenario, ScenarioError};
use crate::compare::{Comparison, Origin};
use crate::law::published::Loaded;
use crate::law::{Bodies, LawChoice, Plm};
use crate::material::{Material, Pair};
use crate::nearest::nearest;
use crate::units::{Dimension, human};

/// `[compare]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct CompareTable {
    /// δ_m/δ_Y, or
    pub peak_indentation_ratio: Option<DepthRatio>,
    /// δ_m.
    pub peak_indentation: Option<Length>,
    /// F_m; with the next two, the peak is given; without, it is the PLM's.
    pub peak_force: Option<Force>,
    /// a_m.
    pub peak_contact_radius: Option<Length>,
    /// δ_sm.
    pub peak_sphere_indentation: Option<Length>,
    /// Work of loading; the PLM's over the same force if not given.
    pub spent_work: Option<Energy>,
    /// Names of laws; all that unload if not given.
    pub laws: Option<Vec<String>>,
}

/// Fitted to a wanted restitution, so that there is nothing to compare.
const LEFT_OUT: &str = "walton_braun";

impl Scenario {
    /// The comparison that the scenario asks for.
    ///
    /// # Errors
    /// [`ScenarioError`] where a key is missing, contradicts another, or names no law.
    pub fn comparison(&self) -> Result<Comparison, ScenarioError> {
        let refuse = |key: &str, message: &str| self.document.refuse(key, message.to_owned());
        let Some(table) = &self.file.compare else { return Err(refuse("compare", "the table [compare] is missing")) };
        if self.file.impact.is_some() {
            return Err(refuse("impact", "is not used: [compare] has no motion; leave one of the two out"));
        }
        let sphere = &self.file.sphere;
        let material = Material { youngs_modulus: sphere.youngs_modulus.0, poissons_ratio: sphere.poissons_ratio.0 };
        let table_of_half_space = self.file.half_space.as_ref();
        let half_space = table_of_half_space.ok_or_else(|| self.document.missing("", "half_space"))?.resolve();
        let pair = Pair::try_new(self.radius(sphere)?, &material, &half_space)
            .map_err(|error| refuse("sphere", &error.to_string()))?;
        let bodies =
            Bodies::new(&pair, &half_space).ok_or_else(|| self.document.missing("half_space", "yield_strength"))?;
        let point = bodies.yield_point;
        let plm = match &self.file.law {
            None => Plm::default(),
            Some(LawTable::Plm(plm)) => Plm {
                coefficients: self.coefficients(plm)?,
                exponent: plm.unloading_exponent.map(|exponent| exponent.0).unwrap_or_default(),
            },
            Some(_) => return Err(refuse("law", "only [law.plm] has an effect here; name other laws in compare.laws")),
        };
        let x = match (table.peak_indentation_ratio, table.peak_indentation) {
            (Some(ratio), None) => ratio.0,
            (None, Some(length)) => length.0 / point.indentation,
            (None, None) => {
                return Err(refuse(
                    "compare",
                    "the key `peak_indentation_ratio` is missing: peak over yield indentation such as 105.1; or `peak_indentation`",
                ));
            }
            (Some(_), Some(_)) => {
                return Err(refuse(
                    "compare.peak_indentation",
                    "`peak_indentation_ratio` is given too; write only one of the two",
                ));
            }
        };
        if !(x > 1.0 && x < 1e6) {
            return Err(refuse(
                "compare.peak_indentation",
                &format!("is {x:.4} x the yield indentation; a plastic peak is above 1 x, and below 10^6 x"),
            ));
        }
        let laws = self.compared_laws(table, &plm)?;
        let of_plm = Comparison::of_plm(bodies, sphere.youngs_modulus.0, &plm, x, laws);
        let mut comparison = of_plm.ok_or_else(|| refuse("law", "the PLM cannot be built for these bodies"))?;
        let given = (table.peak_force, table.peak_contact_radius, table.peak_sphere_indentation);
        match given {
            (None, None, None) => {}
            (Some(force), Some(radius), Some(sphere)) => {
                if pair.sphere_compliance == 0.0 {
                    return Err(refuse(
                        "compare.peak_sphere_indentation",
                        "a rigid sphere has no indentation of its own; leave the numbers of the peak out to take the PLM's",
                    ));
                }
                let elastic_approach = sphere.0 / pair.sphere_compliance / point.indentation;
                if elastic_approach > x {
                    return Err(refuse(
                        "compare.peak_sphere_indentation",
                        "is larger than that of an elastic contact of this indentation",
                    ));
                }
                let (force, radius) = (force.0 / point.force, radius.0 / point.contact_radius);
                let spent = comparison.peak.spent * (force / comparison.peak.force);
                comparison.peak =
                    Loaded { indentation: x, force, radius, elastic_approach: Some(elastic_approach), spent };
                comparison.origin = Origin::Given;
            }
            _ => {
                return Err(refuse(
                    "compare",
                    "a given peak needs peak_force, peak_contact_radius and peak_sphere_indentation; leave all three out to take the PLM's",
                ));
            }
        }
        if let Some(work) = table.spent_work {
            let unit = point.force * point.indentation;
            let of_plm = human(comparison.peak.spent * unit, Dimension::Energy);
            comparison.peak.spent = work.0 / unit;
            if comparison.compared().iter().all(|law| law.unloading.is_err()) {
                let message = format!(
                    "{} is less than any of these laws gives back from the peak; the PLM spends {of_plm}",
                    human(work.0, Dimension::Energy)
                );
                return Err(refuse("compare.spent_work", &message));
            }
        }
        comparison.warnings = Kind::Compare.idle_keys(&self.file);
        Ok(comparison)
    }

    fn compared_laws(&self, table: &CompareTable, plm: &Plm) -> Result<Vec<LawChoice>, ScenarioError> {
        let unload = || LawChoice::all().into_iter().filter(LawChoice::has_own_unloading);
        let own = |law: LawChoice| if matches!(law, LawChoice::Plm(_)) { LawChoice::Plm(plm.clone()) } else { law };
        let Some(names) = &table.laws else {
            return Ok(unload().filter(|law| law.about().name != LEFT_OUT).map(own).collect());
        };
        let refuse = |message: String| self.document.refuse("compare.laws", message);
        if names.is_empty() {
            return Err(refuse("names no law; leave it out for all".to_owned()));
        }
        let known: Vec<&'static str> = unload().map(|law| law.about().name).collect();
        let find = |name: &String| {
            unload().find(|law| law.about().name == name).map(own).ok_or_else(|| {
                let guess = nearest(name, known.iter().copied());
                let hint = guess.map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
                refuse(format!("no unloading is known as \"{name}\"{hint}; there are {}", known.join(", ")))
            })
        };
        names.iter().map(find).collect()
    }

    /// The keys of `[law.plm]`, if that is the law.
    pub(super) fn plm_table(&self) -> PlmTable {
        match &self.file.law {
            Some(LawTable::Plm(plm)) => plm.clone(),
            _ => PlmTable::default(),
        }
    }
}
