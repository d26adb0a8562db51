//! The warnings of a result.

use std::fmt;

/// A warning. Its text states the consequence and the remedy.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    pub kind: WarningKind,
    /// How serious the warning is, comparable within its kind: the largest counts, and NaN counts most.
    pub size: f64,
    text: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WarningKind {
    /// a/R above the data or the assumptions of the law.
    DeepDent,
    /// A deep dent in a metal that does not harden: a lip of piled-up metal carries force.
    DeepSoftDent,
    /// A deep and fast dent: the inertia of the target takes part in the impact.
    TargetInertia,
    /// A Poisson's ratio below those of the finite elements.
    NegativePoissonsRatio,
    /// A strength above the range of solids, as from a mistaken unit.
    HighStrength,
    /// A density below the range of solids, as from a mistaken unit.
    LightBody,
    /// A sphere as large as a house, as from a mistaken unit.
    LargeSphere,
    /// A measured flow curve that ends too early.
    BeyondFlowCurve,
    /// A sphere that would yield too, although the law keeps it elastic.
    SphereYields,
    /// A yielding sphere with a strength below the range of the finite elements.
    WeakSphere,
    /// A rigid sphere that yields.
    RigidFlows,
    /// Two balls that both yield and are not equal.
    UnequalBalls,
    /// Two balls of one material, of which only one has a strength.
    OneBallYields,
    /// A body that cracks or creeps where a metal would yield.
    NotAMetal,
    /// The hardness of a metal that hardens, without its exponent.
    NoExponent,
    /// A contact time that is too short for a quasi-static sphere.
    ShortContact,
    /// More radiation than a first-order estimate allows.
    StrongWaves,
    /// A plate so thick that the impact ends before the plate bends.
    ThickPlate,
    /// A plate in the range between half-space and thin plate.
    ModeratelyThickPlate,
    /// A contact as wide as the plate is thick.
    WideContactOnPlate,
    NearEdge,
    /// A plate or rod that absorbs nearly all energy, at a Zener's number above the measured ones.
    InelasticWaveguide,
    /// A plate that bends so much that it stretches.
    DeepPlate,
    /// A pulse in a rod that is too short for a one-dimensional wave.
    ShortPulseInRod,
    /// A contact that is wide against the end of a rod.
    WideContactOnRod,
    /// A rod whose far end reflects the wave during the contact.
    ShortRod,
    /// Damping so strong that hardly any energy is recovered, as from a mistaken unit.
    StiffDamping,
    /// More energy is recovered than the sphere had.
    EnergyGain,
    /// An oblique impact whose dent is so deep that the sphere ploughs.
    Ploughing,
    /// Bodies whose pressure and friction are coupled.
    DundursCoupling,
    /// A fall that air would slow, or a ball so light that air moves with it.
    InAir,
    /// A drop height far above the range of a test, as from a mistaken unit.
    HighDrop,
    /// A sphere so small and slow that adhesion matters.
    Adhesion,
    /// A key or a table of the scenario that has no effect.
    UnusedKey,
    /// A strain rate outside of the range of the constants.
    StrainRate,
    /// A test of the strength that was nearly as fast as an impact.
    DynamicTest,
    /// Constants of Cowper and Symonds for the lower yield point.
    LowerYield,
    /// An unloading exponent that is raised, because it would recover more energy than was spent.
    RaisedExponent,
    /// A published law outside the range that its authors state.
    OutsideStated,
    /// Integration and closed form disagree.
    Inaccurate,
    /// An energy balance that does not close.
    EnergyImbalance,
}

/// Above this ratio of mean pressure to yield strength, a sphere yields as fully as a half-space does at 2.9.
pub(in crate::impact) const FULL_PLASTICITY_RATIO: f64 = 2.0;

impl Warning {
    pub(crate) fn new(kind: WarningKind, size: f64, text: String) -> Self {
        Self { kind, size, text }
    }

    /// True if the result must not be used. Such a warning comes before the others.
    pub fn is_fatal(&self) -> bool {
        self.kind == WarningKind::NotAMetal
            || self.kind == WarningKind::SphereYields && self.size > FULL_PLASTICITY_RATIO
    }

    /// True if two warnings have the same meaning, so that one of them suffices. Every material may have its own warning.
    pub(crate) fn is_same_kind(&self, other: &Self) -> bool {
        let is_of_material = matches!(self.kind, WarningKind::NotAMetal | WarningKind::NoExponent);
        self.kind == other.kind && (!is_of_material || self.text == other.text)
    }

    /// Adds a warning and its position to a list that keeps the worst warning of each meaning.
    pub(crate) fn keep_worst<P>(self, worst: &mut Vec<(Self, P)>, place: impl FnOnce() -> P) {
        match worst.iter_mut().find(|(known, _)| known.is_same_kind(&self)) {
            None => worst.push((self, place())),
            Some(known) if self.size.is_nan() || self.size > known.0.size => *known = (self, place()),
            Some(_) => {}
        }
    }

    /// The warning of a key or a table without effect; `reason` states the cause, and the remedy if there is another one than to remove the key.
    pub(crate) fn unused_key(key: &str, reason: &str) -> Self {
        Self::new(WarningKind::UnusedKey, 0.0, format!("{key} has no effect: {reason}."))
    }

    pub(in crate::impact) fn new_if(
        is_doubtful: bool,
        kind: WarningKind,
        size: f64,
        text: impl FnOnce() -> String,
    ) -> Option<Self> {
        is_doubtful.then(|| Self::new(kind, size, text()))
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
