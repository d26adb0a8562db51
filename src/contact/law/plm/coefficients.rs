//! The coefficients of the PLM: a table of data, the check of it, and the law that follows from it for a pair of bodies.

use std::borrow::Cow;
use std::fmt::Debug;
use std::sync::{Arc, LazyLock};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::approach::{ApproachPolyline, ApproachSlopes};
use super::contact_radius::RadiusTable;
use super::depth::{Depth, DepthTable};
use super::poisson::{PoissonTable, pressure_ratio, squared_positions};
use super::unloading_rule::{PlmUnloadingRule, ValidityTable};
use crate::contact::law::{Law, LawError, UnloadingExponent};
use crate::contact::pair::Pair;
use crate::numerics::curve::{Cached, LoadingCurve};

/// Where a set of coefficients comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoefficientSource {
    /// Short name, reported with every result.
    pub name: String,
    pub source: String,
    pub accuracy: String,
    pub range: String,
}

/// Knots and slopes of the force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceTable {
    /// x at which each straight piece begins; rising, the first ≥ 1.
    pub from: Vec<f64>,
    /// df/dx at κ = 0; > 0.
    pub slope: Vec<f64>,
    /// The slope is `slope` + κ² × this.
    pub slope_kappa_squared: Vec<f64>,
    /// t² at these knots ([`poisson`](super::poisson)), with the knots.
    #[serde(skip)]
    positions: Cached<(Vec<f64>, Vec<f64>)>,
}

impl ForceTable {
    /// t² at the knots.
    fn squared_positions(&self) -> Cow<'_, [f64]> {
        let (knots, positions) = self.positions.0.get_or_init(|| (self.from.clone(), squared_positions(&self.from)));
        if *knots == self.from { Cow::Borrowed(positions) } else { Cow::Owned(squared_positions(&self.from)) }
    }

    fn slopes(&self, kappa_squared: f64) -> impl Iterator<Item = (f64, f64)> {
        let pieces = self.from.iter().zip(&self.slope).zip(&self.slope_kappa_squared);
        pieces.map(move |((from, slope), per_kappa)| (*from, slope + per_kappa * kappa_squared))
    }
}

/// The polyline of ε in A.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ApproachTable {
    /// Slope from A = 1 at κ = 0.
    pub first_slope: f64,
    /// The slope is `first_slope` + κ² × this.
    pub first_slope_kappa_squared: f64,
    pub first_slope_limit: f64,
    /// Fully plastic from A = 1 + this × ρ_E.
    pub plastic_from_rho: f64,
    /// Slope from there on at κ = 0.
    pub plastic_slope: f64,
    /// The slope is `plastic_slope` + κ² × this.
    pub plastic_slope_kappa_squared: f64,
    /// Finite geometry: A a_Y/R from which each factor multiplies the slope.
    pub geometry_from: Vec<f64>,
    pub geometry_factor: Vec<f64>,
}

/// The coefficients of the PLM. A scenario may name a file with others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlmCoefficients {
    pub provenance: CoefficientSource,
    pub force: ForceTable,
    pub elastic_approach: ApproachTable,
    pub contact_radius: RadiusTable,
    /// Without it, the law of ν = 0.3 serves every Poisson's ratio.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson: Option<PoissonTable>,
    /// Without it, the law of shallow dents serves every depth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<DepthTable>,
    #[serde(default)]
    pub validity: ValidityTable,
}

/// Why a table of coefficients is refused.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CoefficientsError {
    /// Not TOML of the expected form; the text shows line and key.
    #[error("{0}")]
    Form(String),
    #[error("{key} = {value} is not allowed: {rule}")]
    Value { key: &'static str, value: String, rule: &'static str },
}

fn is_rising(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite()) && values.windows(2).all(|pair| pair[0] < pair[1])
}

fn is_positive(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite() && *v > 0.0)
}

fn is_non_negative(values: &[f64]) -> bool {
    values.iter().all(|v| v.is_finite() && *v >= 0.0)
}

impl PlmCoefficients {
    pub fn built_in() -> &'static Self {
        static TABLE: LazyLock<PlmCoefficients> = LazyLock::new(|| {
            PlmCoefficients::from_toml(include_str!("coefficients.toml"))
                .expect("the built-in table is well-formed (tested)")
        });
        &TABLE
    }

    /// Reads a table; see `coefficients.toml` for the form.
    ///
    /// # Errors
    /// [`CoefficientsError`] naming line, key and allowed range.
    pub fn from_toml(text: &str) -> Result<Self, CoefficientsError> {
        let table: Self = toml::from_str(text).map_err(|error| CoefficientsError::Form(error.to_string()))?;
        table.check()?;
        Ok(table)
    }

    /// Checks what the law needs: rising knots, positive slopes for every κ in \[0, 1\], lists of equal length.
    ///
    /// # Errors
    /// [`CoefficientsError::Value`] for the first value that breaks a rule.
    pub fn check(&self) -> Result<(), CoefficientsError> {
        let (f, e, r) = (&self.force, &self.elastic_approach, &self.contact_radius);
        let steepest: Vec<f64> = f.slope.iter().zip(&f.slope_kappa_squared).map(|(s, k)| s + k).collect();
        let same = f.from.len() == f.slope.len() && f.from.len() == f.slope_kappa_squared.len();
        let starts = is_rising(&f.from) && f.from.first().is_none_or(|x| *x >= 1.0);
        let with_kappa = |value: f64, kappa_squared: f64| [value, value + kappa_squared];
        let first = is_positive(&with_kappa(e.first_slope, e.first_slope_kappa_squared));
        let plastic = is_positive(&with_kappa(e.plastic_slope, e.plastic_slope_kappa_squared));
        let geometry = is_rising(&e.geometry_from) && is_positive(&e.geometry_from);
        let factors = e.geometry_from.len() == e.geometry_factor.len() && is_positive(&e.geometry_factor);
        let knots = is_rising(&r.from) && r.from.len() == r.ratio.len();
        let ratios = r.ratio.iter().all(|v| (1.0..=1.6).contains(v));
        let narrower = is_non_negative(&with_kappa(r.geometry_slope, r.geometry_slope_kappa_squared));
        let numbers = self.poisson.map_or([0.0; 2], |poisson| [poisson.force, poisson.approach]);
        let depth = self.depth.map_or([0.0; 5], |d| [d.from, d.force, d.recovery, d.radius, d.radius_from]);
        let deepest = self.depth.is_none_or(|d| d.from < d.to && d.to.is_finite());
        let kappa = self.depth.is_none_or(|d| (0.0..=1.0).contains(&d.recovery_kappa));
        let ValidityTable { perfectly_plastic, hardening, yielding_sphere, both_yield } = self.validity;
        let widest = [perfectly_plastic, hardening, yielding_sphere, both_yield];
        let within = is_positive(&widest) && widest.iter().all(|ratio| *ratio <= 1.0);
        let rules: [(bool, &'static str, &dyn Debug, &'static str); 19] = [
            (same, "force.slope", &f.slope, "force.from, slope and slope_kappa_squared have the same length"),
            (starts, "force.from", &f.from, "rising, the first at least 1 (first yield)"),
            (is_positive(&f.slope), "force.slope", &f.slope, "> 0"),
            (
                is_positive(&steepest),
                "force.slope_kappa_squared",
                &f.slope_kappa_squared,
                "slope + slope_kappa_squared > 0",
            ),
            (first, "elastic_approach.first_slope", &e.first_slope, "> 0, with first_slope_kappa_squared too"),
            (is_positive(&[e.first_slope_limit]), "elastic_approach.first_slope_limit", &e.first_slope_limit, "> 0"),
            (plastic, "elastic_approach.plastic_slope", &e.plastic_slope, "> 0, with plastic_slope_kappa_squared too"),
            (is_non_negative(&[e.plastic_from_rho]), "elastic_approach.plastic_from_rho", &e.plastic_from_rho, ">= 0"),
            (geometry, "elastic_approach.geometry_from", &e.geometry_from, "> 0 and rising"),
            (factors, "elastic_approach.geometry_factor", &e.geometry_factor, "> 0, as many as geometry_from"),
            (knots, "contact_radius.from", &r.from, "rising, as many as ratio"),
            (ratios, "contact_radius.ratio", &r.ratio, "from 1 (Hertz pressure) to 1.6"),
            (is_non_negative(&[r.geometry_from]), "contact_radius.geometry_from", &r.geometry_from, ">= 0"),
            (
                narrower,
                "contact_radius.geometry_slope",
                &r.geometry_slope,
                ">= 0, with geometry_slope_kappa_squared too",
            ),
            (is_non_negative(&numbers), "poisson", &self.poisson, "force and approach are >= 0"),
            (is_non_negative(&depth), "depth", &self.depth, "no number is negative"),
            (deepest, "depth.to", &self.depth, "to is greater than from"),
            (kappa, "depth.recovery_kappa", &self.depth, "from 0 to 1"),
            (within, "validity", &self.validity, "each > 0 and <= 1"),
        ];
        match rules.iter().find(|(holds, ..)| !holds) {
            Some((_, key, value, rule)) => Err(CoefficientsError::Value { key, value: format!("{value:?}"), rule }),
            None => Ok(()),
        }
    }

    /// [`Self::check`], as an error of the law.
    pub(super) fn check_rules(&self) -> Result<(), LawError> {
        match self.check() {
            Err(CoefficientsError::Value { key, rule, .. }) => Err(LawError::Coefficients { key, rule }),
            Err(CoefficientsError::Form(_)) | Ok(()) => Ok(()),
        }
    }

    /// The law, without the flat of a sphere, for a pair that yields at `a_Y` / R = `yield_radius_ratio`.
    pub fn law(&self, pair: &Pair, yield_radius_ratio: f64, exponent: UnloadingExponent) -> Law {
        let [kappa, _] = pair.law_shares();
        let loading = self.shallow_loading(kappa * kappa, pressure_ratio(pair));
        let depth = self.depth(pair, yield_radius_ratio, &loading);
        let rule = self.unloading_rule(pair, yield_radius_ratio, exponent);
        Law::plm(loading, Arc::new(PlmUnloadingRule { depth, ..rule }))
    }

    /// The loading of shallow dents for this κ² and this c, in units of first yield.
    pub(super) fn shallow_loading(&self, kappa_squared: f64, pressure_ratio: f64) -> Arc<LoadingCurve> {
        let slopes = self.force.slopes(kappa_squared);
        let hertz = LoadingCurve::hertz();
        let curve = match self.poisson {
            Some(poisson) if pressure_ratio != 1.0 => {
                let positions = self.force.squared_positions();
                let factors = poisson.force_factors(&positions, kappa_squared, pressure_ratio);
                hertz.then_lines(slopes.zip(factors).map(|((from, slope), factor)| (from, slope * factor)))
            }
            _ => hertz.then_lines(slopes),
        };
        Arc::new(curve.with_transit_series())
    }

    /// How a pair of constant strengths unloads from a shallow dent, without the flat of a sphere.
    pub(super) fn unloading_rule(
        &self,
        pair: &Pair,
        yield_radius_ratio: f64,
        exponent: UnloadingExponent,
    ) -> PlmUnloadingRule {
        let [kappa, _] = pair.law_shares();
        let line = ApproachPolyline::new(&self.approach_slopes(pair), yield_radius_ratio);
        let radius = self.contact_radius.for_contact(kappa * kappa, yield_radius_ratio);
        let max_radius_ratio = self.validity.perfectly_plastic;
        PlmUnloadingRule {
            approach: line,
            hardening: None,
            flattening: None,
            depth: None,
            radius,
            max_radius_ratio,
            exponent,
        }
    }

    /// The correction for deep dents of a pair whose force in shallow dents is `base`.
    pub(super) fn depth(&self, pair: &Pair, yield_radius_ratio: f64, base: &Arc<LoadingCurve>) -> Option<Depth> {
        let [_, rho] = pair.law_shares();
        Depth::new(self.depth?, pair, yield_radius_ratio, self.plastic_from(rho), base)
    }

    /// A from which the contact is fully plastic, for this 1 − κ.
    pub(super) fn plastic_from(&self, rho: f64) -> f64 {
        1.0 + self.elastic_approach.plastic_from_rho * rho
    }

    /// The slopes and knots of the polyline of the elastic approach.
    pub(super) fn approach_slopes(&self, pair: &Pair) -> ApproachSlopes {
        let [kappa, rho] = pair.law_shares();
        let kappa_squared = kappa * kappa;
        let table = &self.elastic_approach;
        let first = (table.first_slope + table.first_slope_kappa_squared * kappa_squared).min(table.first_slope_limit);
        let of_poisson = self.poisson.map_or(1.0, |poisson| poisson.approach_factor(pressure_ratio(pair)));
        ApproachSlopes {
            first,
            plastic_from: self.plastic_from(rho),
            plastic: (table.plastic_slope + table.plastic_slope_kappa_squared * kappa_squared) * of_poisson,
            geometry: table.geometry_from.iter().copied().zip(table.geometry_factor.iter().copied()).collect(),
        }
    }
}
