//! The registry of keys: its schema and its reference page agree with what the program reads.

use plm_impact::scenario::schema::schema;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use plm_impact::impact::indentation::SetPoint;
use plm_impact::results::TABLES;
use plm_impact::results::impact::impact_results;
use plm_impact::scenario::input::NUMERIC_KEYS;
use plm_impact::scenario::keys::key_spec::{Part, ValueForm};
use plm_impact::scenario::{Facts, ScenarioSource};

use crate::common::golden::assert_golden;
use crate::common::prelude::*;

mod pages;
use pages::renewed;

#[test]
fn the_command_prints_the_schema() {
    let output = Sandbox::with("").run(&["schema"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(serde_json::from_str::<Value>(&text(&output.stdout)).unwrap(), schema());
}

#[test]
fn reference_pages_have_tables_of_program() {
    let mut tables = 0;
    for name in ["keys.md", "results.md", "units.md", "README.md"] {
        let path = format!("{}/scenarios/{name}", env!("CARGO_MANIFEST_DIR"));
        let page = std::fs::read_to_string(&path).unwrap();
        let (fresh, count) = renewed(&page);
        tables += count;
        assert_golden(Path::new(&path), fresh);
    }
    assert_eq!(tables, 5);
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/keys.md")).unwrap();
    for path in ALL_KEYS.iter().map(|key| key.path) {
        let name = path.rsplit('.').next().unwrap();
        assert!(page.contains(&format!("`{name}`")) || page.contains(&format!("`[{path}]`")), "{path}");
    }
}

/// The types of the Python module have every result of an impact, so that a wrong name is found before the program runs.
#[test]
fn the_stub_of_an_impact_has_its_results() {
    const MARKS: [&str; 2] = ["    # results: written by a test\n", "    # end of results\n"];
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/interfaces/python/plm_impact/_core.pyi");
    let stub = std::fs::read_to_string(&path).unwrap();
    let of_impacts = impact_results().into_iter().filter(|result| result.condition != TABLES);
    let names = of_impacts.flat_map(|result| [result.name.split('.').next().unwrap(), result.name]);
    let names: BTreeSet<&str> = names.filter(|name| !name.contains('.')).collect();
    let known = ["restitution", "warnings"];
    let lines = names.iter().filter(|name| !known.contains(name)).map(|name| format!("    {name}: Final[Any]\n"));
    let lines = lines.collect::<Vec<_>>().concat();
    let (before, rest) = stub.split_once(MARKS[0]).unwrap();
    let (_, after) = rest.split_once(MARKS[1]).unwrap();
    assert!(names.contains("peak_force_N") && names.contains("energy"), "{names:?}");
    assert!(
        impact_results().iter().any(|result| result.name == "plastic_fraction") && !names.contains("plastic_fraction")
    );
    assert_golden(&path, format!("{before}{}{lines}{}{after}", MARKS[0], MARKS[1]));
}

/// Every key names the part of the scene that it changes. A table computes that part anew when the key varies, so none may be
/// missing.
#[test]
fn key_without_effect_on_contact_says_so() {
    let text = format!("{STEEL}[friction]\ncoefficient = 0.1\n[gravity]\nacceleration = 9.81\n");
    let scene = Scenario::from_text("s.toml", &text, &[]).unwrap().resolve().unwrap();
    let contact = |input: &Input| format!("{:?}", input.contact());
    let (own, law) = (contact(&scene), scene.law());
    let mut kept = 0;
    for key in NUMERIC_KEYS.iter() {
        let (low, high) = key.quantity().range();
        let mut changed = scene.clone();
        key.set_exclusive(
            &mut changed,
            if high.is_finite() { 0.3 * low.max(0.0) + 0.7 * high } else { low.max(0.0) + 1.0 },
        );
        assert!(key.part().changes_contact() || contact(&changed) == own, "{}", key.path());
        assert!(key.part().changes_law() || changed.law() == law, "{}", key.path());
        kept += u32::from(!key.part().changes_contact());
    }
    assert!(kept >= 6, "{kept}");
}

#[test]
fn every_named_file_enters_the_hash() {
    let mut hashes = BTreeSet::from([ScenarioSource::default().sha256()]);
    let named: Vec<&str> =
        ALL_KEYS.iter().filter(|key| matches!(key.form, ValueForm::File(_))).map(|key| key.path).collect();
    for path in &named {
        let files = BTreeMap::from([((*path).to_owned(), "x".to_owned())]);
        hashes.insert(ScenarioSource { files, ..ScenarioSource::default() }.sha256());
    }
    assert_eq!(hashes.len(), named.len() + 1);
}

/// Computes what this purpose needs of an input, and writes it as text with all digits.
fn computed(input: &Input, of: Kind) -> String {
    if of == Kind::Indentation {
        let law = input.law();
        let (sphere, half_space) = input.bodies(&law);
        let contact = StaticContact::try_new(&sphere, &half_space, law.as_contact_law());
        return format!("{:?}", contact.unwrap().indent(&[SetPoint::Load(1e4), SetPoint::Load(0.0)], None));
    }
    let contact = input.contact().unwrap();
    if of == Kind::Sweep {
        format!("{:?}", contact.row(input.approach(), &input.solver()))
    } else {
        // a run writes a trace
        format!("{:?}", contact.impact(input.approach(), &input.solver(), Some(5)))
    }
}

/// Every number that a scene gives changes what is computed, or the scene is warned that it does not, and why. An indentation
/// refuses forces, a motion and its solver beside it.
#[test]
fn every_key_has_effect_or_reason() {
    let scenes: &[&[&str]] = &[
        &["solver.tolerance=1e-9", "friction.coefficient=0.1", "sphere.moment_of_inertia=5e-8"],
        &["solver.method=auto", "solver.tolerance=1e-9", "half_space.density=7850", "law.stronge.unloading_factor=1.1"],
        &["solver.method=verlet", "solver.tolerance=1e-9", "sphere.youngs_modulus=rigid", "sphere.yield_strength=8e8"],
        &["half_space.density=7850", "half_space.thickness=0.02", "half_space.edge_distance=0.01"],
        &["half_space.density=7850", "half_space.rod_diameter=0.02", "half_space.rod_length=0.01"],
        &["damping.viscous=0.1", "solver.method=auto", "solver.tolerance=1e-9"],
        &["damping.viscoelastic_time=1e-6", "solver.method=auto"],
        &["adhesion.work=0.05", "solver.method=auto"],
        &["friction.coefficient=0.1", "impact.angle=30 deg", "sphere.spin=10", "sphere.moment_of_inertia=5e-8"],
        &["gravity.acceleration=9.81", "law.thornton.yield_pressure=1e9"],
        &["half_space.flow_stress.voce.saturation=2", "half_space.flow_stress.voce.rate=20", "output.samples=9"],
        &[
            "half_space.rate.johnson_cook.c=0.02",
            "half_space.rate.johnson_cook.reference=2",
            "half_space.rate.tested_at=0.01",
        ],
        &["half_space.rate.cowper_symonds.rate=4000", "half_space.rate.cowper_symonds.exponent=4"],
        &["half_space.flow_stress.power.exponent=0.1", "law.plm.unloading_exponent=1.6"],
    ];
    let elastic = STEEL.replace("yield_strength = \"345 MPa\"\n", "");
    let elastic = read(&elastic, &["law.plm.unloading_exponent=1.6", "solver.tolerance=1e-9"]);
    let (mut met, mut idle) = (BTreeSet::new(), BTreeSet::new());
    for scenario in scenes.iter().map(|set| read(STEEL, set)).chain([elastic]) {
        let input = scenario.resolve().unwrap();
        for of in [Kind::Sweep, Kind::Impact, Kind::Indentation] {
            let is_refused = |part| {
                of == Kind::Indentation && matches!(part, Part::Forces | Part::Approach | Part::Solver | Part::Rate)
            };
            for key in NUMERIC_KEYS.iter().filter(|key| !is_refused(key.part())) {
                let Some(number) = input.number(*key).filter(|number| number.is_finite()) else { continue };
                let mut changed = input.clone();
                changed.set(*key, Some(0.9 * number));
                let facts = Facts { inputs: std::slice::from_ref(&input), kind: of, varied: &[] };
                let reason = facts.why_unused(key.path());
                let is_idle = computed(&changed, of) == computed(&input, of);
                assert_eq!(reason.is_some(), is_idle, "{} for {of:?}: {reason:?}, {input:?}", key.path());
                met.insert(key.path());
                idle.extend(reason.map(|_| (key.path(), format!("{of:?}"))));
            }
        }
    }
    assert!(met.len() > 20 && idle.len() > 15, "{met:?} {idle:?}");
}
