//! The comment lines of a loading curve that give the properties of its bodies.

use crate::material::{HalfSpace, Material, Pair};
use crate::scene::Key;
use crate::units::csv_text::Refusal;
use crate::units::nearest::did_you_mean;

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
/// Tokens of the comment line with ratios.
const RATIOS: [&str; 4] = ["E'=", "E'_s=", "E'_h=", "a_Y/R="];

/// The values in the comment lines.
#[derive(Debug, Default)]
pub(super) struct Header {
    keys: [Option<f64>; KEYS.len()],
    ratios: Option<[f64; RATIOS.len()]>,
}

/// The two bodies of a curve.
#[derive(Debug)]
pub(super) struct Bodies {
    pub pair: Pair,
    /// Contact radius at first yield over radius of the sphere, a_Y/R.
    pub yield_radius_ratio: f64,
    /// δ_Y \[m\], F_Y \[N\] and a_Y \[m\], if the radius is known.
    pub scales: Option<[f64; 3]>,
}

impl Header {
    pub(super) fn read(text: &str) -> Result<Self, Refusal> {
        let mut header = Self::default();
        for (line, comment) in (1..).zip(text.lines()).filter_map(|(i, line)| Some((i, line.strip_prefix('#')?))) {
            header.take(comment).map_err(|message| (Some(line), message))?;
        }
        Ok(header)
    }

    fn take(&mut self, comment: &str) -> Result<(), String> {
        if let Some((key, value)) = comment.split_once('=') {
            let (key, value) = (key.trim(), value.trim().trim_matches('"'));
            if let Some(index) = KEYS.iter().position(|known| *known == key)
                && let Some(Key { quantity, word, .. }) = Key::find(key)
            {
                let number = if *word == Some(value) {
                    f64::INFINITY
                } else {
                    quantity.parse(value).map_err(|error| format!("{key}: {error}"))?
                };
                if self.keys[index].replace(number).is_some() {
                    return Err(format!("{key} is given twice"));
                }
                return Ok(());
            }
            let is_key = (key.starts_with("sphere.") || key.starts_with("half_space.")) && !key.contains(' ');
            if is_key {
                let hint = did_you_mean(key, KEYS, '`', &format!("keys are {}", KEYS.join(", ")));
                return Err(format!("unknown key `{key}`{hint}"));
            }
        }
        let found = RATIOS.map(|token| comment.split_whitespace().find_map(|word| word.strip_prefix(token)));
        if found.iter().all(Option::is_some) {
            let mut ratios = [0.0; RATIOS.len()];
            for ((ratio, token), text) in ratios.iter_mut().zip(RATIOS).zip(found.into_iter().flatten()) {
                let value: Option<f64> = text.parse().ok();
                *ratio = value
                    .filter(|value| value.is_normal() && *value > 0.0)
                    .ok_or_else(|| format!("{token}{text} is not allowed: it must be a finite number above 0"))?;
            }
            let [e_star, of_sphere, of_half_space, _] = ratios;
            // the moduli in the file are rounded to six digits
            let sum = e_star / of_sphere + e_star / of_half_space;
            if (sum - 1.0).abs() > 1e-4 {
                return Err(format!("the moduli contradict each other: E'/E'_s + E'/E'_h = {sum:.5}, which must be 1"));
            }
            self.ratios = Some(ratios);
        }
        Ok(())
    }

    /// The two bodies. Keys are used before ratios.
    pub(super) fn bodies(&self) -> Result<Bodies, Refusal> {
        let refuse = |message: String| (None, message);
        if let [Some(of_sphere), Some(nu_sphere), Some(of_half_space), Some(nu_half_space), Some(strength), radius] =
            self.keys
        {
            let material = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
            let half_space = HalfSpace {
                material: material(of_half_space, nu_half_space),
                yield_strength: Some(strength),
                density: None,
            };
            let pair = Pair::try_new(radius.unwrap_or(1.0), &material(of_sphere, nu_sphere), &half_space)
                .map_err(|error| refuse(error.to_string()))?;
            let point = pair.yield_point.ok_or_else(|| refuse("the half-space does not yield".to_owned()))?;
            let scales = radius.map(|_| [point.indentation, point.force, point.contact_radius]);
            return Ok(Bodies { pair, yield_radius_ratio: point.contact_radius / pair.radius, scales });
        }
        if self.keys.iter().any(Option::is_some) || self.ratios.is_none() {
            let missing: Vec<&str> = KEYS
                .iter()
                .zip(self.keys)
                .take(NEEDED)
                .filter(|(_, value)| value.is_none())
                .map(|(key, _)| *key)
                .collect();
            return Err(refuse(format!(
                "the comment lines do not say {}: write lines such as `# half_space.yield_strength = 345 MPa` above the columns",
                missing.join(", ")
            )));
        }
        let [effective_modulus, of_sphere, of_half_space, yield_radius_ratio] = self.ratios.unwrap_or([1.0; 4]);
        let pair = Pair {
            radius: 1.0,
            effective_modulus,
            sphere_compliance: effective_modulus / of_sphere,
            half_space_compliance: effective_modulus / of_half_space,
            yield_point: None,
        };
        Ok(Bodies { pair, yield_radius_ratio, scales: None })
    }
}
