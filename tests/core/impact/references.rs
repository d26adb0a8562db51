//! Impacts of independent programs with 30 digits, no time stepping: by every method, with a trace, and as a row of a table.

use crate::common::prelude::*;
use crate::common::reference::{Row, rows};

/// A file of references.
struct References {
    text: &'static str,
    count: usize,
    /// The largest error of the closed form, and at a tolerance of 1e-12 of rk8 and of the steppers of ode_solvers.
    allowed: [f64; 3],
}

/// With the built-in coefficients; the other files name those that they were made with.
const BUILT_IN: References =
    References { text: include_str!("../../reference/built_in.csv"), count: 14, allowed: [1e-12, 2e-11, 1e-9] };
/// Before the corrections for Poisson's ratio and depth.
const TWENTY_FOUR_PIECES: References = References {
    text: include_str!("../../reference/twenty_four_pieces.csv"),
    count: 7,
    allowed: [5e-14, 2e-11, 1e-9],
};
const PLAIN: References =
    References { text: include_str!("../../reference/plain.csv"), count: 18, allowed: [5e-14, 2e-11, 1e-9] };
const HARDENING: References =
    References { text: include_str!("../../reference/hardening.csv"), count: 8, allowed: [1e-12, 1e-11, 1e-9] };
/// A sphere that yields, both bodies, balls among themselves and curved walls.
const YIELDING: References =
    References { text: include_str!("../../reference/yielding.csv"), count: 11, allowed: [1e-12, 1e-11, 1e-9] };
/// There is no closed form on a plate. Measured: 3e-13 and 1.1e-9.
const PLATE: References =
    References { text: include_str!("../../reference/plate.csv"), count: 12, allowed: [f64::NAN, 1e-12, 2e-9] };

impl References {
    fn rows(&self) -> Vec<Row> {
        let rows = rows(self.text);
        assert_eq!(rows.len(), self.count);
        rows
    }
}

/// Compares all results that the row has; `allowed` is relative to the second number.
fn assert_near(row: &Row, contact: &Contact, impact: &Impact, allowed: f64) {
    let (size, on_plate) = (impact.row.peak_indentation, impact.row.waveguide);
    let point = contact.pair().yield_point;
    let of_point = |of: fn(&plm_impact::contact::pair::YieldPoint) -> f64| point.as_ref().map_or(f64::NAN, of);
    // R_res = R R_e/(R_e − R) loses digits where the dent is shallow
    let radius = impact.residual_radius.unwrap_or(f64::NAN);
    let of_plate = |of: fn(&WaveguideResult) -> f64| on_plate.as_ref().map_or(f64::NAN, of);
    let mut compared = 0;
    let target = impact.row.target_speed.unwrap_or(f64::NAN);
    for (name, got, unit) in [
        ("sphere_velocity_after_m_per_s", -impact.rebound_speed, impact.speed),
        ("target_velocity_after_m_per_s", target, impact.speed),
        // e may be next to nothing, and a dent is a small difference
        ("restitution", impact.row.restitution, 1.0),
        ("plastic_fraction", impact.row.plastic_fraction, 1.0),
        ("plate_energy_fraction", impact.row.waveguide_loss_fraction(WaveguideKind::Plate).unwrap_or(f64::NAN), 1.0),
        ("residual_indentation_m", impact.row.residual_indentation, size),
        ("residual_radius_m", radius, 60.0 * radius),
        ("contact_time_s", impact.row.contact_time, impact.row.contact_time),
        ("loading_time_s", impact.loading_time, impact.loading_time),
        ("peak_force_N", impact.row.peak_force, impact.row.peak_force),
        ("peak_indentation_m", size, size),
        ("peak_contact_radius_m", impact.row.peak_contact_radius, impact.row.peak_contact_radius),
        ("elastic_approach_m", impact.elastic_approach, impact.elastic_approach),
        ("unloading_radius_m", impact.unloading_radius, impact.unloading_radius),
        ("unloading_exponent", impact.unloading_exponent, 1.0),
        ("yield_speed_m_per_s", contact.yield_speed().unwrap_or(f64::NAN), contact.yield_speed().unwrap_or(f64::NAN)),
        ("yield_indentation_m", of_point(|point| point.indentation), of_point(|point| point.indentation)),
        ("yield_force_N", of_point(|point| point.force), of_point(|point| point.force)),
        ("lambda", of_plate(|plate| plate.zener_number), of_plate(|plate| plate.zener_number)),
        ("plate_displacement_m", of_plate(|plate| plate.displacement), of_plate(|plate| plate.displacement)),
    ] {
        let Some(want) = row.optional_number(name) else { continue };
        let error = (got - want).abs() / unit;
        assert!(error <= allowed, "{}: {name} {got:e}, not {want:e}: {error:e}", row.name());
        compared += 1;
    }
    assert!(compared >= 7, "{}: {compared}", row.name());
    if let Some(share) = row.optional_number("harder_body_residual_share") {
        let flow = point.unwrap().yield_partition;
        let of_harder = if flow.is_sphere { impact.row.dent_depth() } else { impact.row.flat_depth };
        assert!(
            (of_harder - share * impact.row.residual_indentation).abs() < 1e-11 * size,
            "{}: {of_harder}",
            row.name()
        );
        return;
    }
    let is_plain = row.optional_number("unloading_radius_m").is_some();
    assert!(!is_plain || impact.residual_radius.is_some() == row.optional_number("residual_radius_m").is_some());
}

#[test]
fn every_method_matches_references() {
    for references in [BUILT_IN, TWENTY_FOUR_PIECES, PLAIN, HARDENING, YIELDING, PLATE] {
        let [exact, of_rk8, of_library] = references.allowed;
        for row in references.rows() {
            let scene = row.scene();
            let contact = scene.contact().unwrap();
            let impact = |solver: &Solver, samples| contact.impact(scene.speed(), solver, samples).unwrap();
            // at the default tolerance of 1e-10, as README states it
            let of_default = 2e-11;
            // a row of a table has the closed form
            let mut row_allows = of_default;
            if row.optional_number("half_space.thickness").is_none() {
                assert_near(&row, &contact, &contact.closed_form(scene.speed()).unwrap(), exact);
                row_allows = 1e-12;
            }
            assert_near(&row, &contact, &impact(&Solver::default(), None), of_default);
            assert_near(&row, &contact, &impact(&Solver::default(), Some(50)), of_default);
            for (method, allowed) in [(Method::Rk8, of_rk8), (Method::Dop853, of_library), (Method::Dopri5, of_library)]
            {
                assert_near(&row, &contact, &impact(&solver(method, 1e-12), None), allowed);
            }
            let keys =
                [&row.keys(&["impact"])[..], &[format!("sweep={{\"impact.speed\"=[{}]}}", scene.speed())]].concat();
            let of_table = rows_of("", &keys).results[0].unwrap();
            for (name, got, unit) in [
                ("restitution", of_table.restitution, 1.0),
                ("contact_time_s", of_table.contact_time, of_table.contact_time),
                ("peak_force_N", of_table.peak_force, of_table.peak_force),
                ("peak_indentation_m", of_table.peak_indentation, of_table.peak_indentation),
                ("residual_indentation_m", of_table.residual_indentation, of_table.peak_indentation),
            ] {
                let want = row.number(name);
                assert!((got - want).abs() <= row_allows * unit, "{} in a table: {name} {got:e} {want:e}", row.name());
            }
        }
    }
}

#[test]
fn peak_row_matches_reference() {
    for row in [BUILT_IN, TWENTY_FOUR_PIECES, PLAIN, HARDENING, YIELDING, PLATE].iter().flat_map(References::rows) {
        let (scene, _, impact) = run::impact::compute(&read("", &row.keys(&[])), Some(200)).unwrap();
        let peak = *impact.trace.iter().find(|at| at.event == Some(Event::Peak)).unwrap();
        if let Some(want) = row.optional_number("sphere_speed_at_peak_m_s") {
            assert!(relative_error(peak.sphere_speed.unwrap_or(peak.speed), want) < 1e-8, "{}", row.name());
        }
        // the share of the sphere of what is elastic, and the flat that it keeps
        let compliance =
            |body: &plm_impact::contact::body::Material| (1.0 - body.poissons_ratio.powi(2)) / body.youngs_modulus;
        let [of_sphere, of_half_space] = [&scene.sphere().material, &scene.half_space().material].map(compliance);
        if let Some(elastic) = row.optional_number("elastic_approach_m") {
            let kept = row.optional_number("harder_body_residual_share").unwrap_or(0.0);
            let is_softer =
                scene.contact().unwrap().pair().yield_point.is_some_and(|point| point.yield_partition.is_sphere);
            let flat = if is_softer { 1.0 - kept } else { kept };
            let want = of_sphere / (of_sphere + of_half_space) * elastic
                + flat * row.optional_number("residual_indentation_m").unwrap_or(0.0);
            for got in [peak.sphere_indentation, impact.peak_sphere_indentation] {
                // a rigid sphere has no indentation
                assert!((got - want).abs() <= 1e-8 * want, "{}: {got} {want}", row.name());
            }
        }
    }
}
