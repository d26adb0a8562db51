//! Lines for the engines of robots and machines: Drake, MuJoCo, Chrono. Each has its own equation of a contact, and the parameters
//! are those at which this equation gives e and contact time of the law at the speed of the impact.

use super::exporter::Exporter;
use super::one_contact::{damped_hertz_contact, restitution_and_time, restitution_of_ratio};
use super::springs::non_cohesive_spring;
use crate::error::Error;
use crate::numerics::functions::{ln_1p, pow};
use crate::numerics::root::bisect;

/// The ratio that the lines of Chrono assume for both materials.
const POISSONS_RATIO: f64 = 0.3;
/// e below which the damping of an equation has no useful value.
const MIN_RESTITUTION: f64 = 0.02;
/// d of MuJoCo's impedance: 1 would be a contact whose solver has no regularisation.
const IMPEDANCE: f64 = 0.99;

/// d v of the force k x (1 + d x') of Hunt and Crossley (1975) that has this e. Over the speed, u du/(1 + d u) = −(k/m) x dx has the
/// integral d v − ln(1 + d v) = −e d v − ln(1 − e d v). For small d, e = 1 − (2/3) d v.
fn hunt_crossley_damping(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    // the root lies below 1/e, where the second logarithm ends
    let excess = |dv: f64| (dv - ln_1p(dv)) - (-e * dv - ln_1p(-e * dv));
    bisect(1e-6, (1.0 - 1e-15) / e, |dv| excess(dv) > 0.0).0
}

impl Exporter<'_> {
    /// Refuses an e that is too small for the damping of a code.
    pub(super) fn require_rebound(&self, code: &str) -> Result<(), Error> {
        if self.e >= MIN_RESTITUTION {
            return Ok(());
        }
        Err(Error::input(format!(
            "--to {code}: e is {:.4} at {} m/s, and this contact needs e of {MIN_RESTITUTION} or more. Give a lower --speed.",
            self.e, self.impact.speed
        )))
    }

    /// Point contact of Drake: f = k x (1 + d x')+, where k = k1 k2/(k1 + k2) and d = (k2 d1 + k1 d2)/(k1 + k2) of the two bodies
    /// (documentation of Drake, "Compliant point contact").
    pub(super) fn drake(&self) -> Result<String, Error> {
        self.require_rebound("drake")?;
        let damping = hunt_crossley_damping(self.e);
        let (_, time) = restitution_and_time(|x, u| x * (1.0 + damping * u));
        let (speed, mass) = (self.impact.speed, self.contact.contact.reduced_mass());
        let frequency = time / self.impact.row.contact_time;
        let friction = self.contact.friction.unwrap_or(0.0);
        Ok(format!(
            "# point contact f = k x (1 + d x')+; two equal bodies have k/2 and d. e of this contact falls with the speed: d is of this speed.\n\
             # The approximations \"tamsi\", \"similar\" and \"lagged\" have this equation; \"sap\" and hydroelastic contact have others.\n\
             properties = ProximityProperties()\n\
             AddContactMaterial(dissipation={:.9e}, point_stiffness={:.9e}, friction=CoulombFriction({friction:?}, {friction:?}), properties=properties)\n\
             plant.set_contact_model(ContactModel.kPoint)\n\
             plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSimilar)\n\
             # MultibodyPlant(time_step={:.3e})\n",
            damping / speed,
            2.0 * mass * frequency * frequency,
            self.time_step()
        ))
    }

    /// `solref` with two negative numbers, −stiffness and −damping, each divided by the mass. With a constant impedance d the
    /// acceleration of a contact is −(stiffness x + damping x') + (1 − d) a_0, where a_0 is the acceleration without the contact, and
    /// the contact never pulls (documentation of MuJoCo, "Solver parameters").
    pub(super) fn mujoco(&self) -> Result<String, Error> {
        let (stiffness, damping) = non_cohesive_spring(1.0, self.e, self.impact.row.contact_time).ok_or_else(|| {
            Error::input(format!(
                "--to mujoco: a damped spring that never pulls has e above exp(-2) = 0.135, and e is {:.4}. Give a lower --speed.",
                self.e
            ))
        })?;
        let (dimension, friction) = match self.contact.friction {
            None => (1, String::new()),
            Some(friction) => (3, format!(" friction=\"{friction} 0 0\"")),
        };
        Ok(format!(
            "<!-- solref is negative: stiffness and damping over the mass. The e is the same for every mass and speed. -->\n\
             <option timestep=\"{:.3e}\" integrator=\"Euler\" cone=\"elliptic\"/>\n\
             <default>\n  <geom solref=\"{:.9e} {:.9e}\" solimp=\"{IMPEDANCE} {IMPEDANCE} 0.001 0.5 2\" condim=\"{dimension}\"{friction}/>\n</default>\n",
            self.time_step(),
            -stiffness,
            -damping
        ))
    }

    /// Smooth contact (SMC) of Chrono with the model Hertz and material properties: Sn = 2 E* √(R x), kn = (2/3) Sn, gn = 2 √(5/6) β √(Sn m),
    /// β = −ln cr/√(ln² cr + π²), force kn x + gn x' (source of Chrono, `ChSystemSMC`). The force never pulls, so the
    /// restitution of the material, cr, is a little less than e.
    pub(super) fn chrono(&self) -> Result<String, Error> {
        self.require_rebound("chrono")?;
        let (beta, _) = bisect(0.0, 1.0, |beta| damped_hertz_contact(beta).0 > self.e);
        if beta >= 1.0 - 1e-9 {
            let message =
                format!("--to chrono: this contact has no e as small as {:.4}. Give a lower --speed.", self.e);
            return Err(Error::input(message));
        }
        let restitution = restitution_of_ratio(beta);
        let (speed, mass) = (self.impact.speed, self.contact.contact.reduced_mass());
        // the unit of length is that of m v²/L = K L^1.5, and the unit of time is L/v
        let length = speed * self.impact.row.contact_time / damped_hertz_contact(beta).1;
        let stiffness = mass * speed * speed / pow(length, 2.5);
        let radius = self.contact.contact.pair().radius;
        let modulus = 2.0 * (1.0 - POISSONS_RATIO * POISSONS_RATIO) * 0.75 * stiffness / radius.sqrt();
        let friction = self.contact.friction.unwrap_or(0.0);
        Ok(format!(
            "// ChSystemSMC with material properties and SetContactForceModel(ChSystemSMC::Hertz); both bodies have this material.\n\
             // A fixed body needs a large mass, because Chrono takes the effective mass of both. The effective radius is {radius:.9e} m;\n\
             // for shapes without a radius set it with ChCollisionInfo::SetDefaultEffectiveCurvatureRadius.\n\
             auto material = chrono_types::make_shared<ChContactMaterialSMC>();\n\
             material->SetYoungModulus({modulus:.9e}f);\nmaterial->SetPoissonRatio({POISSONS_RATIO}f);\n\
             material->SetRestitution({restitution:.9}f);\nmaterial->SetFriction({friction:?}f);\n\
             // system.DoStepDynamics({:.3e});\n",
            self.time_step()
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral of the motion, against the motion itself and the formula for small damping.
    #[test]
    fn hunt_crossley_damping_gives_restitution() {
        for e in [0.1, 0.5, 0.9] {
            let damping = hunt_crossley_damping(e);
            let (got, _) = restitution_and_time(|x, u| x * (1.0 + damping * u));
            assert!((got / e - 1.0).abs() < 1e-5, "{e} {got}");
        }
        assert!((hunt_crossley_damping(0.999) / 1.5e-3 - 1.0).abs() < 2e-3);
    }
}
