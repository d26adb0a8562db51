//! Computes the rows of the cases of a plan.

use std::ops::Range;
use std::sync::OnceLock;

use crate::contact::law::LawChoice;
use crate::impact::{Contact, ImpactError, ImpactRow, WaveguideKind};
use crate::numerics::ode::IntegrationError;
use crate::results::Requirement;
use crate::scenario::input::{Body, Input, NumericKey};
use crate::scenario::keys::{HardnessRanges, Uncertainty};
use crate::scenario::plan::{Cases, Plan, SweepAxis, Variable, VariableSampler, axis_indices};
use crate::strings::named_enum;

named_enum! {
    /// The reason why a row has no numbers, with its name in the column `status`.
    pub enum RowFailure {
        /// A quantity is too large or too small for double precision.
        OutOfFloatRange = "out_of_float_range",
        /// The integrator's step underflowed.
        StepUnderflow = "step_underflow",
        /// The integrator ran out of steps.
        TooManySteps = "too_many_steps",
        /// The fixed steps are too long for the contact.
        CoarseSteps = "coarse_steps",
        /// The state was not finite.
        NotFinite = "not_finite",
        /// The case lies outside the range of the law.
        OutsideLaw = "outside_law",
        /// The moment of inertia is too small for the steps of friction.
        SmallInertia = "small_inertia",
        /// An impact on this plate is not possible.
        OutsidePlate = "outside_plate",
        /// An impact on this rod is not possible.
        OutsideRod = "outside_rod",
        /// The method is `closed_form`, but the scene has no closed form.
        NoClosedForm = "no_closed_form",
        /// A value of the row is NaN or not allowed. A scenario is refused for it; an array of Python may have such values.
        NotAllowed = "not_allowed",
    }
}

impl From<ImpactError> for RowFailure {
    fn from(error: ImpactError) -> Self {
        match error {
            ImpactError::Range(_) | ImpactError::Invalid(_) => Self::OutOfFloatRange,
            // the scenario refuses a target under gravity, one at an angle that is no ball, and a viscoelastic contact with a strain rate
            ImpactError::Law(_)
            | ImpactError::TooDeep { .. }
            | ImpactError::Hollow(_)
            | ImpactError::FreeUnderGravity
            | ImpactError::ViscoelasticRate
            | ImpactError::NoBall => Self::OutsideLaw,
            ImpactError::SmallInertia { .. } => Self::SmallInertia,
            ImpactError::Waveguide(error) => match error.kind {
                WaveguideKind::Plate => Self::OutsidePlate,
                WaveguideKind::Rod => Self::OutsideRod,
            },
            ImpactError::NoClosedForm => Self::NoClosedForm,
            ImpactError::Integration(IntegrationError::StepUnderflow { .. }) => Self::StepUnderflow,
            ImpactError::Integration(
                IntegrationError::TooManySteps { .. }
                | IntegrationError::TooManyFixedSteps { .. }
                | IntegrationError::UnsettledRate { .. }
                | IntegrationError::TooManyFrictionSteps { .. }
                | IntegrationError::Creeping { .. },
            ) => Self::TooManySteps,
            ImpactError::Integration(IntegrationError::CoarseSteps { .. }) => Self::CoarseSteps,
            ImpactError::Integration(IntegrationError::NotFinite { .. }) => Self::NotFinite,
        }
    }
}

/// The rows of consecutive cases.
#[derive(Debug, Clone, Default)]
pub struct Rows {
    /// Case numbers.
    pub cases: Vec<u64>,
    /// Swept values, case after case. On a grid each entry is the index of the value on its axis, not the value; it is an `f64` because
    /// Monte Carlo rows hold values. Yield strengths that follow from the swept values ([`Plan::derives_strength`]) are the last entries.
    pub axis_values: Vec<f64>,
    pub results: Vec<Result<ImpactRow, RowFailure>>,
}

impl Rows {
    /// No rows, with memory for `count` rows of `n_swept` swept values each.
    pub fn with_capacity(count: u64, n_swept: usize) -> Self {
        let count = usize::try_from(count).unwrap_or(0);
        Self {
            cases: Vec::with_capacity(count),
            axis_values: Vec::with_capacity(count * n_swept),
            results: Vec::with_capacity(count),
        }
    }

    /// Takes all rows away; the memory stays.
    pub fn clear(&mut self) {
        self.cases.clear();
        self.axis_values.clear();
        self.results.clear();
    }
}

/// The bodies of a row and their law.
#[derive(Debug)]
struct RowContact {
    /// The yield strengths of sphere and half-space.
    strengths: [Option<f64>; 2],
    contact: Result<Contact, RowFailure>,
    /// The uncertainty of e, if the table has columns for it.
    uncertainty: Option<Uncertainty>,
}

impl RowContact {
    /// The contact of an input under its law; `known` is this contact if it exists already.
    fn new(input: &Input, law: &LawChoice, known: Option<&Contact>, ranges: Option<&HardnessRanges>) -> Self {
        let (sphere, half_space) = input.bodies(law);
        let pair = || input.contact_of(sphere, half_space, law).map_err(RowFailure::from);
        let contact = known.cloned().map_or_else(pair, Ok);
        let uncertainty = contact
            .as_ref()
            .ok()
            .zip(ranges)
            .and_then(|(contact, ranges)| Uncertainty::new(input, contact, law, ranges));
        Self { strengths: [sphere.yield_strength, half_space.yield_strength], contact, uncertainty }
    }
}

/// The law of the rows. Rows share the law and its computed loading curve. If the law changes from row to row, every row reads its
/// law anew.
struct RowLaw {
    changes: bool,
    law: LawChoice,
    /// The ranges of hardness of the last row, if the table shows the interval of e. Rows with the same strengths share them.
    ranges: Option<HardnessRanges>,
}

impl RowLaw {
    fn new(input: &Input, changes: bool, has_interval: bool) -> Self {
        let law = input.law();
        let ranges = has_interval.then(|| HardnessRanges::new(input, &law));
        Self { changes: changes || input.has_flow_of_materials(), law, ranges }
    }

    /// The bodies of a row and their law.
    fn contact_for(&mut self, input: &Input) -> RowContact {
        if self.changes {
            self.law = input.law();
        }
        let law = &self.law;
        self.ranges = self.ranges.take().map(|ranges| ranges.with_input(input, law));
        RowContact::new(input, law, None, self.ranges.as_ref())
    }
}

/// The most contacts that are kept for the rows of a grid.
const MAX_CONTACTS: u64 = 1 << 16;

fn shows_interval(plan: &Plan) -> bool {
    plan.result_columns().iter().any(|column| column.needs == Requirement::Interval)
}

/// A plan, with the numbers that its rows have in common, computed once.
#[derive(Debug)]
pub struct Evaluator<'a> {
    plan: &'a Plan,
    /// True if the yield strengths of sphere and half-space follow from the swept values ([`Plan::derives_strength`]).
    derives_strength: [bool; 2],
    /// True if the table shows the interval of e.
    has_interval: bool,
    /// The contact of every combination of the axes that change the contact, made when its first row needs it. Empty if there
    /// are too many combinations.
    contacts: Vec<OnceLock<Box<RowContact>>>,
    /// For every axis, how far apart its neighbouring values are in `contacts`; 0 if the axis does not change the
    /// contact.
    strides: Vec<u64>,
}

impl<'a> Evaluator<'a> {
    /// An evaluator that keeps the contact of every combination, if there are at most `MAX_CONTACTS` of them. So the order
    /// of the axes hardly changes the time of a table: rows that share their contact need not follow each other.
    #[allow(clippy::cast_possible_truncation)] // at most MAX_CONTACTS
    pub fn new(plan: &'a Plan) -> Self {
        let (mut strides, mut combinations) = (Vec::new(), 1_u64);
        match &plan.cases {
            Cases::Grid(axes) => {
                for axis in axes {
                    strides.push(if axis.is_contact_constant() { 0 } else { combinations });
                    combinations = combinations.saturating_mul(if axis.is_contact_constant() { 1 } else { axis.len() });
                }
            }
            Cases::MonteCarlo { variables, .. } => {
                if variables.iter().any(|variable| variable.key.part().changes_contact()) {
                    combinations = u64::MAX;
                }
            }
        }
        let count = if combinations <= MAX_CONTACTS { combinations as usize } else { 0 };
        let contacts = std::iter::repeat_with(OnceLock::new).take(count).collect();
        Self::with_contacts(plan, contacts, strides)
    }

    /// An evaluator for [`Self::append_rows_with_values`] alone, without the contacts of a grid. `contact` is the contact of the plan, if
    /// no key changes it.
    pub fn with_contact(plan: &'a Plan, contact: Option<&Contact>) -> Self {
        let input = &plan.input;
        let law = input.law();
        let ranges = shows_interval(plan).then(|| HardnessRanges::new(input, &law));
        let row_contact =
            |contact: &Contact| OnceLock::from(Box::new(RowContact::new(input, &law, Some(contact), ranges.as_ref())));
        Self::with_contacts(plan, contact.map(row_contact).into_iter().collect(), Vec::new())
    }

    fn with_contacts(plan: &'a Plan, contacts: Vec<OnceLock<Box<RowContact>>>, strides: Vec<u64>) -> Self {
        let derives_strength = Body::ALL.map(|body| plan.derives_strength(body));
        Self { plan, derives_strength, has_interval: shows_interval(plan), contacts, strides }
    }

    /// The number of swept values of a row.
    pub fn n_axis_values(&self) -> usize {
        self.plan.varied_paths().len() + self.derives_strength.iter().filter(|is_derived| **is_derived).count()
    }

    /// The cache of the contact of these indices on the axes; `None` if contacts are not cached.
    #[allow(clippy::cast_possible_truncation)] // at most MAX_CONTACTS
    fn cached_contact(&self, places: &[u64]) -> Option<&OnceLock<Box<RowContact>>> {
        let index: u64 = places.iter().zip(&self.strides).map(|(place, stride)| place * stride).sum();
        self.contacts.get(index as usize)
    }

    /// Appends the rows of `cases`.
    pub fn append_rows(&self, cases: Range<u64>, rows: &mut Rows) {
        rows.cases.extend(cases.clone());
        match &self.plan.cases {
            Cases::Grid(axes) => self.append_grid_rows(axes, cases, rows),
            Cases::MonteCarlo { seed, variables, .. } => self.append_random_rows(variables, *seed, cases, rows),
        }
    }

    /// Appends the row of an input with this contact.
    fn append_row(&self, input: &Input, RowContact { strengths, contact, uncertainty }: &RowContact, rows: &mut Rows) {
        for (strength, is_derived) in strengths.iter().zip(self.derives_strength) {
            // a body that stays elastic has none
            rows.axis_values.extend(is_derived.then(|| strength.unwrap_or(f64::NAN)));
        }
        let row = contact.as_ref().map_err(|error| *error);
        let mut row = row.and_then(|contact| Ok(contact.row(input.approach(), &input.solver())?));
        if let (Ok(row), Ok(contact), Some(uncertainty)) = (&mut row, contact, uncertainty) {
            row.restitution_interval = uncertainty.interval_ends(contact, input.approach(), row);
        }
        rows.results.push(row);
    }

    /// Appends the rows of a grid.
    fn append_grid_rows(&self, axes: &[SweepAxis], cases: Range<u64>, rows: &mut Rows) {
        let mut places = axis_indices(axes, cases.start);
        let mut input = self.plan.input_at(&places);
        let mut own: Option<RowContact> = None;
        let mut row_law = RowLaw::new(&input, axes.iter().any(SweepAxis::changes_law), self.has_interval);
        for _ in cases {
            rows.axis_values.extend(places.iter().map(|place| *place as f64));
            let contact = match self.cached_contact(&places) {
                Some(kept) => &**kept.get_or_init(|| Box::new(row_law.contact_for(&input))),
                None => own.get_or_insert_with(|| row_law.contact_for(&input)),
            };
            self.append_row(&input, contact, rows);
            // the next combination: the last axis moves by one; when an axis starts over, the axis before it moves too
            let mut brings_values = false;
            for (axis, place) in axes.iter().zip(&mut places).rev() {
                *place = if *place + 1 == axis.len() { 0 } else { *place + 1 };
                axis.apply(*place, &mut input);
                brings_values |= axis.brings_values();
                if !axis.is_contact_constant() {
                    own = None;
                }
                if *place > 0 {
                    break;
                }
            }
            if brings_values {
                input = self.plan.input_at(&places);
            }
        }
    }

    /// Appends the rows of random cases.
    fn append_random_rows(&self, variables: &[Variable], seed: u64, cases: Range<u64>, rows: &mut Rows) {
        let mut draws: Vec<VariableSampler> = (0..)
            .zip(variables)
            .map(|(stream, variable)| VariableSampler::new(variable, seed, stream, cases.start))
            .collect();
        let keys: Vec<NumericKey> = variables.iter().map(|variable| variable.key).collect();
        self.append_each(&keys, cases, rows, |place, _, swept| {
            let value = draws[place].next_value();
            swept.push(value);
            value
        });
    }

    /// Appends the results of listed cases; every key comes with one value for each case. The keys are axes of the
    /// plan, but the values of those axes are ignored. The result of a case is the same as on a grid. Of the swept
    /// values only yield strengths that follow from the keys are appended.
    pub fn append_rows_with_values(&self, keys: &[(NumericKey, &[f64])], cases: Range<usize>, rows: &mut Rows) {
        let only_keys: Vec<NumericKey> = keys.iter().map(|(key, _)| *key).collect();
        self.append_each(&only_keys, cases, rows, |place, case, _| keys[place].1[case]);
    }

    /// Appends the rows of cases in which each of these keys has a value of its own. `value` gives that of a key, by its place, in
    /// a case, and may add it to the swept values.
    fn append_each<C: Copy>(
        &self,
        keys: &[NumericKey],
        cases: impl Iterator<Item = C>,
        rows: &mut Rows,
        mut value: impl FnMut(usize, C, &mut Vec<f64>) -> f64,
    ) {
        let mut input = self.plan.input.clone();
        let mut own: Option<RowContact> = None;
        let mut row_law = RowLaw::new(&input, keys.iter().any(|key| key.part().changes_law()), self.has_interval);
        let is_one = !keys.iter().any(|key| key.part().changes_contact());
        for case in cases {
            for (place, key) in keys.iter().enumerate() {
                let new = Some(value(place, case, &mut rows.axis_values));
                if key.part().changes_contact() && input.number(*key) != new {
                    own = None;
                }
                input.set(*key, new);
            }
            let contact = match self.contacts.first().filter(|_| is_one) {
                Some(kept) => &**kept.get_or_init(|| Box::new(row_law.contact_for(&input))),
                None => own.get_or_insert_with(|| row_law.contact_for(&input)),
            };
            self.append_row(&input, contact, rows);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::scenario::Scenario;

    /// The rows of one speed need the contacts of all radii, and the rows of the next speed find them.
    #[test]
    fn contacts_are_cached_for_any_axis_order() -> Result<(), Error> {
        let bodies = "[sphere]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\ndensity = 7850\n\
                      [half_space]\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\nyield_strength = 3e8\n[sweep]\n";
        let radii = "\"sphere.radius\" = { linspace = [1e-3, 5e-3], points = 20000 }\n";
        let speeds = "\"impact.speed\" = [1, 2]\n";
        for (axes, cases) in [([radii, speeds], [0..600, 600..1200]), ([speeds, radii], [0..600, 20_000..20_600])] {
            let plan = Scenario::from_text("s.toml", &format!("{bodies}{}", axes.concat()), &[])?.plan()?;
            let evaluator = Evaluator::new(&plan);
            let n_kept = || evaluator.contacts.iter().filter(|kept| kept.get().is_some()).count();
            let after = cases.map(|cases| {
                evaluator.append_rows(cases, &mut Rows::default());
                n_kept()
            });
            let is_inside = axes[1] == speeds;
            assert_eq!(after, if is_inside { [300, 600] } else { [600, 600] });
        }
        Ok(())
    }
}
