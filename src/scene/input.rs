//! The tables of one impact as they are written: every number as it is given, and nothing that follows from others.

use super::field::{Count, Fault, Number, Or, Pairs, Reader, Scalar, Special, Word, tables, text};
use super::key::Form;
use super::quantity::{
    Acceleration, Density, DropHeight, HardeningExponent, HardeningRate, HardeningSlope, Hardness, HuntCrossley,
    Length, Mass, Modulus, PoissonsRatio, Samples, Saturation, Speed, SphereModulus, Steps, Strain, Strength,
    Tolerance, Viscous,
};
use super::words::Columns;
use super::written::Node;
use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::Entry as Material;
use crate::strength::flow::{FlowCurve, FlowPoint};
use crate::units::csv_text::{CsvText, Refusal};

/// What the file and the command line say about one impact. Every key sets a value of its own here, so that the order in
/// which values are set does not matter; [`Input::resolve`] works out what follows from them.
#[derive(Debug, Clone, Default)]
pub struct Input {
    pub sphere: SphereInput,
    pub half_space: HalfSpaceInput,
    pub impact: ImpactInput,
    pub gravity: GravityInput,
    pub damping: DampingInput,
    /// The law with its parameters; [`Input::resolve`] gives it the flow curve of the half-space.
    pub law: LawChoice,
    pub solver: SolverInput,
    /// Rows of a trace.
    pub samples: Option<Count<Samples>>,
}

/// In place of the sphere's modulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid;

impl Special for Rigid {
    const WORD: &'static str = "rigid";
}

tables! {
    /// `[sphere]`
    pub struct SphereInput {
        /// Radius of the sphere (not its diameter).
        radius: Option<Number<Length>>,
        /// Diameter of the sphere, in place of the radius.
        diameter: Option<Number<Length>>,
        /// Young's modulus of the sphere, or "rigid".
        youngs_modulus: Option<Or<SphereModulus, Rigid>>,
        /// Poisson's ratio of the sphere.
        poissons_ratio: Option<Number<PoissonsRatio>>,
        /// Density of the sphere, which gives its mass.
        density: Option<Number<Density>>,
        /// Mass of all that moves with the sphere, in place of its density; for a hammer or a pendulum with a spherical tip.
        mass: Option<Number<Mass>>,
        /// Yield strength of the sphere. It only serves to warn where the sphere would yield too.
        yield_strength: Option<Number<Strength>>,
        /// Material whose numbers the sphere takes; a key that is given too replaces the number. It can be an axis.
        material: Option<&'static Material>,
    }

    /// `[half_space]`
    pub struct HalfSpaceInput {
        /// Young's modulus of the half-space.
        youngs_modulus: Option<Number<Modulus>>,
        /// Poisson's ratio of the half-space.
        poissons_ratio: Option<Number<PoissonsRatio>>,
        /// Uniaxial yield strength of the half-space; without it the contact is elastic and nothing plastic is reported.
        yield_strength: Option<Number<Strength>>,
        /// Hardness of the half-space in place of its yield strength: "300 HV", "250 HB", "45 HRC", or the mean pressure of a
        /// hardness test. The flow stress at a plastic strain of 0.08 is this pressure divided by 2.9. It is the yield
        /// strength too, unless flow_stress.power is given: then the yield strength is where that curve begins.
        hardness: Option<Number<Hardness>>,
        /// Density of the half-space; with it the energy that is radiated as elastic waves is reported.
        density: Option<Number<Density>>,
        /// Material whose numbers the half-space takes; a key that is given too replaces the number. It can be an axis.
        material: Option<&'static Material>,
        /// How the half-space hardens.
        flow_stress: FlowInput,
    }

    /// `[half_space.flow_stress]`: one of its forms.
    pub struct FlowInput {
        /// A power law.
        power: Option<PowerInput>,
        /// A stress that rises to a limit.
        voce: Option<VoceInput>,
        /// A stress that rises in a straight line.
        linear: Option<LinearInput>,
        /// Points of a measured flow curve: plastic strain and true stress; straight lines between them, constant after the
        /// last.
        points: Option<FlowPoints>,
        /// File of such points, relative to the scenario: CSV with the columns plastic_strain and stress_Pa.
        table: Option<FlowTable>,
    }

    /// σ_Y (1 + E ε/σ_Y)^N.
    pub struct PowerInput {
        /// Exponent N of the flow stress sigma_Y (1 + E strain/sigma_Y)^N of a half-space that hardens.
        exponent: Option<Number<HardeningExponent>>,
    }

    /// σ_Y (1 + b (1 − exp(−c ε))).
    pub struct VoceInput {
        /// Factor b of the flow stress sigma_Y (1 + b (1 - exp(-c strain))), which rises by b yield strengths in the end.
        saturation: Option<Number<Saturation>>,
        /// Rate c of that flow stress: how fast it rises with plastic strain.
        rate: Option<Number<HardeningRate>>,
    }

    /// σ_Y + H ε.
    pub struct LinearInput {
        /// Slope of a flow stress that rises in a straight line with plastic strain.
        slope: Option<Number<HardeningSlope>>,
    }

    /// `[impact]`
    pub struct ImpactInput {
        /// Speed of the sphere at first touch, towards the half-space.
        speed: Option<Number<Speed>>,
        /// Height that the sphere falls from, in place of the speed; with 0 it is released at first touch. Needs gravity.
        drop_height: Option<Number<DropHeight>>,
    }

    /// `[gravity]`
    pub struct GravityInput {
        /// Gravity, towards the half-space; it acts during contact too.
        acceleration: Option<Number<Acceleration>>,
    }

    /// `[damping]`
    pub struct DampingInput {
        /// Coefficient chi of the force F (1 + chi v).
        hunt_crossley: Option<Number<HuntCrossley>>,
        /// Fraction of critical damping, with the tangent stiffness of the contact; in place of hunt_crossley.
        viscous: Option<Number<Viscous>>,
    }

    /// `[solver]`
    pub struct SolverInput {
        /// Relative tolerance of the integration, on the dimensionless state.
        tolerance: Option<Number<Tolerance>> = "1e-10",
        /// Integration method; it can be an axis. auto is the closed form where there is one and no trace is asked for,
        /// else rk8.
        method: Option<Method> = "rk8; auto for tables and repeated impacts",
        /// Steps of verlet during the contact time.
        steps_per_contact: Option<Count<Steps>> = "50",
    }

    /// `[output]`
    pub struct OutputInput {
        /// Rows of a trace, evenly spaced in time; every event adds a row.
        samples: Option<Count<Samples>> = "400",
        /// Results that a table has besides the restitution.
        columns: Option<Vec<Word<Columns>>> = "all",
    }
}

/// Points of a flow curve.
#[derive(Debug, Clone)]
pub struct FlowPoints(pub FlowCurve);

impl Scalar for FlowPoints {
    fn form() -> Form {
        Pairs::<Strain, Strength>::form()
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let points = Pairs::<Strain, Strength>::read(node, reader)?.0;
        through(&points).map(Self).map_err(|message| Fault::at(node, message))
    }
}

/// The same, in a file.
#[derive(Debug, Clone)]
pub struct FlowTable(pub FlowCurve);

impl Scalar for FlowTable {
    fn form() -> Form {
        Form::Text("flow.csv")
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let [path, text] = reader.file(node, text(node, "flow.csv")?)?;
        let refused = |(line, message): Refusal| {
            let line = line.map(|line| format!(":{line}")).unwrap_or_default();
            Fault::at(node, format!("{path}{line}: {message}"))
        };
        let points = points(&text).map_err(refused)?;
        through(&points).map(Self).map_err(|message| refused((None, message)))
    }
}

const COLUMNS: [&str; 2] = ["plastic_strain", "stress_Pa"];

/// The points of a file: `plastic_strain, stress_Pa`.
fn points(text: &str) -> Result<Vec<[f64; 2]>, Refusal> {
    let table = CsvText::new(text)?;
    if table.header.iter().collect::<Vec<_>>() != COLUMNS {
        return Err((table.line, format!("its columns must be {}", COLUMNS.join(", "))));
    }
    let mut points = Vec::new();
    for row in table.rows() {
        let (line, row) = row?;
        let number = |i: usize| {
            let no_number = |_| (Some(line), format!("{} is no number, but \"{}\"", COLUMNS[i], &row[i]));
            row[i].parse::<f64>().map_err(no_number)
        };
        points.push([number(0)?, number(1)?]);
    }
    Ok(points)
}

fn through(points: &[[f64; 2]]) -> Result<FlowCurve, String> {
    let points = points.iter().map(|&[strain, stress]| FlowPoint { strain, stress });
    FlowCurve::through(points.collect::<Vec<_>>()).map_err(|error| error.to_string())
}

impl FlowInput {
    /// The names of the forms that are given.
    pub fn forms(&self) -> impl Iterator<Item = &'static str> {
        let Self { power, voce, linear, points, table } = self;
        let given = [
            power.as_ref().map(|_| "power"),
            voce.as_ref().map(|_| "voce"),
            linear.as_ref().map(|_| "linear"),
            points.as_ref().map(|_| "points"),
            table.as_ref().map(|_| "table"),
        ];
        given.into_iter().flatten()
    }

    /// The curve, if all its numbers are given.
    pub fn curve(&self) -> Option<FlowCurve> {
        if let Some(PowerInput { exponent: Some(exponent) }) = self.power {
            Some(FlowCurve::Power { exponent: exponent.into() })
        } else if let Some(VoceInput { saturation: Some(saturation), rate: Some(rate) }) = self.voce {
            Some(FlowCurve::Voce { saturation: saturation.into(), rate: rate.into() })
        } else if let Some(LinearInput { slope: Some(slope) }) = self.linear {
            Some(FlowCurve::Linear { slope: slope.into() })
        } else {
            let points = self.points.as_ref().map(|points| &points.0);
            points.or(self.table.as_ref().map(|table| &table.0)).cloned()
        }
    }
}
