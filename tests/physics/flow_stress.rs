//! A half-space that hardens, in every kind of scene: traces, indentations, series, gravity and damping, tables.
//!
//! The expected numbers are from 30-digit arithmetic (`oracle_hardening.csv`) and from closed forms.

use std::fs;

use plm_impact::impact::Method;
use plm_impact::impact::closed_form::solve;
use plm_impact::law::Law;
use plm_impact::law::curve::Curve;
use plm_impact::law::piece::{Piece, Shape};
use plm_impact::reference::hardening::{ExactImpact, Materials, impacts};
use plm_impact::run;
use plm_impact::scenario::Scenario;
use plm_impact::scene::{Input, Scene};
use plm_impact::sweep::evaluator::{Evaluator, Failure, Rows};
use proptest::prelude::*;

use crate::common::command::{Desk, column};
use crate::common::{STEEL, off, solver};

/// A scenario of an exact impact, without `[impact]`.
fn scenario(materials: &Materials, impact: &ExactImpact) -> String {
    let words: Vec<&str> = materials.flow.split_whitespace().collect();
    let flow = match words[..] {
        ["power", exponent] => format!("power = {{ exponent = {exponent} }}"),
        ["voce", saturation, rate] => format!("voce = {{ saturation = {saturation}, rate = {rate} }}"),
        ["linear", slope] => format!("linear = {{ slope = {slope} }}"),
        ["table", pairs] => format!("points = [[{}]]", pairs.replace(',', "], [").replace(':', ", ")),
        _ => panic!("{words:?}"),
    };
    let (sphere, half_space) = (materials.sphere(), materials.half_space().material);
    let exponent = match impact.exponent() {
        plm_impact::law::UnloadingExponent::PressureShape => "\"pressure-shape\"",
        _ => "1.5",
    };
    format!(
        "[sphere]\nradius = {}\nyoungs_modulus = {}\npoissons_ratio = {}\ndensity = {}\n[half_space]\nyoungs_modulus = {}\n\
         poissons_ratio = {}\nyield_strength = {}\n[half_space.flow_stress]\n{flow}\n[law.plm]\nunloading_exponent = {exponent}\n",
        impact.radius_m,
        sphere.youngs_modulus,
        sphere.poissons_ratio,
        impact.sphere_density_kg_per_m3,
        half_space.youngs_modulus,
        half_space.poissons_ratio,
        materials.yield_strength,
    )
}

fn read(text: &str) -> Scenario {
    Scenario::from_text("s.toml", text, &[]).unwrap()
}

#[test]
fn a_scenario_and_its_trace_come_to_the_exact_impact() {
    for (materials, want) in impacts().unwrap() {
        let speed = want.impact_speed_m_per_s;
        let text = scenario(&materials, &want) + &format!("[impact]\nspeed = {speed}\n");
        let (_, _, impact) = run::impact::compute(&read(&text), Some(200)).unwrap();
        assert!(off(impact.restitution, want.restitution) < 1e-8, "{}", want.case);
        let rows = &impact.trace;
        let highest = rows.iter().map(|row| row.force).fold(0.0, f64::max);
        let deepest = rows.iter().map(|row| row.indentation).fold(0.0, f64::max);
        assert!(off(highest, want.peak_force) < 1e-8 && off(deepest, want.peak_indentation_m) < 1e-8, "{}", want.case);
        let (first, last) = (&rows[0], rows.last().unwrap());
        assert!(off(last.time, want.contact_time_s) < 1e-8 && off(-last.speed / speed, want.restitution) < 1e-8);
        assert!(first.time == 0.0 && rows.windows(2).all(|pair| pair[0].time < pair[1].time));
        // the indentation of the sphere
        let bodies = [materials.sphere(), materials.half_space().material];
        let [of_sphere, of_both] = [&bodies[..1], &bodies[..]].map(|bodies| {
            bodies.iter().map(|body| (1.0 - body.poissons_ratio.powi(2)) / body.youngs_modulus).sum::<f64>()
        });
        let want_of_sphere = of_sphere / of_both * want.elastic_approach_m;
        let peak = rows.iter().max_by(|a, b| a.indentation.total_cmp(&b.indentation)).unwrap();
        for got in [peak.sphere_indentation, impact.peak_sphere_indentation] {
            // a rigid sphere has no indentation
            assert!((got - want_of_sphere).abs() <= 1e-8 * want_of_sphere, "{}: {got} {want_of_sphere}", want.case);
        }
    }
}

#[test]
fn an_indentation_to_the_same_depth_has_the_same_force_and_dent() {
    for (materials, want) in impacts().unwrap() {
        let steps =
            format!("[indentation]\nsteps = [{{ indentation = {} }}, {{ load = 0 }}]\n", want.peak_indentation_m);
        let (_, tested, _) = run::indentation::compute(&read(&(scenario(&materials, &want) + &steps)), None).unwrap();
        let [loaded, unloaded] = &tested[0].indentation.steps[..] else { panic!("two steps") };
        assert!(off(loaded.force, want.peak_force) < 1e-11, "{}", want.case);
        assert!(off(loaded.memory.contact_radius, want.peak_contact_radius_m) < 1e-11, "{}", want.case);
        let stiffness = want.unloading_exponent * want.peak_force / want.elastic_approach_m;
        assert!(off(loaded.memory.unloading_stiffness, stiffness) < 1e-11, "{}", want.case);
        // the dent of a shallow contact is a small difference
        let lost = want.peak_indentation_m / want.residual_indentation_m;
        assert!(off(unloaded.indentation, want.residual_indentation_m) < 1e-11 * lost, "{}", want.case);
        // the work of loading is the whole energy of the impact
        let mass = 4.0 / 3.0 * std::f64::consts::PI * want.radius_m.powi(3) * want.sphere_density_kg_per_m3;
        let energy = 0.5 * mass * want.impact_speed_m_per_s.powi(2);
        assert!(off(loaded.work, energy) < 1e-11 && off(-unloaded.work, energy * want.restitution.powi(2)) < 1e-10);
    }
}

#[test]
fn a_spot_that_was_hit_remembers_its_hardened_dent() {
    for (materials, want) in impacts().unwrap() {
        let speed = want.impact_speed_m_per_s;
        // the second shot stays elastic; the third has more energy than the unloading gave back
        let speeds = [speed, 0.99 * want.restitution * speed, speed];
        for spot in ["same", "fresh"] {
            let series = format!("[repeat]\nspot = \"{spot}\"\nspeeds = {speeds:?}\n");
            let (scene, contact, repeat) =
                run::repeat::prepare_repeat(&read(&(scenario(&materials, &want) + &series))).unwrap();
            let hits = repeat.run(&contact, &scene.solver, 10, None).unwrap().hits;
            assert!(off(hits[0].restitution, want.restitution) < 1e-11, "{}", want.case);
            if spot == "fresh" {
                assert_eq!(hits[2].restitution, hits[0].restitution);
                continue;
            }
            assert!((hits[1].restitution - 1.0).abs() < 1e-11 && hits[1].dent_growth == 0.0, "{}", want.case);
            assert!(hits[2].restitution > hits[0].restitution && hits[2].dent_growth > 0.0, "{}", want.case);
        }
    }
}

fn steel(tables: &str) -> Scene {
    let flow = "[half_space.flow_stress]\npower = { exponent = 0.15 }\n[impact]";
    read(&(STEEL.replace("[impact]", flow) + tables)).resolve().unwrap()
}

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
        // so soft that the powers of the work would leave double precision at the last pieces
        (STEEL.replace("345 MPa", "1 kPa"), "linear.slope = 1e6"),
    ];
    for (steel, flow) in flows {
        let text = steel.replace("[impact]", &format!("[half_space.flow_stress]\n{flow}\n[impact]"));
        let contact = read(&text).resolve().unwrap().contact().unwrap();
        for k in 0..200 {
            let speed = 0.02 * 1.05_f64.powi(k);
            let (_, law, q) = contact.scaled(speed).unwrap();
            let straight = |curve: Curve, piece: &Piece| match piece.shape {
                Shape::Straight { slope, .. } => curve.then_straight_from(piece.start, piece.force, slope),
                _ => panic!("{piece:?}"),
            };
            let loading = law.loading.pieces()[1..].iter().fold(Curve::hertz(), straight);
            let (by_series, by_pieces) = (solve(law, q), solve(&Law { loading, ..law.clone() }, q));
            assert!(off(by_series.loading_time, by_pieces.loading_time) < 2e-15, "{flow} {speed}");
            assert_eq!(by_series.restitution, by_pieces.restitution, "{flow} {speed}");
        }
    }
}

/// Damping after Hunt and Crossley has a closed form for any law: with G(v) = v/χ − ln(1 + χ v)/χ², m G(v_0) is the
/// work of loading, and m G(−e v_0) is the work that the unloading branch gives back.
#[test]
fn damping_acts_on_a_hardened_contact_as_its_phase_curve_says() {
    let (chi, speed) = (0.1_f64, 3.0_f64);
    let scene = steel(&format!("[damping]\nhunt_crossley = {chi}\n"));
    let contact = scene.contact().unwrap();
    let (scales, law, _) = contact.scaled(speed).unwrap();
    let g = |v: f64| v / chi - (1.0 + chi * v).ln() / (chi * chi);
    for (method, tolerance, allowed) in [(Method::ClosedForm, 1e-10, 1e-11), (Method::Rk8, 1e-11, 1e-9)] {
        let impact = contact.impact(speed, &solver(method, tolerance), None).unwrap();
        let peak = law.loaded_to(impact.peak_indentation / scales.length);
        let energy = scales.force * scales.length;
        assert!(off(energy * law.loading.work(peak.indentation), contact.mass() * g(speed)) < allowed);
        let recovered = energy * law.unloading(peak).capacity();
        assert!(off(recovered, contact.mass() * g(-impact.restitution * speed)) < 10.0 * allowed);
    }
    // viscous damping has no closed form: two methods agree, and fixed steps converge to them
    let damped = steel("[damping]\nviscous = 0.05\n[gravity]\nacceleration = 9.81\n").contact().unwrap();
    let by = |method, tolerance| damped.impact(speed, &solver(method, tolerance), None).unwrap();
    let (one, other) = (by(Method::Rk8, 1e-11), by(Method::Dop853, 1e-11));
    assert!(off(one.restitution, other.restitution) < 1e-8 && one.energy.drift < 1e-9);
    let fixed = plm_impact::impact::Solver { steps_per_contact: 4000, ..solver(Method::Verlet, 1e-10) };
    assert!(off(damped.impact(speed, &fixed, None).unwrap().restitution, one.restitution) < 1e-4);
}

fn rows(text: &str) -> Rows {
    let plan = read(text).plan().unwrap().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).rows(0..plan.count(), &mut rows);
    rows
}

/// Rows of a table, by closed form and by steps, equal single impacts to the last bit.
#[test]
fn tables_on_a_hardened_half_space_are_single_impacts() {
    let flow = STEEL.replace("[impact]", "[half_space.flow_stress]\npower = { exponent = 0.15 }\n[impact]");
    let exponents = [0.05, 0.3];
    let speeds = [0.005, 0.02, 0.3, 2.0, 11.0];
    let axes =
        format!("[sweep]\n\"half_space.flow_stress.power.exponent\" = {exponents:?}\n\"impact.speed\" = {speeds:?}\n");
    for tables in ["", "[solver]\nmethod = \"rk8\"\n", "[damping]\nviscous = 0.05\n"] {
        let table = rows(&format!("{flow}{tables}{axes}")).results;
        assert_eq!(table.len(), 10);
        for (case, row) in table.iter().enumerate() {
            let mut input = Input::of(&steel(tables));
            let exponent = plm_impact::scene::Key::find("half_space.flow_stress.power.exponent").unwrap();
            exponent.put(&mut input, exponents[case / 5]);
            let scene = input.resolve();
            let method = if tables.is_empty() { Method::Auto } else { Method::Rk8 };
            let alone = scene.contact().unwrap().essentials_by(speeds[case % 5], &solver(method, 1e-10)).unwrap();
            assert_eq!(row.unwrap(), alone, "{tables} {case}");
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
        (&hardness, "[sweep]\n\"half_space.youngs_modulus\" = [1e11, 2e11]\n", false),
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
        if !varies || tables.contains("exponent") || tables.contains("modulus") {
            continue;
        }
        for (strength, e) in column(&table, name).iter().zip(column(&table, "restitution")) {
            let alone = STEEL.replace("\"345 MPa\"", strength);
            let scene = read(&alone).resolve().unwrap();
            let impact = scene.contact().unwrap().closed_form(scene.speed).unwrap();
            assert!(off(e.parse().unwrap(), impact.restitution) < 1e-14, "{strength}");
        }
        if tables.contains("40.8") {
            // the strength is 9.80665 HV/0.9272/2.9 MPa; HRC 40.8 is HV 400
            for (strength, vickers) in column(&table, name).iter().zip([200.0, 400.0]) {
                assert!(off(strength.parse().unwrap(), 9.806_65e6 * vickers / 0.9272 / 2.9) < 1e-14);
            }
        }
    }
}

/// `check` explains which strength the law needs, only if a yield strength of a metal is given and the contact is deep.
/// A run prints no such hint.
#[test]
fn check_teaches_which_strength_is_meant() {
    let desk = Desk::with(STEEL);
    let flow = "half_space.flow_stress.power.exponent=0";
    let table = "sweep={\"impact.speed\"=[\"3 m/s\",\"1 cm/s\"]}";
    let indentation = STEEL.replace("[impact]\nspeed = \"3 m/s\"", "[indentation]\nsteps = [{ load = \"1 kN\" }]");
    fs::write(desk.path("i.toml"), &indentation).unwrap();
    fs::write(desk.path("h.toml"), STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"300 HV\"")).unwrap();
    for (file, set, is_said) in [
        ("s.toml", None, true),
        ("s.toml", Some(table), true),
        ("s.toml", Some("repeat={spot=\"same\",impacts=2}"), true),
        ("i.toml", None, true),
        // a shallow contact, not a metal, a flow curve, a law without yield
        ("s.toml", Some("impact.speed=1 cm/s"), false),
        ("s.toml", Some("half_space.youngs_modulus=3 GPa"), false),
        ("s.toml", Some(flow), false),
        ("i.toml", Some(flow), false),
        ("h.toml", None, false),
        ("s.toml", Some("law=hertz"), false),
    ] {
        let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
        let repeat = if set.iter().any(|set| set.starts_with("repeat")) {
            vec!["--set", "gravity.acceleration=9.81"]
        } else {
            vec![]
        };
        let (printed, _) = desk.ends(&[&["check", file], &set[..], &repeat[..]].concat(), 0);
        assert_eq!(printed.contains("Which strength?"), is_said, "{file} {set:?}: {printed}");
        let (printed, said) = desk
            .ends(&[&["run", file, "--out", "o", "--force", "--pictures", "none"], &set[..], &repeat[..]].concat(), 0);
        let hints =
            |line: &str| line.contains("strength") && !line.ends_with("hardly any solid reaches: check the units");
        assert!(!printed.contains("Which strength?") && !said.lines().any(hints), "{file} {set:?}: {said}");
    }
}

/// A curve steeper than Young's modulus is refused by `check`, a run and a table in the same words. Where an axis makes it so, the
/// rows say that they are outside of the law.
#[test]
fn a_curve_that_no_metal_has_is_refused_everywhere() {
    let flow = "[half_space.flow_stress]\nvoce = { saturation = 23, rate = 2300 }\n[impact]";
    let desk = Desk::with(STEEL.replace("[impact]", flow));
    let table = ["--set", "sweep={\"impact.speed\"=[1,2]}"];
    for arguments in
        [&["check", "s.toml"][..], &["run", "s.toml", "--out", "o"], &[&["run", "s.toml"], &table[..]].concat()]
    {
        let (_, message) = desk.ends(arguments, 2);
        for part in ["s.toml:", "flow_stress", "between plastic strain 0 and", "Young's modulus", "give a smaller rise"]
        {
            assert!(message.contains(part), "{part}: {message}");
        }
        assert_eq!(desk.files(""), ["s.toml"]);
    }
    let axis = "[sweep]\n\"half_space.flow_stress.voce.saturation\" = [0.1, 1, 23]\n";
    let got = rows(&(STEEL.replace("[impact]", &flow.replace("saturation = 23, ", "")) + axis));
    let is_outside: Vec<bool> = got.results.iter().map(|row| *row == Err(Failure::OutsideLaw)).collect();
    assert_eq!(is_outside, [false, true, true]);
}

#[test]
fn scenes_without_an_impact_refuse_what_does_not_fit() {
    let indentation = STEEL.replace("[impact]\nspeed = \"3 m/s\"", "[indentation]\nsteps = [{ load = \"1 kN\" }]");
    let compare = STEEL.replace("[impact]\nspeed = \"3 m/s\"", "[compare]\npeak_indentation_ratio = 30");
    let flow = "[half_space.flow_stress]\n";
    for (text, want) in [
        (format!("{indentation}{flow}points = [[0.01, 3e8], [0.02, 4e8]]\n"), "below the yield strength"),
        (format!("{indentation}{flow}power = {{ exponent = 0.1 }}\n[law.thornton]\n"), "thornton has no hardening"),
    ] {
        let message = read(&text).indentation().unwrap_err().to_string();
        assert!(message.contains("s.toml:") && message.contains(want), "{message}");
    }
    let message = read(&format!("{compare}{flow}power = {{ exponent = 0.1 }}\n")).comparison().unwrap_err().to_string();
    assert!(message.contains("half_space.flow_stress") && message.contains("have no hardening"), "{message}");
    // a hardness gives the strength there too
    let hardness = |text: &str| text.replace("yield_strength = \"345 MPa\"", "hardness = \"1.0005 GPa\"");
    assert!(off(read(&hardness(&compare)).comparison().unwrap().bodies.yield_strength, 345e6) < 1e-14);
    let specimens = read(&hardness(&indentation)).indentation().unwrap().specimens;
    assert!(off(specimens[0].half_space.yield_strength.unwrap(), 345e6) < 1e-14);
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    /// For any flow curve and any forces the energy ledger closes, e is at most 1, and a warning is given beyond the
    /// curve.
    #[test]
    fn energy_is_kept_on_any_flow_curve(
        speed in 0.01..20.0_f64, first in 1.0..1.5_f64, second in 1.0..2.0_f64, strain in 1e-3..0.05_f64, zeta in 0.0..0.2_f64,
    ) {
        let points = format!("points = [[{strain}, {}], [{}, {}]]", 345e6 * first, 3.0 * strain, 345e6 * first * second);
        let text = STEEL.replace("[impact]", &format!("[half_space.flow_stress]\n{points}\n[damping]\nviscous = {zeta}\n[impact]"));
        let scene = read(&text.replace("3 m/s", &format!("{speed} m/s"))).resolve().unwrap();
        let contact = scene.contact().unwrap();
        let impact = contact.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        prop_assert!(impact.energy.drift < 1e-8, "{}", impact.energy.drift);
        prop_assert!(impact.restitution > 0.0 && impact.restitution <= 1.0 + 1e-9);
        // the curve is used up to a strain of 0.37 (√(δ/R) − √(δ_Y/R))
        let at = |indentation: f64| (indentation / 5e-3).sqrt();
        let asked = 0.37 * (at(impact.peak_indentation) - at(contact.pair().yield_point.unwrap().indentation));
        let is_beyond = impact.warnings.iter().any(|warning| warning.to_string().contains("the flow curve ends"));
        prop_assert_eq!(is_beyond, asked > 3.0 * strain, "{} {}", asked, 3.0 * strain);
    }
}
