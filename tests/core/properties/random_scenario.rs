//! A scene of one impact, as the keys of a scenario, and what the program makes of it.

use std::fmt;

use plm_impact::error::ErrorKind;

use crate::common::prelude::*;

/// The keys of a plate and of a rod.
pub const WAVEGUIDES: [&str; 2] = [WaveguideKind::Plate.size_key(), WaveguideKind::Rod.size_key()];

/// The value of a key.
#[derive(Debug, Clone, PartialEq)]
pub enum KeySetting {
    Number(f64),
    Word(String),
    /// Points of a flow curve.
    Points(Vec<[f64; 2]>),
}

/// A scene of one impact.
#[derive(Clone)]
pub struct AnyScene {
    pub keys: Vec<(&'static str, KeySetting)>,
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
        let text = |(key, given): &(&str, KeySetting)| match given {
            // an angle has to have its unit
            KeySetting::Number(number) if *key == "impact.angle" => format!("{key}=\"{number:e} rad\""),
            KeySetting::Number(number) => format!("{key}={number:e}"),
            KeySetting::Word(word) => format!("{key}={word}"),
            KeySetting::Points(points) => format!("{key}={points:?}"),
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
    pub fn with(&self, path: &'static str, given: KeySetting) -> Self {
        let mut scene = self.without(&[path]);
        scene.keys.push((path, given));
        scene
    }

    /// The scenario, with these overrides more.
    pub fn scenario(&self, more: &[String]) -> Result<Scenario, RefusalReason> {
        Scenario::from_text("s.toml", "", &Override::list(&[self.overrides(), more.to_vec()].concat()))
            .map_err(RefusalReason::ByKeys)
    }

    pub fn input(&self) -> Result<Input, RefusalReason> {
        self.scenario(&[])?.resolve().map_err(RefusalReason::ByKeys)
    }

    /// The impact of this scene, by its solver and on its spot.
    pub fn run(&self) -> Result<Run, RefusalReason> {
        let input = self.input()?;
        let contact = input.contact()?;
        let (approach, solver) = (input.approach(), input.solver());
        let (mut before, mut earlier) = (Spot::new(), None);
        if let Some(ratio) = self.earlier {
            let speed = approach.tangential.speed * ratio;
            let tangential = TangentialMotion { speed, ..approach.tangential };
            let approach = Approach { normal: approach.normal * ratio, tangential, ..approach };
            earlier = Some(contact.impact_on(&mut before, approach, &solver, None)?);
        }
        let mut after = before.clone();
        let impact = contact.impact_on(&mut after, approach, &solver, self.samples)?;
        Ok(Run { scene: self.clone(), contact, approach, solver, earlier, before, after, impact })
    }

    /// Whether a refusal has a reason that this scene has.
    pub fn explains(&self, refused: &RefusalReason) -> bool {
        let is_plm = !self.has("law") || self.has("law.plm");
        match refused {
            RefusalReason::ByKeys(error) => {
                let text = error.to_string();
                error.kind == ErrorKind::Input && self.keys.iter().any(|(key, _)| text.contains(key))
            }
            RefusalReason::ByImpact(error) => match error {
                ImpactError::TooDeep { indentation, contact_radius, radius, .. } => {
                    indentation > radius || contact_radius > radius
                }
                ImpactError::Law(LawError::Range { .. }) => !is_plm,
                // up to 5 % more than was spent is taken care of
                ImpactError::Law(LawError::Exponent { gain, .. }) => {
                    self.has("law.plm.unloading_exponent") && *gain > 0.05
                }
                ImpactError::Law(LawError::Flow(_) | LawError::BothFlow { .. }) => self.has("half_space.flow_stress"),
                ImpactError::Waveguide(error) => self.has(error.kind.size_key()),
                ImpactError::NoClosedForm => self.has("damping") || WAVEGUIDES.iter().any(|key| self.has(key)),
                _ => false,
            },
        }
    }
}

/// Why a scene has no impact.
#[derive(Debug)]
pub enum RefusalReason {
    ByKeys(Error),
    ByImpact(ImpactError),
}

impl From<ImpactError> for RefusalReason {
    fn from(error: ImpactError) -> Self {
        Self::ByImpact(error)
    }
}

/// The results of the program for a scene.
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

impl Run {
    /// The speed normal to the surface.
    pub fn speed(&self) -> f64 {
        self.approach.normal
    }

    /// The contact with the strength of the strain rate of this impact.
    pub fn contact_at_own_rate(&self) -> Contact {
        self.contact.at_speed(self.speed()).unwrap().into_owned()
    }

    pub fn is_plm(&self) -> bool {
        !self.scene.has("law") || self.scene.has("law.plm")
    }

    /// True if only a flat half-space can yield.
    pub fn is_flat_and_alone(&self) -> bool {
        self.contact.sphere().yield_strength.is_none() && self.contact.half_space().radius.is_none()
    }

    pub fn is_fresh(&self) -> bool {
        self.before == Spot::new()
    }

    /// True if damping or a plate takes energy on the way.
    pub fn has_drag(&self) -> bool {
        self.contact.forces().damping.is_some() || self.contact.forces().waveguide.is_some()
    }

    /// True for the methods that follow a tolerance.
    pub fn is_adaptive(&self) -> bool {
        self.impact.method != Method::Verlet
    }

    /// Where the sphere touches.
    pub fn touch(&self) -> f64 {
        self.contact.dent_depth(&self.before)
    }

    pub fn weight(&self) -> f64 {
        self.contact.mass() * self.contact.forces().gravity.unwrap_or(0.0)
    }

    /// Kinetic energy at first touch, and the work of the weight down to the peak.
    pub fn input_energy(&self) -> f64 {
        self.impact.row.kinetic_in + self.weight() * (self.impact.row.peak_indentation - self.touch())
    }

    /// The error that a method may leave: ten tolerances, and rounding. The methods of `ode_solvers` step in time, in which a
    /// damped force is not smooth: they lose one more digit. On a plate the error is twice as large. The closed form takes its
    /// times under gravity at the tolerance of the solver; all else of it, and the run of its trace, has a tolerance of 1e-13.
    pub fn error_allowance(&self) -> f64 {
        let Forces { gravity, damping, waveguide, .. } = *self.contact.forces();
        let is_exact = self.impact.method == Method::ClosedForm && gravity.is_none();
        let tolerance = if is_exact { 1e-13 } else { self.solver.tolerance };
        let is_own = matches!(self.impact.method, Method::Rk8 | Method::ClosedForm);
        let factor = match (waveguide, damping) {
            (None, Some(_)) if !is_own => 100.0,
            (Some(_), _) => 20.0,
            _ => 10.0,
        };
        factor * tolerance + 1e-13
    }

    /// True if it turns so near to a joint of the law that its tolerance does not say on which side: there the contact radius of some
    /// laws jumps, and at first yield e, by an exponent above 3/2. On a plate this is so of the impact without it too.
    pub fn turns_at_subdivision(&self) -> bool {
        let own = self.contact_at_own_rate();
        let (scales, law, _) = own.scaling(self.speed().max(2.0 * own.yield_speed().unwrap_or(0.0))).unwrap();
        let peak = self.impact.row.peak_indentation / scales.units.length;
        if own.yield_speed().is_some_and(|yields| relative_error(self.speed(), yields) <= 10.0 * self.error_allowance())
        {
            return true;
        }
        let starts = law.loading.pieces().iter().map(|piece| piece.start).chain([law.validity.elastic_until]);
        starts.filter(|start| *start > 0.0).any(|start| relative_error(peak, start) <= 10.0 * self.error_allowance())
    }
}
