//! The tables of a scenario file, each as a type. The doc comment of a key is its line on the reference page and in the
//! schema.

use super::axes::RandomKeys;
use crate::plan::axis::Axis;
use crate::plan::free::Free;
use crate::repeat::Place;
use crate::scene::field::{
    Count, Example, Fault, Given, Items, Listed, Number, Reader, Scalar, Table, Text, Word, tables, word,
};
use crate::scene::input::{
    DampingInput, GravityInput, HalfSpaceInput, ImpactInput, Input, OutputInput, SolverInput, SphereInput,
};
use crate::scene::key::{AnyKey, Form, List};
use crate::scene::laws::LawInput;
use crate::scene::quantity::{
    DepthRatio, Deviation, Energy, Force, Impacts, Indentation, Leeb, Length, Load, ModelError, Modulus, PoissonsRatio,
    Restitution, ShotSpeed, Speed, Strength, Time,
};
use crate::scene::words::{Laws, NOISES, OwnUnloadings, Robusts};
use crate::scene::written::{Node, Value};

tables! {
    /// A scenario, as it is written.
    pub(super) struct File {
        /// The sphere.
        sphere: SphereInput,
        /// The half-space.
        half_space: HalfSpaceInput,
        /// The impact.
        impact: ImpactInput,
        /// Gravity.
        gravity: GravityInput,
        /// Damping.
        damping: DampingInput,
        /// The contact law.
        law: LawInput,
        /// The integration.
        solver: SolverInput,
        /// Traces and tables.
        output: OutputInput,
        /// Axes of a table: keys with lists or ranges of values; the first varies slowest.
        sweep: Option<Vec<Axis>>,
        /// Random cases: samples, seed, and keys with distributions.
        monte_carlo: Option<RandomKeys>,
        /// Impacts one after the other.
        repeat: Option<RepeatInput>,
        /// Unloading laws from one peak.
        compare: Option<CompareInput>,
        /// Keys that are found from measurements.
        calibrate: Option<CalibrateInput>,
        /// Loads and indentations without any impact.
        indentation: Option<IndentationInput>,
    }

    /// `[repeat]`
    pub(super) struct RepeatInput {
        /// Where repeated impacts hit: same is in the dent of the impacts before, fresh is on new surface every time.
        spot: Option<Place>,
        /// Largest number of impacts.
        impacts: Option<Count<Impacts>>,
        /// When bouncing ends.
        until: Option<UntilInput>,
        /// Speed of every shot, in place of [impact] and impacts.
        speeds: Option<Vec<Number<ShotSpeed>>>,
    }

    /// `[repeat.until]`
    pub(super) struct UntilInput {
        /// Bouncing ends before an impact that would be slower than this.
        speed: Option<Number<Speed>>,
    }

    /// `[compare]`
    pub(super) struct CompareInput {
        /// Peak indentation over that at first yield.
        peak_indentation_ratio: Option<Number<DepthRatio>>,
        /// Peak indentation, in place of the ratio.
        peak_indentation: Option<Number<Length>>,
        /// Force at the peak, where it was measured.
        peak_force: Option<Number<Force>> = "of the PLM",
        /// Contact radius at the peak, where it was measured.
        peak_contact_radius: Option<Number<Length>> = "of the PLM",
        /// The sphere's own indentation at the peak, where it was measured.
        peak_sphere_indentation: Option<Number<Length>> = "of the PLM",
        /// Work of loading up to the peak.
        spent_work: Option<Number<Energy>> = "of the PLM",
        /// Laws to compare, in the order of table and picture.
        laws: Option<Vec<Word<OwnUnloadings>>> = "all but walton_braun",
    }
}

/// A file of measurements.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Drops;

impl Example for Drops {
    const EXAMPLE: &'static str = "drops.csv";
}

tables! {
    /// `[calibrate]`
    pub(super) struct CalibrateInput {
        /// File of measurements (CSV), relative to the scenario.
        data: Option<Text<Drops>>,
        /// One or two numeric keys to find, each with its range and, if needed, its scale.
        free: Option<Vec<Free>> = "half_space.yield_strength, from 1e-5 to 0.1 of the modulus; or half_space.hardness where that is given, 2.9 times as high",
        /// What is done about outliers: student-t has the long tails of Student's distribution with 4 degrees of freedom.
        robust: Option<Word<Robusts>> = "\"none\"",
        /// Other laws to fit; all laws are ranked.
        laws: Option<Vec<Word<Laws>>> = "none",
        /// Standard deviations of the measurements, or estimate: they are found from the scatter about the fitted law.
        noise: Option<NoiseInput> = "columns `_sd` of the data, else \"estimate\"",
        /// The measurements themselves.
        measured: Option<MeasuredInput>,
    }
}

/// `calibrate.noise`: a word, or a table.
#[derive(Debug, Clone)]
pub(super) enum NoiseInput {
    /// "estimate".
    Estimate,
    /// Standard deviations.
    Given(Deviations),
}

impl Scalar for NoiseInput {
    fn form() -> Form {
        Form::WordOrTable(&NOISES, Deviations::keys)
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        match node.value {
            Value::Table(_) => <Deviations as Scalar>::read(node, reader).map(Self::Given),
            _ => word(&NOISES, node).map(|_| Self::Estimate),
        }
    }
}

tables! {
    /// `[calibrate.noise]`
    pub(super) struct Deviations {
        /// Error of the law as a share of each value, added in quadrature, independent from value to value.
        model: Option<Number<ModelError>> = "0",
        /// Standard deviation of this measurement, where the data have no column for it.
        restitution: Option<Number<Deviation>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        rebound_speed: Option<Number<Speed>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        rebound_height: Option<Number<Length>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        leeb: Option<Number<Deviation>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        dent_diameter: Option<Number<Length>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        dent_depth: Option<Number<Length>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        contact_time: Option<Number<Time>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        peak_force: Option<Number<Force>>,
        /// Standard deviation of this measurement, where the data have no column for it.
        force: Option<Number<Force>>,
    }

    /// `[calibrate.measured]`
    pub(super) struct MeasuredInput {
        /// Rebound speed over impact speed, measured in the impact of the scenario: in place of data.
        restitution: Option<Number<Restitution>>,
        /// Speed of the rebound, measured in the impact of the scenario: in place of data.
        rebound_speed: Option<Number<Speed>>,
        /// Height of the rebound, measured in the impact of the scenario: in place of data.
        rebound_height: Option<Number<Length>>,
        /// Leeb hardness: 1000 times the restitution, measured in the impact of the scenario: in place of data.
        leeb: Option<Number<Leeb>>,
        /// Diameter of the dent's rim, measured in the impact of the scenario: in place of data.
        dent_diameter: Option<Number<Length>>,
        /// Depth of the dent, measured in the impact of the scenario: in place of data.
        dent_depth: Option<Number<Length>>,
        /// Time in contact, measured in the impact of the scenario: in place of data.
        contact_time: Option<Number<Time>>,
        /// Largest force, measured in the impact of the scenario: in place of data.
        peak_force: Option<Number<Force>>,
    }

    /// `[indentation]`
    pub(super) struct IndentationInput {
        /// Where the steps end.
        steps: Items<StepInput>,
        /// Half-spaces, each with a name.
        half_space: Items<SpecimenInput>,
    }

    /// A step of an indentation.
    pub(super) struct StepInput {
        /// Load at which the step ends.
        load: Option<Number<Load>>,
        /// Indentation at which the step ends, in place of the load.
        indentation: Option<Number<Indentation>>,
    }
}

impl Listed for StepInput {
    const LIST: &'static List = &List {
        example: "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]",
        item: "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }",
    };
}

/// The name of a half-space.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Name;

impl Example for Name {
    const EXAMPLE: &'static str = "Ti-10Nb";
}

tables! {
    /// `[[indentation.half_space]]`
    pub(super) struct SpecimenInput {
        /// Name of the material in tables and pictures.
        name: Option<Text<Name>>,
        /// Young's modulus of this half-space.
        youngs_modulus: Option<Number<Modulus>>,
        /// Uncertainty of the modulus: half of the width of its interval.
        youngs_modulus_uncertainty: Option<Number<Modulus>> = "none",
        /// Poisson's ratio of this half-space.
        poissons_ratio: Option<Number<PoissonsRatio>>,
        /// Yield strength of this half-space; without the key it stays elastic.
        yield_strength: Option<Number<Strength>>,
        /// Uncertainty of the strength: half of the width of its interval.
        yield_strength_uncertainty: Option<Number<Strength>> = "none",
    }
}

impl Listed for SpecimenInput {
    const LIST: &'static List =
        &List { example: "[[indentation.half_space]] with a name", item: "a table with a name" };
}

impl File {
    /// The tables of one impact.
    pub(super) fn input(&self) -> Input {
        let Self { sphere, half_space, impact, gravity, damping, law, solver, output, .. } = self.clone();
        Input { sphere, half_space, impact, gravity, damping, law: law.choice, solver, samples: output.samples }
    }
}

/// The numbers that a table gives, by their names in alphabetical order.
pub(super) fn numbers<T: Table>(table: Option<&T>) -> Vec<(String, f64)> {
    let Some(table) = table else { return Vec::new() };
    let number = |name: &str, given| match given {
        Some(Given::Number(value)) => Some((name.to_owned(), value)),
        _ => None,
    };
    let mut all: Vec<_> = T::ENTRIES.iter().filter_map(|entry| number(entry.name, (entry.get)(table))).collect();
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all
}

/// Every key of a scenario, in the order of the reference page.
pub fn every_key() -> impl Iterator<Item = AnyKey> {
    static ALL: std::sync::LazyLock<Vec<AnyKey>> = std::sync::LazyLock::new(|| {
        let mut all = Vec::new();
        File::keys("", &mut all);
        all
    });
    ALL.iter().copied()
}

/// The list of tables of that path.
pub fn list_of(path: &str) -> Option<&'static List> {
    match path {
        "indentation.steps" => Some(StepInput::LIST),
        "indentation.half_space" => Some(SpecimenInput::LIST),
        _ => None,
    }
}
