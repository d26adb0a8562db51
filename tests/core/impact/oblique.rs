//! Oblique impacts: every row of `tests/reference/oblique.csv`, the curve of Maw, Barber and Fawcett, limits, and what must
//! hold for any scene.

mod spin;
mod with_forces;

use crate::common::prelude::*;
use approx::assert_abs_diff_eq;
use plm_impact::impact::oblique::normal_motion::NormalMotion;
use plm_impact::validate::oblique::single_spring_ratio;

use crate::common::reference::rows;

/// The accuracy of a run by itself, and of one in a table.
const OF_RUNS: f64 = 2e-9;
const OF_ROWS: f64 = 5e-6;

/// s_1/s_0 of an elastic impact.
fn elastic_ratio(psi: f64, chi: f64, accuracy: f64) -> f64 {
    NormalMotion::elastic_motion().unwrap().ratio(psi, chi, accuracy).unwrap()
}

/// The alumina sphere on glass of Kharaz, Gorham and Salman (2001).
fn alumina_on_glass() -> Contact {
    let sphere = Sphere::elastic(2.5e-3, Material { youngs_modulus: 380e9, poissons_ratio: 0.23 }, 4000.0);
    let glass = Material { youngs_modulus: 70e9, poissons_ratio: 0.25 };
    let half_space = HalfSpace::flat(glass, None);
    Contact::try_new(sphere, half_space, &Plm::default()).unwrap()
}

/// A steel sphere of 5 mm radius on the same steel.
fn steel(law: &LawChoice) -> Contact {
    Scene::steel().contact_by(law.as_contact_law())
}

fn approach(speed: f64, degrees: f64, friction: f64, spin: f64) -> Approach {
    Approach::at_angle(speed, degrees.to_radians(), spin, friction)
}

fn impact(contact: &Contact, approach: Approach, samples: Option<usize>) -> (Impact, Rebound) {
    let impact = contact.impact(approach, &Solver::default(), samples).unwrap();
    let rebound = impact.row.rebound.unwrap();
    (impact, rebound)
}

#[test]
fn twelve_impacts_are_those_of_the_reference() {
    let rows = rows(include_str!("../../reference/oblique.csv"));
    assert_eq!(rows.len(), 12);
    for row in rows {
        let (scene, number) = (row.scene(), |name: &str| row.number(name));
        let (contact, approach) = (scene.contact().unwrap(), scene.approach_at(scene.speed()));
        let (impact, rebound) = impact(&contact, approach, Some(20));
        let (name, want) = (row.name(), number("contact_point_ratio_s1_over_s0"));
        assert_abs_diff_eq!(-rebound.contact_point_restitution, want, epsilon = 2e-6);
        assert!(rebound.error < 1e-6, "{name}");
        assert_relative_eq!(rebound.psi, number("psi_1"), max_relative = 1e-12);
        assert_relative_eq!(impact.row.restitution, number("restitution"), max_relative = 1e-9);
        assert_relative_eq!(rebound.tangential.speed, number("rebound_tangential_speed_m_s"), max_relative = 4e-6);
        assert_relative_eq!(rebound.tangential.spin, number("rebound_spin_rad_s"), max_relative = 8e-6);
        // it slides all the time where the reference has the impulse of gross sliding
        let sliding = 1.0 - 2.0 * contact.chi() * (1.0 + impact.row.restitution) / rebound.psi.abs();
        assert_eq!(rebound.is_sliding, (want - sliding).abs() < 2e-6, "{name}");
        // the tangential spring of DEM codes, which the picture of the validation shows
        let (spring, want_of_spring) = (stepped(&contact, approach, 2e4), number("spring_contact_point_ratio"));
        assert!((spring - want_of_spring).abs() < 3e-4, "{name}: {spring} {want_of_spring}");
        if scene.half_space().yield_strength.is_none() {
            let got = single_spring_ratio(rebound.psi, contact.chi()).unwrap();
            assert_abs_diff_eq!(got, want_of_spring, epsilon = 2e-4);
        }
        let of_table = contact.row(approach, &Solver::AUTO).unwrap().rebound.unwrap();
        assert_abs_diff_eq!(-of_table.contact_point_restitution, want, epsilon = 1e-5);
    }
}

/// s_1/s_0 of an impact that is stepped as DEM codes do, with force and friction of the contact: velocity Verlet in `steps`
/// steps a contact.
fn stepped(contact: &Contact, approach: Approach, steps: f64) -> f64 {
    let Approach { normal: mut speed, tangential, friction } = approach;
    let (mass, j, radius) = (contact.mass(), contact.slip_factor(), contact.sphere().radius);
    let slip = tangential.speed - radius * tangential.spin;
    let dt = contact.closed_form(speed).unwrap().row.contact_time / steps;
    let (mut indentation, mut force, mut moving) = (0.0, 0.0, slip);
    let (mut memory, mut history) = (Memory::default(), [0.0; 3]);
    while speed > 0.0 || indentation > memory.dent_depth() {
        speed -= 0.5 * dt * force / mass;
        moving += 0.5 * dt * j / mass * history[0];
        let before = indentation;
        indentation += dt * speed;
        force = contact.force(indentation, &mut memory);
        let step = FrictionStep { previous_indentation: before, indentation, force, slip: [moving * dt, 0.0, 0.0] };
        assert!(contact.friction(friction.unwrap(), &step, &memory, &mut history));
        speed -= 0.5 * dt * force / mass;
        moving += 0.5 * dt * j / mass * history[0];
    }
    assert_eq!(history[1..], [0.0; 2]);
    moving / slip
}

#[test]
fn the_curve_of_maw_barber_and_fawcett() {
    let rows = rows(include_str!("../../reference/maw.csv"));
    assert_eq!(rows.len(), 14);
    for row in rows {
        let psi = row.number("psi_1");
        for (chi, name) in [(1.441_176_5, "chi_1.4411765"), (1.503_501_256, "chi_1.503501256")] {
            let want = row.number(name);
            assert_abs_diff_eq!(elastic_ratio(psi, chi, OF_RUNS), want, epsilon = 1e-7);
            assert_abs_diff_eq!(elastic_ratio(psi, chi, OF_ROWS), want, epsilon = 1e-5);
        }
    }
}

#[test]
fn without_slip_the_sphere_swings_on_a_spring() {
    // psi_2/psi_1 for psi_1 -> 0, by the differential equation in high precision
    for (chi, want) in [(1.441_176_5, 0.231_669_691_05), (1.503_501_256, 0.282_596_443_74)] {
        assert_abs_diff_eq!(elastic_ratio(1e-9, chi, OF_RUNS), want, epsilon = 1e-7);
    }
    // the same from the other end: a coefficient of friction of 1e6
    let (_, rebound) = impact(&alumina_on_glass(), approach(3.9, 30.0, 1e6, 0.0), None);
    assert_abs_diff_eq!(-rebound.contact_point_restitution, 0.282_596_443_74, epsilon = 1e-6);
}

/// Below ψ_1 = 1e-8 only the rim slips: slip and friction at any time are in proportion to the angle.
#[test]
fn hardly_slipping_trace_is_proportional_to_angle() {
    let contact = steel(&LawChoice::default());
    let [small, large] = [1e-9, 1e-6].map(|angle| impact(&contact, approach(3.0, angle, 0.15, 0.0), Some(12)).0.trace);
    let friction = |row: &TraceRow| row.friction.unwrap();
    let force = large.iter().map(|row| friction(row).friction_force.abs()).fold(0.0, nan_max);
    let slip = friction(&large[0]).slip_speed;
    assert!(force > 0.0 && slip > 0.0 && small.len() == large.len());
    for (small, large) in small.iter().zip(&large) {
        let (small, large) = (friction(small), friction(large));
        assert_abs_diff_eq!(1e3 * small.friction_force, large.friction_force, epsilon = 1e-4 * force);
        assert_abs_diff_eq!(1e3 * small.slip_speed, large.slip_speed, epsilon = 1e-4 * slip);
    }
}

/// Dundurs' β by the shear moduli, for bodies of different Poisson's ratio. It changes its sign with the bodies.
#[test]
fn dundurs_beta_is_that_of_the_shear_moduli() {
    let materials = [(380e9, 0.23), (70e9, 0.42)];
    let beta = |[(e_1, nu_1), (e_2, nu_2)]: [(f64, f64); 2]| {
        let sphere = Sphere::elastic(1e-3, Material { youngs_modulus: e_1, poissons_ratio: nu_1 }, 4000.0);
        let half_space = HalfSpace::flat(Material { youngs_modulus: e_2, poissons_ratio: nu_2 }, None);
        let contact = Contact::try_new(sphere, half_space, &Plm::default()).unwrap();
        let [g_1, g_2] = [e_1 / (1.0 + nu_1), e_2 / (1.0 + nu_2)];
        let want =
            0.5 * (g_2 * (1.0 - 2.0 * nu_1) - g_1 * (1.0 - 2.0 * nu_2)) / (g_2 * (1.0 - nu_1) + g_1 * (1.0 - nu_2));
        assert_relative_eq!(contact.dundurs_beta(), want, max_relative = 1e-12);
        want
    };
    let [first, second] = materials;
    assert_relative_eq!(beta([first, second]), -beta([second, first]), max_relative = 1e-12);
}

/// A deep dent in a steel of 10 MPa: s_1/s_0 has a limit as the angle goes to 0, which another sum over springs puts at −0.5374 ± 0.001. Once it
/// ran away in dents of more than 1e6 yield indentations: 6.0 at 1e-7 degrees, and no answer below.
#[test]
fn hardly_slipping_friction_in_deep_dent_has_limit() {
    let coefficients = "law.plm.coefficients=tests/reference/coefficients-24.toml";
    let soft =
        ["sphere.yield_strength=10 MPa", "sphere.poissons_ratio=0", "half_space.yield_strength=1e14", coefficients];
    let contact = contact(STEEL, &soft);
    let ratio = |angle: f64, friction: f64| {
        let (impact, rebound) = impact(&contact, approach(3.0, angle, friction, 0.0), Some(3));
        assert!(impact.row.restitution < 0.05 && rebound.loss_fraction >= 0.0, "{angle} {friction}");
        assert!(rebound.impulse_ratio.abs() < friction);
        let of_table = contact.row(approach(3.0, angle, friction, 0.0), &Solver::AUTO).unwrap().rebound.unwrap();
        assert_abs_diff_eq!(of_table.contact_point_restitution, rebound.contact_point_restitution, epsilon = 1e-5);
        rebound.contact_point_restitution
    };
    let limit = ratio(1e-12, 2.0);
    assert_abs_diff_eq!(limit, 0.5374, epsilon = 1e-3);
    for angle in [1e-4, 1e-5, 1e-6, 1e-7, 3e-8, 1e-9, 1e-20] {
        // in proportion to psi_1 away from the limit: 0.46 per degree
        assert_abs_diff_eq!(ratio(angle, 2.0), limit, epsilon = 1e-6 + angle);
    }
    let limit = ratio(20.0, 1e9);
    for friction in [1e5, 1e6, 1e7, 1e12] {
        assert_abs_diff_eq!(ratio(20.0, friction), limit, epsilon = 1e-6 + 10.0 / friction);
    }
}

/// With gross sliding the impulses are in the ratio μ to the last bit: the difference of two large speeds once gave 0.3 % more.
#[test]
fn gross_sliding_impulse_ratio_is_friction_coefficient() {
    let contact = alumina_on_glass();
    for (angle, friction, spin) in
        [(89.999_999_999_9, 0.5, 0.0), (60.0, 1e-6, -3e4), (0.0, 1e-6, 3e4), (80.0, 0.1, 7.0)]
    {
        let (_, rebound) = impact(&contact, approach(3.9, angle, friction, spin), None);
        assert!(rebound.is_sliding);
        let slip = 3.9 * f64::sin(angle.to_radians()) - 2.5e-3 * spin;
        assert_eq!(rebound.impulse_ratio, friction * slip.signum(), "{angle}");
    }
}

/// Once I was made back from 1 + m R²/I: it lost digits, and was infinite from 1e16 m R² on.
#[test]
fn large_moment_of_inertia_keeps_energy() {
    let contact = alumina_on_glass();
    let of_radius = contact.mass() * 2.5e-3 * 2.5e-3;
    for share in [0.1, 0.4, 1e3, 1e12, 1e16, 1e20] {
        let contact = contact.clone().with_moment_of_inertia(share * of_radius);
        let (angle, spin) = (30.0_f64, 50.0);
        let oblique = impact(&contact, approach(3.9, angle, 0.1, spin), None).0.oblique.unwrap();
        let tangential = 3.9 * angle.to_radians().sin();
        let want = 0.5 * contact.mass() * tangential * tangential + 0.5 * share * of_radius * spin * spin;
        assert_relative_eq!(oblique.kinetic_in, want, max_relative = 1e-14);
        // friction absorbs the energy that the motion loses, within the digits of a fast spin
        let lost = oblique.kinetic_in - oblique.recovered;
        assert_abs_diff_eq!(lost, oblique.loss, epsilon = 1e-14 * want);
    }
}

#[test]
fn gross_sliding_has_closed_form_and_its_limit() {
    // elastic: psi_2 = psi_1 - 4 chi from psi_1 = 4 chi - 1 on
    let chi = 1.3;
    let run = |psi: f64| psi * elastic_ratio(psi, chi, OF_RUNS);
    for above in [1e-3, 0.1, 3.0] {
        let psi = 4.0 * chi - 1.0 + above;
        assert_abs_diff_eq!(run(psi), psi - 4.0 * chi, epsilon = 1e-7);
    }
    assert!(run(4.0 * chi - 1.2) - (-1.2) > 1e-3);
    // plastic: the run agrees with the formula where the contact says that it slides, and not 2 % below
    for exponent in [UnloadingExponent::Paper, UnloadingExponent::PressureShape, UnloadingExponent::Fixed(1.8)] {
        let contact = steel(&LawChoice::Plm(Plm { exponent, ..Plm::default() }));
        let (chi, speed) = (contact.chi(), 1.0);
        let (_, law, q) = contact.scaling(speed).unwrap();
        let motion = NormalMotion::new(law, q, &ScaledForces::NONE).unwrap();
        let e = contact.row(speed, &Solver::AUTO).unwrap().restitution;
        let formula = |psi: f64| psi - 2.0 * chi * (1.0 + e);
        let run = |psi: f64| psi * motion.ratio(psi * q, chi, OF_RUNS).unwrap();
        // straight down with a spin that gives this psi_1 at mu = 0.1
        let spin = |psi: f64| -psi * 0.1 * speed / (4.0 * contact.shear_ratio() * 5e-3);
        let slides = |psi: f64| {
            let approach = approach(speed, 0.0, 0.1, spin(psi));
            contact.row(approach, &Solver::AUTO).unwrap().rebound.unwrap().is_sliding
        };
        let n = contact.closed_form(speed).unwrap().unloading_exponent;
        let end = 2.0 * chi * (1.0 + e) - e * (2.0 * n - 2.0).min(1.0);
        // the stops of the PLM rise by at most 1.3, and the formula takes 2 to be sure
        let [begins, sure] = [1.3, 2.0].map(|rate| end.max(2.0 * chi + rate));
        assert!(slides(sure * 1.0001) && !slides(end * 0.99), "{exponent:?}");
        assert_abs_diff_eq!(run(begins * 1.001), formula(begins * 1.001), epsilon = 1e-5);
        assert!((run(end * 0.8) - formula(end * 0.8)).abs() > 1e-4, "{exponent:?}");
    }
}

/// The closed form of gross sliding is used only where a run gives the same: where no spring sticks before the peak or the separation.
#[test]
fn closed_form_of_sliding_is_that_of_a_run() {
    let hertz = LawChoice::from_name("hertz").unwrap();
    let of_exponent = |exponent| LawChoice::Plm(Plm { exponent: UnloadingExponent::Fixed(exponent), ..Plm::default() });
    for (law, speed) in [(hertz, 1.0), (LawChoice::default(), 1.0), (of_exponent(1.1), 0.05), (of_exponent(1.3), 3.0)] {
        let solid = 0.4 * steel(&law).mass() * 25e-6;
        for share in [0.05, 0.25, 1.0, 20.0] {
            let contact = steel(&law).with_moment_of_inertia(share * solid);
            let row = contact.row(speed, &Solver::AUTO).unwrap();
            let (chi, e, n) = (contact.chi(), row.restitution, contact.closed_form(speed).unwrap().unloading_exponent);
            let (_, scaled, q) = contact.scaling(speed).unwrap();
            let motion = NormalMotion::new(scaled, q, &ScaledForces::NONE).unwrap();
            let end = 2.0 * chi * (1.0 + e) - e * (2.0 * n - 2.0).min(1.0);
            let begins = end.max(2.0 * chi + 1.0);
            for psi in [0.7, 0.9, 0.98, 1.02, 1.1, 1.3].into_iter().flat_map(|part| [part * end, part * begins]) {
                // straight down with a spin that gives this psi_1 at mu = 0.1
                let spin = -psi * 0.1 * speed / (4.0 * contact.shear_ratio() * 5e-3);
                let rebound = contact.row(approach(speed, 0.0, 0.1, spin), &Solver::AUTO).unwrap().rebound.unwrap();
                let want = motion.ratio(psi * q, chi, OF_ROWS).unwrap();
                assert_abs_diff_eq!(-rebound.contact_point_restitution, want, epsilon = 2e-5);
                assert!(!(psi < end && rebound.is_sliding), "{share} {psi}");
            }
        }
    }
}

#[test]
fn limits_without_friction_without_slip_and_without_anything() {
    let contact = alumina_on_glass();
    // no friction: tangential speed and spin stay
    let (_, free) = impact(&contact, approach(3.9, 40.0, 0.0, 120.0), None);
    assert_eq!((free.tangential.speed, free.tangential.spin), (3.9 * 40_f64.to_radians().sin(), 120.0));
    assert!(free.is_sliding && free.impulse_ratio == 0.0 && free.loss_fraction == 0.0);
    // also where the contact is integrated
    for setting in ["damping.viscous=0.1", "damping.hunt_crossley=0.1", "law=walton_braun", "law=jackson_green"] {
        let (impact, free) = impact(&with_forces::under(&[setting]), approach(3.0, 20.0, 0.0, 120.0), Some(12));
        let before = approach(3.0, 20.0, 0.0, 120.0).tangential;
        assert_eq!(free.tangential, before, "{setting}");
        assert!(impact.trace.iter().all(|row| row.friction.unwrap().tangential == before), "{setting}");
    }
    // rolling: the contact point does not slip, and nothing happens
    let rolling = 3.9 * 20_f64.to_radians().sin() / 2.5e-3;
    let exact = Approach::at_angle(3.9, 0.0, 0.0, 0.3);
    let (straight, nothing) = impact(&contact, exact, Some(10));
    assert_eq!((nothing.tangential.speed, nothing.tangential.spin, nothing.angle), (0.0, 0.0, 0.0));
    assert!(nothing.tangential_restitution.is_nan() && nothing.contact_point_restitution.is_nan());
    assert!(straight.trace.iter().all(|row| row.friction.unwrap().friction_force == 0.0));
    let (_, rolled) = impact(&contact, approach(3.9, 20.0, 0.3, rolling), None);
    assert_abs_diff_eq!(rolled.tangential_restitution, 1.0, epsilon = 1e-12);
    // without an angle nothing is added
    let normal = contact.impact(3.9, &Solver::default(), Some(10)).unwrap();
    assert!(normal.row.rebound.is_none() && normal.oblique.is_none());
    assert!(normal.trace.iter().all(|row| row.friction.is_none()));
    // a body with the moment of inertia of a solid sphere is one
    let mass = contact.mass();
    let same = alumina_on_glass().with_moment_of_inertia(0.4 * mass * 2.5e-3 * 2.5e-3);
    let at = approach(3.9, 15.0, 0.092, 0.0);
    let (given, own) = (impact(&same, at, None).1, impact(&contact, at, None).1);
    // rounding changes the lengths of the steps
    assert_relative_eq!(given.tangential.spin, own.tangential.spin, max_relative = 1e-9);
    // mirrored: forward becomes backward
    let (back, forth) = (approach(3.9, 0.0, 0.1, -90.0), approach(3.9, 0.0, 0.1, 90.0));
    let [back, forth] = [back, forth].map(|approach| impact(&contact, approach, None).1);
    assert_eq!((back.tangential.speed, back.tangential.spin), (-forth.tangential.speed, -forth.tangential.spin));
}

/// A solid sphere has (2/5) m R². With less the contact point swings faster, in proportion to √(1 + m R²/I): the steps become
/// shorter, and beyond a hundred times as many there is no answer. Friction never makes energy.
#[test]
fn small_moment_of_inertia_is_limited_by_steps() {
    for law in [LawChoice::from_name("hertz").unwrap(), LawChoice::default()] {
        let contact = steel(&law);
        let solid = 0.4 * contact.mass() * 25e-6;
        let (mut computed, mut refused) = (0, None);
        for halves in 0..12 {
            let moment = solid * 10_f64.powf(-0.5 * f64::from(halves));
            let contact = contact.clone().with_moment_of_inertia(moment);
            for friction in [0.3, 1e6] {
                let approach = approach(1.0, 20.0, friction, 0.0);
                let row = contact.row(approach, &Solver::default());
                let impact = match contact.impact(approach, &Solver::default(), None) {
                    Ok(impact) => impact,
                    Err(ImpactError::SmallInertia { least, solid: told }) => {
                        let least = least.unwrap();
                        assert!(least > moment && relative_error(told, solid) < 1e-12 && row.is_err());
                        refused = refused.or(Some(least));
                        continue;
                    }
                    Err(error) => panic!("{error}"),
                };
                let (rebound, of_row) = (impact.row.rebound.unwrap(), row.unwrap().rebound.unwrap());
                let ratios = [of_row, rebound].map(|rebound| rebound.contact_point_restitution);
                assert_abs_diff_eq!(ratios[0], ratios[1], epsilon = 1e-5);
                assert!(rebound.contact_point_restitution.abs() <= 1.0 && rebound.loss_fraction >= 0.0, "{rebound:?}");
                assert!(rebound.error < 1e-4, "{moment:e}, {friction}: {rebound:?}");
                computed += 1;
            }
        }
        assert!(computed > 8, "{computed}");
        // from the least moment on, which the message names, there is an answer
        let least = refused.unwrap();
        let with = |moment| contact.clone().with_moment_of_inertia(moment);
        let approach = approach(1.0, 20.0, 1e6, 0.0);
        let of = |moment| with(moment).impact(approach, &Solver::default(), None);
        assert!(of(1.001 * least).is_ok() && of(0.999 * least).is_err());
    }
}
