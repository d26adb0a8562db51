//! Unloading never gives back more energy than loading took: the exponent of the unloading branch just past first
//! yield.
//!
//! A branch f_m (d/ε_m)^n gives back f_m ε_m/(n + 1). If this is more than the work W_m of loading, n is replaced by
//! the exponent that gives back exactly W_m, f_m ε_m/W_m − 1, with a warning. It is 3/2 at first yield and falls to the n
//! that was asked for. If it is more by over 5 %, an impact has no answer.

use crate::common::prelude::*;

fn steel(n: f64) -> Scene {
    Scene { exponent: UnloadingExponent::Fixed(n), ..Scene::steel() }
}

#[test]
fn series_on_one_spot_warns_of_exponent_once() {
    let contact = steel(1.4).contact();
    let speed = 1.1 * contact.yield_speed().unwrap();
    let repeat = ImpactSeries {
        spot_mode: SpotMode::Same,
        mode: SeriesMode::Shots(vec![speed, speed, 1.05 * speed, 3.0 * speed]),
    };
    let sequence = repeat.run(&contact, &Solver::AUTO, 0, None).unwrap();
    assert!(
        sequence
            .impacts
            .iter()
            .all(|hit| hit.impact.row.restitution <= 1.0 && hit.impact.energy.plastic.unwrap() >= 0.0)
    );
    assert!(matches!(sequence.warnings[..], [(1, Warning { kind: WarningKind::RaisedExponent, .. })]));
}

/// The loading of Thornton's law and the unloading of the PLM.
#[test]
fn fixed_exponent_is_kept_under_other_loading() {
    let plm = LawChoice::Plm(Plm { exponent: UnloadingExponent::Fixed(1.2), ..Plm::default() });
    let [loading, unloading] = [LawChoice::from_name("thornton").unwrap(), plm].map(Box::new);
    let contact = Scene::steel().contact_by(&Combined { loading, unloading });
    let mut refused = 0;
    for i in 1..100 {
        let speed = contact.yield_speed().unwrap() * 1.1_f64.powi(i);
        match contact.closed_form(speed) {
            Ok(impact) => assert_eq!(impact.unloading_exponent, 1.2),
            Err(ImpactError::Law(_)) => refused += 1,
            Err(error) => panic!("{error}"),
        }
    }
    assert!((1..50).contains(&refused), "{refused}");
}

#[test]
fn coefficients_that_would_gain_by_themselves_do_not() {
    // the slope of the force doubles at first yield, and the approach is elastic far beyond it
    let mut table = PlmCoefficients::built_in().clone();
    table.force.from = vec![1.0];
    table.force.slope = vec![4.0];
    table.force.slope_kappa_squared = vec![0.0];
    table.elastic_approach.first_slope = 1.99;
    table.check().unwrap();
    let contact = Scene::steel().contact_by(&Plm::new(&table, UnloadingExponent::Paper));
    for i in 1..60 {
        let speed = contact.yield_speed().unwrap() * (1.0 + 0.05 * f64::from(i));
        match contact.row(speed, &Solver::AUTO) {
            Ok(row) => assert!(row.restitution <= 1.0 && row.plastic_fraction >= 0.0, "{i} {row:?}"),
            Err(error) => assert!(matches!(error, ImpactError::Law(LawError::Exponent { .. })), "{i} {error}"),
        }
    }
}

/// A table that widens the pressure to a ratio of 1.6, with a metal that hardens steeply, asks for an exponent of 0.95: such a contact would end
/// with an infinite stiffness.
#[test]
fn an_exponent_is_never_below_one() {
    let mut table = PlmCoefficients::built_in().clone();
    table.contact_radius.ratio = vec![1.0, 1.5, 1.6];
    table.check().unwrap();
    let plm = |flow| Plm { flow: [None, flow], ..Plm::new(&table, UnloadingExponent::PressureShape) };
    let hardening = Scene::steel().contact_by(&plm(Some(FlowCurve::Power { exponent: 0.5 })));
    let perfect = Scene::steel().contact_by(&plm(None));
    for speed in [0.1, 3.0, 10.0, 20.0] {
        for contact in [&hardening, &perfect] {
            let exact = contact.closed_form(speed).unwrap();
            assert!(exact.unloading_exponent >= 1.0 && exact.row.restitution <= 1.0, "{speed} {exact:?}");
            for (method, _) in STEPPING {
                let stepped = contact.impact(speed, &solver(method, 1e-11), None).unwrap();
                assert!(max_relative_error(&stepped, &exact) < 1e-9, "{speed} {}", method.name());
            }
        }
    }
    assert_eq!(hardening.closed_form(20.0).unwrap().unloading_exponent, 1.0);
}
