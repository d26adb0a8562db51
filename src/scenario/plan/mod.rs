//! The cases of a table: the varied keys, their values, and the results that the table shows.

pub(crate) mod axis;
pub mod free_key;
pub(crate) mod random;
pub(in crate::scenario) mod read_axes;
pub(in crate::scenario) mod varied;

use super::Kind;
use super::input::{Body, Input, NumericKey};
use super::keys::body_key;
use super::rules::effect::Facts;
use crate::impact::{Method, Warning};
use crate::results::{PEENING_MEANS, RESTITUTION, Requirement, ResultColumn, result_columns};
pub(crate) use axis::{AxisSetting, AxisValues, AxisWord, SweepAxis};
pub use free_key::FreeKey;
pub(crate) use random::{Distribution, Variable, VariableSampler};

/// The source of the cases.
#[derive(Debug, Clone)]
pub enum Cases {
    /// All combinations of the axes; the first varies slowest.
    Grid(Vec<SweepAxis>),
    MonteCarlo {
        samples: u64,
        seed: u64,
        variables: Vec<Variable>,
    },
}

/// A sweep: an input and its varied keys.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The input with the first value of every axis, or with the medians of random keys. All cases share its other keys.
    pub input: Input,
    /// Warnings about keys without effect.
    pub warnings: Vec<Warning>,
    pub cases: Cases,
    /// Names of the results in the table; `None`: all.
    pub columns: Option<Vec<&'static str>>,
    /// Names of the results in pictures; `None`: the results that suit the first axis.
    pub pictures: Option<Vec<&'static str>>,
    /// True if the trace of every row is written too.
    pub has_traces: bool,
}

/// Maximum number of rows of a table with traces: a reader can distinguish this number of curves in a picture.
pub const MAX_TRACES: u64 = 12;

/// Maximum number of cases. Every tool can represent a case number of this size.
pub const MAX_CASES: u64 = 1 << 63;

impl Plan {
    /// The cases of an input in which every varied key has its first value or its median.
    pub fn new(input: &Input, cases: Cases) -> Self {
        let mut plan = Self {
            input: input.clone(),
            warnings: Vec::new(),
            cases,
            columns: None,
            pictures: None,
            has_traces: false,
        };
        plan.input = plan.input_at(&vec![0; plan.axes().len()]);
        plan
    }

    /// The axes; empty for random cases.
    pub fn axes(&self) -> &[SweepAxis] {
        if let Cases::Grid(axes) = &self.cases { axes } else { &[] }
    }

    /// The number of cases, or `u64::MAX` for more than can be counted. More than [`MAX_CASES`] are refused while the
    /// scenario is read.
    pub fn n_cases(&self) -> u64 {
        match &self.cases {
            Cases::Grid(axes) => axes.iter().map(SweepAxis::len).fold(1, u64::saturating_mul),
            Cases::MonteCarlo { samples, .. } => *samples,
        }
    }

    /// The input of the case at these indices on the axes.
    pub fn input_at(&self, places: &[u64]) -> Input {
        let mut input = self.input.clone();
        apply_axes(self.axes(), places, &mut input);
        input
    }

    /// The columns of the swept values, and of yield strengths that follow from them.
    pub fn axis_columns(&self) -> Vec<String> {
        let derived = self.derived_bodies().map(Body::yield_strength);
        let column =
            |path: &str| NumericKey::find(path).map_or_else(|| path.replace('.', "_"), NumericKey::column_name);
        self.varied_paths().into_iter().chain(derived).map(column).collect()
    }

    /// The bodies whose yield strength follows from values that vary.
    pub fn derived_bodies(&self) -> impl Iterator<Item = Body> {
        Body::ALL.into_iter().filter(|body| self.derives_strength(*body))
    }

    /// True if the yield strength of a body follows from varied values: from a hardness, given or from the material, and then also
    /// from the moduli and the hardening exponent.
    pub fn derives_strength(&self, body: Body) -> bool {
        let paths = self.varied_paths();
        let varies = |path: &str| paths.contains(&path);
        self.input.number(body_key!(body, "hardness")).is_some()
            && (varies(body.material()) || body.strength_numbers().into_iter().any(|number| varies(number.path())))
    }

    pub fn result_columns(&self) -> Vec<ResultColumn> {
        let is_wanted = |name| self.columns.as_ref().is_none_or(|columns| columns.contains(&name));
        let (inputs, varied) = (self.inputs_of_word_axes(), self.varied_paths());
        let facts = self.facts(&inputs, &varied);
        let all = result_columns().into_iter();
        all.filter(|column| is_wanted(column.name) && facts.why_no_column(column.needs).is_none()).collect()
    }

    /// The columns whose distribution is reported, the restitution first: the columns that the scenario names among its columns or
    /// pictures, and in shot peening the columns whose means give the coverage. Empty if nothing is random.
    pub fn statistics_columns(&self) -> Vec<ResultColumn> {
        if !self.is_monte_carlo() {
            return Vec::new();
        }
        let named = [&self.columns, &self.pictures];
        let is_named = |name| {
            PEENING_MEANS.contains(&name)
                || named.iter().any(|names| names.as_ref().is_some_and(|names| names.contains(&name)))
        };
        let mut all: Vec<ResultColumn> = self.result_columns();
        all.retain(|column| column.name == RESTITUTION || is_named(column.name));
        all.sort_by_key(|column| column.name != RESTITUTION);
        all
    }

    /// Why a table lacks a column with this requirement; `None` if the table has it.
    pub fn column_refusal(&self, needs: Requirement) -> Option<&'static str> {
        self.facts(&self.inputs_of_word_axes(), &self.varied_paths()).why_no_column(needs)
    }

    fn facts<'a>(&self, inputs: &'a [Input], varied: &'a [&'static str]) -> Facts<'a> {
        Facts { inputs, kind: if self.is_monte_carlo() { Kind::MonteCarlo } else { Kind::Sweep }, varied }
    }

    pub fn column_names(&self) -> Vec<String> {
        let results = self.result_columns().into_iter().map(|column| column.name.to_owned());
        std::iter::once("case".to_owned())
            .chain(self.axis_columns())
            .chain(results)
            .chain(["status".to_owned()])
            .collect()
    }

    /// The varied keys.
    pub fn varied_paths(&self) -> Vec<&'static str> {
        match &self.cases {
            Cases::Grid(axes) => axes.iter().map(SweepAxis::path).collect(),
            Cases::MonteCarlo { variables, .. } => variables.iter().map(|variable| variable.key.path()).collect(),
        }
    }

    /// A varied key without effect on the table, and the reason.
    pub fn unused_axis(&self) -> Option<(&'static str, String)> {
        let (paths, inputs) = (self.varied_paths(), self.inputs_of_word_axes());
        let (has_laws, facts) = (paths.contains(&"law"), self.facts(&inputs, &paths));
        paths.iter().find_map(|path| {
            let problem = if has_laws && path.starts_with("law.") && !path.starts_with("law.plm.") {
                "cannot vary together with \"law\". Give the key in the table of its law.".to_owned()
            } else {
                format!("has no effect: {}.", facts.why_unused(path)?)
            };
            Some((*path, problem))
        })
    }

    /// The inputs under all laws and methods of the axes, with the first values of the other axes.
    pub fn inputs_of_word_axes(&self) -> Vec<Input> {
        let mut all = vec![self.input_at(&vec![0; self.axes().len()])];
        for axis in
            self.axes().iter().filter(|axis| matches!(axis.word_values(), [AxisWord::Law(_) | AxisWord::Method(_), ..]))
        {
            let with = |input: &Input, place| {
                let mut input = input.clone();
                axis.apply(place, &mut input);
                input
            };
            all = all.iter().flat_map(|input| (0..axis.len()).map(move |place| with(input, place))).collect();
        }
        all
    }

    /// Inputs that differ from the input of the plan in one varied key: values along a whole axis, or over a whole distribution. Rows
    /// share a value only if it is equal in all these inputs.
    pub fn with_other_values(&self) -> Vec<Input> {
        const MAX_VALUES: u64 = 16;
        match &self.cases {
            Cases::Grid(axes) => {
                let other_values = |(number, axis): (usize, &SweepAxis)| {
                    let (last, count) = (axis.len() - 1, axis.len().min(MAX_VALUES));
                    let at = move |i: u64| {
                        let mut places = vec![0; axes.len()];
                        // an axis may have 2^63 values; in this form the product does not overflow
                        places[number] = last / (count - 1) * i + last % (count - 1) * i / (count - 1);
                        self.input_at(&places)
                    };
                    (1..count).map(at).collect::<Vec<_>>()
                };
                axes.iter().enumerate().flat_map(other_values).collect()
            }
            Cases::MonteCarlo { variables, .. } => {
                let with = |variable: &Variable, share: f64| {
                    let mut input = self.input.clone();
                    input.set(variable.key, Some(variable.value(share)));
                    input
                };
                let shares = [0.001, 0.25, 0.75, 0.999];
                variables.iter().flat_map(|variable| shares.map(|share| with(variable, share))).collect()
            }
        }
    }

    fn methods(&self) -> Vec<Method> {
        self.inputs_of_word_axes().iter().map(|input| input.solver().method).collect()
    }

    /// True if a case has the method `closed_form`, but no closed form.
    pub fn lacks_closed_form(&self) -> bool {
        let mut input = self.input.clone();
        for key in
            self.varied_paths().into_iter().filter(|path| path.starts_with("damping.")).filter_map(NumericKey::find)
        {
            // a swept damping may begin at 0
            input.set(key, Some(1.0));
        }
        let chosen = |method: Method| method.resolve(&input.forces(), false);
        self.methods().into_iter().map(chosen).any(|method| method.is_none())
    }

    /// About the microseconds of a row on one core, for the slowest of its methods.
    pub fn row_time_us(&self) -> f64 {
        let of_case = |input: &Input| {
            // with partial slip
            let friction = if input.is_oblique() { 150.0 } else { 0.0 };
            let solver = input.solver();
            friction
                + match solver.method {
                    Method::Verlet => 0.05 * f64::from(solver.steps_per_contact),
                    Method::Dopri5 | Method::Dop853 => 32.0,
                    _ if input.is_integrated() => 8.0,
                    _ => 0.25,
                }
        };
        self.inputs_of_word_axes().iter().map(of_case).fold(0.25, f64::max)
    }

    pub fn is_monte_carlo(&self) -> bool {
        matches!(self.cases, Cases::MonteCarlo { .. })
    }
}

/// Sets the values of all axes in an input. Laws and materials are set first: they set keys that numeric axes then override.
pub fn apply_axes(axes: &[SweepAxis], places: &[u64], input: &mut Input) {
    for is_word in [true, false] {
        for (axis, place) in axes.iter().zip(places).filter(|(axis, _)| axis.word_values().is_empty() != is_word) {
            axis.apply(*place, input);
        }
    }
}

pub fn axis_indices(axes: &[SweepAxis], case: u64) -> Vec<u64> {
    let mut rest = case;
    let mut places: Vec<u64> = Vec::new();
    for axis in axes.iter().rev() {
        places.push(rest % axis.len());
        rest /= axis.len();
    }
    places.reverse();
    places
}
