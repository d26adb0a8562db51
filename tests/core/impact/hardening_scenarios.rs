//! A half-space that hardens, in every kind of scene: traces, indentations, series, gravity and damping, tables.

use plm_impact::impact::solve::closed_form::solve;
use plm_impact::numerics::curve::LoadingCurve;
use plm_impact::numerics::curve::piece::{Piece, Shape};

use crate::common::prelude::*;

/// The series for the time on the first pieces against the sum of the times on all pieces: the same law with its curve made
/// anew from its pieces has no series.
#[test]
fn contact_time_is_sum_over_pieces() {
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
        let contact = contact(&text, NO_OVERRIDES);
        for k in 0..200 {
            let speed = 0.02 * 1.05_f64.powi(k);
            let (_, law, q) = contact.scaling(speed).unwrap();
            let straight = |curve: LoadingCurve, piece: &Piece| match piece.shape {
                Shape::Linear { slope, .. } => curve.then_line(piece.start, slope),
                _ => panic!("{piece:?}"),
            };
            let loading = law.loading.pieces()[1..].iter().fold(LoadingCurve::hertz(), straight);
            let (by_series, by_pieces) =
                (solve(law, q), solve(&Law::new(loading, law.validity, law.unloading_rule.clone()), q));
            assert!(relative_error(by_series.loading_time, by_pieces.loading_time) < 2e-15, "{flow} {speed}");
            assert_eq!(by_series.restitution, by_pieces.restitution, "{flow} {speed}");
        }
    }
}

/// A curve steeper than Young's modulus is refused where it is written (`refusals.toml`); where an axis makes it so, the
/// rows say that they are outside of the law.
#[test]
fn impossible_flow_curve_is_outside_the_law() {
    let rate = "half_space.flow_stress.voce.rate=2300";
    let got = rows_of(STEEL, &[rate, "sweep={\"half_space.flow_stress.voce.saturation\" = [0.1, 1, 23]}"]);
    let is_outside: Vec<bool> = got.results.iter().map(|row| *row == Err(RowFailure::OutsideLaw)).collect();
    assert_eq!(is_outside, [false, true, true]);
}

proptest! {
    #![proptest_config(crate::common::proptest_config(100))]

    /// A warning is given beyond the curve, and nowhere else.
    #[test]
    fn impact_beyond_flow_curve_warns(
        speed in 0.01..20.0_f64, first in 1.0..1.5_f64, second in 1.0..2.0_f64, strain in 1e-3..0.05_f64, zeta in 0.0..0.2_f64,
    ) {
        // steeper than the elastic line is refused
        prop_assume!(345e6 * (second - 1.0) * first < 0.99 * 210e9 * 2.0 * strain);
        let points = format!("points = [[{strain}, {}], [{}, {}]]", 345e6 * first, 3.0 * strain, 345e6 * first * second);
        let text = STEEL.replace("[impact]", &format!("[half_space.flow_stress]\n{points}\n[damping]\nviscous = {zeta}\n[impact]"));
        let contact = contact(&text.replace("3 m/s", &format!("{speed} m/s")), NO_OVERRIDES);
        let impact = contact.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        // the curve is used up to a strain of 0.37 (√(δ/R) − √(δ_Y/R))
        let at = |indentation: f64| (indentation / 5e-3).sqrt();
        let asked = 0.37 * (at(impact.row.peak_indentation) - at(contact.pair().yield_point.unwrap().indentation));
        let is_beyond = impact.warnings.iter().any(|warning| warning.to_string().contains("The flow curve ends"));
        prop_assert_eq!(is_beyond, asked > 3.0 * strain, "{} {}", asked, 3.0 * strain);
    }
}
