//! A loading curve and its two bodies: a CSV file whose comment lines give the properties of the bodies.
//!
//! ```text
//! # sphere.youngs_modulus = 208 GPa            ("rigid" is allowed)
//! # sphere.poissons_ratio = 0.3
//! # half_space.youngs_modulus = 210 GPa
//! # half_space.poissons_ratio = 0.3
//! # half_space.yield_strength = 345 MPa
//! # sphere.radius = 35 mm                      (only needed for columns in SI units)
//! indentation_m,force_N,sphere_indentation_m,contact_radius_m
//! ```
//!
//! Other comment lines are ignored. The file has one column of each kind; the contact radius is optional:
//!
//! | kind | SI | dimensionless |
//! |---|---|---|
//! | indentation | `indentation_m` | `delta_over_deltaY` |
//! | force | `force_N` | `F_over_FY` |
//! | elastic approach | `sphere_indentation_m` or `elastic_approach_m` | `delta_s_over_delta` |
//! | contact radius | `contact_radius_m` | `a_over_R` |
//!
//! Further columns are ignored.

use std::path::Path;

use super::header::Bodies;
use crate::error::Error;
use crate::material::Pair;
use crate::math::functions::ln;
use crate::scenario::read_text;
use crate::units::csv_text::{CsvText, refused, without_mark};

/// Smallest number of points beyond first yield that a curve must have.
pub const FEWEST_POINTS: usize = 8;

/// One point, in units of first yield.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadingPoint {
    /// x = δ/δ_Y.
    pub indentation: f64,
    /// f = F/F_Y.
    pub force: f64,
    /// ε = δ_e/δ_Y, with δ_e = (E_s*/E*) δ_s.
    pub elastic_approach: f64,
    /// a/a_Y, if it was given.
    pub contact_radius: Option<f64>,
}

/// A loading curve.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadingCurve {
    /// The name of the file.
    pub name: String,
    /// The bodies; the radius is 1 if the file does not give it.
    pub pair: Pair,
    /// Contact radius at first yield over radius of the sphere, a_Y/R.
    pub yield_radius_ratio: f64,
    /// The points; x and f rise from point to point.
    pub points: Vec<LoadingPoint>,
}

/// A column. Its numbers divided by `unit` are dimensionless.
#[derive(Debug, Clone, Copy)]
struct Column {
    index: usize,
    name: &'static str,
    unit: f64,
}

/// The columns of a curve.
struct Columns {
    indentation: Column,
    force: Column,
    approach: Column,
    /// Whether the approach is a share of the indentation.
    is_share: bool,
    radius: Option<Column>,
}

impl LoadingCurve {
    /// Reads a file.
    ///
    /// # Errors
    /// [`Error`] with the file, the line, what is wrong and what is needed.
    pub fn load(path: &Path) -> Result<Self, Error> {
        /// Largest file \[MiB\]: enough for a million rows.
        const LARGEST: u64 = 64;
        let text = read_text(path, LARGEST)?;
        Self::parse(&path.display().to_string(), &text)
    }

    /// Reads a curve from a text. Messages use `name` for the file.
    ///
    /// # Errors
    /// [`Error`] with the line, what is wrong and what is needed.
    pub fn parse(name: &str, text: &str) -> Result<Self, Error> {
        let refused = refused(name);
        let text = without_mark(text);
        let bodies = Bodies::read(text).map_err(refused)?;
        let table = CsvText::new(text).map_err(refused)?;
        let columns = Columns::find(&table.header, &bodies).map_err(|message| refused((table.line, message)))?;
        let mut points: Vec<LoadingPoint> = Vec::new();
        for row in table.rows() {
            let (line, record) = row.map_err(refused)?;
            let in_line = |message| refused((Some(line), message));
            let point = columns.point(&record, &bodies.pair).map_err(in_line)?;
            if let Some(last) = points.last() {
                for (column, from, to) in [
                    (columns.indentation, last.indentation, point.indentation),
                    (columns.force, last.force, point.force),
                ] {
                    if to <= from {
                        return Err(in_line(format!(
                            "{} does not rise; a loading curve does: leave out unloading, sort the points, smooth scatter",
                            column.name
                        )));
                    }
                }
            }
            points.push(point);
        }
        let beyond = points.iter().filter(|point| point.indentation > 1.0).count();
        if beyond < FEWEST_POINTS {
            let message = format!(
                "{beyond} of {} points are beyond first yield (delta/delta_Y > 1); at least {FEWEST_POINTS} are needed",
                points.len()
            );
            return Err(refused((None, message)));
        }
        Ok(Self { name: name.to_owned(), pair: bodies.pair, yield_radius_ratio: bodies.yield_radius_ratio, points })
    }

    /// The weight of each point: half the distance between its neighbours in ln x. Then equal ranges of ln x have equal
    /// weight.
    pub fn log_weights(&self) -> Vec<f64> {
        let at: Vec<f64> = self.points.iter().map(|point| ln(point.indentation)).collect();
        let end = at.len().saturating_sub(1);
        (0..at.len()).map(|i| 0.5 * (at[(i + 1).min(end)] - at[i.saturating_sub(1)])).collect()
    }
}

impl Columns {
    fn find(header: &csv::StringRecord, bodies: &Bodies) -> Result<Self, String> {
        let place = |name: &str| header.iter().position(|column| column == name);
        let one_of = |kind: &str, candidates: &[(&'static str, Option<f64>)]| -> Result<Option<Column>, String> {
            let found: Vec<(usize, &(&'static str, Option<f64>))> =
                candidates.iter().filter_map(|candidate| Some((place(candidate.0)?, candidate))).collect();
            match found[..] {
                [] => Ok(None),
                [(index, &(name, Some(unit)))] => Ok(Some(Column { index, name, unit })),
                [(_, &(name, None))] => Err(format!(
                    "the column {name} is in SI units, which needs the bodies and the radius: write # sphere.radius = 35 mm and the other keys above the columns"
                )),
                _ => Err(format!("two columns give the {kind}: keep one of {}", names(candidates))),
            }
        };
        let needed = |kind: &str, candidates: &[(&'static str, Option<f64>)]| {
            one_of(kind, candidates)?
                .ok_or_else(|| format!("no column gives the {kind}: name one {}", names(candidates)))
        };
        let [length, force, radius] = bodies.scales.map_or([None; 3], |scales| scales.map(Some));
        let of_sphere = length.map(|length| length * bodies.pair.sphere_compliance);
        let approach = needed(
            "elastic approach",
            &[
                ("delta_s_over_delta", Some(bodies.pair.sphere_compliance)),
                ("sphere_indentation_m", of_sphere),
                ("elastic_approach_m", length),
            ],
        )?;
        if approach.unit == 0.0 {
            return Err(format!(
                "{} says nothing of the elastic approach under a rigid sphere: give elastic_approach_m, the indentation that unloading recovers",
                approach.name
            ));
        }
        Ok(Self {
            indentation: needed("indentation", &[("delta_over_deltaY", Some(1.0)), ("indentation_m", length)])?,
            force: needed("force", &[("F_over_FY", Some(1.0)), ("force_N", force)])?,
            approach,
            is_share: approach.name == "delta_s_over_delta",
            radius: one_of(
                "contact radius",
                &[("a_over_R", Some(bodies.yield_radius_ratio)), ("contact_radius_m", radius)],
            )?,
        })
    }

    fn point(&self, record: &csv::StringRecord, pair: &Pair) -> Result<LoadingPoint, String> {
        let number = |column: Column| -> Result<f64, String> {
            let text = record.get(column.index).unwrap_or_default();
            let value: f64 = text.parse().map_err(|_| format!("{} = {text:?} is not a number", column.name))?;
            let scaled = value / column.unit;
            if scaled.is_normal() && scaled > 0.0 {
                Ok(scaled)
            } else {
                Err(format!("{} = {text} is not allowed: it must be a finite number above 0", column.name))
            }
        };
        let indentation = number(self.indentation)?;
        let approach = number(self.approach)?;
        let elastic_approach = if self.is_share { approach * indentation } else { approach };
        // after elastic loading the whole indentation is recovered; up to 10 % more is taken as scatter
        if elastic_approach > 1.1 * indentation {
            return Err(format!(
                "{} makes the elastic approach {:.3} times the indentation (sphere compliance E*/E_s* = {:.4}); it cannot exceed 1: check moduli and columns",
                self.approach.name,
                elastic_approach / indentation,
                pair.sphere_compliance
            ));
        }
        let contact_radius = self.radius.map(number).transpose()?;
        Ok(LoadingPoint { indentation, force: number(self.force)?, elastic_approach, contact_radius })
    }
}

fn names(candidates: &[(&'static str, Option<f64>)]) -> String {
    candidates.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(" or ")
}
