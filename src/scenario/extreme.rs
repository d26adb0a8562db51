//! Which number of a scenario is so large or small that a result leaves double precision.

use super::Scenario;
use crate::error::Error;
use crate::material::OutOfFloatRange;
use crate::math::functions::log10;
use crate::scene::quantity::Quantity;
use crate::scene::{KEYS, Key};
use crate::units::{number, si};

/// A number is extreme if it is more powers of ten than this away from the example of its quantity.
const FAR: f64 = 20.0;

impl Scenario {
    /// The refusal of the number that is farthest from ordinary ones, where it stands; `None` where no number is extreme.
    pub fn too_extreme(&self, range: &OutOfFloatRange) -> Option<Error> {
        let given = KEYS.iter().filter(|key| self.document.has(key.path));
        let values = given.filter_map(|key| Some((key, key.get(&self.input)?)));
        let distances = values.filter_map(|(key, value)| Some((key, value, decades(value, key.quantity)?)));
        let distances = distances.filter(|(.., decades)| *decades > FAR);
        let (Key { path, quantity, .. }, value, _) = distances.max_by(|a, b| a.2.total_cmp(&b.2))?;
        let message = format!(
            "{} is the most extreme number here: {} = {} cannot be held in double precision; choose a less extreme one, such as {}",
            si(value, quantity.dimension),
            range.quantity,
            number(range.value),
            quantity.example
        );
        Some(self.document.refuse(path, message))
    }
}

/// How many powers of ten a value is from the example of its quantity; `None` for 0.
fn decades(value: f64, quantity: &Quantity) -> Option<f64> {
    let decades = (log10(value.abs()) - log10(quantity.example_value()?)).abs();
    decades.is_finite().then_some(decades)
}
