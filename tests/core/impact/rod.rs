//! Impacts on the end of a long rod: the references of plates, the momentum of the pulse, and where the theory ends.

use std::f64::consts::PI;

use crate::common::prelude::*;
use crate::common::reference::rows;

/// A steel ball of 5 mm diameter on the end of a steel rod of this diameter \[m\], of 345 MPa.
fn on_rod(rod: Rod, yield_strength: Option<f64>) -> Contact {
    let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
    let half_space = HalfSpace { density: Some(7850.0), ..HalfSpace::flat(steel, yield_strength) };
    let forces = Forces { waveguide: Some(Waveguide::Rod(rod)), ..Forces::default() };
    let sphere = Sphere::elastic(2.5e-3, steel, 7850.0);
    Contact::try_new(sphere, half_space, &Plm::default()).unwrap().with_forces(forces)
}

fn long(diameter: f64) -> Rod {
    Rod { diameter, length: None }
}

/// The impedance ρ c_0 A \[kg/s\] of such a rod.
fn impedance(rod: Rod) -> f64 {
    7850.0 * (210e9_f64 / 7850.0).sqrt() * PI / 4.0 * rod.diameter.powi(2)
}

/// The diameter and the density of a rod with the mobility of a plate, to the last bit: a few spacings of doubles beside √(4/(π Y √(E ρ))).
fn rod_of_same_mobility(modulus: f64, density: f64, mobility: f64) -> (f64, f64) {
    let of = |density: f64, diameter: f64| 1.0 / (modulus * density).sqrt() / (0.25 * PI * diameter * diameter);
    let beside = |number: f64, steps: i64| f64::from_bits(number.to_bits().checked_add_signed(steps).unwrap());
    let diameter = (4.0 / (PI * mobility * (modulus * density).sqrt())).sqrt();
    let all = (-9..=9).flat_map(|i| (-9..=9).map(move |k| (beside(density, i), beside(diameter, k))));
    all.into_iter().find(|(density, diameter)| of(*density, *diameter) == mobility).expect("no such rod")
}

/// Twelve impacts on plates with 30 digits (`references.rs`). A rod with the mobility of the plate gives way as the plate does, so all
/// results are the same bits.
#[test]
fn rod_has_bits_of_plate_of_same_mobility() {
    for row in rows(include_str!("../../reference/plate.csv")) {
        let (scene, plate) = (row.scene(), row.contact());
        let HalfSpace { material, density, .. } = *plate.half_space();
        let (density, thickness) = (density.unwrap(), row.number("half_space.thickness"));
        // as `Plate` computes it
        let mobility =
            12.0_f64.sqrt() / 8.0 / (material.plane_strain_modulus() * density).sqrt() / thickness / thickness;
        let (density, diameter) = rod_of_same_mobility(material.youngs_modulus, density, mobility);
        let keys = row.keys(&["half_space.thickness", "half_space.density"]);
        let more = [format!("half_space.density={density:?}"), format!("half_space.rod_diameter={diameter:?}")];
        let rod = crate::common::scene("", &[keys, more.to_vec()].concat()).contact().unwrap();
        for solver in [Solver::default(), solver(Method::Dop853, 1e-12)] {
            let [mut on_plate, on_rod] =
                [&plate, &rod].map(|contact| contact.impact(scene.speed(), &solver, Some(50)).unwrap());
            let [of_plate, of_rod] = [&on_plate, &on_rod].map(|impact| impact.row.waveguide.unwrap());
            assert_eq!(of_plate.zener_number.to_bits(), of_rod.zener_number.to_bits(), "{}", row.name());
            assert_eq!(of_plate.energy.to_bits(), of_rod.energy.to_bits(), "{}", row.name());
            assert_eq!(of_plate.displacement.to_bits(), of_rod.displacement.to_bits(), "{}", row.name());
            // what is left are all results of the sphere
            on_plate.row.waveguide = on_rod.row.waveguide;
            assert_eq!(on_plate.row, on_rod.row, "{}", row.name());
            for (plate, rod) in on_plate.trace.iter().zip(&on_rod.trace) {
                assert_eq!((plate.force, plate.sphere_speed), (rod.force, rod.sphere_speed), "{}", row.name());
            }
        }
    }
}

/// The sphere loses the momentum m (1 + e) v, which is ∫F dt, and the pulse in the rod has it: ρ c_0 A times the displacement. The pulse has
/// the energy ∫F² dt/(ρ c_0 A).
#[test]
fn pulse_in_rod_has_momentum_and_energy_of_force() {
    let rod = long(8e-3);
    for (strength, speed) in [(None, 1.0), (Some(345e6), 1.0)] {
        let contact = on_rod(rod, strength);
        let impact = contact.impact(speed, &Solver::default(), Some(4000)).unwrap();
        let result = impact.row.waveguide.unwrap();
        let momentum = contact.mass() * (1.0 + impact.row.restitution) * speed;
        assert!(relative_error(impedance(rod) * result.displacement, momentum) < 1e-9);
        let sum = |value: fn(f64) -> f64| {
            let pairs = impact.trace.windows(2);
            pairs.map(|at| 0.5 * (at[1].time - at[0].time) * (value(at[0].force) + value(at[1].force))).sum::<f64>()
        };
        assert!(relative_error(sum(|force| force), momentum) < 1e-6, "{:e} {momentum:e}", sum(|force| force));
        let energy = sum(|force| force * force) / impedance(rod);
        assert!(relative_error(result.energy, energy) < 1e-6, "{:e} {energy:e}", result.energy);
        let lost = 1.0 - impact.row.restitution.powi(2) - impact.row.plastic_fraction;
        assert!(relative_error(impact.row.waveguide_loss_fraction(WaveguideKind::Rod).unwrap(), lost) < 1e-8);
        assert!(impact.row.waveguide_loss_fraction(WaveguideKind::Plate).is_none());
        let area = PI * (4e-3_f64).powi(2);
        assert!(relative_error(impact.row.rod_peak_stress().unwrap(), impact.row.peak_force / area) < 1e-14);
        for row in &impact.trace {
            assert!((row.rod_stress.unwrap() - row.force / area).abs() <= 1e-14 * impact.row.peak_force / area);
        }
    }
}

#[test]
fn doubtful_rods_are_warned_of() {
    let impact = |rod: Rod| on_rod(rod, None).impact(0.5, &Solver::default(), None).unwrap();
    let warned = |rod: Rod| impact(rod).warnings.iter().map(|warning| warning.kind).collect::<Vec<_>>();
    assert_eq!(warned(long(8e-3)), []);
    // X goes with 1/d
    let transits = impact(long(8e-3)).row.waveguide.unwrap().wave_transits;
    let with = |wave_transits: f64| long(8e-3 * transits / wave_transits);
    assert_eq!(warned(with(4.01)), []);
    assert_eq!(warned(with(3.99)), [WarningKind::ShortPulseInRod]);
    // c_0 t_c/2
    let Impact { row, .. } = impact(long(8e-3));
    let reach = row.waveguide.unwrap().wave_reach;
    assert!(relative_error(reach, 0.5 * (210e9_f64 / 7850.0).sqrt() * row.contact_time) < 1e-14);
    let of_length = |share: f64| Rod { length: Some(share * reach), ..long(8e-3) };
    assert_eq!(warned(of_length(1.001)), []);
    assert_eq!(warned(of_length(0.999)), [WarningKind::ShortRod]);
    let thin = on_rod(long(1e-3), None).impact(8.0, &Solver::default(), None).unwrap().warnings;
    let thin: Vec<WarningKind> = thin.iter().map(|warning| warning.kind).collect();
    assert!(
        thin.contains(&WarningKind::WideContactOnRod) && thin.contains(&WarningKind::InelasticWaveguide),
        "{thin:?}"
    );
}

#[test]
fn impossible_rods_are_refused() {
    let refused = |contact: &Contact| match contact.impact(1.0, &Solver::default(), None) {
        Err(ImpactError::Waveguide(WaveguideError { kind: WaveguideKind::Rod, reason })) => reason,
        other => panic!("{other:?}"),
    };
    let WaveguideFault::TooThin { least, .. } = refused(&on_rod(long(1e-5), None)) else { panic!() };
    let just = on_rod(long(1.001 * least), None).impact(1.0, &Solver::default(), None).unwrap();
    assert!(relative_error(just.row.waveguide.unwrap().zener_number, 20.0) < 3e-3);
    let damping = Some(Damping::Viscous(0.1));
    let contact = on_rod(long(8e-3), None);
    let damped = contact.clone().with_forces(Forces { damping, ..*contact.forces() });
    assert_eq!(refused(&damped), WaveguideFault::Damped);
    // the end of a rod is flat, and rests
    for (radius, support) in [(Some(0.05), Support::Fixed), (None, Support::Free(1.0))] {
        let half_space = HalfSpace { radius, support, ..*contact.half_space() };
        let moved = Contact::try_new(*contact.sphere(), half_space, &Plm::default()).unwrap();
        assert_eq!(refused(&moved.with_forces(*contact.forces())), WaveguideFault::Curved, "{support:?}");
    }
}
