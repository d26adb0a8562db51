//! A half-space that hardens: unloadings of finite elements.

use super::rows;
use super::unloading::Unloaded;
use crate::contact::law::Bodies;
use crate::contact::material::{HalfSpace, Material, Pair, PairError, Sphere};
use crate::contact::strength::flow::{FlowCurve, FlowPoint};
use crate::error::Error;

rows! {
    /// The two materials, and how the half-space hardens.
    pub struct Materials {
        half_space_modulus as "half_space_youngs_modulus_Pa": f64,
        half_space_poissons_ratio: f64,
        sphere_modulus as "sphere_youngs_modulus_Pa": f64,
        sphere_poissons_ratio: f64,
        /// σ_Y \[Pa\].
        pub yield_strength as "yield_strength_Pa": f64,
        /// In words, such as "power 0.1"; empty in a table without hardening.
        #[serde(default)]
        pub flow: String,
    }
}

impl Materials {
    pub fn sphere(&self) -> Material {
        Material { youngs_modulus: self.sphere_modulus, poissons_ratio: self.sphere_poissons_ratio }
    }

    /// The half-space at its initial yield strength.
    pub fn half_space(&self) -> HalfSpace {
        let material =
            Material { youngs_modulus: self.half_space_modulus, poissons_ratio: self.half_space_poissons_ratio };
        HalfSpace::flat(material, Some(self.yield_strength))
    }

    /// The bodies for which a law is built; never `None`, because the half-space yields.
    pub fn bodies(&self) -> Result<Option<Bodies>, PairError> {
        // the law in units of the yield point does not depend on the radius
        let half_space = self.half_space();
        Ok(Bodies::new(&Pair::try_new(&Sphere::elastic(1.0, self.sphere(), f64::NAN), &half_space)?))
    }

    /// The flow curve; `None` if the words name none.
    pub fn curve(&self) -> Option<FlowCurve> {
        let mut words = self.flow.split_whitespace();
        let form = words.next()?;
        let mut number = || words.next()?.parse().ok();
        match form {
            "power" => Some(FlowCurve::Power { exponent: number()? }),
            "voce" => Some(FlowCurve::Voce { saturation: number()?, rate: number()? }),
            "linear" => Some(FlowCurve::Linear { slope: number()? }),
            "table" => {
                let point = |pair: &str| {
                    let (strain, stress) = pair.split_once(':')?;
                    Some(FlowPoint { strain: strain.parse().ok()?, stress: stress.parse().ok()? })
                };
                let points = self.flow.split_whitespace().nth(1)?.split(',').map(point);
                FlowCurve::through(points.collect::<Option<Vec<_>>>()?).ok()
            }
            _ => None,
        }
    }
}

/// All unloadings of the finite elements.
pub fn unloadings() -> Result<Vec<(Materials, Unloaded)>, Error> {
    let (name, text) = ("fe_hardening.csv", include_str!("fe_hardening.csv"));
    Ok(rows::<Materials>(name, text)?.into_iter().zip(rows(name, text)?).collect())
}
