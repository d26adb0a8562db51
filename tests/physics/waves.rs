//! Radiation of elastic waves: the factor of the material, the integral along an impact, and known values.

use plm_impact::impact::waves::{radiation_factor, restitution_with_waves};

use crate::common::prelude::*;

/// A sphere on a half-space of known density.
#[derive(Debug, Clone, Copy)]
struct Bodies {
    sphere: Sphere,
    half_space: HalfSpace,
    exponent: UnloadingExponent,
    /// Hardening exponent N of the half-space.
    hardening: Option<f64>,
}

fn material(youngs_modulus: f64, poissons_ratio: f64) -> Material {
    Material { youngs_modulus, poissons_ratio }
}

impl Bodies {
    /// A steel ball of 5 mm radius on steel: E = 210 GPa, ν = 0.3, ρ = 7850 kg/m³.
    fn steel(yield_strength: Option<f64>) -> Self {
        let steel = material(210e9, 0.3);
        Self {
            sphere: Sphere { radius: 5e-3, material: steel, density: 7850.0, yield_strength: None },
            half_space: HalfSpace { material: steel, yield_strength, density: Some(7850.0) },
            exponent: UnloadingExponent::Paper,
            hardening: None,
        }
    }

    fn contact(&self) -> Contact {
        let flow = self.hardening.map(|exponent| FlowCurve::Power { exponent });
        Contact::try_new(self.sphere, self.half_space, &Plm { exponent: self.exponent, flow, ..Plm::default() })
            .unwrap()
    }

    fn impact(&self, speed: f64) -> Impact {
        self.contact().closed_form(speed).unwrap()
    }

    fn loss(&self, speed: f64) -> f64 {
        self.impact(speed).wave_loss_fraction.unwrap()
    }

    /// 2 W_rad/(m v²) in SI units by adaptive quadrature over the law, directly from the definition.
    fn loss_by_quadrature(&self, speed: f64) -> f64 {
        let contact = self.contact();
        let (scales, law, _) = contact.scaled(speed).unwrap();
        let impact = contact.closed_form(speed).unwrap();
        let peak = law.loaded_to(impact.peak_indentation / scales.length);
        let half_space = &self.half_space;
        let (nu, density) = (half_space.material.poissons_ratio, half_space.density.unwrap());
        let shear_speed = (half_space.material.youngs_modulus / (2.0 * (1.0 + nu) * density)).sqrt();
        let mass = contact.mass();

        // δ' follows from the remaining work, in units of √(ΦL/m)
        let pieces = law.loading.pieces();
        let most = law.loading.work(peak.indentation);
        let starts: Vec<f64> = pieces.iter().map(|piece| piece.start).filter(|x| *x < peak.indentation).collect();
        let ends = starts[1..].iter().copied().chain([peak.indentation]);
        let loading: f64 = starts
            .iter()
            .zip(ends)
            .zip(pieces)
            .map(|((start, end), piece)| {
                adaptive(*start, end, |x| piece.slope_at(x).powi(2) * (2.0 * (most - piece.work_at(x)).max(0.0)).sqrt())
            })
            .sum();
        let unloading = law.unloading(peak);
        let (n, residual) = (unloading.exponent, peak.residual());
        let back = adaptive(0.0, peak.elastic_approach, |d| {
            let slope = n * peak.force / peak.elastic_approach * (d / peak.elastic_approach).powf(n - 1.0);
            let released = unloading.stored(peak.indentation) - unloading.stored(residual + d);
            slope * slope * (2.0 * released.max(0.0)).sqrt()
        });
        let (force, length) = (scales.force, scales.length);
        let integral = (loading + back) * force * force / length * (force * length / mass).sqrt();
        let radiated = radiation_factor(nu) / (density * shear_speed.powi(3)) * integral;
        2.0 * radiated / (mass * speed * speed)
    }
}

/// Simpson's rule, with parts halved until they are accurate. The substitution x = a + (b − a) sin⁴ θ at both ends
/// removes singularities of square-root type.
fn adaptive(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let length = to - from;
    let middle = 0.5 * (from + to);
    // from each end to the middle, where sin⁴ θ = ½
    let theta = 0.5f64.sqrt().sqrt().asin();
    let near = |theta: f64| (length * theta.sin().powi(4), length * 4.0 * theta.sin().powi(3) * theta.cos());
    let left = simpson(
        &|theta| {
            let (d, dd) = near(theta);
            f((from + d).min(middle)) * dd
        },
        0.0,
        theta,
    );
    let right = simpson(
        &|theta| {
            let (d, dd) = near(theta);
            f((to - d).max(middle)) * dd
        },
        0.0,
        theta,
    );
    left + right
}

fn simpson(f: &dyn Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    fn halves(f: &dyn Fn(f64) -> f64, ends: [f64; 2], values: [f64; 3], whole: f64, size: f64, depth: u32) -> f64 {
        let [a, b] = ends;
        let [fa, fm, fb] = values;
        let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
        let (fl, fr) = (f(0.5 * (a + m)), f(0.5 * (m + b)));
        let (left, right) = (h / 6.0 * (fa + 4.0 * fl + fm), h / 6.0 * (fm + 4.0 * fr + fb));
        let miss = left + right - whole;
        if depth == 0 || miss.abs() < 1e-13 * size {
            return left + right + miss / 15.0;
        }
        halves(f, [a, m], [fa, fl, fm], left, size, depth - 1) + halves(f, [m, b], [fm, fr, fb], right, size, depth - 1)
    }
    // equal panels first, so that no feature is missed between the nodes, and to know the size of the integral
    const PANELS: u32 = 32;
    let h = (to - from) / f64::from(PANELS);
    let panels: Vec<_> = (0..PANELS)
        .map(|i| {
            let a = from + h * f64::from(i);
            let values = [f(a), f(a + 0.5 * h), f(a + h)];
            (a, values, h / 6.0 * (values[0] + 4.0 * values[1] + values[2]))
        })
        .collect();
    let size: f64 = panels.iter().map(|(_, _, whole)| whole.abs()).sum();
    panels.into_iter().map(|(a, values, whole)| halves(f, [a, a + h], values, whole, size, 30)).sum()
}

#[test]
fn the_factor_of_the_material_is_the_formulas() {
    // reference/waves.csv: the same formula in 40 digits by another method, see waves.py
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(&include_bytes!("../reference/waves.csv")[..]);
    let rows: Vec<(f64, f64)> = reader.deserialize().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 14);
    for (nu, factor) in rows {
        let error = off(radiation_factor(nu), factor);
        assert!(error < 1e-13, "{nu}: {error:.1e}");
    }
}

#[test]
fn steel_on_steel_at_half_a_metre_a_second_loses_0_44_percent() {
    // by hand: K = 1.08786e10 N/m^1.5, δ_m = 6.743 µm, ∫ (dF/dδ)² |δ'| dδ = 2 · (9/4) (K δ_m)² v (2/5) B(4/5, 3/2)
    // = 4.2827e9 N²/s, C/(ρ c_s³) = 5.2967e-16 s/kg, ½ m v² = 5.1379e-4 J
    let steel = Bodies::steel(None);
    let loss = steel.loss(0.5);
    assert!(off(loss, 5.2967e-16 * 4.2827e9 / 5.1379e-4) < 1e-4, "{loss}");
    // known value with E = 200 GPa: 0.448 %; for equal bodies the loss goes as E^(-3/10)
    let material = material(200e9, 0.3);
    let softer = Bodies {
        sphere: Sphere { material, ..steel.sphere },
        half_space: HalfSpace { material, ..steel.half_space },
        ..steel
    };
    assert!((100.0 * softer.loss(0.5) - 0.448).abs() < 5e-4);
    assert!(off(softer.loss(0.5), loss * (200.0f64 / 210.0).powf(-0.3)) < 1e-13);
}

#[test]
fn an_elastic_impact_loses_as_v_to_three_fifths() {
    // Hunter (1957); exact for this law, because all elastic impacts have the same shape
    let bodies = Bodies::steel(None);
    let one = bodies.loss(1.0);
    for speed in [1e-12, 1e-6, 1e-3, 0.1, 10.0] {
        assert!(off(bodies.loss(speed), one * speed.powf(0.6)) < 1e-13, "{speed}");
    }
    // so the loss vanishes as v goes to 0
    assert!(bodies.loss(1e-30) < 1e-19);
    // the same for a half-space with a yield strength that does not yield
    assert!(off(Bodies::steel(Some(345e6)).loss(1e-3), bodies.loss(1e-3)) < 1e-13);
}

#[test]
fn the_integral_is_exact_just_before_and_behind_every_knot() {
    let bodies = Bodies::steel(Some(345e6));
    let contact = bodies.contact();
    let yield_speed = contact.yield_speed().unwrap();
    let (_, law, _) = contact.scaled(2.0 * yield_speed).unwrap();
    for piece in &law.loading.pieces()[1..] {
        for nearness in [-1e-2, -1e-5, -1e-9, 1e-9, 1e-5, 1e-2] {
            let x = piece.start * (1.0 + nearness);
            // w(x) = (2/5) q²
            let speed = yield_speed * (2.5 * law.loading.work(x)).sqrt();
            let error = off(bodies.loss(speed), bodies.loss_by_quadrature(speed));
            assert!(error < 1e-10, "{x}: {error:.1e}");
        }
    }
}

#[test]
fn a_half_space_that_hardens_radiates_by_the_same_integral() {
    for (exponent, hardening) in [(UnloadingExponent::Paper, 0.1), (UnloadingExponent::PressureShape, 0.3)] {
        let bodies = Bodies { exponent, hardening: Some(hardening), ..Bodies::steel(Some(345e6)) };
        for speed in [0.012, 0.1, 1.0, 3.0, 20.0] {
            let error = off(bodies.loss(speed), bodies.loss_by_quadrature(speed));
            assert!(error < 1e-10, "{speed}: {error:.1e}");
        }
        // a harder contact is shorter and radiates more
        assert!(bodies.loss(3.0) > Bodies::steel(Some(345e6)).loss(3.0));
    }
}

#[test]
fn stepped_impacts_and_tables_radiate_what_the_closed_form_does() {
    let contact = Bodies::steel(Some(345e6)).contact();
    let exact = contact.closed_form(3.0).unwrap();
    let row = contact.essentials(3.0, &Solver::AUTO).unwrap();
    assert_eq!(row.wave_loss_fraction, exact.wave_loss_fraction);
    assert_eq!(row.restitution_with_waves(), exact.restitution_with_waves());
    for method in [Method::Rk8, Method::Dop853] {
        let solver = Solver { method, tolerance: 1e-11, ..Solver::default() };
        let stepped = contact.impact(3.0, &solver, None).unwrap();
        assert!(off(stepped.wave_loss_fraction.unwrap(), exact.wave_loss_fraction.unwrap()) < 1e-9);
    }
}

#[test]
fn nothing_is_said_of_waves_without_a_density_and_nothing_else_changes() {
    let with = Bodies::steel(Some(345e6));
    let without = Bodies { half_space: HalfSpace { density: None, ..with.half_space }, ..with };
    let (with, without) = (with.impact(3.0), without.impact(3.0));
    assert_eq!((without.wave_loss_fraction, without.restitution_with_waves()), (None, None));
    let essentials = Essentials { wave_loss_fraction: None, ..with.essentials };
    let stripped = Impact { essentials, ..with };
    assert_eq!(stripped, without);
}

#[test]
fn waves_that_would_take_more_than_comes_back_leave_nothing_and_a_warning() {
    // a soft but very heavy half-space has slow shear waves
    let base = Bodies::steel(Some(5e6));
    let with = |density| {
        let half_space = HalfSpace { material: material(3e9, 0.45), density: Some(density), ..base.half_space };
        Bodies { half_space, ..base }.impact(100.0)
    };
    let (light, heavy) = (with(10.0), with(1e7));
    assert!(!light.warnings.iter().any(|warning| warning.kind == WarningKind::StrongWaves));
    assert!(heavy.warnings.iter().any(|warning| warning.kind == WarningKind::StrongWaves));
    assert!(heavy.wave_loss_fraction.unwrap() > heavy.restitution * heavy.restitution);
    assert_eq!(heavy.restitution_with_waves(), Some(0.0));
    // W_rad is proportional to √ρ for a half-space of given moduli
    assert!(off(heavy.wave_loss_fraction.unwrap(), 1e3 * light.wave_loss_fraction.unwrap()) < 1e-13);
    assert!(restitution_with_waves(0.5, 0.26) == 0.0 && off(restitution_with_waves(0.5, 0.09), 0.4) < 1e-15);
}

#[test]
fn waves_are_left_out_where_the_force_jumps_and_the_way_out_is_said() {
    let bodies = Bodies::steel(Some(345e6));
    let contact = |jumps| {
        let law = JacksonGreen { jumps, ..Default::default() };
        Contact::try_new(bodies.sphere, bodies.half_space, &law).unwrap()
    };
    // at a jump of the force F' is infinite, and so is the radiated power
    let says = |impact: &Impact| impact.warnings.iter().any(|warning| warning.kind == WarningKind::WavesAtJump);
    let (printed, crossed) = (contact(Jumps::Printed), contact(Jumps::Crossed));
    let yield_speed = printed.yield_speed().unwrap();
    // x = 1.9 is reached at 1.9^1.25 = 2.23 times the yield speed
    for (times, jumps) in [(0.5, false), (2.2, false), (2.3, true), (300.0, true)] {
        let speed = times * yield_speed;
        let impact = printed.closed_form(speed).unwrap();
        assert_eq!((impact.wave_loss_fraction.is_none(), says(&impact)), (jumps, jumps), "{times}");
        assert_eq!(printed.essentials(speed, &Solver::AUTO).unwrap().wave_loss_fraction.is_none(), jumps);
        assert!(crossed.essentials(speed, &Solver::AUTO).unwrap().wave_loss_fraction.unwrap() > 0.0, "{times}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    #[test]
    fn the_integral_is_exact_for_any_scene(
        ratio in -1.5..1.5f64,
        speed in -1.0..2.5f64,
        nu in 0.0..0.49f64,
        exponent in prop::option::of(1.05..2.0f64),
    ) {
        let base = Bodies::steel(Some(345e6));
        let bodies = Bodies {
            sphere: Sphere { material: material(210e9 * 10f64.powf(ratio), 0.3), ..base.sphere },
            half_space: HalfSpace { material: material(210e9, nu), ..base.half_space },
            exponent: exponent.map_or(UnloadingExponent::PressureShape, UnloadingExponent::Fixed),
            hardening: None,
        };
        let speed = bodies.contact().yield_speed().unwrap() * 10f64.powf(speed);
        let error = off(bodies.loss(speed), bodies.loss_by_quadrature(speed));
        prop_assert!(error < 1e-10, "{error:.1e}");
    }
}
