//! Pictures of impacts on plates: restitution against Zener's number with its limits, restitution against thickness
//! between foil and half-space, and the force over time. Steel on steel, by the built-in law.

use super::{Picture, log_sampled};
use crate::error::Error;
use crate::impact::{Contact, Forces, Impact, Plate, PlateTheory, Solver};
use crate::law::Plm;
use crate::material::{HalfSpace, Material, Sphere};
use crate::math::functions::{exp, pow};
use crate::plot::{Axis, Chart, Guide, Series, Style};

const STEEL: Material = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
const DENSITY: f64 = 7850.0;
/// Diameter of the ball \[m\].
const DIAMETER: f64 = 5e-3;

/// The ball on a plate of this thickness \[m\], or on a half-space.
fn contact(yield_strength: Option<f64>, plate: Option<(f64, PlateTheory)>) -> Result<Contact, Error> {
    let sphere = Sphere::elastic(0.5 * DIAMETER, STEEL, DENSITY);
    let half_space = HalfSpace { material: STEEL, yield_strength, density: Some(DENSITY) };
    let plate = plate.map(|(thickness, theory)| Plate { thickness, edge_distance: None, theory });
    Ok(Contact::try_new(sphere, half_space, &Plm::default())?.with_forces(Forces { plate, ..Forces::default() }))
}

fn impact(
    yield_strength: Option<f64>,
    plate: Option<(f64, PlateTheory)>,
    speed: f64,
    samples: Option<usize>,
) -> Result<Impact, Error> {
    Ok(contact(yield_strength, plate)?.impact(speed, &Solver::default(), samples)?)
}

/// Yield strength of the plates that yield \[Pa\].
const STRENGTH: Option<f64> = Some(600e6);

pub(super) fn pictures() -> Result<[Picture; 3], Error> {
    Ok([limits()?, thicknesses()?, forces()?])
}

/// e against λ of elastic contacts.
fn limits() -> Result<Picture, Error> {
    let mut elastic = Vec::new();
    for (thickness, _) in log_sampled(0.25e-3, 40e-3, 200, |thickness| (thickness, 0.0)) {
        let of = impact(None, Some((thickness, PlateTheory::Zener)), 1.0, None)?;
        elastic.extend(of.on_plate.map(|plate| (plate.inelasticity, of.restitution)));
    }
    let series = vec![
        Series::bare("Zener's equation, by the program", elastic),
        Series::bare("small λ: exp(−1.730 λ)", log_sampled(1e-3, 2.0, 100, |x| (x, exp(-1.730_173_287 * x)))),
        Series::bare("large λ: 0.679 λ⁻⁵", log_sampled(0.85, 20.0, 2, |x| (x, 0.679_293 * pow(x, -5.0)))),
    ];
    let axes = [
        Axis::log("Zener's number λ", "").between(1e-3, 20.0),
        Axis::log("Restitution e, elastic", "").between(1e-7, 2.0),
    ];
    Ok(("plate-limits".to_owned(), Chart::new("Impact on a thin plate: Zener's curve and its limits", axes, series)))
}

/// e against thickness. The half-space with its waves holds below X = 2, the thin plate from X = 10 on.
fn thicknesses() -> Result<Picture, Error> {
    let mut series = Vec::new();
    let mut ends = [f64::INFINITY, 0.0_f64];
    for (i, speed) in [0.3, 1.0, 3.0].into_iter().enumerate() {
        let half_space = impact(STRENGTH, None, speed, None)?;
        let e = half_space.restitution_with_waves().unwrap_or(half_space.restitution);
        let wave_speed = (STEEL.plane_strain_modulus() / DENSITY).sqrt();
        let at = |thinness: f64| wave_speed * half_space.contact_time / thinness;
        ends = [ends[0].min(at(10.0)), ends[1].max(at(2.0))];
        let curve = |from: f64, to: f64, theory: PlateTheory| {
            let thicknesses = log_sampled(from, to, 60, |thickness| (thickness, 0.0)).into_iter();
            let point =
                |(thickness, _)| Ok((thickness, impact(STRENGTH, Some((thickness, theory)), speed, None)?.restitution));
            thicknesses.map(point).collect::<Result<Vec<_>, Error>>()
        };
        let thin = curve(0.4e-3, at(10.0), PlateTheory::Zener)?;
        let thick = curve(at(10.0), at(4.0), PlateTheory::Thick)?;
        series.push(Series::bare(format!("{speed} m/s"), thin).styled(Style::of(i).solid()));
        series.push(Series::bare("", thick).styled(Style::of(i).branch(1)));
        series.push(Series::bare("", vec![(at(2.0), e), (0.2, e)]).styled(Style::of(i).solid()));
    }
    let axes = [Axis::log("Thickness", "m").between(0.4e-3, 0.2), Axis::linear("Restitution e", "").between(0.0, 0.9)];
    let chart = Chart::new("Steel ball of 5 mm on steel plates, strength 600 MPa", axes, series);
    let guides =
        [Guide::vertical(ends[0], "thin up to here"), Guide::vertical(ends[1], "half-space with waves from here")];
    Ok(("plate-thickness".to_owned(), chart.with_guides(guides)))
}

/// Force over time for three thicknesses.
fn forces() -> Result<Picture, Error> {
    let mut series = Vec::new();
    for (thickness, name) in [(None, "half-space"), (Some(4e-3), "4 mm"), (Some(2e-3), "2 mm"), (Some(1e-3), "1 mm")] {
        let of = impact(STRENGTH, thickness.map(|thickness| (thickness, PlateTheory::Zener)), 1.0, Some(300))?;
        let points = of.trace.iter().map(|row| (row.time, row.force)).collect();
        series.push(Series::bare(format!("{name}: e = {:.3}", of.restitution), points));
    }
    let axes = [Axis::engineering("Time", "s"), Axis::engineering("Force", "N")];
    let title = "Steel ball of 5 mm at 1 m/s on steel plates, strength 600 MPa";
    Ok(("plate-force".to_owned(), Chart::new(title, axes, series)))
}
