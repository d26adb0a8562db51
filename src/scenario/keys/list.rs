//! All keys of a scenario, once each: path, part, form, default in words, meaning. Parsing, "did you mean", axes, columns of tables,
//! `check`, the page of keys and the schema use this list.

use super::key_spec::ValueForm::{
    Axes, Count, File, Flag, Free, Number, NumberOr, Numbers, Points, Text, Variables, Word, WordOrTable, Words,
};
use super::quantity::{
    ACCELERATION, ANGLE, AREA, AREA_FACTOR, COVERAGE, CURVATURE, DENSITY, DEVIATION, DRAG, DROP_HEIGHT, EXPONENT,
    FACTOR, FORCE, FRICTION, HARDENING_EXPONENT, HARDENING_RATE, HARDENING_SLOPE, HARDNESS, HUNT_CROSSLEY, IMPACTS,
    INDENTATION, LEEB, LENGTH, LOAD, MASS, MASS_FLOW, MODEL_ERROR, MODULUS, MOMENT_OF_INERTIA, PADDING, POISSONS_RATIO,
    RATE_EXPONENT, RATE_SENSITIVITY, RESTITUTION, SAMPLES, SATURATION, SHARE, SHOT_SPEED, SPEED, SPHERE_MODULUS, SPIN,
    STEPS, STRAIN_RATE, STRENGTH, TIME, TOLERANCE, TRANSITION_RATIO, VISCOELASTIC_TIME, VISCOSITY, VISCOUS,
    WORK_OF_ADHESION,
};
use super::words::{
    COLUMNS, HARDNESSES, LAWS, LOADINGS, MATERIALS, METHODS, NOISES, PLATES, RATES, ROBUSTS, SPOT_MODES,
    STRENGTH_KINDS, UNLOADINGS,
};
use super::{KeySpec, Part};

macro_rules! key_specs {
    // the keys below a path, which ends in a dot or is empty
    ($table:literal; $($(#[doc = $about:literal])+ $path:literal of $part:ident: $form:expr $(=> $default:literal)?;)+) => {
        [$(KeySpec {
            path: concat!($table, $path),
            part: Part::$part,
            form: $form,
            default: concat!($($default)?),
            description: concat!($($about),+).trim_ascii_start(),
        }),+]
    };
}

/// The strength of a body, by the same keys for both bodies.
macro_rules! strength_keys {
    ($table:literal, $part:ident) => {
        key_specs! {
            $table;
            /// Uniaxial yield strength of the body. Without it the body is elastic. If both bodies have a yield strength, the
            /// softer body yields; both yield if their contact pressures at first yield differ by less than a factor of 1.25.
            "yield_strength" of $part: Number(&STRENGTH);
            /// Hardness of the body, instead of its yield strength: "300 HV", "250 HB", "45 HRC", or the mean pressure of a
            /// hardness test. It is converted to the flow stress at a plastic strain of 0.08; `check` prints the ratio. Without
            /// flow_stress.power the metal is perfectly plastic with this stress. With flow_stress.power the yield strength is the
            /// start of that curve.
            "hardness" of $part: Number(&HARDNESS);
            /// Kind of strength: "flow" is the flow stress in the impact, at a plastic strain of 0.5 to 8 %, such as a calibrated
            /// strength; "proof" is the 0.2 % proof stress of a tensile test, with which e is up to 38 % too low. The key changes
            /// only the interval of e.
            "strength_kind" of $part: Word(&STRENGTH_KINDS);
            /// Exponent N of the flow stress sigma_Y (1 + E strain/sigma_Y)^N of a metal that strain-hardens. Validated for N = 0.1
            /// to 0.3; outside, the error of e may exceed 3 %.
            "flow_stress.power.exponent" of Flow: Number(&HARDENING_EXPONENT);
            /// Factor b of the flow stress sigma_Y (1 + b (1 - exp(-c strain))); the stress saturates at (1 + b) sigma_Y.
            "flow_stress.voce.saturation" of Flow: Number(&SATURATION);
            /// Rate c of this flow stress: how fast the stress rises with plastic strain.
            "flow_stress.voce.rate" of Flow: Number(&HARDENING_RATE);
            /// Slope of a flow stress that rises linearly with plastic strain.
            "flow_stress.linear.slope" of Flow: Number(&HARDENING_SLOPE);
            /// Points of a measured flow curve: plastic strain and true stress. The stress is linear between points, and constant
            /// after the last point.
            "flow_stress.points" of Flow: Points;
            /// File of points of a flow curve, relative to the scenario: CSV with the columns plastic_strain and stress_Pa.
            "flow_stress.table" of Flow: File("flow.csv");
            /// Strain-rate dependence of the strength, under the law plm: a table, or "material" for the johnson_cook.c of the
            /// material of the body, if c is known.
            "rate" of Rate: WordOrTable(&RATES);
            /// c of Johnson and Cook's factor 1 + c ln(rate/reference) of the strength.
            "rate.johnson_cook.c" of Rate: Number(&RATE_SENSITIVITY);
            /// Strain rate at which the factor of Johnson and Cook is 1. Below this rate the factor is less than 1.
            "rate.johnson_cook.reference" of Rate: Number(&STRAIN_RATE) => "1 1/s";
            /// D of Cowper and Symonds' factor 1 + (rate/D)^(1/q) of the strength.
            "rate.cowper_symonds.rate" of Rate: Number(&STRAIN_RATE);
            /// q of the factor of Cowper and Symonds.
            "rate.cowper_symonds.exponent" of Rate: Number(&RATE_EXPONENT);
            /// Strain rate of the test that gave the strength, the flow curve or the hardness.
            "rate.tested_at" of Rate: Number(&STRAIN_RATE) => "0.001 1/s";
        }
    };
}

/// The quantities that can be measured, by the same keys in two tables. `$rest` ends each description.
macro_rules! measured_keys {
    ($table:literal, $rest:literal, $restitution:ident, $leeb:ident) => {
        key_specs! {
            $table;
            #[doc = " Coefficient of restitution"]
            #[doc = $rest]
            "restitution" of Kind: Number(&$restitution);
            #[doc = " Rebound speed"]
            #[doc = $rest]
            "rebound_speed" of Kind: Number(&SPEED);
            #[doc = " Rebound height"]
            #[doc = $rest]
            "rebound_height" of Kind: Number(&LENGTH);
            #[doc = " Time from this first contact to the next"]
            #[doc = $rest]
            "bounce_interval" of Kind: Number(&TIME);
            #[doc = " Leeb hardness: 1000 times the restitution"]
            #[doc = $rest]
            "leeb" of Kind: Number(&$leeb);
            #[doc = " Diameter of the dent"]
            #[doc = $rest]
            "dent_diameter" of Kind: Number(&LENGTH);
            #[doc = " Depth of the dent"]
            #[doc = $rest]
            "dent_depth" of Kind: Number(&LENGTH);
            #[doc = " Contact time"]
            #[doc = $rest]
            "contact_time" of Kind: Number(&TIME);
            #[doc = " Peak force"]
            #[doc = $rest]
            "peak_force" of Kind: Number(&FORCE);
        }
    };
}

/// The parts of the list, in the order of the reference page.
const PARTS: [&[KeySpec]; 9] = [
    &SPHERE_KEYS,
    &strength_keys!("sphere.", Sphere),
    &HALF_SPACE_KEYS,
    &strength_keys!("half_space.", HalfSpace),
    &OTHER_KEYS,
    &measured_keys!(
        "calibrate.noise.",
        ": standard deviation, unless the data have a column of standard deviations.",
        DEVIATION,
        DEVIATION
    ),
    &CURVE_NOISE,
    &measured_keys!(
        "calibrate.measured.",
        ", measured in the impact of the scenario; replaces data.",
        RESTITUTION,
        LEEB
    ),
    &INDENTATION_KEYS,
];

/// The number of keys.
const COUNT: usize = {
    let (mut part, mut count) = (0, 0);
    while part < PARTS.len() {
        count += PARTS[part].len();
        part += 1;
    }
    count
};

/// All keys, in the order of the reference page.
pub const ALL_KEYS: &[KeySpec] = &{
    let mut all = [SPHERE_KEYS[0]; COUNT];
    let (mut part, mut place, mut next) = (0, 0, 0);
    while part < PARTS.len() {
        if place == PARTS[part].len() {
            (part, place) = (part + 1, 0);
        } else {
            all[next] = PARTS[part][place];
            (place, next) = (place + 1, next + 1);
        }
    }
    all
};

/// The sphere, except for its strength.
const SPHERE_KEYS: [KeySpec; 11] = key_specs! {
    "";
    /// Radius of the sphere (not its diameter).
    "sphere.radius" of Sphere: Number(&LENGTH);
    /// Diameter of the sphere, instead of its radius.
    "sphere.diameter" of Sphere: Number(&LENGTH);
    /// Young's modulus of the sphere, or "rigid".
    "sphere.youngs_modulus" of Sphere: NumberOr(&SPHERE_MODULUS, "rigid");
    /// Poisson's ratio of the sphere.
    "sphere.poissons_ratio" of Sphere: Number(&POISSONS_RATIO);
    /// Density of the sphere; the mass follows from it.
    "sphere.density" of Motion: Number(&DENSITY);
    /// Total moving mass, instead of the density; for a hammer or a pendulum with a spherical tip.
    "sphere.mass" of Motion: Number(&MASS);
    /// Moment of inertia of all moving parts about the centre of the sphere. Required with mass if the sphere has an angle or a
    /// spin.
    "sphere.moment_of_inertia" of Motion: Number(&MOMENT_OF_INERTIA) => "of a solid sphere";
    /// Spin of the sphere before the impact, about the axis across its path: positive for rolling forward (topspin), negative for
    /// backspin. Requires [friction].
    "sphere.spin" of Approach: Number(&SPIN) => "0";
    /// Spin before the impact about the direction of the path along the surface: positive if clockwise, seen from behind. Friction
    /// then drives the sphere to the right. Requires [friction].
    "sphere.spin_about_path" of Approach: Number(&SPIN) => "0";
    /// Spin before the impact about the normal: positive if counterclockwise, seen from above. The impact does not change this spin.
    /// Requires [friction].
    "sphere.spin_about_normal" of Approach: Number(&SPIN) => "0";
    /// Material of the sphere from the library. Other keys of this table override single properties. The material can be an axis.
    "sphere.material" of Sphere: Word(&MATERIALS);
};

/// The half-space, except for its strength.
const HALF_SPACE_KEYS: [KeySpec; 11] = key_specs! {
    "";
    /// Young's modulus of the half-space.
    "half_space.youngs_modulus" of HalfSpace: Number(&MODULUS);
    /// Poisson's ratio of the half-space.
    "half_space.poissons_ratio" of HalfSpace: Number(&POISSONS_RATIO);
    /// Radius of curvature of the target: positive for a ball or a convex wall, negative for a hollow (at least twice the radius of
    /// the sphere).
    "half_space.radius" of HalfSpace: Number(&CURVATURE) => "flat";
    /// Mass of a free target that is at rest before the impact, or "ball" for a solid ball of the target's radius and density.
    "half_space.mass" of Motion: NumberOr(&MASS, "ball") => "fixed";
    /// Density of the half-space. With the density, the energy radiated as elastic waves is computed, and a series of impacts loses
    /// this energy.
    "half_space.density" of Motion: Number(&DENSITY);
    /// Material of the half-space from the library. Other keys of this table override single properties. The material can be an
    /// axis.
    "half_space.material" of HalfSpace: Word(&MATERIALS);
    /// Thickness of a large plate that replaces the half-space; requires half_space.density. The thickness can be an axis.
    "half_space.thickness" of Motion: Number(&LENGTH);
    /// Distance of the nearest edge of the plate. Used only for a warning about bending waves that the edge reflects.
    "half_space.edge_distance" of Motion: Number(&LENGTH);
    /// Model of the plate: "zener" for a thin plate, "thick" with the first correction for a thick plate.
    "half_space.plate" of Motion: Word(&PLATES) => "zener";
    /// Diameter of a long round rod that replaces the half-space and is hit at its end (Hopkinson bar); requires half_space.density. The
    /// diameter can be an axis.
    "half_space.rod_diameter" of Motion: Number(&LENGTH);
    /// Length of the rod. Used only for a warning about the wave that the far end reflects.
    "half_space.rod_length" of Motion: Number(&LENGTH);
};

const OTHER_KEYS: [KeySpec; 54] = key_specs! {
    "";
    /// Impact speed: speed of the sphere at first contact, towards the half-space. With an angle, the magnitude of the velocity.
    "impact.speed" of Approach: Number(&SPEED);
    /// Drop height, instead of the speed: v = sqrt(2 g h), with g = 9.80665 m/s^2 unless gravity is given. With gravity the drop
    /// height may be 0: the sphere is released at first contact.
    "impact.drop_height" of Approach: Number(&DROP_HEIGHT);
    /// Angle of the path from the normal of the half-space (in erosion the angle is often counted from the surface). Requires
    /// [friction].
    "impact.angle" of Approach: Number(&ANGLE) => "0 deg";
    /// Coefficient of Coulomb friction between sphere and half-space; 0 for none.
    "friction.coefficient" of Approach: Number(&FRICTION);
    /// Gravitational acceleration, towards the half-space, during contact and flight. Not required for a drop height.
    "gravity.acceleration" of Forces: Number(&ACCELERATION);
    /// Density of the air during fall and rise; 1.2 kg/m^3 is usual. Buoyancy is included.
    "air.density" of Forces: Number(&DENSITY);
    /// Drag coefficient in flight, about 0.5 for a smooth sphere; or "sphere": by the Reynolds number (Schiller and Naumann), which
    /// requires air.viscosity.
    "air.drag" of Forces: NumberOr(&DRAG, "sphere");
    /// Viscosity of the air, for drag = "sphere".
    "air.viscosity" of Forces: Number(&VISCOSITY);
    /// Coefficient chi of the force F (1 + chi v).
    "damping.hunt_crossley" of Forces: Number(&HUNT_CROSSLEY);
    /// Fraction of critical damping, with the tangent stiffness of the contact; instead of hunt_crossley.
    "damping.viscous" of Forces: Number(&VISCOUS);
    /// Time A of a viscoelastic contact, for polymers and rubber: the force is F + A F' v with the slope F' of the law. Fit A to one
    /// measured rebound. Instead of hunt_crossley.
    "damping.viscoelastic_time" of Forces: Number(&VISCOELASTIC_TIME);
    /// Work of adhesion per contact area, for small particles: the results are the sticking speed and the restitution with adhesion.
    /// N/m is the same unit.
    "adhesion.work" of Forces: Number(&WORK_OF_ADHESION);
    /// Coverage of the surface by the dents of random impacts, as a fraction: 0.98 is full coverage in shot peening. The results are
    /// impacts, mass and time for this coverage.
    "peening.coverage" of Peening: Number(&COVERAGE);
    /// Mass of shot that hits the area per time.
    "peening.mass_flow" of Peening: Number(&MASS_FLOW);
    /// Area that the shot hits.
    "peening.area" of Peening: Number(&AREA);
    /// Time of peening, for the coverage after this time. Requires mass_flow and area.
    "peening.time" of Peening: Number(&TIME);
    /// Exponent of the unloading force. "pressure-shape" (recommended) follows from the contact pressure at maximum compression:
    /// the error of e against finite elements is 1.0 % (rms) and 3.1 % at most. With 1.5, the value of the paper, e is 3.0 % too
    /// low on average. Other numbers are for comparison only.
    "law.plm.unloading_exponent" of Law: NumberOr(&EXPONENT, "pressure-shape") => "1.5";
    /// File of coefficients of the loading curve, relative to the scenario.
    "law.plm.coefficients" of Law: File("my.toml") => "built in";
    /// Contact pressure at which the linear part of the loading begins.
    "law.thornton.yield_pressure" of Law: Number(&STRENGTH) => "largest Hertz pressure at first yield";
    /// Mean contact pressure at first yield over the yield strength.
    "law.stronge.yield_pressure_ratio" of Law: Number(&FACTOR) => "1.1";
    /// Factor f_u of the recovered indentation.
    "law.stronge.unloading_factor" of Law: Number(&FACTOR) => "1";
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.jackson_green.yield_factor" of Law: Number(&FACTOR) => "1.295 exp(0.736 nu)";
    /// Formula of the geometric hardness: exponential is that of 2005, cosine the later one.
    "law.jackson_green.hardness" of Law: Word(&HARDNESSES) => "\"exponential\"";
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.kogut_etsion.yield_factor" of Law: Number(&FACTOR) => "(0.454 + 0.41 nu) x 2.8";
    /// Largest Hertz pressure at first yield over the yield strength.
    "law.yigit_christoforou.yield_factor" of Law: Number(&FACTOR) => "2 sqrt(0.68) = 1.649";
    /// Hardness over the yield strength.
    "law.ma_liu.hardness_ratio" of Law: Number(&FACTOR) => "2.8";
    /// Indentation at full plasticity over indentation at first yield.
    "law.ma_liu.transition_ratio" of Law: Number(&TRANSITION_RATIO) => "110";
    /// Pile-up factor: true contact area over the area in which the sphere intersects the original surface.
    "law.mesarovic_johnson.area_factor" of Law: Number(&AREA_FACTOR) => "1.43";
    /// Stiffness of loading, in units of force over indentation at first yield.
    "law.walton_braun.loading_stiffness" of Law: Number(&FACTOR) => "1";
    /// Loading stiffness over unloading stiffness; the restitution is the square root of this ratio.
    "law.walton_braun.stiffness_ratio" of Law: Number(&SHARE) => "0.5";
    /// Mean contact pressure during loading.
    "law.johnson.dynamic_pressure" of Law: Number(&STRENGTH) => "3 yield strengths";
    /// Law of the loading.
    "law.combined.loading" of Law: Word(&LOADINGS);
    /// Law of the unloading.
    "law.combined.unloading" of Law: Word(&UNLOADINGS);
    /// Relative tolerance of the integration, on the dimensionless state.
    "solver.tolerance" of Solver: Number(&TOLERANCE) => "1e-10";
    /// Integration method; it can be an axis. auto is the closed form if one exists and no trace is required, otherwise rk8.
    "solver.method" of Solver: Word(&METHODS) => "rk8; auto for tables and repeated impacts";
    /// Steps of verlet during the contact time.
    "solver.steps_per_contact" of Solver: Count(&STEPS) => "50";
    /// Number of rows of the trace, evenly spaced in time, plus one row for every event.
    "output.samples" of Output: Count(&SAMPLES) => "400";
    /// Time from sample to sample of the force of a single impact, in pulse.csv, with its spectrum in spectrum.csv.
    "output.pulse.step" of Output: Number(&TIME);
    /// Length of the pulse with zeros behind it over the contact time; the length is raised to a power of two. Without the key the
    /// spectrum has the padding 8, and pulse.csv has no zeros.
    "output.pulse.padding" of Output: Count(&PADDING);
    /// Columns of a table, in addition to the restitution.
    "output.columns" of Output: Words(&COLUMNS) => "all";
    /// Results to draw: over the axes of a table, or as histograms of random cases.
    "output.picture" of Output: Words(&COLUMNS) => "restitution";
    /// Also write the trace of every row of a [sweep] to `traces.csv`, and draw all forces in one picture; for at most 12 rows.
    "output.traces" of Output: Flag => "false";
    /// Sweep axes: keys with lists or ranges of values. All combinations are computed; the first axis varies slowest.
    "sweep" of Kind: Axes;
    /// Random cases: samples, seed, and keys with distributions.
    "monte_carlo" of Kind: Variables;
    /// "same": every impact hits the same dent. "fresh": every impact hits undamaged surface.
    "repeat.spot" of Kind: Word(&SPOT_MODES);
    /// Maximum number of impacts.
    "repeat.impacts" of Kind: Count(&IMPACTS);
    /// Bouncing ends before an impact that is slower than this speed.
    "repeat.until.speed" of Kind: Number(&SPEED);
    /// Given impact speeds, instead of [impact] and impacts.
    "repeat.speeds" of Kind: Numbers(&SHOT_SPEED);
    /// File of measurements (CSV), relative to the scenario.
    "calibrate.data" of Kind: File("drops.csv");
    /// One or two numeric keys to fit, each with its range and, if needed, its scale.
    "calibrate.free" of Kind: Free => "the yield strength of the half-space, or of the sphere if only the sphere yields, from 1e-5 to 0.1 of Young's modulus; if the scenario gives a hardness, the hardness over the same range of strengths";
    /// Treatment of outliers: "student-t" fits with Student's distribution with 4 degrees of freedom; "none" with the normal
    /// distribution.
    "calibrate.robust" of Kind: Word(&ROBUSTS) => "\"none\"";
    /// Other laws to fit; the laws are ranked.
    "calibrate.laws" of Kind: Words(&LAWS) => "none";
    /// Standard deviations of the measurements; or "estimate": from the scatter about the fitted law.
    "calibrate.noise" of Kind: WordOrTable(&NOISES) => "columns `_sd` of the data, else \"estimate\"";
    /// Relative model error of each value, independent between values; added in quadrature.
    "calibrate.noise.model" of Kind: Number(&MODEL_ERROR) => "0";
};

/// Noise of an indentation curve, which is no measurement of an impact.
const CURVE_NOISE: [KeySpec; 1] = key_specs! {
    "";
    /// Force of an indentation curve; its standard deviation, where the data have no column for it.
    "calibrate.noise.force" of Kind: Number(&FORCE);
};

const INDENTATION_KEYS: [KeySpec; 6] = key_specs! {
    "";
    /// Load at which the step ends.
    "indentation.steps[].load" of Kind: Number(&LOAD);
    /// Indentation at which the step ends, instead of the load.
    "indentation.steps[].indentation" of Kind: Number(&INDENTATION);
    /// Name of the material in tables and pictures.
    "indentation.half_space[].name" of Kind: Text("Ti-10Nb");
    /// Young's modulus of this half-space.
    "indentation.half_space[].youngs_modulus" of Kind: Number(&MODULUS);
    /// Poisson's ratio of this half-space.
    "indentation.half_space[].poissons_ratio" of Kind: Number(&POISSONS_RATIO);
    /// Yield strength of this half-space. Without it the half-space is elastic.
    "indentation.half_space[].yield_strength" of Kind: Number(&STRENGTH);
};
