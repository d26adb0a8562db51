//! The strain rate of an impact, and the contact that has the strength of that rate.
//!
//! ```text
//! w    = v/√(R δ_m)
//! g    = g(0.2 w)      factor of the strength while the sphere goes in: δ_m, times, work, waves
//! g_t  = g(0.015 w)    factor where it turns, as the metal relaxes there: F_m, δ_e, n
//! ```
//!
//! δ_m is that of the strength g σ, so g is a fixed point, found by repeating. Two factors for a whole impact keep every
//! closed form. Against own explicit finite elements with the rate in every Gauss point (eleven impacts, 0.3 to 10 m/s,
//! Johnson-Cook 0.014 to 0.03, Cowper-Symonds): e rms 1.0 %, contact time 0.8 %, depth 1.7 %, peak force −2.2 to +0.6 %. With one
//! factor, at any rate, e is off by up to 9.5 %: the flow stress relaxes within a microsecond where the sphere turns.
//!
//! The factor is that of the impact of the same normal speed on fresh surface, without gravity, damping and plate. Each body has
//! its own factor at the same w.

use std::sync::Arc;

use super::contact::{Contact, Rated, Rates};
use super::error::ImpactError;
use super::scales::Scales;
use crate::contact::law::{Bodies, Ground, LawChoice};
use crate::contact::material::{HalfSpace, OutOfFloatRange, Pair, PairError, Sphere};
use crate::contact::strength::rate::Rate;
use crate::numerics::integrate::IntegrationError;

/// The rate of the loading and that of the turn, over w.
const SHARES: [f64; 2] = [0.2, 0.015];

/// A round gains one digit at least, and two with usual constants.
const MOST_ROUNDS: u64 = 60;

/// The body that yields, or the softer one: 0 for the sphere, 1 for the half-space.
fn yielding(pair: &Pair) -> usize {
    usize::from(!pair.yield_point.is_some_and(|point| point.flow.is_sphere))
}

impl Contact {
    /// Returns this contact of bodies whose strengths rise with the rate of strain, those of sphere and half-space under this law.
    pub fn with_rates(mut self, of_bodies: [Option<Rate>; 2], law: &LawChoice) -> Self {
        let has_rate = of_bodies.iter().any(Option::is_some) && self.pair().yield_point.is_some();
        self.rates = has_rate.then(|| Arc::new(Rates { of_bodies, law: law.clone() }));
        self
    }

    /// True if the strength depends on the speed.
    pub fn has_rate(&self) -> bool {
        self.rates.is_some()
    }

    /// The strain rate that the strength of this contact belongs to, with its factors; `None` without a rate, and before a speed is known.
    pub fn rated(&self) -> Option<&Rated> {
        self.rated.as_ref()
    }

    /// The contact with the strength of an impact at this speed \[m/s\]; itself where the strength does not depend on it.
    ///
    /// # Errors
    /// [`ImpactError`] where a constant of the pair over- or underflows, or the factors are no numbers.
    pub fn at_speed(&self, speed: f64) -> Result<Self, ImpactError> {
        Ok(self.rated_at(speed)?.unwrap_or_else(|| self.clone()))
    }

    /// As [`Contact::at_speed`]; `None` where the strength does not depend on the speed.
    #[inline]
    pub(super) fn rated_at(&self, speed: f64) -> Result<Option<Self>, ImpactError> {
        match &self.rates {
            None => Ok(None),
            Some(rates) => self.of_rate(rates, speed).map(Some),
        }
    }

    #[cold]
    fn of_rate(&self, rates: &Rates, speed: f64) -> Result<Self, ImpactError> {
        let (w, [loading, turn]) = self.factors(rates, speed)?;
        let raised = self.raised(rates, loading)?;
        let body = yielding(raised.pair());
        let (factor, factor_at_turn, rate) = (loading[body], turn[body], rates.of_bodies[body]);
        let rated = Rated { strain_rate: SHARES[0] * w, factor, factor_at_turn, rate };
        let ratio = factor_at_turn / factor;
        let mut contact = if turn == loading { raised } else { raised.relaxing_to(self.raised(rates, turn)?, ratio) };
        contact.rated = Some(rated);
        Ok(contact)
    }

    /// w, and the factors of sphere and half-space while the sphere goes in and where it turns.
    fn factors(&self, rates: &Rates, speed: f64) -> Result<(f64, [[f64; 2]; 2]), ImpactError> {
        let at = |rate: f64| rates.of_bodies.map(|of_body| of_body.map_or(1.0, |rise| rise.factor(rate)));
        let mut factors = [1.0; 2];
        for _ in 0..MOST_ROUNDS {
            let depth = self.depth(rates, factors, speed)?;
            let w = if speed == 0.0 { 0.0 } else { speed / (self.pair().radius * depth).sqrt() };
            let next = at(SHARES[0] * w);
            let is_found = (0..2).all(|body| (next[body] - factors[body]).abs() < 1e-14 * next[body]);
            factors = next;
            if is_found {
                return Ok((w, [factors, at(SHARES[1] * w)]));
            }
            if let Some(value) = factors.into_iter().find(|factor| !factor.is_finite()) {
                return Err(OutOfFloatRange { quantity: "factor of the strength at this rate of strain", value }.into());
            }
        }
        Err(IntegrationError::TooManySteps { steps: MOST_ROUNDS }.into())
    }

    /// δ_m \[m\] of the impact on fresh surface with these factors, without gravity, damping and plate.
    fn depth(&self, rates: &Rates, factors: [f64; 2], speed: f64) -> Result<f64, ImpactError> {
        let deepest = |contact: &Self, scales: &Scales| {
            let q = speed / scales.speed;
            let ground = Ground::from(&contact.law);
            let (last, distance) = ground.turn(0.4 * q * q, 0.0);
            (ground.piece(last).start + distance) * scales.length
        };
        if factors == [1.0; 2] {
            return Ok(deepest(self, &self.scales));
        }
        let pair = self.pair_of(factors)?;
        if let Some(scales) = self.scales_of_same_curve(&pair)? {
            return Ok(deepest(self, &scales));
        }
        let raised = self.raised(rates, factors)?;
        Ok(deepest(&raised, &raised.scales))
    }

    /// The bodies with these factors of their strengths.
    fn pair_of(&self, [of_sphere, of_half_space]: [f64; 2]) -> Result<Pair, PairError> {
        let times = |strength: Option<f64>, factor: f64| strength.map(|strength| strength * factor);
        let (sphere, half_space) = (self.sphere(), self.half_space());
        Pair::try_new(
            &Sphere { yield_strength: times(sphere.yield_strength, of_sphere), ..*sphere },
            &HalfSpace { yield_strength: times(half_space.yield_strength, of_half_space), ..*half_space },
        )
    }

    /// This contact with these factors, without a rate.
    fn raised(&self, rates: &Rates, factors: [f64; 2]) -> Result<Self, ImpactError> {
        if factors == [1.0; 2] {
            let mut contact = self.clone();
            contact.rates = None;
            return Ok(contact);
        }
        let pair = self.pair_of(factors)?;
        if let (LawChoice::Plm(plm), Some(scales), Some(bodies)) =
            (&rates.law, self.scales_of_same_curve(&pair)?, Bodies::new(&pair))
        {
            return Ok(self.of_law(pair, plm.of_same_curve(&self.law, &bodies), scales, scales.speed));
        }
        let mut law = rates.law.clone();
        if let LawChoice::Plm(plm) = &mut law {
            plm.rate_factors = factors;
        }
        self.of_pair(pair, law.get())
    }

    /// This contact, which relaxes to the strength of another one where the sphere turns.
    fn relaxing_to(mut self, turn: Self, ratio: f64) -> Self {
        self.law = self.law.relaxing_to(turn.law, ratio);
        self.elastic_speed = turn.yield_speed.min(self.yield_speed);
        self
    }
}
