//! Impacts that are hard for integrators, each with its exact outcome and the source of its restitution.
//!
//! All are dimensionless: a [`Law`] and a speed ratio. Some come from scenes in SI units that are hard, such as nanometres or
//! a modulus ratio of 10¹².

use plm_impact::impact::solve::closed_form;

use plm_impact::bench::problems::{BenchProblem, kinked_law, steel_speed_ratio, stiff_law};
use plm_impact::numerics::curve::LoadingCurve;
use plm_impact::numerics::functions::{pow, powi};

use crate::common::prelude::*;

const BALANCE: &str = "balance of energy, e^2 = f_m eps_m/((n + 1) w_m), without stepping";
const ELASTIC: &str = "elastic: what was spent comes back, e = 1 exactly";
const PRINTED: &str = "known to 16 digits from 30-digit arithmetic";

/// A sphere on a half-space, given by the ratios that matter.
#[derive(Debug, Clone, Copy)]
struct ExtremePair {
    radius: f64,
    /// Young's moduli of sphere and half-space \[Pa\].
    youngs_moduli: [f64; 2],
    poissons_ratios: [f64; 2],
    /// σ_Y/E*.
    strength_ratio: f64,
    /// v/v_Y.
    speed_ratio: f64,
}

/// Steel on steel, deep in the plastic range.
const STEEL: ExtremePair = ExtremePair {
    radius: 5e-3,
    youngs_moduli: [210e9, 210e9],
    poissons_ratios: [0.3, 0.3],
    strength_ratio: 3e-3,
    speed_ratio: 300.0,
};

impl ExtremePair {
    fn law(&self) -> (Law, f64) {
        let [of_sphere, of_half_space] =
            [0, 1].map(|i| Material { youngs_modulus: self.youngs_moduli[i], poissons_ratio: self.poissons_ratios[i] });
        let e_star = 1.0 / (1.0 / of_sphere.plane_strain_modulus() + 1.0 / of_half_space.plane_strain_modulus());
        let contact = Contact::try_new(
            Sphere::elastic(self.radius, of_sphere, 7850.0),
            HalfSpace::flat(of_half_space, Some(self.strength_ratio * e_star)),
            &Plm::default(),
        )
        .unwrap();
        let yield_speed = contact.yield_speed().unwrap_or(1.0);
        let (_, law, q) = contact.scaling(self.speed_ratio * yield_speed).unwrap();
        (law.clone(), q)
    }
}

/// A case whose exact outcome is the closed form's.
fn closed_form_problem(name: &'static str, law: Law, speed: f64) -> BenchProblem {
    let exact = closed_form::solve(&law, speed);
    let about = if exact.restitution == 1.0 { ELASTIC } else { BALANCE };
    BenchProblem { name, description: about, law, speed, forces: ScaledForces::NONE, exact }
}

/// A law of `count` straight pieces, the knots spaced by the factor `ratio`, close to f = x^1.2 beyond x = 1.7.
fn many_knots(law: &Law, count: i32, ratio: f64) -> Law {
    let knots = (0..count).map(|i| 1.7 * powi(ratio, i));
    let loading = knots.fold(LoadingCurve::hertz(), |curve, start| curve.then_line(start, 2.0 * pow(start / 1.7, 0.2)));
    Law::new(loading, law.validity, law.unloading_rule.clone())
}

/// All hard cases. Each names the source of its restitution in its description.
pub fn hard_cases() -> Vec<BenchProblem> {
    let (steel, _) = STEEL.law();
    let (hertz, stiffest, as_stiff) = (Law::hertz(), stiff_law(1e12), stiff_law(1.0));
    let (many, close) = (many_knots(&steel, 200, 1.02), many_knots(&steel, 5, 1.0 + 1e-12));
    let mut cases: Vec<BenchProblem> = [
        ("v = v_Y (1 - 1e-3)", &steel, 1.0 - 1e-3),
        ("v = v_Y (1 - 1e-6)", &steel, 1.0 - 1e-6),
        ("v = v_Y (1 - 1e-9)", &steel, 1.0 - 1e-9),
        ("v = v_Y (1 - 1e-12)", &steel, 1.0 - 1e-12),
        ("v = v_Y (1 - 1e-15)", &steel, 1.0 - 1e-15),
        ("v = v_Y", &steel, 1.0),
        ("v = v_Y (1 + 1e-15)", &steel, 1.0 + 1e-15),
        ("v = v_Y (1 + 1e-12)", &steel, 1.0 + 1e-12),
        ("v = v_Y (1 + 1e-9)", &steel, 1.0 + 1e-9),
        ("v = v_Y (1 + 1e-6)", &steel, 1.0 + 1e-6),
        ("v = v_Y (1 + 1e-3)", &steel, 1.0 + 1e-3),
        ("peak on the knot at x = 1.7", &steel, speed_to(&steel, 1.7)),
        ("peak on the knot at x = 8.4", &steel, speed_to(&steel, 8.4)),
        ("peak on the knot at x = 225", &steel, speed_to(&steel, 225.0)),
        ("peak 1e-12 before the knot at x = 8.4", &steel, speed_to(&steel, 8.4 * (1.0 - 1e-12))),
        ("peak 1e-12 behind the knot at x = 8.4", &steel, speed_to(&steel, 8.4 * (1.0 + 1e-12))),
        ("v = 1e-100 v_Y", &steel, 1e-100),
        ("elastic impact of any speed", &hertz, 1.0),
        ("v = 1e4 v_Y", &steel, 1e4),
        ("v = 1e8 v_Y", &steel, 1e8),
        ("hardly any rebound: unloading 1e12 times as stiff", &stiffest, 100.0),
        ("hardly any dent: x_r = 2.5e-13", &as_stiff, speed_to(&as_stiff, 1.0 + 1e-6)),
        ("200 knots", &many, 300.0),
        ("five knots 1e-12 apart", &close, 30.0),
        ("five knots 1e-12 apart, peak among them", &close, speed_to(&close, 1.7 * (1.0 + 2e-12))),
    ]
    .map(|(name, law, speed)| closed_form_problem(name, law.clone(), speed))
    .into();

    let [sphere, half_space] = STEEL.youngs_moduli;
    for (name, extreme) in [
        ("rigid sphere, E_s = inf", ExtremePair { youngs_moduli: [f64::INFINITY, half_space], ..STEEL }),
        ("rigid sphere, E_s = 1e30 Pa", ExtremePair { youngs_moduli: [1e30, half_space], ..STEEL }),
        ("E_s/E_h = 1e12", ExtremePair { youngs_moduli: [1e12 * half_space, half_space], ..STEEL }),
        ("E_s/E_h = 1e-3", ExtremePair { youngs_moduli: [1e-3 * half_space, half_space], ..STEEL }),
        ("E_s/E_h = 1e-12", ExtremePair { youngs_moduli: [sphere, 1e12 * sphere], ..STEEL }),
        ("R = 1e-9 m", ExtremePair { radius: 1e-9, ..STEEL }),
        ("R = 1e3 m", ExtremePair { radius: 1e3, ..STEEL }),
        ("yield strength 1e-9 E*: plastic throughout", ExtremePair { strength_ratio: 1e-9, speed_ratio: 1e6, ..STEEL }),
        ("yield strength 10 E*: elastic", ExtremePair { strength_ratio: 10.0, speed_ratio: 1e-3, ..STEEL }),
        ("Poisson's ratios -0.99", ExtremePair { poissons_ratios: [-0.99, -0.99], ..STEEL }),
        ("Poisson's ratios 0.4999999", ExtremePair { poissons_ratios: [0.499_999_9, 0.499_999_9], ..STEEL }),
    ] {
        let (law, speed) = extreme.law();
        cases.push(closed_form_problem(name, law, speed));
    }
    // in SI units other programs fail on these three; the restitution of the first is an independent 30-digit value
    let first = closed_form_problem("P4a: 1 um at 10 m/s", kinked_law(), steel_speed_ratio(10.0));
    let exact = ScaledResult { restitution: 0.301_220_801_577_325_58, ..first.exact };
    cases.push(BenchProblem { description: PRINTED, exact, ..first });
    cases.push(closed_form_problem("P4b: 1 m at 1e-6 m/s", kinked_law(), steel_speed_ratio(1e-6)));
    cases.push(closed_form_problem("P4c: 1 nm at 100 m/s, Hertz alone", hertz, steel_speed_ratio(100.0)));
    cases
}

/// The speed ratio at which the loading curve turns at x.
fn speed_to(law: &Law, indentation: f64) -> f64 {
    (2.5 * law.loading.work(indentation)).sqrt()
}
