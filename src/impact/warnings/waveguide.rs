//! The warnings for a plate or a rod.

use super::limits::{
    MAX_CONTACT_OVER_ROD_RADIUS, MAX_CONTACT_OVER_THICKNESS, MAX_DEFLECTION_OVER_THICKNESS, MAX_MEASURED_ZENER_NUMBER,
    MIN_ROD_TRANSITS, MIN_THICK_PLATE_TRANSITS, MIN_THIN_PLATE_TRANSITS, MIN_WAVE_TRANSITS,
};
use crate::impact::problem::plate::{Plate, PlateTheory};
use crate::impact::problem::rod::Rod;
use crate::impact::problem::waveguide::{Waveguide, WaveguideKind};
use crate::impact::result::warning::{Warning, WarningKind};
use crate::impact::result::waveguide::WaveguideResult;
use crate::units::{Dimension, format_input};

/// The warnings for a waveguide, hit with this contact radius \[m\].
pub(super) fn waveguide_warnings(guide: &Waveguide, result: &WaveguideResult, contact_radius: f64) -> Vec<Warning> {
    let mut warnings = match guide {
        Waveguide::Plate(plate) => plate_warnings(plate, result, contact_radius),
        Waveguide::Rod(rod) => rod_warnings(rod, result, contact_radius),
    };
    warnings.extend(inelastic_warning(result));
    warnings
}

/// The warning for a waveguide that absorbs nearly all energy.
fn inelastic_warning(result: &WaveguideResult) -> Option<Warning> {
    let number = result.zener_number;
    Warning::new_if(number > MAX_MEASURED_ZENER_NUMBER, WarningKind::InelasticWaveguide, number, || {
        let (size, model) = match result.kind {
            WaveguideKind::Plate => ("thickness", "the plate model"),
            WaveguideKind::Rod => ("diameter of the rod", "the same equation for plates"),
        };
        format!(
            "e is close to 0 and very sensitive to the {size}. Zener's number {number:.2} exceeds {MAX_MEASURED_ZENER_NUMBER}, up to which measured contact times confirm {model}."
        )
    })
}

/// The warnings for a plate, hit with this contact radius \[m\].
fn plate_warnings(plate: &Plate, result: &WaveguideResult, contact_radius: f64) -> Vec<Warning> {
    let WaveguideResult { wave_transits, displacement, wave_reach, .. } = *result;
    let thickness = plate.thickness;
    let (least, beyond) = match plate.theory {
        PlateTheory::Thick => {
            (MIN_THICK_PLATE_TRANSITS, "by 8 % at 5 thicknesses and by a third at 3. Take e as an upper limit")
        }
        PlateTheory::Zener if wave_transits < MIN_THICK_PLATE_TRANSITS => {
            (MIN_THIN_PLATE_TRANSITS, "by half or more. Use half_space.plate = \"thick\"")
        }
        PlateTheory::Zener => (
            MIN_THIN_PLATE_TRANSITS,
            "by a fifth at 10 thicknesses and by half at 5. Use half_space.plate = \"thick\", whose loss is within 8 %",
        ),
    };
    let is_thick = wave_transits < MIN_WAVE_TRANSITS;
    let thick = Warning::new_if(is_thick, WarningKind::ThickPlate, -wave_transits, || {
        format!(
            "The plate model does not apply. During the contact a wave travels only {wave_transits:.2} plate thicknesses; below {MIN_WAVE_TRANSITS} the plate acts as a half-space. Remove half_space.thickness."
        )
    });
    let between = Warning::new_if(
        !is_thick && wave_transits < least,
        WarningKind::ModeratelyThickPlate,
        -wave_transits,
        || {
            format!(
                "e is too high. During the contact a wave travels only {wave_transits:.1} plate thicknesses, and this plate model requires {least}; the plate absorbs more energy than computed, {beyond}."
            )
        },
    );
    let ratio = contact_radius / thickness;
    let wide = Warning::new_if(ratio > MAX_CONTACT_OVER_THICKNESS, WarningKind::WideContactOnPlate, ratio, || {
        format!(
            "The result is an estimate. Contact radius / plate thickness = {ratio:.3} exceeds {MAX_CONTACT_OVER_THICKNESS}: the local stiffness of the plate differs by more than 10 % from a half-space, and the plate may yield through its thickness."
        )
    });
    let near = plate.edge_distance.filter(|distance| *distance < wave_reach).map(|distance| {
        let [edge, far] = [distance, wave_reach].map(|length| format_input(length, Dimension::Length));
        let text = format!(
            "The plate loss is uncertain by +-25 %. Bending waves return from the edge during the contact (half_space.edge_distance = {edge}, required {far})."
        );
        Warning::new(WarningKind::NearEdge, wave_reach / distance, text)
    });
    let ratio = displacement / thickness;
    let deep = Warning::new_if(ratio > MAX_DEFLECTION_OVER_THICKNESS, WarningKind::DeepPlate, ratio, || {
        format!(
            "The plate is stiffer than computed. The plate moves by {ratio:.2} times its thickness; above {MAX_DEFLECTION_OVER_THICKNESS} it also stretches."
        )
    });
    [thick, between, wide, near, deep].into_iter().flatten().collect()
}

/// The warnings for a rod, hit with this contact radius \[m\].
fn rod_warnings(rod: &Rod, result: &WaveguideResult, contact_radius: f64) -> Vec<Warning> {
    let WaveguideResult { wave_transits, wave_reach, .. } = *result;
    let thick = Warning::new_if(wave_transits < MIN_ROD_TRANSITS, WarningKind::ShortPulseInRod, -wave_transits, || {
        format!(
            "e and the stress in the rod are estimates. During the contact a wave travels only {wave_transits:.2} rod diameters; below {MIN_ROD_TRANSITS} the wave in the rod is not one-dimensional. Use a thinner rod, or remove half_space.rod_diameter for a block."
        )
    });
    let ratio = contact_radius / (0.5 * rod.diameter);
    let wide = Warning::new_if(ratio > MAX_CONTACT_OVER_ROD_RADIUS, WarningKind::WideContactOnRod, ratio, || {
        format!(
            "The result is an estimate. Contact radius / rod radius = {ratio:.3} exceeds {MAX_CONTACT_OVER_ROD_RADIUS}: the end of the rod is less stiff under the sphere than a half-space, and the rod may yield through its cross section."
        )
    });
    let short = rod.length.filter(|length| *length < wave_reach).map(|length| {
        let [length_text, least] = [length, wave_reach].map(|length| format_input(length, Dimension::Length));
        let text = format!(
            "e and contact time are wrong. The wave returns from the far end of the rod during the contact (half_space.rod_length = {length_text}, required {least})."
        );
        Warning::new(WarningKind::ShortRod, wave_reach / length, text)
    });
    [thick, wide, short].into_iter().flatten().collect()
}
