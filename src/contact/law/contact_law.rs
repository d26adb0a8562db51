//! The trait of all contact laws: every law has a description, a loading and an unloading.

use std::fmt::Debug;
use std::sync::LazyLock;

use serde::Serialize;

use super::Law;
use super::published::{LawError, LawParts};
use crate::contact::pair::{Pair, YieldPoint};

/// The source of a law and its use, in words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct LawInfo {
    pub name: &'static str,
    /// Authors and year.
    pub title: &'static str,
    pub source: &'static str,
    pub loading: &'static str,
    pub unloading: &'static str,
    pub validity: &'static str,
    /// How reliable its equations are: "high" if several independent texts agree, "low" if they were written from memory.
    pub confidence: &'static str,
}

impl LawInfo {
    /// The facts of a law, from its line in the table `facts.csv`; empty facts for a law without a line.
    pub(super) fn for_law(name: &str) -> &'static Self {
        static FACTS: LazyLock<Vec<LawInfo>> =
            LazyLock::new(|| include_str!("facts.csv").lines().map(LawInfo::parse_line).collect());
        static NOTHING: LazyLock<LawInfo> = LazyLock::new(|| LawInfo::parse_line(""));
        FACTS.iter().find(|about| about.name == name).unwrap_or(&NOTHING)
    }

    fn parse_line(line: &'static str) -> Self {
        let mut words = line.split('|');
        let mut next = || words.next().unwrap_or_default();
        let (name, title, source, loading) = (next(), next(), next(), next());
        Self { name, title, source, loading, unloading: next(), validity: next(), confidence: next() }
    }
}

/// Two bodies of which at least one yields. A law is built for them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldingPair {
    /// Effective modulus, fractions of the compliance.
    pub pair: Pair,
    /// First yield of the softer body by C_ν: the unit of x and f.
    pub yield_point: YieldPoint,
}

impl YieldingPair {
    /// `None` for bodies without a yield strength, which follow Hertz alone.
    pub fn new(pair: &Pair) -> Option<Self> {
        Some(Self { pair: *pair, yield_point: pair.yield_point? })
    }

    /// δ_y/δ_Y of a law that yields where the largest Hertz pressure is `factor` σ_Y: (C/C_ν)².
    pub fn yield_indentation_ratio(&self, factor: f64) -> f64 {
        let ratio = factor / self.yield_point.factor;
        ratio * ratio
    }

    /// σ_Y/E*.
    pub fn yield_strain(&self) -> f64 {
        self.yield_point.strength / self.pair.effective_modulus
    }

    /// a_Y/R = √(δ_Y/R), with R of the finite geometry.
    pub fn yield_radius_ratio(&self) -> f64 {
        self.yield_point.contact_radius / self.pair.geometry_radius
    }

    /// E of the softer body \[Pa\].
    pub fn modulus(&self) -> f64 {
        let Pair { sphere_compliance, half_space_compliance, .. } = self.pair;
        let YieldPoint { yield_partition: flow, poissons_ratio, .. } = self.yield_point;
        let plane_strain = self.pair.effective_modulus / flow.for_softer([sphere_compliance, half_space_compliance]);
        plane_strain * (1.0 - poissons_ratio * poissons_ratio)
    }

    /// Slope df/dx of F = s π R p δ, with p = `pressure` σ_Y: (3/2) s p/C_ν.
    pub fn slope_at_pressure(&self, area_factor: f64, pressure: f64) -> f64 {
        1.5 * area_factor * pressure / self.yield_point.factor
    }
}

/// A contact law: its parameters, and the law of two bodies that follows from them.
pub trait ContactLaw: Debug {
    /// Its loading and unloading for these bodies, in units of δ_Y and F_Y by C_ν.
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts;

    /// The whole law.
    ///
    /// # Errors
    /// [`LawError::Incomplete`] for a law without a loading rule; for the PLM also [`LawError::BothFlow`] and [`LawError::Flow`].
    fn law(&self, bodies: &YieldingPair) -> Result<Law, LawError> {
        let LawParts { loading, recovery } = self.build_parts(bodies);
        Ok(Law::from_published(loading?, recovery))
    }

    /// The whole law of a pair of bodies. Without a yield strength the law is Hertz.
    ///
    /// # Errors
    /// The errors of [`ContactLaw::law`].
    fn law_for_pair(&self, pair: &Pair) -> Result<Law, LawError> {
        YieldingPair::new(pair).map_or_else(|| Ok(Law::hertz()), |bodies| self.law(&bodies))
    }
}
