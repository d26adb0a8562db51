//! How scenes are drawn: tables of alternatives with their weights, and numbers in units of the scene, so that scenes of all sizes are
//! alike.

use super::random_scenario::{AnyScene, KeySetting, WAVEGUIDES};
use crate::common::prelude::*;

/// The unit of a random number.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Unit {
    Si,
    Radius,
    SphereMass,
    Strength,
    /// The speed at first yield.
    YieldSpeed,
    /// From a thousandth of that speed to where most spheres would go in too deep, or to 10⁴ times that speed.
    Range,
    /// The gravity at which the weight is the force at first yield.
    YieldGravity,
    /// One over the speed, with the one that the weight gives.
    PerSpeed,
    /// The time in which the sphere passes the indentation of an elastic impact, with that speed.
    ImpactTime,
    SpeedOverRadius,
}
use Unit::{ImpactTime, PerSpeed, Radius, Range, Si, SpeedOverRadius, SphereMass, Strength, YieldGravity, YieldSpeed};

/// The kind of value that is drawn for a key.
#[derive(Debug, Clone, Copy)]
enum Draw {
    Number(f64),
    /// Evenly between two numbers.
    Even(f64, f64),
    /// With a logarithm evenly between two numbers.
    Decades(f64, f64),
    /// One and up to a tenth more or less, by decades.
    Beside(f64),
    OneOf(&'static [&'static str]),
    /// A whole law by its name.
    Law,
    /// Two points of a flow curve.
    Curve,
}
use Draw::{Beside, Curve, Decades, Even, Law, Number, OneOf};

/// Alternatives with their weights, and the keys of each; the simplest one first.
type Table = &'static [(u32, &'static [(&'static str, Draw, Unit)])];

const PRESSURE_SHAPE: &[&str] = &["pressure-shape"];

const SPHERES: Table = &[
    (9, &[("sphere.youngs_modulus", Decades(6.0, 13.0), Si)]),
    (1, &[("sphere.youngs_modulus", OneOf(&["rigid"]), Si)]),
];
const BODIES: Table = &[(
    1,
    &[
        ("sphere.radius", Decades(-9.0, 1.0), Si),
        ("sphere.density", Decades(2.0, 4.3), Si),
        ("sphere.poissons_ratio", Even(-0.9, 0.49), Si),
        ("half_space.youngs_modulus", Decades(6.0, 13.0), Si),
        ("half_space.poissons_ratio", Even(-0.9, 0.49), Si),
    ],
)];
const BALL: (&str, Draw, Unit) = ("half_space.mass", OneOf(&["ball"]), Si);
const DENSITY: (&str, Draw, Unit) = ("half_space.density", Decades(2.0, 4.3), Si);
/// Curved walls, a body that is free to move, a ball.
const SHAPES: Table = &[
    (20, &[]),
    (1, &[("half_space.radius", Decades(-0.7, 2.0), Radius)]),
    (1, &[("half_space.radius", Even(-20.0, -2.0), Radius)]),
    (1, &[("half_space.mass", Decades(-1.0, 1.0), SphereMass)]),
    (2, &[("half_space.radius", Decades(-0.7, 0.7), Radius), DENSITY, BALL]),
];
const SOFTER: (&str, Draw, Unit) = ("half_space.yield_strength", Number(1.0), Strength);
/// Which bodies yield; the strength of the sphere may be far from that of the half-space, or within the ratio where both flow.
const STRENGTHS: Table = &[
    (11, &[SOFTER]),
    (1, &[]),
    (1, &[("sphere.yield_strength", Number(1.0), Strength)]),
    (1, &[SOFTER, ("sphere.yield_strength", Decades(-0.09, 0.09), Strength)]),
    (2, &[SOFTER, ("sphere.yield_strength", Decades(-0.4, 0.4), Strength)]),
];
/// The PLM with each kind of exponent, and the published laws, also with other numbers than their own.
const LAWS: Table = &[
    (12, &[]),
    (9, &[("law.plm.unloading_exponent", OneOf(PRESSURE_SHAPE), Si)]),
    (9, &[("law.plm.unloading_exponent", Even(1.01, 2.0), Si)]),
    (12, &[("law", Law, Si)]),
    (1, &[("law.stronge.yield_pressure_ratio", Even(1.0, 3.0), Si)]),
    (1, &[("law.jackson_green.yield_factor", Even(1.2, 2.0), Si)]),
    (1, &[("law.kogut_etsion.yield_factor", Even(1.2, 2.0), Si)]),
    (1, &[("law.ma_liu.hardness_ratio", Even(2.0, 3.5), Si)]),
    (1, &[("law.mesarovic_johnson.area_factor", Even(0.8, 2.0), Si)]),
    (1, &[("law.walton_braun.stiffness_ratio", Even(0.2, 1.0), Si)]),
];
const FLOWS: Table = &[
    (7, &[]),
    (2, &[("half_space.flow_stress.power.exponent", Even(0.0, 0.5), Si)]),
    (1, &[("half_space.flow_stress.linear.slope", Even(0.0, 10.0), Strength)]),
    (1, &[("half_space.flow_stress.points", Curve, Strength)]),
    (
        1,
        &[
            ("half_space.flow_stress.voce.saturation", Even(0.0, 3.0), Si),
            ("half_space.flow_stress.voce.rate", Even(2.0, 30.0), Si),
        ],
    ),
];
const RATES: Table = &[
    (6, &[]),
    (1, &[("half_space.rate.johnson_cook.c", Even(0.0, 0.05), Si)]),
    (
        1,
        &[
            ("half_space.rate.cowper_symonds.rate", Decades(2.0, 5.0), Si),
            ("half_space.rate.cowper_symonds.exponent", Even(1.0, 8.0), Si),
        ],
    ),
];
const GRAVITIES: Table = &[(2, &[]), (1, &[("gravity.acceleration", Decades(-6.0, 2.0), YieldGravity)])];
/// Damping, a plate, a rod or elastic waves: from hardly any to what leaves next to nothing.
const DRAGS: Table = &[
    (10, &[]),
    (4, &[DENSITY]),
    (2, &[("damping.hunt_crossley", Decades(-4.0, 1.0), PerSpeed)]),
    (2, &[("damping.viscous", Decades(-4.0, 0.5), Si)]),
    (2, &[("damping.viscoelastic_time", Decades(-4.0, 0.3), ImpactTime)]),
    (1, &[("half_space.thickness", Decades(-0.5, 1.5), Radius), DENSITY]),
    (1, &[("half_space.rod_diameter", Decades(-0.3, 1.5), Radius), DENSITY]),
];
/// The whole range, and its edges: at first yield and just beside it, next to nothing, and at rest.
const SPEEDS: Table = &[
    (18, &[("impact.speed", Even(0.0, 1.0), Range)]),
    (2, &[("impact.speed", Beside(1.0), YieldSpeed)]),
    (1, &[("impact.speed", Beside(-1.0), YieldSpeed)]),
    (1, &[("impact.speed", Number(1.0), YieldSpeed)]),
    (1, &[("impact.speed", Decades(-20.0, -3.0), YieldSpeed)]),
    (1, &[("impact.drop_height", Number(0.0), Si)]),
];
const OBLIQUES: Table = &[
    (3, &[]),
    (
        1,
        &[
            ("impact.angle", Even(0.0, 1.55), Si),
            ("friction.coefficient", Decades(-3.0, 0.5), Si),
            ("sphere.spin", Even(-1.0, 1.0), SpeedOverRadius),
        ],
    ),
    (
        1,
        &[
            ("impact.angle", Even(0.0, 1.55), Si),
            ("friction.coefficient", Decades(-3.0, 0.5), Si),
            ("sphere.spin", Even(-1.0, 1.0), SpeedOverRadius),
            ("sphere.spin_about_path", Even(-1.0, 1.0), SpeedOverRadius),
            ("sphere.spin_about_normal", Even(-1.0, 1.0), SpeedOverRadius),
        ],
    ),
];
const METHODS: &[&str] = &["rk8", "rk8", "rk8", "dopri5", "dop853", "verlet", "auto", "closed_form"];
const SOLVERS: Table = &[(1, &[("solver.method", OneOf(METHODS), Si), ("solver.tolerance", Decades(-12.0, -3.0), Si)])];

const TABLES: [Table; 12] =
    [BODIES, SPHERES, SHAPES, STRENGTHS, LAWS, FLOWS, RATES, GRAVITIES, DRAGS, SPEEDS, OBLIQUES, SOLVERS];

type Keys = Vec<(&'static str, KeySetting, Unit)>;

/// Any scene of one impact: σ_Y/E* from 1e-5 to 0.1, sometimes an earlier hit on the same spot, and a trace.
pub fn any_scene() -> impl Strategy<Value = AnyScene> {
    let draws = prop::collection::vec((0.0..1.0_f64, prop::array::uniform5(0.0..1.0_f64)), TABLES.len());
    let earlier = prop_oneof![3 => Just(None), 1 => (-1.5..1.5_f64).prop_map(|log| Some(10_f64.powf(log)))];
    (draws, -5.0..-1.0_f64, earlier, prop::option::of(2..60_usize)).prop_map(|(draws, log, earlier, samples)| {
        let mut keys = Keys::new();
        for (table, (pick, numbers)) in TABLES.iter().zip(draws) {
            let mut left = pick * f64::from(table.iter().map(|(weight, _)| weight).sum::<u32>());
            let chosen = table.iter().find(|(weight, _)| {
                left -= f64::from(*weight);
                left < 0.0
            });
            for ((path, form, unit), share) in chosen.unwrap().1.iter().zip(numbers) {
                keys.push((path, draw_value(*form, share), *unit));
            }
        }
        // other laws have neither; and what is given twice counts once
        let is_plm = !keys.iter().any(|(path, ..)| path.starts_with("law") && !path.starts_with("law.plm"));
        keys.retain(|(path, ..)| is_plm || !path.contains("flow_stress") && !path.contains(".rate."));
        let mut known = Vec::new();
        keys.retain(|(path, ..)| {
            !known.contains(path) && {
                known.push(*path);
                true
            }
        });
        // a few traces are long
        let samples = samples.map(|samples| if samples < 59 { samples } else { 1001 });
        AnyScene { keys: to_si(&keys, 10_f64.powf(log)), earlier, samples }
    })
}

/// The value by an even share from 0 to 1.
fn draw_value(form: Draw, share: f64) -> KeySetting {
    let between = |low: f64, high: f64| low + share * (high - low);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
    let place = |count: usize| (share * count as f64) as usize;
    match form {
        Number(number) => KeySetting::Number(number),
        Even(low, high) => KeySetting::Number(between(low, high)),
        Decades(low, high) => KeySetting::Number(10_f64.powf(between(low, high))),
        Beside(sign) => KeySetting::Number(1.0 + sign * 10_f64.powf(between(-15.0, -1.0))),
        OneOf(words) => KeySetting::Word(format!("\"{}\"", words[place(words.len())])),
        Law => {
            let laws = crate::contact::laws::whole_laws();
            KeySetting::Word(format!("\"{}\"", laws[place(laws.len())].1.name()))
        }
        // of two stresses and a strain one number makes three
        Curve => {
            let [strain, second] = [10_f64.powf(between(-3.0, -1.3)), (1e3 * share).fract()];
            let first = 1.0 + 0.5 * (1e6 * share).fract();
            KeySetting::Points(vec![[strain, first], [3.0 * strain, first * (1.0 + second)]])
        }
    }
}

/// These keys with numbers in SI, where the strength is this share of E*.
fn to_si(keys: &[(&'static str, KeySetting, Unit)], strain: f64) -> Vec<(&'static str, KeySetting)> {
    let find = |path: &str| keys.iter().find(|(key, ..)| *key == path);
    let of = |path: &str| match find(path) {
        Some((_, KeySetting::Number(number), _)) => *number,
        _ => f64::INFINITY,
    };
    let modulus = |body: &str| {
        let poissons_ratio = of(&format!("{body}.poissons_ratio"));
        of(&format!("{body}.youngs_modulus")) / (1.0 - poissons_ratio * poissons_ratio)
    };
    let e_star = 1.0 / (1.0 / modulus("sphere") + 1.0 / modulus("half_space"));
    let (radius, density, strength) = (of("sphere.radius"), of("sphere.density"), strain * e_star);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3) * density;
    // first yield with C_ν = 1.6, where no law says otherwise
    let pressure = 1.6 * std::f64::consts::PI * strain;
    let force = pressure.powi(3) * e_star * radius * radius / 6.0;
    let indentation = 0.25 * pressure * pressure * radius;
    let by_hand = (0.8 * force * indentation / mass).sqrt();
    let convert = |yield_speed: f64| {
        let speed = match find("impact.speed") {
            Some((_, KeySetting::Number(share), Range)) => {
                let highest = (0.03 / (strain * strain)).log10().min(4.0);
                yield_speed * 10_f64.powf(-3.0 + share * (highest + 3.0))
            }
            Some((_, KeySetting::Number(share), _)) => yield_speed * share,
            _ => 0.0,
        };
        let weight =
            if let Some((_, KeySetting::Number(weight), _)) = find("gravity.acceleration") { *weight } else { 0.0 };
        let fallen = (2.0 * weight * force / mass * indentation * (1.0 + 3.0 * weight)).sqrt();
        let size = |unit| match unit {
            Si => 1.0,
            Radius => radius,
            SphereMass => mass,
            Strength => strength,
            YieldSpeed | Range => speed,
            YieldGravity => force / mass,
            PerSpeed => 1.0 / speed.hypot(fallen),
            ImpactTime => {
                let fastest = speed.hypot(fallen);
                (1.25 * mass * fastest * fastest / (4.0 / 3.0 * e_star * radius.sqrt())).powf(0.4) / fastest
            }
            SpeedOverRadius => speed / radius,
        };
        let in_unit = |given: &KeySetting, unit: Unit| match given {
            KeySetting::Number(_) if matches!(unit, YieldSpeed | Range) => KeySetting::Number(speed),
            KeySetting::Number(number) => KeySetting::Number(number * size(unit)),
            KeySetting::Points(points) => {
                KeySetting::Points(points.iter().map(|[strain, stress]| [*strain, stress * size(unit)]).collect())
            }
            KeySetting::Word(word) => KeySetting::Word(word.clone()),
        };
        keys.iter().map(|(path, given, unit)| (*path, in_unit(given, *unit))).collect()
    };
    // the contact itself knows its speed at first yield to the last bit
    let begins = ["impact", "sphere.spin", "friction", "damping", "gravity", "solver"];
    let scene = AnyScene { keys: convert(by_hand), earlier: None, samples: None };
    let scene = scene.without(&begins).without(&WAVEGUIDES).with("impact.speed", KeySetting::Number(by_hand));
    let yield_speed = scene.input().ok().and_then(|input| input.contact().ok()?.yield_speed());
    convert(yield_speed.unwrap_or(by_hand))
}
