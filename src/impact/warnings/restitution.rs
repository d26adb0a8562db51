//! The warnings that say how far e may be off, or that nobody knows how far. The interval of e has them as parts.

use std::f64::consts::PI;

use super::bodies::{flow_warnings, ignored_strength, material_warnings, yielding_warning};
use super::limits::{
    ADHESION_RANGE, MAX_SOFT_RADIUS_RATIO, MAX_UNEQUAL_BALLS_RATIO, MIN_POISSONS_RATIO, MIN_TRANSITS, WORK_OF_ADHESION,
};
use super::waveguide::waveguide_warnings;
use crate::contact::body::Support;
use crate::contact::law::{Law, UnloadingRule};
use crate::contact::pair::Pair;
use crate::impact::problem::contact::Contact;
use crate::impact::result::row::ImpactRow;
use crate::impact::result::warning::{Warning, WarningKind};
use crate::numerics::comparison::is_above;
use crate::units::{Dimension, format_result};

/// The warnings that concern e in an impact with this speed normal to the surface \[m/s\], this peak mean pressure \[Pa\] and this
/// result.
pub(super) fn restitution_warnings(contact: &Contact, speed: f64, pressure: f64, row: &ImpactRow) -> Vec<Warning> {
    let strengths = [contact.sphere().yield_strength, contact.half_space().yield_strength];
    let left_out = ignored_strength(contact.pair(), &contact.law, strengths);
    let ratio = row.radius_ratio;
    let mut warnings: Vec<Warning> = yielding_warning(pressure, left_out, "e is far too high").into_iter().collect();
    warnings.extend(flow_warnings(contact.pair()));
    warnings.extend(material_warnings(contact, row));
    warnings.extend(unequal_balls_warning(contact.pair(), ratio));
    warnings.extend(dent_warning(&contact.law, ratio));
    warnings.extend(soft_dent_warning(contact, ratio));
    warnings.extend(negative_ratio_warning(contact, row));
    warnings.extend(short_contact_warning(contact, row.contact_time));
    warnings.extend(adhesion_warning(contact, speed));
    let waveguide = contact.forces().waveguide.as_ref().zip(row.waveguide.as_ref());
    warnings.extend(
        waveguide.into_iter().flat_map(|(guide, result)| waveguide_warnings(guide, result, row.peak_contact_radius)),
    );
    warnings
}

/// A known error of e, for a reason that a warning names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bias {
    /// The reason, such as "weak sphere".
    pub reason: &'static str,
    /// True for a known bias, false for scatter.
    pub is_shift: bool,
    /// The lowest true e, as a share of e, less 1.
    pub low: f64,
    /// The highest true e, as a share of e, less 1.
    pub high: f64,
}

impl Contact {
    /// The known errors of e in an impact with this result, by its warnings. `None` where a warning names no share of e, as for a
    /// contact that is too wide: then nobody knows how far e is off.
    pub fn known_biases(&self, speed: f64, row: &ImpactRow) -> Option<Vec<Bias>> {
        let pressure = row.peak_force / (PI * row.peak_contact_radius) / row.peak_contact_radius;
        let bias = |warning: Warning| {
            let (reason, is_shift, low, high) = match warning.kind {
                WarningKind::WeakSphere => ("weak sphere", true, 0.0, 0.03),
                WarningKind::UnequalBalls => ("unequal balls", false, -0.01, 0.01),
                _ => return None,
            };
            Some(Bias { reason, is_shift, low, high })
        };
        // what is known of a strength is a part of its own, and what is known of a deep dent is the part of the law
        let is_other_part = |kind| matches!(kind, WarningKind::NoExponent | WarningKind::DeepSoftDent);
        let warnings = restitution_warnings(self, speed, pressure, row).into_iter();
        warnings.filter(|warning| !is_other_part(warning.kind)).map(bias).collect()
    }
}

/// The warning for a dent of this radius, over that of the sphere.
pub(crate) fn dent_warning(law: &Law, ratio: f64) -> Option<Warning> {
    let limit = law.validity.max_radius_ratio;
    Warning::new_if(law.validity.is_exceeded(ratio), WarningKind::DeepDent, ratio, || {
        format!(
            "Force, dent and e are estimates. Contact radius / sphere radius (a/R) = {ratio:.3} exceeds {limit}, the limit of validity of this law. Reduce the indentation."
        )
    })
}

/// The largest κ of a stiff sphere: its Young's modulus is a third of the modulus of a half-space with the same Poisson's ratio.
const MAX_COMPLIANCE_OF_STIFF_SPHERE: f64 = 0.75;

/// The warning for a deep dent of a stiff sphere in a metal that does not harden.
fn soft_dent_warning(contact: &Contact, ratio: f64) -> Option<Warning> {
    let UnloadingRule::PlmRule(rule) = contact.law.rule_while_loading() else { return None };
    let is_deep = ratio > MAX_SOFT_RADIUS_RATIO && !contact.law.validity.is_exceeded(ratio);
    let is_soft =
        rule.hardening.is_none() && !is_above(contact.pair().sphere_compliance, MAX_COMPLIANCE_OF_STIFF_SPHERE);
    Warning::new_if(is_deep && is_soft, WarningKind::DeepSoftDent, ratio, || {
        format!(
            "e may be up to 6 % too high. Contact radius / sphere radius (a/R) = {ratio:.3} exceeds {MAX_SOFT_RADIUS_RATIO}, and the metal is perfectly plastic: finite elements form a lip around such a dent. Give the flow curve of the metal (flow_stress)."
        )
    })
}

/// The warning for a body that yields and has a Poisson's ratio below those of the finite elements.
fn negative_ratio_warning(contact: &Contact, row: &ImpactRow) -> Option<Warning> {
    let ratio = contact.pair().yield_point?.poissons_ratio;
    let is_plm = matches!(contact.law.rule_while_loading(), UnloadingRule::PlmRule(_));
    let is_outside = is_plm && row.has_dent() && ratio < MIN_POISSONS_RATIO;
    Warning::new_if(is_outside, WarningKind::NegativePoissonsRatio, -ratio, || {
        format!(
            "Force, dent and e are extrapolations. Poisson's ratio {ratio} of the yielding body is below {MIN_POISSONS_RATIO}; finite elements confirm the law from 0.03 to 0.42. Calibrate the strength with a measured rebound."
        )
    })
}

/// The warning for two balls that both flow and are not equal, with this contact radius over that of the smaller one.
fn unequal_balls_warning(pair: &Pair, ratio: f64) -> Option<Warning> {
    let is_doubtful = pair.has_unequal_balls() && ratio > MAX_UNEQUAL_BALLS_RATIO;
    Warning::new_if(is_doubtful, WarningKind::UnequalBalls, ratio, || {
        format!(
            "e has an additional error of 0.5 to 1 %. Both balls yield and are not equal (contact radius = {ratio:.3} times the smaller radius); their indentations are superposed. A sweep shows a step of this size at equal balls."
        )
    })
}

/// The warning for a contact so short that the sphere is not quasi-static.
fn short_contact_warning(contact: &Contact, duration: f64) -> Option<Warning> {
    let (sphere, target) = (contact.sphere(), contact.half_space());
    let transit = 2.0 * sphere.radius * (sphere.density / sphere.material.youngs_modulus).sqrt();
    let of_ball = target.ball_radius().filter(|_| target.support == Support::Ball).zip(target.density);
    let transit = of_ball.map_or(transit, |(radius, density)| {
        transit.max(2.0 * radius * (density / target.material.youngs_modulus).sqrt())
    });
    let transits = duration / transit;
    let is_short = transits < MIN_TRANSITS && !contact.has_attached_mass();
    Warning::new_if(is_short, WarningKind::ShortContact, -transits, || {
        format!(
            "e is too high. The contact lasts only {transits:.2} wave transits of the sphere (2 R / c); below {MIN_TRANSITS} the contact is not quasi-static, and waves absorb energy."
        )
    })
}

/// The warning for a speed at which adhesion takes a part of e: below seven times the speed at which an elastic sphere sticks, with the
/// given work of adhesion, or with a usual one.
fn adhesion_warning(contact: &Contact, speed: f64) -> Option<Warning> {
    let work = contact.adhesion_work().unwrap_or(WORK_OF_ADHESION);
    let sticking = contact.sticking_speed(work, contact.pair().radius);
    let is_slow = speed > 0.0 && speed < ADHESION_RANGE * sticking;
    let [sticks, negligible] =
        [sticking, ADHESION_RANGE * sticking].map(|speed| format_result(speed, Dimension::Speed));
    let of_work = format_result(work, Dimension::SurfaceEnergy);
    Warning::new_if(is_slow, WarningKind::Adhesion, sticking / speed, || {
        if contact.adhesion_work().is_some() {
            format!(
                "restitution does not contain adhesion, and is too high. For a work of adhesion of {of_work} an elastic sphere sticks below {sticks}; above {negligible} adhesion lowers e by at most 1 %/e^2. Use restitution_with_adhesion."
            )
        } else {
            format!(
                "e is too high, because adhesion is not modelled. For a work of adhesion of {of_work} the sphere sticks below {sticks}; above {negligible} adhesion lowers e by at most 1 %/e^2. Give adhesion.work for the restitution with adhesion."
            )
        }
    })
}
