//! Every row of `src/reference/oracle.csv`: 30-digit energy balance and quadrature of the law, no time stepping.

use approx::assert_relative_eq;
use plm_impact::impact::{Contact, Impact, Method, Solver};
use plm_impact::law::{Plm, UnloadingExponent};
use plm_impact::material::{HalfSpace, Material, Sphere};

struct Row {
    case: String,
    contact: Contact,
    speed: f64,
    want: [f64; 11],
    residual_radius: Option<f64>,
}

fn rows() -> Vec<Row> {
    let text = include_str!("../../src/reference/oracle.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader
        .records()
        .map(|record| {
            let record = record.unwrap();
            let number = |i: usize| record[i].parse::<f64>().unwrap();
            let sphere = Sphere {
                radius: number(1),
                material: Material { youngs_modulus: number(2), poissons_ratio: number(3) },
                density: number(4),
                yield_strength: None,
            };
            let half_space = HalfSpace {
                material: Material { youngs_modulus: number(5), poissons_ratio: number(6) },
                yield_strength: Some(number(7)),
                density: None,
            };
            let exponent = match &record[9] {
                "pressure-shape" => UnloadingExponent::PressureShape,
                _ => UnloadingExponent::Paper,
            };
            Row {
                case: record[0].to_string(),
                contact: Contact::try_new(sphere, half_space, &Plm { exponent, ..Plm::default() }).unwrap(),
                speed: number(8),
                want: [10, 11, 12, 13, 14, 15, 16, 17, 19, 20, 21].map(number),
                residual_radius: record[18].parse().ok(),
            }
        })
        .collect()
}

fn compare(row: &Row, impact: &Impact, tolerance: f64) {
    let point = row.contact.pair().yield_point.unwrap();
    let got = [
        impact.restitution,
        impact.contact_time,
        impact.loading_time,
        impact.peak_force,
        impact.peak_indentation,
        impact.residual_indentation,
        impact.elastic_approach,
        impact.unloading_radius,
        row.contact.yield_speed().unwrap(),
        point.indentation,
        point.force,
    ];
    for (i, (got, want)) in got.into_iter().zip(row.want).enumerate() {
        assert!(
            (got - want).abs() <= tolerance * want.abs(),
            "{}: quantity {i}: {got} against {want}, off by {:e}",
            row.case,
            got / want - 1.0
        );
    }
    assert_eq!(impact.residual_radius.is_some(), row.residual_radius.is_some(), "{}", row.case);
    if let (Some(got), Some(want)) = (impact.residual_radius, row.residual_radius) {
        // R_res = R R_e/(R_e − R) loses digits if the dent is shallow
        assert_relative_eq!(got, want, max_relative = 60.0 * tolerance);
    }
}

#[test]
fn closed_form_is_exact_to_rounding() {
    for row in rows() {
        // the table has 16 digits; a shallow dent (x − ε) loses two of them
        compare(&row, &row.contact.closed_form(row.speed).unwrap(), 5e-14);
    }
}

#[test]
fn every_adaptive_method_reproduces_the_table_at_tight_tolerance() {
    for (method, allowed) in [(Method::Dopri5, 1e-9), (Method::Dop853, 1e-9), (Method::Rk8, 2e-11)] {
        for row in rows() {
            let solver = Solver { method, tolerance: 1e-12, ..Solver::default() };
            compare(&row, &row.contact.impact(row.speed, &solver, None).unwrap(), allowed);
        }
    }
}

#[test]
fn the_default_solver_reproduces_the_table_with_a_trace() {
    for row in rows() {
        compare(&row, &row.contact.impact(row.speed, &Solver::default(), Some(50)).unwrap(), 1e-8);
    }
}
