//! Scenarios: a TOML file with units, checked while it is read, and the scene it resolves to.
//!
//! ```
//! use plm_impact::scenario::Scenario;
//!
//! let text = r#"
//!     [sphere]
//!     radius = "5 mm"
//!     youngs_modulus = "210 GPa"
//!     poissons_ratio = 0.3
//!     density = "7850 kg/m^3"
//!     [half_space]
//!     youngs_modulus = "210 GPa"
//!     poissons_ratio = 0.3
//!     yield_strength = "345 MPa"
//!     [impact]
//!     speed = "3 m/s"
//! "#;
//! let scene = Scenario::from_text("steel", text, &["impact.speed=1 m/s".to_owned()])?.resolve()?;
//! assert_eq!(scene.speed, 1.0);
//! # Ok::<(), plm_impact::scenario::ScenarioError>(())
//! ```

mod axes;
pub mod calibrate;
mod columns;
mod compare;
mod document;
mod entries;
mod error;
mod explain;
mod extreme;
mod flow;
mod forces;
pub mod indentation;
mod kind;
mod law;
mod material;
mod overrides;
mod place;
mod repeat;
mod source;
mod sweep;
mod template;
mod values;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::impact::{Solver, Warning};
use crate::material::{HalfSpace, Material};
use crate::scene::taken::Taken;
use crate::scene::{DEFAULT_SAMPLES, EITHER, KEYS, Scene};
pub use document::{Document, LARGEST_SCENARIO, read_text, text_of};
use entries::Entries;
pub use error::ScenarioError;
pub use kind::Kind;
pub use place::{Place, Refusal};
pub use template::template;

/// A scenario file, read and checked.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Its text, in which the place of a value can be found.
    pub document: Document,
    /// The values of its keys.
    entries: Entries,
    /// The values that its bodies take from named materials.
    pub taken: Vec<Taken>,
    /// The folder of the files that it names.
    directory: PathBuf,
    /// Texts of such files by their keys.
    texts: BTreeMap<&'static str, String>,
}

/// The keys that an impact needs. Another key may stand in place of one of them (see [`EITHER`]). The speed is the last.
const NEEDED: [&str; 7] = [
    "sphere.radius",
    "sphere.youngs_modulus",
    "sphere.poissons_ratio",
    "half_space.youngs_modulus",
    "half_space.poissons_ratio",
    "sphere.density",
    "impact.speed",
];

/// Why a law has no effect.
const ELASTIC: &str =
    "the half-space has no yield_strength, so the contact stays elastic; give it one, or leave the key out";

impl Scenario {
    /// Reads a scenario file, with `key=value` overrides.
    ///
    /// # Errors
    /// [`ScenarioError`], naming file, line, value, allowed range.
    pub fn load(path: &Path, overrides: &[String]) -> Result<Self, ScenarioError> {
        let text = document::read_text(path, LARGEST_SCENARIO)?;
        let directory = path.parent().unwrap_or(Path::new("")).to_owned();
        Self::new(path.display().to_string(), text, overrides, directory, BTreeMap::new())
    }

    /// Reads a scenario from a text; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_text(name: &str, text: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        Self::in_directory(name, text, overrides, PathBuf::new())
    }

    /// The same, where files that it names are relative to a directory.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn in_directory(
        name: &str,
        text: &str,
        overrides: &[String],
        directory: PathBuf,
    ) -> Result<Self, ScenarioError> {
        Self::new(name.to_owned(), text.to_owned(), overrides, directory, BTreeMap::new())
    }

    fn new(
        name: String,
        text: String,
        overrides: &[String],
        directory: PathBuf,
        texts: BTreeMap<&'static str, String>,
    ) -> Result<Self, ScenarioError> {
        let document = Document::new(name, text, overrides)?;
        let (entries, taken) = document.entries()?;
        let mut scenario = Self { document, entries, taken, directory, texts };
        scenario.check_tables()?;
        scenario.read_files()?;
        Ok(scenario)
    }

    /// Checks what every kind of scene needs: a sphere, and no two keys in place of each other.
    fn check_tables(&self) -> Result<(), ScenarioError> {
        for [one, other] in EITHER {
            if self.entries.has(one) && self.entries.has(other) {
                return Err(self.document.one_key(one, other));
            }
        }
        for table in ["gravity", "damping"] {
            if self.entries.has(table) && self.entries.keys_in(table).next().is_none() {
                let keys: Vec<&str> = KEYS.iter().map(|key| key.path).filter(|path| path.starts_with(table)).collect();
                return Err(self.document.missing_one_of(table, &keys, "; or leave the table out"));
            }
        }
        self.need(&NEEDED[..3])
    }

    /// Refuses a scenario in which one of these keys is missing. A key in place of it counts, and a key that varies
    /// over the cases of a table.
    fn need(&self, keys: &[&'static str]) -> Result<(), ScenarioError> {
        let group = |key: &&'static str| {
            EITHER.iter().find(|pair| pair[0] == *key).map_or_else(|| vec![*key], |pair| pair.to_vec())
        };
        let is_there = |path: &&str| self.entries.has(path) || self.entries.varies(path);
        let Some(group) = keys.iter().map(group).find(|group| !group.iter().any(is_there)) else {
            return Ok(());
        };
        let (table, _) = group[0].split_once('.').unwrap_or_default();
        // a body needs more keys than the one that varies, and so its table
        let in_table = |path: &&str| path.split_once('.').is_some_and(|(other, _)| other == table);
        if !self.entries.has(table) && !self.entries.varied().any(|path| table == "impact" && in_table(&path)) {
            return Err(self.document.missing("", table));
        }
        Err(self.document.missing_one_of(table, &group, ""))
    }

    /// The scene of an impact: defaults filled in, files read.
    ///
    /// # Errors
    /// [`ScenarioError`] where keys contradict each other, what an impact needs is missing, or the file of coefficients is
    /// bad.
    pub fn resolve(&self) -> Result<Scene, ScenarioError> {
        let shot = self.first_of_speeds()?;
        let mut scene = self.put_together(if shot.is_some() { NEEDED.len() - 1 } else { NEEDED.len() })?;
        if let Some(speed) = shot {
            scene.set_speed(speed);
        }
        scene.warnings = self.unused(scene.half_space.yield_strength.is_none());
        Ok(scene)
    }

    /// The bodies and the law of a scenario that needs no impact: its speed is not a number where none is given.
    pub fn resolve_bodies(&self) -> Result<Scene, ScenarioError> {
        self.put_together(NEEDED.len() - 1)
    }

    /// The scene of the keys; the first `needed` of [`NEEDED`] must be given.
    fn put_together(&self, needed: usize) -> Result<Scene, ScenarioError> {
        self.need(&NEEDED[..needed])?;
        let mut scene = self.blank()?;
        for key in KEYS {
            if let Some(value) = self.entries.number(key.path).or_else(|| self.entries.first(key.path)) {
                (key.set)(&mut scene, value);
            }
        }
        self.needs_gravity()?;
        self.refuse_waves(&scene)?;
        self.check_strength(&scene.law, Some(&scene.half_space))?;
        Ok(scene)
    }

    /// The scene before its numeric keys are set: law, method, counts and materials.
    fn blank(&self) -> Result<Scene, ScenarioError> {
        let defaults = Solver::default();
        Ok(Scene {
            solver: Solver {
                method: self.method().unwrap_or(defaults.method),
                steps_per_contact: self.entries.count("solver.steps_per_contact").unwrap_or(defaults.steps_per_contact),
                ..defaults
            },
            samples: self.samples(),
            materials: self.taken.clone(),
            ..Scene::of_law(self.law()?)
        })
    }

    /// A numeric key that the scenario gives, in SI.
    pub fn number_of(&self, path: &str) -> Option<f64> {
        self.entries.number(path)
    }

    /// The sphere's radius \[m\], by its radius or its diameter.
    pub fn sphere_radius(&self) -> Option<f64> {
        let diameter = || Some(0.5 * self.entries.number("sphere.diameter")?);
        self.entries.number("sphere.radius").or_else(diameter)
    }

    /// Rows of a trace.
    pub fn samples(&self) -> usize {
        self.entries.count("output.samples").unwrap_or(DEFAULT_SAMPLES)
    }

    /// The sphere's radius \[m\].
    fn radius(&self) -> Result<f64, ScenarioError> {
        self.sphere_radius().ok_or_else(|| self.document.missing("sphere", "radius"))
    }

    /// A number that the scene needs.
    fn number(&self, path: &str) -> Result<f64, ScenarioError> {
        let (table, name) = path.rsplit_once('.').unwrap_or(("", path));
        self.entries.number(path).ok_or_else(|| self.document.missing(table, name))
    }

    /// The sphere's material.
    fn sphere_material(&self) -> Result<Material, ScenarioError> {
        Ok(Material {
            youngs_modulus: self.number("sphere.youngs_modulus")?,
            poissons_ratio: self.number("sphere.poissons_ratio")?,
        })
    }

    /// A half-space whose keys stand in this table.
    fn half_space_in(&self, table: &str) -> Result<HalfSpace, ScenarioError> {
        let path = |name: &str| format!("{table}.{name}");
        Ok(HalfSpace {
            material: Material {
                youngs_modulus: self.number(&path("youngs_modulus"))?,
                poissons_ratio: self.number(&path("poissons_ratio"))?,
            },
            yield_strength: self.strength_in(table)?,
            density: self.entries.number(&path("density")),
        })
    }

    /// Warnings about keys of a law, which an elastic half-space does not use.
    fn unused(&self, is_elastic: bool) -> Vec<Warning> {
        const OF_PLM: [&str; 2] = ["law.plm.unloading_exponent", "law.plm.coefficients"];
        if !is_elastic {
            return Vec::new();
        }
        let of_plm = OF_PLM.into_iter().filter(|path| self.entries.has(path));
        let law = self.law_name().filter(|law| !matches!(*law, "plm" | "hertz")).map(|_| "law");
        of_plm.chain(law).map(|key| Warning::UnusedKey { key, reason: ELASTIC }).collect()
    }
}
