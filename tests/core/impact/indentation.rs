//! Slow indentation: closed forms of the loops, memory, and random steps.

use SetPoint::{Indentation as To, Load};
use plm_impact::impact::indentation::{SetPoint, StepResult, StepWarning};

use crate::common::prelude::*;

/// The tungsten carbide sphere of Xie et al. 2024, section 4.3.
fn indenter() -> Sphere {
    Sphere::elastic(0.25e-3, Material { youngs_modulus: 600e9, poissons_ratio: 0.23 }, f64::NAN)
}

/// A Ti-xNb alloy of Table 3 of Xie et al. 2024.
fn alloy(youngs_modulus: f64, yield_strength: Option<f64>) -> HalfSpace {
    HalfSpace::flat(Material { youngs_modulus, poissons_ratio: 0.3 }, yield_strength)
}

fn contact(half_space: &HalfSpace, exponent: UnloadingExponent) -> StaticContact {
    StaticContact::try_new(&indenter(), half_space, &Plm { exponent, ..Plm::default() }).unwrap()
}

fn ti_10_nb(exponent: UnloadingExponent) -> StaticContact {
    contact(&alloy(77e9, Some(630e6)), exponent)
}

fn steps(contact: &StaticContact, targets: &[SetPoint]) -> Vec<StepResult> {
    contact.indent(targets, None).unwrap().steps
}

#[test]
fn an_elastic_loop_is_hertz_to_and_fro() {
    let contact = contact(&alloy(77e9, None), UnloadingExponent::Paper);
    let e_star = contact.pair().effective_modulus;
    let done = contact.indent(&[Load(30.0), Load(12.0), Load(0.0), To(1e-6)], Some(50)).unwrap();
    // F = (4/3) E* √R δ^1.5, a = √(R δ), W = (2/5) F δ, S = 2 E* a
    let depth = |load: f64| (0.75 * load / (e_star * 0.25e-3f64.sqrt())).powf(2.0 / 3.0);
    for (step, load) in done.steps.iter().zip([30.0, 12.0, 0.0]) {
        assert!((step.indentation - depth(load)).abs() < 1e-13 * depth(30.0));
        assert!((step.force - load).abs() < 1e-12 * 30.0);
        assert!((step.stored_energy - 0.4 * load * depth(load)).abs() < 1e-12 * 30.0 * depth(30.0));
        assert_eq!((step.plastic_work, step.peak.residual_indentation), (0.0, 0.0));
    }
    let radius = (0.25e-3 * depth(30.0)).sqrt();
    assert!(relative_error(done.steps[0].peak.contact_radius, radius) < 1e-13);
    assert!(relative_error(done.steps[2].peak.unloading_stiffness, 2.0 * e_star * radius) < 1e-13);
    let branches: Vec<_> = done.steps.iter().map(|step| step.branch).collect();
    assert_eq!(branches, [Branch::Elastic, Branch::Unloading, Branch::Unloading, Branch::Reloading]);
    for row in &done.trace {
        assert!((row.force - 4.0 / 3.0 * e_star * (0.25e-3 * row.indentation).sqrt() * row.indentation).abs() < 1e-11);
        let kappa = contact.pair().sphere_compliance;
        assert!((row.sphere_indentation - kappa * row.indentation).abs() < 1e-18);
    }
}

/// On a ball the radius of Hertz's contact is the effective one, 1/R = 1/0.25 mm + 1/0.5 mm.
#[test]
fn elastic_contact_of_two_balls_follows_hertz() {
    let ball = HalfSpace { radius: Some(0.5e-3), ..alloy(77e9, None) };
    let contact = contact(&ball, UnloadingExponent::Paper);
    let memory = steps(&contact, &[To(1e-6)])[0].peak;
    // a = √(R δ), F = (4/3) E* a δ
    let width = (0.5e-3 / 3.0 * 1e-6_f64).sqrt();
    let force = 4.0 / 3.0 * contact.pair().effective_modulus * width * 1e-6;
    assert!(relative_error(memory.force, force) < 1e-13 && relative_error(memory.contact_radius, width) < 1e-13);
    assert!(relative_error(memory.mean_pressure, force / (std::f64::consts::PI * width * width)) < 1e-13);
}

#[test]
fn loop_energy_is_work_minus_recovered_energy() {
    // from the definition of the law: ∮ F dδ = W − F_m δ_e/(n + 1), S = n F_m/δ_e, δ_r = δ_m − δ_e
    for (exponent, n) in [
        (UnloadingExponent::Paper, 1.5),
        (UnloadingExponent::Fixed(1.8), 1.8),
        (UnloadingExponent::PressureShape, f64::NAN),
    ] {
        let contact = ti_10_nb(exponent);
        let done = contact.indent(&[Load(30.0), Load(0.0)], Some(2000)).unwrap();
        let [up, down] = done.steps[..] else { panic!() };
        let n = if n.is_nan() { up.peak.unloading_exponent } else { n };
        let recovered = up.indentation - up.peak.residual_indentation;
        assert!(relative_error(up.work + down.work, up.work - 30.0 * recovered / (n + 1.0)) < 1e-13);
        assert!(relative_error(up.plastic_work, up.work + down.work) < 1e-13 && down.plastic_work == 0.0);
        assert!(relative_error(up.peak.unloading_stiffness, n * 30.0 / recovered) < 1e-13);
        assert!(relative_error(down.indentation, up.peak.residual_indentation) < 1e-15 && down.force == 0.0);
        // the area of the traced loop is this work: trapezoids of 2000 rows per step
        let area: f64 = done
            .trace
            .windows(2)
            .map(|rows| 0.5 * (rows[0].force + rows[1].force) * (rows[1].indentation - rows[0].indentation))
            .sum();
        assert!(relative_error(area, up.plastic_work) < 1e-6, "{area} {}", up.plastic_work);
        // the slope of the traced curve at the beginning of unloading
        let down: Vec<_> = done.trace.iter().filter(|row| row.step == 2).collect();
        let (a, b) = (down[0], down[1]);
        assert!(
            relative_error((a.force - b.force) / (a.indentation - b.indentation), up.peak.unloading_stiffness) < 1e-3
        );
    }
}

#[test]
fn no_contact_and_no_force_above_dent() {
    let contact = ti_10_nb(UnloadingExponent::Paper);
    let done = contact.indent(&[Load(20.0), To(1e-6), To(0.0), To(2e-6), Load(5.0)], Some(30)).unwrap();
    let residual = done.steps[0].peak.residual_indentation;
    assert!(residual > 2e-6);
    for step in &done.steps[1..4] {
        assert_eq!((step.force, step.sphere_indentation, step.branch), (0.0, 0.0, Branch::Separated));
    }
    assert!(relative_error(done.steps[1].work, -20.0 * (done.steps[0].indentation - residual) / 2.5) < 1e-13);
    assert_eq!((done.steps[2].work, done.steps[3].work), (0.0, 0.0));
    // the trace has a row of zero force where the surfaces separate, and the dent does not change beyond it
    let parting: Vec<_> = done.trace.iter().filter(|row| row.indentation == residual).collect();
    assert_eq!(parting.len(), 2, "once on the way out, once on the way in");
    for row in done.trace.iter().filter(|row| row.branch == Branch::Separated) {
        assert_eq!((row.force, row.sphere_indentation, row.half_space_indentation), (0.0, 0.0, residual));
    }
    // a load of zero is the place where the surfaces separate
    assert!(relative_error(steps(&contact, &[Load(20.0), Load(0.0)])[1].indentation, residual) < 1e-15);
}

#[test]
fn step_warns_once_of_its_own_problem() {
    // nothing says how hard a half-space will be that hardens
    let strong = Sphere { yield_strength: Some(1.2e9), ..indenter() };
    let half_space = alloy(77e9, Some(630e6));
    let plm = Plm { flow: [None, Some(FlowCurve::Power { exponent: 0.01 })], ..Plm::default() };
    let contact = StaticContact::try_new(&strong, &half_space, &plm).unwrap();
    let warnings = |targets: &[SetPoint]| contact.indent(targets, None).unwrap().warnings;
    assert!(warnings(&[Load(1.0), Load(0.0)]).is_empty());
    let found = warnings(&[Load(1.0), Load(170.0), Load(0.0), Load(180.0)]);
    assert!(
        matches!(
            found[..],
            [
                StepWarning { step: 2, warning: Warning { kind: WarningKind::DeepDent, .. } },
                StepWarning { step: 2, warning: Warning { kind: WarningKind::SphereYields, .. } }
            ]
        ),
        "{found:?}"
    );
}

proptest! {
    #![proptest_config(crate::common::proptest_config(128))]

    #[test]
    fn random_steps_keep_the_books(
        modulus in 10.0..11.7f64,
        strength in prop::option::of(7.5..9.5f64),
        shape in any::<bool>(),
        targets in prop::collection::vec((any::<bool>(), 0.0..1.0f64), 1..12),
    ) {
        let exponent = if shape { UnloadingExponent::PressureShape } else { UnloadingExponent::Paper };
        let contact = contact(&alloy(10f64.powf(modulus), strength.map(|s| 10f64.powf(s))), exponent);
        // loads up to the load at an indentation of a tenth of the radius
        let most = steps(&contact, &[To(25e-6)])[0].force;
        let targets: Vec<_> = targets.iter().map(|(is_load, share)| {
            if *is_load { Load(share * most) } else { To(share * 25e-6) }
        }).collect();
        let done = contact.indent(&targets, Some(20));
        // a step without movement is refused; it occurs only after separation, because random targets differ
        prop_assume!(done.is_ok());
        let done = done.unwrap();
        let (mut work, mut plastic, mut largest) = (0.0, 0.0, 0.0);
        let scale = most * 25e-6;
        for (target, step) in targets.iter().zip(&done.steps) {
            work += step.work;
            plastic += step.plastic_work;
            // plastic work is never negative, except that the straight pieces allow as much as they let e rise, at most
            // 0.12 %
            prop_assert!(step.plastic_work >= -2.4e-3 * step.work.abs());
            prop_assert!((work - plastic - step.stored_energy).abs() < 1e-12 * scale);
            prop_assert!(step.peak.force >= largest);
            largest = step.peak.force;
            match *target {
                Load(load) => {
                    prop_assert!((step.force - load).abs() < 1e-11 * most);
                    // displacement control to the end of a step in load control gives the same load
                    let mut others = targets[..done.steps.iter().position(|other| other == step).unwrap()].to_vec();
                    others.push(To(step.indentation));
                    if let Ok(again) = contact.indent(&others, None) {
                        prop_assert!((again.steps.last().unwrap().force - load).abs() < 1e-11 * most);
                    }
                }
                To(indentation) => prop_assert!((step.indentation - indentation).abs() < 1e-12 * 25e-6),
            }
        }
        for row in &done.trace {
            prop_assert!(row.force >= 0.0 && row.sphere_indentation >= 0.0);
            if row.branch != Branch::Separated {
                let sum = row.sphere_indentation + row.half_space_indentation;
                prop_assert!((sum - row.indentation).abs() < 1e-14 * 25e-6 + 1e-20);
            }
        }
    }
}
