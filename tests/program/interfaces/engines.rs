//! `plm-impact export --to drake|mujoco|chrono`: the equation of one contact of each code, integrated with the parameters of the lines, has
//! e and contact time of the law.

use std::f64::consts::PI;

use crate::common::STEEL;
use crate::common::prelude::*;

/// The number behind these words, the n-th number if there are more.
fn number_after(text: &str, words: &str, n: usize) -> f64 {
    let rest = text.split_once(words).unwrap_or_else(|| panic!("{words} in {text}")).1;
    let is_part = |c: char| c.is_ascii_digit() || "+-.e".contains(c);
    rest.split(|c| !is_part(c))
        .filter(|word| word.contains(|c: char| c.is_ascii_digit()))
        .nth(n)
        .unwrap()
        .parse()
        .unwrap()
}

/// e and duration of the force of one contact of this mass by semi-implicit Euler, as engines step, where the contact begins at this
/// fraction of a step. A force below zero is zero.
fn stepped(mass: f64, speed: f64, step: f64, phase: f64, force: impl Fn(f64, f64) -> f64) -> (f64, f64) {
    let (mut x, mut u, mut time) = (-phase * step * speed, speed, 0.0);
    loop {
        let push = if x > 0.0 { force(x, u).max(0.0) } else { 0.0 };
        u -= step * push / mass;
        x += step * u;
        time += if push > 0.0 { step } else { 0.0 };
        if u < 0.0 && (x <= 0.0 || force(x, u) <= 0.0) {
            return (-u / speed, time);
        }
    }
}

/// The law at these speeds: e from 0.8 to 0.4.
const SPEEDS: [&str; 3] = ["0.05 m/s", "0.5 m/s", "5 m/s"];

/// The lines of a code with the summary of the same impact, and its mass.
fn lines(code: &str, speed: &str) -> (String, f64, f64, f64, f64) {
    let scenario = STEEL.replace("3 m/s", speed);
    let desk = Sandbox::with(&scenario);
    let text = desk.run_expecting(&["export", "s.toml", "--to", code], 0).0;
    let contact = contact(&scenario, NO_OVERRIDES);
    let speed = speed.split(' ').next().unwrap().parse().unwrap();
    let row = contact.closed_form(speed).unwrap().row;
    (text, speed, row.restitution, row.contact_time, contact.mass())
}

/// e and contact time with fine steps, and e with the time step of the lines, wherever in a step the contact begins.
fn assert_rebound(text: &str, [speed, e, time, mass]: [f64; 4], step_words: &str, force: impl Fn(f64, f64) -> f64) {
    let (fine, lasted) = stepped(mass, speed, 1e-5 * time, 0.0, &force);
    assert!((fine / e - 1.0).abs() < 1e-3 && (lasted / time - 1.0).abs() < 2e-3, "{fine} {e} {lasted} {time}: {text}");
    let step = number_after(text, step_words, 0);
    for phase in [0.0, 0.3, 0.7] {
        let (coarse, _) = stepped(mass, speed, step, phase, &force);
        assert!((coarse / e - 1.0).abs() < 0.01, "{coarse} {e} at {speed} m/s: {text}");
    }
}

/// f = k x (1 + d x')+, with the k of two equal bodies in series.
#[test]
fn point_contact_of_drake_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, speed, e, time, mass) = lines("drake", speed);
        let (damping, stiffness) =
            (number_after(&text, "dissipation=", 0), number_after(&text, "point_stiffness=", 0) / 2.0);
        assert_rebound(&text, [speed, e, time, mass], "MultibodyPlant(time_step=", |x, u| {
            stiffness * x * (1.0 + damping * u)
        });
    }
}

/// Reference acceleration −(b v + k r) with b = damping/d, k = stiffness d/d² and the impedance d: the acceleration of a free body is d times
/// this one.
#[test]
fn solref_of_mujoco_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, speed, e, time, mass) = lines("mujoco", speed);
        let d = number_after(&text, "solimp=", 0);
        let [stiffness, damping] = [0, 1].map(|n| -number_after(&text, "solref=", n));
        assert!(stiffness > 0.0 && damping > 0.0 && number_after(&text, "solimp=", 1) == d);
        let (k, b) = (stiffness * d / (d * d), damping / d);
        assert_rebound(&text, [speed, e, time, mass], "timestep=", |x, u| mass * d * (k * x + b * u));
        let comments = text.lines().filter_map(|line| line.strip_prefix("<!--")?.strip_suffix("-->"));
        assert!(comments.into_iter().all(|comment| !comment.contains("--")), "{text}");
    }
}

/// Model Hertz of Chrono with material properties, for two equal materials and the effective radius of the lines.
#[test]
fn smooth_contact_of_chrono_has_restitution_of_law() {
    for speed in SPEEDS {
        let (text, speed, e, time, mass) = lines("chrono", speed);
        let young = number_after(&text, "SetYoungModulus(", 0);
        let ratio = number_after(&text, "SetPoissonRatio(", 0);
        let log = number_after(&text, "SetRestitution(", 0).ln();
        let radius = number_after(&text, "The effective radius is ", 0);
        let modulus = young / (2.0 * (1.0 - ratio * ratio));
        let beta = log / (log * log + PI * PI).sqrt();
        assert_rebound(&text, [speed, e, time, mass], "DoStepDynamics(", |x, u| {
            let sn = 2.0 * modulus * (radius * x).sqrt();
            2.0 / 3.0 * sn * x - 2.0 * (5.0_f64 / 6.0).sqrt() * beta * (sn * mass).sqrt() * u
        });
    }
}

/// An e that no contact of these codes has is refused.
#[test]
fn restitution_without_parameters_is_refused() {
    for (code, damping, words) in [
        ("mujoco", "1", "has e above exp(-2)"),
        ("drake", "3", "needs e of 0.02 or more"),
        ("chrono", "3", "of 0.02 or more"),
    ] {
        let desk = Sandbox::with(format!("{STEEL}[damping]\nviscous = {damping}\n"));
        let (_, message) = desk.run_expecting(&["export", "s.toml", "--to", code], 2);
        assert!(message.contains(words), "{code}: {message}");
    }
}
