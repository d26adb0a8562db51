//! Random scenes of one impact, as the keys of a scenario, with weights for the edges; and what the program makes of one.

use std::fmt;
use std::ops::Range;

use plm_impact::error::ErrorKind;
use proptest::sample::select;

use crate::common::prelude::*;

/// The unit of a random number, so that scenes of all sizes are alike.
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
    SpeedOverRadius,
}

/// What stands behind a key.
#[derive(Debug, Clone, PartialEq)]
pub enum Given {
    Number(f64),
    Word(String),
    /// Points of a flow curve.
    Points(Vec<[f64; 2]>),
}

type Keys = Vec<(&'static str, Given, Unit)>;

/// A key with a number of this range, evenly.
fn number(path: &'static str, range: Range<f64>, unit: Unit) -> BoxedStrategy<Keys> {
    range.prop_map(move |number| vec![(path, Given::Number(number), unit)]).boxed()
}

/// A key with a number whose logarithm is in this range.
fn decades(path: &'static str, range: Range<f64>, unit: Unit) -> BoxedStrategy<Keys> {
    range.prop_map(move |log| vec![(path, Given::Number(10_f64.powf(log)), unit)]).boxed()
}

fn word(path: &'static str, word: &str) -> Keys {
    vec![(path, Given::Word(format!("\"{word}\"")), Unit::Si)]
}

fn nothing() -> BoxedStrategy<Keys> {
    Just(Keys::new()).boxed()
}

/// The keys of both strategies.
fn and(one: BoxedStrategy<Keys>, other: BoxedStrategy<Keys>) -> BoxedStrategy<Keys> {
    (one, other).prop_map(|(one, other)| [one, other].concat()).boxed()
}

/// The keys of one of these strategies, which have these weights.
fn one_of<const N: usize>(weighted: [(u32, BoxedStrategy<Keys>); N]) -> BoxedStrategy<Keys> {
    proptest::strategy::Union::new_weighted(Vec::from(weighted)).boxed()
}

/// Radius from 1 nm to 10 m, moduli from 1 MPa to 10 TPa and sometimes a rigid sphere, any Poisson's ratio.
fn bodies() -> BoxedStrategy<Keys> {
    [
        decades("sphere.radius", -9.0..1.0, Unit::Si),
        decades("sphere.density", 2.0..4.3, Unit::Si),
        one_of([
            (9, decades("sphere.youngs_modulus", 6.0..13.0, Unit::Si)),
            (1, Just(word("sphere.youngs_modulus", "rigid")).boxed()),
        ]),
        number("sphere.poissons_ratio", -0.9..0.49, Unit::Si),
        decades("half_space.youngs_modulus", 6.0..13.0, Unit::Si),
        number("half_space.poissons_ratio", -0.9..0.49, Unit::Si),
        // a curved wall, a ball and a body that is free to move
        one_of([
            (20, nothing()),
            (1, decades("half_space.radius", -0.7..2.0, Unit::Radius)),
            (1, number("half_space.radius", -20.0..-2.0, Unit::Radius)),
            (1, decades("half_space.mass", -1.0..1.0, Unit::SphereMass)),
            (
                2,
                and(
                    decades("half_space.radius", -0.7..0.7, Unit::Radius),
                    and(
                        decades("half_space.density", 2.0..4.3, Unit::Si),
                        Just(word("half_space.mass", "ball")).boxed(),
                    ),
                ),
            ),
        ]),
    ]
    .into_iter()
    .reduce(and)
    .unwrap()
}

/// Which bodies yield, by their strength over that of the scene.
fn strengths() -> BoxedStrategy<Keys> {
    let half_space = || Just(vec![("half_space.yield_strength", Given::Number(1.0), Unit::Strength)]).boxed();
    let sphere = |range| decades("sphere.yield_strength", range, Unit::Strength);
    one_of([
        (11, half_space()),
        (1, sphere(-0.01..0.01)),
        (1, and(half_space(), sphere(-0.09..0.09))),
        (2, and(half_space(), sphere(-0.4..0.4))),
        (1, nothing()),
    ])
}

/// A flow curve of the half-space, and how its strength rises with the strain rate.
fn hardening() -> BoxedStrategy<Keys> {
    let points = (1.0..1.5_f64, 1.0..2.0_f64, -3.0..-1.3_f64).prop_map(|(first, second, log)| {
        let strain = 10_f64.powf(log);
        let points = vec![[strain, first], [3.0 * strain, first * second]];
        vec![("half_space.flow_stress.points", Given::Points(points), Unit::Strength)]
    });
    let flow = one_of([
        (7, nothing()),
        (2, number("half_space.flow_stress.power.exponent", 0.0..0.5, Unit::Si)),
        (1, number("half_space.flow_stress.linear.slope", 0.0..10.0, Unit::Strength)),
        (1, points.boxed()),
        (
            1,
            and(
                number("half_space.flow_stress.voce.saturation", 0.0..3.0, Unit::Si),
                number("half_space.flow_stress.voce.rate", 2.0..30.0, Unit::Si),
            ),
        ),
    ]);
    let rate = one_of([
        (6, nothing()),
        (1, number("half_space.rate.johnson_cook.c", 0.0..0.05, Unit::Si)),
        (
            1,
            and(
                decades("half_space.rate.cowper_symonds.rate", 2.0..5.0, Unit::Si),
                number("half_space.rate.cowper_symonds.exponent", 1.0..8.0, Unit::Si),
            ),
        ),
    ]);
    and(flow, rate)
}

/// The law with its numbers: the PLM with each kind of exponent, and the published laws, also with other numbers than their own.
fn laws() -> BoxedStrategy<Keys> {
    let names = super::super::laws::whole_laws().into_iter().map(|(_, law)| law.name());
    let names: Vec<String> = names.filter(|name| name != "plm").collect();
    let exponent = one_of([
        (4, nothing()),
        (3, Just(word("law.plm.unloading_exponent", "pressure-shape")).boxed()),
        (3, number("law.plm.unloading_exponent", 1.01..2.0, Unit::Si)),
    ]);
    one_of([
        (10, and(exponent, hardening())),
        (4, select(names).prop_map(|name| word("law", &name)).boxed()),
        (
            1,
            one_of([
                (1, number("law.stronge.yield_pressure_ratio", 1.0..3.0, Unit::Si)),
                (1, number("law.jackson_green.yield_factor", 1.2..2.0, Unit::Si)),
                (1, number("law.kogut_etsion.yield_factor", 1.2..2.0, Unit::Si)),
                (1, number("law.ma_liu.hardness_ratio", 2.0..3.5, Unit::Si)),
                (1, number("law.mesarovic_johnson.area_factor", 0.8..2.0, Unit::Si)),
                (1, number("law.walton_braun.stiffness_ratio", 0.2..1.0, Unit::Si)),
            ]),
        ),
    ])
}

/// Gravity, and damping, a plate or elastic waves: from hardly any to what leaves next to nothing.
fn forces() -> BoxedStrategy<Keys> {
    let weight = decades("gravity.acceleration", -6.0..2.0, Unit::YieldGravity);
    let thin = decades("half_space.thickness", -0.5..1.5, Unit::Radius);
    let density = || decades("half_space.density", 2.0..4.3, Unit::Si);
    let drag = one_of([
        (4, nothing()),
        (2, density()),
        (1, decades("damping.hunt_crossley", -4.0..1.0, Unit::PerSpeed)),
        (1, decades("damping.viscous", -4.0..0.5, Unit::Si)),
        (1, and(thin, density())),
    ]);
    and(one_of([(2, nothing()), (1, weight)]), drag)
}

/// The speed over its whole range, and at its edges: at first yield and just beside it, next to nothing, and at rest; and
/// sometimes an angle with friction and spin.
fn approaches() -> BoxedStrategy<Keys> {
    let beside = |range: Range<f64>, sign: f64| {
        let at = range.prop_map(move |log| Given::Number(1.0 + sign * 10_f64.powf(log)));
        at.prop_map(|number| vec![("impact.speed", number, Unit::YieldSpeed)]).boxed()
    };
    let speed = one_of([
        (18, number("impact.speed", 0.0..1.0, Unit::Range)),
        (2, beside(-15.0..-1.0, 1.0)),
        (1, beside(-15.0..-1.0, -1.0)),
        (1, Just(vec![("impact.speed", Given::Number(1.0), Unit::YieldSpeed)]).boxed()),
        (1, decades("impact.speed", -20.0..-3.0, Unit::YieldSpeed)),
        (1, Just(vec![("impact.drop_height", Given::Number(0.0), Unit::Si)]).boxed()),
    ]);
    let oblique = [
        number("impact.angle", 0.0..1.55, Unit::Si),
        decades("friction.coefficient", -3.0..0.5, Unit::Si),
        number("sphere.spin", -1.0..1.0, Unit::SpeedOverRadius),
    ];
    and(speed, one_of([(3, nothing()), (1, oblique.into_iter().reduce(and).unwrap())]))
}

fn solvers() -> BoxedStrategy<Keys> {
    let methods = ["rk8", "rk8", "rk8", "dopri5", "dop853", "verlet", "auto", "closed_form"];
    let method = select(methods.to_vec()).prop_map(|method| word("solver.method", method)).boxed();
    and(method, decades("solver.tolerance", -12.0..-3.0, Unit::Si))
}

/// Any scene of one impact.
pub fn any_scene() -> impl Strategy<Value = AnyScene> {
    let keys = [bodies(), strengths(), laws(), forces(), approaches(), solvers()].into_iter().reduce(and).unwrap();
    let earlier = prop_oneof![3 => Just(None), 1 => (-1.5..1.5_f64).prop_map(|log| Some(10_f64.powf(log)))];
    // σ_Y/E*
    let strain = (-5.0..-1.0_f64).prop_map(|log| 10_f64.powf(log));
    (keys, strain, earlier, prop::option::of(2..60_usize)).prop_map(|(keys, strain, earlier, samples)| AnyScene {
        keys: in_si(&keys, strain),
        earlier,
        samples,
    })
}

/// These keys with numbers in SI, where the strength is this share of E*.
fn in_si(keys: &[(&'static str, Given, Unit)], strain: f64) -> Vec<(&'static str, Given)> {
    let find = |path: &str| keys.iter().find(|(key, ..)| *key == path);
    let of = |path: &str| match find(path) {
        Some((_, Given::Number(number), _)) => *number,
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
            Some((_, Given::Number(share), Unit::Range)) => {
                let highest = (0.03 / (strain * strain)).log10().min(4.0);
                yield_speed * 10_f64.powf(-3.0 + share * (highest + 3.0))
            }
            Some((_, Given::Number(share), _)) => yield_speed * share,
            _ => 0.0,
        };
        let weight = if let Some((_, Given::Number(weight), _)) = find("gravity.acceleration") { *weight } else { 0.0 };
        let fallen = (2.0 * weight * force / mass * indentation * (1.0 + 3.0 * weight)).sqrt();
        let size = |unit| match unit {
            Unit::Si => 1.0,
            Unit::Radius => radius,
            Unit::SphereMass => mass,
            Unit::Strength => strength,
            Unit::YieldSpeed | Unit::Range => speed,
            Unit::YieldGravity => force / mass,
            Unit::PerSpeed => 1.0 / speed.hypot(fallen),
            Unit::SpeedOverRadius => speed / radius,
        };
        let in_unit = |given: &Given, unit: Unit| match given {
            Given::Number(_) if matches!(unit, Unit::YieldSpeed | Unit::Range) => Given::Number(speed),
            Given::Number(number) => Given::Number(number * size(unit)),
            Given::Points(points) => {
                Given::Points(points.iter().map(|[strain, stress]| [*strain, stress * size(unit)]).collect())
            }
            Given::Word(word) => Given::Word(word.clone()),
        };
        let mut done: Vec<(&'static str, Given)> = Vec::new();
        for (path, given, unit) in keys {
            if done.iter().all(|(known, _)| known != path) {
                done.push((path, in_unit(given, *unit)));
            }
        }
        done
    };
    // the contact itself knows its speed at first yield to the last bit
    let begins = ["impact", "sphere.spin", "friction", "damping", "gravity", "solver", "half_space.thickness"];
    let scene = AnyScene { keys: convert(by_hand), earlier: None, samples: None };
    let scene = scene.without(&begins).with("impact.speed", Given::Number(by_hand));
    let yield_speed = scene.input().ok().and_then(|input| input.contact().ok()?.yield_speed());
    convert(yield_speed.unwrap_or(by_hand))
}

/// A scene of one impact.
#[derive(Clone)]
pub struct AnyScene {
    pub keys: Vec<(&'static str, Given)>,
    /// Speed of an earlier impact on the same spot, over the speed of this one.
    pub earlier: Option<f64>,
    pub samples: Option<usize>,
}

/// As the overrides of a command.
impl fmt::Debug for AnyScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (earlier {:?}, samples {:?})", self.overrides().join(" "), self.earlier, self.samples)
    }
}

impl AnyScene {
    fn overrides(&self) -> Vec<String> {
        let text = |(key, given): &(&str, Given)| match given {
            // an angle has to have its unit
            Given::Number(number) if *key == "impact.angle" => format!("{key}=\"{number:e} rad\""),
            Given::Number(number) => format!("{key}={number:e}"),
            Given::Word(word) => format!("{key}={word}"),
            Given::Points(points) => format!("{key}={points:?}"),
        };
        self.keys.iter().map(text).collect()
    }

    /// True if it has a key that begins so.
    pub fn has(&self, begin: &str) -> bool {
        self.keys.iter().any(|(key, _)| key.starts_with(begin))
    }

    /// This scene without the keys that begin so.
    pub fn without(&self, begins: &[&str]) -> Self {
        let is_kept = |key: &str| !begins.iter().any(|begin| key.starts_with(begin));
        Self { keys: self.keys.iter().filter(|(key, _)| is_kept(key)).cloned().collect(), ..self.clone() }
    }

    /// This scene with a key more, or with another value of it.
    pub fn with(&self, path: &'static str, given: Given) -> Self {
        let mut scene = self.without(&[path]);
        scene.keys.push((path, given));
        scene
    }

    /// The scenario, with these overrides more.
    pub fn scenario(&self, more: &[String]) -> Result<Scenario, Refused> {
        Scenario::from_text("s.toml", "", &[self.overrides(), more.to_vec()].concat()).map_err(Refused::ByKeys)
    }

    pub fn input(&self) -> Result<Input, Refused> {
        self.scenario(&[])?.resolve().map_err(Refused::ByKeys)
    }

    /// The impact of this scene, by its solver and on its spot.
    pub fn run(&self) -> Result<Run, Refused> {
        let input = self.input()?;
        let contact = input.contact()?;
        let (approach, solver) = (input.approach(), input.solver());
        let (mut before, mut earlier) = (Spot::fresh(), None);
        if let Some(ratio) = self.earlier {
            let approach = Approach { speed: approach.speed * ratio, ..approach };
            earlier = Some(contact.impact_on(&mut before, approach, &solver, None)?);
        }
        let mut after = before.clone();
        let impact = contact.impact_on(&mut after, approach, &solver, self.samples)?;
        Ok(Run { scene: self.clone(), contact, approach, solver, earlier, before, after, impact })
    }

    /// Whether a refusal has a reason that this scene has.
    pub fn explains(&self, refused: &Refused) -> bool {
        let is_plm = !self.has("law") || self.has("law.plm");
        match refused {
            Refused::ByKeys(error) => {
                let text = error.to_string();
                error.kind == ErrorKind::Input && self.keys.iter().any(|(key, _)| text.contains(key))
            }
            Refused::ByImpact(error) => match error {
                ImpactError::TooDeep { indentation, contact_radius, radius, .. } => {
                    indentation > radius || contact_radius > radius
                }
                ImpactError::Law(OutsideLaw::Range { .. }) => !is_plm,
                ImpactError::Law(OutsideLaw::Exponent { .. }) => self.has("law.plm.unloading_exponent"),
                ImpactError::Law(OutsideLaw::Flow(_) | OutsideLaw::BothFlow { .. }) => {
                    self.has("half_space.flow_stress")
                }
                ImpactError::Plate(_) => self.has("half_space.thickness"),
                ImpactError::NoClosedForm => self.has("damping") || self.has("half_space.thickness"),
                _ => false,
            },
        }
    }
}

/// Why a scene has no impact.
#[derive(Debug)]
pub enum Refused {
    ByKeys(Error),
    ByImpact(ImpactError),
}

impl From<ImpactError> for Refused {
    fn from(error: ImpactError) -> Self {
        Self::ByImpact(error)
    }
}

/// What the program makes of a scene.
#[derive(Debug)]
pub struct Run {
    pub scene: AnyScene,
    pub contact: Contact,
    pub approach: Approach,
    pub solver: Solver,
    /// The earlier impact on the same spot.
    pub earlier: Option<Impact>,
    /// The spot before and after this impact.
    pub before: Spot,
    pub after: Spot,
    pub impact: Impact,
}
