//! The registry of the keys that are read, but do not vary: words, counts, lists, and the numbers of scenes without an
//! impact.
//!
//! An entry gives, in this order: what the key means; its path; how its value is written; and the default in words (`=`).

use super::key::{AnyKey, Form};
use super::quantity::{
    DEPTH_RATIO, DEVIATION, ENERGY, FORCE, IMPACTS, INDENTATION, LEEB, LENGTH, LOAD, MODEL_ERROR, MODULUS,
    POISSONS_RATIO, RESTITUTION, SAMPLES, SHOT_SPEED, SPEED, STEPS, STRAIN, STRENGTH, TIME,
};
use super::words::{
    COLUMNS, HARDNESSES, JUMPS, LAWS, LOADINGS, MATERIALS, METHODS, NOISES, OWN_UNLOADINGS, ROBUSTS, SPOTS, UNLOADINGS,
};

/// A list of keys from their entries.
macro_rules! keys {
    ($($(#[doc = $about:literal])+ $path:literal: $form:ident $(($($what:expr),+))? $(= $default:literal)?;)+) => {
        &[$(AnyKey {
            path: $path,
            form: Form::$form$(($($what),+))?,
            about: concat!($($about),+).trim_ascii_start(),
            default: concat!($($default)?),
        }),+]
    };
}

/// The keys that do not vary, in the order of the file.
pub const OTHER_KEYS: &[AnyKey] = keys! {
    /// Material whose numbers the sphere takes; a key that is given too replaces the number. It can be an axis.
    "sphere.material": Word(&MATERIALS);
    /// Material whose numbers the half-space takes; a key that is given too replaces the number. It can be an axis.
    "half_space.material": Word(&MATERIALS);
    /// Points of a measured flow curve: plastic strain and true stress; straight lines between them, constant after the
    /// last.
    "half_space.flow_stress.points": Pairs(&STRAIN, &STRENGTH);
    /// File of such points, relative to the scenario: CSV with the columns plastic_strain and stress_Pa.
    "half_space.flow_stress.table": Text("flow.csv");
    /// File of coefficients of the loading curve, relative to the scenario.
    "law.plm.coefficients": Text("my.toml") = "built in";
    /// Formula of the geometric hardness: exponential is that of 2005, cosine the later one.
    "law.jackson_green.hardness": Word(&HARDNESSES) = "\"exponential\"";
    /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
    "law.jackson_green.jumps": Word(&JUMPS) = "\"printed\"";
    /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
    "law.kogut_etsion.jumps": Word(&JUMPS) = "\"printed\"";
    /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
    "law.kogut_komvopoulos.jumps": Word(&JUMPS) = "\"printed\"";
    /// Law of the loading.
    "law.combined.loading": Word(&LOADINGS);
    /// Law of the unloading.
    "law.combined.unloading": Word(&UNLOADINGS);
    /// Integration method; it can be an axis. auto is the closed form where there is one and no trace is asked for,
    /// else rk8.
    "solver.method": Word(&METHODS) = "rk8; auto for tables and repeated impacts";
    /// Steps of verlet during the contact time.
    "solver.steps_per_contact": Count(&STEPS) = "50";
    /// Rows of a trace, evenly spaced in time; every event adds a row.
    "output.samples": Count(&SAMPLES) = "400";
    /// Results that a table has besides the restitution.
    "output.columns": WordList(&COLUMNS) = "all";
    /// Axes of a table: keys with lists or ranges of values; the first varies slowest.
    "sweep": Axes;
    /// Random cases: samples, seed, and keys with distributions.
    "monte_carlo": Variables;
    /// Where repeated impacts hit: same is in the dent of the impacts before, fresh is on new surface every time.
    "repeat.spot": Word(&SPOTS);
    /// Largest number of impacts.
    "repeat.impacts": Count(&IMPACTS);
    /// Bouncing ends before an impact that would be slower than this.
    "repeat.until.speed": Number(&SPEED, None);
    /// Speed of every shot, in place of [impact] and impacts.
    "repeat.speeds": Numbers(&SHOT_SPEED);
    /// Peak indentation over that at first yield.
    "compare.peak_indentation_ratio": Number(&DEPTH_RATIO, None);
    /// Peak indentation, in place of the ratio.
    "compare.peak_indentation": Number(&LENGTH, None);
    /// Force at the peak, where it was measured.
    "compare.peak_force": Number(&FORCE, None) = "of the PLM";
    /// Contact radius at the peak, where it was measured.
    "compare.peak_contact_radius": Number(&LENGTH, None) = "of the PLM";
    /// The sphere's own indentation at the peak, where it was measured.
    "compare.peak_sphere_indentation": Number(&LENGTH, None) = "of the PLM";
    /// Work of loading up to the peak.
    "compare.spent_work": Number(&ENERGY, None) = "of the PLM";
    /// Laws to compare, in the order of table and picture.
    "compare.laws": WordList(&OWN_UNLOADINGS) = "all but walton_braun";
    /// File of measurements (CSV), relative to the scenario.
    "calibrate.data": Text("drops.csv");
    /// One or two numeric keys to find, each with its range and, if needed, its scale.
    "calibrate.free": Free = "half_space.yield_strength, from 1e-5 to 0.1 of the modulus; or half_space.hardness where that is given, 2.9 times as high";
    /// What is done about outliers: student-t has the long tails of Student's distribution with 4 degrees of freedom.
    "calibrate.robust": Word(&ROBUSTS) = "\"none\"";
    /// Other laws to fit; all laws are ranked.
    "calibrate.laws": WordList(&LAWS) = "none";
    /// Standard deviations of the measurements, or estimate: they are found from the scatter about the fitted law.
    "calibrate.noise": WordOrTable(&NOISES) = "columns `_sd` of the data, else \"estimate\"";
    /// Error of the law as a share of each value, added in quadrature, independent from value to value.
    "calibrate.noise.model": Number(&MODEL_ERROR, None) = "0";
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.restitution": Number(&DEVIATION, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.rebound_speed": Number(&SPEED, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.rebound_height": Number(&LENGTH, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.leeb": Number(&DEVIATION, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.dent_diameter": Number(&LENGTH, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.dent_depth": Number(&LENGTH, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.contact_time": Number(&TIME, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.peak_force": Number(&FORCE, None);
    /// Standard deviation of this measurement, where the data have no column for it.
    "calibrate.noise.force": Number(&FORCE, None);
    /// Rebound speed over impact speed, measured in the impact of the scenario: in place of data.
    "calibrate.measured.restitution": Number(&RESTITUTION, None);
    /// Speed of the rebound, measured in the impact of the scenario: in place of data.
    "calibrate.measured.rebound_speed": Number(&SPEED, None);
    /// Height of the rebound, measured in the impact of the scenario: in place of data.
    "calibrate.measured.rebound_height": Number(&LENGTH, None);
    /// Leeb hardness: 1000 times the restitution, measured in the impact of the scenario: in place of data.
    "calibrate.measured.leeb": Number(&LEEB, None);
    /// Diameter of the dent's rim, measured in the impact of the scenario: in place of data.
    "calibrate.measured.dent_diameter": Number(&LENGTH, None);
    /// Depth of the dent, measured in the impact of the scenario: in place of data.
    "calibrate.measured.dent_depth": Number(&LENGTH, None);
    /// Time in contact, measured in the impact of the scenario: in place of data.
    "calibrate.measured.contact_time": Number(&TIME, None);
    /// Largest force, measured in the impact of the scenario: in place of data.
    "calibrate.measured.peak_force": Number(&FORCE, None);
    /// Load at which the step ends.
    "indentation.steps[].load": Number(&LOAD, None);
    /// Indentation at which the step ends, in place of the load.
    "indentation.steps[].indentation": Number(&INDENTATION, None);
    /// Name of the material in tables and pictures.
    "indentation.half_space[].name": Text("Ti-10Nb");
    /// Young's modulus of this half-space.
    "indentation.half_space[].youngs_modulus": Number(&MODULUS, None);
    /// Uncertainty of the modulus: half of the width of its interval.
    "indentation.half_space[].youngs_modulus_uncertainty": Number(&MODULUS, None) = "none";
    /// Poisson's ratio of this half-space.
    "indentation.half_space[].poissons_ratio": Number(&POISSONS_RATIO, None);
    /// Yield strength of this half-space; without the key it stays elastic.
    "indentation.half_space[].yield_strength": Number(&STRENGTH, None);
    /// Uncertainty of the strength: half of the width of its interval.
    "indentation.half_space[].yield_strength_uncertainty": Number(&STRENGTH, None) = "none";
};

/// A list of tables: a key whose items have keys of their own.
#[derive(Debug, Clone, Copy)]
pub struct List {
    /// As in the file, with dots.
    pub path: &'static str,
    /// How it is written.
    pub example: &'static str,
    /// What an item of it is.
    pub item: &'static str,
}

/// The lists of tables.
pub const LISTS: [List; 2] = [
    List {
        path: "indentation.steps",
        example: "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]",
        item: "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }",
    },
    List {
        path: "indentation.half_space",
        example: "[[indentation.half_space]] with a name",
        item: "a table with a name",
    },
];

impl List {
    /// The list of that path.
    pub fn find(path: &str) -> Option<&'static Self> {
        LISTS.iter().find(|list| list.path == path)
    }
}
