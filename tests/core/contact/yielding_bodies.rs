//! Which body yields: finite elements, limits, and what holds for any pair of bodies.

use plm_impact::contact::law::PlmCoefficients;

use crate::common::prelude::*;
use crate::common::reference::{Row, rows};

/// The contact of a row of finite elements, with the exponent that has a physical reason.
fn contact_of(row: &Row, more: &[&str]) -> (plm_impact::scenario::input::Input, Contact) {
    let keys: Vec<String> = more.iter().map(|key| (*key).to_owned()).collect();
    let exponent = vec!["law.plm.unloading_exponent=pressure-shape".to_owned()];
    let scene = scene("", &[row.keys(&[]), exponent, keys].concat());
    let contact = scene.contact().unwrap();
    (scene, contact)
}

/// Load cycles: force and residual indentation at the depth of the finite elements, e at their energy. Rows with fewer than nine
/// elements in contact are left out, and bodies of equal strength beyond a/R = 0.2. S10 is weaker than the law is meant for.
#[test]
fn load_cycles_are_those_of_finite_elements() {
    let (mut compared, mut off_force, mut off_e) = (0, Vec::new(), Vec::new());
    for row in rows(include_str!("../../../src/reference/fe_yielding.csv")) {
        let (name, ratio) = (row.name().to_owned(), row.number("contact_radius_over_R"));
        if row.number("elements_in_contact") < 9.0 || ["S3", "S7"].contains(&&*name) && ratio > 0.2 {
            continue;
        }
        let (_, contact) = contact_of(&row, &["sphere.density=7850", "impact.speed=1"]);
        let (scales, law, _) = contact.scaling(10.0 * contact.yield_speed().unwrap()).unwrap();
        let depth = row.number("delta_m");
        let peak = law.loaded_state(depth / scales.units.length);
        let force = peak.force * scales.units.force / row.number("F_N") - 1.0;
        let residual = (peak.residual() * scales.units.length - row.number("residual_m")) / depth;
        let impact = contact.closed_form((2.0 * row.number("W_J") / contact.mass()).sqrt()).unwrap();
        let e = impact.row.restitution / row.number("e") - 1.0;
        let [of_force, of_e] = if name == "S10" { [0.07, 0.035] } else { [0.03, 0.025] };
        assert!(
            force.abs() < of_force && residual.abs() < 0.02 && e.abs() < of_e,
            "{name} {depth}: {force} {residual} {e}"
        );
        if name != "S10" {
            off_force.push(force);
            off_e.push(e);
        }
        compared += 1;
    }
    assert_eq!(compared, 31);
    let rms = plm_impact::validate::comparison::rms;
    assert!(rms(&off_force) < 0.011 && rms(&off_e) < 0.011, "{} {}", rms(&off_force), rms(&off_e));
}

/// Whole impacts, to which no number of the law was fitted: e with waves, peak force, contact time, depth, residual indentation.
#[test]
fn whole_impacts_are_those_of_finite_elements() {
    let all = rows(include_str!("../../reference/fe_yielding_impacts.csv"));
    assert_eq!(all.len(), 20);
    for row in all {
        let (scene, contact) = contact_of(&row, &[]);
        let impact = contact.closed_form(scene.speed()).unwrap();
        // D8 is a half-space alone at 10 m/s: what is off there, 2.7 % of e and 1.8 % of the depth, is the law without a flat. M3 and
        // E3, at a/R = 0.155, are off by 2.4 and 2.3 % of e with the 24 pieces, and by 1.7 and 1.2 % with the nine
        let is_plain = row.name() == "D8";
        let of_e = match row.number("a_max_over_R") {
            _ if is_plain => 0.03,
            ratio if ratio > 0.15 => 0.025,
            _ => 0.02,
        };
        let depth = row.number("d_max_m");
        for (what, off, allowed) in [
            ("e", impact.row.restitution_with_waves().unwrap() / row.number("e") - 1.0, of_e),
            ("force", impact.row.peak_force / row.number("F_fit_N") - 1.0, 0.02),
            // M5, a sphere of aluminium with a Poisson ratio of 0.33: 1.04 %
            ("time", impact.row.contact_time / row.number("contact_time_s") - 1.0, 0.011),
            ("depth", impact.row.peak_indentation / depth - 1.0, if is_plain { 0.02 } else { 0.015 }),
            ("residual", (impact.row.residual_indentation - row.number("d_at_loss_m")) / depth, 0.02),
        ] {
            assert!(off.abs() < allowed, "{} {what}: {off}", row.name());
        }
    }
}

/// Who keeps the residual indentation, up to a/R = 0.11: the harder body's share within 0.1 of that of the finite elements.
#[test]
fn dent_and_flat_match_finite_elements() {
    for row in rows(include_str!("../../../src/reference/fe_yielding.csv")) {
        if row.number("contact_radius_over_R") > 0.11 {
            continue;
        }
        let (_, contact) = contact_of(&row, &["sphere.density=7850", "impact.speed=1"]);
        let (flat, dent) = (row.number("flat_over_delta"), row.number("dent_over_delta"));
        let share = contact.pair().yield_point.unwrap().yield_partition.flat_share;
        assert!((share - flat / (flat + dent)).abs() < 0.1, "{}: {share} {}", row.name(), flat / (flat + dent));
    }
}

/// The sphere's own part of the approach has its flat: on a rigid wall it is the whole approach all the way, and of bodies of the same
/// modulus and strength half of it. A sphere that stays elastic has its share of what comes back alone.
#[test]
fn sphere_keeps_flat_in_its_approach() {
    let sphere = Sphere { yield_strength: Some(345e6), ..Scene::steel().bodies().0 };
    let wall = HalfSpace::flat(Material { youngs_modulus: 1e30, poissons_ratio: 0.3 }, None);
    let equal = HalfSpace::flat(sphere.material, Some(345e6));
    for (half_space, share) in [(wall, 1.0), (equal, 0.5)] {
        let contact = Contact::try_new(sphere, half_space, &Plm::default()).unwrap();
        let impact = contact.impact(3.0, &Solver::default(), Some(50)).unwrap();
        assert!(relative_error(impact.peak_sphere_indentation, share * impact.row.peak_indentation) < 1e-12);
        assert!(impact.trace.len() > 50);
        for row in &impact.trace {
            let want = share * row.indentation;
            assert!((row.sphere_indentation - want).abs() < 1e-12 * impact.row.peak_indentation, "{row:?}");
        }
    }
    let elastic = Contact::try_new(Sphere { yield_strength: None, ..sphere }, equal, &Plm::default()).unwrap();
    let impact = elastic.closed_form(3.0).unwrap();
    assert!(relative_error(impact.peak_sphere_indentation, 0.5 * impact.elastic_approach) < 1e-12);
}

/// A scene with the sphere's strength.
fn with_sphere(scene: Scene, strength: Option<f64>) -> Contact {
    let (sphere, half_space) = scene.bodies();
    let sphere = Sphere { yield_strength: strength, ..sphere };
    Contact::try_new(sphere, half_space, &Plm { exponent: scene.exponent, ..Plm::default() }).unwrap()
}

/// The law has no step where the number of bodies that flow changes.
#[test]
fn restitution_is_continuous_over_strength_ratio() {
    let of = |ratio: f64| with_sphere(Scene::steel(), Some(ratio * 345e6)).closed_form(3.0).unwrap().row.restitution;
    for edge in [0.8, 1.0, 1.25] {
        let [below, above] = [edge - 1e-9, edge + 1e-9].map(of);
        assert!((below - above).abs() < 1e-8, "{edge}: {below} {above}");
    }
}

/// Lead on steel gave e = 1 with a warning before the sphere could yield.
#[test]
fn a_lead_ball_on_steel_hardly_rebounds() {
    let sphere = Sphere {
        yield_strength: Some(12e6),
        ..Sphere::elastic(5e-3, Material { youngs_modulus: 16e9, poissons_ratio: 0.44 }, 11_340.0)
    };
    let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
    let half_space = HalfSpace::flat(steel, Some(345e6));
    let impact = Contact::try_new(sphere, half_space, &Plm::default()).unwrap().closed_form(1.0).unwrap();
    assert!(
        impact.row.restitution < 0.3 && impact.row.dent_depth() == 0.0 && impact.row.flat_depth > 0.0,
        "{}",
        impact.row.restitution
    );
    let grave = impact.warnings.iter().find(|warning| warning.kind == WarningKind::SphereYields);
    assert!(grave.is_none(), "{grave:?}");
}

/// The law in units of first yield does not know which of two bodies flows, but for the flat. So with a sphere that is large beside
/// its contact an exchange of the bodies changes nothing, and none of their flow curves.
#[test]
fn small_contacts_are_symmetric_in_the_bodies() {
    let [stiff, soft] = [210e9, 70e9].map(|youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 });
    let law = |strengths: [Option<f64>; 2], materials: [Material; 2], flow: [Option<FlowCurve>; 2]| {
        let sphere = Sphere { yield_strength: strengths[0], ..Sphere::elastic(1.0, materials[0], 1.0) };
        let half_space = HalfSpace::flat(materials[1], strengths[1]);
        let contact = Contact::try_new(sphere, half_space, &Plm { flow, ..Plm::default() }).unwrap();
        let (_, law, _) = contact.scaling(100.0 * contact.yield_speed().unwrap()).unwrap();
        law.clone()
    };
    let curves = [None, Some(FlowCurve::Power { exponent: 0.2 })];
    for (strength, curve) in [1e3, 1e4].into_iter().flat_map(|strength| curves.clone().map(|curve| (strength, curve))) {
        let dented = law([None, Some(strength)], [stiff, soft], [None, curve.clone()]);
        let flattened = law([Some(strength), None], [soft, stiff], [curve, None]);
        for x in [1.5, 3.0, 30.0, 300.0] {
            let [one, two] = [&dented, &flattened].map(|law| law.loaded_state(x));
            assert!(relative_error(two.force, one.force) < 1e-3, "{strength} {x}: {} {}", one.force, two.force);
            assert!(relative_error(two.elastic_approach, one.elastic_approach) < 1e-3, "{strength} {x}");
        }
    }
}

/// The series for the time on the first pieces are made when an impact needs them: it has the same bits whatever came before it.
#[test]
fn impacts_before_change_no_bit_of_an_impact() {
    let of = |sphere| with_sphere(Scene::steel(), sphere);
    for strength in [None, Some(100e6)] {
        let used = of(strength);
        for speed in [0.3, 10.0, 1.0, 3.0, 0.3] {
            let [again, first] = [&used, &of(strength)].map(|contact| contact.closed_form(speed).unwrap());
            assert_eq!(again.row.contact_time.to_bits(), first.row.contact_time.to_bits(), "{speed}");
            assert_eq!(again, first);
        }
    }
}

/// The flat makes a contact softer by a factor that stays constant after a/R has reached 0.6.
#[test]
fn wide_flat_softens_by_constant_factor() {
    let input = scene(STEEL, &["sphere.yield_strength=1 GPa", "half_space.yield_strength=none"]);
    let bodies = YieldingPair::new(&Pair::try_new(&input.sphere(), &input.half_space()).unwrap()).unwrap();
    let (table, ratio) = (PlmCoefficients::built_in(), bodies.yield_radius_ratio());
    let law = Plm::default().law(&bodies).unwrap();
    // the wall stays elastic, so it has no correction for deep dents
    let unflattened =
        PlmCoefficients { depth: None, ..table.clone() }.law(&bodies.pair, ratio, UnloadingExponent::Paper);
    let factor = |x: f64| unflattened.loading.force(x) / law.loading.force(x);
    let is_wide = |x: &f64| law.contact_radius(&law.loaded_state(*x)) * ratio > 0.6;
    let wide: Vec<f64> = unflattened.loading.pieces().iter().map(|piece| piece.start).filter(is_wide).collect();
    assert!(wide.len() >= 2, "{wide:?}");
    let from = (0..400).map(|i| 1.05_f64.powi(i)).find(is_wide).unwrap();
    for x in wide.iter().copied().chain([1e4, 1e5]) {
        assert!(relative_error(factor(x), factor(wide[0])) < 1e-12, "{x}: {} {}", factor(x), factor(wide[0]));
    }
    // and it rises up to there
    assert!(factor(0.5 * from) < 0.99 * factor(from) && factor(from) > 1.1, "{} {}", factor(0.5 * from), factor(from));
}

/// With coefficients that make a deep contact so narrow that a/R never reaches 0.6, the curve ends where the indentation is R.
#[test]
fn curve_of_narrow_flat_has_an_end() {
    let mut coefficients = PlmCoefficients::built_in().clone();
    coefficients.contact_radius.geometry_slope = 1.5;
    let (sphere, half_space) = Scene::steel().bodies();
    let sphere = Sphere { yield_strength: Some(200e6), ..sphere };
    let contact = Contact::try_new(sphere, half_space, &Plm::new(&coefficients, UnloadingExponent::Paper)).unwrap();
    let (scales, law, _) = contact.scaling(3.0).unwrap();
    let last = law.loading.pieces().last().unwrap().start * scales.units.length / sphere.radius;
    assert!((1.0..1.1).contains(&last), "{last}");
}

/// A flow curve that does not rise is the law of one strength, and one that rises lets more come back. A flow curve is known of a body
/// that flows alone.
#[test]
fn hardening_ball_is_softer_body_with_curve() {
    let of = |ratio: f64, flow: [Option<FlowCurve>; 2]| {
        let (sphere, half_space) = Scene::steel().bodies();
        let sphere = Sphere { yield_strength: Some(ratio * 345e6), ..sphere };
        Contact::try_new(sphere, half_space, &Plm { flow, ..Plm::default() })
    };
    let power = |exponent| Some(FlowCurve::Power { exponent });
    for speed in [0.05, 0.5, 3.0, 10.0] {
        let e = |flow| of(0.5, [flow, None]).unwrap().closed_form(speed).unwrap().row.restitution;
        assert!(relative_error(e(power(0.0)), e(None)) < 1e-12, "{speed}");
        assert!(e(power(0.1)) > e(None) && e(power(0.3)) > e(power(0.1)), "{speed}");
    }
    assert!(matches!(of(1.1, [power(0.1), None]), Err(plm_impact::impact::ImpactError::Law(_))));
    // the curve of a body that stays elastic has no part in the law
    let [with, without] = [power(0.1), None].map(|curve| of(2.0, [curve, None]).unwrap().closed_form(3.0).unwrap());
    assert_eq!(with.row.restitution, without.row.restitution);
}
