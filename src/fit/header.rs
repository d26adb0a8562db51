//! The comment lines of a loading curve that give the properties of its bodies.

use crate::material::{HalfSpace, Material, Pair};
use crate::scene::Key;
use crate::units::csv_text::{Refusal, keys_in_comments};

/// Keys of a scenario that a comment line may give.
const KEYS: [&str; 6] = [
    "sphere.youngs_modulus",
    "sphere.poissons_ratio",
    "half_space.youngs_modulus",
    "half_space.poissons_ratio",
    "half_space.yield_strength",
    "sphere.radius",
];
/// Number of keys, from the first on, that dimensionless columns need.
const NEEDED: usize = 5;
/// The two bodies of a curve.
#[derive(Debug)]
pub(super) struct Bodies {
    pub pair: Pair,
    /// Contact radius at first yield over radius of the sphere, a_Y/R.
    pub yield_radius_ratio: f64,
    /// δ_Y \[m\], F_Y \[N\] and a_Y \[m\], if the radius is known.
    pub scales: Option<[f64; 3]>,
}

impl Bodies {
    /// The bodies that the comment lines of a text give.
    ///
    /// # Errors
    /// [`Refusal`] for a bad value, an unknown key, and a key that is missing.
    pub(super) fn read(text: &str) -> Result<Self, Refusal> {
        let mut values = [None; KEYS.len()];
        for (line, key, value) in keys_in_comments(text, &KEYS)? {
            let refuse = |message: String| (Some(line as u64), message);
            let (Some(place), Some(Key { quantity, word, .. })) =
                (KEYS.iter().position(|known| *known == key), Key::find(key))
            else {
                continue;
            };
            let number = if *word == Some(value) { Ok(f64::INFINITY) } else { quantity.parse(value) };
            let number = number.map_err(|error| refuse(format!("{key}: {error}")))?;
            if values[place].replace(number).is_some() {
                return Err(refuse(format!("{key} is given twice")));
            }
        }
        let refuse = |message: String| (None, message);
        let [Some(of_sphere), Some(nu_sphere), Some(of_half_space), Some(nu_half_space), strength @ Some(_), radius] =
            values
        else {
            let needed = KEYS.iter().zip(values).take(NEEDED).filter(|(_, value)| value.is_none());
            let missing: Vec<&str> = needed.map(|(key, _)| *key).collect();
            return Err(refuse(format!(
                "the comment lines do not say {}: write lines such as `# half_space.yield_strength = 345 MPa` above the columns",
                missing.join(", ")
            )));
        };
        let material = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
        let half_space =
            HalfSpace { material: material(of_half_space, nu_half_space), yield_strength: strength, density: None };
        let pair = Pair::try_new(radius.unwrap_or(1.0), &material(of_sphere, nu_sphere), &half_space)
            .map_err(|error| refuse(error.to_string()))?;
        let point = pair.yield_point.ok_or_else(|| refuse("the half-space does not yield".to_owned()))?;
        let scales = radius.map(|_| [point.indentation, point.force, point.contact_radius]);
        Ok(Self { pair, yield_radius_ratio: point.contact_radius / pair.radius, scales })
    }
}
