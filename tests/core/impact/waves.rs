//! Radiation of elastic waves: the factor of the material, the integral along an impact, and known values.

use plm_impact::impact::problem::waves::{radiation_factor, restitution_with_waves};

use crate::common::prelude::*;

/// A steel ball of 5 mm radius on steel of known density, with these settings.
fn steel(set: &[&str]) -> Contact {
    contact(STEEL, &[&["half_space.density=7850"], set].concat())
}

/// A contact with steel that does not yield.
fn elastic(set: &[&str]) -> Contact {
    contact(&STEEL.replace("yield_strength = \"345 MPa\"", "density = 7850"), set)
}

fn loss(contact: &Contact, speed: f64) -> f64 {
    contact.closed_form(speed).unwrap().row.wave_loss_fraction.unwrap()
}

/// 2 W_rad/(m v²) in SI units by quadrature over the law, directly from the definition.
pub fn loss_by_quadrature(contact: &Contact, speed: f64) -> f64 {
    let (scales, law, _) = contact.scaling(speed).unwrap();
    let impact = contact.closed_form(speed).unwrap();
    let peak = law.loaded_state(impact.row.peak_indentation / scales.units.length);
    let HalfSpace { material, density, .. } = *contact.half_space();
    let (nu, density, mass) = (material.poissons_ratio, density.unwrap(), contact.mass());
    let shear_speed = (material.youngs_modulus / (2.0 * (1.0 + nu) * density)).sqrt();

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
            tanh_sinh_reference(*start, end, |x| {
                piece.slope_at(x).powi(2) * (2.0 * (most - piece.work_at(x)).max(0.0)).sqrt()
            })
        })
        .sum();
    let unloading = law.unload(peak);
    let (n, residual) = (unloading.exponent, peak.residual());
    let back = tanh_sinh_reference(0.0, peak.elastic_approach, |d| {
        let slope = n * peak.force / peak.elastic_approach * (d / peak.elastic_approach).powf(n - 1.0);
        let released = unloading.stored_energy(peak.indentation) - unloading.stored_energy(residual + d);
        slope * slope * (2.0 * released.max(0.0)).sqrt()
    });
    let (force, length) = (scales.units.force, scales.units.length);
    let whole = (loading + back) * force * force / length * (force * length / mass).sqrt();
    let radiated = radiation_factor(nu) / (density * shear_speed.powi(3)) * whole;
    2.0 * radiated / (mass * speed * speed)
}

#[test]
fn the_factor_of_the_material_is_the_formulas() {
    // reference/waves.csv: the integral that the row stands for, in 40 digits, at every hundredth of Poisson's ratio; see waves.py
    let rows: Vec<(f64, f64)> = records(include_str!("../../reference/waves.csv"));
    assert_eq!(rows.len(), 151);
    for (nu, factor) in rows {
        let error = relative_error(radiation_factor(nu), factor);
        assert!(error < 1e-13, "{nu}: {error:.1e}");
    }
}

#[test]
fn steel_on_steel_loses_published_wave_energy() {
    // by hand: K = 1.08786e10 N/m^1.5, δ_m = 6.743 µm, ∫ (dF/dδ)² |δ'| dδ = 2 · (9/4) (K δ_m)² v (2/5) B(4/5, 3/2)
    // = 4.2827e9 N²/s, C/(ρ c_s³) = 5.2967e-16 s/kg, ½ m v² = 5.1379e-4 J
    let of_steel = loss(&elastic(&[]), 0.5);
    assert!(relative_error(of_steel, 5.2967e-16 * 4.2827e9 / 5.1379e-4) < 1e-4, "{of_steel}");
    // known value with E = 200 GPa: 0.448 %; for equal bodies the loss goes as E^(-3/10)
    let softer = loss(&elastic(&["sphere.youngs_modulus=200e9", "half_space.youngs_modulus=200e9"]), 0.5);
    assert!((100.0 * softer - 0.448).abs() < 5e-4);
    assert!(relative_error(softer, of_steel * (200.0f64 / 210.0).powf(-0.3)) < 1e-13);
}

#[test]
fn elastic_wave_loss_follows_speed_power_law() {
    // Hunter (1957); exact for this law, because all elastic impacts have the same shape
    let contact = elastic(&[]);
    let one = loss(&contact, 1.0);
    for speed in [1e-12, 1e-6, 1e-3, 0.1, 10.0] {
        assert!(relative_error(loss(&contact, speed), one * speed.powf(0.6)) < 1e-13, "{speed}");
    }
    // so the loss vanishes as v goes to 0
    assert!(loss(&contact, 1e-30) < 1e-19);
    // the same for a half-space with a yield strength that does not yield
    assert!(relative_error(loss(&steel(&[]), 1e-3), loss(&contact, 1e-3)) < 1e-13);
}

#[test]
fn integral_is_exact_beside_every_knot() {
    let contact = steel(&[]);
    let yield_speed = contact.yield_speed().unwrap();
    let (_, law, _) = contact.scaling(2.0 * yield_speed).unwrap();
    for piece in &law.loading.pieces()[1..] {
        for nearness in [-1e-2, -1e-5, -1e-9, 1e-9, 1e-5, 1e-2] {
            let x = piece.start * (1.0 + nearness);
            // w(x) = (2/5) q²
            let speed = yield_speed * (2.5 * law.loading.work(x)).sqrt();
            let error = relative_error(loss(&contact, speed), loss_by_quadrature(&contact, speed));
            assert!(error < 1e-10, "{x}: {error:.1e}");
        }
    }
}

#[test]
fn gravity_does_not_change_radiated_energy() {
    // the estimate is that of the impact without gravity, by every method; at 3 m/s the weight does 2e-5 of the work
    let contact = steel(&["gravity.acceleration=9.81"]);
    for method in [Method::ClosedForm, Method::Rk8, Method::Verlet] {
        let impact = contact.impact(3.0, &Solver { method, ..Solver::default() }, None).unwrap();
        assert!(relative_error(impact.row.wave_loss_fraction.unwrap(), loss(&steel(&[]), 3.0)) < 1e-13, "{method:?}");
    }
    // an elastic impact: Hertz in other units
    assert!(relative_error(loss(&contact, 5e-3), loss(&steel(&[]), 5e-3)) < 1e-13);
    // nothing is known of a sphere that stays, and of one that was let go
    let heavy = steel(&["gravity.acceleration=1e6"]);
    let kept = heavy.impact(0.01, &Solver::default(), None).unwrap();
    assert!(kept.captured_result().is_some() && kept.row.wave_loss_fraction.is_none());
    assert_eq!(heavy.impact(0.0, &Solver::default(), None).unwrap().row.wave_loss_fraction, None);
}

#[test]
fn reload_and_bounces_radiate_by_same_integral() {
    // on the dent the sphere runs up the unloading branch F = S d^n and down again: with d = d_m sin^(2/(n+1)),
    // the integral of F'^2 |u| over both ways, by quadrature over the branch
    let contact = steel(&[]);
    let mut spot = Spot::new();
    let first = contact.impact_on(&mut spot, 3.0, &Solver::AUTO, None).unwrap();
    let speed = first.row.restitution_with_waves().unwrap() * 3.0;
    let again = contact.impact_on(&mut spot, speed, &Solver::AUTO, None).unwrap();
    assert_eq!(again.row.restitution, 1.0);
    let (n, force, approach) = (1.5, again.force_at_peak_indentation, again.elastic_approach);
    let stiffness = force / approach.powf(n);
    let half = tanh_sinh_reference(0.0, approach, |d| {
        let slope = n * stiffness * d.powf(n - 1.0);
        let rest = stiffness / (n + 1.0) * (approach.powf(n + 1.0) - d.powf(n + 1.0));
        slope * slope * (2.0 * rest.max(0.0) / contact.mass()).sqrt()
    });
    let HalfSpace { material, density, .. } = *contact.half_space();
    let shear_speed = (material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio) * density.unwrap())).sqrt();
    let power = radiation_factor(material.poissons_ratio) / (density.unwrap() * shear_speed.powi(3));
    let want = 2.0 * power * 2.0 * half / (contact.mass() * speed * speed);
    assert!(
        relative_error(again.row.wave_loss_fraction.unwrap(), want) < 1e-10,
        "{:?} {want}",
        again.row.wave_loss_fraction
    );

    // each flight begins with the speed that waves leave, and the energy of a series closes
    for place in [SpotMode::Same, SpotMode::Fresh] {
        let contact = steel(&["gravity.acceleration=9.81"]);
        let drive =
            SeriesMode::Bouncing { gravity: 9.81, drop_height: None, approach: 3.0.into(), most: 30, until: None };
        let sequence = ImpactSeries { spot_mode: place, mode: drive }.run(&contact, &Solver::AUTO, 2, None).unwrap();
        assert_eq!(sequence.impacts.len(), 30);
        for hit in &sequence.impacts {
            let flight = hit.flight.map_or(hit.rebound_speed, |flight| flight.speed);
            assert_eq!(flight, hit.impact.row.restitution_with_waves().unwrap() * hit.approach.normal);
            let radiated = hit.impact.row.wave_loss_fraction.unwrap() * hit.impact.row.kinetic_in;
            assert!(relative_error(hit.radiated_energy().unwrap(), radiated) < 1e-9, "{place:?}");
            let weight = hit.forces_value(|under| under.gravity_work).unwrap();
            let spent = hit.recovered_energy() + hit.impact.energy.plastic.unwrap() + radiated;
            assert!(
                relative_error(spent, hit.impact.row.kinetic_in + weight) < 1e-9,
                "{place:?} {}",
                hit.approach.normal
            );
        }
        // so a ball on one spot comes to rest, which it never did without waves
        assert!(sequence.remaining_time.is_some());
    }
}

#[test]
fn waves_need_density_and_change_nothing_else() {
    let [with, without] = [steel(&[]), contact(STEEL, NO_OVERRIDES)].map(|contact| contact.closed_form(3.0).unwrap());
    assert_eq!((without.row.wave_loss_fraction, without.row.restitution_with_waves()), (None, None));
    let row = ImpactRow { wave_loss_fraction: None, ..with.row };
    let stripped = Impact { row, ..with };
    assert_eq!(stripped, without);
}

#[test]
fn wave_loss_above_recovered_energy_warns() {
    // a soft but very heavy half-space has slow shear waves
    let soft =
        ["youngs_modulus=3e9", "poissons_ratio=0.45", "yield_strength=5e6"].map(|set| format!("half_space.{set}"));
    let [light, heavy] = ["half_space.density=10", "half_space.density=1e7"].map(|density| {
        let set: Vec<&str> = soft.iter().map(String::as_str).chain([density]).collect();
        contact(STEEL, &set).closed_form(20.0).unwrap()
    });
    assert!(!light.warnings.iter().any(|warning| warning.kind == WarningKind::StrongWaves));
    assert!(heavy.warnings.iter().any(|warning| warning.kind == WarningKind::StrongWaves));
    assert!(heavy.row.wave_loss_fraction.unwrap() > heavy.row.restitution * heavy.row.restitution);
    assert_eq!(heavy.row.restitution_with_waves(), Some(0.0));
    // W_rad is proportional to √ρ for a half-space of given moduli
    assert!(relative_error(heavy.row.wave_loss_fraction.unwrap(), 1e3 * light.row.wave_loss_fraction.unwrap()) < 1e-13);
    assert!(restitution_with_waves(0.5, 0.26) == 0.0 && relative_error(restitution_with_waves(0.5, 0.09), 0.4) < 1e-15);
}
