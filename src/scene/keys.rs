//! The registry of keys: every key of a scenario, once. Reading, `--set`, axes, random variables, `check`, the inputs of
//! `summary.json`, "did you mean", the reference page and the JSON Schema come from here.

use super::Scene;
use super::quantity::{
    ACCELERATION, AREA_FACTOR, DENSITY, DEPTH_RATIO, DROP_HEIGHT, ENERGY, EXPONENT, FACTOR, FORCE, HUNT_CROSSLEY,
    IMPACTS, INDENTATION, LENGTH, LOAD, MODULUS, POISSONS_RATIO, Quantity, SAMPLES, SHARE, SHOT_SPEED, SPEED,
    SPHERE_MODULUS, STEPS, STRENGTH, TOLERANCE, TRANSITION_RATIO, VISCOUS,
};
use super::results::RESULT_COLUMNS;
use crate::impact::{Damping, Method};
use crate::law::{LawChoice, UnloadingExponent};
use crate::repeat::Place;

/// A numeric key of the scene of an impact: it can be an axis or a random variable.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// As in the file, with dots: `impact.speed`.
    pub path: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// A word that may stand in place of the number; it is an infinite number in the scene.
    pub word: Option<&'static str>,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// Its value in a scene, SI; `None` where the scene has none.
    pub get: fn(&Scene) -> Option<f64>,
    /// Puts a checked value, SI, into a scene.
    pub set: fn(&mut Scene, f64),
}

/// A key that is read, but not varied.
#[derive(Debug, Clone, Copy)]
pub struct OtherKey {
    /// As in the file, with dots; `[]` stands behind the name of a list of tables.
    pub path: &'static str,
    /// How its value is written.
    pub form: Form,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
}

/// How a value is written.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A number in SI, or a text with a unit, or the word.
    Number(&'static Quantity, Option<&'static str>),
    /// A whole number.
    Count(&'static Quantity),
    /// A list of numbers.
    Numbers(&'static Quantity),
    /// One of some words.
    Word(&'static Words),
    /// A list of such words.
    WordList(&'static Words),
    /// Any text, such as this one.
    Text(&'static str),
    /// The axes of a table, by the keys that vary.
    Axes,
    /// The random variables of a table, by the keys that vary.
    Variables,
}

/// Words that a key takes.
#[derive(Debug)]
pub struct Words {
    /// One of them is called.
    pub one: &'static str,
    /// Several of them are called.
    pub several: &'static str,
    /// What there is.
    pub known: fn() -> Vec<String>,
}

/// Names of integration methods.
pub static METHODS: Words = Words {
    one: "method",
    several: "methods",
    known: || Method::ALL.iter().map(|(name, _)| (*name).to_owned()).collect(),
};
/// Names of whole laws, as an axis takes them.
pub static LAWS: Words = Words { one: "law", several: "laws", known: || names(LawChoice::has_loading) };
/// Names of laws that load.
pub static LOADINGS: Words = Words { one: "loading", several: "loadings", known: || names(LawChoice::has_loading) };
/// Names of laws that unload.
pub static UNLOADINGS: Words =
    Words { one: "unloading", several: "unloadings", known: || names(LawChoice::has_unloading) };
/// Names of laws with an unloading of their own.
pub static OWN_UNLOADINGS: Words =
    Words { one: "unloading", several: "unloadings", known: || names(LawChoice::has_own_unloading) };
/// Where repeated impacts hit.
pub static SPOTS: Words =
    Words { one: "spot", several: "spots", known: || Place::ALL.iter().map(|place| place.name().to_owned()).collect() };
/// What becomes of a printed jump.
pub static JUMPS: Words = Words { one: "word", several: "words here", known: || words(&["printed", "crossed"]) };
/// Forms of the hardness of Jackson and Green.
pub static HARDNESSES: Words =
    Words { one: "word", several: "words here", known: || words(&["exponential", "cosine"]) };
static COLUMNS: Words = Words {
    one: "result",
    several: "results",
    known: || RESULT_COLUMNS.iter().map(|column| column.name.to_owned()).collect(),
};

fn words(known: &[&str]) -> Vec<String> {
    known.iter().map(ToString::to_string).collect()
}

fn names(is_wanted: fn(&LawChoice) -> bool) -> Vec<String> {
    LawChoice::all().iter().filter(|law| is_wanted(law)).map(LawChoice::name).collect()
}

impl Key {
    /// The key of that path.
    #[must_use]
    pub fn find(path: &str) -> Option<&'static Self> {
        KEYS.iter().find(|key| key.path == path)
    }

    /// The name of its column in tables, with its unit: `impact_speed_m_per_s`.
    #[must_use]
    pub fn column(&self) -> String {
        format!("{}{}", self.path.replace('.', "_"), self.quantity.dimension.suffix())
    }
}

/// A numeric key of every scene.
macro_rules! of_scene {
    ($path:literal, $quantity:expr, optional $($field:ident).+, $about:literal) => {
        Key {
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = Some(value),
            ..key($path, $quantity, $about)
        }
    };
    ($path:literal, $quantity:expr, $($field:ident).+, $about:literal) => {
        Key {
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value,
            ..key($path, $quantity, $about)
        }
    };
}

/// A key of a published law: there only in a scene under that law.
macro_rules! of_law {
    ($path:literal, $quantity:expr, $law:ident, $field:ident, $default:literal, $about:literal) => {
        of_law!($path, $quantity, $law, $field, $default, $about, Some, std::convert::identity)
    };
    ($path:literal, $quantity:expr, $law:ident, optional $field:ident, $default:literal, $about:literal) => {
        of_law!($path, $quantity, $law, $field, $default, $about, std::convert::identity, Some)
    };
    ($path:literal, $quantity:expr, $law:ident, $field:ident, $default:literal, $about:literal, $get:expr, $set:expr) => {
        Key {
            default: $default,
            get: |scene| match &scene.law {
                LawChoice::$law(law) => $get(law.$field),
                _ => None,
            },
            set: |scene, value| {
                if let LawChoice::$law(law) = &mut scene.law {
                    law.$field = $set(value);
                }
            },
            ..key($path, $quantity, $about)
        }
    };
}

const fn key(path: &'static str, quantity: &'static Quantity, about: &'static str) -> Key {
    Key { path, quantity, word: None, about, default: "", get: |_| None, set: |_, _| {} }
}

/// All numeric keys of the scene of an impact, in the order of the file.
pub const KEYS: &[Key] = &[
    of_scene!("sphere.radius", &LENGTH, sphere.radius, "Radius of the sphere (not its diameter)."),
    Key {
        get: |scene| Some(2.0 * scene.sphere.radius),
        set: |scene, value| scene.sphere.radius = 0.5 * value,
        ..key("sphere.diameter", &LENGTH, "Diameter of the sphere, in place of the radius.")
    },
    Key {
        word: Some("rigid"),
        ..of_scene!(
            "sphere.youngs_modulus",
            &SPHERE_MODULUS,
            sphere.material.youngs_modulus,
            "Young's modulus of the sphere, or \"rigid\"."
        )
    },
    of_scene!(
        "sphere.poissons_ratio",
        &POISSONS_RATIO,
        sphere.material.poissons_ratio,
        "Poisson's ratio of the sphere."
    ),
    of_scene!("sphere.density", &DENSITY, sphere.density, "Density of the sphere, which gives its mass."),
    of_scene!(
        "sphere.yield_strength",
        &STRENGTH,
        optional sphere.yield_strength,
        "Yield strength of the sphere: only to warn where it would yield too."
    ),
    of_scene!(
        "half_space.youngs_modulus",
        &MODULUS,
        half_space.material.youngs_modulus,
        "Young's modulus of the half-space."
    ),
    of_scene!(
        "half_space.poissons_ratio",
        &POISSONS_RATIO,
        half_space.material.poissons_ratio,
        "Poisson's ratio of the half-space."
    ),
    of_scene!(
        "half_space.yield_strength",
        &STRENGTH,
        optional half_space.yield_strength,
        "Uniaxial yield strength of the half-space; without it the contact is elastic and nothing plastic is reported."
    ),
    of_scene!(
        "half_space.density",
        &DENSITY,
        optional half_space.density,
        "Density of the half-space; with it the energy that is radiated as elastic waves is reported."
    ),
    Key {
        get: |scene| Some(scene.speed),
        set: Scene::set_speed,
        ..key("impact.speed", &SPEED, "Speed of the sphere at first touch, towards the half-space.")
    },
    Key {
        get: |scene| scene.drop_height,
        set: Scene::set_drop_height,
        ..key(
            "impact.drop_height",
            &DROP_HEIGHT,
            "Height of the fall that gives the speed, in place of it; 0 is a sphere let go at first touch. Needs gravity.",
        )
    },
    Key {
        get: |scene| scene.forces.gravity,
        set: Scene::set_gravity,
        ..key("gravity.acceleration", &ACCELERATION, "Gravity, towards the half-space; it acts during contact too.")
    },
    Key {
        get: |scene| match scene.forces.damping {
            Some(Damping::HuntCrossley(chi)) => Some(chi),
            _ => None,
        },
        set: |scene, value| scene.forces.damping = Some(Damping::HuntCrossley(value)),
        ..key("damping.hunt_crossley", &HUNT_CROSSLEY, "Coefficient chi of the force F (1 + chi v).")
    },
    Key {
        get: |scene| match scene.forces.damping {
            Some(Damping::Viscous(zeta)) => Some(zeta),
            _ => None,
        },
        set: |scene, value| scene.forces.damping = Some(Damping::Viscous(value)),
        ..key(
            "damping.viscous",
            &VISCOUS,
            "Fraction of critical damping, with the tangent stiffness of the contact; in place of hunt_crossley.",
        )
    },
    Key {
        word: Some("pressure-shape"),
        default: "1.5",
        get: |scene| match &scene.law {
            LawChoice::Plm(plm) => Some(plm.exponent.into()),
            _ => None,
        },
        set: |scene, value| {
            if let LawChoice::Plm(plm) = &mut scene.law {
                plm.exponent = UnloadingExponent::from(value);
            }
        },
        ..key(
            "law.plm.unloading_exponent",
            &EXPONENT,
            "Exponent of the unloading force, or \"pressure-shape\": the exponent that follows from the shape of the contact pressure at the peak. Other numbers than 1.5 are for comparison.",
        )
    },
    of_law!(
        "law.thornton.yield_pressure",
        &STRENGTH,
        Thornton,
        optional yield_pressure,
        "largest Hertz pressure at first yield",
        "Contact pressure at which the straight part of the loading begins."
    ),
    of_law!(
        "law.stronge.yield_pressure_ratio",
        &FACTOR,
        Stronge,
        yield_pressure_ratio,
        "1.1",
        "Mean contact pressure at first yield over the yield strength."
    ),
    of_law!(
        "law.stronge.unloading_factor",
        &FACTOR,
        Stronge,
        unloading_factor,
        "1",
        "Factor f_u of the recovered approach."
    ),
    of_law!(
        "law.jackson_green.yield_factor",
        &FACTOR,
        JacksonGreen,
        optional yield_factor,
        "1.295 exp(0.736 nu)",
        "Largest Hertz pressure at first yield over the yield strength."
    ),
    of_law!(
        "law.kogut_etsion.yield_factor",
        &FACTOR,
        KogutEtsion,
        optional yield_factor,
        "(0.454 + 0.41 nu) x 2.8",
        "Largest Hertz pressure at first yield over the yield strength."
    ),
    of_law!(
        "law.yigit_christoforou.yield_factor",
        &FACTOR,
        YigitChristoforou,
        optional yield_factor,
        "1.649",
        "Largest Hertz pressure at first yield over the yield strength."
    ),
    of_law!("law.ma_liu.hardness_ratio", &FACTOR, MaLiu, hardness_ratio, "2.8", "Hardness over the yield strength."),
    of_law!(
        "law.ma_liu.transition_ratio",
        &TRANSITION_RATIO,
        MaLiu,
        transition_ratio,
        "110",
        "Indentation of full plasticity over that at first yield."
    ),
    of_law!(
        "law.mesarovic_johnson.area_factor",
        &AREA_FACTOR,
        MesarovicJohnson,
        area_factor,
        "1.43",
        "True contact area over that of the cut of sphere and surface."
    ),
    of_law!(
        "law.walton_braun.loading_stiffness",
        &FACTOR,
        WaltonBraun,
        loading_stiffness,
        "1",
        "Stiffness of loading, in units of force over indentation at first yield."
    ),
    of_law!(
        "law.walton_braun.stiffness_ratio",
        &SHARE,
        WaltonBraun,
        stiffness_ratio,
        "0.5",
        "Stiffness of loading over that of unloading; the restitution is its root."
    ),
    of_law!(
        "law.johnson.dynamic_pressure",
        &STRENGTH,
        Johnson,
        optional dynamic_pressure,
        "3 yield strengths",
        "Mean contact pressure while the sphere goes in."
    ),
    Key {
        default: "1e-10",
        ..of_scene!(
            "solver.tolerance",
            &TOLERANCE,
            solver.tolerance,
            "Relative tolerance of the integration, on the dimensionless state."
        )
    },
];

const fn other(path: &'static str, form: Form, default: &'static str, about: &'static str) -> OtherKey {
    OtherKey { path, form, about, default }
}

/// The keys that do not vary, in the order of the file.
pub const OTHER_KEYS: &[OtherKey] = &[
    other(
        "law.plm.coefficients",
        Form::Text("my.toml"),
        "built in",
        "File of coefficients of the loading curve, relative to the scenario.",
    ),
    other(
        "law.jackson_green.hardness",
        Form::Word(&HARDNESSES),
        "\"exponential\"",
        "Form of the geometric hardness: of 2005, or the later one.",
    ),
    other("law.jackson_green.jumps", Form::Word(&JUMPS), "\"printed\"", JUMPS_ABOUT),
    other("law.kogut_etsion.jumps", Form::Word(&JUMPS), "\"printed\"", JUMPS_ABOUT),
    other("law.kogut_komvopoulos.jumps", Form::Word(&JUMPS), "\"printed\"", JUMPS_ABOUT),
    other("law.combined.loading", Form::Word(&LOADINGS), "", "Law that says how the contact loads."),
    other("law.combined.unloading", Form::Word(&UNLOADINGS), "", "Law that says how the contact unloads."),
    other(
        "solver.method",
        Form::Word(&METHODS),
        "rk8; auto for tables and repeated impacts",
        "Integration method; it can be an axis. auto is the closed form where there is one and no trace is asked for, else rk8.",
    ),
    other("solver.steps_per_contact", Form::Count(&STEPS), "50", "Steps of verlet over the contact time."),
    other(
        "output.samples",
        Form::Count(&SAMPLES),
        "400",
        "Rows of a trace, evenly spaced in time; every event gets a row besides.",
    ),
    other("output.columns", Form::WordList(&COLUMNS), "all", "Results that a table has besides the restitution."),
    other("sweep", Form::Axes, "", "Axes of a table: keys with lists or ranges of values; the first varies slowest."),
    other("monte_carlo", Form::Variables, "", "Random cases: samples, seed, and keys with distributions."),
    other(
        "repeat.spot",
        Form::Word(&SPOTS),
        "",
        "Where repeated impacts hit: the dent is what the sphere meets next, or every impact is on new surface.",
    ),
    other("repeat.impacts", Form::Count(&IMPACTS), "", "Most impacts there may be."),
    other(
        "repeat.until.speed",
        Form::Number(&SPEED, None),
        "",
        "Bouncing ends before an impact that would be slower than this.",
    ),
    other("repeat.speeds", Form::Numbers(&SHOT_SPEED), "", "Speed of every shot, in place of [impact] and impacts."),
    other(
        "compare.peak_indentation_ratio",
        Form::Number(&DEPTH_RATIO, None),
        "",
        "Peak indentation over that at first yield.",
    ),
    other("compare.peak_indentation", Form::Number(&LENGTH, None), "", "Peak indentation, in place of the ratio."),
    other("compare.peak_force", Form::Number(&FORCE, None), "of the PLM", "Force at the peak, where it was measured."),
    other(
        "compare.peak_contact_radius",
        Form::Number(&LENGTH, None),
        "of the PLM",
        "Contact radius at the peak, where it was measured.",
    ),
    other(
        "compare.peak_sphere_indentation",
        Form::Number(&LENGTH, None),
        "of the PLM",
        "The sphere's own indentation at the peak, where it was measured.",
    ),
    other("compare.spent_work", Form::Number(&ENERGY, None), "of the PLM", "Work of loading up to the peak."),
    other(
        "compare.laws",
        Form::WordList(&OWN_UNLOADINGS),
        "all but walton_braun",
        "Laws to compare, in the order of table and picture.",
    ),
    other("indentation.steps[].load", Form::Number(&LOAD, None), "", "Load that the step goes to."),
    other(
        "indentation.steps[].indentation",
        Form::Number(&INDENTATION, None),
        "",
        "Indentation that the step goes to, in place of the load.",
    ),
    other("indentation.half_space[].name", Form::Text("Ti-10Nb"), "", "Name of the material in tables and pictures."),
    other(
        "indentation.half_space[].youngs_modulus",
        Form::Number(&MODULUS, None),
        "",
        "Young's modulus of this half-space.",
    ),
    other(
        "indentation.half_space[].youngs_modulus_uncertainty",
        Form::Number(&MODULUS, None),
        "none",
        "Half of the width of the interval that the modulus lies in.",
    ),
    other(
        "indentation.half_space[].poissons_ratio",
        Form::Number(&POISSONS_RATIO, None),
        "",
        "Poisson's ratio of this half-space.",
    ),
    other(
        "indentation.half_space[].yield_strength",
        Form::Number(&STRENGTH, None),
        "",
        "Yield strength of this half-space; without it, it stays elastic.",
    ),
    other(
        "indentation.half_space[].yield_strength_uncertainty",
        Form::Number(&STRENGTH, None),
        "none",
        "Half of the width of the interval that the strength lies in.",
    ),
];

const JUMPS_ABOUT: &str =
    "What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.";

/// Every key as the reader of a file sees it: its path and how its value is written.
pub fn forms() -> impl Iterator<Item = (&'static str, Form)> {
    let numeric = KEYS.iter().map(|key| (key.path, Form::Number(key.quantity, key.word)));
    numeric.chain(OTHER_KEYS.iter().map(|key| (key.path, key.form)))
}
