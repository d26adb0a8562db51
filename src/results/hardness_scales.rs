//! Hardness numbers of testers, from the results of a scenario: rebound hardness of a Leeb tester and of Shore's scleroscope, Brinell's
//! and Meyer's number of a ball that is pressed in.
//!
//! A scenario does not name its tester. A rebound hardness is reported if mass, tip and energy of the sphere are those of a tester. The
//! rebound of any other body is a restitution and no hardness.

use std::f64::consts::PI;

use crate::impact::{Contact, ImpactRow};

/// One kgf in N.
const KILOGRAM_FORCE: f64 = 9.806_65;
/// Relative tolerance of mass and tip radius of a tester. The nominal masses of different manuals agree within this.
const BODY_TOLERANCE: f64 = 0.05;
/// Relative tolerance of the energy of a tester.
const ENERGY_TOLERANCE: f64 = 0.10;
/// Young's modulus \[Pa\] between a tip of tungsten carbide and a tip of diamond.
const DIAMOND_FROM: f64 = 800e9;

/// A tester whose body rebounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReboundTester {
    /// The scale of hardness.
    pub scale: &'static str,
    pub title: &'static str,
    /// Mass of the body \[kg\].
    pub mass: f64,
    /// Radius of the tip \[m\]; `None` if no source states the radius.
    pub tip_radius: Option<f64>,
    /// Energy of the impact \[J\].
    pub energy: f64,
    /// True for a tip of diamond, false for a tip of tungsten carbide.
    pub has_diamond_tip: bool,
}

const fn leeb(scale: &'static str, mass: f64, tip_radius: f64, energy: f64, has_diamond_tip: bool) -> ReboundTester {
    ReboundTester { scale, title: "Leeb", mass, tip_radius: Some(tip_radius), energy, has_diamond_tip }
}

/// Leeb testers, by the public manuals of `reference/leeb.csv`. Device DL is left out, because its manuals give two diameters of the tip.
pub const LEEB_TESTERS: [ReboundTester; 5] = [
    leeb("HLD", 5.5e-3, 1.5e-3, 0.011, false),
    leeb("HLD+15", 7.8e-3, 1.5e-3, 0.011, false),
    leeb("HLC", 3.0e-3, 1.5e-3, 0.0027, false),
    leeb("HLE", 5.5e-3, 1.5e-3, 0.011, true),
    leeb("HLG", 20e-3, 2.5e-3, 0.090, false),
];

/// Shore's scleroscope of model C: 2.3 to 2.5 g fall from 251 to 254 mm (ASTM E448 and JIS B 7727, not read again).
pub const SCLEROSCOPE: ReboundTester = ReboundTester {
    scale: "HSC",
    title: "Shore's scleroscope, model C",
    mass: 2.4e-3,
    tip_radius: None,
    energy: 0.0060,
    has_diamond_tip: true,
};

/// The properties of a body by which a tester is recognised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactBody {
    /// \[kg\]
    pub mass: f64,
    /// \[m\]
    pub radius: f64,
    /// \[Pa\]
    pub youngs_modulus: f64,
    /// \[J\]
    pub energy: f64,
}

impl ImpactBody {
    /// The body of an impact along the normal of a fixed target; `None` for another impact.
    pub fn new(contact: &Contact, row: &ImpactRow) -> Option<Self> {
        let (sphere, mass) = (contact.sphere(), contact.mass());
        let is_of_tester = row.rebound.is_none() && contact.target_mass().is_none();
        is_of_tester.then_some(Self {
            mass,
            radius: sphere.radius,
            youngs_modulus: sphere.material.youngs_modulus,
            energy: row.kinetic_in,
        })
    }

    /// True if the body is the body of this tester.
    pub fn is_of(&self, tester: &ReboundTester) -> bool {
        let is_near = |value: f64, nominal: f64, tolerance: f64| (value / nominal - 1.0).abs() <= tolerance;
        is_near(self.mass, tester.mass, BODY_TOLERANCE)
            && tester.tip_radius.is_none_or(|radius| is_near(self.radius, radius, BODY_TOLERANCE))
            && is_near(self.energy, tester.energy, ENERGY_TOLERANCE)
            && (self.youngs_modulus >= DIAMOND_FROM) == tester.has_diamond_tip
    }

    /// The scale of the Leeb tester with this body.
    pub fn leeb_scale(&self) -> Option<&'static str> {
        LEEB_TESTERS.iter().find(|tester| self.is_of(tester)).map(|tester| tester.scale)
    }

    /// True for the hammer of a scleroscope.
    pub fn is_of_scleroscope(&self) -> bool {
        self.is_of(&SCLEROSCOPE)
    }
}

/// Leeb hardness: 1000 times the ratio of rebound speed to impact speed.
pub fn leeb_hardness(restitution: f64) -> f64 {
    1000.0 * restitution
}

/// Shore hardness HSC: the ratio of rebound height to drop height times 10000/65. The ratio of the heights is the square of the restitution.
pub fn shore_hardness(restitution: f64) -> f64 {
    10_000.0 / 65.0 * restitution * restitution
}

/// The range of the diameter of the dent over the diameter of the ball in which a Brinell number is valid (ISO 6506-1).
pub const BRINELL_RANGE: [f64; 2] = [0.24, 0.6];
/// True for a ball of a Brinell test, by its diameter \[m\]: the smallest has 1 mm and the largest 10 mm (ISO 6506-1).
pub fn is_brinell_ball(diameter: f64) -> bool {
    const ROUNDING: f64 = 1e-9;
    (1e-3 * (1.0 - ROUNDING)..=10e-3 * (1.0 + ROUNDING)).contains(&diameter)
}

/// Brinell number in kgf/mm²: force \[N\] over the area of the cap of the dent, from the diameters \[m\] of ball and dent. `None` outside of
/// [`BRINELL_RANGE`].
pub fn brinell_hardness(force: f64, ball_diameter: f64, dent_diameter: f64) -> Option<f64> {
    let [least, largest] = BRINELL_RANGE;
    let ratio = dent_diameter / ball_diameter;
    let cap = 0.5 * PI * ball_diameter * ball_diameter * (1.0 - (1.0 - ratio * ratio).sqrt());
    (least..=largest).contains(&ratio).then(|| kilogram_force_per_mm2(force / cap))
}

/// Meyer number in kgf/mm²: force over the projected area of the dent, which is the mean pressure \[Pa\].
pub fn meyer_hardness(mean_pressure: f64) -> f64 {
    kilogram_force_per_mm2(mean_pressure)
}

fn kilogram_force_per_mm2(pressure: f64) -> f64 {
    pressure * 1e-6 / KILOGRAM_FORCE
}

#[cfg(test)]
mod tests {
    use super::*;

    /// HBW = 0.102 · 2 F/(π D (D − √(D² − d²))) of ISO 6506-1. 29.42 kN on a ball of 10 mm and a dent of 4 mm: 229 in its tables.
    #[test]
    fn brinell_number_is_the_tabulated_one() {
        let number = brinell_hardness(29_420.0, 0.01, 0.004).unwrap_or(f64::NAN);
        assert!((number - 228.7).abs() < 0.5, "{number}");
        assert_eq!(brinell_hardness(29_420.0, 0.01, 0.0023), None);
        assert_eq!(brinell_hardness(29_420.0, 0.01, 0.0061), None);
    }

    /// Shore's scale has 100 at a rebound to 0.65 of the drop height.
    #[test]
    fn shore_number_is_hundred_at_reference_height() {
        assert!((shore_hardness(0.65_f64.sqrt()) - 100.0).abs() < 1e-9);
    }

    /// The bodies of all testers differ: no body has two scales.
    #[test]
    fn every_tester_is_recognised_by_its_body_alone() {
        let all: Vec<_> = LEEB_TESTERS.into_iter().chain([SCLEROSCOPE]).collect();
        for tester in &all {
            let body = ImpactBody {
                mass: tester.mass,
                radius: tester.tip_radius.unwrap_or(1e-3),
                youngs_modulus: if tester.has_diamond_tip { 1000e9 } else { 600e9 },
                energy: tester.energy,
            };
            let scales: Vec<_> = all.iter().filter(|other| body.is_of(other)).map(|other| other.scale).collect();
            assert_eq!(scales, [tester.scale]);
            let ball = ImpactBody { mass: 1.3 * tester.mass, ..body };
            assert!(all.iter().all(|other| !ball.is_of(other)));
        }
    }
}
