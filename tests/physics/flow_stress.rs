//! A half-space that hardens, in every kind of scene: traces, indentations, series, gravity and damping, tables.

use plm_impact::impact::closed_form::solve;
use plm_impact::numerics::curve::Curve;
use plm_impact::numerics::curve::piece::{Piece, Shape};

use crate::common::prelude::*;

/// The series for the time on the first pieces against the sum of the times on all pieces: the same law with its curve made
/// anew from its pieces has no series.
#[test]
fn the_contact_time_is_the_sum_of_the_times_on_all_pieces() {
    let flows = [
        (STEEL.to_owned(), "power.exponent = 0"),
        (STEEL.to_owned(), "power.exponent = 0.3"),
        (STEEL.to_owned(), "linear.slope = 4e9"),
        (STEEL.to_owned(), "voce = { saturation = 2, rate = 30 }"),
        // a kink, beyond which the strength is constant
        (STEEL.to_owned(), "points = [[0, 345e6], [0.01, 600e6]]"),
        // a sphere that flows alone
        (STEEL.replace("[sphere]", "[sphere]\nyield_strength = 1e8"), "power.exponent = 0.3"),
        // so soft that the powers of the work would leave double precision at the last pieces
        (STEEL.replace("345 MPa", "1 kPa"), "linear.slope = 1e6"),
    ];
    for (steel, flow) in flows {
        let text = steel.replace("[impact]", &format!("[half_space.flow_stress]\n{flow}\n[impact]"));
        let contact = contact(&text, NONE);
        for k in 0..200 {
            let speed = 0.02 * 1.05_f64.powi(k);
            let (_, law, q) = contact.scaled(speed).unwrap();
            let straight = |curve: Curve, piece: &Piece| match piece.shape {
                Shape::Straight { slope, .. } => curve.then_straight(piece.start, slope),
                _ => panic!("{piece:?}"),
            };
            let loading = law.loading.pieces()[1..].iter().fold(Curve::hertz(), straight);
            let (by_series, by_pieces) = (solve(law, q), solve(&Law::new(loading, law.limits, law.rule.clone()), q));
            assert!(off(by_series.loading_time, by_pieces.loading_time) < 2e-15, "{flow} {speed}");
            assert_eq!(by_series.restitution, by_pieces.restitution, "{flow} {speed}");
        }
    }
}

/// If the hardness varies, so does the yield strength: the table has it as a column, and the results are those of it.
#[test]
fn the_yield_strength_of_a_hardness_is_a_column_where_it_varies() {
    let hardness = STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"300 HV\"");
    let with_flow = hardness.replace("[impact]", "[half_space.flow_stress]\npower = { exponent = 0.1 }\n[impact]");
    let name = "half_space_yield_strength_Pa";
    for (bodies, tables, varies) in [
        (&hardness, "[sweep]\n\"half_space.hardness\" = [\"200 HV\", \"40.8 HRC\"]\n", true),
        (&with_flow, "[sweep]\n\"half_space.flow_stress.power.exponent\" = [0.05, 0.2]\n", true),
        (&with_flow, "[sweep]\n\"half_space.youngs_modulus\" = [1e11, 2e11]\n", true),
        (&hardness, "[sweep]\n\"half_space.poissons_ratio\" = [0.2, 0.3]\n", true),
        (&hardness, "[sweep]\n\"sphere.radius\" = [0.002, 0.003]\n", false),
        (
            &hardness,
            "[monte_carlo]\nsamples = 3\n\"half_space.hardness\" = { normal = { mean = \"300 HV\", sd = \"9 HV\" } }\n",
            true,
        ),
    ] {
        let desk = Desk::ran(format!("{bodies}{tables}"));
        let (table, summary) = (desk.read("out/table.csv"), desk.summary());
        assert_eq!(table.lines().next().unwrap().contains(name), varies, "{table}");
        // values that all rows have in common are inputs; values that vary are not
        assert_eq!(summary["inputs"][name].is_null(), varies, "{summary}");
        assert!(summary["inputs"]["half_space_yield_strength_from"].as_str().unwrap().starts_with("hardness"));
        if !varies || tables.contains("exponent") || tables.contains("modulus") || tables.contains("ratio") {
            continue;
        }
        for (strength, e) in column(&table, name).iter().zip(column(&table, "restitution")) {
            let alone = STEEL.replace("\"345 MPa\"", strength);
            let scene = scene(&alone, NONE);
            let impact = scene.contact().unwrap().closed_form(scene.speed()).unwrap();
            assert!(off(e.parse().unwrap(), impact.restitution) < 1e-14, "{strength}");
        }
        if tables.contains("40.8") {
            // HRC 40.8 is HV 400; see command/strength_keys.rs
            for (strength, wanted) in column(&table, name).iter().zip([743_476_353.118_887_7, 1_566_488_017.801_822]) {
                assert!(off(strength.parse().unwrap(), wanted) < 1e-11);
            }
        }
    }
}

/// A curve steeper than Young's modulus is refused where it is written (command/refusals.toml); where an axis makes it so, the
/// rows say that they are outside of the law.
#[test]
fn rows_with_a_curve_that_no_metal_has_are_outside_of_the_law() {
    let rate = "half_space.flow_stress.voce.rate=2300";
    let got = rows_of(STEEL, &[rate, "sweep={\"half_space.flow_stress.voce.saturation\" = [0.1, 1, 23]}"]);
    let is_outside: Vec<bool> = got.results.iter().map(|row| *row == Err(Failure::OutsideLaw)).collect();
    assert_eq!(is_outside, [false, true, true]);
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    /// A warning is given beyond the curve, and nowhere else.
    #[test]
    fn an_impact_beyond_the_flow_curve_is_warned_of(
        speed in 0.01..20.0_f64, first in 1.0..1.5_f64, second in 1.0..2.0_f64, strain in 1e-3..0.05_f64, zeta in 0.0..0.2_f64,
    ) {
        // steeper than the elastic line is refused
        prop_assume!(345e6 * (second - 1.0) * first < 0.99 * 210e9 * 2.0 * strain);
        let points = format!("points = [[{strain}, {}], [{}, {}]]", 345e6 * first, 3.0 * strain, 345e6 * first * second);
        let text = STEEL.replace("[impact]", &format!("[half_space.flow_stress]\n{points}\n[damping]\nviscous = {zeta}\n[impact]"));
        let contact = contact(&text.replace("3 m/s", &format!("{speed} m/s")), NONE);
        let impact = contact.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        // the curve is used up to a strain of 0.37 (√(δ/R) − √(δ_Y/R))
        let at = |indentation: f64| (indentation / 5e-3).sqrt();
        let asked = 0.37 * (at(impact.peak_indentation) - at(contact.pair().yield_point.unwrap().indentation));
        let is_beyond = impact.warnings.iter().any(|warning| warning.to_string().contains("the flow curve ends"));
        prop_assert_eq!(is_beyond, asked > 3.0 * strain, "{} {}", asked, 3.0 * strain);
    }
}
