//! The tables of a scenario file, each as a type. The doc comment of a key is its line on the reference page and in the
//! schema.

use super::axes::RandomKeys;
use crate::plan::axis::Axis;
use crate::plan::free::Free;
use crate::repeat::Place;
use crate::scene::Input;
use crate::scene::field::Field as _;
use crate::scene::key::AnyKey;
use crate::scene::key::Form::{self, Axes, Count, Items, List, Number, Table, Text, Variables, Word, WordOrTable};
use crate::scene::measured::{Deviations, MeasuredInput};
use crate::scene::quantity::{IMPACTS, INDENTATION, LOAD, MODULUS, POISSONS_RATIO, SHOT_SPEED, SPEED, STRENGTH};
use crate::scene::read::{Reader, items};
use crate::scene::table::{self, Table as _, tables};
use crate::scene::words::{LAWS, NOISES, ROBUSTS, SPOTS};
use crate::scene::written::Node;

tables! {
    /// The tables of a scenario besides those of one impact.
    pub(super) struct Tables {
        /// Axes of a table: keys with lists or ranges of values; the first varies slowest.
        sweep: Option<Vec<Axis>> as Axes,
        /// Random cases: samples, seed, and keys with distributions.
        monte_carlo: Option<RandomKeys> as Variables,
        /// Impacts one after the other.
        repeat: Option<RepeatInput> as Table,
        /// Keys that are found from measurements.
        calibrate: Option<CalibrateInput> as Table,
        /// Loads and indentations without any impact.
        indentation: Option<IndentationInput> as Table,
    }

    /// `[repeat]`
    pub(super) struct RepeatInput {
        /// Where repeated impacts hit: same is in the dent of the impacts before, fresh is on new surface every time.
        spot: Option<Place> as Word(&SPOTS),
        /// Largest number of impacts.
        impacts: Option<u64> as Count(&IMPACTS),
        /// When bouncing ends.
        until: Option<UntilInput> as Table,
        /// Speed of every shot, in place of [impact] and impacts.
        speeds: Option<Vec<f64>> as List(&Number(&SHOT_SPEED)),
    }

    /// `[repeat.until]`
    pub(super) struct UntilInput {
        /// Bouncing ends before an impact that would be slower than this.
        speed: Option<f64> as Number(&SPEED),
    }

    /// `[calibrate]`
    pub(super) struct CalibrateInput {
        /// File of measurements (CSV), relative to the scenario.
        data: Option<String> as Text("drops.csv"),
        /// One or two numeric keys to find, each with its range and, if needed, its scale.
        free: Option<Vec<Free>> as Form::Free => "half_space.yield_strength, from 1e-5 to 0.1 of the modulus; or half_space.hardness where that is given, 2.9 times as high",
        /// What is done about outliers: student-t has the long tails of Student's distribution with 4 degrees of freedom.
        robust: Option<String> as Word(&ROBUSTS) => "\"none\"",
        /// Other laws to fit; all laws are ranked.
        laws: Option<Vec<String>> as List(&Word(&LAWS)) => "none",
        /// Standard deviations of the measurements, or estimate: they are found from the scatter about the fitted law.
        noise: Option<Deviations> as WordOrTable(&NOISES) => "columns `_sd` of the data, else \"estimate\"",
        /// The measurements themselves.
        measured: Option<MeasuredInput> as Table,
    }

    /// `[indentation]`
    pub(super) struct IndentationInput {
        /// Where the steps end.
        steps: Option<Vec<StepInput>> as Items(STEPS, STEP),
        /// Half-spaces, each with a name.
        half_space: Option<Vec<SpecimenInput>> as Items(SPECIMENS, "a table with a name"),
    }

    /// A step of an indentation.
    pub(super) struct StepInput {
        /// Load at which the step ends.
        load: Option<f64> as Number(&LOAD),
        /// Indentation at which the step ends, in place of the load.
        indentation: Option<f64> as Number(&INDENTATION),
    }
}

/// How steps of an indentation are written.
pub(super) const STEPS: &str = "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]";
const SPECIMENS: &str = "[[indentation.half_space]] with a name";
const STEP: &str = "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }";

tables! {
    /// `[[indentation.half_space]]`
    pub(super) struct SpecimenInput {
        /// Name of the material in tables and pictures.
        name: Option<String> as Text("Ti-10Nb"),
        /// Young's modulus of this half-space.
        youngs_modulus: Option<f64> as Number(&MODULUS),
        /// Poisson's ratio of this half-space.
        poissons_ratio: Option<f64> as Number(&POISSONS_RATIO),
        /// Yield strength of this half-space; without the key it stays elastic.
        yield_strength: Option<f64> as Number(&STRENGTH),
    }
}

/// Reads all tables of a scenario. What is refused stays with the reader.
pub(super) fn read(root: &Node, reader: &mut Reader) -> (Input, Tables) {
    let (mut input, mut tables) = (Input::default(), Tables::default());
    if let Ok(all) = items(root) {
        let others = input.read_known(all, reader);
        let unknown = tables.read_known(others, reader);
        reader.unknown(unknown, &[Input::names(), Tables::names()].concat());
    }
    (input, tables)
}

/// The numbers that a table gives, by their names in alphabetical order.
pub(super) fn numbers<T: table::Table>(table: Option<&T>) -> Vec<(String, f64)> {
    let Some(table) = table else { return Vec::new() };
    let fields = T::names().into_iter().zip(table.fields());
    let mut all: Vec<_> = fields.filter_map(|(name, field)| Some((name.to_owned(), field.given()?))).collect();
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all
}

/// Every key of a scenario, in the order of the reference page.
pub fn every_key() -> impl Iterator<Item = AnyKey> {
    static ALL: std::sync::LazyLock<Vec<AnyKey>> = std::sync::LazyLock::new(|| {
        let mut all = Vec::new();
        Input::default().keys("", &[], &mut all);
        Tables::default().keys("", &[], &mut all);
        all
    });
    ALL.iter().copied()
}
