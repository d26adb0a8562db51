//! The law without motion: printed table, limits, knots, work, unloading, memory, coefficient tables.

// tables as printed
#![allow(clippy::unreadable_literal, clippy::excessive_precision)]

use std::f64::consts::PI;

use plm_impact::impact::solve::closed_form;

use crate::common::prelude::*;

/// Restitution of a quasi-static cycle to x: square root of recovered over spent work.
fn restitution(law: &Law, x: f64) -> f64 {
    let peak = law.loaded_state(x);
    (law.unload(peak).stored_energy(x) / law.loading.work(x)).sqrt()
}

#[test]
fn printed_table_of_case_3_is_reproduced() {
    // x, f, ε, W/(F_Y δ_Y), δ_s/δ, δ_r/δ_m, e: Xie et al. 2024, Table 1, case 3; computed with 30 digits from the law's
    // definition and printed with 6 to 10
    #[rustfmt::skip]
    let table = [
        [0.5, 0.3535533906, 0.5, 0.07071067812, 0.502392, 0.0, 1.0],
        [1.0, 1.0, 1.0, 0.4, 0.502392, 0.0, 1.0],
        [1.5, 1.837117307, 1.46337678, 1.102270384, 0.490126, 0.0244155, 0.9877168219],
        [1.7, 2.216528818, 1.639126182, 1.507239596, 0.484403, 0.0358081, 0.9819327226],
        [3.0, 5.057057684, 2.649139069, 6.172605254, 0.443636, 0.116954, 0.9317450113],
        [6.0, 13.2848753, 4.519200382, 33.19948495, 0.378402, 0.2468, 0.8504991088],
        [13.5, 39.66439315, 8.098300364, 227.7999516, 0.301372, 0.400126, 0.7510183169],
        [30.0, 111.3790227, 14.1570179, 1456.015413, 0.237079, 0.528099, 0.6581647239],
        [105.1, 516.9194675, 31.22024643, 24562.28802, 0.149237, 0.702947, 0.5126549951],
        [300.0, 1733.205069, 56.69780713, 241783.0525, 0.0949485, 0.811007, 0.4032043176],
        [843.1, 5334.599546, 94.76797159, 2160049.321, 0.056471, 0.887596, 0.3059707184],
    ];
    let scene = Scene::case_3();
    let (law, kappa) = (scene.law(), scene.contact().pair().sphere_compliance);
    for [x, f, eps, work, sphere_share, residual_share, e] in table {
        let peak = law.loaded_state(x);
        let near =
            |got: f64, want: f64, digits: f64| assert!((got - want).abs() <= digits * want, "x = {x}: {got} {want}");
        near(peak.force, f, 6e-10);
        near(peak.elastic_approach, eps, 6e-10);
        near(law.loading.work(x), work, 6e-10);
        near(kappa * peak.elastic_approach / x, sphere_share, 6e-6);
        near(peak.residual() / x, residual_share, 6e-6);
        near(restitution(&law, x), e, 6e-10);
    }
}

proptest! {
    #![proptest_config(crate::common::proptest_config(200))]

    #[test]
    fn work_is_the_integral_of_the_force(scene in any_scene(), log_x in -3.0..5.0_f64) {
        let law = scene.law();
        let x = 10_f64.powf(log_x);
        let starts = law.loading.pieces().iter().map(|piece| piece.start).filter(|start| *start < x);
        let ends: Vec<f64> = starts.chain([x]).collect();
        let sum: f64 = ends.windows(2).map(|span| tanh_sinh_reference(span[0], span[1], |x| law.loading.force(x))).sum();
        prop_assert!(relative_error(law.loading.work(x), sum) < 1e-13, "{} {sum}", law.loading.work(x));
    }

    #[test]
    fn work_is_inverted(scene in any_scene(), log_x in -3.0..5.0_f64) {
        let curve = scene.law().loading;
        let x = 10_f64.powf(log_x);
        let piece = &curve.pieces()[curve.index_at(x)];
        prop_assert!(relative_error(piece.indentation_at_work(curve.work(x)), x) < 2e-15);
    }

    #[test]
    fn unloading_begins_at_peak_and_ends_at_dent(scene in any_scene(), log_x in -1.0..4.0_f64, exponent in 0..3_usize) {
        let exponent = [UnloadingExponent::Paper, UnloadingExponent::Fixed(1.2), UnloadingExponent::PressureShape][exponent];
        let law = Scene { exponent, ..scene }.law();
        let x = 10_f64.powf(log_x);
        let peak = law.loaded_state(x);
        let unloading = law.unload(peak);
        // Eq. 19: F(δ_m) = F_m, F(δ_r) = 0; x − x_r loses digits by the factor x/ε
        prop_assert!(relative_error(unloading.force(x), peak.force) < 4e-15 * x / peak.elastic_approach);
        prop_assert_eq!(unloading.force(peak.residual()), 0.0);
        prop_assert_eq!(unloading.force(0.5 * peak.residual()), 0.0);
        // stored energy is the integral of the force
        let middle = peak.residual() + 0.5 * peak.elastic_approach;
        let returned = tanh_sinh_reference(middle, x, |x| unloading.force(x));
        prop_assert!(relative_error(unloading.stored_energy(x) - unloading.stored_energy(middle), returned) < 1e-11 * x / peak.elastic_approach);
        // Eq. 24 in units of the yield point: R_e/R = f²/ε³; and with exponent 3/2 the law is f = √(R_e/R) (x −
        // x_r)^1.5
        let ratio = peak.unloading_radius_ratio();
        prop_assert!(relative_error(ratio, peak.force.powi(2) / peak.elastic_approach.powi(3)) < 1e-14);
        if exponent == UnloadingExponent::Paper {
            prop_assert!(relative_error(unloading.force(middle), ratio.sqrt() * (0.5 * peak.elastic_approach).powf(1.5)) < 1e-12 * x / peak.elastic_approach);
        }
    }
}

#[test]
fn radius_ratio_and_exponent_have_their_end_values() {
    let table = &PlmCoefficients::built_in().contact_radius;
    let shallow = table.for_contact(0.0, 0.01);
    // Λ: 1 up to A = 1.5, 1.15 at A = 4, 1.19 from A = 8 on
    for (radius, want) in
        [(0.0, 1.0), (1.0, 1.0), (1.5, 1.0), (2.75, 1.075), (4.0, 1.15), (6.0, 1.17), (8.0, 1.19), (1e6, 1.19)]
    {
        assert!(relative_error(shallow.pressure_shape_at(radius), want) < 1e-15, "{radius}");
    }
    // G = 1 + (0.25 + 0.145 κ²) max(0, â/R − 0.105), here with a_Y = R/100 so that â/R = A/100
    for (kappa, radius, want) in [(0.0, 10.5, 1.0), (0.0, 40.5, 1.075), (0.5, 40.5, 1.085_875), (1.0, 50.5, 1.158)] {
        let deep = table.for_contact(kappa * kappa, 0.01);
        assert!(relative_error(deep.geometry_factor_at(radius), want) < 1e-15, "{kappa} {radius}");
        assert_eq!(deep.geometry_factor_at(0.5 * f64::min(radius, 10.5)), 1.0);
    }
    // a body that yields at a_Y/R = 0.2: G = 1 + 0.25 (A/5 − 0.105 − (0.2 − 0.105)/A)
    let hard = table.for_contact(0.0, 0.2);
    for (radius, want) in [(1.0, 1.0), (2.0, 1.061_875), (5.0, 1.219)] {
        assert!(relative_error(hard.geometry_factor_at(radius), want) < 1e-15, "{radius}");
    }
    assert_eq!(pressure_shape_exponent(1.0), 1.5);
    // uniform pressure, Λ = 3π/8: n = 3π/4 − 1
    assert!(relative_error(pressure_shape_exponent(3.0 * PI / 8.0), 0.75 * PI - 1.0) < 1e-15);
    // n = 3/2 − 0.80746 (Λ − 1)
    assert!(relative_error(pressure_shape_exponent(1.1), 1.5 - 0.080_746) < 1e-6);
    // after elastic loading, unloading follows Hertz for every choice
    for exponent in [UnloadingExponent::Fixed(1.2), UnloadingExponent::PressureShape] {
        let law = Scene { exponent, ..Scene::case_3() }.law();
        assert_eq!(law.unload(law.loaded_state(0.9)).exponent, 1.5);
    }
}

/// The built-in table with one change.
fn changed(change: impl FnOnce(&mut PlmCoefficients)) -> PlmCoefficients {
    let mut table = PlmCoefficients::built_in().clone();
    change(&mut table);
    table
}

#[test]
fn built_in_table_is_accepted_with_its_source() {
    let table = PlmCoefficients::built_in();
    table.check().unwrap();
    assert!(table.provenance.source.contains("CalculiX") && table.provenance.range.contains("0.55"));
}

#[test]
fn a_table_without_geometry_is_read() {
    let text = include_str!("../../../src/contact/law/plm/coefficients.toml");
    assert_eq!(&PlmCoefficients::from_toml(text).unwrap(), PlmCoefficients::built_in());
    // a table in the earlier form without geometry: G = 1
    let older: String =
        text.lines().filter(|line| !line.starts_with("geometry_slope")).map(|l| l.to_owned() + "\n").collect();
    let radius = PlmCoefficients::from_toml(&older).unwrap().contact_radius.for_contact(0.25, 0.01);
    assert_eq!(radius.geometry_factor_at(1e3), 1.0);
}

/// A table may have the coefficient 0: then the first slope is the same for every κ.
#[test]
fn first_slope_may_be_independent_of_kappa() {
    let table = changed(|table| table.elastic_approach.first_slope_kappa_squared = 0.0);
    table.check().unwrap();
    for modulus in [70e9, 210e9, 600e9] {
        let scene = Scene { sphere: Material { youngs_modulus: modulus, ..Scene::steel().sphere }, ..Scene::steel() };
        let contact = scene.contact_by(&Plm::new(&table, UnloadingExponent::Paper));
        let (_, law, _) = contact.scaling(1.0).unwrap();
        // ε = 1 + 1.62 (A − 1) with A = f/ε, before the contact is fully plastic
        let ContactState { force, elastic_approach, .. } = law.loaded_state(1.9);
        let want = 1.0 + 1.62 * (force / elastic_approach - 1.0);
        assert!(relative_error(elastic_approach, want) < 1e-13, "{modulus}: {elastic_approach} {want}");
    }
}

/// The factor for a Poisson's ratio is 1 at the first knot. So it does not change the force of a table with one knot.
#[test]
fn single_slope_fits_every_poissons_ratio() {
    let single = changed(|table| {
        table.depth = None;
        table.force.from.truncate(1);
        table.force.slope.truncate(1);
        table.force.slope_kappa_squared.truncate(1);
    });
    single.check().unwrap();
    let scene = Scene { half_space: Material { poissons_ratio: 0.1, ..Scene::steel().half_space }, ..Scene::steel() };
    let pair = *scene.contact().pair();
    let force = |table: &PlmCoefficients| table.law(&pair, 0.01, UnloadingExponent::Paper).loading.force(10.0);
    let plain = PlmCoefficients { poisson: None, ..single.clone() };
    assert_eq!(force(&single), force(&plain));
}

/// If the knots of a table change after a law was made with it, the next law has the new knots.
#[test]
fn used_table_follows_changed_knots() {
    let scene = Scene { half_space: Material { poissons_ratio: 0.1, ..Scene::steel().half_space }, ..Scene::steel() };
    let pair = *scene.contact().pair();
    let force = |table: &PlmCoefficients| table.law(&pair, 0.01, UnloadingExponent::Paper).loading.force(100.0);
    let mut used = PlmCoefficients::from_toml(include_str!("../../../src/contact/law/plm/coefficients.toml")).unwrap();
    let mut fresh = used.clone();
    force(&used);
    for table in [&mut used, &mut fresh] {
        table.force.from[0] = 1.5;
    }
    assert_eq!(force(&used), force(&fresh));
}

/// A table without the corrections for Poisson's ratio and depth is the law without them to the last bit, and so is one with zeros.
#[test]
fn zero_corrections_change_no_bit() {
    let text = include_str!("../../reference/coefficients-24.toml");
    let zeros = "[poisson]\nforce = 0\napproach = 0\n[depth]\nfrom = 0.035\nto = 0.2\nforce = 0\nrecovery = 0\nrecovery_kappa = 0.75\nradius = 0\nradius_from = 0.4\n";
    let [absent, zero] = [text.to_owned(), format!("{text}\n{zeros}")]
        .map(|text| Plm::new(&PlmCoefficients::from_toml(&text).unwrap(), UnloadingExponent::PressureShape));
    for (poissons_ratio, exponent) in [(0.05, None), (0.3, None), (0.45, None), (0.2, Some(0.2))] {
        let scene = Scene { half_space: Material { poissons_ratio, ..Scene::steel().half_space }, ..Scene::steel() };
        let flow = [None, exponent.map(|exponent| FlowCurve::Power { exponent })];
        let [absent, zero, built_in] =
            [&absent, &zero, &Plm { exponent: UnloadingExponent::PressureShape, ..Plm::default() }]
                .map(|plm| scene.contact_by(&Plm { flow: flow.clone(), ..plm.clone() }));
        for speed in [0.5, 5.0, 50.0] {
            let impact = absent.closed_form(speed).unwrap();
            assert_eq!(impact, zero.closed_form(speed).unwrap());
            // and at 50 m/s each law here has a correction
            assert!(speed < 50.0 || impact.row.restitution != built_in.closed_form(speed).unwrap().row.restitution);
        }
    }
}

/// An impact that turns before a deep dent sees the same curve, whether its part beyond was computed or not; one that continues sees
/// the whole curve.
#[test]
fn impacts_see_the_curve_that_they_reach() {
    let contact = Scene::steel().contact();
    let (_, law, _) = contact.scaling(1.0).unwrap();
    let yields = contact.yield_speed().unwrap();
    let from = 0.035 / (contact.pair().yield_point.unwrap().contact_radius / contact.pair().radius).powi(2);
    let (mut shallow, mut deep) = (0, 0);
    for i in 0..60 {
        let speed = yields * 1.25_f64.powi(i);
        let Ok(impact) = contact.closed_form(speed) else { continue };
        let whole = closed_form::solve(law, speed / yields);
        assert!(relative_error(impact.row.restitution, whole.restitution) < 1e-14, "{speed}");
        assert!(
            relative_error(impact.row.contact_time, whole.contact_time * contact.scaling(speed).unwrap().0.time())
                < 1e-14
        );
        if whole.unloading.peak.indentation < from { shallow += 1 } else { deep += 1 }
    }
    assert!(shallow > 20 && deep > 5, "{shallow} {deep}");
}

/// D: the part of the yielding that is in the half-space; of two balls, the part in the larger one times the difference of the radii over
/// their sum.
fn depth_share(sphere: &Sphere, half_space: &HalfSpace, of_sphere: f64) -> f64 {
    let Some(radius) = half_space.radius else { return 1.0 - of_sphere };
    let of_larger = if radius > sphere.radius { 1.0 - of_sphere } else { of_sphere };
    of_larger * (radius - sphere.radius).abs() / (radius + sphere.radius)
}

/// Force and elastic approach of deep dents by the formulas of `depth.rs`, from those of a table without depth: at every knot, also
/// beyond δ/R = 0.2, where y is constant. The bodies are a half-space that yields early, late (beyond the start of the correction) or
/// together with the sphere, a sphere that yields alone, and two balls, of which either is the larger one.
#[test]
fn deep_dent_follows_formulas_from_shallow_one() {
    let contacts: [&[&str]; 8] = [
        &["half_space.yield_strength=345 MPa"],
        &["half_space.yield_strength=2 GPa"],
        &["half_space.yield_strength=9 GPa"],
        &["half_space.yield_strength=15 GPa"],
        &["half_space.yield_strength=1.5 GPa", "sphere.yield_strength=1.5 GPa"],
        &["half_space.yield_strength=900 MPa", "sphere.yield_strength=200 MPa"],
        &["half_space.radius=3 mm", "half_space.yield_strength=1 GPa", "sphere.yield_strength=1.1 GPa"],
        &["half_space.radius=8 mm", "half_space.yield_strength=1 GPa", "sphere.yield_strength=1.1 GPa"],
    ];
    let shallow_table = changed(|table| table.depth = None);
    let (mut changed_points, mut constant_points) = (0, 0);
    for keys in contacts {
        let input = scene(STEEL, keys);
        let (sphere, half_space) = (input.sphere(), input.half_space());
        let bodies = YieldingPair::new(&Pair::try_new(&sphere, &half_space).unwrap()).unwrap();
        let partition = bodies.yield_point.yield_partition;
        let share = depth_share(&sphere, &half_space, partition.sphere_share);
        let (kappa, plastic_from) = (partition.elastic_share, 1.0 + 7.6 * partition.plastic_share);
        let ratio = bodies.yield_radius_ratio();
        let law = |table: &PlmCoefficients| Plm::new(table, UnloadingExponent::Paper).law(&bodies).unwrap();
        let shallow = law(&shallow_table);
        // A, without the flat of a sphere
        let without_flat = shallow_table.law(&bodies.pair, ratio, UnloadingExponent::Paper);
        let equivalent = |x: f64| without_flat.loaded_state(x).force / without_flat.loaded_state(x).elastic_approach;
        let y = |x: f64| {
            let depth = (x * ratio * ratio).min(0.2);
            let plastic = 1.0 - plastic_from / equivalent(depth / (ratio * ratio));
            share * (depth - 0.035).max(0.0) * plastic.max(0.0)
        };
        // also with some numbers of the correction at 0
        for (of_force, of_recovery, of_radius) in
            [(0.55, 1.4, 0.14), (0.55, 1.4, 0.0), (0.55, 0.0, 0.0), (0.0, 1.4, 0.0)]
        {
            let deep = law(&changed(|table| {
                let depth = table.depth.as_mut().unwrap();
                (depth.force, depth.recovery, depth.radius) = (of_force, of_recovery, of_radius);
            }));
            let knots = [&deep, &shallow].map(|law| law.loading.pieces()).into_iter().flatten();
            for x in knots.map(|piece| piece.start).filter(|x| *x > 1.7) {
                let [state, base] = [&deep, &shallow].map(|law| law.loaded_state(x));
                let about = format!("{keys:?} {of_force} {of_recovery} {x}: {} {}", state.force, base.force);
                assert!(relative_error(state.force * (1.0 + of_force * y(x)), base.force) < 1e-12, "{about}");
                let approach = base.elastic_approach * (1.0 + of_recovery * (0.75 - kappa) * y(x));
                assert!(relative_error(state.elastic_approach, approach.min(x)) < 1e-12, "{about}");
                changed_points += usize::from(y(x) > 0.0);
                constant_points += usize::from(x * ratio * ratio > 0.2 && y(x) > 0.0);
            }
        }
    }
    assert!(changed_points > 500 && constant_points > 50, "{changed_points} {constant_points}");
}

/// A half-space so hard that the correction would begin before the first knot: no two pieces begin at one x, so every method passes the
/// knot as the closed form does.
#[test]
fn hard_half_space_is_integrated_beyond_first_knot() {
    let contact = Scene { yield_strength: Some(9e9), ..Scene::steel() }.contact();
    let exact = contact.closed_form(300.0).unwrap();
    let a_y = contact.pair().yield_point.unwrap().contact_radius / contact.pair().radius;
    assert!(0.035 < 1.7 * a_y * a_y && exact.row.peak_indentation > 0.2 * contact.pair().radius);
    for (method, factor) in STEPPING {
        let stepped = contact.impact(300.0, &solver(method, 1e-10), None).unwrap();
        let error = max_relative_error(&stepped, &exact);
        assert!(error < factor * 1e-10, "{}: {error:e}", method.name());
    }
}

/// Behind another loading A is the force of this loading over the elastic approach that the law of shallow dents has at this force, and
/// where the elastic approach is measured, the force over this elastic approach. The exponent is that of the pressure's shape at this A.
#[test]
fn recovery_behind_other_loading_follows_its_force() {
    // Λ rises over all dents
    let table = changed(|table| table.contact_radius.from = vec![1.5, 4.0, 80.0]);
    let shallow_table = PlmCoefficients { depth: None, ..table.clone() };
    let exponent_at = |equivalent: f64| pressure_shape_exponent(table.contact_radius.pressure_shape_at(equivalent));
    let mut deepest: f64 = 0.0;
    for strength in [345e6, 3e9] {
        let (sphere, half_space) = Scene { yield_strength: Some(strength), ..Scene::steel() }.bodies();
        let bodies = YieldingPair::new(&Pair::try_new(&sphere, &half_space).unwrap()).unwrap();
        let [deep, shallow] = [&table, &shallow_table]
            .map(|table| Plm::new(table, UnloadingExponent::PressureShape).build_parts(&bodies));
        let square = bodies.yield_radius_ratio().powi(2);
        for (x, share) in [2.0, 12.0, 40.0].into_iter().flat_map(|x| [0.9, 1.05].map(|share| (x, share))) {
            let force = share * shallow.loading.as_ref().unwrap().curve.force(x);
            let at = |elastic_approach| published::LoadedState {
                indentation: x,
                force,
                contact_radius: x.sqrt(),
                elastic_approach,
                loading_work: f64::INFINITY,
            };
            let base = (shallow.recovery)(at(None)).elastic_approach;
            // κ = 1/2, A_fp = 1 + 7.6/2
            let y = (x * square - 0.035).max(0.0) * (1.0 - 4.8 / (force / base)).max(0.0);
            deepest = deepest.max(y);
            let measured = 0.8 * base;
            for (known, approach, equivalent) in [
                (None, (base * (1.0 + 1.4 * 0.25 * y)).min(x), force / base),
                (Some(measured), measured, force / measured),
            ] {
                let Recovery { elastic_approach, shape } = (deep.recovery)(at(known));
                let UnloadingShape::Power(n) = shape else { panic!("{shape:?}") };
                let want = exponent_at(equivalent);
                assert!(relative_error(elastic_approach, approach) < 1e-12, "{strength} {x} {share} {known:?}");
                assert!(relative_error(n, want) < 1e-12, "{strength} {x} {share} {known:?}: {n} {want}");
            }
        }
    }
    assert!(deepest > 0.01, "{deepest}");
}

/// A heavy sphere that is slow at first touch goes deep by its weight: at its peak it has the force that the contact has at this
/// indentation.
#[test]
fn slow_heavy_sphere_sees_deep_curve() {
    let soft = Material { youngs_modulus: 100e6, poissons_ratio: 0.3 };
    let scene = Scene { radius: 1.0, half_space: soft, yield_strength: Some(400e3), ..Scene::steel() };
    let contact = scene.contact().with_forces(Forces { gravity: Some(9.81), ..Forces::default() });
    for method in [Method::ClosedForm, Method::Rk8] {
        let impact = contact.impact(0.1, &solver(method, 1e-11), None).unwrap();
        assert!(impact.row.peak_indentation > 0.08, "{}", impact.row.peak_indentation);
        let force = contact.force(impact.row.peak_indentation, &mut Memory::default());
        assert!(
            relative_error(impact.row.peak_force, force) < 1e-9,
            "{}: {} {force}",
            method.name(),
            impact.row.peak_force
        );
    }
}

/// The contact of a convex wall that hardens is narrower by the factor 1 + 0.14 D (â/R − 0.4), with D = (R_h − R_s)/(R_h + R_s) and
/// â = 3F/(4E* δ_e) of the law without depth. The wall without its flat is a flat half-space that a sphere of the effective radius hits.
#[test]
fn convex_hardening_wall_narrows_contact_by_share() {
    let keys =
        ["half_space.flow_stress.power.exponent=0.2", "half_space.yield_strength=600 MPa", "half_space.radius=20 mm"];
    let flat = ["half_space.flow_stress.power.exponent=0.2", "half_space.yield_strength=600 MPa", "sphere.radius=4 mm"];
    let law = |keys: &[&str], table: &PlmCoefficients| {
        let input = scene(STEEL, keys);
        let bodies = YieldingPair::new(&Pair::try_new(&input.sphere(), &input.half_space()).unwrap()).unwrap();
        let flow = [None, Some(FlowCurve::Power { exponent: 0.2 })];
        let law = Plm { flow, ..Plm::new(table, UnloadingExponent::Paper) }.law(&bodies).unwrap();
        (law, bodies.yield_radius_ratio())
    };
    let (narrower, ratio) = law(&keys, PlmCoefficients::built_in());
    let (plain, _) = law(&keys, &changed(|table| table.depth.as_mut().unwrap().radius = 0.0));
    let (without_flat, same_ratio) = law(&flat, &changed(|table| table.depth = None));
    assert!(relative_error(same_ratio, ratio) < 1e-14);
    let mut narrowed = 0;
    for i in 1..30 {
        let x = 0.01 * f64::from(i) / (ratio * ratio);
        let [with, without] = [&narrower, &plain].map(|law| law.contact_radius(&law.loaded_state(x)));
        let of_half_space = without_flat.loaded_state(x);
        let hertzian = of_half_space.force / of_half_space.elastic_approach * ratio;
        let want = 1.0 + 0.14 * 0.6 * (hertzian - 0.4).max(0.0);
        assert!(relative_error(without / with, want) < 1e-12, "{i}: {} {want}", without / with);
        narrowed += usize::from(want > 1.005);
    }
    assert!(narrowed > 5, "{narrowed}");
}

#[test]
fn tables_of_200_and_of_close_knots_work() {
    let pair = *Scene::case_3().contact().pair();
    for ratio in [1.02, 1.0 + 1e-12] {
        let table = changed(|table| {
            table.depth = None;
            table.force.from = (0..200).map(|i| 1.7 * f64::powi(ratio, i)).collect();
            // approximately the slopes of f = x^1.2 through (1.7, 2.2)
            table.force.slope = table.force.from.iter().map(|x| 2.0 * (x / 1.7).powf(0.2)).collect();
            table.force.slope_kappa_squared = vec![0.05; 200];
        });
        table.check().unwrap();
        let law = table.law(&pair, pair.yield_point.unwrap().contact_radius / pair.radius, UnloadingExponent::Paper);
        let pieces = law.loading.pieces();
        assert_eq!(pieces.len(), 201);
        for pair in pieces.windows(2) {
            assert!(relative_error(pair[0].force_at(pair[1].start), pair[1].force) < 1e-15);
            assert!(relative_error(pair[0].work_at(pair[1].start), pair[1].work) < 1e-15);
            assert!(pair[0].force < pair[1].force && pair[0].work < pair[1].work);
        }
        let law_restitution: Vec<f64> = [1.5, 1.7, 2.0, 20.0, 80.0].map(|x| restitution(&law, x)).to_vec();
        assert!(law_restitution.windows(2).all(|pair| pair[0] > pair[1]), "{law_restitution:?}");
    }
}
