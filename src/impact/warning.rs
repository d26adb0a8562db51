//! The warnings that a result may come with.

use std::fmt;

/// A warning. Its text says what is doubtful and what to do.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    pub kind: WarningKind,
    /// How doubtful it is, comparable within its kind: of several the largest counts, and not a number most of all.
    pub size: f64,
    text: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WarningKind {
    /// a/R beyond the data behind the law, or beyond what it takes for granted.
    DeepDent,
    /// A strength beyond that of solids, as where a unit is mistaken.
    HighStrength,
    /// A density below that of solids, as where a unit is mistaken.
    LightBody,
    /// A sphere as large as a house, as where a unit is mistaken.
    LargeSphere,
    /// A measured flow curve that ends too early.
    BeyondFlowCurve,
    /// The sphere would yield as well.
    SphereYields,
    /// A sphere that flows at a strength below those of the finite elements.
    WeakSphere,
    /// A sphere without elastic strain that flows.
    RigidFlows,
    /// Two balls that both flow and are not equal.
    UnequalBalls,
    /// Two balls of one material, of which only one has a strength.
    OneBallYields,
    /// A body that cracks or creeps where a metal would yield.
    NoMetal,
    /// The hardness of a metal that hardens, without its exponent.
    NoExponent,
    /// Too short for a quasi-static sphere.
    ShortContact,
    /// More radiation than a first-order estimate can bear.
    StrongWaves,
    /// A plate so thick that the impact is over before it is felt.
    ThickPlate,
    /// A plate between a half-space and a thin plate.
    BetweenTheories,
    /// A contact as wide as the plate is thick.
    WideContactOnPlate,
    NearEdge,
    /// A plate that takes nearly all, at a Zener's number beyond those that were measured.
    InelasticPlate,
    /// A plate that bends so far that it stretches.
    DeepPlate,
    /// Damping so strong that next to nothing comes back, as where a unit is mistaken.
    StiffDamping,
    /// More comes back than was brought.
    EnergyGain,
    /// An oblique impact whose dent is so deep that the sphere ploughs.
    Ploughing,
    /// Bodies whose pressure and friction act on each other.
    Mismatch,
    /// A fall that air would slow, or a ball so light that air moves with it.
    InAir,
    /// A drop height far above that of a test, as where a unit is mistaken.
    HighDrop,
    /// A sphere so small and slow that adhesion counts.
    Adhesion,
    /// A key or a table of the scenario that has no effect.
    Unused,
    /// A strain rate outside of those that the constants are known for.
    StrainRate,
    /// A test of the strength that was nearly as fast as an impact.
    FastTest,
    /// Constants of Cowper and Symonds for the lower yield point.
    LowerYield,
    /// An exponent of unloading that is not kept, because it would give back more than was spent.
    RaisedExponent,
    /// A published law outside the range that its authors state.
    OutsideStated,
    /// Integration and closed form disagree.
    Inaccurate,
    /// Energy is missing, or too much.
    OpenLedger,
}

/// Beyond this mean pressure over its yield strength a sphere yields as far as a half-space does at 2.9.
pub(super) const FULLY: f64 = 2.0;

impl Warning {
    pub(crate) fn new(kind: WarningKind, size: f64, text: String) -> Self {
        Self { kind, size, text }
    }

    /// True if the result is not to be used at all. Such a warning comes before the others.
    pub fn is_grave(&self) -> bool {
        self.kind == WarningKind::NoMetal || self.kind == WarningKind::SphereYields && self.size > FULLY
    }

    /// True if two warnings have the same meaning, so that one of them is enough. Every material may have its own warning.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let is_of_material = matches!(self.kind, WarningKind::NoMetal | WarningKind::NoExponent);
        self.kind == other.kind && (!is_of_material || self.text == other.text)
    }

    /// Puts a warning and its place into a list that keeps the worst of each meaning.
    pub(crate) fn keep_worst<P>(self, worst: &mut Vec<(Self, P)>, place: impl FnOnce() -> P) {
        match worst.iter_mut().find(|(known, _)| known.is_like(&self)) {
            None => worst.push((self, place())),
            Some(known) if self.size.is_nan() || self.size > known.0.size => *known = (self, place()),
            Some(_) => {}
        }
    }

    /// The warning of a key or a table without effect; `reason` says why, and the way out.
    pub(crate) fn unused(key: &str, reason: &str) -> Self {
        Self::new(WarningKind::Unused, 0.0, format!("{key} is not used: {reason}"))
    }

    pub(super) fn when(is_doubtful: bool, kind: WarningKind, size: f64, text: impl FnOnce() -> String) -> Option<Self> {
        is_doubtful.then(|| Self::new(kind, size, text()))
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
