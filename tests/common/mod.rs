//! Methods, scenes and relative errors that several test files use.
#![allow(dead_code, unused_imports)]

pub mod command;
pub mod golden;
pub mod picture;
pub mod prelude;
pub mod reference;
pub mod untrusted;

use std::cell::Cell;
use std::ops::Range;

use plm_impact::contact::body::{HalfSpace, Material, Sphere};
use plm_impact::contact::law::{ContactLaw, Law, Plm, PlmCoefficients, Surface, UnloadingExponent};
use plm_impact::impact::solve::closed_form;
use plm_impact::impact::{Contact, Impact, ImpactError, Method, ScaledForces, ScaledResult, Solver, Spot};
use plm_impact::numerics::ode::{IntegrationError, SolverStats};
use plm_impact::numerics::power::nan_max;
use plm_impact::scenario::input::Input;
use plm_impact::scenario::{Override, Scenario};
use plm_impact::table::evaluator::{Evaluator, Rows};
use proptest::prop_oneof;
use proptest::strategy::{Just, Strategy};
use proptest::test_runner::{Config, FileFailurePersistence, RngSeed, TestCaseError, TestRunner};

/// A sphere of steel with 5 mm radius on the same steel, at 3 m/s: a scenario to which tests add tables.
pub const STEEL: &str = r#"[sphere]
radius = "5 mm"
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"

[half_space]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "345 MPa"

[impact]
speed = "3 m/s"
"#;

/// No overrides.
pub const NO_OVERRIDES: &[&str] = &[];

/// The scenario of this text, with these overrides.
pub fn read(text: &str, set: &[impl ToString]) -> Scenario {
    let set: Vec<Override> = set.iter().map(|text| text.to_string().into()).collect();
    Scenario::from_text("s.toml", text, &set).unwrap_or_else(|error| panic!("{error}"))
}

/// The input of its first impact.
pub fn scene(text: &str, set: &[impl ToString]) -> Input {
    read(text, set).resolve().unwrap_or_else(|error| panic!("{error}"))
}

/// Its contact.
pub fn contact(text: &str, set: &[impl ToString]) -> Contact {
    scene(text, set).contact().unwrap()
}

/// The rows of its table.
pub fn rows_of(text: &str, set: &[impl ToString]) -> Rows {
    let plan = read(text, set).plan().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).append_rows(0..plan.n_cases(), &mut rows);
    rows
}

/// Every adaptive stepping method, with the largest error at the end of an impact in units of its tolerance. The step
/// control limits the error of one step; the sum over an impact depends on the method. Measured for the hard cases and
/// the random scenes (tolerances 1e-6 to 1e-13), rounded up.
pub const STEPPING: [(Method, f64); 3] = [(Method::Rk8, 10.0), (Method::Dopri5, 10.0), (Method::Dop853, 10.0)];

/// A random case that fails is written into this file, to be committed with its cure. Every property begins with the cases in it.
const KNOWN_FAILURES: FileFailurePersistence = FileFailurePersistence::Direct("tests/proptest-regressions.txt");

/// Settings of a property test: `count` random cases, which are the same in every run. For a wider search, set other
/// cases by `PROPTEST_RNG_SEED` and their number by `PROPTEST_CASES`.
pub fn proptest_config(count: u32) -> Config {
    let from_environment = Config::default();
    let rng_seed = match from_environment.rng_seed {
        RngSeed::Random => RngSeed::Fixed(2024),
        chosen @ RngSeed::Fixed(_) => chosen,
    };
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { from_environment.cases } else { count };
    Config { cases, rng_seed, failure_persistence: Some(Box::new(KNOWN_FAILURES)), ..from_environment }
}

/// Checks a property on `count` random cases, and returns in how many of them it could be judged: `property` is true
/// where it was, and false where the case has no answer.
pub fn check_property<S: Strategy>(
    count: u32,
    strategy: &S,
    property: impl Fn(S::Value) -> Result<bool, TestCaseError>,
) -> usize {
    let judged = Cell::new(0);
    let mut runner = TestRunner::new(proptest_config(count));
    let result = runner.run(strategy, |case| {
        judged.set(judged.get() + usize::from(property(case)?));
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    judged.get()
}

/// A result, unless the law has no answer there: a property test leaves such a case out.
pub fn skip_if_law_has_no_answer<T>(result: Result<T, ImpactError>) -> Result<T, TestCaseError> {
    result.map_err(|error| match error {
        ImpactError::TooDeep { .. } | ImpactError::Law(_) => TestCaseError::reject(error.to_string()),
        _ => TestCaseError::fail(error.to_string()),
    })
}

/// A solver with this method and tolerance.
pub fn solver(method: Method, tolerance: f64) -> Solver {
    Solver { method, tolerance, ..Solver::default() }
}

/// The closed form of an impact on a spot, which then remembers it.
pub fn closed_form_on_spot(contact: &Contact, spot: &mut Spot, speed: f64) -> Impact {
    contact.impact_on(spot, speed, &solver(Method::ClosedForm, 1e-10), None).unwrap()
}

/// One dimensionless impact.
pub fn run<'a>(
    ground: impl Into<Surface<'a>>,
    speed: f64,
    method: Method,
    tolerance: f64,
) -> Result<(ScaledResult, SolverStats), IntegrationError> {
    let ground = ground.into();
    let exact = closed_form::solve(ground, speed);
    let run =
        plm_impact::impact::solve(ground, speed, &ScaledForces::NONE, Some(&exact), &solver(method, tolerance), None);
    run.map(|computed| (computed.outcome, computed.stats))
}

/// Contact time of a Hertz impact times v/δ_max: (4/5) B(2/5, 1/2).
pub const HERTZ_CONTACT_TIME: f64 = 2.943_275_184_324_704_7;

/// |got/want − 1|.
pub fn relative_error(got: f64, want: f64) -> f64 {
    (got / want - 1.0).abs()
}

/// The largest relative error among restitution, contact time, loading time and peak force.
pub fn max_relative_error_of_outcomes(got: &ScaledResult, want: &ScaledResult) -> f64 {
    [
        relative_error(got.restitution, want.restitution),
        relative_error(got.contact_time, want.contact_time),
        relative_error(got.loading_time, want.loading_time),
        relative_error(got.unloading.peak.force, want.unloading.peak.force),
    ]
    .into_iter()
    .fold(0.0, nan_max)
}

/// The largest relative error among restitution, times, peak force and peak indentation of two impacts.
pub fn max_relative_error(got: &Impact, want: &Impact) -> f64 {
    [
        relative_error(got.row.restitution, want.row.restitution),
        relative_error(got.row.contact_time, want.row.contact_time),
        relative_error(got.loading_time, want.loading_time),
        relative_error(got.row.peak_force, want.row.peak_force),
        relative_error(got.row.peak_indentation, want.row.peak_indentation),
    ]
    .into_iter()
    .fold(0.0, nan_max)
}

/// An integral to about 14 digits, also where the integrand has the singularity of a root at an end: the trapezoidal rule in
/// t, with x = from + length/(1 + exp(−π sinh t)) (Takahasi and Mori 1974).
pub fn tanh_sinh_reference(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 1.0 / 32.0;
    let length = to - from;
    let term = |i: i32| {
        let t = STEP * f64::from(i);
        let near = 1.0 / (1.0 + (std::f64::consts::PI * t.abs().sinh()).exp());
        let x = if t < 0.0 { from + length * near } else { to - length * near };
        f(x) * std::f64::consts::PI * t.cosh() * near * (1.0 - near)
    };
    STEP * length * (-115..=115).map(term).sum::<f64>()
}

/// The law with the nine pieces that the references were made with whose files do not name the coefficients.
pub fn nine_pieces() -> Plm {
    let table = PlmCoefficients::from_toml(include_str!("../reference/coefficients-9.toml")).unwrap();
    Plm::new(&table, UnloadingExponent::Paper)
}

/// A sphere on a half-space, SI units.
#[derive(Debug, Clone, Copy)]
pub struct Scene {
    pub radius: f64,
    pub density: f64,
    pub sphere: Material,
    pub half_space: Material,
    pub yield_strength: Option<f64>,
    pub exponent: UnloadingExponent,
}

impl Scene {
    /// Materials of Table 1 of Xie et al. 2024, case 3: E_h 210, E_s 208 GPa, σ_Y 345 MPa, ν 0.3, R = 35 mm.
    pub fn case_3() -> Self {
        let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
        Self {
            radius: 35e-3,
            density: 7850.0,
            sphere: material(208e9),
            half_space: material(210e9),
            yield_strength: Some(345e6),
            exponent: UnloadingExponent::Paper,
        }
    }

    /// A sphere of steel with 5 mm radius on the same steel.
    pub fn steel() -> Self {
        let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
        Self { radius: 5e-3, sphere: steel, half_space: steel, ..Self::case_3() }
    }

    pub fn contact(&self) -> Contact {
        self.try_contact().unwrap()
    }

    pub fn try_contact(&self) -> Result<Contact, ImpactError> {
        let (sphere, half_space) = self.bodies();
        Contact::try_new(sphere, half_space, &Plm { exponent: self.exponent, ..Plm::default() })
    }

    pub fn bodies(&self) -> (Sphere, HalfSpace) {
        let half_space = HalfSpace::flat(self.half_space, self.yield_strength);
        (Sphere::elastic(self.radius, self.sphere, self.density), half_space)
    }

    /// The contact under another law than that of its exponent.
    pub fn contact_by(&self, law: &dyn ContactLaw) -> Contact {
        let (sphere, half_space) = self.bodies();
        Contact::try_new(sphere, half_space, law).unwrap()
    }

    pub fn yield_speed(&self) -> f64 {
        self.contact().yield_speed().unwrap()
    }

    /// The PLM law of the scene, in units of its yield point.
    pub fn law(&self) -> Law {
        let contact = self.contact();
        let (_, law, _) = contact.scaling(10.0 * self.yield_speed()).unwrap();
        law.clone()
    }

    pub fn impact(&self, speed: f64, method: Method, tolerance: f64, samples: Option<usize>) -> Impact {
        self.contact().impact(speed, &solver(method, tolerance), samples).unwrap()
    }
}

/// Random scenes: decades of both Young's moduli, both Poisson's ratios, decades of the radius, and of σ_Y/E*; with the exponent of
/// the paper or "pressure-shape", and 5000 kg/m³.
pub fn scenes(
    modulus: Range<f64>,
    poissons_ratio: Range<f64>,
    radius: Range<f64>,
    strain: Range<f64>,
) -> impl Strategy<Value = Scene> {
    let body = || {
        (modulus.clone(), poissons_ratio.clone())
            .prop_map(|(log, poissons_ratio)| Material { youngs_modulus: 10_f64.powf(log), poissons_ratio })
    };
    let exponent = prop_oneof![Just(UnloadingExponent::Paper), Just(UnloadingExponent::PressureShape)];
    (body(), body(), radius, strain, exponent).prop_map(|(sphere, half_space, log_r, log_strain, exponent)| {
        let e_star = 1.0 / (1.0 / sphere.plane_strain_modulus() + 1.0 / half_space.plane_strain_modulus());
        let yield_strength = Some(10_f64.powf(log_strain) * e_star);
        Scene { radius: 10_f64.powf(log_r), density: 5000.0, sphere, half_space, yield_strength, exponent }
    })
}

/// Random scenes: κ from a nearly rigid to a very soft sphere, σ_Y/E* from 4e-7 to 0.04, so that a_Y/R is up to 0.1.
pub fn any_scene() -> impl Strategy<Value = Scene> {
    scenes(9.0..13.0, 0.0..0.49, -1.5..-1.4, -6.4..-1.4)
}
