//! The warnings that say how far e may be off, or that nobody knows how far. The interval of e has them as parts.

use std::f64::consts::PI;

use super::bodies::{flow_warnings, ignored_strength, material_warnings, yielding_warning};
use crate::contact::body::Support;
use crate::contact::law::Law;
use crate::contact::pair::Pair;
use crate::impact::problem::contact::Contact;
use crate::impact::problem::plate::{Plate, PlateTheory};
use crate::impact::result::row::{ImpactRow, PlateResult};
use crate::impact::result::warning::{Warning, WarningKind};
use crate::numerics::functions::pow;
use crate::units::{Dimension, format_input, format_result};

/// The largest Zener's number up to which contact times on plates were measured, and agree with his theory.
const MAX_MEASURED_ZENER_NUMBER: f64 = 1.5;

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
    warnings.extend(short_contact_warning(contact, row.contact_time));
    warnings.extend(adhesion_warning(contact, speed));
    if let (Some(plate), Some(on_plate)) = (&contact.forces().plate, &row.plate) {
        warnings.extend(plate_warnings(plate, on_plate, row.peak_contact_radius));
    }
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
        // what is known of a strength is a part of its own
        let warnings = restitution_warnings(self, speed, pressure, row).into_iter();
        warnings.filter(|warning| warning.kind != WarningKind::NoExponent).map(bias).collect()
    }
}

/// The warning for a dent of this radius, over that of the sphere.
pub(crate) fn dent_warning(law: &Law, ratio: f64) -> Option<Warning> {
    let limit = law.validity.max_radius_ratio;
    Warning::new_if(ratio > limit, WarningKind::DeepDent, ratio, || {
        format!(
            "contact radius / sphere radius = {ratio:.3} is beyond {limit}, up to which this law holds: take forces and residual indentation as estimates, or let the indentation be shallower"
        )
    })
}

/// The warning for two balls that both flow and are not equal, with this contact radius over that of the smaller one.
fn unequal_balls_warning(pair: &Pair, ratio: f64) -> Option<Warning> {
    let is_doubtful = pair.has_unequal_balls() && ratio > 0.1;
    Warning::new_if(is_doubtful, WarningKind::UnequalBalls, ratio, || {
        format!(
            "both balls flow and are not equal, and the contact radius is {ratio:.3} of the smaller one's: there the sum of their parts misses equal balls by 0.5 to 1 % of e, so that e has a step of this size where an axis passes through equal balls"
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
    let is_short = transits < 5.0 && !contact.has_attached_mass();
    Warning::new_if(is_short, WarningKind::ShortContact, -transits, || {
        format!(
            "contact lasts {transits:.2} wave transits of the sphere (2 R / c); below 5 it is no longer quasi-static and part of the energy goes into waves"
        )
    })
}

/// The warning for a speed at which adhesion would take a part of e: below seven times the speed at which a sphere sticks by the
/// theory of Johnson, Kendall and Roberts, √(14.18/m) (Γ⁵ R⁴/E*²)^(1/6) (Thornton and Ning 1998).
fn adhesion_warning(contact: &Contact, speed: f64) -> Option<Warning> {
    /// Γ \[J/m²\].
    const WORK_OF_ADHESION: f64 = 0.2;
    let (radius, modulus) = (contact.pair().radius, contact.pair().effective_modulus);
    let depth = pow(WORK_OF_ADHESION, 5.0 / 6.0) * pow(radius, 2.0 / 3.0) / pow(modulus, 1.0 / 3.0);
    let sticking = (14.18 / contact.reduced_mass()).sqrt() * depth;
    let is_slow = speed > 0.0 && speed < 7.0 * sticking;
    Warning::new_if(is_slow, WarningKind::Adhesion, sticking / speed, || {
        format!(
            "adhesion is not computed: with a surface energy of 0.2 J/m^2 the sphere would stick below {}, and up to seven times that speed e is more than 1 % too high",
            format_result(sticking, Dimension::Speed)
        )
    })
}

/// The warnings for a plate, hit with this contact radius \[m\].
fn plate_warnings(plate: &Plate, on_plate: &PlateResult, contact_radius: f64) -> impl Iterator<Item = Warning> + use<> {
    let PlateResult { zener_number, wave_transits, displacement, wave_reach, .. } = *on_plate;
    let thickness = plate.thickness;
    let (least, beyond) = match plate.theory {
        PlateTheory::Thick => (5.0, "by 8 % at 5 thicknesses and by a third at 3"),
        PlateTheory::Zener if wave_transits < 5.0 => {
            (10.0, "by half or more; half_space.plate = \"thick\" comes nearer")
        }
        PlateTheory::Zener => {
            (10.0, "by a fifth at 10 thicknesses and by half at 5; half_space.plate = \"thick\" is good to 8 % of it")
        }
    };
    let is_thick = wave_transits < 2.0;
    let thick = Warning::new_if(is_thick, WarningKind::ThickPlate, -wave_transits, || {
        format!(
            "during the contact a wave travels only {wave_transits:.2} thicknesses of the plate, and below 2 the echo of its rear face comes too late: it acts as a half-space, so leave half_space.thickness out"
        )
    });
    let between = Warning::new_if(
        !is_thick && wave_transits < least,
        WarningKind::ModeratelyThickPlate,
        -wave_transits,
        || {
            format!(
                "during the contact a wave travels {wave_transits:.1} thicknesses of the plate, and a thin plate takes at least {least}: the plate takes more energy than computed, {beyond}"
            )
        },
    );
    let ratio = contact_radius / thickness;
    let wide = Warning::new_if(ratio > 0.15, WarningKind::WideContactOnPlate, ratio, || {
        format!(
            "contact radius / plate thickness = {ratio:.3} is above 0.15: there the plate is stiffer under the sphere than a half-space by more than a tenth, and yields through; take the result for an estimate"
        )
    });
    let near = plate.edge_distance.filter(|distance| *distance < wave_reach).map(|distance| {
        let [edge, far] = [distance, wave_reach].map(|length| format_input(length, Dimension::Length));
        let text = format!(
            "half_space.edge_distance = {edge} is less than {far}, from where bending waves come back during the contact: the plate may take a quarter more or less than computed"
        );
        Warning::new(WarningKind::NearEdge, wave_reach / distance, text)
    });
    let ratio = displacement / thickness;
    let deep = Warning::new_if(ratio > 0.3, WarningKind::DeepPlate, ratio, || {
        format!(
            "the plate moves by {ratio:.2} of its thickness, and above 0.3 it also stretches, which makes it stiffer than computed"
        )
    });
    let little = Warning::new_if(
        zener_number > MAX_MEASURED_ZENER_NUMBER,
        WarningKind::InelasticPlate,
        zener_number,
        || {
            format!(
                "Zener's number is {zener_number:.2}, above {MAX_MEASURED_ZENER_NUMBER}, up to which measured contact times confirm the theory of the plate: it takes nearly all, and a small error in its thickness changes e many times as much; take e for nearly 0"
            )
        },
    );
    [thick, between, wide, near, deep, little].into_iter().flatten()
}
