//! The registry of numeric keys: each is described once. Reading, `--set`, axes, random variables, `check`, the inputs of
//! `summary.json`, "did you mean", the reference page and the JSON Schema come from here.
//!
//! An entry gives, in this order: what the key means; its path; its dimension and range; the word that may stand in place
//! of the number (`or`); the default in words (`=`); and where the value is in a [`Scene`]. There, `field?` is a field that
//! a scene may lack, and `Law.field` a field of that law, which only a scene under that law has. In the same way,
//! `flow Form.field` is a number of a flow curve of that form, and `damping Kind` the number of damping of that kind.

use super::Scene;
use super::key::{AnyKey, Form, Key};
use super::other_keys::OTHER_KEYS;
use super::quantity::{
    ACCELERATION, AREA_FACTOR, DENSITY, DROP_HEIGHT, EXPONENT, FACTOR, HARDENING_EXPONENT, HARDENING_RATE,
    HARDENING_SLOPE, HARDNESS, HUNT_CROSSLEY, LENGTH, MASS, MODULUS, POISSONS_RATIO, SATURATION, SHARE, SPEED,
    SPHERE_MODULUS, STRENGTH, TOLERANCE, TRANSITION_RATIO, VISCOUS,
};
use crate::impact::Damping;
use crate::law::{LawChoice, UnloadingExponent};
use crate::strength::flow::FlowCurve;

/// Reads a key from a scene.
type Get = fn(&Scene) -> Option<f64>;
/// Puts a key into a scene.
type Set = fn(&mut Scene, f64);

/// A list of keys from their entries.
macro_rules! keys {
    ($($(#[doc = $about:literal])+
       $path:literal: $quantity:ident $(or $word:literal)? $(= $default:literal)? => $place:tt;)+) => {
        &[$({
            let (get, set): (Get, Set) = place!($place);
            Key {
                path: $path,
                quantity: &$quantity,
                word: word!($($word)?),
                about: concat!($($about),+).trim_ascii_start(),
                default: concat!($($default)?),
                get,
                set,
            }
        }),+]
    };
}

macro_rules! word {
    () => {
        None
    };
    ($word:literal) => {
        Some($word)
    };
}

/// How a value is read from a scene and put there.
macro_rules! place {
    ({ get: $get:expr, set: $set:expr }) => { ($get, $set) };
    ({ scene.$($field:ident).+ }) => {
        (|scene| Some(scene.$($field).+), |scene, value| scene.$($field).+ = value)
    };
    ({ scene.$($field:ident).+ ? }) => {
        (|scene| scene.$($field).+, |scene, value| scene.$($field).+ = Some(value))
    };
    ({ flow $form:ident.$number:ident }) => {
        (
            |scene| match scene.law.flow() {
                Some(FlowCurve::$form { $number, .. }) => Some(*$number),
                _ => None,
            },
            |scene, value| {
                scene.change_flow(|flow| {
                    if let FlowCurve::$form { $number, .. } = flow {
                        *$number = value;
                    }
                });
            },
        )
    };
    ({ damping $kind:ident }) => {
        (
            |scene| match scene.forces.damping {
                Some(Damping::$kind(value)) => Some(value),
                _ => None,
            },
            |scene, value| scene.forces.damping = Some(Damping::$kind(value)),
        )
    };
    ({ $law:ident.$field:ident }) => { place!({ $law, |law| Some(law.$field), |law, value| law.$field = value }) };
    ({ $law:ident.$field:ident ? }) => { place!({ $law, |law| law.$field, |law, value| law.$field = Some(value) }) };
    ({ $law:ident, |$of:ident| $get:expr, |$to:ident, $value:ident| $set:expr }) => {
        (
            |scene| match &scene.law {
                LawChoice::$law($of) => $get,
                _ => None,
            },
            |scene, $value| {
                if let LawChoice::$law($to) = &mut scene.law {
                    $set;
                }
            },
        )
    };
}

/// All numeric keys of the scene of an impact, in the order of the file.
pub const KEYS: &[Key] = keys! {
    /// Radius of the sphere (not its diameter).
    "sphere.radius": LENGTH => { get: |scene| Some(scene.sphere.radius), set: Scene::set_radius };
    /// Diameter of the sphere, in place of the radius.
    "sphere.diameter": LENGTH => {
        get: |scene| Some(2.0 * scene.sphere.radius),
        set: |scene, value| scene.set_radius(0.5 * value)
    };
    /// Young's modulus of the sphere, or "rigid".
    "sphere.youngs_modulus": SPHERE_MODULUS or "rigid" => { scene.sphere.material.youngs_modulus };
    /// Poisson's ratio of the sphere.
    "sphere.poissons_ratio": POISSONS_RATIO => { scene.sphere.material.poissons_ratio };
    /// Density of the sphere, which gives its mass.
    "sphere.density": DENSITY => {
        get: |scene| scene.mass.is_none().then_some(scene.sphere.density),
        set: Scene::set_density
    };
    /// Mass of all that moves with the sphere, in place of its density; for a hammer or a pendulum with a spherical tip.
    "sphere.mass": MASS => { get: |scene| scene.mass, set: Scene::set_mass };
    /// Yield strength of the sphere. It only serves to warn where the sphere would yield too.
    "sphere.yield_strength": STRENGTH => { scene.sphere.yield_strength? };
    /// Young's modulus of the half-space.
    "half_space.youngs_modulus": MODULUS => {
        get: |scene| Some(scene.half_space.material.youngs_modulus),
        set: Scene::set_half_space_modulus
    };
    /// Poisson's ratio of the half-space.
    "half_space.poissons_ratio": POISSONS_RATIO => { scene.half_space.material.poissons_ratio };
    /// Uniaxial yield strength of the half-space; without it the contact is elastic and nothing plastic is reported.
    "half_space.yield_strength": STRENGTH => {
        get: |scene| scene.half_space.yield_strength,
        set: Scene::set_yield_strength
    };
    /// Hardness of the half-space in place of its yield strength: "300 HV", "250 HB", "45 HRC", or the mean pressure of a
    /// hardness test. The flow stress at a plastic strain of 0.08 is this pressure divided by 2.9. It is the yield
    /// strength too, unless flow_stress.power is given: then the yield strength is where that curve begins.
    "half_space.hardness": HARDNESS => { get: |scene| scene.hardness, set: Scene::set_hardness };
    /// Exponent N of the flow stress sigma_Y (1 + E strain/sigma_Y)^N of a half-space that hardens.
    "half_space.flow_stress.power.exponent": HARDENING_EXPONENT => { flow Power.exponent };
    /// Factor b of the flow stress sigma_Y (1 + b (1 - exp(-c strain))), which rises by b yield strengths in the end.
    "half_space.flow_stress.voce.saturation": SATURATION => { flow Voce.saturation };
    /// Rate c of that flow stress: how fast it rises with plastic strain.
    "half_space.flow_stress.voce.rate": HARDENING_RATE => { flow Voce.rate };
    /// Slope of a flow stress that rises in a straight line with plastic strain.
    "half_space.flow_stress.linear.slope": HARDENING_SLOPE => { flow Linear.slope };
    /// Density of the half-space; with it the energy that is radiated as elastic waves is reported.
    "half_space.density": DENSITY => { scene.half_space.density? };
    /// Speed of the sphere at first touch, towards the half-space.
    "impact.speed": SPEED => { get: |scene| Some(scene.speed), set: Scene::set_speed };
    /// Height that the sphere falls from, in place of the speed; with 0 it is released at first touch. Needs gravity.
    "impact.drop_height": DROP_HEIGHT => { get: |scene| scene.drop_height, set: Scene::set_drop_height };
    /// Gravity, towards the half-space; it acts during contact too.
    "gravity.acceleration": ACCELERATION => { get: |scene| scene.forces.gravity, set: Scene::set_gravity };
    /// Coefficient chi of the force F (1 + chi v).
    "damping.hunt_crossley": HUNT_CROSSLEY => { damping HuntCrossley };
    /// Fraction of critical damping, with the tangent stiffness of the contact; in place of hunt_crossley.
    "damping.viscous": VISCOUS => { damping Viscous };
    /// Exponent of the unloading force, or "pressure-shape": the exponent that follows from the shape of the contact
    /// pressure at the peak. Other numbers than 1.5 are for comparison.
    "law.plm.unloading_exponent": EXPONENT or "pressure-shape" = "1.5" => {
        Plm, |plm| Some(plm.exponent.into()), |plm, value| plm.exponent = UnloadingExponent::from(value)
    };
    /// Contact pressure at which the straight part of the loading begins.
    "law.thornton.yield_pressure": STRENGTH = "largest Hertz pressure at first yield" => { Thornton.yield_pressure? };
    /// Mean contact pressure at first yield over the yield strength.
    "law.stronge.yield_pressure_ratio": FACTOR = "1.1" => { Stronge.yield_pressure_ratio };
    /// Factor f_u of the recovered approach.
    "law.stronge.unloading_factor": FACTOR = "1" => { Stronge.unloading_factor };
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.jackson_green.yield_factor": FACTOR = "1.295 exp(0.736 nu)" => { JacksonGreen.yield_factor? };
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.kogut_etsion.yield_factor": FACTOR = "(0.454 + 0.41 nu) x 2.8" => { KogutEtsion.yield_factor? };
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.yigit_christoforou.yield_factor": FACTOR = "1.649" => { YigitChristoforou.yield_factor? };
    /// Hardness over the yield strength.
    "law.ma_liu.hardness_ratio": FACTOR = "2.8" => { MaLiu.hardness_ratio };
    /// Indentation of full plasticity over that at first yield.
    "law.ma_liu.transition_ratio": TRANSITION_RATIO = "110" => { MaLiu.transition_ratio };
    /// True contact area over the area in which the sphere cuts the original surface.
    "law.mesarovic_johnson.area_factor": AREA_FACTOR = "1.43" => { MesarovicJohnson.area_factor };
    /// Stiffness of loading, in units of force over indentation at first yield.
    "law.walton_braun.loading_stiffness": FACTOR = "1" => { WaltonBraun.loading_stiffness };
    /// Stiffness of loading over that of unloading; the restitution is the square root of this ratio.
    "law.walton_braun.stiffness_ratio": SHARE = "0.5" => { WaltonBraun.stiffness_ratio };
    /// Mean contact pressure while the sphere goes in.
    "law.johnson.dynamic_pressure": STRENGTH = "3 yield strengths" => { Johnson.dynamic_pressure? };
    /// Relative tolerance of the integration, on the dimensionless state.
    "solver.tolerance": TOLERANCE = "1e-10" => { scene.solver.tolerance };
};

/// Keys that stand in place of each other: a scene takes one of the two.
pub const EITHER: [[&str; 2]; 6] = [
    ["sphere.radius", "sphere.diameter"],
    ["sphere.density", "sphere.mass"],
    ["half_space.yield_strength", "half_space.hardness"],
    ["impact.speed", "impact.drop_height"],
    ["damping.hunt_crossley", "damping.viscous"],
    ["compare.peak_indentation_ratio", "compare.peak_indentation"],
];

impl Key {
    /// The key of that path.
    pub fn find(path: &str) -> Option<&'static Self> {
        KEYS.iter().find(|key| key.path == path)
    }
}

/// The path of the key itself, from that of an axis, a random key or a key of a calibration. Any other path stays as it is.
pub fn varied(path: &str) -> &str {
    ["sweep.", "monte_carlo.", "calibrate.free."].iter().find_map(|table| path.strip_prefix(table)).unwrap_or(path)
}

/// Every key of a scenario; those that may vary come first.
pub fn every_key() -> impl Iterator<Item = AnyKey> {
    let numeric = KEYS.iter().map(|key| {
        let &Key { path, about, default, .. } = key;
        AnyKey { path, form: Form::Number(key.quantity, key.word), about, default }
    });
    numeric.chain(OTHER_KEYS.iter().copied())
}
