//! Every row of `src/reference/oracle.csv` as a scenario: one impact by the default solver, and as a row of a table.

use plm_impact::scenario::Scenario;
use plm_impact::sweep::evaluator::{Evaluator, Rows};

/// The scenario of a row: its numbers as they are written, in SI units, without a table of the solver.
fn scenario(row: &csv::StringRecord) -> String {
    let exponent = row[9].parse::<f64>().map_or_else(|_| format!("{:?}", &row[9]), |n| n.to_string());
    format!(
        "[sphere]\nradius = {}\nyoungs_modulus = {}\npoissons_ratio = {}\ndensity = {}\n\n\
         [half_space]\nyoungs_modulus = {}\npoissons_ratio = {}\nyield_strength = {}\n\n\
         [law.plm]\nunloading_exponent = {exponent}\n",
        &row[1], &row[2], &row[3], &row[4], &row[5], &row[6], &row[7],
    )
}

#[test]
fn the_oracle_is_reproduced_at_the_defaults_and_in_tables() {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(include_str!("../../src/reference/oracle.csv").as_bytes());
    let headers = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 18);
    for row in rows {
        let wanted =
            |name: &str| -> f64 { row[headers.iter().position(|head| head == name).unwrap()].parse().unwrap() };
        // in a row without a dent the difference has to be exactly 0
        let near = |name: &str, got: f64, tolerance: f64| {
            let want = wanted(name);
            assert!(
                (got - want).abs() <= tolerance * want,
                "{} ({}): {name} = {got:e}, not {want:e}",
                &row[0],
                &row[9]
            );
        };
        let single = format!("{}[impact]\nspeed = {}\n", scenario(&row), &row[8]);
        let scene = Scenario::from_text("oracle", &single, &[]).unwrap().resolve().unwrap();
        let contact = scene.contact().unwrap();
        let one = contact.impact(scene.speed, &scene.solver, Some(scene.samples)).unwrap();
        near("yield_speed_m_per_s", contact.yield_speed().unwrap(), 1e-8);
        let table = format!("{}[sweep]\n\"impact.speed\" = [{}]\n", scenario(&row), &row[8]);
        let plan = Scenario::from_text("oracle", &table, &[]).unwrap().plan().unwrap().unwrap();
        let mut rows = Rows::default();
        Evaluator::new(&plan).rows(0..1, &mut rows);
        // ten times the tolerance of the default solver; the closed form is accurate to 5e-14 (tests/physics/oracle.rs)
        for (result, tolerance) in [(one.essentials, 1e-8), (rows.results[0].unwrap(), 1e-12)] {
            near("restitution", result.restitution, tolerance);
            near("contact_time_s", result.contact_time, tolerance);
            near("peak_force_N", result.peak_force, tolerance);
            near("peak_indentation_m", result.peak_indentation, tolerance);
            near("residual_indentation_m", result.residual_indentation, tolerance);
        }
    }
}
