//! The short table a person reads on the terminal.

use crate::impact::{Contact, Impact, UnderForces};
use crate::math::power::max_or_nan;
use crate::units::aligned::aligned;
use crate::units::rounded::{number, percent, quantity};

/// A few aligned lines: what came of the impact and how exact it is.
pub fn table(contact: &Contact, impact: &Impact) -> String {
    let mut rows: Vec<[String; 3]> = Vec::new();
    let mut row = |name: &str, value: String, remark: String| rows.push([name.to_owned(), value, remark]);
    let is_elastic = contact.pair().yield_point.is_none();
    let captured = impact.captured();
    let end = captured.map_or_else(String::new, |under| {
        let depth = under.static_indentation.map_or_else(String::new, |depth| quantity(depth, "m"));
        format!("captured: the sphere comes to rest at an indentation of {depth}")
    });
    let e = if impact.speed > 0.0 { number(impact.restitution) } else { "none".to_owned() };
    row("restitution", e, end);
    if let (Some(loss), Some(restitution)) = (impact.wave_loss_fraction, impact.restitution_with_waves()) {
        row("with waves", number(restitution), format!("{} of the energy radiated", percent(loss)));
    }
    row("rebound speed", quantity(impact.rebound_speed, "m/s"), format!("impact at {}", quantity(impact.speed, "m/s")));
    row(
        "contact time",
        captured.map_or_else(|| quantity(impact.contact_time, "s"), |_| "without end".to_owned()),
        match captured {
            None => format!("compression {}", quantity(impact.loading_time, "s")),
            Some(under) => format!(
                "compression {}, followed until {}",
                quantity(impact.loading_time, "s"),
                quantity(under.end_time, "s")
            ),
        },
    );
    if let Some(seen) = &impact.in_fixed_steps {
        row(
            "in whole steps",
            seen.separation_time.map_or_else(|| "without end".to_owned(), |time| quantity(time, "s")),
            format!(
                "compression {}, step {}; energy drift at the end {:.1e}",
                quantity(seen.compression_time, "s"),
                quantity(seen.step, "s"),
                seen.drift_at_end
            ),
        );
    }
    row(
        "peak force",
        quantity(impact.peak_force, "N"),
        format!("mean pressure {}", quantity(impact.peak_mean_pressure, "Pa")),
    );
    row(
        "peak indentation",
        quantity(impact.peak_indentation, "m"),
        format!(
            "sphere {}, half-space {}",
            quantity(impact.peak_sphere_indentation, "m"),
            quantity(impact.peak_indentation - impact.peak_sphere_indentation, "m")
        ),
    );
    if contact.pair().yield_point.is_some() {
        if let Some(radius) = impact.dent_radius {
            let curvature = impact
                .residual_radius
                .map_or_else(String::new, |r| format!("radius of curvature {}", quantity(r, "m")));
            row("dent depth", quantity(impact.residual_indentation, "m"), curvature);
            row("dent radius", quantity(radius, "m"), String::new());
        } else {
            row("dent", "none".into(), String::new());
        }
        if let (Some(speed), Some((_, force))) = (contact.yield_speed(), contact.yields_at()) {
            row("yield speed", quantity(speed, "m/s"), format!("first yield at {}", quantity(force, "N")));
        }
    }
    let energy = &impact.energy;
    let mut split = match energy.plastic {
        Some(plastic) if !is_elastic => format!(
            "{} recovered, {} into the dent",
            percent(energy.recovered / energy.kinetic_in),
            percent(plastic / energy.kinetic_in)
        ),
        _ => format!("{} recovered", percent(energy.recovered / energy.kinetic_in)),
    };
    if let Some(under) = &impact.under_forces {
        split = of_forces(impact, under);
    }
    row("energy", quantity(energy.kinetic_in, "J"), split);
    let accuracy = &impact.accuracy;
    if accuracy.restitution_error.is_nan() {
        row("accuracy", format!("{:.1e}", energy.drift), "energy drift; this scene has no closed form".to_owned());
    } else {
        row(
            "accuracy",
            format!("{:.1e}", max_or_nan(accuracy.restitution_error, accuracy.contact_time_error)),
            format!(
                "relative, against the closed form (restitution {:.1e}, contact time {:.1e}); energy drift {:.1e}",
                accuracy.restitution_error, accuracy.contact_time_error, energy.drift
            ),
        );
    }
    let work = &impact.work;
    row(
        "work",
        format!("{} steps", work.steps),
        format!("{} rejected, {} force evaluations", work.rejected, work.force_evaluations),
    );
    aligned(&rows, |_| true)
}

/// Where the energy went under gravity and damping, in joules: shares of a kinetic energy that may be zero say nothing.
fn of_forces(impact: &Impact, under: &UnderForces) -> String {
    let mut parts = Vec::new();
    let mut part = |value: f64, what: &str| parts.push(format!("{} {what}", quantity(value, "J")));
    if let Some(work) = under.gravity_work {
        part(work, "from gravity");
    }
    part(impact.energy.recovered, "recovered");
    if let Some(plastic) = impact.energy.plastic {
        part(plastic, "into the dent");
    }
    if let Some(loss) = under.damping_loss {
        part(loss, "into damping");
    }
    if let Some(stored) = under.stored_at_separation {
        part(stored, "left in the contact");
    }
    parts.join(", ")
}
