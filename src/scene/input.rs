//! The tables of one impact as they are written: every number as it is given, and nothing that follows from others.

use super::field::{Field, Held, show_word};
use super::key::Form::{self, Count, List, Number, NumberOr, Pair, Table, Text, Word};
use super::quantity::{
    ACCELERATION, ANGLE, DENSITY, DROP_HEIGHT, FRICTION, HARDENING_EXPONENT, HARDENING_RATE, HARDENING_SLOPE, HARDNESS,
    HUNT_CROSSLEY, LENGTH, MASS, MODULUS, MOMENT_OF_INERTIA, POISSONS_RATIO, SAMPLES, SATURATION, SPEED,
    SPHERE_MODULUS, SPIN, STEPS, STRAIN, STRENGTH, TOLERANCE, VISCOUS,
};
use super::read::{Fault, Reader, list, pair};
use super::table::tables;
use super::words::{COLUMNS, MATERIALS, METHODS, PLATES};
use super::written::Node;
use crate::impact::{Method, PlateTheory};
use crate::law::LawChoice;
use crate::materials::Entry as Material;
use crate::strength::flow::{FlowCurve, FlowPoint};
use crate::units::csv_text::{CsvText, Refusal};
use crate::units::{Dimension, human, number};

tables! {
    /// What the file and the command line say about one impact. Every key sets a value of its own here, so that the order in
    /// which values are set does not matter; [`Input::resolve`] works out what follows from them.
    pub struct Input {
        /// The sphere.
        sphere: SphereInput as Table,
        /// The half-space.
        half_space: HalfSpaceInput as Table,
        /// The impact.
        impact: ImpactInput as Table,
        /// Friction.
        friction: FrictionInput as Table,
        /// Gravity.
        gravity: GravityInput as Table,
        /// Damping.
        damping: DampingInput as Table,
        /// The contact law with its parameters; [`Input::resolve`] gives it the flow curve of the half-space.
        law: LawChoice as Table,
        /// The integration.
        solver: SolverInput as Table,
        /// Traces and tables.
        output: OutputInput as Table,
    }

    /// `[sphere]`
    pub struct SphereInput {
        /// Radius of the sphere (not its diameter).
        radius: Option<f64> as Number(&LENGTH),
        /// Diameter of the sphere, in place of the radius.
        diameter: Option<f64> as Number(&LENGTH),
        /// Young's modulus of the sphere, or "rigid".
        youngs_modulus: Option<f64> as NumberOr(&SPHERE_MODULUS, "rigid"),
        /// Poisson's ratio of the sphere.
        poissons_ratio: Option<f64> as Number(&POISSONS_RATIO),
        /// Density of the sphere, which gives its mass.
        density: Option<f64> as Number(&DENSITY),
        /// Mass of all that moves with the sphere, in place of its density; for a hammer or a pendulum with a spherical tip.
        mass: Option<f64> as Number(&MASS),
        /// Moment of inertia of all that moves with the sphere, about the sphere's centre. Needed with mass where the sphere
        /// comes in at an angle or spins.
        moment_of_inertia: Option<f64> as Number(&MOMENT_OF_INERTIA) => "of a solid sphere",
        /// Spin of the sphere before the impact, about the axis across its path; positive for rolling forward. Needs friction.
        spin: Option<f64> as Number(&SPIN) => "0",
        /// Yield strength of the sphere. It only serves to warn where the sphere would yield too.
        yield_strength: Option<f64> as Number(&STRENGTH),
        /// Material whose numbers the sphere takes; a key that is given too replaces the number. It can be an axis.
        material: Option<&'static Material> as Word(&MATERIALS),
    }

    /// `[half_space]`
    pub struct HalfSpaceInput {
        /// Young's modulus of the half-space.
        youngs_modulus: Option<f64> as Number(&MODULUS),
        /// Poisson's ratio of the half-space.
        poissons_ratio: Option<f64> as Number(&POISSONS_RATIO),
        /// Uniaxial yield strength of the half-space; without it the contact is elastic and nothing plastic is reported.
        yield_strength: Option<f64> as Number(&STRENGTH),
        /// Hardness of the half-space in place of its yield strength: "300 HV", "250 HB", "45 HRC", or the mean pressure of a
        /// hardness test. The flow stress at a plastic strain of 0.08 is this pressure divided by 2.9. It is the yield
        /// strength too, unless flow_stress.power is given: then the yield strength is where that curve begins.
        hardness: Option<f64> as Number(&HARDNESS),
        /// Density of the half-space; with it the energy that is radiated as elastic waves is reported, and bouncing loses it.
        density: Option<f64> as Number(&DENSITY),
        /// Material whose numbers the half-space takes; a key that is given too replaces the number. It can be an axis.
        material: Option<&'static Material> as Word(&MATERIALS),
        /// Thickness of a large plate in place of the half-space; needs its density. It can be an axis.
        thickness: Option<f64> as Number(&LENGTH),
        /// Distance of the plate's nearest edge. It only serves to warn where bending waves come back from it in time.
        edge_distance: Option<f64> as Number(&LENGTH),
        /// How the plate gives way: as a thin one, or with the first term of a thick one.
        plate: Option<PlateTheory> as Word(&PLATES) => "zener",
        /// How the half-space hardens.
        flow_stress: FlowInput as Table,
    }

    /// `[half_space.flow_stress]`: one of its forms.
    pub struct FlowInput {
        /// A power law.
        power: Option<PowerInput> as Table,
        /// A stress that rises to a limit.
        voce: Option<VoceInput> as Table,
        /// A stress that rises in a straight line.
        linear: Option<LinearInput> as Table,
        /// Points of a measured flow curve: plastic strain and true stress; straight lines between them, constant after the
        /// last.
        points: Option<FlowCurve> as List(&Pair(&STRAIN, &STRENGTH)),
        /// File of such points, relative to the scenario: CSV with the columns plastic_strain and stress_Pa.
        table: Option<FlowCurve> as Text("flow.csv"),
    }

    /// σ_Y (1 + E ε/σ_Y)^N.
    pub struct PowerInput {
        /// Exponent N of the flow stress sigma_Y (1 + E strain/sigma_Y)^N of a half-space that hardens; finite elements
        /// back 0.1 to 0.3, and outside of that e may be off by more than 3 %.
        exponent: Option<f64> as Number(&HARDENING_EXPONENT),
    }

    /// σ_Y (1 + b (1 − exp(−c ε))).
    pub struct VoceInput {
        /// Factor b of the flow stress sigma_Y (1 + b (1 - exp(-c strain))), which rises by b yield strengths in the end.
        saturation: Option<f64> as Number(&SATURATION),
        /// Rate c of that flow stress: how fast it rises with plastic strain.
        rate: Option<f64> as Number(&HARDENING_RATE),
    }

    /// σ_Y + H ε.
    pub struct LinearInput {
        /// Slope of a flow stress that rises in a straight line with plastic strain.
        slope: Option<f64> as Number(&HARDENING_SLOPE),
    }

    /// `[impact]`
    pub struct ImpactInput {
        /// Speed of the sphere at first touch, towards the half-space.
        speed: Option<f64> as Number(&SPEED),
        /// Height that the sphere falls from, in place of the speed: v = sqrt(2 g h), with g = 9.80665 m/s^2 unless gravity is
        /// given. With gravity it may be 0: the sphere is released at first touch.
        drop_height: Option<f64> as Number(&DROP_HEIGHT),
        /// Angle of the path from the normal of the half-space (in erosion it is often counted from the surface). The speed
        /// is then the whole speed. Needs friction.
        angle: Option<f64> as Number(&ANGLE) => "0 deg",
    }

    /// `[friction]`
    pub struct FrictionInput {
        /// Coefficient of Coulomb friction between sphere and half-space; 0 for none.
        coefficient: Option<f64> as Number(&FRICTION),
    }

    /// `[gravity]`
    pub struct GravityInput {
        /// Gravity, towards the half-space, that acts during contact and flight. A drop height alone does not need it.
        acceleration: Option<f64> as Number(&ACCELERATION),
    }

    /// `[damping]`
    pub struct DampingInput {
        /// Coefficient chi of the force F (1 + chi v).
        hunt_crossley: Option<f64> as Number(&HUNT_CROSSLEY),
        /// Fraction of critical damping, with the tangent stiffness of the contact; in place of hunt_crossley.
        viscous: Option<f64> as Number(&VISCOUS),
    }

    /// `[solver]`
    pub struct SolverInput {
        /// Relative tolerance of the integration, on the dimensionless state.
        tolerance: Option<f64> as Number(&TOLERANCE) => "1e-10",
        /// Integration method; it can be an axis. auto is the closed form where there is one and no trace is asked for,
        /// else rk8.
        method: Option<Method> as Word(&METHODS) => "rk8; auto for tables and repeated impacts",
        /// Steps of verlet during the contact time.
        steps_per_contact: Option<u64> as Count(&STEPS) => "50",
    }

    /// `[output]`
    pub struct OutputInput {
        /// Rows of a trace, evenly spaced in time; every event adds a row.
        samples: Option<u64> as Count(&SAMPLES) => "400",
        /// Results that a table has besides the restitution.
        columns: Option<Vec<String>> as List(&Word(&COLUMNS)) => "all",
    }
}

impl Input {
    /// The keys that have a value, for reports: numbers, words and counts in the order of the file.
    pub fn held(&self) -> Vec<Held> {
        let mut held = Vec::new();
        self.show(&Table, "", &mut held);
        held
    }
}

/// A flow curve through points, which stand in a list or in a file.
impl Field for Option<FlowCurve> {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let refused = |message| Fault::at(node, message);
        *self = Some(match form {
            Text(example) => {
                let [path, text] = reader.file(node, example)?;
                let at = |line: Option<u64>| line.map(|line| format!(":{line}")).unwrap_or_default();
                let points = points(&text).and_then(|points| through(&points).map_err(|message| (None, message)));
                points.map_err(|(line, message)| refused(format!("{path}{}: {message}", at(line))))?
            }
            form => {
                let items = list(node, &form.example())?;
                let points =
                    items.iter().map(|item| pair([&STRAIN, &STRENGTH], item)).collect::<Result<Vec<_>, _>>()?;
                through(&points).map_err(refused)?
            }
        });
        Ok(())
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        let Some(FlowCurve::Points(points)) = self else { return };
        let pair =
            |point: &FlowPoint| format!("{}: {}", number(point.strain), human(point.stress, Dimension::Pressure));
        show_word(points.iter().map(pair).collect::<Vec<_>>().join(", "), path, into);
    }
}

const OF_POINTS: [&str; 2] = ["plastic_strain", "stress_Pa"];

/// The points of a file: `plastic_strain, stress_Pa`.
fn points(text: &str) -> Result<Vec<[f64; 2]>, Refusal> {
    let table = CsvText::new(text)?;
    if table.header.iter().collect::<Vec<_>>() != OF_POINTS {
        return Err((table.line, format!("its columns must be {}", OF_POINTS.join(", "))));
    }
    let mut points = Vec::new();
    for row in table.rows() {
        let (line, row) = row?;
        let field = |i: usize| {
            let no_number = |_| (Some(line), format!("{} is no number, but \"{}\"", OF_POINTS[i], &row[i]));
            row[i].parse::<f64>().map_err(no_number)
        };
        points.push([field(0)?, field(1)?]);
    }
    Ok(points)
}

fn through(points: &[[f64; 2]]) -> Result<FlowCurve, String> {
    let points = points.iter().map(|&[strain, stress]| FlowPoint { strain, stress });
    FlowCurve::through(points.collect::<Vec<_>>()).map_err(|error| error.to_string())
}

impl FlowInput {
    /// The curve, if all its numbers are given.
    pub fn curve(&self) -> Option<FlowCurve> {
        if let Some(PowerInput { exponent: Some(exponent) }) = self.power {
            Some(FlowCurve::Power { exponent })
        } else if let Some(VoceInput { saturation: Some(saturation), rate: Some(rate) }) = self.voce {
            Some(FlowCurve::Voce { saturation, rate })
        } else if let Some(LinearInput { slope: Some(slope) }) = self.linear {
            Some(FlowCurve::Linear { slope })
        } else {
            self.points.as_ref().or(self.table.as_ref()).cloned()
        }
    }
}
