//! Impacts with known solutions, on which speed is measured against error.
//!
//! P1, P2 and P3 are a sphere of steel (E 210 GPa, ν 0.3, ρ 7850 kg/m³, R 5 mm, σ_Y 345 MPa) on the same steel, with
//! laws simple enough for pencil and paper: Hertz up to δ_Y = R (π 1.6 σ_Y/2E*)², then straight pieces, and Hertz-type
//! unloading √2 times as stiff as the loading. Three more are the PLM at three of its limits. The last three are other scenes
//! that users compute: the PLM on a half-space that hardens, with viscous damping, and on a plate.

use std::f64::consts::{PI, SQRT_2};

use crate::contact::body::{HalfSpace, Material, STEEL_DENSITY, Sphere};
use crate::contact::law::published::{Loading, hertz_unloading};
use crate::contact::law::{ContactLaw, Law, Plm};
use crate::contact::strength::flow_curve::FlowCurve;
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::impact::solve::closed_form;
use crate::impact::solve::closed_form::solve_energy_balance;
use crate::impact::{Contact, ImpactError, Method, ScaledForces, ScaledResult, Solver, solve};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::pow;
use crate::numerics::ode::DampingCoefficients;
use crate::numerics::power::quarter_period_factor;

/// An impact in dimensionless form, with its exact outcome.
#[derive(Debug, Clone)]
pub struct BenchProblem {
    pub name: &'static str,
    /// A description for a reader of the report.
    pub description: &'static str,
    /// The law, in units of the yield indentation and force.
    pub law: Law,
    /// q = v/V.
    pub speed: f64,
    /// The forces in addition to that of the law.
    pub forces: ScaledForces,
    /// The exact outcome: e and contact time from 16 or more printed digits, the peak by the balance of energy. The hardened
    /// problem has that of the closed form, the damped one that of rk8 at a tolerance of 1e-14, the plate that of 30-digit
    /// arithmetic.
    pub exact: ScaledResult,
}

impl BenchProblem {
    /// `contact_time` in units of L/V.
    fn new(
        name: &'static str,
        description: &'static str,
        law: Law,
        speed: f64,
        restitution: f64,
        contact_time: f64,
    ) -> Self {
        let unloading = solve_energy_balance(&law, speed).unloading;
        let unloading_time =
            quarter_period_factor(unloading.exponent) * unloading.peak.elastic_approach / (restitution * speed);
        let loading_time = contact_time - unloading_time;
        let by_formula = closed_form::solve(&law, speed);
        let exact = ScaledResult { unloading, restitution, loading_time, contact_time, ..by_formula };
        Self { name, description, law, speed, forces: ScaledForces::NONE, exact }
    }
}

/// q = v/V of a steel sphere at `speed` \[m/s\] under the laws of P2 to P4, whatever its radius.
///
/// ```text
/// δ_Y = R (π 1.6 σ_Y/2E*)²,  ½ m V² = (2/5) K δ_Y^2.5,  K = (4/3) E* √R,  m = (4/3) π R³ ρ
/// V² = (4/5) E*/(π ρ) (δ_Y/R)^2.5
/// ```
pub fn steel_speed_ratio(speed: f64) -> f64 {
    let nu = Material::STEEL.poissons_ratio;
    let e_star = Material::STEEL.youngs_modulus / (2.0 * (1.0 - nu * nu));
    let contact_radius_ratio = PI * 1.6 * 345e6 / (2.0 * e_star); // √(δ_Y/R)
    speed / ((0.8 * e_star / (PI * STEEL_DENSITY)).sqrt() * pow(contact_radius_ratio, 2.5))
}

/// Hertz up to x = 1, then straight with Hertz's slope there, 3/2; unloading √2 times as stiff as the loading.
pub fn kinked_law() -> Law {
    stiff_law(SQRT_2)
}

/// A Hertzian law whose unloading has another stiffness, ε = (f/k)^(2/3).
pub fn stiff_law(k: f64) -> Law {
    let loading = Loading::new(LoadingCurve::hertz().then_line(1.0, 1.5), 1.0, |x, _| x.sqrt());
    Law::from_published(loading, hertz_unloading(move |peak| pow(peak.force / k, 2.0 / 3.0)))
}

/// The contact of a steel ball of 5 mm radius with steel of 345 MPa, under a law.
pub fn steel_on_steel(law: &dyn ContactLaw) -> Result<Contact, ImpactError> {
    let half_space = HalfSpace::flat(Material::STEEL, Some(345e6));
    Contact::try_new(Sphere::elastic(5e-3, Material::STEEL, STEEL_DENSITY), half_space, law)
}

/// That ball at this speed on a half-space of 345 MPa that hardens by this power of the strain.
fn steel_ball(exponent: Option<f64>, speed: f64) -> Result<(Law, f64), ImpactError> {
    let plm = Plm { flow: [None, exponent.map(|exponent| FlowCurve::Power { exponent })], ..Plm::default() };
    let contact = steel_on_steel(&plm)?;
    let (_, law, q) = contact.scaling(speed)?;
    Ok((law.clone(), q))
}

/// The hardened impact, the damped one, and the one on a plate.
fn user_problems() -> Result<[BenchProblem; 3], ImpactError> {
    let (law, speed) = steel_ball(Some(0.2), 3.0)?;
    let exact = closed_form::solve(&law, speed);
    let about =
        "PLM, steel sphere of 5 mm radius at 3 m/s on a half-space that hardens with the power 0.2 of the strain";
    let hardened = BenchProblem { name: "hardened", description: about, law, speed, forces: ScaledForces::NONE, exact };
    let (law, speed) = steel_ball(None, 3.0)?;
    let forces = ScaledForces {
        damping: DampingCoefficients { viscous: 0.2, ..DampingCoefficients::NONE },
        ..ScaledForces::NONE
    };
    let solver = Solver { method: Method::Rk8, tolerance: 1e-14, ..Solver::default() };
    let exact = solve(&law, speed, &forces, None, &solver, None)?.outcome;
    let about = "PLM, steel sphere of 5 mm radius on steel at 3 m/s, with a tenth of critical viscous damping";
    let damped = BenchProblem { name: "damped", description: about, law, speed, forces, exact };
    let (law, speed) = steel_ball(None, 1.0)?;
    let forces = ScaledForces {
        damping: DampingCoefficients { plate: 0.090_413_272_576_400_49 / FORCE_FACTOR, ..DampingCoefficients::NONE },
        ..ScaledForces::NONE
    };
    let by_rk8 = solve(&law, speed, &forces, None, &solver, None)?.outcome;
    // 30-digit arithmetic of Zener's equation with this law: restitution, and the times in units of L/V
    let exact = ScaledResult {
        restitution: 0.429_962_209_070_157_3,
        contact_time: 1.202_249_512_645_784_7,
        loading_time: 0.672_461_093_074_569_8,
        ..by_rk8
    };
    let about = "PLM, steel sphere of 5 mm radius on steel at 1 m/s, on a plate with Zener's number 0.2";
    Ok([hardened, damped, BenchProblem { name: "plate", description: about, law, speed, forces, exact }])
}

pub fn problems() -> Result<Vec<BenchProblem>, ImpactError> {
    let p2 = kinked_law();
    let p3 = Law::new(LoadingCurve::clone(&p2.loading).then_line(60.0, 0.75), p2.validity, p2.unloading_rule.clone());
    // √(m/k_1) in units of δ_Y/V, with k_1 = (3/2) F_Y/δ_Y: x'' = −(5/4) (3/2) x
    let unit = 1.875_f64.sqrt().recip();
    let sphere = |radius, youngs_modulus| {
        Sphere::elastic(radius, Material { youngs_modulus, poissons_ratio: 0.3 }, STEEL_DENSITY)
    };
    let plm = |name, about, sphere, yield_strength, speed, restitution, contact_time| {
        let half_space = HalfSpace::flat(Material::STEEL, Some(yield_strength));
        let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
        let (scales, law, q) = contact.scaling(speed)?;
        Ok::<_, ImpactError>(BenchProblem::new(name, about, law.clone(), q, restitution, contact_time / scales.time()))
    };
    let [hardened, damped, plate] = user_problems()?;
    Ok(vec![
        BenchProblem::new("P1", "Hertz alone", Law::hertz(), 1.0, 1.0, 2.943_275_184_324_704_7),
        BenchProblem::new(
            "P2",
            "Hertz, then one straight piece; 77 times the yield indentation",
            p2,
            steel_speed_ratio(1.0),
            0.442_128_945_483_069_8,
            2.388_442_181_292_526_5 * unit,
        ),
        BenchProblem::new(
            "P3",
            "Hertz, then two straight pieces; 300 times the yield indentation",
            p3,
            steel_speed_ratio(3.2),
            0.279_391_655_146_911_8,
            2.694_316_983_752_614_8 * unit,
        ),
        // restitution and contact time of the PLM: 50-digit energy balance and quadrature, as in `tests/reference/hard_cases.py`
        plm(
            "shallow",
            "PLM, steel sphere of 5 mm radius on steel at 0.1 m/s; 6.7 times the yield indentation",
            sphere(5e-3, 210e9),
            345e6,
            0.1,
            0.837_537_175_585_748_8,
            5.313_292_261_363_535e-5,
        )?,
        plm(
            "deep",
            "PLM, sphere of 35 mm radius (104 GPa) on a half-space of 120 MPa at 5 m/s; 1119 times the yield indentation",
            sphere(35e-3, 104e9),
            120e6,
            5.0,
            0.296_659_902_052_557_16,
            2.582_499_974_389_442_4e-4,
        )?,
        plm(
            "soft sphere",
            "PLM, sphere of 35 mm radius, four times softer than the half-space (kappa = 0.8) at 1 m/s",
            sphere(35e-3, 52e9),
            50e6,
            1.0,
            0.338_544_203_724_049_1,
            4.128_221_548_557_24e-4,
        )?,
        hardened,
        damped,
        plate,
    ])
}
