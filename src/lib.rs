//! Low-velocity impact of an elastic sphere on an elastic-plastic half-space.
//!
//! A sphere of radius R, mass m and speed v meets a flat half-space at rest, normal to it or at an angle. The contact
//! force follows Hertz up to first yield, a piecewise-linear loading curve (PLM) beyond, and the unloading law of Xie et al.
//! (2024) during the rebound; [`contact::law::catalogue`] has the other published laws. Scenarios may add friction, gravity, damping,
//! plates, rods, elastic waves, series of impacts and quasi-static indentation:
//!
//! ```text
//! m δ'' = −F(δ, memory),   δ(0) = 0,  δ'(0) = v,   until F = 0 at δ = δ_r;   e = −δ'(end)/v
//! ```
//!
//! Without gravity and damping the impact has a closed form. Tables of e(v) use the closed form, unless they name a method. The
//! integration of a single impact is compared with it.
//!
//! The pages of the package: the [limits of validity and expected errors][limits], the [guide to scenarios][guide] with the choice
//! of the strength, and the [example scenarios][examples]. Examples in Rust stand [below](#how-to-use-the-library).
//!
//! [limits]: https://docs.rs/crate/plm-impact/latest/source/scenarios/trust.md
//! [guide]: https://docs.rs/crate/plm-impact/latest/source/scenarios/README.md
//! [examples]: https://docs.rs/crate/plm-impact/latest/source/scenarios/
//!
//! # Notation
//!
//! | symbol | name in code | unit | meaning |
//! |---|---|---|---|
//! | R | `radius` | m | radius of the sphere (not the diameter) |
//! | E_i* | `plane_strain_modulus` | Pa | E_i/(1 − ν_i²), i = s (sphere), h (half-space) |
//! | E* | `effective_modulus` | Pa | 1/E* = 1/E_s* + 1/E_h*; E/(2 (1 − ν²)) for equal bodies |
//! | κ | `sphere_compliance` | 1 | E*/E_s*, the sphere's share of the elastic approach; 0 is a rigid sphere |
//! | ρ_E | `half_space_compliance` | 1 | E*/E_h* = 1 − κ |
//! | σ_Y | `yield_strength` | Pa | of a body (von Mises), not the contact pressure at which it yields |
//! | C_ν | `yield_factor` | 1 | largest Hertz pressure at first yield over σ_Y |
//! | δ, δ_s, δ_h | `indentation`, `sphere_indentation`, `half_space_indentation` | m | approach, δ = δ_s + δ_h |
//! | δ_Y, F_Y, v_Y | `yield_point` | m, N, m/s | first yield |
//! | δ_m, F_m, a_m | `peak_indentation`, `peak_force`, `peak_contact_radius` | m, N, m | where compression stops |
//! | δ_e | `elastic_approach` | m | what of δ is recovered on unloading |
//! | δ_r | `residual_indentation` | m | depth of the dent |
//! | R_e, R_res | `unloading_radius`, `residual_radius` | m | effective radius of unloading; radius of curvature of the dent |
//! | n | `unloading_exponent` | 1 | F ∝ (δ − δ_r)^n |
//! | e | `restitution` | 1 | rebound speed over impact speed (COR) |
//! | v_n, V, Ω, μ | [`Approach`] | m/s, m/s, rad/s, 1 | normal speed, tangential velocity, spin and coefficient of friction of the arriving sphere |
//! | g, χ, ζ | [`Forces`](impact::Forces) | m/s², s/m, 1 | gravity; damping after Hunt and Crossley; fraction of critical damping |
//! | h, d, Y, λ | [`Waveguide`](impact::Waveguide), [`WaveguideResult`](impact::WaveguideResult) | m, m, s/kg, 1 | thickness of a plate or diameter of a rod that is hit, how it gives way (w' = Y F), Zener's number |
//! | C(ν) | [`Waves`](crate::impact::problem::waves::Waves) | 1 | power radiated as elastic waves is C F'²/(ρ c_s³), ρ and c_s of the half-space |
//! | x, f, ε, u, τ | | 1 | δ/δ_Y, F/F_Y, δ_e/δ_Y, δ'/v_Y, t v_Y/δ_Y: x'' = −(5/4) f, ' = d/dτ |
//!
//! # How to use the library
//!
//! These parts serve a user of the library: the contact of two bodies, its impacts, the laws, the trace of an impact, forces and
//! friction, series of impacts, indentation, the force for a DEM code, tables of many impacts, and numbers with units. All quantities
//! below are in SI units.
//!
//! **A contact and its impacts.** [`contact`] has the bodies and laws, [`impact`] their motion. An impact is integrated or exact:
//!
//! ```
//! use plm_impact::{Contact, HalfSpace, Material, Plm, Solver, Sphere};
//!
//! let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
//! let sphere = Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None };
//! let half_space = HalfSpace::flat(steel, Some(345e6));
//! let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
//!
//! let impact = contact.impact(3.0, &Solver::default(), None)?;
//! assert!((impact.row.restitution - 0.490_578_549).abs() < 1e-8);
//!
//! // without stepping
//! let exact = contact.closed_form(3.0)?;
//! assert!((impact.row.contact_time / exact.row.contact_time - 1.0).abs() < 1e-9);
//! # Ok::<(), plm_impact::ImpactError>(())
//! ```
//!
//! **Laws.** [`LawChoice`] has the PLM and the published laws, by the names of `plm-impact laws`. [`Plm`] has an exponent of unloading and
//! flow curves, and [`laws`] converts a hardness:
//!
//! ```
//! # use plm_impact::{Contact, HalfSpace, Material, Plm, Sphere};
//! # let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
//! # let sphere = Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None };
//! # let half_space = HalfSpace::flat(steel, Some(345e6));
//! use plm_impact::LawChoice;
//! use plm_impact::contact::strength::flow_curve::FlowCurve;
//! use plm_impact::laws::UnloadingExponent;
//! use plm_impact::laws::plm::hardness_test::strength_of_hardness;
//!
//! let thornton = LawChoice::from_name("thornton").ok_or("no such law")?;
//! let contact = Contact::try_new(sphere, half_space, thornton.as_contact_law())?;
//! let (slow, fast) = (contact.closed_form(0.1)?, contact.closed_form(10.0)?);
//! assert!(slow.row.restitution > fast.row.restitution);
//!
//! // closest to finite elements; the half-space hardens with N = 0.1
//! let flow = [None, Some(FlowCurve::Power { exponent: 0.1 })];
//! let law = Plm { exponent: UnloadingExponent::PressureShape, flow, ..Plm::default() };
//! let hardening = Contact::try_new(sphere, half_space, &law)?.closed_form(3.0)?;
//! assert!(hardening.row.restitution > 0.55);
//!
//! // a mean pressure of 3 GPa in a hardness test
//! let strength = strength_of_hardness(3e9, None, &steel);
//! assert!((2.3..3.0).contains(&(3e9 / strength)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A trace** is the impact against time: a given number of rows evenly spaced, and one more for every event.
//!
//! ```
//! # use plm_impact::{Contact, HalfSpace, Material, Plm, Solver, Sphere};
//! # let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
//! # let sphere = Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None };
//! # let half_space = HalfSpace::flat(steel, Some(345e6));
//! # let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
//! let impact = contact.impact(3.0, &Solver::default(), Some(200))?;
//! assert!(impact.trace.len() >= 200);
//! let largest = impact.trace.iter().map(|row| row.force).fold(0.0, f64::max);
//! assert_eq!(largest, impact.row.peak_force);
//! # Ok::<(), plm_impact::ImpactError>(())
//! ```
//!
//! **Forces and friction.** [`Forces`](impact::Forces) adds gravity, damping, a plate or a rod; an [`Approach`] adds angle, spin and friction:
//!
//! ```
//! # use plm_impact::{Contact, HalfSpace, Material, Plm, Solver, Sphere};
//! # let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
//! # let sphere = Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None };
//! # let half_space = HalfSpace::flat(steel, Some(345e6));
//! use plm_impact::Approach;
//! use plm_impact::impact::{Damping, Forces, Plate, PlateTheory, TangentialMotion, Waveguide};
//!
//! let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
//! let forces = Forces { gravity: Some(9.81), damping: Some(Damping::Viscous(0.1)), ..Forces::default() };
//! let damped = contact.clone().with_forces(forces).impact(3.0, &Solver::default(), None)?;
//! assert!(damped.row.restitution < contact.closed_form(3.0)?.row.restitution);
//!
//! // a plate of 5 mm absorbs energy; its target needs a density
//! let target = HalfSpace { density: Some(7850.0), ..half_space };
//! let plate = Plate { thickness: 5e-3, edge_distance: None, theory: PlateTheory::Zener };
//! let forces = Forces { waveguide: Some(Waveguide::Plate(plate)), ..Forces::default() };
//! let on_plate = Contact::try_new(sphere, target, &Plm::default())?.with_forces(forces).row(3.0, &Solver::AUTO)?;
//! assert!(on_plate.restitution < contact.closed_form(3.0)?.row.restitution);
//!
//! // gross sliding at 60° from the normal: the tangential impulse is μ (1 + e) m v_n
//! let tangential = TangentialMotion::in_plane(1.5 * 3_f64.sqrt(), 0.0);
//! let approach = Approach { normal: 1.5, tangential, friction: Some(0.1) };
//! let oblique = contact.impact(approach, &Solver::default(), None)?;
//! let rebound = oblique.row.rebound.ok_or("no rebound")?;
//! let after = tangential.speed - 0.1 * (1.0 + contact.closed_form(1.5)?.row.restitution) * 1.5;
//! assert!((rebound.tangential.speed / after - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Series, indentation, DEM.** An [`ImpactSeries`](impact::series::ImpactSeries) hits one spot again and again, a
//! [`StaticContact`](impact::indentation::StaticContact) indents without motion, and [`Contact::force`] with its
//! [`Memory`](impact::Memory) serves a code that moves the spheres itself:
//!
//! ```
//! # use plm_impact::{Contact, HalfSpace, Material, Plm, Solver, Sphere};
//! # let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
//! # let sphere = Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None };
//! # let half_space = HalfSpace::flat(steel, Some(345e6));
//! use plm_impact::impact::Memory;
//! use plm_impact::impact::indentation::{SetPoint, StaticContact};
//! use plm_impact::impact::series::{ImpactSeries, SeriesMode, SpotMode};
//!
//! let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
//! let series = ImpactSeries { spot_mode: SpotMode::Same, mode: SeriesMode::Shots(vec![1.0, 0.5, 2.0]) };
//! let shots = series.run(&contact, &Solver::AUTO, 10, None)?;
//! // the second shot has less energy than the first recovered, and stays on the old unloading curve
//! assert!(shots.impacts[1].impact.row.restitution > 0.999 && shots.impacts[2].impact.row.restitution < 0.9);
//!
//! let press = StaticContact::try_new(&sphere, &half_space, &Plm::default())?;
//! let pressed = press.indent(&[SetPoint::Load(100.0), SetPoint::Load(0.0)], None)?;
//! let mut memory = Memory::default();
//! let force = contact.force(pressed.steps[0].indentation, &mut memory);
//! assert!((force / 100.0 - 1.0).abs() < 1e-9 && memory.dent_depth() > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A table** of many impacts: a [`scenario`] defines the varied keys, and [`table`] computes the rows.
//!
//! ```
//! use plm_impact::Scenario;
//! use plm_impact::table::evaluator::{Evaluator, Rows};
//!
//! let text = r#"
//!     sphere = { radius = "5 mm", youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = 7850 }
//!     half_space = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, yield_strength = "345 MPa" }
//!     [sweep]
//!     "impact.speed" = { logspace = ["0.1 m/s", "10 m/s"], points = 5 }
//! "#;
//! let plan = Scenario::from_text("steel", text, &[])?.plan()?;
//! let mut rows = Rows::default();
//! Evaluator::new(&plan).append_rows(0..5, &mut rows);
//! let restitutions: Vec<f64> = rows.results.iter().flatten().map(|row| row.restitution).collect();
//! assert!(restitutions.len() == 5 && restitutions.is_sorted_by(|slow, fast| slow > fast));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Numbers with units** are parsed as in scenarios:
//!
//! ```
//! use plm_impact::units::{Dimension, parse};
//!
//! assert_eq!(parse("5 mm", Dimension::Length)?, 5e-3);
//! assert!(parse("5 mm", Dimension::Pressure).is_err());
//! # Ok::<(), plm_impact::error::Error>(())
//! ```
//!
//! All other modules serve the command and the tests. They are public, not described here, and may change at any time; `src/README.md`
//! shows them.

// see .clippy.toml
#![warn(clippy::disallowed_methods)]

#[doc(hidden)]
pub mod bench;
#[doc(hidden)]
pub mod calibrate;
pub mod contact;
#[doc(hidden)]
pub mod contact_trace;
#[doc(hidden)]
pub mod error;
#[doc(hidden)]
pub mod files;
pub mod impact;
#[doc(hidden)]
pub mod interfaces;
#[doc(hidden)]
pub mod materials;
#[doc(hidden)]
pub mod numerics;
#[doc(hidden)]
pub mod reference;
#[doc(hidden)]
pub mod report;
#[doc(hidden)]
pub mod results;
pub mod scenario;
#[doc(hidden)]
pub mod strings;
pub mod table;
pub mod units;
#[doc(hidden)]
pub mod validate;

pub use crate::contact::body::{HalfSpace, Material, Sphere};
pub use contact::law::{self as laws, LawChoice, Plm};
pub use error::Error;
pub use impact::{Approach, Contact, Impact, ImpactError, Solver};
pub use scenario::Scenario;
