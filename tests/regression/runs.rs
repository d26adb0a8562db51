//! The runs whose numbers are compared.

use std::fs;
use std::path::{Path, PathBuf};

/// One call of the command.
pub struct Run {
    /// The name in the record: the file, and the keys that are set.
    pub name: String,
    /// The arguments of the command, which writes into the directory `out`.
    pub arguments: Vec<String>,
}

/// A scenario of this folder, and groups of keys that are set in it. All combinations of one choice from each group are
/// run. A choice may be no key, or two keys separated by a blank. All values are in SI units.
const VARIANTS: &[(&str, &[&[&str]])] = &[
    ("impact", &[METHODS, FORCES]),
    ("impact", &[&["solver.method=verlet"], &["solver.steps_per_contact=20", "solver.steps_per_contact=333"]]),
    ("impact", &[&["solver.tolerance=1e-3", "solver.tolerance=1e-6", "solver.tolerance=1e-13"], FEW_FORCES]),
    ("impact", &[CURVED, &["solver.method=rk8", "solver.method=dop853"], FEW_FORCES]),
    ("impact", &[BODIES, FEW_FORCES]),
    ("impact", &[&["damping.viscous=1", "damping.viscous=1.3"], &["gravity.acceleration=1e5"]]),
    ("speeds", &[LAWS]),
    ("speeds", &[METHODS]),
    ("laws-under-gravity", &[&["damping.viscous=0.1", "damping.hunt_crossley=0.1", "solver.method=rk8"]]),
    ("flow-stress", &[&["law.plm.unloading_exponent=pressure-shape", "solver.method=rk8"]]),
    ("viscous", &[METHODS]),
    ("hunt-crossley", &[METHODS]),
    ("plate", &[&["gravity.acceleration=9.81", "half_space.plate=thick", "law=thornton", "solver.method=dop853"]]),
    ("drop-heights", &[&["", "damping.viscous=0.1", "damping.hunt_crossley=0.1"], &["", "solver.method=rk8"]]),
    ("random", &[FORCES]),
    ("elastic-bouncing", &[DAMPING]),
    ("bouncing", &[SPOTS, DAMPING]),
    ("bouncing", &[SPOTS, &["solver.method=rk8"]]),
    ("bouncing", &[&["half_space.yield_strength=1e15", "law.thornton.yield_pressure=500e6"]]),
    ("shots", &[SPOTS, DAMPING]),
    ("shots", &[SPOTS, &["solver.method=rk8"]]),
    ("indentation", &[&["law.plm.unloading_exponent=1.2", "law.plm.unloading_exponent=pressure-shape"]]),
];

const METHODS: &[&str] = &[
    "",
    "solver.method=rk8",
    "solver.method=dopri5",
    "solver.method=dop853",
    "solver.method=verlet",
    "solver.method=closed_form",
];

const FORCES: &[&str] = &[
    "",
    "gravity.acceleration=9.81",
    "damping.viscous=0.1",
    "damping.hunt_crossley=0.1",
    "damping.viscous=0.1 gravity.acceleration=9.81",
    "damping.hunt_crossley=0.1 gravity.acceleration=9.81",
];

const FEW_FORCES: &[&str] = &["", "damping.viscous=0.1 gravity.acceleration=9.81"];

const DAMPING: &[&str] = &["", "damping.viscous=0.05", "damping.hunt_crossley=0.02"];

const SPOTS: &[&str] = &["", "repeat.spot=fresh"];

/// Laws with pieces that are neither straight nor a Hertz curve.
const CURVED: &[&str] =
    &["law.plm.unloading_exponent=1.2", "law.plm.unloading_exponent=pressure-shape", "law=jackson_green"];

const BODIES: &[&str] = &[
    "sphere.youngs_modulus=rigid",
    "sphere.youngs_modulus=5e9",
    "sphere.radius=1e-8",
    "sphere.yield_strength=4e8",
    "half_space.yield_strength=1e15",
    "half_space.density=7850",
];

const LAWS: &[&str] = &[
    "law.plm.unloading_exponent=1.2",
    "law.plm.unloading_exponent=1.8",
    "law.plm.unloading_exponent=pressure-shape",
    "law.thornton.yield_pressure=800e6",
    "law.stronge.yield_pressure_ratio=1.3",
    "law.stronge.unloading_factor=0.8",
    "law.jackson_green.yield_factor=1.5",
    "law.jackson_green.hardness=cosine",
    "law.kogut_etsion.yield_factor=1.2",
    "law.yigit_christoforou.yield_factor=1.3",
    "law.ma_liu.hardness_ratio=3.1",
    "law.ma_liu.transition_ratio=60",
    "law.mesarovic_johnson.area_factor=1.2",
    "law.walton_braun.loading_stiffness=2",
    "law.walton_braun.stiffness_ratio=0.3",
    "law.johnson.dynamic_pressure=900e6",
];

/// All runs: every scenario of `scenarios/` and of this folder, the variants, and other commands than `run`.
pub fn all() -> Vec<Run> {
    let ours = folder("tests/regression");
    let mut runs: Vec<Run> = scenarios(&folder("scenarios")).iter().map(|file| run("scenarios/", file, &[])).collect();
    runs.extend(scenarios(&ours).iter().map(|file| run("", file, &[])));
    for (scenario, groups) in VARIANTS {
        let file = ours.join(format!("{scenario}.toml"));
        runs.extend(products(groups).iter().filter(|keys| !keys.is_empty()).map(|keys| run("", &file, keys)));
    }
    runs.push(validate());
    runs
}

/// A folder of the project.
pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn scenarios(folder: &Path) -> Vec<PathBuf> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|extension| extension == "toml")).collect();
    files.sort();
    files
}

/// One choice from every group, in all combinations.
fn products(groups: &[&[&'static str]]) -> Vec<Vec<&'static str>> {
    let Some((first, rest)) = groups.split_first() else { return vec![Vec::new()] };
    let rest = products(rest);
    let with_rest = |choice: &&'static str| {
        let keys: Vec<_> = choice.split_whitespace().collect();
        rest.iter().map(|others| [keys.as_slice(), others].concat()).collect::<Vec<_>>()
    };
    first.iter().flat_map(with_rest).collect()
}

/// A run of a scenario in which these keys are set.
fn run(folder: &str, file: &Path, keys: &[&str]) -> Run {
    let stem = file.file_stem().unwrap().to_string_lossy();
    let name = [&[format!("{folder}{stem}").as_str()], keys].concat().join(" ");
    let path = file.to_string_lossy();
    let settings = keys.iter().flat_map(|key| ["--set", key]);
    let arguments = ["run", &path, "--out", "out", "--quiet", "--pictures", "none"].into_iter().chain(settings);
    Run { name, arguments: arguments.map(str::to_owned).collect() }
}

fn validate() -> Run {
    let arguments = ["validate", "--pictures", "none", "--out", "out"];
    Run { name: "validate".to_owned(), arguments: arguments.map(str::to_owned).into() }
}
