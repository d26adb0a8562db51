//! A row of a table has the bits of the single case with the same values: for all laws, methods, forces and kinds of
//! axes; but for friction with partial slip, which a row computes to 1e-5.

use plm_impact::scenario::keys::restitution_interval;
use plm_impact::scenario::plan::axis_indices;

use crate::common::prelude::*;

/// Settings of a scenario, and axes: a key and its values, as they stand in a file.
type Table = (&'static [&'static str], &'static [(&'static str, &'static [&'static str])]);

const TABLES: [Table; 13] = [
    (&[], &[METHODS, SPEEDS]),
    (&["gravity.acceleration=9.81", "half_space.density=7850"], &[STEPPED, SPEEDS]),
    (&["damping.viscous=0.1"], &[STEPPED, SPEEDS]),
    // a sphere that is let go, and one that hardly moves; a damping of nothing
    (&[], &[HEIGHTS, ("damping.viscous", &["0", "0.1"]), ("gravity.acceleration", &["9.81", "1e5"])]),
    (&["solver.method=rk8"], &[HEIGHTS, ("gravity.acceleration", &["9.81", "1e5"])]),
    (
        &[],
        &[
            ("friction.coefficient", &["0.1", "0.3"]),
            ("impact.angle", &["\"0 deg\"", "\"10 deg\"", "\"60 deg\""]),
            ("sphere.spin", &["-50", "0"]),
            ("sphere.spin_about_path", &["0", "70"]),
        ],
    ),
    (&[FLOW], &[("half_space.flow_stress.power.exponent", &["0.05", "0.3"]), SPEEDS]),
    (&[FLOW, "solver.method=rk8"], &[("half_space.flow_stress.power.exponent", &["0.05", "0.3"]), SPEEDS]),
    (&[FLOW, "damping.viscous=0.05"], &[("half_space.flow_stress.power.exponent", &["0.05", "0.3"]), SPEEDS]),
    (&[], &[("half_space.yield_strength", &["200e6", "345e6", "900e6"]), ("sphere.radius", &["1e-3", "2e-3"]), SPEEDS]),
    (
        &["gravity.acceleration=9.81"],
        &[("half_space.hardness", &["\"100 HV\"", "\"300 HV\""]), ("impact.speed", &["0.5", "1.0"])],
    ),
    (&["half_space.density=7850"], &[("half_space.thickness", &["2e-3", "5e-3"]), ("impact.speed", &["0.5", "1.0"])]),
    (
        &["half_space.density=7850"],
        &[("half_space.rod_diameter", &["8e-3", "2e-2"]), ("impact.speed", &["0.5", "1.0"])],
    ),
];

/// A run of one impact has a trace, and so no closed form under forces; a table has none.
const STEPPED: (&str, &[&str]) = ("solver.method", &["\"auto\"", "\"rk8\"", "\"dopri5\"", "\"dop853\"", "\"verlet\""]);
const METHODS: (&str, &[&str]) = (STEPPED.0, &["\"closed_form\"", "\"auto\"", "\"rk8\"", "\"verlet\""]);
/// Elastic, just beyond first yield, and far beyond it.
const SPEEDS: (&str, &[&str]) = ("impact.speed", &["5e-3", "9.8e-3", "0.3", "3", "11"]);
const HEIGHTS: (&str, &[&str]) = ("impact.drop_height", &["0", "1e-9", "0.5"]);
const FLOW: &str = "half_space.flow_stress.power.exponent=0.1";

/// The steel scenario without what the axes give in another way.
fn bodies(axes: &[(&str, &[&str])]) -> String {
    let has = |name: &str| axes.iter().any(|(key, _)| *key == name);
    let steel = if has("impact.drop_height") { STEEL.replace("speed = \"3 m/s\"\n", "") } else { STEEL.to_owned() };
    if has("half_space.hardness") { steel.replace("yield_strength = \"345 MPa\"\n", "") } else { steel }
}

/// Asserts that a row has the bits of a single run. With partial slip a row is within 1e-5 and a single run within 1e-7.
pub fn assert_same(row: &Result<ImpactRow, RowFailure>, single: &Result<ImpactRow, RowFailure>, what: &str) {
    let slips = |of: &Result<ImpactRow, RowFailure>| {
        let rebound = of.as_ref().ok().and_then(|of| of.rebound)?;
        (!rebound.is_sliding && rebound.psi != 0.0).then_some(rebound.contact_point_restitution)
    };
    let (mut row, mut single) = (*row, *single);
    if let (Some(of_row), Some(of_single)) = (slips(&row), slips(&single)) {
        assert!((of_row - of_single).abs() <= 1e-5, "{what}: {of_row} {of_single}");
        for of in [&mut row, &mut single].into_iter().flatten() {
            of.rebound = None;
        }
    }
    // as text, because some numbers are NaN where nothing slips
    assert_eq!(format!("{row:?}"), format!("{single:?}"), "{what}");
}

/// The results of the single run that a row is compared with. If the row has the interval of e, the single run has its own.
pub fn single_of(input: &Input, row: &Result<ImpactRow, RowFailure>) -> Result<ImpactRow, RowFailure> {
    let contact = input.contact().map_err(RowFailure::from)?;
    let mut single = contact.impact(input.approach(), &input.solver(), None).map_err(RowFailure::from)?.row;
    if let Ok(ImpactRow { restitution_interval: Some(_), .. }) = row {
        let interval = restitution_interval(input, &contact, input.speed(), &single);
        single.restitution_interval = interval.map(|interval| [interval.low, interval.high]);
    }
    Ok(single)
}

/// Compares every row with its single case, and returns how many have numbers.
fn compare(settings: &[&str], axes: &[(&str, &[&str])]) -> usize {
    let text = bodies(axes);
    let list = |(key, values): &(&str, &[&str])| format!("\"{key}\" = [{}]", values.join(", "));
    let sweep = format!("sweep={{ {} }}", axes.iter().map(list).collect::<Vec<_>>().join(", "));
    let rows = rows_of(&text, &[settings, &[&sweep]].concat()).results;
    assert_eq!(rows.len(), axes.iter().map(|(_, values)| values.len()).product::<usize>());
    for (case, row) in rows.iter().enumerate() {
        let mut rest = case;
        // without a method a table has the closed form where there is one
        let mut set = vec!["solver.method=auto".to_owned()];
        set.extend(settings.iter().map(ToString::to_string));
        for (key, values) in axes.iter().rev() {
            set.push(format!("{key}={}", values[rest % values.len()]));
            rest /= values.len();
        }
        assert_same(row, &single_of(&scene(&text, &set), row), &format!("{set:?}"));
    }
    rows.iter().filter(|row| row.is_ok()).count()
}

#[test]
fn rows_equal_single_impacts() {
    let given: Vec<usize> = TABLES.iter().map(|(settings, axes)| compare(settings, axes)).collect();
    // under 1e5 m/s^2 the highest drop is deeper than the sphere, with little damping too
    assert_eq!(given, [20, 25, 25, 10, 5, 24, 10, 10, 10, 30, 4, 4, 4]);
}

#[test]
fn law_and_material_rows_equal_single_impacts() {
    let whole =
        plm_impact::contact::law::LawChoice::all().into_iter().filter(plm_impact::contact::law::LawChoice::has_loading);
    let laws: Vec<String> = whole.map(|law| law.name()).chain(["jackson_green + brake".to_owned()]).collect();
    let laws: Vec<String> = laws.iter().map(|name| format!("{name:?}")).collect();
    let laws: Vec<&str> = laws.iter().map(String::as_str).collect();
    let given = compare(&[], &[("law", &laws), ("impact.speed", &["1e-3", "0.03", "1", "10"])]);
    // some laws have no answer at some speeds
    assert!(given > 3 * laws.len() && given < 4 * laws.len(), "{given} of 4 x {}", laws.len());
    let exponents: &[&str] = &["1.4", "1.5", "1.7"];
    assert_eq!(compare(&[], &[("law.plm.unloading_exponent", exponents), SPEEDS]), 15);
    let metals: &[&str] = &["\"steel-304-annealed\"", "\"aluminium-6061-t6\""];
    let text = STEEL.split("youngs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\nyield").next().unwrap();
    let sweep = format!("sweep={{ \"half_space.material\" = [{}] }}", metals.join(", "));
    for (row, metal) in rows_of(text, &[&sweep, "impact.speed=3"]).results.iter().zip(metals) {
        let single = scene(text, &[format!("half_space.material={metal}"), "impact.speed=3".to_owned()]);
        let want = single.contact().unwrap().row(3.0, &Solver::AUTO).unwrap();
        // the interval is that of `plm-impact run`
        let interval = restitution_interval(&single, &single.contact().unwrap(), 3.0, &want).unwrap();
        assert_eq!(
            row.unwrap(),
            ImpactRow { restitution_interval: Some([interval.low, interval.high]), ..want },
            "{metal}"
        );
    }
}

/// A row has the interval of e where more is known of the strength than its number.
#[test]
fn interval_of_e_adds_two_columns() {
    let bodies = STEEL.split("youngs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\nyield").next().unwrap();
    let metal = "half_space.material=\"aluminium-6061-t6\"";
    let sizes = "sweep={\"sphere.radius\"=[\"1 mm\",\"2 mm\"]}";
    let has_interval = |text: &str, set: &[&str]| {
        let names = read(text, &[set, &["impact.speed=2"]].concat()).plan().unwrap().column_names();
        let has = |name: &str| names.iter().any(|column| column == name);
        assert_eq!(has("restitution_interval_low"), has("restitution_interval_high"));
        has("restitution_interval_low")
    };
    assert!(has_interval(bodies, &[metal, sizes]));
    assert!(!has_interval(STEEL, &[sizes]), "a strength without a material has no range");
    // hardening and strain rate of a hardness stay open
    assert!(has_interval(bodies, &[metal, "half_space.hardness=\"100 HV\"", sizes]));
    assert!(has_interval(bodies, &[metal, "sweep={\"half_space.hardness\"=[\"90 HV\",\"100 HV\"]}"]));
    assert!(has_interval(STEEL, &["half_space.strength_kind=\"proof\"", sizes]));
    assert!(!has_interval(bodies, &[metal, "law=\"thornton\"", sizes]), "the error of this law is not stated");
    let exponents = "sweep={\"law.plm.unloading_exponent\"=[1.5,1.6]}";
    assert!(!has_interval(bodies, &[metal, exponents]), "the error of such an exponent is not stated");
}

/// Cases as Python gives them, with a list of values for each key.
#[test]
fn listed_cases_have_the_results_of_a_grid() {
    for (settings, axes) in [TABLES[0], TABLES[2], TABLES[8], TABLES[9]] {
        let axes: Vec<_> = axes.iter().filter(|(key, _)| *key != "solver.method").collect();
        let lists: Vec<String> = axes.iter().map(|(key, values)| format!("\"{key}\"=[{}]", values.join(","))).collect();
        let own: Vec<_> = axes.iter().map(|axis| **axis).collect();
        let (text, sweep) = (bodies(&own), format!("sweep={{{}}}", lists.join(",")));
        let plan = read(&text, &[settings, &[&*sweep]].concat()).plan().unwrap();
        let Cases::Grid(axes) = &plan.cases else { panic!("{text}") };
        let (evaluator, count) = (Evaluator::new(&plan), plan.n_cases());
        let (mut grid, mut listed) = (Rows::default(), Rows::default());
        evaluator.append_rows(0..count, &mut grid);
        let values = |k: usize| (0..count).map(|case| axes[k].value_at(axis_indices(axes, case)[k])).collect();
        let values: Vec<Vec<f64>> = (0..axes.len()).map(values).collect();
        let keys = axes.iter().map(|axis| NumericKey::find(axis.path()).unwrap());
        let keys: Vec<(NumericKey, &[f64])> = keys.zip(values.iter().map(Vec::as_slice)).collect();
        let count = usize::try_from(count).unwrap();
        evaluator.append_rows_with_values(&keys, 0..1, &mut listed);
        evaluator.append_rows_with_values(&keys, 1..count, &mut listed);
        assert_eq!(listed.results, grid.results, "{text}");
        assert!(listed.results.iter().all(Result::is_ok), "{text}");
    }
}
