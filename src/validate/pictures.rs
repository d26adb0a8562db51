//! Pictures of the validation: the law (lines) beside the reference (points).

use rayon::prelude::*;

use super::cases::{MaterialCase, cases};
use super::comparison::{EXPONENTS, deviation};
use super::dynamic;
use super::figure_10::figure_10;
use super::hardening::hardening_law;
use super::law_error::cycle_errors;
use super::leeb::restitution as of_device;
use super::load_cycle::LoadCycle;
use super::oblique::{FRICTION, alumina_on_glass, rebound, single_spring_ratio};
use super::yielding::yielding_cycles;
use crate::contact::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::files::{OutputFile, Progress};
use crate::impact::{ImpactError, TraceRow};
use crate::numerics::functions::{exp, ln, sin_cos};
use crate::reference::{HARDENING, LEEB_DEVICES, LEEB_STEELS, REBOUNDS, ReferenceRow};
use crate::report::chart::{Axis, Chart, Panel, PictureFormat, Series, Style};
use crate::scenario::keys::interval::law_error::BodyClass;
use crate::units::{Dimension, format_result};

/// A picture before it is drawn, with the name of its file without the ending.
type Picture = (String, Chart);

/// A curve of 300 pieces from 1 to `high`, with equal ratios.
fn log_sampled(high: f64, point: impl Fn(f64) -> (f64, f64)) -> Vec<(f64, f64)> {
    (0..=300).map(|i| point(exp(ln(high) * f64::from(i) / 300.0))).collect()
}

/// All pictures. `progress` counts them.
pub fn pictures(
    coefficients: &PlmCoefficients,
    format: PictureFormat,
    progress: &Progress,
) -> Result<Vec<OutputFile>, Error> {
    if format == PictureFormat::None {
        return Ok(Vec::new());
    }
    let cases = cases()?;
    let mut pictures = vec![restitution_error_against_depth(&cases, coefficients)];
    if let Some(case) = cases.iter().find(|case| case.loading.case == "case3") {
        pictures.push(restitution_against_depth(case, coefficients));
        pictures.extend(figure_10(case)?);
    }
    pictures.extend(dynamic::cases(coefficients)?.iter().map(impact));
    pictures.push(hardening(coefficients)?);
    pictures.push(restitution_error_against_radius(coefficients)?);
    pictures.push(yielding(coefficients, &cases)?);
    pictures.push(leeb(coefficients)?);
    pictures.push(oblique()?);
    progress.add_total(pictures.len() as u64);
    let file = |(name, chart): &Picture| format.to_file(name, chart).inspect(|_| progress.advance());
    let drawn: Result<Vec<Option<OutputFile>>, Error> = pictures.par_iter().map(file).collect();
    Ok(drawn?.into_iter().flatten().collect())
}

fn depth_axis() -> Axis {
    Axis::log("Peak indentation over that at yield", "")
}

/// The caption that says where the cases come from.
const CASES: &str = "cases are pairs of bodies of Table 1 of Xie et al. (2024)";

/// The deviation of the restitution of all load cycles: a box for each exponent, a marker for each pair of materials.
fn restitution_error_against_depth(cases: &[MaterialCase], coefficients: &PlmCoefficients) -> Picture {
    let of_exponent = |(which, (exponent, name)): (usize, (_, &str))| {
        let of_case = |(i, case): (usize, &MaterialCase)| {
            let law = case.law(coefficients, exponent);
            let off = |x, e| (x, 100.0 * deviation(e, LoadCycle::to_depth(&law, x).restitution));
            let points = case
                .cycles
                .iter()
                .filter_map(|cycle| Some(off(cycle.peak.indentation, cycle.row.optional_number("restitution")?)));
            let name = if which == 0 { case.name() } else { String::new() };
            Series::points(name, points.collect()).with_style(i)
        };
        let series = cases.iter().enumerate().map(of_case).collect();
        let y = Axis::linear(&format!("error of e, {name}"), "%").with_range(-6.5, 2.5);
        let mut panel = Panel::new(y, series);
        panel.guides.push(Series::horizontal(0.0, ""));
        panel
    };
    let panels = EXPONENTS.into_iter().enumerate().map(of_exponent).collect();
    let chart =
        Chart::with_panels("Error of the restitution of the law, against finite elements", depth_axis(), panels);
    ("error-restitution".to_owned(), chart.with_caption(CASES))
}

/// The classes in the picture of errors against contact radius.
const CLASSES: [(BodyClass, &str); 4] = [
    (BodyClass::PerfectlyPlastic, "perfectly plastic"),
    (BodyClass::Hardening, "hardens"),
    (BodyClass::YieldingSphere, "sphere yields"),
    (BodyClass::OtherPoissonsRatio, "ν 0.03 to 0.42, over ν = 0.3"),
];

/// The deviation of the restitution of all load cycles and impacts, over the contact radius.
fn restitution_error_against_radius(coefficients: &PlmCoefficients) -> Result<Picture, Error> {
    let errors = cycle_errors(coefficients, UnloadingExponent::PressureShape)?;
    let of_class = |(i, (class, name)): (usize, (BodyClass, &str))| {
        let here = errors.iter().filter(|(other, ..)| *other == class);
        Series::points(name, here.map(|(_, ratio, error)| (*ratio, 100.0 * error)).collect()).with_style(i)
    };
    let series = CLASSES.into_iter().enumerate().map(of_class).collect();
    let mut panel = Panel::new(Axis::linear("error of e, pressure-shape", "%"), series);
    panel.guides.push(Series::horizontal(0.0, ""));
    let x = Axis::linear("Contact radius over radius of the sphere", "");
    let chart = Chart::with_panels("Error of the restitution of the law, against finite elements", x, vec![panel]);
    Ok(("error-restitution-contact-radius".to_owned(), chart.with_caption("load cycles and whole impacts")))
}

fn restitution_against_depth(case: &MaterialCase, coefficients: &PlmCoefficients) -> Picture {
    let deepest = case.cycles.last().map_or(10.0, |cycle| cycle.peak.indentation);
    let cycles = case
        .cycles
        .iter()
        .filter_map(|cycle| Some((cycle.peak.indentation, cycle.row.optional_number("restitution")?)));
    let mut series = vec![Series::points("finite elements", cycles.collect())];
    for (i, (exponent, name)) in EXPONENTS.into_iter().enumerate() {
        let law = case.law(coefficients, exponent);
        let curve = log_sampled(1.1 * deepest, |x| (x, LoadCycle::to_depth(&law, x).restitution));
        series.push(Series::line(format!("law, {name}"), curve).with_style(i + 1));
    }
    let y = Axis::linear("Restitution e", "").with_range(0.15, 1.02);
    let chart = Chart::new(format!("Restitution against depth, {}", case.name()), [depth_axis(), y], series);
    let chart = chart.with_caption(CASES);
    (format!("restitution-{}", case.name().replace(' ', "-")), chart)
}

/// The step from marker to marker, in samples of finite elements; the lines below the markers stay visible.
const MARKER_STRIDE: usize = 4;

/// An indentation: its name, its column of the reference, and its value in the law.
type IndentationPart = (&'static str, &'static str, fn(&TraceRow) -> f64);

const INDENTATIONS: [IndentationPart; 3] = [
    ("approach δ", "indentation_m", |row| row.indentation),
    ("sphere δₛ", "sphere_indentation_m", |row| row.sphere_indentation),
    ("half-space δₕ", "half_space_indentation_m", |row| row.half_space_indentation),
];

/// Force against indentations of a whole impact (Fig. 12 of Xie et al. 2024).
fn impact(case: &dynamic::DynamicCase) -> Picture {
    let mut series = Vec::new();
    for (i, (name, column, of_row)) in INDENTATIONS.into_iter().enumerate() {
        let samples = case.samples.iter().step_by(MARKER_STRIDE);
        let points = samples.map(|sample| (sample.number(column), sample.number("force_N")));
        series.push(Series::points(name, points.collect()).with_style(i));
        for (which, impact) in case.impacts.iter().enumerate() {
            let curve = impact.trace.iter().map(|row| (of_row(row), row.force)).collect();
            series.push(Series::line("", curve).with_style(Style::new(i).with_line_of_branch(which)));
        }
    }
    let mut notes = vec!["points: finite elements".to_owned(), "Restitution".to_owned()];
    notes.push(format!("  finite elements: {:.4}", case.reference.number("restitution")));
    let of_law = case.impacts.iter().zip(EXPONENTS);
    notes.extend(of_law.map(|(impact, (_, name))| format!("  {name}: {:.4}", impact.row.restitution)));
    let with_waves = case.impacts[1].row.restitution_with_waves();
    notes.extend(with_waves.map(|restitution| format!("  … with waves: {restitution:.4}")));
    let axes = [Axis::linear("Indentation", "m"), Axis::linear("Force", "N")];
    let (name, slug) = (case.reference.cell_text("case"), case.reference.cell_text("case").to_lowercase());
    let title = format!("Impact {name} at {}", format_result(case.impacts[0].speed, Dimension::Speed));
    let chart = Chart::new(title, axes, series).with_branches(&EXPONENTS.map(|(_, name)| name)).with_notes(notes);
    (format!("impact-{slug}-force-indentation"), chart)
}

/// Materials that harden, and their names in the picture.
const METALS: [(&str, &str); 3] =
    [("c3n10", "steel, N = 0.1"), ("alvoce", "aluminium, Voce"), ("cun30", "copper, N = 0.3")];

/// Restitution against depth on half-spaces that harden, by the law with the flow curve and with the initial yield
/// strength.
fn hardening(coefficients: &PlmCoefficients) -> Result<Picture, Error> {
    let rows = HARDENING.rows()?;
    let mut series = Vec::new();
    for (i, (name, called)) in METALS.into_iter().enumerate() {
        let of_material: Vec<_> = rows.iter().filter(|row| row.cell_text("material") == name).collect();
        let Some(materials) = of_material.first() else { continue };
        let point = |row: &&ReferenceRow| (row.number("x"), row.number("restitution"));
        let points: Vec<(f64, f64)> = of_material.iter().map(point).collect();
        let deepest = points.iter().map(|point| point.0).fold(1.0, f64::max);
        series.push(Series::points(called, points).with_style(i));
        for (which, hardens) in [true, false].into_iter().enumerate() {
            let Some((law, _)) = hardening_law(materials, coefficients, hardens)? else { continue };
            let curve = log_sampled(1.2 * deepest, |x| (x, LoadCycle::to_depth(&law, x).restitution));
            series.push(Series::line("", curve).with_style(Style::new(i).with_line_of_branch(which)));
        }
    }
    let axes = [
        Axis::log("Peak indentation over that at first yield", ""),
        Axis::linear("Restitution e, pressure-shape", "").with_range(0.1, 1.02),
    ];
    let chart = Chart::new("Restitution on metals that harden", axes, series);
    let chart =
        chart.with_branches(&["law, flow curve", "law, initial strength"]).with_notes(["points: finite elements"]);
    Ok(("hardening-restitution".to_owned(), chart))
}

/// The pairs of steel in the picture of bodies that yield, all of the same strength; the dents are those of case 3.
const YIELDING: [(&str, &str); 2] = [("S1", "sphere: flat"), ("S3", "both")];

/// Restitution against contact radius, where the half-space yields, the sphere, or both.
fn yielding(coefficients: &PlmCoefficients, cases: &[MaterialCase]) -> Result<Picture, Error> {
    let (all, mut series) = (yielding_cycles(coefficients, UnloadingExponent::PressureShape)?, Vec::new());
    let mut add = |called: &str, law: &Law, ratio: f64, points: Vec<(f64, f64)>, deepest: f64| {
        let style = series.len() / 2;
        series.push(Series::points(called, points).with_style(style));
        let at = |x| {
            let cycle = LoadCycle::to_depth(law, x);
            (cycle.contact_radius * ratio, cycle.restitution)
        };
        series.push(Series::line("", log_sampled(1.1 * deepest, at)).with_style(style));
    };
    for case in cases.iter().filter(|case| case.loading.case == "case3") {
        let law = case.law(coefficients, UnloadingExponent::PressureShape);
        let point =
            |row: &ReferenceRow| Some((row.number("contact_radius_over_R"), row.optional_number("restitution")?));
        let points = case.cycles.iter().filter_map(|cycle| point(&cycle.row)).collect();
        let deepest = case.cycles.iter().map(|cycle| cycle.peak.indentation).fold(1.0, f64::max);
        add("half-space: dent", &law, case.loading.yield_radius_ratio, points, deepest);
    }
    for (name, called) in YIELDING {
        let of_pair: Vec<_> = all.iter().filter(|cycle| cycle.row.cell_text("case") == name).collect();
        let Some(first) = of_pair.first() else { continue };
        let point = |row: &ReferenceRow| (row.number("contact_radius_over_R"), row.number("e"));
        let points = of_pair.iter().map(|cycle| point(&cycle.row)).collect();
        let deepest = of_pair.iter().map(|cycle| cycle.at_depth).fold(1.0, f64::max);
        add(called, &first.law, first.bodies.yield_radius_ratio(), points, deepest);
    }
    let axes = [
        Axis::log("Contact radius over radius of the sphere a/R", ""),
        Axis::linear("Restitution e, pressure-shape", "").with_range(0.25, 1.02),
    ];
    let chart = Chart::new("Restitution where sphere, half-space or both yield", axes, series);
    let chart = chart.with_notes(["points: finite elements", "lines: law"]).with_caption("yield strength 345 MPa");
    Ok(("yielding-restitution".to_owned(), chart))
}

/// The rebound hardness of steels against their tensile strength: as measured, and by the law with two strengths that are
/// often used as yield strength. The 0.2 % strength of a structural steel is 0.65 of the tensile.
fn leeb(coefficients: &PlmCoefficients) -> Result<Picture, Error> {
    let steels = LEEB_STEELS.rows()?;
    let end = |steel: &ReferenceRow, which: &str| {
        (steel.number(&format!("{which}_tensile_strength_MPa")), steel.number(&format!("{which}_HLD")))
    };
    // a point of NaN separates the steels
    let ranges = steels.iter().flat_map(|steel| [end(steel, "low"), end(steel, "high"), (f64::NAN, f64::NAN)]);
    let ranges = ranges.collect();
    let mut series =
        vec![Series::line("measured, ten steels", ranges).with_note("each from end to end of its range").with_style(0)];
    let lines = [(1.0, "law, tensile strength", "as yield strength"), (0.65, "law, 0.2 % strength", "0.65 × tensile")];
    for (device, (i, (share, name, assumption))) in
        LEEB_DEVICES.rows()?.iter().take(1).cycle().zip(lines.into_iter().enumerate())
    {
        let mut points = Vec::new();
        for step in 0..=60 {
            let tensile = 350.0 + 2350.0 * f64::from(step) / 60.0;
            points.push((tensile, 1000.0 * of_device(device, 1e6 * share * tensile, coefficients)?));
        }
        series.push(Series::line(name, points).with_note(assumption).with_style(1 + i));
    }
    let axes = [
        Axis::linear("Tensile strength", "MPa"),
        Axis::linear("HLD = 1000 × restitution", "").with_range(150.0, 900.0),
    ];
    let chart = Chart::new("Rebound hardness of steels (Leeb, device D)", axes, series);
    Ok(("measured-leeb-tensile-strength".to_owned(), chart))
}

/// The tangential restitution against the angle: measured, by the program, by the spring of DEM codes, and of a rigid
/// body.
fn oblique() -> Result<Picture, Error> {
    let rows = REBOUNDS.rows()?;
    let measured = rows.iter().filter(|row| row.cell_text("quantity") == "tangential_restitution");
    let measured = measured.map(|row| (row.number("angle_deg"), row.number("value"))).collect();
    let measured = Series::points("measured, alumina on glass", measured);
    let contact = alumina_on_glass()?;
    let (chi, j) = (contact.chi(), contact.slip_factor());
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    // up to 65 degrees
    for step in 1..=260 {
        let degrees = 0.25 * f64::from(step);
        let angle = degrees.to_radians();
        let Some(after) = rebound(&contact, angle, FRICTION)? else { continue };
        let (sin, cos) = sin_cos(angle);
        // s_0 = v_t, so that e_t = 1 + (s_1/s_0 - 1)/j
        let psi = 4.0 * contact.shear_ratio() * sin / cos / FRICTION;
        let sliding = 1.0 - 4.0 * chi / psi;
        let ratios = [
            -after.contact_point_restitution,
            single_spring_ratio(psi, chi).map_err(ImpactError::from)?,
            sliding.max(0.0),
        ];
        for (curve, ratio) in curves.iter_mut().zip(ratios) {
            curve.push((degrees, 1.0 + (ratio - 1.0) / j));
        }
    }
    let names = ["this program", "one spring, as in LAMMPS", "rigid body"];
    let mut series = vec![measured.with_style(Style::BLACK)];
    let curves = names.into_iter().zip(curves).enumerate();
    series.extend(curves.map(|(i, (name, curve))| Series::line(name, curve).with_style(i)));
    let axes = [
        Axis::linear("Angle of impact from the normal", "°"),
        Axis::linear("Tangential restitution vₜ′/vₜ", "").with_range(0.5, 1.0),
    ];
    let chart =
        Chart::new("Oblique rebound of alumina from glass", axes, series).with_caption("3.9 m/s, friction 0.092");
    Ok(("oblique-alumina-on-glass".to_owned(), chart))
}
