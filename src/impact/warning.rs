//! The warnings that a result may come with.

use thiserror::Error;

use crate::units::{Dimension, four_digits, human};

/// Lighter bodies are doubted \[kg/m³\]; cork has 120 to 240.
pub(super) const LIGHT: f64 = 100.0;
/// Larger spheres are doubted: their radius \[m\].
pub(super) const LARGE: f64 = 1.0;
/// Higher strengths are doubted, over Young's modulus; whiskers without a flaw reach a tenth.
pub(super) const HIGH: f64 = 0.1;

/// A warning. Its text says what is doubtful and what to do.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Warning {
    /// a/R beyond the data behind the law, or beyond what it takes for granted.
    #[error(
        "contact radius / sphere radius = {ratio:.3} is beyond {limit}, up to which this law holds: take forces and dent as estimates, or let the dent be shallower"
    )]
    DeepDent {
        /// a_m/R.
        ratio: f64,
        /// Largest a/R of the loading law.
        limit: f64,
    },
    /// A strength beyond that of solids, as where a unit is mistaken.
    #[error(
        "{key} = {} is more than a tenth of Young's modulus, {}, which hardly any solid reaches: check the units",
        human(*.strength, Dimension::Pressure), human(*.modulus, Dimension::Pressure)
    )]
    HighStrength {
        /// The key, with dots.
        key: &'static str,
        /// Yield strength \[Pa\].
        strength: f64,
        /// Young's modulus of the same body \[Pa\].
        modulus: f64,
    },
    /// A density below that of solids, as where a unit is mistaken.
    #[error(
        "{key} = {density} kg/m^3 is below {LIGHT} kg/m^3, lighter than cork: check the unit, such as \"7850 kg/m^3\" or \"7.85 g/cm^3\""
    )]
    LightBody {
        /// The key, with dots.
        key: &'static str,
        /// Density \[kg/m³\].
        density: f64,
    },
    /// A sphere as large as a house, as where a unit is mistaken.
    #[error("sphere.radius = {radius} m is above {LARGE} m: check the unit, such as \"5 mm\"")]
    LargeSphere {
        /// Its radius \[m\].
        radius: f64,
    },
    /// A measured flow curve that ends too early.
    #[error(
        "the flow curve ends at a plastic strain of {last}, and the contact asks for it up to {strain:.4}: beyond its last point it is taken to stay level; give points at larger strains, or let the dent be shallower"
    )]
    BeyondFlowCurve {
        /// The largest strain that was asked for.
        strain: f64,
        /// Strain of the last point.
        last: f64,
    },
    /// A flow curve with a step.
    #[error(
        "the flow stress rises by {:.0} % within 0.1 % of strain, from a plastic strain of {} on: such a step is outside of the law, and beyond it e may rise with the speed; give points of a smooth curve",
        100.0 * (ratio - 1.0), four_digits(*.strain)
    )]
    FlowStep {
        /// Where it begins.
        strain: f64,
        /// Stress behind it over the stress before.
        ratio: f64,
    },
    /// A power law of hardening that was not compared with finite elements.
    #[error(
        "the exponent of hardening {exponent} is outside of 0.1 to 0.3, the range of the finite elements behind the law: e may be off by more than 3 %; points of a measured flow curve are safer, as a power law this steep starts far below the proof stress of the metal"
    )]
    UntestedExponent {
        /// N.
        exponent: f64,
    },
    /// The sphere would yield as well.
    #[error(
        "peak mean pressure {pressure:.3e} Pa is above 1.1 x the sphere's yield strength {strength:.3e} Pa: the sphere would yield too, and less would come back"
    )]
    SphereYields {
        /// Peak mean pressure \[Pa\].
        pressure: f64,
        /// The sphere's yield strength \[Pa\].
        strength: f64,
    },
    /// Too short for a quasi-static sphere.
    #[error(
        "contact lasts {transits:.2} wave transits of the sphere (2 R / c); below 5 it is no longer quasi-static and part of the energy goes into waves"
    )]
    ShortContact {
        /// Contact time over 2 R/√(E_s/ρ_s).
        transits: f64,
    },
    /// More radiation than a first-order estimate can bear.
    #[error(
        "elastic waves take {loss:.3} of the kinetic energy, while the law gives {recovered:.3} of it back: too much for a first-order estimate; take restitution_with_waves as a rough value (0 where nothing is left)"
    )]
    StrongWaves {
        /// 2 W_rad/(m v²).
        loss: f64,
        /// e².
        recovered: f64,
    },
    /// No waves where the force jumps.
    #[error(
        "the wave loss is left out: the force of the law jumps at {} x the yield indentation, where the first-order theory makes it infinite; give the law `jumps = \"crossed\"`, or the half-space no density",
        four_digits(*.indentation)
    )]
    WavesAtJump {
        /// δ/δ_Y of the jump.
        indentation: f64,
    },
    /// A plate so thick that the impact is over before it is felt.
    #[error(
        "during the contact a wave travels only {thinness:.2} thicknesses of the plate, and below 2 the echo of its rear face comes too late: it acts as a half-space, so leave half_space.thickness out"
    )]
    ThickPlate {
        /// X.
        thinness: f64,
    },
    /// A plate between a half-space and a thin plate.
    #[error(
        "during the contact a wave travels {thinness:.1} thicknesses of the plate, and a thin plate takes at least {least}: the plate takes more energy than computed, {}",
        beyond_theory(*.thinness, *.least)
    )]
    BetweenTheories {
        /// X.
        thinness: f64,
        /// Where the theory of the plate begins to hold.
        least: f64,
    },
    /// A contact as wide as the plate is thick.
    #[error(
        "contact radius / plate thickness = {ratio:.3} is above 0.15: there the plate is stiffer under the sphere than a half-space by more than a tenth, and yields through; take the result for an estimate"
    )]
    WideContactOnPlate {
        /// a_m/h.
        ratio: f64,
    },
    /// An edge so near that it is felt.
    #[error(
        "half_space.edge_distance = {} is less than {}, from where bending waves come back during the contact: the plate may take a quarter more or less than computed",
        human(*.distance, Dimension::Length), human(*.reach, Dimension::Length)
    )]
    NearEdge {
        /// Of the edge \[m\].
        distance: f64,
        /// Of the farthest edge that is felt \[m\].
        reach: f64,
    },
    /// A plate that bends so far that it stretches.
    #[error(
        "the plate moves by {ratio:.2} of its thickness, and above 0.3 it also stretches, which makes it stiffer than computed"
    )]
    DeepPlate {
        /// w/h.
        ratio: f64,
    },
    /// A second hit gives back more than it brought.
    #[error(
        "restitution {restitution:.6} is above 1: just behind a knot of the loading curve the plastic work falls where it should rise, and a second hit gains that; take it for 1"
    )]
    EnergyGain {
        /// e.
        restitution: f64,
    },
    /// A step of an indentation that gains energy.
    #[error(
        "plastic work {work:.3e} J is below 0: just behind a knot of the loading curve the plastic work of the law falls where it should rise; take it for 0"
    )]
    PlasticGain {
        /// In the step \[J\].
        work: f64,
    },
    /// More comes back than was spent, but by less than the error of the run.
    #[error(
        "restitution {restitution:.6} is above 1, but the energy ledger is off by {drift:.1e}, so this may be an error of the run: tighten the tolerance or use another method"
    )]
    RoughRebound {
        /// e.
        restitution: f64,
        /// Largest drift.
        drift: f64,
    },
    /// An oblique impact whose dent is so deep that the sphere ploughs.
    #[error(
        "contact radius / sphere radius = {ratio:.3} at {:.0} deg from the normal: the sphere ploughs, a force of about {:.0} % of the contact force that friction leaves out; take tangential speed and spin as estimates",
        angle.to_degrees(), 100.0 * 4.0 / (3.0 * std::f64::consts::PI) * ratio
    )]
    Ploughing {
        /// a_m/R.
        ratio: f64,
        /// From the normal \[rad\].
        angle: f64,
    },
    /// Bodies whose pressure and friction act on each other.
    #[error(
        "the materials differ so much (Dundurs' beta = {mismatch:.2}) that pressure and friction act on each other, which is neglected: where the contact slips as little as here, psi_2 may be off by 0.1"
    )]
    Mismatch {
        /// Dundurs' β.
        mismatch: f64,
    },
    /// A key of the scene that has no effect.
    #[error("{key} is not used: {reason}")]
    UnusedKey {
        /// The key, with dots.
        key: &'static str,
        /// Why, and the way out.
        reason: &'static str,
    },
    /// The table of a law that no case of a sweep is under.
    #[error("law.{law} is not used: no case is under that law; name it in \"law\" of [sweep], or leave its table out")]
    UnusedLaw {
        /// Its name.
        law: &'static str,
    },
    /// A published law outside the range that its authors state.
    #[error(
        "peak indentation = {} x the yield indentation is outside {}, the range that the law is stated for: take the result for an extrapolation",
        four_digits(*.indentation), stated(*.from, *.to)
    )]
    OutsideStated {
        /// δ_m/δ_Y.
        indentation: f64,
        /// Lower end.
        from: f64,
        /// Upper end, which may be infinite.
        to: f64,
    },
    /// Integration and closed form disagree.
    #[error(
        "integration and closed form differ by {error:.1e}, more than 100 x the tolerance {tolerance:.1e}: tighten the tolerance or use another method"
    )]
    Inaccurate {
        /// The larger of the two relative errors.
        error: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// Energy is missing, or too much.
    #[error(
        "the energy ledger is off by {drift:.1e}, more than 1000 x the tolerance {tolerance:.1e}: tighten the tolerance or use another method"
    )]
    OpenLedger {
        /// Largest drift.
        drift: f64,
        /// What was asked for.
        tolerance: f64,
    },
}

/// What to do below the range of a theory of plates.
fn beyond_theory(thinness: f64, least: f64) -> &'static str {
    if least < 10.0 {
        "by 8 % at 5 thicknesses and by a third at 3"
    } else if thinness < 5.0 {
        "by half or more; half_space.plate = \"thick\" comes nearer"
    } else {
        "by a fifth at 10 thicknesses and by half at 5; half_space.plate = \"thick\" is good to 8 % of it"
    }
}

/// A range that may have no upper end.
fn stated(from: f64, to: f64) -> String {
    if to.is_finite() {
        format!("{} to {}", four_digits(from), four_digits(to))
    } else {
        format!("{} and more", four_digits(from))
    }
}
