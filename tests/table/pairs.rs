//! Every pair of numeric keys as the axes of a table, with two values each: a row has the bits of the single run with its values,
//! and the summary lists no value as shared that one of the runs does not have. The keys come from the registry: a new key fails
//! here until a scene below gives it.

use std::collections::BTreeSet;

use plm_impact::report::text::inputs::Inputs;
use plm_impact::scenario::input::NUMERIC_KEYS;
use plm_impact::units::Dimension;

use crate::common::prelude::*;
use crate::row_equals_impact::{assert_same, single_of};

const FALL: &str = "impact={drop_height=10}";
const AIR: &str = "air={density=1.2,drag=0.5}";
const SMALL: &str = "sphere.radius=5e-4";
/// A sphere that yields on a half-space that does not.
const SOFT_SPHERE: [&str; 2] = ["half_space.yield_strength=none", "sphere.yield_strength=3e8"];

/// Scenes that together give all numeric keys.
const SCENES: [&[&str]; 32] = [
    &[FALL, AIR, SMALL, "half_space.radius=0.02", "half_space.density=7850"],
    &[
        FALL,
        "air={density=1.2,drag=\"sphere\",viscosity=1.8e-5}",
        "gravity.acceleration=9.81",
        "sphere={diameter=1e-3,youngs_modulus=2e11,poissons_ratio=0.3,mass=4e-6,hardness=\"200 HV\"}",
        "half_space={youngs_modulus=2.1e11,poissons_ratio=0.3,hardness=\"120 HV\"}",
    ],
    &[FALL, SMALL, "impact.angle=0.4 rad", "friction.coefficient=0.1", "sphere.spin=20", "solver.method=rk8"],
    &[FALL, AIR, "half_space.thickness=4e-3", "half_space.edge_distance=0.02", "half_space.density=7850"],
    &[FALL, AIR, "half_space.rod_diameter=8e-3", "half_space.rod_length=2", "half_space.density=7850"],
    &[FALL, AIR, SMALL, "damping.viscous=0.1", "solver.method=rk8", "solver.tolerance=1e-9"],
    &[FALL, AIR, SMALL, "damping.hunt_crossley=0.1", "gravity.acceleration=9.81"],
    &["half_space.mass=0.01", "sphere.density=8000"],
    &["impact.angle=0.4 rad", "friction.coefficient=0.1", "sphere.spin=10", "sphere.moment_of_inertia=4e-8"],
    &[
        "impact.angle=0.4 rad",
        "friction.coefficient=0.1",
        "sphere={radius=5e-3,youngs_modulus=2e11,poissons_ratio=0.3,density=7850,spin=10,spin_about_path=20,spin_about_normal=30}",
    ],
    &["peening={coverage=0.9,mass_flow=0.1,area=0.01,time=10}"],
    &["half_space.flow_stress.power.exponent=0.1", "law.plm.unloading_exponent=1.6"],
    &["half_space.flow_stress.voce={saturation=2.0,rate=20.0}"],
    &["half_space.flow_stress.linear.slope=1e9", FALL, AIR, SMALL],
    &[SOFT_SPHERE[0], SOFT_SPHERE[1], "sphere.flow_stress.power.exponent=0.1"],
    &[SOFT_SPHERE[0], SOFT_SPHERE[1], "sphere.flow_stress.voce={saturation=2.0,rate=20.0}"],
    &[SOFT_SPHERE[0], SOFT_SPHERE[1], "sphere.flow_stress.linear.slope=1e9"],
    &["half_space.rate={johnson_cook={c=0.014,reference=2.0},tested_at=1e-2}", FALL, AIR, SMALL],
    &["half_space.rate={cowper_symonds={rate=6844.0,exponent=3.91}}"],
    &[SOFT_SPHERE[0], SOFT_SPHERE[1], "sphere.rate={johnson_cook={c=0.014,reference=2.0},tested_at=1e-2}"],
    &[SOFT_SPHERE[0], SOFT_SPHERE[1], "sphere.rate={cowper_symonds={rate=6844.0,exponent=3.91}}"],
    &["law={thornton={yield_pressure=6e8}}", FALL, AIR, SMALL],
    &["law={stronge={yield_pressure_ratio=1.2,unloading_factor=1.1}}"],
    &["law={jackson_green={yield_factor=1.6}}"],
    &["law={kogut_etsion={yield_factor=1.6}}"],
    &["law={yigit_christoforou={yield_factor=1.6}}"],
    &["law={ma_liu={hardness_ratio=2.8,transition_ratio=110.0}}"],
    &["law={mesarovic_johnson={area_factor=1.4}}"],
    &["damping.viscoelastic_time=1e-6"],
    &["adhesion.work=0.05"],
    &["law={walton_braun={loading_stiffness=1.1,stiffness_ratio=0.5}}"],
    &["law={johnson={dynamic_pressure=1e9}}"],
];

/// A value as a scenario gives it.
fn in_file(key: NumericKey, value: f64) -> String {
    if key.quantity().dimension == Dimension::Angle { format!("\"{value:?} rad\"") } else { format!("{value:?}") }
}

/// Compares the rows of this pair of keys with single runs; false for a pair that a table refuses.
fn compare(set: &[String], keys: [NumericKey; 2], values: [[f64; 2]; 2]) -> bool {
    let of_key = |key: NumericKey, value: f64| format!("{}={}", key.path(), in_file(key, value));
    let single = |of: [usize; 2]| {
        let own = [0, 1].map(|i| of_key(keys[i], values[i][of[i]]));
        scene(STEEL, &[set, &own].concat())
    };
    // the same four runs for both orders, by the place of the value of the first key, and of the second
    let mut singles = [[None, None], [None, None]];
    for order in [[0, 1], [1, 0]] {
        let axis =
            |i: usize| format!("\"{}\"=[{}]", keys[i].path(), values[i].map(|value| in_file(keys[i], value)).join(","));
        let sweep = format!("sweep={{{}}}", order.map(axis).join(","));
        let all = [set, &[sweep]].concat();
        let Ok(plan) = Scenario::from_text("s.toml", STEEL, &Override::list(&all)).and_then(|scenario| scenario.plan())
        else {
            return false;
        };
        let evaluator = Evaluator::new(&plan);
        let (mut rows, mut listed) = (Rows::default(), Rows::default());
        evaluator.append_rows(0..4, &mut rows);
        let cases = [0, 1].map(|outer| [0, 1].map(|inner| [outer, inner])).concat();
        let columns = [0, 1].map(|at| cases.iter().map(|case| values[order[at]][case[at]]).collect::<Vec<_>>());
        let list = [0, 1].map(|at| (keys[order[at]], columns[at].as_slice()));
        Evaluator::with_contact(&plan, None).append_rows_with_values(&list, 0..4, &mut listed);
        let shared = Inputs::from_plan(&plan);
        for (case, of) in cases.iter().enumerate() {
            let mut places = [0; 2];
            (places[order[0]], places[order[1]]) = (of[0], of[1]);
            let [first, second] = places;
            let (single, own) = singles[first][second].get_or_insert_with(|| {
                let input = single(places);
                (single_of(&input, &rows.results[case]), Inputs::new(&input))
            });
            let what = format!("{set:?} {sweep:?}, case {case}", sweep = &all[set.len()]);
            assert_same(&rows.results[case], single, &what);
            assert_same(&listed.results[case], single, &what);
            for entry in &shared.0 {
                let has = own.0.iter().any(|one| one.path == entry.path && one.value == entry.value);
                assert!(has, "{what}: {} is not shared", entry.path);
            }
        }
    }
    true
}

#[test]
fn row_of_any_two_keys_matches_run() {
    let (mut covered, mut idle, mut pairs) = (BTreeSet::new(), BTreeSet::new(), 0);
    for scene_keys in SCENES {
        let mut set: Vec<String> = scene_keys.iter().map(ToString::to_string).collect();
        if !set.iter().any(|key| key.starts_with("solver.method")) {
            // a table takes the closed form where there is one
            set.push("solver.method=auto".to_owned());
        }
        let input = scene(STEEL, &set);
        let given = |key: &NumericKey| input.number(*key).filter(|value| value.is_finite() && *value != 0.0);
        let given: Vec<(NumericKey, f64)> = NUMERIC_KEYS.iter().filter_map(|key| Some((*key, given(key)?))).collect();
        for (i, (one, first)) in given.iter().enumerate() {
            let alone =
                [set.clone(), vec![format!("sweep={{\"{}\"=[{}]}}", one.path(), in_file(*one, *first))]].concat();
            if Scenario::from_text("s.toml", STEEL, &Override::list(&alone))
                .and_then(|scenario| scenario.plan())
                .is_err()
            {
                idle.insert(one.path());
            }
            for (other, second) in &given[i + 1..] {
                if compare(&set, [*one, *other], [[*first, 0.9 * first], [*second, 0.9 * second]]) {
                    covered.extend([one.path(), other.path()]);
                    pairs += 1;
                }
            }
        }
    }
    // a key that changes no row is refused as an axis: only a warning depends on it
    let is_missing = |path: &&str| !covered.contains(path) && !idle.contains(path);
    let missing: Vec<&str> = NUMERIC_KEYS.iter().map(|key| key.path()).filter(is_missing).collect();
    assert_eq!(
        idle.difference(&covered).copied().collect::<Vec<_>>(),
        ["half_space.edge_distance", "half_space.rod_length"]
    );
    assert!(missing.is_empty(), "no scene above lets these keys vary with another: {missing:?}");
    assert!(pairs > 1000, "{pairs}");
}
