//! A half-space that hardens: the materials of an unloading by finite elements.

use super::ReferenceRow;
use crate::contact::body::{HalfSpace, Material, Sphere};
use crate::contact::law::YieldingPair;
use crate::contact::pair::{Pair, PairError};
use crate::contact::strength::flow_curve::{FlowCurve, FlowPoint};

impl ReferenceRow {
    /// The elastic constants of a body, which have this prefix.
    fn material(&self, body: &str) -> Material {
        Material {
            youngs_modulus: self.number(&format!("{body}_youngs_modulus_Pa")),
            poissons_ratio: self.number(&format!("{body}_poissons_ratio")),
        }
    }

    pub fn sphere(&self) -> Material {
        self.material("sphere")
    }

    /// The half-space at its initial yield strength.
    pub fn half_space(&self) -> HalfSpace {
        HalfSpace::flat(self.material("half_space"), Some(self.number("yield_strength_Pa")))
    }

    /// The bodies for which a law is built; never `None`, because the half-space yields.
    pub fn bodies(&self) -> Result<Option<YieldingPair>, PairError> {
        Ok(YieldingPair::new(&Pair::try_new(&self.ball(), &self.half_space())?))
    }

    /// The sphere; the law in units of the yield point does not depend on the radius.
    pub fn ball(&self) -> Sphere {
        Sphere::elastic(1.0, self.sphere(), f64::NAN)
    }

    /// How the half-space hardens: in words, such as "power 0.1". `None` if the words name no curve.
    pub fn curve(&self) -> Option<FlowCurve> {
        let flow = self.cell_text("flow");
        let mut words = flow.split_whitespace();
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
                let points = flow.split_whitespace().nth(1)?.split(',').map(point);
                FlowCurve::from_points(points.collect::<Option<Vec<_>>>()?).ok()
            }
            _ => None,
        }
    }
}
